// The bytes of VTK's files; that VTK itself reads them is tests/programs/paraview_test.py's matter.
#include <array>
#include <span>
#include <string>

#include <hfdem/observe/vtk_xml.hpp>

#include <doctest/doctest.h>

namespace {

std::string encoded(const std::string& text) {
  return hfdem::observe::base64(std::as_bytes(std::span(text)));
}

}  // namespace

TEST_CASE("base64 is that of RFC 4648, section 10") {
  CHECK(encoded("").empty());
  CHECK(encoded("f") == "Zg==");
  CHECK(encoded("fo") == "Zm8=");
  CHECK(encoded("foo") == "Zm9v");
  CHECK(encoded("foob") == "Zm9vYg==");
  CHECK(encoded("fooba") == "Zm9vYmE=");
  CHECK(encoded("foobar") == "Zm9vYmFy");
  CHECK(encoded("\xff\xfe\xfb\xef\xbf\x80") == "//7777+A");
}
