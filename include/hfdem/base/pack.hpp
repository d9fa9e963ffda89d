/// @file
/// Four doubles that move together: the value type of the vectorised contact loop.
///
/// `Pack` is a vector extension of g++ and clang++ with a fixed width of four, so its layout in
/// memory, and every bit of a result, is the same whatever instruction set the compiler is allowed
/// to use; without `-mavx` it becomes two SSE2 registers. Arithmetic operators, comparisons and
/// `mask ? a : b` are the compiler's own. The functions below exist for `double` as well, so that a
/// contact law is one formula for a single contact and for four.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

// Without AVX both compilers warn that packs would be passed differently between object files built
// with and without it. No function of a header-only library crosses that border.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace hfdem {

/// Four doubles, element by element.
using Pack = double __attribute__((vector_size(32)));
/// Four masks of 64 bits, all ones or all zeros: what comparing two packs gives.
using PackMask = decltype(Pack{} < Pack{});
inline constexpr std::size_t pack_width = 4;  ///< doubles in a pack

/// The result type of a comparison of two values of type `T`.
template <class T>
using MaskOf = decltype(T{} < T{});

/// Two doubles that move together.
using PackHalf = double __attribute__((vector_size(16)));

namespace detail {
/// A pack as two registers of processors without AVX.
struct Halves {
  PackHalf low, high;
};

/// f(a, b) on whatever the processor has registers for: without AVX compilers choose between four
/// doubles one by one, but between two at once.
template <class F>
[[gnu::always_inline]] inline Pack with_registers(const Pack& a, const Pack& b, F&& f) {
#ifdef __AVX__
  return f(a, b);
#else
  const auto x = std::bit_cast<Halves>(a), y = std::bit_cast<Halves>(b);
  return std::bit_cast<Pack>(Halves{f(x.low, y.low), f(x.high, y.high)});
#endif
}

// a > b ? a : b and a < b ? a : b, in the one instruction that compilers do not always find.
#if defined(__AVX__)
inline Pack larger(const Pack& a, const Pack& b) { return __builtin_ia32_maxpd256(a, b); }
inline Pack smaller(const Pack& a, const Pack& b) { return __builtin_ia32_minpd256(a, b); }
#elif defined(__SSE2__)
inline PackHalf larger(const PackHalf& a, const PackHalf& b) { return __builtin_ia32_maxpd(a, b); }
inline PackHalf smaller(const PackHalf& a, const PackHalf& b) { return __builtin_ia32_minpd(a, b); }
#else
template <class T>
T larger(const T& a, const T& b) {
  return a > b ? a : b;
}
template <class T>
T smaller(const T& a, const T& b) {
  return a < b ? a : b;
}
#endif
}  // namespace detail

/// @name For one value and for four
/// @{
/// Lane by lane.
inline double max(double a, double b) { return a > b ? a : b; }
inline double min(double a, double b) { return a < b ? a : b; }
inline double abs(double a) { return std::fabs(a); }
inline Pack max(const Pack& a, const Pack& b) {
  return detail::with_registers(a, b,
                                [](const auto& x, const auto& y) { return detail::larger(x, y); });
}
inline Pack min(const Pack& a, const Pack& b) {
  return detail::with_registers(a, b,
                                [](const auto& x, const auto& y) { return detail::smaller(x, y); });
}
inline Pack abs(const Pack& a) {
  constexpr long long magnitude = 0x7fff'ffff'ffff'ffff;
  return std::bit_cast<Pack>(std::bit_cast<PackMask>(a) &
                             PackMask{magnitude, magnitude, magnitude, magnitude});
}
/// `value`, or the bound that it exceeds, lane by lane.
template <class T>
T clamp(const T& value, const T& low, const T& high) {
  return max(low, min(value, high));
}

/// `size`, which is not negative, with the sign of `of`, lane by lane; zero where that is zero: a
/// velocity of exactly zero must not be damped to one side, or rounding would decide which wing of
/// a crack runs.
inline Pack with_sign(const Pack& size, const Pack& of) {
  return detail::with_registers(size, of, [](const auto& x, const auto& y) {
    using Bits = decltype(y < y);
    constexpr long long sign_bit = std::numeric_limits<long long>::min();
    const Bits signs = std::bit_cast<Bits>(y) & (Bits{} + sign_bit), is_not_zero = y != 0.0;
    return std::bit_cast<std::remove_cvref_t<decltype(x)>>((std::bit_cast<Bits>(x) ^ signs) &
                                                           is_not_zero);
  });
}

/// a + signs * b, whose signs are 1 or -1: rounded once, whether the compiler fuses it or not.
inline Pack plus_signed(const Pack& a, const Pack& signs, const Pack& b) {
#ifdef __FMA__
  return __builtin_ia32_vfmaddpd256(b, signs, a);
#else
  return a + signs * b;
#endif
}

