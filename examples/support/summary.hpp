/// @file
/// summary.json: the answer of a run in numbers.
#pragma once

#include <memory>
#include <string>

namespace hfdem::support {

/// An ordered list of named values, possibly nested, printed as JSON. Numbers are printed with
/// twelve significant digits.
class Summary {
 public:
  Summary();
  ~Summary();
  Summary(Summary&&) noexcept;
  Summary& operator=(Summary&&) noexcept;

  /// Sets one value; `path` separates levels by '/'. A number that is not finite becomes null.
  void set(const std::string& path, double value);
  void set(const std::string& path, long value);
  void set(const std::string& path, bool value);
  void set(const std::string& path, const std::string& value);
  void set(const std::string& path, const char* value) { set(path, std::string(value)); }
  void set(const std::string& path, int value) { set(path, long{value}); }

  /// Our value beside a reference, with the relative difference, under `path`.
  void compare(const std::string& path, double ours, double reference);

  std::string json() const;

 private:
  struct Document;
  std::unique_ptr<Document> document_;
};

}  // namespace hfdem::support
