/// @file
/// How a report looks: one column of text, figures as wide as the page, light or dark as the reader
/// has it, on a phone and on paper. In both schemes words have a contrast of at least 4.5 (WCAG).
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include <hfdem/observe/colours.hpp>

namespace hfdem::observe::drawing {

inline constexpr std::string_view report_layout = R"css(
:root { color-scheme: light dark; --paper: #fff; --ink: #222; --muted: #5e5e5e; --rule: #d9d9d9;
  --tint: #f5f3ee; --link: #00629b; --warning: #8a3800; --warning-tint: #fdf0e4;
  --serif: Charter, "Bitstream Charter", "Sitka Text", Cambria, Georgia, serif;
  --sans: system-ui, "Segoe UI", Roboto, Helvetica, Arial, sans-serif; }
* { box-sizing: border-box; }
html { -webkit-text-size-adjust: 100%; text-size-adjust: 100%; }
body { margin: 0; padding: 3rem 1.25rem 5rem; background: var(--paper); color: var(--ink);
  font: 1.0625rem/1.6 var(--serif); overflow-wrap: break-word; }
main > *, section > * { max-width: 42rem; margin-inline: auto; }
main > section, main > section > figure { max-width: 66rem; }
h1, h2 { font-weight: 600; line-height: 1.2; text-wrap: balance; }
h1 { margin: 0.3rem 0 0.8rem; font-size: clamp(1.875rem, 1.3rem + 2.4vw, 2.75rem);
  font-weight: 400; letter-spacing: -0.015em; }
h2 { margin-block: 4rem 1rem; padding-top: 0.9rem; border-top: 1px solid var(--rule);
  font-size: 1.4rem; }
p { margin-block: 0 1rem; }
a { color: var(--link); text-underline-offset: 0.15em; text-decoration-thickness: 1px; }
sub, sup { line-height: 0; font-size: 0.75em; }
code { font: 0.875em/1.5 ui-monospace, "SF Mono", Menlo, Consolas, monospace;
  overflow-wrap: anywhere; }
.program { margin: 0; color: var(--muted); font: 0.875rem/1.4 var(--sans); }
.lead { font-size: 1.1875rem; line-height: 1.5; color: var(--muted); }
.stopped { margin-block: 1.5rem; padding: 0.9rem 1.1rem; border-left: 4px solid var(--warning);
  background: var(--warning-tint); color: var(--warning); font-family: var(--sans);
  font-size: 1rem; line-height: 1.5; }
.stopped strong { display: block; }
nav { margin-block: 2.5rem 0; padding-block: 0.7rem; border-block: 1px solid var(--rule);
  font: 0.9375rem/1.5 var(--sans); }
nav ul { display: flex; flex-wrap: wrap; gap: 0.2rem 1.4rem; margin: 0; padding: 0;
  list-style: none; }
nav a { text-decoration: none; }
nav a:hover { text-decoration: underline; }
nav + section > h2 { margin-top: 3rem; padding-top: 0; border-top: 0; }

.numbers { display: grid; grid-template-columns: repeat(auto-fit, minmax(8.5rem, 1fr));
  gap: 1.25rem 1.5rem; margin-block: 2rem 2.5rem; font-family: var(--sans); }
.numbers dt, .numbers .beside { color: var(--muted); font-size: 0.875rem; line-height: 1.45; }
.numbers > div { display: grid; grid-row: span 3; grid-template-rows: subgrid; row-gap: 0; }
.numbers dt { align-self: end; }
.numbers dd { margin: 0; }
.numbers .value { font-size: 1.75rem; line-height: 1.35; letter-spacing: -0.01em;
  white-space: nowrap; }
.numbers, table, .facts { font-variant-numeric: tabular-nums lining-nums; }

figure { margin-block: 2.5rem; }
figure svg { max-width: 100%; }
.picture > svg { display: block; width: 100%; height: auto; }
.phone { display: none; max-width: 32rem; margin-inline: auto; }
figcaption { max-width: 42rem; margin: 0.9rem auto 0; color: var(--muted);
  font: 0.9375rem/1.5 var(--sans); }
figcaption b { color: var(--ink); font-weight: 600; }

.table { overflow-x: auto; margin-block: 1.5rem 2rem; }
.table:focus-visible { outline: 2px solid var(--link); outline-offset: 2px; }
table { width: 100%; border-collapse: collapse; font: 0.9375rem/1.45 var(--sans); }
caption { padding-bottom: 0.6rem; color: var(--muted); text-align: left; }
th, td { padding: 0.35rem 0 0.35rem 1.25rem; text-align: right; vertical-align: baseline;
  white-space: nowrap; font-weight: 400; }
th:first-child, td:first-child { padding-left: 0; text-align: left; white-space: normal; }
th:first-child { min-width: 8.5rem; }
thead > tr > * { border-bottom: 1px solid var(--ink); color: var(--muted); font-size: 0.875rem;
  vertical-align: bottom; white-space: normal; }
tbody tr + tr > * { border-top: 1px solid var(--rule); }
.parameters th:last-child, .parameters td:last-child { min-width: 13rem; text-align: left;
  white-space: normal; color: var(--muted); }
.parameters td:nth-child(3), .parameters thead th:nth-child(3) { padding-left: 0.4rem;
  text-align: left; }
.parameters .group th { padding-top: 1.6rem; color: var(--ink); font-weight: 600; }
.parameters tbody tr.group + tr > * { border-top: 1px solid var(--ink); }
.parameters code { font-size: 0.875rem; white-space: nowrap; }
.changed > th, .changed > td { background: var(--tint); }
.changed td:nth-child(2) { font-weight: 600; }
.default { display: block; color: var(--muted); font-size: 0.8125rem; font-weight: 400; }

.facts { display: grid; grid-template-columns: minmax(8rem, max-content) minmax(0, 1fr);
  font: 0.9375rem/1.5 var(--sans); }
.facts dt, .facts dd { margin: 0; padding: 0.35rem 1.25rem 0.35rem 0;
  border-bottom: 1px solid var(--rule); }
.facts dt { color: var(--muted); }

@media screen and (max-width: 48rem) {
  .wide { display: none; }
  .phone { display: block; }
}
@media screen and (max-width: 40rem) {
  body { padding: 1.5rem 1rem 3rem; font-size: 1rem; }
  .lead { font-size: 1.0625rem; }
  .numbers { grid-template-columns: repeat(2, minmax(0, 1fr)); }
  .numbers .value { font-size: 1.5rem; }
  .facts { grid-template-columns: minmax(0, 1fr); }
  .facts dt { padding-bottom: 0; border-bottom: 0; }
  .facts dd { padding-top: 0; }
  h2 { margin-top: 3rem; }
  .parameters thead { display: none; }
  .parameters tr { display: grid; grid-template-columns: minmax(0, 1fr) auto 3.5rem;
    padding-block: 0.35rem; border-top: 1px solid var(--rule); }
  .parameters tr > *, .parameters tbody tr.group + tr > * { padding-block: 0; border: 0; }
  .parameters tr.group + tr { border-top-color: var(--ink); }
  .parameters td:last-child { grid-column: 1 / -1; padding-left: 0; }
  .changed { background: var(--tint); }
}
@media print {
  @page { margin: 18mm 16mm; }
  html { font-size: 9pt; }
  body { padding: 0; }
  nav { display: none; }
  main > *, section > *, figcaption { max-width: none; }
  h2 { margin-top: 2rem; break-after: avoid; }
  figure, tr, .numbers, .stopped { break-inside: avoid; }
  thead { display: table-header-group; }
  .table { overflow: visible; }
  th, td { white-space: normal; }
  a { color: inherit; }
}
)css";

