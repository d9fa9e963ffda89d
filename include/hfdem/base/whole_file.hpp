/// @file
/// Files that are there as a whole or not at all, however a run ends.
#pragma once

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace hfdem {

/// A file or folder that cannot be written; the message names it.
struct WriteFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// @throws WriteFailed if the folder does not exist and cannot be made
inline void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder))
    throw WriteFailed("cannot make the folder " + folder.string() + ": " +
                      (error ? error.message() : "a file of this name exists"));
}

/// Writes beside the file and renames: until the new content is complete, the old one stands.
/// @throws WriteFailed if that does not succeed
inline void write_whole_file(const std::filesystem::path& file, std::string_view content) {
  std::filesystem::path unfinished = file;
  unfinished += ".part";
  std::ofstream out(unfinished, std::ios::binary);
  out.write(content.data(), static_cast<std::streamsize>(content.size()));
  out.close();
  std::error_code error;
  if (out) std::filesystem::rename(unfinished, file, error);
  if (!out || error) throw WriteFailed("cannot write all of " + file.string());
}

}  // namespace hfdem
