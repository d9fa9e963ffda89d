/// @file
/// What is said of bad input.
#pragma once

#include <string>

#include <hfdem/base/errors.hpp>

/// The message of the refusal, or "accepted".
std::string refusal(const auto& action) {
  try {
    action();
  } catch (const hfdem::InvalidParameter& e) {
    return e.what();
  }
  return "accepted";
}
