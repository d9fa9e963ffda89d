/// @file
/// What moving discs comes to: of a range of them while it goes on, and of a whole step.
#pragma once

#include <hfdem/base/pack.hpp>

namespace hfdem {

/// What moving a range of discs came to.
struct MotionTally {
  Pack largest{};  ///< of the squares of the resultants that count, (N per m)^2, in the first lane
  Pack sum{};      ///< of these squares: a maximum loses what is not a number, a sum keeps it
  Pack fastest{};  ///< of the components of velocity, m/s and rad/s
};

/// What a step came to; nothing of it is a finite number if some resultant is not.
struct Moved {
  double resultant;           ///< the largest on a disc that counts, before damping, N per m
  double distance, rotation;  ///< no component of a displacement, m, and no rotation, rad, has
                              ///< changed by more

  /// By how much the motion of a contact has changed at most: opening, shear, and rotation times
  /// the smaller disc's radius together, m. Two discs move by twice a component apart in x and as
  /// much in y; they turn alike, which is all shear, or against each other, which is no more.
  /// @param lever no arm and no radius is longer, m
  double of_contacts(double lever) const { return 4 * distance + 2 * lever * rotation; }
};

}  // namespace hfdem
