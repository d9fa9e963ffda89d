/// @file
/// Where rows of four doubles are.
#pragma once

#include <hfdem/base/index.hpp>
#include <hfdem/base/pack.hpp>

namespace hfdem {

/// The place of a row of four doubles, counted in doubles: its number times four, where processors
/// find it without multiplying.
struct RowPlace {
  /// The place of row `row`.
  static constexpr Index of(Index row) { return row * Index{pack_width}; }
  /// The row at a place.
  static constexpr Index row(Index place) { return place / Index{pack_width}; }
  /// What is there.
  static const Pack& at(const Pack* rows, Index place) {
    return *reinterpret_cast<const Pack*>(reinterpret_cast<const double*>(rows) + place);
  }
};

}  // namespace hfdem
