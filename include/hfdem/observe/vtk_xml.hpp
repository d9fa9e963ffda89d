/// @file
/// VTK's XML files: points, lines, polygons and numbers on them (PolyData, .vtp), and ParaView's
/// list of such files over time (.pvd).
///
/// Source: "VTK XML file formats" in VTK's documentation, version 1.0 with headers of 64 bits.
/// Arrays stand inline in base64, so that a file is well-formed XML to every reader; reals are
/// single precision.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <hfdem/base/vec2.hpp>
#include <hfdem/state/contact.hpp>

namespace hfdem::observe {

/// Bytes as text (RFC 4648, section 4).
inline std::string base64(std::span<const std::byte> bytes) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text((bytes.size() + 2) / 3 * 4, '=');
  for (std::size_t k = 0, at = 0; k < bytes.size(); k += 3, at += 4) {
    const std::size_t present = std::min<std::size_t>(3, bytes.size() - k);
    std::uint32_t triple = 0;
    for (std::size_t b = 0; b < present; ++b)
      triple |= std::to_integer<std::uint32_t>(bytes[k + b]) << (16 - 8 * b);
    for (std::size_t d = 0; d <= present; ++d) text[at + d] = digits[triple >> (18 - 6 * d) & 63];
  }
  return text;
}

/// One row of an array of reals.
template <class... Numbers>
std::array<float, sizeof...(Numbers)> reals(Numbers... numbers) {
  return {static_cast<float>(numbers)...};
}

namespace detail {

template <class T>
inline constexpr std::string_view vtk_type{};
template <>
inline constexpr std::string_view vtk_type<float> = "Float32";
template <>
inline constexpr std::string_view vtk_type<std::int32_t> = "Int32";
template <>
inline constexpr std::string_view vtk_type<std::uint8_t> = "UInt8";

/// `name="value"` with a blank before it. Names and values hold no character that XML reserves.
inline std::string xml(std::string_view name, std::string_view value) {
  return " " + std::string(name) + "=\"" + std::string(value) + "\"";
}
inline std::string xml(std::string_view name, std::size_t value) {
  return xml(name, std::to_string(value));
}

template <class T, std::size_t components>
std::string data_array(std::string_view name, const std::vector<std::array<T, components>>& rows) {
  static_assert(!vtk_type<T>.empty(), "VTK has a name for this type, but it is not listed here");
  const std::uint64_t size = rows.size() * sizeof(rows[0]);
  std::vector<std::byte> bytes(sizeof size + size);
  std::memcpy(bytes.data(), &size, sizeof size);
  if (size > 0) std::memcpy(bytes.data() + sizeof size, rows.data(), size);
  return "<DataArray" + xml("type", vtk_type<T>) + xml("Name", name) +
         xml("NumberOfComponents", components) + xml("format", "binary") + ">" + base64(bytes) +
         "</DataArray>\n";
}

/// The same digits as in the tables of history.hpp.
inline std::string time_text(double time) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", time);
  return text;
}

/// A whole file.
inline std::string vtk_file(std::string_view type, std::string_view content) {
  const bool little = std::endian::native == std::endian::little;
  return "<?xml version=\"1.0\"?>\n<VTKFile" + xml("type", type) + xml("version", "1.0") +
         xml("byte_order", little ? "LittleEndian" : "BigEndian") + xml("header_type", "UInt64") +
         ">\n" + std::string(content) + "</VTKFile>\n";
}

}  // namespace detail

/// Points that are cells of their own, the ends of lines or the corners of polygons, and arrays on
/// points and on these cells; a file has one kind of cells.
class VtkPolyData {
 public:
  /// @param time of the simulation, s
  explicit VtkPolyData(double time) : time_(time) {}

  /// Points, lines and polygons count from zero, in the order in which they are added. Lengths in
  /// m.
  void add_point(Vec2 at) { points_.push_back(reals(at.x, at.y, 0)); }
  /// @param from, to points, which may be added later
  void add_line(std::size_t from, std::size_t to) {
    line_ends_.push_back({static_cast<std::int32_t>(from)});
    line_ends_.push_back({static_cast<std::int32_t>(to)});
  }
  /// @param corners points, one after the other around it
  void add_polygon(std::span<const Index> corners) {
    for (const Index point : corners) corners_.push_back({static_cast<std::int32_t>(point)});
    polygon_ends_.push_back({static_cast<std::int32_t>(corners_.size())});
  }
  /// Makes every point a cell that can be seen and selected.
  void show_points() { points_are_vertices_ = true; }

