/// @file
/// One self-contained HTML page: what a user opens first after a run. No network and no script; its
/// pictures are part of it. A program adds plain data, section by section:
///
///   Report page{.title = "A crack of 0.8 m", .lead = "What was run, in a sentence."};
///   page.numbers({{"crack length", "0.800 m", "paper 0.770 m"}});
///   page.figure(specimen_picture);
///   page.section("Comparison");
///   page.table({.header = {"", "hfdem", "paper"}, .rows = {{"length", "0.800 m", "0.770 m"}}});
///   file << page.html();
///
/// Words may hold groups like `K_{IC}` and `10^{-6}`. Whatever it is given is escaped.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <hfdem/base/errors.hpp>
#include <hfdem/observe/html.hpp>
#include <hfdem/observe/report_style.hpp>

namespace hfdem::observe {

/// One number of the answer; below it stands what it is to be compared with, line by line.
struct KeyNumber {
  std::string name, value;  ///< what it is; how much, with its unit
  std::string beside{};     ///< lines of words
};

/// An SVG without ids, so that pictures cannot clash; `phone` is shown instead on narrow screens.
struct Figure {
  std::string title, caption, svg;  ///< the picture and the words below it
  std::string phone{};              ///< empty: `svg` on every screen
};

/// Rows of words; the first column names the row.
struct Table {
  std::string caption{};                         ///< above it
  std::vector<std::string> header{};             ///< names of the columns
  std::vector<std::vector<std::string>> rows{};  ///< as wide as the header
};

/// What is known under a name, such as the version.
struct Fact {
  std::string name, value;  ///< what it is; what it is like
  bool code = false;        ///< to be shown letter by letter
};

/// A parameter of the run.
struct Parameter {
  std::string section, name, value, unit, meaning;  ///< as in a run file and the table of fields
  std::string usual{};  ///< the default with its unit, where the value differs from it
};

/// A file beside the report.
struct File {
  std::string name, meaning;  ///< relative to the page; what it holds
};

/// A page in the making. What is added before the first `section` is its opening: the answer.
struct Report {
  std::string title{}, lead{};  ///< the heading, and the sentence below it
  std::string program{};        ///< what wrote it, above the title
  std::string stopped{};        ///< why the run ended early; empty if it did not

  /// A part of the page under its heading.
  struct Section {
    std::string heading, content;  ///< words; HTML
  };
  std::vector<Section> sections = std::vector<Section>(1);  ///< the opening first

  /// Begins a section; what follows belongs to it.
  void section(const std::string& heading) { sections.push_back({heading, ""}); }

  /// A paragraph.
  void text(std::string_view words) { add("<p>" + drawing::html_words(words) + "</p>\n"); }

  /// Large, beside each other.
  void numbers(const std::vector<KeyNumber>& numbers) {
    std::string out = "<dl class=\"numbers\">\n";
    for (const KeyNumber& n : numbers)
      out +=
          "<div><dt>" + drawing::html_words(n.name) + "</dt><dd class=\"value\">" +
          drawing::html_words(n.value) + "</dd>" +
          (n.beside.empty() ? ""
                            : "<dd class=\"beside\">" + drawing::html_words(n.beside) + "</dd>") +
          "</div>\n";
    add(out + "</dl>\n");
  }

  /// @throws InvalidParameter if the picture has ids
  void figure(const Figure& f) {
    for (const std::string* svg : {&f.svg, &f.phone})
      if (svg->find(" id=") != std::string::npos)
        throw InvalidParameter("the figure \"" + f.title + "\" of a report has ids: pictures of " +
                               "one page must have none");
    std::string out = "<figure>\n";
    if (f.phone.empty())
      out += "<div class=\"picture\">" + f.svg + "</div>\n";
    else
      out += "<div class=\"picture wide\">" + f.svg + "</div>\n<div class=\"picture phone\">" +
             f.phone + "</div>\n";
    add(out + "<figcaption><b>" + drawing::html_words(f.title) + ".</b> " +
        drawing::html_words(f.caption) + "</figcaption>\n</figure>\n");
  }

  /// A chart or any other picture that knows its title, its caption and its media.
  template <class Picture>
  void figure(const Picture& p) {
    figure(Figure{p.title, caption(p), svg(p, Medium::page), svg(p, Medium::phone)});
  }

  /// A table, under its caption.
  void table(const Table& t) {
    std::string out = "<table>\n";
    if (!t.caption.empty()) out += "<caption>" + drawing::html_words(t.caption) + "</caption>\n";
    out += head(t.header) + "<tbody>\n";
    for (const auto& row : t.rows) {
      out += "<tr>";
      for (std::size_t k = 0; k < row.size(); ++k)
        out += (k == 0 ? "<th scope=\"row\">" : "<td>") + drawing::html_words(row[k]) +
               (k == 0 ? "</th>" : "</td>");
      out += "</tr>\n";
    }
    add_scrolling(t.caption.empty() ? sections.back().heading : t.caption,
                  out + "</tbody>\n</table>\n");
  }

