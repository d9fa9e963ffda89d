// The builder of reports: what it is given is escaped, and what would break a page is refused.
#include <cmath>

#include <hfdem/observe/chart.hpp>
#include <hfdem/observe/report.hpp>

#include <doctest/doctest.h>

using namespace hfdem;
using namespace hfdem::observe;

namespace {

bool contains(const std::string& page, const std::string& words) {
  return page.find(words) != std::string::npos;
}

}  // namespace

TEST_CASE("whatever a report is given is escaped, wherever it goes") {
  const std::string hostile = "</p><script>&amp;\"'";
  Report page{.title = hostile, .lead = hostile, .program = hostile, .stopped = hostile};
  page.text(hostile);
  page.numbers({{hostile, hostile, hostile}});
  page.figure(Figure{hostile, hostile, "<svg></svg>"});
  page.section(hostile);
  page.table({hostile, {hostile, hostile}, {{hostile, hostile}}});
  page.facts({{hostile, hostile}, {hostile, hostile, true}});
  page.parameters({{hostile, hostile, hostile, hostile, hostile, hostile}});
  page.files({{hostile, hostile}});
  const std::string html = page.html();
  CHECK(!contains(html, "<script"));
  CHECK(!contains(html, "script>&amp;\""));
  // header, opening, heading (in the contents too), table, facts, parameter, file (linked)
  std::size_t count = 0;
  const std::string safe = "&lt;/p&gt;&lt;script&gt;&amp;amp;&quot;'";
  for (auto at = html.find(safe); at != std::string::npos; at = html.find(safe, at + 1)) ++count;
  CHECK(count == 5 + 6 + 2 + 6 + 4 + 6 + 3);
}

TEST_CASE("groups become sub- and superscripts, and open ones are closed") {
  Report page{.title = "K_{IC}"};
  page.text("K_{IC} = 1 MPa·m^{1/2}; a_b, c^2, {d}\nand x_{open");
  CHECK(contains(page.html(),
                 "<p>K<sub>IC</sub> = 1 MPa·m<sup>1/2</sup>; a_b, c^2, {d}<br>and "
                 "x<sub>open</sub></p>"));
  CHECK(contains(page.html(), "<title>K_IC</title>"));
}

TEST_CASE("numbers are rounded, have a true minus and a space that does not break") {
  CHECK(fixed(0.7705, 2, "m") == "0.77\u00a0m");
  CHECK(fixed(-36.62, 1, "%") == "\u221236.6\u00a0%");
  CHECK(fixed(-0.0004, 3) == "0.000");
  CHECK(fixed(12, 0) == "12");
  CHECK(fixed(NAN, 3, "m") == "\u2013");
}

TEST_CASE("a picture with ids is refused by its title, for two of one page would clash") {
  Report page;
  CHECK_THROWS_WITH_AS(page.figure(Figure{"Stress", "", "<svg><g id=\"a\"/></svg>"}),
                       doctest::Contains("Stress"), InvalidParameter);
  CHECK_THROWS_AS(page.figure(Figure{"", "", "<svg></svg>", "<svg id=\"a\"></svg>"}),
                  InvalidParameter);
}

TEST_CASE("a chart comes in its two widths, with its words in the page") {
  Report page;
  page.figure(Chart{.title = "Length",
                    .caption = "It grows.",
                    .conditions = "Of 100 discs.",
                    .series = {{.name = "hfdem", .x = {0, 1}, .y = {0, 1}}}});
  const std::string html = page.html();
  CHECK(contains(html, "<div class=\"picture wide\"><svg role=\"img\" aria-label=\"Length\""));
  CHECK(contains(html, "<div class=\"picture phone\"><svg role=\"img\" aria-label=\"Length\""));
  CHECK(contains(html, "<figcaption><b>Length.</b> It grows.</figcaption>"));
  CHECK(!contains(html, "Of 100 discs."));  // a page says once what all its figures share
}

TEST_CASE("sections are linked from the contents in their order") {
  Report page;
  page.section("Growth");
  page.section("Files");
  const std::string html = page.html();
  const auto at = [&](const char* words) { return html.find(words); };
  CHECK(at("<a href=\"#section-1\">Growth</a>") < at("<a href=\"#section-2\">Files</a>"));
  CHECK(at("<a href=\"#section-2\">Files</a>") < at("<h2 id=\"section-1\">Growth</h2>"));
  CHECK(at("<h2 id=\"section-1\">Growth</h2>") < at("<h2 id=\"section-2\">Files</h2>"));
}

TEST_CASE("words keep their contrast, however light the colour of their line") {
  const auto linear = [](double part) {
    part /= 255;
    return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
  };
  const auto luminance = [&](Colour c) {
    return 0.2126 * linear(c.red) + 0.7152 * linear(c.green) + 0.0722 * linear(c.blue);
  };
  for (const Colour c : palette) CHECK(1.05 / (luminance(drawing::readable(c)) + 0.05) >= 4.5);
  for (const auto& [light, dark] : drawing::counterparts)
    if (drawing::hex(light) != "#ffffff" && drawing::hex(light) != "#e2e2e2")
      CHECK((luminance(dark) + 0.05) / (luminance(drawing::night) + 0.05) >= 4.5);
}