/// Whether a comparison holds in any lane.
inline bool any(bool mask) { return mask; }
/// Whether a comparison holds in any lane.
inline bool any(const PackMask& mask) {
  using Bits [[maybe_unused]] = long long __attribute__((vector_size(32)));
  using Half [[maybe_unused]] = long long __attribute__((vector_size(16)));
  using Bytes [[maybe_unused]] = char __attribute__((vector_size(16)));
#ifdef __AVX__
  const auto bits = std::bit_cast<Bits>(mask);
  return __builtin_ia32_ptestz256(bits, bits) == 0;
#elif defined(__SSE2__)
  const auto [low, high] = std::bit_cast<std::array<Half, 2>>(mask);
  const auto is_zero = std::bit_cast<Bytes>(low | high) == Bytes{};
  return __builtin_ia32_pmovmskb128(std::bit_cast<Bytes>(is_zero)) != 0xffff;
#else
  return (mask[0] | mask[1] | mask[2] | mask[3]) != 0;
#endif
}
/// @}

/// Turns four rows into four columns (and back).
inline void transpose(Pack& a, Pack& b, Pack& c, Pack& d) {
#ifdef __AVX__
  const Pack ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6);
  const Pack ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Pack cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Pack cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
  d = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
#else
  const auto [a_low, a_high] = std::bit_cast<detail::Halves>(a);
  const auto [b_low, b_high] = std::bit_cast<detail::Halves>(b);
  const auto [c_low, c_high] = std::bit_cast<detail::Halves>(c);
  const auto [d_low, d_high] = std::bit_cast<detail::Halves>(d);
  const auto join = [](const PackHalf& low, const PackHalf& high) {
    return std::bit_cast<Pack>(detail::Halves{low, high});
  };
  a = join(__builtin_shufflevector(a_low, b_low, 0, 2),
           __builtin_shufflevector(c_low, d_low, 0, 2));
  b = join(__builtin_shufflevector(a_low, b_low, 1, 3),
           __builtin_shufflevector(c_low, d_low, 1, 3));
  c = join(__builtin_shufflevector(a_high, b_high, 0, 2),
           __builtin_shufflevector(c_high, d_high, 0, 2));
  d = join(__builtin_shufflevector(a_high, b_high, 1, 3),
           __builtin_shufflevector(c_high, d_high, 1, 3));
#endif
}

/// A record whose members are all of its value type.
template <class Four>
inline constexpr bool holds_only_packs = [] {
  return []<std::size_t... I>(std::index_sequence<I...>) {
    return requires { Four{(static_cast<void>(I), Pack{})...}; };
  }
  (std::make_index_sequence < std::is_empty_v<Four> ? 0 : sizeof(Four) / sizeof(Pack) > {});
}();

/// Whether two records of packs are not the same, bit for bit.
template <class Four>
bool differ(const Four& one, const Four& other) {
  if constexpr (std::is_empty_v<Four>) {
    return false;
  } else {
    using Bits = std::array<PackMask, sizeof(Four) / sizeof(Pack)>;
    const auto a = std::bit_cast<Bits>(one), b = std::bit_cast<Bits>(other);
    PackMask difference{};
    for (std::size_t m = 0; m < a.size(); ++m) difference |= a[m] ^ b[m];
    return any(difference);
  }
}

/// A column of records, `Record<double>` each, stored four to a block as `Record<Pack>`: the loop
/// reads whole blocks, everything else reads and writes single records.
/// @tparam Record an aggregate template whose members are all of its value type.
template <template <class> class Record>
class PackedColumn {
 public:
  using One = Record<double>;  ///< a single record
  using Four = Record<Pack>;   ///< a block of four
  /// Values in a record; a column of empty records holds nothing.
  static constexpr std::size_t members = std::is_empty_v<One> ? 0 : sizeof(One) / sizeof(double);
  static_assert(holds_only_packs<Four>,
                "the members of a packed record must all be of its value type");

  PackedColumn() = default;
  /// @param size number of records, a multiple of `pack_width`; all start as zeros.
  explicit PackedColumn(std::size_t size) : blocks_(size / pack_width, Four{}) {}

  /// Records 4 b to 4 b + 3.
  Four& block(std::size_t b) { return blocks_[b]; }
  /// Records 4 b to 4 b + 3.
  const Four& block(std::size_t b) const { return blocks_[b]; }

  /// Every record.
  void exchange(auto& archive) {
    if constexpr (members > 0) archive(std::span(blocks_));
  }

  /// A copy of one record; `set` writes it.
  One operator[](std::size_t index) const { return lane(blocks_[index / pack_width], index); }

  /// Replaces one record, bit for bit.
  void set(std::size_t index, const One& record) {
    auto values = std::bit_cast<std::array<double, members * pack_width>>(blocks_[index / 4]);
    const auto source = std::bit_cast<std::array<double, members>>(record);
    for (std::size_t m = 0; m < members; ++m)
      values[m * pack_width + index % pack_width] = source[m];
    blocks_[index / pack_width] = std::bit_cast<Four>(values);
  }

  /// All blocks, for a loop.
  Four* blocks() { return blocks_.data(); }
  /// All blocks, for a loop.
  const Four* blocks() const { return blocks_.data(); }

  /// The record of one lane of a block (`index` modulo four).
  static One lane(const Four& block, std::size_t index) {
    const auto values = std::bit_cast<std::array<double, members * pack_width>>(block);
    std::array<double, members> one{};
    for (std::size_t m = 0; m < members; ++m) one[m] = values[m * pack_width + index % pack_width];
    return std::bit_cast<One>(one);
  }

 private:
  std::vector<Four> blocks_;
};

}  // namespace hfdem
