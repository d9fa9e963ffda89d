/// @file
/// How discs, contacts and flow domains are counted.
#pragma once

#include <cstdint>

namespace hfdem {

/// Index of a disc, contact, domain; `nothing` stands for none.
using Index = std::uint32_t;
inline constexpr Index nothing = ~Index{0};  ///< no disc, contact or domain

}  // namespace hfdem
