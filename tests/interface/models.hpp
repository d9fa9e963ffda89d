/// @file
/// For each concept the least that it accepts, and for every atom a model that lacks only that one.
#pragma once

#include <tuple>

#include <hfdem/state/concepts.hpp>

namespace models {

using namespace hfdem;

struct NoParams {
  static constexpr auto fields() { return std::tuple{}; }
};
struct ParamsWithoutFields {};
struct ParamsWithConstructor : NoParams {
  ParamsWithConstructor() {}
};
struct ParamsWithoutDefaults : NoParams {
  double& host;
};

/// Gives a policy other parameters, from which it can still be made.
template <class Policy, class P>
struct WithParams : Policy {
  using Params = P;
  explicit WithParams(const Params&) : Policy({}) {}
};
template <class Policy>
using WithoutFields = WithParams<Policy, ParamsWithoutFields>;

/// Takes away the construction from parameters.
template <class Policy>
struct MadeFromNothing : Policy {
  MadeFromNothing() : Policy({}) {}
};

// ---- contact law ------------------------------------------------------------------------------

/// A spring that never breaks.
struct Law {
  using Params = NoParams;
  template <class T>
  struct Stiffness {
    T normal;
  };
  template <class T>
  struct Memory {};
  template <class T>
  struct Response {
    T normal;
    Memory<T> memory;
    Reaction<T> reaction() const { return {normal, T{}, T{}}; }
  };

  explicit Law(const Params&) {}

  Stiffness<double> stiffness(Disc, Disc) const noexcept { return {1}; }
  Stiffness<double> broken(const Stiffness<double>& k) const noexcept { return k; }
  Springs springs(const Stiffness<double>& k) const noexcept { return {.normal = k.normal}; }

  template <class T>
  Response<T> respond(const Stiffness<T>& k, const Memory<T>& memory,
                      const Motion<T>& motion) const noexcept {
    return {-(k.normal * motion.opening), memory};
  }
  template <class T>
  Failure<T> failure(const Stiffness<T>&, const Response<T>&) const noexcept {
    return {MaskOf<T>{}, MaskOf<T>{}};
  }
};

struct LawWithClosedStiffness : Law {
  using Law::Law;
  template <class T>
  struct Stiffness : Law::Stiffness<T> {
    explicit Stiffness(const Law::Stiffness<T>& k) : Law::Stiffness<T>(k) {}
  };
  Stiffness<double> stiffness(Disc a, Disc b) const noexcept {
    return Stiffness<double>(Law::stiffness(a, b));
  }
  Stiffness<double> broken(const Stiffness<double>& k) const noexcept { return k; }
};

struct LawWithClosedMemory : Law {
  using Law::Law;
  template <class T>
  struct Memory : Law::Memory<T> {
    Memory(const Law::Memory<T>&) {}
  };
};

struct LawWithoutStiffness : Law {
  using Law::Law;
  void stiffness() = delete;
};

struct LawWithoutSprings : Law {
  using Law::Law;
  void springs() = delete;
};

/// All laws are called in loops that cannot catch anything.
struct LawWithThrowingSprings : Law {
  using Law::Law;
  Springs springs(const Stiffness<double>& k) const { return Law::springs(k); }
};

struct LawWithoutReaction : Law {
  using Law::Law;
  template <class T>
  struct Response : Law::Response<T> {
    void reaction() = delete;
  };
  template <class T>
  Response<T> respond(const Stiffness<T>& k, const Memory<T>& memory,
                      const Motion<T>& motion) const noexcept {
    return {Law::respond(k, memory, motion)};
  }
};

/// Answers one contact at a time only.
struct ScalarLaw : Law {
  using Law::Law;
  Response<double> respond(const Stiffness<double>& k, const Memory<double>& memory,
                           const Motion<double>& motion) const noexcept {
    return Law::respond(k, memory, motion);
  }
};

struct LawWithoutFailure : Law {
  using Law::Law;
  void failure() = delete;
};

struct LawWithoutBroken : Law {
  using Law::Law;
  void broken() = delete;
};

// ---- aperture law -----------------------------------------------------------------------------

struct Aperture {
  using Params = NoParams;
  explicit Aperture(const Params&) {}
  double rest_width() const noexcept { return 1; }
  double width(double w0, double, double gap) const noexcept { return w0 + gap; }
};

struct ApertureWithoutRestWidth : Aperture {
  using Aperture::Aperture;
  void rest_width() = delete;
};

struct ApertureWithoutWidth : Aperture {
  using Aperture::Aperture;
  void width() = delete;
};

// ---- pressure scheme --------------------------------------------------------------------------

struct Scheme {
  using Params = NoParams;
  static constexpr bool holds_fluid = false;
  explicit Scheme(const Params&) {}
  double fluid_dt(double mechanical_dt) const { return mechanical_dt; }
  template <class Relax>
  FluidStep advance(Network&, const Injected&, Relax&& relax) {
    return {.unbalanced_ratio = relax().unbalanced_ratio};
  }
};

/// It does not say whether it holds fluid.
struct SchemeWithoutWord : Scheme {
  using Scheme::Scheme;
  void holds_fluid() = delete;
};

struct SchemeWithoutFluidDt : Scheme {
  using Scheme::Scheme;
  void fluid_dt() = delete;
};

struct SchemeWithoutAdvance : Scheme {
  using Scheme::Scheme;
  void advance() = delete;
};

// ---- neighbour search -------------------------------------------------------------------------

struct Search {
  Search(const Specimen&, double) {}
  template <class F>
  void for_each_pair(F&& f) const {
    f(Pair{0, 1});
  }
};

struct SearchWithoutReach : Search {
  explicit SearchWithoutReach(const Specimen& specimen) : Search(specimen, 0) {}
};

struct SearchWithoutPairs : Search {
  using Search::Search;
  void for_each_pair() = delete;
};

}  // namespace models
