// When the observer writes, and how it refuses. What stands in the files is checked by
// tests/programs/paraview_test.py.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <unistd.h>

#include <hfdem/observe/paraview.hpp>

#include <doctest/doctest.h>

#include "schemes/small_array.hpp"

namespace {

namespace fs = std::filesystem;
using hfdem::observe::ParaView;

/// A folder that is gone after the test.
struct Scratch {
  fs::path path = fs::temp_directory_path() / ("hfdem_paraview_" + std::to_string(::getpid()));
  Scratch() { fs::remove_all(path); }
  ~Scratch() { fs::remove_all(path); }
};

std::string content(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  REQUIRE(in);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The times that a list names, as they stand there.
std::string times(const fs::path& list) {
  std::string found;
  const std::string text = content(list), key = "timestep=\"";
  for (std::size_t at = text.find(key); at != std::string::npos; at = text.find(key, at + 1)) {
    const std::size_t begin = at + key.size();
    found += text.substr(begin, text.find('"', begin) - begin) + " ";
  }
  return found;
}

/// A clock in front of a simulator: what the observer sees of time.
struct AtTime : test::Injected {
  using test::Injected::Injected;
  double now = 0;
  double time() const { return now; }
};

}  // namespace

TEST_CASE("a step is written at the first fluid step at or after each multiple of the interval") {
  const Scratch folder;
  AtTime sim(test::square(4), {.crack = {.contacts = 2}});
  ParaView out(folder.path / "deep" / "down", 0.01);
  const auto list = [&] { return times(folder.path / "deep" / "down" / "cracks.pvd"); };
  out.write(sim);
  CHECK(list() == "0 ");
  for (const double t : {0.004, 0.008, 0.012, 0.016, 0.02, 0.024, 0.047, 0.049, 0.051}) {
    sim.now = t;
    out.fluid_step(sim, {});
  }
  CHECK(list() == "0 0.012 0.02 0.047 0.051 ");
  sim.now = 0.055;
  out.write(sim);
  out.write(sim);  // the same instant again
  CHECK(list() == "0 0.012 0.02 0.047 0.051 0.055 ");
  for (const char* what : {"particles", "contacts", "cracks"}) {
    const fs::path base = folder.path / "deep" / "down";
    CHECK(content(base / (std::string(what) + "_0005.vtp")).ends_with("</VTKFile>\n"));
    CHECK_FALSE(fs::exists(base / (std::string(what) + "_0006.vtp")));
  }
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(folder.path / "deep" / "down")) {
    CHECK(entry.path().extension() != ".part");
    ++files;
  }
  CHECK(files == 3 + 3 * 6);
}

TEST_CASE("a run without a first state writes its first fluid step") {
  const Scratch folder;
  AtTime sim(test::square(4), {.crack = {.contacts = 2}});
  ParaView out(folder.path, 0.01);
  sim.now = 0.0025;
  out.fluid_step(sim, {});
  CHECK(times(folder.path / "particles.pvd") == "0.0025 ");
}

TEST_CASE("the same run writes the same bytes") {
  const Scratch folder;
  const test::Injected one(test::square(4), {.crack = {.contacts = 2}}),
      other(test::square(4), {.crack = {.contacts = 2}});
  ParaView(folder.path / "one", 1).write(one);
  ParaView(folder.path / "other", 1).write(other);
  for (const auto& entry : fs::directory_iterator(folder.path / "one"))
    CHECK(content(entry.path()) == content(folder.path / "other" / entry.path().filename()));
}

TEST_CASE("a file changes as a whole: until its new content is complete, the old one stands") {
  const Scratch folder;
  const fs::path file = folder.path / "file";
  hfdem::make_folder(folder.path);
  hfdem::write_whole_file(file, "old");
  fs::create_directory(folder.path / "file.part");
  CHECK_THROWS_AS(hfdem::write_whole_file(file, "new"), hfdem::WriteFailed);
  CHECK(content(file) == "old");
  fs::remove(folder.path / "file.part");
  hfdem::write_whole_file(file, "new");
  CHECK(content(file) == "new");
}

TEST_CASE("what cannot be written is said, and what stood there stays") {
  const Scratch folder;
  const test::Injected sim(test::square(4), {.crack = {.contacts = 2}});
  fs::create_directories(folder.path);
  std::ofstream(folder.path / "file") << "in the way";
  const std::string in_the_way = (folder.path / "file").string();
  CHECK_THROWS_WITH_AS(ParaView(in_the_way, 1), doctest::Contains(in_the_way.c_str()),
                       hfdem::WriteFailed);
  CHECK_THROWS_AS(ParaView(folder.path / "file" / "out", 1), hfdem::WriteFailed);
  CHECK(content(folder.path / "file") == "in the way");

  ParaView out(folder.path, 1);
  fs::create_directories(folder.path / "contacts_0000.vtp" / "folder in the way");
  CHECK_THROWS_WITH_AS(out.write(sim), doctest::Contains("contacts_0000.vtp"), hfdem::WriteFailed);
  CHECK_THROWS_WITH_AS(ParaView(folder.path, 0),
                       "paraview.interval = 0 s is not allowed: it must be greater than 0 s",
                       hfdem::InvalidParameter);
  CHECK_THROWS_AS(ParaView(folder.path, NAN), hfdem::InvalidParameter);
}
