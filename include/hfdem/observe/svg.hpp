#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <hfdem/observe/colours.hpp>

/// \file
/// What the SVG pictures share: lengths in pixels, y down, nothing that depends on the locale.

namespace hfdem::observe {

/// Where a picture stands: in a file it carries its title and caption itself; a page of text says
/// them, and lends the picture its own background; on a phone the picture is narrow as well.
enum class Medium { file, page, phone };

/// Building blocks; a caller of `svg(...)` needs none of them.
namespace drawing {
inline constexpr double margin = 24.0;

struct Pixel {
  double x = 0.0, y = 0.0;
};

struct Box {
  double left = 0.0, top = 0.0, width = 0.0, height = 0.0;
  [[nodiscard]] double right() const { return left + width; }
  [[nodiscard]] double bottom() const { return top + height; }
  [[nodiscard]] bool contains(Pixel p) const {
    return p.x >= left && p.x <= right() && p.y >= top && p.y <= bottom();
  }
};

/// `value` with at most `decimals` decimals and no trailing zeros.
inline std::string number(double value, int decimals = 1) {
  std::array<char, 400> buffer{};  // the largest double has 309 digits before the point
  const auto written = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                     std::chars_format::fixed, decimals);
  std::string digits(buffer.data(), written.ptr);
  if (decimals > 0) digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.back() == '.') digits.pop_back();
  return digits == "-0" ? "0" : digits;
}

/// The largest of 1, 2 and 5 times a power of ten that does not exceed `value` > 0.
inline double round_down(double value) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)));
  const double lead = value / unit * (1.0 + 1e-9);  // 0.5 / 0.1 may fall short of 5
  return unit * (lead >= 5.0 ? 5.0 : lead >= 2.0 ? 2.0 : 1.0);
}

/// ` name="value"`
inline std::string attribute(std::string_view name, std::string_view value) {
  return std::string(" ").append(name).append("=\"").append(value).append("\"");
}
inline std::string attribute(std::string_view name, double value) {
  return attribute(name, number(value, 2));
}
inline std::string attributes(const Box& box) {
  return attribute("x", box.left) + attribute("y", box.top) + attribute("width", box.width) +
         attribute("height", box.height);
}
/// `attributes` for an <svg>, whose own coordinates shall be those around it.
inline std::string view(const Box& box) {
  return attributes(box) +
         attribute("viewBox", number(box.left, 2) + " " + number(box.top, 2) + " " +
                                  number(box.width, 2) + " " + number(box.height, 2));
}
inline std::string stroke(Colour colour, double width) {
  return attribute("fill", "none") + attribute("stroke", hex(colour)) +
         attribute("stroke-width", width);
}
inline std::string fill(Colour colour) { return attribute("fill", hex(colour)); }

inline std::string rectangle(const Box& box, std::string_view paint) {
  return "<rect" + attributes(box) + std::string(paint) + "/>\n";
}
inline std::string circle(Pixel centre, double radius, std::string_view paint = "") {
  return "<circle" + attribute("cx", centre.x) + attribute("cy", centre.y) +
         attribute("r", radius) + std::string(paint) + "/>\n";
}

/// Path data with relative coordinates, which are short, rounded to 0.1 pixel without drift.
class Path {
 public:
  void move_to(Pixel to) { append('m', to); }
  void line_to(Pixel to) { append('l', to); }
  /// A stroke of no length: its round caps make a disc as wide as the stroke.
  void dot(Pixel at) {
    move_to(at);
    data_ += "h0";
  }
  [[nodiscard]] std::string element(std::string_view paint) const {
    return "<path" + attribute("d", data_) + std::string(paint) + "/>\n";
  }

 private:
  void append(char command, Pixel to) {
    const Pixel tenths{std::round(to.x * 10.0), std::round(to.y * 10.0)};
    const std::string down = number((tenths.y - last_.y) / 10.0);
    data_ +=
        command + number((tenths.x - last_.x) / 10.0) + (down.front() == '-' ? "" : " ") + down;
    last_ = tenths;
  }
  std::string data_;
  Pixel last_;  // in tenths of a pixel
};

inline std::string line(const std::vector<Pixel>& corners, std::string_view paint) {
  Path path;
  path.move_to(corners.front());
  for (const Pixel& corner : corners) path.line_to(corner);
  return path.element(paint);
}

struct TextStyle {
  double size = 12.0;
  Colour colour = ink;
  std::string_view anchor = "start";
  bool bold = false;
  bool halo = false;  ///< a white rim, for words on top of lines
  [[nodiscard]] double leading() const { return 1.3 * size; }
};

inline std::string escaped(char c) {
  if (c == '&') return "&amp;";
  if (c == '<') return "&lt;";
  if (c == '>') return "&gt;";
  if (c == '"') return "&quot;";
  return {static_cast<unsigned char>(c) < ' ' ? ' ' : c};
}

