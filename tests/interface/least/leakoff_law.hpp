/// @file
/// The least leak-off law; docs/concepts/leakoff_law.md explains it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

#include <hfdem/state/concepts.hpp>

namespace models {

using namespace hfdem;

/// A filter cake: each domain loses at a rate that is proportional to its pressure.
struct FilterCake {
  struct Params {
    double rate = 1e-14;
    static constexpr auto fields() {
      return std::tuple{Field{"rate", &Params::rate, "m2/(s Pa)", non_negative,
                              "what each domain loses per second and pressure"}};
    }
  };
  static constexpr bool leaks = true;

  explicit FilterCake(const Params& params) : p(params) {}

  void join(Network& network) { lost_.resize(network.wet_domains().size(), 0); }
  template <class Fluid>
  void find_loss(const Network&, const Fluid&, double dt, const CrackFluid&, Euler) {
    slope_ = p.rate * dt;
  }
  std::size_t size() const { return lost_.size(); }
  double loss(std::size_t, double pressure) const { return slope_ * std::max(0.0, pressure); }
  double slope(std::size_t) const { return slope_; }
  template <class Fluid>
  void commit(Network&, const Fluid&, const CrackFluid& crack) {
    for (std::size_t d = 0; d < size(); ++d) lost_[d] += loss(d, crack.pressure[d]);
  }
  double leaked() const {
    double sum = 0;
    for (const double lost : lost_) sum += lost;
    return sum;
  }
  void exchange(auto& archive) { archive(lost_, slope_); }

  Params p;
  std::vector<double> lost_;
  double slope_ = 0;
};

}  // namespace models