/// Every colour of the figures, where it is one of `light`, becomes its counterpart.
template <std::size_t N>
std::string recoloured(const std::array<Counterpart, N>& pairs, std::string_view where) {
  std::string css;
  for (const auto& [light, dark] : pairs)
    for (const std::string_view paint : {"fill", "stroke"})
      css.append("  svg [")
          .append(paint)
          .append("=\"" + hex(light) + "\"]")
          .append(where)
          .append(" { ")
          .append(paint)
          .append(": " + hex(dark) + "; }\n");
  return css;
}

/// The whole style sheet of a report.
inline std::string report_style() {
  std::array names = counterparts;  // of lines, in the shades that are readable on white
  for (Counterpart& c : names) c.light = readable(c.light);
  return std::string(report_layout) +
         "@media screen and (prefers-color-scheme: dark) {\n"
         "  :root { --paper: " +
         hex(night) +
         "; --ink: #e4e2de; --muted: #a8a8aa; --rule: #3a3e45; --tint: #23262c;\n"
         "    --link: #6cb8ea; --warning: #f4b183; --warning-tint: #35240f; }\n" +
         recoloured(names, ":not(.rock *)") + recoloured(counterparts, ":not(.rock *)") +
         recoloured(rock_counterparts, "") + "}\n";
}

}  // namespace hfdem::observe::drawing