  /// A list of names and values.
  void facts(const std::vector<Fact>& facts) {
    std::string out = "<dl class=\"facts\">\n";
    for (const Fact& f : facts)
      out += "<dt>" + drawing::html_words(f.name) + "</dt><dd>" +
             (f.code ? "<code>" + drawing::escaped(f.value) + "</code>"
                     : drawing::html_words(f.value)) +
             "</dd>\n";
    add(out + "</dl>\n");
  }

  /// In the order of their sections; those that are not at their default say so.
  void parameters(const std::vector<Parameter>& parameters) {
    std::string out =
        "<table class=\"parameters\">\n" + head({"parameter", "value", "unit", "meaning"});
    std::string section;
    for (const Parameter& p : parameters) {
      if (p.section != section)
        out += (section.empty() ? "<tbody>\n" : "</tbody>\n<tbody>\n") +
               ("<tr class=\"group\"><th colspan=\"4\" scope=\"rowgroup\">" +
                drawing::escaped(p.section)) +
               "</th></tr>\n";
      section = p.section;
      out += (p.usual.empty() ? "<tr>" : "<tr class=\"changed\">") +
             ("<th scope=\"row\"><code>" + drawing::escaped(p.name)) + "</code></th><td>" +
             drawing::html_words(p.value) +
             (p.usual.empty() ? ""
                              : " <span class=\"default\">default " + drawing::html_words(p.usual) +
                                    "</span>") +
             "</td><td>" + drawing::html_words(p.unit) + "</td><td>" +
             drawing::html_words(p.meaning) + "</td></tr>\n";
    }
    add_scrolling("parameters", out + (section.empty() ? "" : "</tbody>\n") + "</table>\n");
  }

  /// A list of links.
  void files(const std::vector<File>& files) {
    std::string out = "<dl class=\"facts\">\n";
    for (const File& f : files)
      out += "<dt><a href=\"" + drawing::escaped(f.name) + "\">" + drawing::escaped(f.name) +
             "</a></dt><dd>" + drawing::html_words(f.meaning) + "</dd>\n";
    add(out + "</dl>\n");
  }

  /// The page.
  std::string html() const {
    std::string out =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<meta name=\"color-scheme\" content=\"light dark\">\n<title>" +
        drawing::plain(title) + "</title>\n<style>" + drawing::report_style() +
        "</style>\n</head>\n<body>\n<main>\n<header>\n<p class=\"program\">" +
        drawing::html_words(program) + "</p>\n<h1>" + drawing::html_words(title) + "</h1>\n";
    if (!stopped.empty())
      out += "<p class=\"stopped\" role=\"alert\"><strong>This run stopped early.</strong> " +
             drawing::html_words(stopped) + "</p>\n";
    out += "<p class=\"lead\">" + drawing::html_words(lead) + "</p>\n</header>\n<section>\n" +
           sections.front().content + "</section>\n";
    if (sections.size() > 1) out += contents();
    for (std::size_t k = 1; k < sections.size(); ++k)
      out += "<section aria-labelledby=\"" + id(k) + "\">\n<h2 id=\"" + id(k) + "\">" +
             drawing::html_words(sections[k].heading) + "</h2>\n" + sections[k].content +
             "</section>\n";
    return out + "</main>\n</body>\n</html>\n";
  }

 private:
  void add(std::string_view content) { sections.back().content += content; }

  /// A table that is too wide for the screen scrolls by itself, by keyboard too.
  void add_scrolling(std::string_view name, std::string_view table) {
    add("<div class=\"table\" role=\"region\" tabindex=\"0\" aria-label=\"" + drawing::plain(name) +
        "\">\n" + std::string(table) + "</div>\n");
  }

  static std::string head(const std::vector<std::string>& names) {
    std::string out = "<thead>\n<tr>";
    for (const std::string& name : names)
      out +=
          name.empty() ? "<td></td>" : "<th scope=\"col\">" + drawing::html_words(name) + "</th>";
    return out + "</tr>\n</thead>\n";
  }

  static std::string id(std::size_t section) { return "section-" + std::to_string(section); }

  std::string contents() const {
    std::string out = "<nav aria-label=\"Contents\">\n<ul>\n";
    for (std::size_t k = 1; k < sections.size(); ++k)
      out += "<li><a href=\"#" + id(k) + "\">" + drawing::html_words(sections[k].heading) +
             "</a></li>\n";
    return out + "</ul>\n</nav>\n";
  }
};

}  // namespace hfdem::observe