/// `S_{min}` and `10^{-6}` as the SVG text `S` with a subscript, `10` with a superscript.
inline std::string markup(std::string_view words, double size) {
  std::string out, closing;
  double shift = 0.0;  // of the group that is open
  for (std::size_t i = 0; i < words.size(); ++i) {
    const char c = words[i];
    if ((c == '_' || c == '^') && words.substr(i + 1).starts_with('{')) {
      shift = size * (c == '_' ? 0.22 : -0.35);
      out += "<tspan" + attribute("dy", shift) + attribute("font-size", 0.75 * size) + ">";
      ++i;  // past the brace
    } else if (c == '}' && shift != 0.0) {
      // an empty <tspan> would shift nothing, so the way back wraps the rest of the line
      out += "</tspan><tspan" + attribute("dy", -shift) + ">";
      closing += "</tspan>";
      shift = 0.0;
    } else {
      out += escaped(c);
    }
  }
  return out + (shift != 0.0 ? "</tspan>" : "") + closing;
}

/// `words` for readers that know no sub- and superscripts.
inline std::string plain(std::string_view words) {
  std::string out;
  for (const char c : words) out += c == '{' || c == '}' ? "" : escaped(c);
  return out;
}

/// An upper estimate for usual words, from the letters of the wide DejaVu Sans.
inline double text_width(std::string_view words, TextStyle style = {}) {
  const auto letters = std::ranges::count_if(words, [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U && c != '{' && c != '}';  // of UTF-8
  });
  return 0.62 * static_cast<double>(letters) * style.size * (style.bold ? 1.13 : 1.0);
}

/// `words` broken at white space into lines of at most `width`, or of one long word.
inline std::vector<std::string> wrap(std::string_view words, double width, TextStyle style = {}) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < words.size();) {
    const std::size_t end = std::min(words.find_first_of(" \n", begin), words.size());
    const std::string word(words.substr(begin, end - begin));
    begin = end + 1;
    if (word.empty()) continue;
    if (!lines.empty() && text_width(lines.back() + " " + word, style) <= width) {
      lines.back() += " " + word;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

inline std::string text(Pixel at, std::string_view words, TextStyle style = {}) {
  std::string element = "<text" + attribute("x", at.x) + attribute("y", at.y) +
                        attribute("font-size", style.size) + fill(style.colour);
  if (style.anchor != "start") element += attribute("text-anchor", style.anchor);
  if (style.bold) element += attribute("font-weight", "600");
  if (style.halo)
    element += attribute("stroke", hex(white)) +
               R"( stroke-width="4" stroke-linejoin="round" paint-order="stroke")";
  return element + ">" + markup(words, style.size) + "</text>\n";
}
/// One line of text under the other; `at` is the start of the first base line.
inline std::string text(Pixel at, const std::vector<std::string>& lines, TextStyle style) {
  std::string elements;
  for (const std::string& words : lines) {
    elements += text(at, words, style);
    at.y += style.leading();
  }
  return elements;
}

/// `content` as far as it lies in `box`; no id is needed, so pictures can share a web page.
inline std::string window(const Box& box, std::string_view content) {
  return "<svg" + view(box) + ">\n" + std::string(content) + "</svg>\n";
}

inline constexpr std::string_view font_family =
    "system-ui,'Segoe UI',Roboto,Helvetica,Arial,sans-serif";

/// The picture for a file: title, `body` of `width` by `height` between the margins, caption.
inline std::string document(std::string_view title, std::string_view caption, double width,
                            double height, std::string_view body) {
  const TextStyle heading{.size = 17.0, .bold = true}, note{.colour = grey};
  const auto headings = wrap(title, width, heading), notes = wrap(caption, width, note);
  const double top = margin + heading.leading() * static_cast<double>(headings.size()) + 12.0;
  const double below = top + height + 26.0;  // base line of the caption
  const Box paper{.width = width + 2.0 * margin,
                  .height = below + note.leading() * static_cast<double>(notes.size())};
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" xml:space=\"preserve\"" +
         view(paper) + attribute("font-family", font_family) + ">\n<title>" + plain(title) +
         "</title>\n<desc>" + plain(caption) + "</desc>\n" + rectangle(paper, fill(white)) +
         text({margin, margin + heading.size * 0.8}, headings, heading) + "<g" +
         attribute("transform", "translate(" + number(margin) + " " + number(top) + ")") + ">\n" +
         std::string(body) + "</g>\n" + text({margin, below}, notes, note) + "</svg>\n";
}

/// The picture for a page of text, which has the words: `body` alone.
inline std::string inlined(std::string_view title, double width, double height,
                           std::string_view body) {
  constexpr double rim = 3.0;  // strokes are wider than what they follow
  return "<svg role=\"img\"" + attribute("aria-label", plain(title)) +
         view({-rim, -rim, width + 2.0 * rim, height + 2.0 * rim}) +
         attribute("font-family", font_family) + ">\n" + std::string(body) + "</svg>\n";
}

/// `body` for a medium. A page of many figures says the `conditions` of a run once, a file in its
/// caption.
inline std::string sheet(std::string_view title, const std::string& caption,
                         const std::string& conditions, double width, double height,
                         std::string_view body, Medium medium) {
  return medium == Medium::file ? document(title, caption + " " + conditions, width, height, body)
                                : inlined(title, width, height, body);
}

}  // namespace drawing
}  // namespace hfdem::observe
