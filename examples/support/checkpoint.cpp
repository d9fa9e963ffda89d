#include "support/checkpoint.hpp"

#include <fstream>
#include <iterator>
#include <sstream>
#include <system_error>

namespace hfdem::support {
namespace {

/// The lines of a parameter file as `section.key = value`, without units and meanings.
std::vector<std::string> assignments(const std::string& config) {
  std::vector<std::string> all;
  std::istringstream lines(config);
  for (std::string line, section; std::getline(lines, line);) {
    line.erase(std::min(line.size(), line.find('#')));
    line.erase(line.find_last_not_of(' ') + 1);
    if (line.empty()) continue;
    if (line.front() == '[')
      section = line.substr(1, line.size() - 2);
    else
      all.push_back(section + "." + line);
  }
  return all;
}

/// What of `some` is not among `others`, as a list in words.
std::string missing(const std::vector<std::string>& some, const std::vector<std::string>& others) {
  std::string words;
  for (const std::string& one : some)
    if (std::find(others.begin(), others.end(), one) == others.end())
      words += (words.empty() ? "" : ", ") + one;
  return words.empty() ? "nothing else" : words;
}

}  // namespace

Checkpoint::Checkpoint(const CommandLine& options, const Manifest& manifest,
                       const std::string& config)
    : path_(checkpoint_file(options.out)),
      manifest_(manifest),
      config_(config),
      interval_(options.checkpoint) {
  note_interrupts();
  if (!options.resume.empty()) {
    take_up();
  } else if (options.overwrite) {
    discard();
  } else if (std::filesystem::exists(path_)) {
    throw InvalidParameter(options.out + " holds an unfinished run: go on with it by --resume " +
                           options.out + ", or give it up by --overwrite");
  }
}

void Checkpoint::take_up() {
  std::ifstream in(path_, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (!in) throw InvalidParameter("cannot read " + path_.string());
  saved_.emplace(std::move(bytes), path_.string());
  Manifest begun = manifest_;
  std::string config;
  saved()(begun.program, begun.version, config, begun.command_line, begun.date);
  if (begun.program != manifest_.program)
    saved().wrong("was made by the program " + begun.program + ", not by " + manifest_.program);
  if (begun.version != manifest_.version)
    saved().wrong("was made by hfdem " + begun.version + ", and this is " + manifest_.version);
  if (config != config_) {
    const auto then = assignments(config), now = assignments(config_);
    saved().wrong("belongs to other parameters: there " + missing(then, now) + ", in config.toml " +
                  missing(now, then));
  }
  manifest_ = begun;
}

void Checkpoint::interrupt(const std::string& where, const std::string& options) const {
  throw Interrupted("interrupted " + where + "; go on with --resume " +
                    path_.parent_path().string() + options);
}

void Checkpoint::discard() const {
  std::error_code ignored;
  for (const char* end : {"", ".part"}) std::filesystem::remove(path_.string() + end, ignored);
}

}  // namespace hfdem::support
