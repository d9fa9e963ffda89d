/// @file
/// How long the bonds are sure to hold: a book of how far the discs have moved at most.
///
/// A law with a margin (`ForeseesFailure`) says how far a contact is from failing. Until some
/// contact can have moved so far, nobody needs to ask, and a step can move discs while forces
/// elsewhere are not known yet (see sweep.hpp). Results do not depend on what is foreseen: who asks
/// in vain makes the same step.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace hfdem {

/// Chunks of contacts, and how long each is sure to hold.
class Foresight {
 public:
  /// @param chunks of contacts
  /// @param rounding motion that rounding may hide, m
  Foresight(std::size_t chunks, double rounding) : sure_until_(chunks), rounding_(rounding) {
    forget();
  }

  /// Nothing is sure any more: something other than steps has moved or changed the contacts.
  void forget() {
    sure_until_.assign(sure_until_.size(), lowest);
    first_end_ = lowest;
    distance_ = 0;
  }

  /// This chunk is not sure any more.
  void forget(std::size_t chunk) {
    sure_until_[chunk] = lowest;
    first_end_ = lowest;
  }

  /// No contact's motion has changed by more than this, m, since the last step: opening, shear, and
  /// rotation times the smaller disc's radius together.
  void moved(double at_most) {
    distance_ += at_most;
    ++steps_;
    // A longer sum would round away what discs move in slow steps.
    if (distance_ > 1e9 * rounding_) forget();
  }

  /// Whether all contacts are sure to hold.
  bool sure() const { return distance_ < first_end_; }

  /// Whether asking those that are not sure has been worth it: not where most were asked and had to
  /// be asked again in the next step. Then a number of steps passes before anybody is asked.
  bool pays() {
    constexpr int rest = 16;
    if (asked_most_ && steps_ <= 1) to_rest_ = rest;
    asked_most_ = false;
    return to_rest_ == 0 || --to_rest_ == 0;
  }

  /// The chunks that are not sure to hold.
  const std::vector<std::size_t>& unsure() {
    unsure_.clear();
    for (std::size_t chunk = 0; chunk < sure_until_.size(); ++chunk)
      if (!(distance_ < sure_until_[chunk])) unsure_.push_back(chunk);
    asked_most_ = 2 * unsure_.size() > sure_until_.size();
    steps_ = 0;
    return unsure_;
  }

  /// No contact of this chunk fails before its motion has changed by so much, m. Chunks may be told
  /// from several threads; call `count` afterwards.
  void tell(std::size_t chunk, double margin) {
    sure_until_[chunk] = distance_ + (margin - rounding_);
  }
  /// Takes up what was told.
  void count() {
    first_end_ = std::numeric_limits<double>::max();
    for (const double end : sure_until_) first_end_ = end < first_end_ ? end : first_end_;
  }

 private:
  static constexpr double lowest = std::numeric_limits<double>::lowest();

  std::vector<double> sure_until_;  // distances
  double rounding_;
  double distance_ = 0, first_end_ = lowest;
  bool asked_most_ = false;
  long steps_ = 0;   // since somebody was asked
  int to_rest_ = 0;  // steps
  std::vector<std::size_t> unsure_;
};

}  // namespace hfdem
