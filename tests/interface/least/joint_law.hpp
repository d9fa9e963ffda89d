/// @file
/// The least law of joints that makes a jointed rock with any contact law.
#pragma once

#include <tuple>

#include <hfdem/contact/smooth_joint.hpp>
#include <hfdem/state/concepts.hpp>

namespace models {

using namespace hfdem;

/// A normal and a shear spring per metre of fracture, equally stiff, glued until they are pulled
/// apart; then the walls are so smooth that nothing is left of the shear.
struct GluedWalls : WithoutMemory {
  struct Params {
    double stiffness = 100e9, tensile_strength = 0.1e6, w0 = 1e-4;
    static constexpr auto fields() {
      using P = Params;
      return std::tuple{
          Field{"stiffness", &P::stiffness, "Pa/m", positive, "stiffness of the walls"},
          Field{"tensile_strength", &P::tensile_strength, "Pa", positive, "strength of the glue"},
          Field{"w0", &P::w0, "m", positive, "aperture of a joint without force"}};
    }
  };
  template <class T>
  struct Stiffness {
    T length, glue;  // m of fracture; 1 while glued, then 0
  };
  template <class T>
  struct Response {
    T normal_stress, shear_stress, length;
    Memory<T> memory{};
    Reaction<T> reaction() const { return {normal_stress * length, shear_stress * length, T{}}; }
  };

  explicit GluedWalls(const Params& params) : p(params) {}

  Stiffness<double> stiffness(double length) const noexcept { return {length, 1}; }
  Stiffness<double> with_length(const Stiffness<double>& k, double length) const noexcept {
    return {length, k.glue};
  }
  Stiffness<double> broken(const Stiffness<double>& k) const noexcept { return {k.length, 0}; }
  Springs springs(const Stiffness<double>& k) const noexcept {
    return {p.stiffness * k.length, p.stiffness * k.length, 0};
  }

  template <class T>
  Response<T> respond(const Stiffness<T>& k, const Memory<T>&, const Motion<T>& m) const noexcept {
    const T normal = -(p.stiffness * m.opening);
    return {.normal_stress = max(normal, k.glue * normal),
            .shear_stress = -(p.stiffness * m.shear) * k.glue,
            .length = k.length};
  }
  template <class T>
  Failure<T> failure(const Stiffness<T>&, const Response<T>& r) const noexcept {
    return {-r.normal_stress > p.tensile_strength + T{}, MaskOf<T>{}};
  }

  double slip(const Memory<double>&) const noexcept { return 0; }
  double dilation(const Memory<double>&) const noexcept { return 0; }
  double rest_width() const noexcept { return p.w0; }
  JointContent initially() const noexcept { return JointContent::dry; }

  Params p;
};

}  // namespace models
