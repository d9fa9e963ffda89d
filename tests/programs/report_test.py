"""The page report.html of the program kgd, as a browser and a reader meet it.

    python3 tests/programs/report_test.py build/release/examples/kgd
"""

import html.parser
import json
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import unittest

KGD = sys.argv.pop(1)
VOID = {"meta", "br", "link", "img", "input", "hr"}
UNITS = {"GPa": 1e9, "MPa": 1e6, "kPa": 1e3, "Pa": 1, "m": 1, "mm": 1e-3, "µm": 1e-6, "s": 1,
         "ms": 1e-3, "µs": 1e-6, "kN/m": 1e3, "N/m": 1, "mPa·s": 1e-3, "mL": 1e-6, "%": 1e-2,
         "million": 1e6}
SAID = {"Pa": "GPa MPa kPa Pa", "m": "m mm µm", "s": "s ms µs", "N/m": "kN/m N/m", "deg": "°",
        "Pa s": "mPa·s", "m2/s": "m²/s", "kg/m3": "kg/m³"}
# What the clock and the caller decide: all else is the same in every run.
VARYING = ("<dt>wall time</dt>", "<dt>disc-steps per second</dt>", "<dt>command line</dt>",
           "<dt>date</dt>")


def plain(words):
    for special, simple in {"\u00a0": " ", "\u202f": "", "\u2212": "-"}.items():
        words = words.replace(special, simple)
    return " ".join(words.split())


class Page(html.parser.HTMLParser):
    """The tree as far as the tests want it: every element with its place and its words."""

    def __init__(self, path):
        super().__init__()
        self.source = path.read_text(encoding="utf-8")
        self.open, self.elements, self.faults, self.style = [], [], [], ""
        self.feed(self.source)
        self.close()
        self.faults += [f"<{e['tag']}> is never closed" for e in self.open]

    def handle_starttag(self, tag, attributes):
        element = {"tag": tag, "words": "", "inside": [e["tag"] for e in self.open],
                   **{name: value for name, value in attributes if name != "tag"}}
        self.elements.append(element)
        if tag not in VOID:
            self.open.append(element)

    def handle_startendtag(self, tag, attributes):
        self.handle_starttag(tag, attributes)
        if tag not in VOID:
            self.open.pop()

    def handle_endtag(self, tag):
        if not self.open or self.open[-1]["tag"] != tag:
            self.faults.append(f"</{tag}> at {self.getpos()}")
        else:
            self.open.pop()

    def handle_data(self, words):
        for element in self.open:
            element["words"] += words

    def all(self, tag, **attributes):
        return [e for e in self.elements
                if e["tag"] == tag and all(e.get(k) == v for k, v in attributes.items())]

    def words(self, tag):
        return [plain(e["words"]) for e in self.all(tag)]

    def facts(self):
        """Every <dt> with the first <dd> behind it."""
        def behind(name):
            rest = self.elements[self.elements.index(name):]
            return next(e for e in rest if e["tag"] == "dd")
        return {plain(e["words"]): plain(behind(e)["words"]) for e in self.all("dt")}

    def rows(self):
        """Cells of every table row."""
        rows = []
        for e in self.elements:
            if e["tag"] == "tr":
                rows.append([e.get("class", "")])
            elif e["tag"] in ("td", "th"):
                rows[-1].append(plain(e["words"]))
        return rows


