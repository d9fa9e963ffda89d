/// @file
/// The folder that a run writes into.
#pragma once

#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

#include <hfdem/base/whole_file.hpp>

namespace hfdem::support {

using OutputFailed = WriteFailed;

class OutputFolder {
 public:
  /// @throws OutputFailed if the folder cannot be made
  explicit OutputFolder(const std::string& path) : path_(path) { make_folder(path_); }

  const std::filesystem::path& path() const { return path_; }

  /// @throws OutputFailed if the file cannot be opened
  std::ofstream open(const std::string& name) const {
    std::ofstream file(path_ / name);
    if (!file) throw OutputFailed("cannot write " + (path_ / name).string());
    return file;
  }

  /// Writes a whole file. @throws OutputFailed if that does not succeed
  void write(const std::string& name, const std::string& content) const {
    write_whole_file(path_ / name, content);
  }

  /// Removes what an earlier run left and this one writes at its end: if it does not come to that,
  /// the old answer must not stand beside the new parameters.
  void discard(std::span<const char* const> names) const {
    std::error_code ignored;
    for (const char* name : names) std::filesystem::remove(path_ / name, ignored);
  }

  void discard(std::initializer_list<const char*> names) const {
    discard(std::span(names.begin(), names.size()));
  }
  void discard(const std::vector<std::string>& names) const {
    for (const std::string& name : names) discard({name.c_str()});
  }

  /// @throws OutputFailed if anything written to the file was lost
  void close(std::ofstream& file, const std::string& name) const {
    file.close();
    if (!file) throw OutputFailed("could not write all of " + (path_ / name).string());
  }

 private:
  std::filesystem::path path_;
};

}  // namespace hfdem::support
