/// @file
/// The checkpoint of a run: a file in its folder that holds everything that evolves, so that the
/// run can go on after an interrupt or a crash as if nothing had happened.
///
///     Checkpoint checkpoint(options, manifest, to_toml(config));
///     if (checkpoint.resumes()) checkpoint.load(parts...);
///     ...
///     if (checkpoint.is_due()) checkpoint.save(parts...);
///     if (interrupted()) checkpoint.interrupt("at t = 0.1 s");
///     ...
///     checkpoint.discard();  // when all results are written
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <hfdem/base/archive.hpp>
#include <hfdem/base/whole_file.hpp>

#include "support/command_line.hpp"
#include "support/interrupts.hpp"
#include "support/manifest.hpp"
#include "support/progress.hpp"

namespace hfdem::support {

class Checkpoint {
 public:
  /// Notes interrupts from here on.
  /// @param config the parameter file: a run goes on with its own parameters only
  /// @throws InvalidParameter if the run's folder holds an unfinished run that is not to be
  /// resumed,
  ///   or if the one to resume is damaged or of another program, version or parameters
  Checkpoint(const CommandLine& options, const Manifest& manifest, const std::string& config);

  bool resumes() const { return saved_.has_value(); }

  /// Where the whole run comes from: command and date are those of its beginning.
  const Manifest& manifest() const { return manifest_; }

  /// The next of what was saved. @throws InvalidParameter if it does not fit
  Loader& saved() { return *saved_; }
  /// The last of what was saved. @throws InvalidParameter if it does not fit
  template <class... Parts>
  void load(Parts&... parts) {
    (*saved_)(parts...);
    saved_->finish();
  }

  /// Whether the time between two saves is over.
  bool is_due() const { return since_save_.seconds() >= interval_; }
  /// Replaces the file; until the new one is whole, the old one stands.
  /// @throws OutputFailed if it cannot be written
  template <class... Parts>
  void save(const Parts&... parts) {
    Saver saver;
    saver(manifest_.program, manifest_.version, config_, manifest_.command_line, manifest_.date,
          parts...);
    write_whole_file(path_, saver.sealed());
    since_save_ = Stopwatch();
  }

  /// Ends the program, once it has saved.
  /// @param where the run is, for the message
  /// @param options that must be given again, beside --resume
  [[noreturn]] void interrupt(const std::string& where, const std::string& options = "") const;

  /// The run is complete.
  void discard() const;

 private:
  void take_up();

  std::filesystem::path path_;
  Manifest manifest_;
  std::string config_;
  double interval_;
  Stopwatch since_save_;
  std::optional<Loader> saved_;
};

}  // namespace hfdem::support
