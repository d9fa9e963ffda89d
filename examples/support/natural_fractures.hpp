/// @file
/// The natural fractures of a run: where they come from, and how they get into its specimen.
///
/// What needs Boost, which takes long to compile, is in the source.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <hfdem/setup/fracture_file.hpp>
#include <hfdem/state/specimen.hpp>

namespace hfdem::support {

/// In a run's folder: the fractures that it has.
inline constexpr const char* fracture_table = "fractures.csv";

/// For the identity of a run: one line for each fracture; nothing if there is none.
std::string in_lines(std::span<const NaturalFracture> fractures);

/// Checks that fractures fit a box and stay away from the injection, by a clearance, m.
/// @param crack the preset one; the injection is in its middle
/// @throws InvalidParameter naming a fracture, by its line if it is from a file
void check(const NamedFractures& fractures, Vec2 box, const NaturalFracture& crack,
           double clearance);

/// Puts fractures into a specimen, if there are any.
/// @throws InvalidParameter naming a fracture that does not fit
void put_into(Specimen& specimen, const NamedFractures& fractures);

/// @throws OutputFailed if the table cannot be written
void save(const std::filesystem::path& path, std::span<const NaturalFracture> fractures);

}  // namespace hfdem::support
