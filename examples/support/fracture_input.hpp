/// @file
/// Natural fractures from a file, as a table (.csv) or as TOML (.toml):
///
///     [[fracture]]
///     from = [0.1, 0.25]     # m
///     to = [0.2, 0.4]
#pragma once

#include <string>

#include <hfdem/setup/fracture_file.hpp>

namespace hfdem::support {

/// Reads fractures; whether they fit a specimen is for `check_fractures` to say.
/// @throws InvalidParameter naming the line and what is wrong with it, or if the file cannot be
///   read, holds no fracture or has another ending
NamedFractures read_fractures(const std::string& path);

}  // namespace hfdem::support