def luminance(colour):
    parts = [int(colour[k:k + 2], 16) / 255 for k in (1, 3, 5)]
    linear = [p / 12.92 if p <= 0.04045 else ((p + 0.055) / 1.055) ** 2.4 for p in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(a, b):
    """Of WCAG 2."""
    light, dark = sorted((luminance(a), luminance(b)), reverse=True)
    return (light + 0.05) / (dark + 0.05)


def long_form(colour):
    return "#" + "".join(2 * c for c in colour[1:]) if len(colour) == 4 else colour


class ReportTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.temporary.cleanup)
        cls.full = cls.run_kgd("full")
        cls.quick = cls.run_kgd("quick", "--quick")

    @classmethod
    def folder(cls, out):
        return pathlib.Path(cls.temporary.name) / out

    @classmethod
    def run_kgd(cls, out, *options, status=0):
        done = subprocess.run([KGD, "--quiet", "--out", str(cls.folder(out)), *options], text=True,
                              capture_output=True)
        assert done.returncode == status, done.stdout + done.stderr
        return Page(cls.folder(out) / "report.html")

    def assert_said(self, words, value, factor=None):
        """`words` begin with `value` and its unit, right to the last digit that is shown."""
        number, unit = re.match(r"([+-]?\d+(?:\.\d+)?) ?(\S*)", words).groups()
        factor = factor or UNITS.get(unit, 1)
        decimals = len(number.partition(".")[2])
        self.assertLessEqual(abs(float(number) - value / factor), 0.5001 * 10 ** -decimals,
                             f"{words} for {value}")

    def check_form(self, page, folder):
        self.assertTrue(page.source.startswith("<!DOCTYPE html>\n<html lang=\"en\">"))
        self.assertEqual(page.faults, [])
        self.assertEqual(len(page.all("h1")), 1)
        self.assertEqual(len(page.all("main")), 1)
        self.assertEqual(page.words("title"), page.words("h1"))
        self.assertEqual(page.all("meta", name="viewport")[0]["content"],
                         "width=device-width, initial-scale=1")
        for tag in ("script", "link", "iframe", "object", "embed", "img", "base", "use", "image"):
            self.assertEqual(page.all(tag), [], tag)
        for word in ("http:", "https:", "url(", "@import", "src="):
            self.assertNotIn(word, page.source)
        ids = [e["id"] for e in page.elements if "id" in e]
        self.assertEqual(len(ids), len(set(ids)))
        for e in page.elements:
            for reference in e.get("aria-labelledby", "").split():
                self.assertIn(reference, ids)
        links = [e["href"] for e in page.elements if "href" in e]
        files = [link for link in links if not link.startswith("#")]
        self.assertEqual({link[1:] for link in links if link.startswith("#")}, set(ids))
        written = [str(p.relative_to(folder)) for p in folder.rglob("*")
                   if p.is_file() and p.suffix != ".vtp"]  # the .pvd files list these
        self.assertEqual(sorted(files + ["report.html"]), sorted(written))
        self.assertEqual(len(page.all("figure")), len(page.all("figcaption")))
        for svg in page.all("svg"):
            if "svg" not in svg["inside"]:
                self.assertEqual(svg["role"], "img")
                self.assertGreater(len(svg["aria-label"]), 5)

    def test_it_is_one_well_formed_page_that_needs_nothing_from_elsewhere(self):
        self.check_form(self.full, self.folder("full"))
        self.check_form(self.quick, self.folder("quick"))
        self.assertEqual(len(self.full.all("figure")), 4)
        self.assertLess(len(self.full.source.encode()), 2e6)

    def test_it_opens_with_the_crack_and_its_numbers_before_any_section(self):
        first_section = self.full.source.index("<h2")
        for part in ('<dl class="numbers">', "<figure>"):
            self.assertLess(self.full.source.index(part), first_section)

    def test_its_numbers_are_those_of_the_summary(self):
        for out, page in (("quick", self.quick), ("full", self.full)):
            summary = json.loads((self.folder(out) / "summary.json").read_text())
            facts = page.facts()
            for name, key in {"crack length": "full_length_m", "tips": "tip_up_m",
                              "aperture at the injection": "aperture_at_injection_m",
                              "injection pressure": "injection_pressure_Pa",
                              "injection time": "time_s",
                              "pressure at the first break": "first_break_pressure_Pa",
                              "peak pressure": "peak_pressure_Pa", "injected": "fluid_volume_m2",
                              "held by the crack": "crack_volume_m2",
                              "broken bonds": "broken_bonds",
                              "of these off the crack's plane": "broken_bonds_off_plane",
                              "contacts of the preset crack": "preset_contacts",
                              "Young's modulus of the specimen": "E_Pa",
                              "Poisson's ratio of the specimen": "poisson_ratio",
                              "fluid steps": "fluid_steps",
                              "unconverged fluid steps": "unconverged_fluid_steps",
                              "mechanical steps": "mechanical_steps",
                              "settling steps": "settling_steps",
                              "mechanical time step": "mechanical_dt_s", "wall time": "wall_s",
                              "disc-steps per second": "particle_steps_per_s",
                              "threads": "threads"}.items():
                with self.subTest(f"{out}: {name}"):
                    self.assert_said(facts[name], summary[key])
            self.assertIn("paper's rule", facts["a fluid step ends"])

    def test_references_stand_beside_the_numbers_where_they_hold(self):
        summary = json.loads((self.folder("full") / "summary.json").read_text())
        rows = {row[1]: row[2:] for row in self.full.rows()}
        self.assertEqual(rows[""], ["hfdem", "paper", "difference", "KGD, the paper's KIC",
                          "difference"])
        for name, key in {"crack length": "full_length_m",
                          "aperture at the injection, w": "aperture_at_injection_m",
                          "of which opened, w - w0": "opening_at_injection_m",
                          "net pressure": "net_pressure_Pa"}.items():
            ours, paper, from_paper, kgd, from_kgd = rows[name]
            self.assert_said(ours, summary[key])
            self.assert_said(kgd, summary["kgd"][key]["reference"])
            self.assert_said(from_kgd, summary["kgd"][key]["relative_difference"])
            if key in summary["paper"]:
                self.assert_said(paper, summary["paper"][key]["reference"])
                self.assert_said(from_paper, summary["paper"][key]["relative_difference"])
        words = plain(self.full.all("main")[0]["words"])
        for printed in ("0.763 m", "75.2 µm", "35.1 GPa", "1.88 MPa", "paper 0.770 m",
                        "KGD 0.766 m"):
            self.assertIn(printed, words)
        # The small specimen is not the paper's.
        rows = {row[1]: row[2:] for row in self.quick.rows()}
        self.assertEqual(rows[""], ["hfdem", "KGD, the paper's KIC", "difference"])
        self.assertNotIn("0.770", self.quick.source)
        self.assertNotIn("paper (numerical)", self.quick.source)
        self.assertIn("paper (numerical)", self.full.source)
        # Nor is it when it reaches the paper's time.
        slow = self.run_kgd("slow", "--quick", "--set", "run.end_time=0.9",
                            "--set", "injection.rate=1e-5")
        self.assertNotIn("0.770", slow.source)
        self.assertNotIn("paper (numerical)", slow.source)

    def test_every_parameter_is_there_and_those_that_differ_say_so(self):
        for out, page in (("quick", self.quick), ("full", self.full)):
            shown, section = {}, ""
            for row in page.rows():
                if row[0] == "group":
                    section = row[1]
                elif section and len(row) == 5:
                    shown[section, row[1]] = row
            changed = {key for key, row in shown.items() if row[0] == "changed"}
            self.assertEqual(changed, set() if out == "full" else
                             {("specimen", "columns"), ("specimen", "rows"), ("run", "end_time")})
            count = 0
            for line in (self.folder(out) / "config.toml").read_text().splitlines():
                if line.startswith("["):
                    section = line.strip("[]")
                elif line:
                    count += 1
                    setting, comment = line.split("#", 1)
                    key, value = (part.strip() for part in setting.split("="))
                    _, _, words, unit, meaning = shown[section, key]
                    with self.subTest(f"{out}: {section}.{key}"):
                        self.check_parameter(words, unit, meaning, value, comment.strip())
            self.assertEqual(len(shown), count)
        row = next(row for row in self.quick.rows() if row[1] == "columns")
        self.assertEqual(row[2:4], ["40 default 100", ""])

    def check_parameter(self, words, unit, meaning, value, comment):
        plain_unit = comment.rpartition("; ")[0] if comment.endswith("; " + meaning) else ""
        self.assertEqual(comment, f"{plain_unit}; {meaning}" if plain_unit else meaning)
        self.assertIn(unit, SAID.get(plain_unit, plain_unit).split() or [""])
        words = words.split(" default")[0]
        try:
            wanted = float(value)
        except ValueError:
            self.assertEqual(words, value.strip('"'))
            return
        shown = float(re.sub(r" × 10(-?\d+)$", r"e\1", words)) * UNITS.get(unit, 1)
        self.assertAlmostEqual(shown, wanted, delta=1e-9 * abs(wanted))

    def test_a_place_and_what_else_is_set_are_shown(self):
        page = self.run_kgd("set", "--quick", "--set", "injection.position=[0.15, 0.25]",
                            "--set", "run.end_time=0.01", "--set", "scheme.equilibrium=true",
                            "--set", "contact.tensile_strength=8.0000001e6")
        rows = {row[1]: row for row in page.rows()}
        self.assertEqual(rows["position"][2:4], ["(0.15, 0.25) default not set", "m"])
        self.assertEqual(rows["equilibrium"][2], "true default false")
        self.assertEqual(rows["tensile_strength"][:3],
                         ["changed", "tensile_strength", "8.0000001 default 8 MPa"])
        self.assertIn("equilibrium", page.facts()["a fluid step ends"])
        self.assertEqual(rows["max_mechanical_steps"][2], "1000 default 10")

    def test_what_a_user_typed_is_shown_and_not_obeyed(self):
        name = "a&b <i>\"c\" 'd' &lt; ^{e}"
        page = self.run_kgd(name, "--quick", "--set", "run.end_time=0.001")
        self.check_form(page, self.folder(name))
        self.assertEqual(page.all("i"), [])
        command = next(c for c in page.words("code") if "--out" in c)
        self.assertEqual(shlex.split(command), [KGD, "--quiet", "--out", str(self.folder(name)),
                                                "--quick", "--set", "run.end_time=0.001"])

    def test_the_manifest_says_where_the_run_comes_from(self):
        facts = self.full.facts()
        self.assertRegex(facts["program"], r"^kgd of hfdem \d+\.\d+\.\d+$")
        self.assertRegex(facts["compiler"], r"^(GCC|.*[Cc]lang) .*\d+\.\d+")
        self.assertIn("-ffp-contract=off", facts["flags"])
        self.assertNotIn("-Wextra", facts["flags"])
        self.assertEqual(facts["seed"], "none")
        self.assertRegex(facts["date"], r"^\d{4}-\d\d-\d\d \d\d:\d\d:\d\d UTC$")

    def test_two_runs_differ_only_where_the_clock_is_read(self):
        again = self.run_kgd("again", "--quick")
        one, other = self.quick.source.splitlines(), again.source.splitlines()
        self.assertEqual(len(one), len(other))
        for a, b in zip(one, other):
            if not a.startswith(VARYING):
                self.assertEqual(a, b)

    def test_a_run_that_stopped_says_so_at_the_top(self):
        self.assertEqual(self.quick.all("p", role="alert"), [])
        page = self.run_kgd("stopped", "--quick", "--set", "run.end_time=2", status=3)
        self.check_form(page, self.folder("stopped"))
        banner, = page.all("p", role="alert")
        self.assertIn("stopped early", banner["words"])
        self.assertIn("rim", banner["words"])
        self.assertIn("header", banner["inside"])
        self.assertIn("rim", page.facts()["ended"])

    def test_a_run_that_could_not_begin_says_so_too(self):
        page = self.run_kgd("unbegun", "--quick", "--set", "mechanics.max_settle_steps=20",
                            status=3)
        self.check_form(page, self.folder("unbegun"))
        self.assertIn("no equilibrium", page.all("p", role="alert")[0]["words"])
        self.assertIn("no row", page.source)

    def test_words_stand_out_in_both_schemes(self):
        style = self.full.all("style")[0]["words"]
        light, dark = style.split("(prefers-color-scheme: dark)")
        for scheme in (light, dark):
            colours = {name: long_form(value)
                       for name, value in re.findall(r"--(\w[\w-]*): (#\w+);", scheme)}
            for name in ("ink", "muted", "link", "warning"):
                for ground in ("paper", "tint") + (("warning-tint",) if name == "warning" else ()):
                    self.assertGreaterEqual(contrast(colours[name], colours[ground]), 4.5,
                                            (name, ground))
        # In the figures: words, and on the dark ground lines, but for the grid's.
        swap = {}
        for paint, before, rule, after in re.findall(
                r'\[(\w+)="(#\w+)"\][^{]*{ (\w+): (#\w+); }', dark):
            self.assertEqual(paint, rule)
            swap[paint, before] = after
        night = re.search(r"--paper: (#\w+)", dark).group(1)
        written = {e["fill"] for e in self.full.all("text")}
        drawn = {e["stroke"] for e in self.full.all("path") if "stroke" in e} - {"#e2e2e2"}
        self.assertGreaterEqual(len(written), 4)
        for colour in written:
            self.assertGreaterEqual(contrast(colour, "#ffffff"), 4.5, colour)
            self.assertGreaterEqual(contrast(swap["fill", colour], night), 4.5, colour)
        for colour in drawn:
            self.assertGreaterEqual(contrast(swap["stroke", colour], night), 3, colour)


if __name__ == "__main__":
    unittest.main()
