/// @file
/// The least contact law that makes a rock; docs/concepts/contact_law.md explains it.
#pragma once

#include <cmath>
#include <tuple>

#include <hfdem/state/concepts.hpp>

namespace models {

using namespace hfdem;

/// A normal and a shear spring, equally stiff, glued until they are pulled apart.
struct GluedSprings : WithoutMemory {
  struct Params {
    double E = 34e9, tensile_strength = 8e6;
    static constexpr auto fields() {
      using P = Params;
      return std::tuple{
          Field{"E", &P::E, "Pa", positive, "Young's modulus of the contact"},
          Field{"tensile_strength", &P::tensile_strength, "Pa", positive, "strength of the glue"}};
    }
  };
  template <class T>
  struct Stiffness {
    T pressed, glued, area;  // N/m2 while pressed; N/m2 while glued, then 0; m
  };

  explicit GluedSprings(const Params& params) : p(params) {}

  Stiffness<double> stiffness(Disc a, Disc b) const noexcept {
    const double area = 2 * std::fmin(a.radius, b.radius), k = p.E * area / (a.radius + b.radius);
    return {k, k, area};
  }
  Stiffness<double> broken(const Stiffness<double>& k) const noexcept {
    return {k.pressed, 0, k.area};
  }
  Springs springs(const Stiffness<double>& k) const noexcept { return {k.pressed, k.glued, 0}; }

  template <class T>
  Response<T> respond(const Stiffness<T>& k, const Memory<T>&, const Motion<T>& m) const noexcept {
    const T normal = max(-(k.pressed * m.opening), -(k.glued * m.opening));
    return {{.normal = normal, .shear = -(k.glued * m.shear), .moment = T{}}};
  }
  template <class T>
  Failure<T> failure(const Stiffness<T>& k, const Response<T>& r) const noexcept {
    return {-r.force.normal > p.tensile_strength * k.area, MaskOf<T>{}};
  }

  Params p;
};

}  // namespace models
