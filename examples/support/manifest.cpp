#include "support/manifest.hpp"

#include <ctime>
#include <string_view>

#include <hfdem/base/version.hpp>

namespace hfdem::support {
namespace {

std::string compiler() {
#if defined(__clang__)
  return __VERSION__;  // begins with the name
#elif defined(__GNUC__)
  return "GCC " __VERSION__;
#else
  return "unknown";
#endif
}

/// `word` as a POSIX shell reads it back.
std::string quoted(std::string_view word) {
  constexpr std::string_view plain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-+=.,:/@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string_view::npos)
    return std::string(word);
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? "'\\''" : std::string(1, c);
  return out + "'";
}

std::string command_line(int argc, const char* const* argv) {
  std::string line;
  for (int k = 0; k < argc; ++k) line.append(k == 0 ? "" : " ").append(quoted(argv[k]));
  return line;
}

std::string now() {
  const std::time_t seconds = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%d %H:%M:%S UTC", &utc);
  return text;
}

}  // namespace

Manifest manifest(const std::string& program, int argc, const char* const* argv, int threads,
                  const std::string& seed) {
  return {program,
          std::string(version),
          compiler(),
          HFDEM_COMPILE_FLAGS,
          HFDEM_BUILD_TYPE,
          command_line(argc, argv),
          seed,
          threads,
          now()};
}

}  // namespace hfdem::support
