/// @file
/// A rock that moves freely under the paper's stress, without fluid: what the benchmarks of the
/// mechanical step time.
#pragma once

#include <hfdem/assembly.hpp>
#include <hfdem/neighbours/cell_grid.hpp>
#include <hfdem/setup/bonding.hpp>

/// Bonded discs under 10 and 12 MPa, just after they have come under it.
template <class Law>
class FreeRock {
 public:
  explicit FreeRock(const hfdem::Specimen& specimen)
      : body_(specimen, hfdem::bonded_contacts<hfdem::CellGrid>(specimen), Law({}), {}, 0.7, 0.97) {
    body_.set_stress({10e6, 12e6});
  }
  void steps(int count, int threads) {
    for (int n = 0; n < count; ++n) {
      body_.begin_step(threads, [](hfdem::Index, hfdem::Mode) {});
      body_.move(false, threads);
    }
  }
  const hfdem::Assembly<Law>& body() const { return body_; }
  std::size_t discs() const { return body_.discs().size(); }
  std::size_t contacts() const { return body_.contacts().size(); }

  /// Bytes that one step has to read or to write, each counted once for either.
  double traffic() const {
    using namespace hfdem;
    constexpr double contact = sizeof(Pair) + sizeof(Frame<double>) +
                               sizeof(typename Law::template Stiffness<double>) +
                               sizeof(typename Law::template Memory<double>) + sizeof(Pack);
    // Which six rows act on it, and their signs; load; time step over mass and inertia;
    // displacement and velocity, which change.
    constexpr double disc = 6 * sizeof(Index) + 1 + sizeof(Vec2) + 2 * sizeof(double) +
                            2 * (sizeof(Pack) + sizeof(Pack));
    return static_cast<double>(contacts()) * contact + static_cast<double>(discs()) * disc;
  }

 private:
  hfdem::Assembly<Law> body_;
};
