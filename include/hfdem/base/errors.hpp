/// @file
/// The ways in which hfdem refuses, or stops.
#pragma once

#include <stdexcept>

namespace hfdem {

/// Input that cannot be meant: the message names the field, its value and the allowed range.
struct InvalidParameter : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// A run that cannot go on (crack at the rim, volume runaway, not a number, no equilibrium): the
/// message is a sentence for the user. The state up to here stays readable.
struct RunStopped : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The crack has reached the rim of the specimen, where the fluid would leave it: for a specimen of
/// finite size an end as good as any.
struct ReachedRim : RunStopped {
  using RunStopped::RunStopped;
};

}  // namespace hfdem
