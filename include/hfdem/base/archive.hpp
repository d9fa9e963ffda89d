/// @file
/// The state of a run as bytes, and back: what a checkpoint is made of.
///
/// A class lists what evolves in it once, and the list serves both directions:
///
///     void exchange(auto& archive) { archive(pressure_, steps_, std::span(width_)); }
///
/// What follows from the parameters is made by the constructor and does not belong there. Every
/// number takes eight bytes, the least significant first; lists and texts are preceded by their
/// length. What is saved is sealed (base/seal.hpp).
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <hfdem/base/errors.hpp>
#include <hfdem/base/fields.hpp>
#include <hfdem/base/seal.hpp>

namespace hfdem {

static_assert(std::endian::native == std::endian::little,
              "archives keep numbers as they are in memory, the least significant byte first");

namespace detail {

template <class>
inline constexpr bool is_span = false;
template <class T>
inline constexpr bool is_span<std::span<T>> = true;

template <class T, class Archive>
concept lists_what_evolves = requires(T& value, Archive& archive) {
  value.exchange(archive);
};

/// The class that a member function was declared in, a base perhaps.
template <class Class, class Archive>
Class declared_in(void (Class::*)(Archive&));
/// A list inherited from a base knows nothing of what a class adds to it, unless the base is empty
/// and asks the class.
template <class T, class Archive>
concept lists_its_own = std::is_same_v<T, decltype(declared_in(&T::template exchange<Archive>))> ||
    std::is_empty_v<decltype(declared_in(&T::template exchange<Archive>))>;

}  // namespace detail

/// What both directions share: which bytes a value has. `Direction` moves them.
template <class Direction>
class Archive {
 protected:
  /// Moves a value of any type that has bytes: numbers, names, texts, lists of these, vectors in
  /// the plane, described parameters, and every class with a member `exchange`.
  template <class T>
  void one(T& value) {
    Direction& archive = static_cast<Direction&>(*this);
    if constexpr (detail::lists_what_evolves<T, Direction>) {
      static_assert(detail::lists_its_own<T, Direction>,
                    "This class inherits its member `void exchange(auto& archive)`, which does not "
                    "know what the class adds: it needs one of its own that lists all.");
      value.exchange(archive);
    } else if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
      archive.number(value);
    } else if constexpr (detail::is_span<T>) {
      archive.expect(value.size());
      block(value.data(), value.size());
    } else if constexpr (is_list<T> || std::is_same_v<T, std::string>) {
      list(value);
    } else if constexpr (is_optional<T>) {
      bool has_value = value.has_value();
      one(has_value);
      if (!has_value) return value.reset();
      if (!value) value.emplace();
      one(*value);
    } else if constexpr (Described<T>) {
      for_each_field<T>([&](const auto& field) { one(value.*(field.member)); });
    } else if constexpr (std::is_same_v<T, Vec2>) {
      archive(value.x, value.y);
    } else {
      static_assert(std::is_empty_v<T>,
                    "This class has data, but no public member `void exchange(auto& archive)` that "
                    "lists what evolves in it, as in `archive(a_, b_)`: without it a checkpoint "
                    "would lose that. If nothing evolves, let the list be empty: `{}`.");
    }
  }

 private:
  template <class List>
  void list(List& values) {
    using T = typename List::value_type;
    constexpr bool as_block = std::is_trivially_copyable_v<T> && !std::is_same_v<T, bool> &&
                              !detail::lists_what_evolves<T, Direction>;
    Direction& archive = static_cast<Direction&>(*this);
    values.resize(archive.length(values.size(), as_block ? sizeof(T) : 1));
    if constexpr (as_block) {
      block(values.data(), values.size());
    } else if constexpr (std::is_same_v<T, bool>) {
      for (auto&& flag : values) {
        char byte = flag ? 1 : 0;
        archive.bytes(&byte, 1);
        flag = byte != 0;
      }
    } else {
      for (T& value : values) one(value);
    }
  }

  template <class T>
  void block(T* values, std::size_t count) {
    static_assert(std::is_trivially_copyable_v<T> && !std::is_pointer_v<T>,
                  "only values that are their bytes can be kept in a block");
    static_cast<Direction&>(*this).bytes(values, count * sizeof(T));
  }
};

