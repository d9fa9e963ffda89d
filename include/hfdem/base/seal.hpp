/// @file
/// Bytes that say what they are and whether they are all there.
///
/// A *sealed* state is the line `hfdem state 1` with the version of the format, the length of the
/// content, the content, and a checksum of all this: the 64-bit FNV-1a hash (G. Fowler, L. C. Noll,
/// P. Vo), which no single wrong byte leaves unchanged.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include <hfdem/base/errors.hpp>

namespace hfdem {

namespace detail {

inline constexpr std::string_view seal_title = "hfdem state ", seal_version = "1\n";

inline std::uint64_t checksum(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash;
}

inline void append(std::string& bytes, std::uint64_t number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

inline std::uint64_t number_at(const char* place) {
  std::uint64_t number = 0;
  std::memcpy(&number, place, sizeof number);
  return number;
}

}  // namespace detail

/// The content between its title and its checksum.
inline std::string seal(std::string_view content) {
  std::string all = std::string(detail::seal_title).append(detail::seal_version);
  detail::append(all, content.size());
  all += content;
  detail::append(all, detail::checksum(all));
  return all;
}

/// The content of what `seal` gave, a view of it.
/// @param sealed all of it
/// @param name of where it comes from, for messages
/// @throws InvalidParameter if it is no sealed state, or damaged
inline std::string_view unseal(std::string_view sealed, const std::string& name) {
  const auto refuse = [&](const std::string& why) { throw InvalidParameter(name + " is " + why); };
  constexpr std::string_view title = detail::seal_title, version = detail::seal_version;
  constexpr std::size_t number = sizeof(std::uint64_t);
  if (!sealed.starts_with(title))
    refuse("no saved state: it does not begin with \"" + std::string(title) + "\"");
  if (!sealed.substr(title.size()).starts_with(version))
    refuse("of another version of the format than the only one known, " +
           std::string(version.substr(0, version.size() - 1)));
  const std::size_t begin = title.size() + version.size() + number;
  if (sealed.size() < begin + number) refuse("cut off at byte " + std::to_string(sealed.size()));
  const std::size_t size = sealed.size() - begin - number;
  if (const auto said = detail::number_at(&sealed[begin - number]); said != size)
    refuse("cut off or damaged: it has " + std::to_string(size) +
           " bytes of content where it says " + std::to_string(said));
  if (detail::number_at(&sealed[begin + size]) != detail::checksum(sealed.substr(0, begin + size)))
    refuse("damaged: its checksum is not that of its " + std::to_string(size) + " bytes");
  return sealed.substr(begin, size);
}

}  // namespace hfdem
