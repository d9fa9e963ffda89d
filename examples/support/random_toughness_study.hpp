/// @file
/// The tests of random rock: of each seed its elastic moduli, slits held open, and a crack that
/// runs.
#pragma once

#include <string>
#include <vector>

#include <hfdem/measure/elastic_moduli.hpp>
#include <hfdem/measure/sample_mean.hpp>
#include <hfdem/neighbours/kd_tree.hpp>
#include <hfdem/pressure/uniform.hpp>

#include "support/progress.hpp"
#include "support/random_toughness_model.hpp"

namespace hfdem::support {

/// What was read from one rock.
struct SeedReadings {
  int seed = 0;
  std::size_t discs = 0;
  measure::ElasticModuli moduli{};
  std::vector<measure::SlitTest> tests{};      ///< of its slits
  std::vector<measure::CrackInstant> crack{};  ///< after every fluid step
  std::string ended{};                         ///< why the crack's run ended
  long unconverged = 0, mechanical_steps = 0;  ///< of the crack's run

  void exchange(auto& archive) {
    archive(seed, discs, moduli.young, moduli.poisson, tests, crack, ended, unconverged,
            mechanical_steps);
  }
};

/// What they say.
struct SeedResult : SeedReadings {
  analytic::CrackedPlate plate;  ///< that the rock is, with its moduli
  measure::SlitModulus slits{};
  measure::RunningToughness above_in_situ{}, above_closing{};
};

/// Tests one seed after the other.
class RandomToughnessStudy {
 public:
  RandomToughnessStudy(const RandomToughnessConfig& config, int threads)
      : config_(config), threads_(threads) {}

  /// Whether all seeds are tested.
  bool complete() const { return static_cast<int>(readings_.size()) == config_.study.seeds; }

  /// @throws InvalidParameter, also if the specimen is no plate that the solution knows
  /// @throws RunStopped if the rock finds no equilibrium, or no crack runs through it
  void test_next(ProgressLine& progress) {
    const auto before = static_cast<int>(readings_.size());
    readings_.push_back(test(config_.rock.specimen.seed + before, progress, before));
    evaluate();
  }

  /// What the seeds have come to so far.
  template <class Archive>
  void exchange(Archive& archive) {
    archive(readings_);
    if constexpr (Archive::loads) evaluate();
  }

  const std::vector<SeedResult>& seeds() const { return seeds_; }

  /// A number of every seed.
  template <class F>
  measure::SampleMean mean(F&& number) const {
    std::vector<double> values;
    for (const SeedResult& s : seeds_) values.push_back(number(s));
    return measure::SampleMean::of(values);
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

  SeedReadings test(int seed, ProgressLine& progress, int before) const {
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
        specimen, rock.contact, rock.in_situ, config_.mechanics, threads_);
    SeedReadings readings{.seed = seed, .discs = specimen.size(), .moduli = moduli};
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
      readings.tests.push_back(slit.held_at(pressures));
    }
    run_crack(specimen, readings, [&](double part) { show(0.3 + 0.7 * part, "running crack"); });
    return readings;
  }

  template <class Show>
  void run_crack(const Specimen& specimen, SeedReadings& readings, Show&& show) const {
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
      readings.ended = "at its end time";
    } catch (const RunStopped& reason) {
      readings.ended = reason.what();  // as is to be expected: the crack reaches the rim
    }
    readings.crack = crack.instants();
    readings.unconverged = crack.unconverged();
    readings.mechanical_steps = sim.mechanical_steps();
  }

  void evaluate() {
    seeds_.clear();
    for (const SeedReadings& r : readings_) {
      const auto plate = plate_of(config_.plate_injection(), r.moduli.young, r.moduli.poisson);
      seeds_.push_back({r,
                        plate,
                        measure::slit_modulus(r.tests, plate, config_.study.opening_reach),
                        running_toughness(r.crack, plate, config_.running),
                        {}});
      if (seeds_.back().above_in_situ.steps == 0)
        throw RunStopped("no crack of " + in_words(config_.running.from * plate.width()) + " to " +
                         in_words(config_.running.to * plate.width()) +
                         " m ran through the rock of seed " + std::to_string(r.seed) +
                         "; its run ended: " + r.ended);
    }
    find_closing_toughness();
  }

  /// The closing pressure is a mean over all seeds, as that of one path says little of another.
  void find_closing_toughness() {
    const double excess = mean([](const auto& s) { return s.slits.closing_excess; }).mean;
    for (SeedResult& s : seeds_)
      s.above_closing = running_toughness(s.crack, s.plate, config_.running, excess);
  }

  const RandomToughnessConfig& config_;
  int threads_;
  std::vector<SeedReadings> readings_{};
  std::vector<SeedResult> seeds_{};
};

}  // namespace hfdem::support
