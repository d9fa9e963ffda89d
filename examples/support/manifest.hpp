/// @file
/// Where a run comes from: what a reader needs to repeat it.
#pragma once

#include <string>

namespace hfdem::support {

struct Manifest {
  std::string program;       ///< its name
  std::string version;       ///< of hfdem
  std::string compiler;      ///< with its version
  std::string flags;         ///< that change the code, without warnings
  std::string build_type;    ///< e.g. Release
  std::string command_line;  ///< ready for a shell
  std::string seed;          ///< of random numbers; "none" if the run draws none
  int threads;
  std::string date;  ///< of the start of the run, UTC: the only one of these that the clock sets
};

/// This build, this command, now.
Manifest manifest(const std::string& program, int argc, const char* const* argv, int threads,
                  const std::string& seed = "none");

}  // namespace hfdem::support