  /// An array on the points: one row for each.
  /// @param name of the array
  /// @param row gives `reals(...)`, or an array of whole numbers, for an index
  template <class Row>
  void add_to_points(std::string_view name, Row&& row) {
    point_data_ += array(name, points_.size(), row);
  }
  /// The same on the lines.
  template <class Row>
  void add_to_lines(std::string_view name, Row&& row) {
    cell_data_ += array(name, lines(), row);
  }
  /// The same on the polygons.
  template <class Row>
  void add_to_polygons(std::string_view name, Row&& row) {
    cell_data_ += array(name, polygon_ends_.size(), row);
  }

  /// The whole file.
  std::string text() const {
    using detail::xml;
    assert(points_are_vertices_ + !line_ends_.empty() + !polygon_ends_.empty() <= 1);
    const std::size_t vertices = points_are_vertices_ ? points_.size() : 0;
    const auto number = [](std::size_t k) { return std::array{static_cast<std::int32_t>(k)}; };
    const auto end_of_line = [&](Index k) { return number(2 * (k + std::size_t{1})); };
    const auto end_of_vertex = [&](Index k) { return number(k + std::size_t{1}); };
    const auto end_of_polygon = [&](Index k) { return polygon_ends_[k]; };
    return detail::vtk_file(
        "PolyData",
        "<PolyData>\n<FieldData>\n<DataArray" + xml("type", "Float64") + xml("Name", "TimeValue") +
            xml("NumberOfTuples", 1) + xml("format", "ascii") + ">" + detail::time_text(time_) +
            "</DataArray>\n</FieldData>\n<Piece" + xml("NumberOfPoints", points_.size()) +
            xml("NumberOfVerts", vertices) + xml("NumberOfLines", lines()) +
            xml("NumberOfStrips", 0) + xml("NumberOfPolys", polygon_ends_.size()) +
            ">\n<PointData>\n" + point_data_ + "</PointData>\n<CellData>\n" + cell_data_ +
            "</CellData>\n<Points>\n" + detail::data_array("Points", points_) +
            "</Points>\n<Verts>\n" + array("connectivity", vertices, number) +
            array("offsets", vertices, end_of_vertex) + "</Verts>\n<Lines>\n" +
            detail::data_array("connectivity", line_ends_) +
            array("offsets", lines(), end_of_line) + "</Lines>\n<Polys>\n" +
            detail::data_array("connectivity", corners_) +
            array("offsets", polygon_ends_.size(), end_of_polygon) +
            "</Polys>\n</Piece>\n</PolyData>\n");
  }

 private:
  std::size_t lines() const { return line_ends_.size() / 2; }

  template <class Row>
  static std::string array(std::string_view name, std::size_t size, Row&& row) {
    std::vector<std::decay_t<decltype(row(Index{}))>> rows;
    rows.reserve(size);
    for (Index k = 0; k < size; ++k) rows.push_back(row(k));
    return detail::data_array(name, rows);
  }

  double time_;
  bool points_are_vertices_ = false;
  std::vector<std::array<float, 3>> points_;
  std::vector<std::array<std::int32_t, 1>> line_ends_, corners_;
  std::vector<std::array<std::int32_t, 1>> polygon_ends_;  // in `corners_`
  std::string point_data_, cell_data_;
};

/// A file and the time that it shows.
struct TimedFile {
  double time;       ///< s
  std::string name;  ///< relative to the folder of the list
};

/// ParaView's list of files over time, as a whole file.
inline std::string paraview_collection(std::span<const TimedFile> files) {
  std::string list;
  for (const auto& [time, name] : files)
    list += "<DataSet" + detail::xml("timestep", detail::time_text(time)) + detail::xml("part", 0) +
            detail::xml("file", name) + "/>\n";
  return detail::vtk_file("Collection", "<Collection>\n" + list + "</Collection>\n");
}

}  // namespace hfdem::observe
