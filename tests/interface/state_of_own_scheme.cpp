/// @file
/// The state of a simulator with a scheme of one's own: with what evolves in it, or not at all.
#include <hfdem/base/archive.hpp>
#include <hfdem/neighbours/fixed_pairs.hpp>
#include <hfdem/simulator.hpp>

#include "least/aperture_law.hpp"
#include "least/contact_law.hpp"
#include "least/pressure_scheme.hpp"

using namespace models;

#if defined(WITHOUT_EXCHANGE)
struct OwnScheme : PressureSteps {
  using PressureSteps::PressureSteps;
  void exchange() = delete;
};
#elif defined(INHERITED_EXCHANGE)
struct OwnScheme : PressureSteps {
  using PressureSteps::PressureSteps;
  double more = 0;
};
#else
using OwnScheme = PressureSteps;
#endif

using Sim = Simulator<GluedSprings, RoughWalls, OwnScheme, FixedPairs>;

std::string save(const Sim& sim) {
  Saver saver;
  saver(sim);
  return saver.sealed();
}

Sim resume(const Specimen& specimen, Loader& saved) { return {specimen, {}, saved}; }
