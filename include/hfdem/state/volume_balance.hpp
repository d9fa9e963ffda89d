/// @file
/// Where the fluid is: the volume ledger of a pressure scheme.
#pragma once

#include <cmath>

namespace hfdem {

/// Volumes at zero pressure, m2 (per m of thickness):
///
///   injected + initial = stored - empty + unmet + leaked + out
///
/// What is stored follows from the network's widths and pressures alone, what has come in from the
/// injection and the channels' filled widths; a scheme that loses or makes fluid does not balance.
struct VolumeBalance {
  double injected = 0;  ///< so far
  double initial = 0;   ///< was in the channels before the injected fluid reached them
  double stored = 0;    ///< fits into the wet channels as wide as they are, at their pressures
  double empty = 0;     ///< of that room, what fluid at the least pressure does not fill
  double unmet = 0;     ///< what has no room yet: the pressures are not quite what they should be
  double leaked = 0;    ///< gone into the rock
  double out = 0;       ///< gone out of the specimen

  /// What is missing, over all that came in; 0 before anything did.
  double relative_error() const {
    const double came = injected + initial;
    const double missing = std::abs(came - (stored - empty + unmet + leaked + out));
    return missing == 0 ? 0 : missing / came;
  }
};

}  // namespace hfdem
