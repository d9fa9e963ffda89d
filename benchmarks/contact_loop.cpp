/// @file
/// What the policies, templates and packed columns cost: the library's contact loop beside a twin
/// written by hand for this one law. One thread, fixed displacements, the square array.
///
///   contact_loop [discs per side = 100] [pairs of batches = 400]
///
/// You should see a ratio library / by hand below 1.15; both must give the same bits.
#include <algorithm>
#include <bit>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

#include <hfdem/aperture/hyperbolic.hpp>
#include <hfdem/base/units.hpp>
#include <hfdem/contact/linear_parallel_bond.hpp>
#include <hfdem/neighbours/fixed_pairs.hpp>
#include <hfdem/pressure/dry.hpp>
#include <hfdem/setup/square_array.hpp>
#include <hfdem/simulator.hpp>

#include "by_hand.hpp"
#include "side_by_side.hpp"

namespace {

using namespace hfdem;
using namespace hfdem::literals;
using Law = LinearParallelBond;
using Specimens = Simulator<Law, HyperbolicAperture, Dry, FixedPairs>;

enum class Shake { every_disc_its_own_way, all_discs_turn_alike };

/// The settled specimen with its discs moved and turned at random, or all turned by one angle,
/// which loads the contacts in shear alone.
std::vector<Pack> shaken(const Specimens& settled, Shake shake, double distance) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> of(-distance, distance);
  const double radius = settled.discs().radius.front();
  std::vector<Pack> displacement = settled.discs().displacement;
  for (Pack& row : displacement) {
    const bool alike = shake == Shake::all_discs_turn_alike;
    const double x = alike ? 0 : of(random), y = alike ? 0 : of(random);
    const double turn = (alike ? distance : of(random)) / radius;
    row += Pack{x, y, turn, turn};
  }
  return displacement;
}

bool same_bits(const Pack& a, const Pack& b) {
  return !any(std::bit_cast<PackMask>(a) ^ std::bit_cast<PackMask>(b));
}

/// Whether both loops agree on force rows, shear offsets and notes of failure, in small steps from
/// where nothing happens to where contacts slip and bonds fail, in tension and in shear.
bool agree(const Specimens& specimen) {
  ContactRange<Law> library = specimen.contacts();
  ContactsByHand by_hand(library, specimen.params().contact);
  std::vector<Pack> rows(library.padded_size()), rows_by_hand(library.padded_size());
  for (const Shake shake : {Shake::every_disc_its_own_way, Shake::all_discs_turn_alike}) {
    for (double distance = 2_um; distance < 40_um; distance *= 1.005) {
      const std::vector<Pack> displacement = shaken(specimen, shake, distance);
      library.evaluate(displacement, rows, 1);
      by_hand.evaluate(displacement.data(), rows_by_hand.data());
      if (!std::equal(rows.begin(), rows.end(), rows_by_hand.begin(), same_bits)) return false;
      for (std::size_t c = 0; c < library.size(); ++c)
        if (library.memory(c).shear_offset != by_hand.offset[c / pack_width][c % pack_width])
          return false;
      std::vector<char> failed(by_hand.failed.size(), 0);
      ContactRange<Law>(library).break_bonds(displacement, rows, [&](Index contact, Mode) {
        failed[contact / (pack_width * ContactsByHand::blocks_per_note)] = 1;
      });
      if (failed != by_hand.failed) return false;
    }
  }
  return true;
}

}  // namespace

int main(int count, char** arguments) {
  const int side = count > 1 ? std::atoi(arguments[1]) : 100;
  const int pairs = count > 2 ? std::atoi(arguments[2]) : 400;
  const bool same = agree(Specimens(square_array(20, 20, 5_mm), {}));
  std::printf("same bits from both: %s\n", same ? "yes" : "no");
  if (!same) return EXIT_FAILURE;

  const Specimens specimen(square_array(side, side, 5_mm), {});
  ContactRange<Law> library = specimen.contacts();
  ContactsByHand by_hand(library, specimen.params().contact);
  // Nothing fails and little slips.
  const std::vector<Pack> displacement = shaken(specimen, Shake::every_disc_its_own_way, 0.1_um);
  std::vector<Pack> rows(library.padded_size());
  constexpr int batch = 10;
  SideBySide times;
  for (int p = 0; p < pairs; ++p)
    times.pair(
        [&] {
          for (int k = 0; k < batch; ++k) library.evaluate(displacement, rows, 1);
        },
        [&] {
          for (int k = 0; k < batch; ++k) by_hand.evaluate(displacement.data(), rows.data());
        });

  const double contacts = static_cast<double>(library.size());
  const double per_contact = 1e9 / (batch * contacts);
  const std::size_t bytes = sizeof(Pair) + sizeof(Frame<double>) + sizeof(Law::Stiffness<double>) +
                            sizeof(Law::Memory<double>) + sizeof(Pack);
  std::printf("contacts %zu, %zu bytes each in columns and force row, discs %zu, %zu bytes each\n",
              library.size(), bytes, specimen.discs().size(), sizeof(Pack));
  std::printf("library %.2f ns per contact\nby hand %.2f ns per contact\n", times.a() * per_contact,
              times.b() * per_contact);
  std::printf("ratio library / by hand %.3f (target: at most 1.15)\n", times.a_over_b());
}
