/// @file
/// A ledger of energy for a law that says what it stores. It compiles as it stands; for a law that
/// does not say so it must not.
#include <hfdem/measure/energy_ledger.hpp>
#include <hfdem/simulator.hpp>

#include "models.hpp"

#ifndef LAW
#define LAW LawWithEnergy
#endif

using namespace models;
using Sim = hfdem::Simulator<LAW, Aperture, Scheme, Search>;

void keep_books(Sim& sim) {
  hfdem::measure::EnergyLedger<LAW> ledger;
  sim.run_until(1, ledger);
}