/// Collects what evolves.
class Saver : public Archive<Saver> {
 public:
  static constexpr bool loads = false;  ///< for the rare class whose two directions differ

  /// Adds values, which stay as they are.
  template <class... T>
  void operator()(const T&... values) {
    // One list serves both directions, so it is no const member; here it is only read.
    (one(const_cast<T&>(values)), ...);
  }

  /// Everything so far, sealed.
  std::string sealed() const { return seal(content_); }

 private:
  friend Archive<Saver>;

  template <class T>
  void number(T& value) {
    if constexpr (std::is_floating_point_v<T>) {
      const double wide = value;
      bytes(&wide, sizeof wide);
    } else {
      const auto wide = static_cast<std::int64_t>(value);
      bytes(&wide, sizeof wide);
    }
  }
  std::size_t length(std::size_t size, std::size_t) {
    expect(size);
    return size;
  }
  void expect(std::size_t size) { number(size); }
  void bytes(const void* data, std::size_t size) {
    content_.append(static_cast<const char*>(data), size);
  }

  std::string content_{};
};

/// Gives back what a `Saver` has collected, value by value in the same order.
class Loader : public Archive<Loader> {
 public:
  static constexpr bool loads = true;  ///< for the rare class whose two directions differ

  /// @param sealed what `Saver::sealed` gave
  /// @param name of where it comes from, for messages
  /// @throws InvalidParameter if it is no sealed state, or damaged
  Loader(std::string sealed, std::string name) : all_(std::move(sealed)), name_(std::move(name)) {
    const std::string_view content = unseal(all_, name_);
    place_ = static_cast<std::size_t>(content.data() - all_.data());
    end_ = place_ + content.size();
  }

  /// Replaces values by the next ones. A span must be as long as it was.
  /// @throws InvalidParameter naming the byte, if what stands there cannot be the next value
  template <class... T>
  void operator()(T&&... values) {
    (one(values), ...);
  }

  /// Call when all is read.
  /// @throws InvalidParameter if something is left
  void finish() const {
    if (place_ != end_)
      wrong_here(std::to_string(end_ - place_) + " bytes follow the last value that is known");
  }

  /// Refuses the state.
  /// @throws InvalidParameter "NAME why"
  [[noreturn]] void wrong(const std::string& why) const {
    throw InvalidParameter(name_ + " " + why);
  }

 private:
  friend Archive<Loader>;

  [[noreturn]] void wrong_here(const std::string& why) const {
    wrong("does not fit this run, at byte " + std::to_string(place_) + ": " + why);
  }

  template <class T>
  void number(T& value) {
    if constexpr (std::is_floating_point_v<T>) {
      double wide = 0;
      bytes(&wide, sizeof wide);
      value = static_cast<T>(wide);
    } else {
      std::int64_t wide = 0;
      bytes(&wide, sizeof wide);
      value = static_cast<T>(wide);
      if (static_cast<std::int64_t>(value) != wide)
        wrong_here(std::to_string(wide) + " stands before it, where a smaller number should");
    }
  }
  /// The length of a list whose entries take at least so many bytes each.
  std::size_t length(std::size_t, std::size_t least) {
    std::uint64_t size = 0;
    number(size);
    if (size > (end_ - place_) / least)
      wrong_here("a list of " + std::to_string(size) + " entries should begin, which is too long");
    return size;
  }
  void expect(std::size_t size) {
    std::size_t found = 0;
    number(found);
    if (found != size)
      wrong_here(std::to_string(found) + " values stand where " + std::to_string(size) + " should");
  }
  void bytes(void* data, std::size_t size) {
    if (size > end_ - place_)
      wrong_here(std::to_string(size) + " bytes should follow, and " +
                 std::to_string(end_ - place_) + " do");
    if (size > 0) std::memcpy(data, all_.data() + place_, size);
    place_ += size;
  }

  std::string all_, name_;
  std::size_t place_ = 0, end_ = 0;
};

}  // namespace hfdem
