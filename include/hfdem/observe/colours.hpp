#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>

/// \file
/// The colours of pictures: one meaning, one colour, everywhere; and what stands for each of them
/// where the reader's background is dark.

namespace hfdem::observe {

/// A colour of the screen (sRGB).
struct Colour {
  std::uint8_t red = 0, green = 0, blue = 0;  ///< 0 to 255
};

/// Colours of Okabe and Ito, which people with any colour vision can tell apart.
namespace okabe_ito {
inline constexpr Colour black{0, 0, 0}, orange{230, 159, 0}, sky_blue{86, 180, 233},
    green{0, 158, 115}, blue{0, 114, 178}, vermillion{213, 94, 0},
    purple{204, 121, 167};  ///< as named
}  // namespace okabe_ito

/// The colours of lines, in the order in which they are given out.
inline constexpr std::array palette{okabe_ito::blue,       okabe_ito::orange,   okabe_ito::black,
                                    okabe_ito::vermillion, okabe_ito::sky_blue, okabe_ito::green,
                                    okabe_ito::purple};

namespace drawing {
inline constexpr Colour white{255, 255, 255}, ink{34, 34, 34}, grey{102, 102, 102},
    pale{226, 226, 226};
inline constexpr Colour stone{222, 215, 203}, stone_rim{150, 140, 124}, pore{250, 248, 244},
    steel{120, 128, 136}, crack_red{204, 0, 0};

inline std::string hex(Colour colour) {
  std::array<char, 8> code{};
  std::snprintf(code.data(), code.size(), "#%02x%02x%02x", colour.red, colour.green, colour.blue);
  return code.data();
}

/// `colour`, darkened where it is too light for letters on white: a contrast of at least 4.5.
inline Colour readable(Colour colour) {
  const auto square = [](std::uint8_t part) { return part * part / (255.0 * 255.0); };
  const double luminance =
      0.21 * square(colour.red) + 0.72 * square(colour.green) + 0.07 * square(colour.blue);
  const double factor = std::sqrt(std::min(1.0, 0.2 / std::max(luminance, 1e-6)));
  const auto dim = [factor](std::uint8_t part) { return static_cast<std::uint8_t>(part * factor); };
  return {dim(colour.red), dim(colour.green), dim(colour.blue)};
}

/// A colour on white, and what it becomes on a dark background.
struct Counterpart {
  Colour light, dark;
};
inline constexpr Colour night{22, 24, 28};  ///< the dark background itself

/// Lines and words.
inline constexpr std::array counterparts{Counterpart{white, night},
                                         Counterpart{ink, {228, 226, 222}},
                                         Counterpart{grey, {168, 168, 170}},
                                         Counterpart{pale, {54, 57, 63}},
                                         Counterpart{okabe_ito::black, {228, 226, 222}},
                                         Counterpart{okabe_ito::blue, {77, 166, 224}},
                                         Counterpart{okabe_ito::orange, okabe_ito::orange},
                                         Counterpart{okabe_ito::sky_blue, {140, 205, 245}},
                                         Counterpart{okabe_ito::green, {28, 184, 140}},
                                         Counterpart{okabe_ito::vermillion, {236, 122, 44}},
                                         Counterpart{okabe_ito::purple, {219, 144, 185}}};

/// Rock is a picture of a thing: it only dims, so that a crack in it stays black and red.
inline constexpr std::array rock_counterparts{Counterpart{stone, {204, 196, 183}},
                                              Counterpart{stone_rim, {128, 118, 102}},
                                              Counterpart{pore, {226, 221, 212}}};

}  // namespace drawing
}  // namespace hfdem::observe
