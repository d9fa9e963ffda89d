/// @file
/// The tests of random rock: of each seed its elastic moduli, slits held open, and a crack that
/// runs.
#pragma once

#include <string>
#include <vector>

#include <hfdem/measure/elastic_moduli.hpp>
#include <hfdem/neighbours/kd_tree.hpp>
#include <hfdem/pressure/uniform.hpp>

#include "support/progress.hpp"
#include "support/random_toughness_model.hpp"
#include "support/seed_mean.hpp"

namespace hfdem::support {

/// What one rock said.
struct SeedResult {
  int seed = 0;
  std::size_t discs = 0;
  measure::ElasticModuli moduli{};
  analytic::CrackedPlate plate;  ///< that the rock is, with these moduli
  measure::SlitModulus slits{};
  std::vector<measure::CrackInstant> crack{};  ///< after every fluid step
  std::string ended{};                         ///< why the crack's run ended
  long unconverged = 0, mechanical_steps = 0;  ///< of the crack's run
  measure::RunningToughness above_in_situ{}, above_closing{};
};

/// Tests one seed after the other.
class RandomToughnessStudy {
 public:
  /// @throws InvalidParameter, also if the specimen is no plate that the solution knows
  /// @throws RunStopped if a rock finds no equilibrium, or no crack runs through it
  RandomToughnessStudy(const RandomToughnessConfig& config, int threads, bool quiet)
      : config_(config), threads_(threads) {
    ProgressLine progress(quiet);
    for (int k = 0; k < config.study.seeds; ++k) test(config.rock.specimen.seed + k, progress, k);
    find_closing_toughness();
  }

  const std::vector<SeedResult>& seeds() const { return seeds_; }

  /// A number of every seed.
  template <class F>
  SeedMean mean(F&& number) const {
    std::vector<double> values;
    for (const SeedResult& s : seeds_) values.push_back(number(s));
    return SeedMean::of(values);
  }

  /// Means over the seeds.
  analytic::RockFracture rock() const {
    return {.E_prime = mean([](const auto& s) { return s.slits.E_prime; }).mean,
            .poisson_ratio = mean([](const auto& s) { return s.moduli.poisson; }).mean,
            .K_IC = mean([](const auto& s) { return s.above_closing.K; }).mean,
            .closing_excess = mean([](const auto& s) { return s.slits.closing_excess; }).mean,
            .K_IC_above_in_situ = mean([](const auto& s) { return s.above_in_situ.K; }).mean};
  }

 private:
  using Crack = Simulator<LinearParallelBond, HyperbolicAperture, UniformPressure, KdTree>;
  using Slit = measure::Slit<LinearParallelBond, HyperbolicAperture, KdTree>;

  void test(int seed, ProgressLine& progress, int before) {
    const auto show = [&](double done, const char* what) {
      progress.show((before + done) / config_.study.seeds,
                    "seed " + std::to_string(seed) + ", " + what);
    };
    const RandomRock& rock = config_.rock;
    RandomPacking packing = rock.specimen;
    packing.seed = seed;
    const Specimen specimen = random_packing(packing, threads_);
    show(0.05, "moduli");
    const auto moduli = measure::elastic_moduli<LinearParallelBond, KdTree>(
        specimen, rock.contact, rock.in_situ, config_.mechanics);
    SeedResult result{.seed = seed,
                      .discs = specimen.size(),
                      .moduli = moduli,
                      .plate = plate_of(config_.plate_injection(), moduli.young, moduli.poisson)};
    std::vector<measure::SlitTest> slits;
    const std::vector<double> pressures = config_.slits.net_pressures();
    for (const double length : config_.slits.lengths()) {
      show(0.1, "slits");
      Slit slit(specimen,
                {.contact = rock.contact,
                 .aperture = rock.aperture,
                 .boundary = rock.boundary,
                 .in_situ = rock.in_situ,
                 .mechanics = config_.mechanics,
                 .scheme = config_.held},
                {.length = length}, config_.study.opening_reach);
      slit.use_threads(threads_);
      slits.push_back(slit.held_at(pressures));
    }
    result.slits = measure::slit_modulus(slits, result.plate, config_.study.opening_reach);
    run_crack(specimen, result, [&](double part) { show(0.3 + 0.7 * part, "running crack"); });
    seeds_.push_back(std::move(result));
  }

  template <class Show>
  void run_crack(const Specimen& specimen, SeedResult& result, Show&& show) const {
    const RandomRock& rock = config_.rock;
    Crack sim(specimen, {.contact = rock.contact,
                         .aperture = rock.aperture,
                         .boundary = rock.boundary,
                         .in_situ = rock.in_situ,
                         .crack = config_.crack,
                         .injection = config_.injection,
                         .mechanics = config_.mechanics,
                         .scheme = config_.scheme});
    sim.use_threads(threads_);
    measure::RunningCrack crack(std::fmin(rock.in_situ.xx, rock.in_situ.yy));
    const double end = config_.study.end_time;
    try {
      sim.run_until(end, crack, [&](const auto& s) { show(s.time() / end); });
      result.ended = "at its end time";
    } catch (const RunStopped& reason) {
      result.ended = reason.what();  // as is to be expected: the crack reaches the rim
    }
    result.crack = crack.instants();
    result.unconverged = crack.unconverged();
    result.mechanical_steps = sim.mechanical_steps();
    result.above_in_situ = running_toughness(result.crack, result.plate, config_.running);
    if (result.above_in_situ.steps == 0)
      throw RunStopped("no crack of " + in_words(config_.running.from * result.plate.width()) +
                       " to " + in_words(config_.running.to * result.plate.width()) +
                       " m ran through the rock of seed " + std::to_string(result.seed) +
                       "; its run ended: " + result.ended);
  }

  /// The closing pressure is a mean over all seeds, as that of one path says little of another.
  void find_closing_toughness() {
    const double excess = mean([](const auto& s) { return s.slits.closing_excess; }).mean;
    for (SeedResult& s : seeds_)
      s.above_closing = running_toughness(s.crack, s.plate, config_.running, excess);
  }

  const RandomToughnessConfig& config_;
  int threads_;
  std::vector<SeedResult> seeds_{};
};

}  // namespace hfdem::support
