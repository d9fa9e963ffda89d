/// @file
/// The version of the library, the same as in CMakeLists.txt (a test compares them).
#pragma once

#include <string_view>

namespace hfdem {

/// Major, minor and patch, as semantic versioning means them.
inline constexpr std::string_view version = "0.1.0";

}  // namespace hfdem
