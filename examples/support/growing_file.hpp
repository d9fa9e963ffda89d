/// @file
/// A file that a run adds to, row after row.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

#include <hfdem/base/errors.hpp>

#include "support/output_folder.hpp"

namespace hfdem::support {

/// Part of a checkpoint: a run that is resumed goes on behind what the file held then, whatever was
/// added later.
class GrowingFile {
 public:
  /// @param resumes whether the run does: the file then takes nothing until it is cut back
  /// @throws OutputFailed if the file cannot be opened
  GrowingFile(const OutputFolder& folder, const std::string& name, bool resumes)
      : path_(folder.path() / name) {
    if (!resumes) open(std::ios::out);
  }

  std::ostream& out() { return file_; }

  /// @throws OutputFailed if anything written to the file was lost
  void close() {
    file_.close();
    check();
  }

  /// Its length; saving it takes care that all of it is in the file.
  template <class Archive>
  void exchange(Archive& archive) {
    std::uintmax_t length = 0;
    if constexpr (!Archive::loads) length = flushed_length();
    archive(length);
    if constexpr (Archive::loads) cut_back(length);
  }

 private:
  void open(std::ios::openmode mode) {
    file_.clear();
    file_.open(path_, mode);
    if (!file_) throw OutputFailed("cannot write " + path_.string());
  }

  void check() const {
    if (!file_) throw OutputFailed("could not write all of " + path_.string());
  }

  std::uintmax_t flushed_length() {
    file_.flush();
    check();
    return static_cast<std::uintmax_t>(file_.tellp());
  }

  void cut_back(std::uintmax_t length) {
    std::error_code missing;
    const std::uintmax_t size = std::filesystem::file_size(path_, missing);
    const std::uintmax_t held = missing ? 0 : size;
    if (held < length)
      throw InvalidParameter(path_.string() + " holds " + std::to_string(held) +
                             " bytes, and held " + std::to_string(length) +
                             " at the checkpoint: it was changed since");
    std::filesystem::resize_file(path_, length);
    open(std::ios::in | std::ios::out | std::ios::ate);
  }

  std::filesystem::path path_;
  std::ofstream file_;
};

}  // namespace hfdem::support
