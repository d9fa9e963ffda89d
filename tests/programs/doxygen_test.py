"""Every public name is described: the reference builds without a warning, and what it needs is in it.

    python3 tests/programs/doxygen_test.py .

Exit status 77, "skipped", where doxygen is not installed.
"""

import html.parser
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(sys.argv.pop(1)).resolve()


def build(root, folder):
    """Builds the reference of a source tree; the warnings, and whether doxygen was content."""
    settings = (root / "docs" / "Doxyfile").read_text() + f'\nOUTPUT_DIRECTORY = "{folder}"\n'
    done = subprocess.run(["doxygen", "-"], input=settings, text=True, capture_output=True, cwd=root)
    return done.stdout + done.stderr, done.returncode == 0


class Links(html.parser.HTMLParser):
    """What a page points to, and what a browser loads to show it."""

    def __init__(self, page):
        super().__init__()
        self.targets, self.loaded = [], []
        self.feed(page.read_text())

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if tag == "a" and "href" in attributes:
            self.targets.append(attributes["href"])
        for name in ("src", "href"):
            if tag != "a" and name in attributes:
                self.loaded.append(attributes[name])


class ReferenceTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.html = pathlib.Path(folder.name)
        cls.warnings, cls.content = build(ROOT, folder.name)

    def page(self, name):
        return (self.html / name).read_text()

    def test_nothing_public_is_undescribed(self):
        self.assertEqual(self.warnings, "")
        self.assertTrue(self.content)

    def test_every_folder_is_described(self):
        listing = self.page("files.html")
        for folder in [ROOT / "include" / "hfdem", *(ROOT / "include" / "hfdem").glob("*/")]:
            row = re.search(rf'>{folder.name}</a></td><td class="desc">(.*?)</td>', listing)
            self.assertTrue(row and row.group(1), folder.name)

    def test_a_parameter_shows_the_meaning_unit_and_range_of_its_table(self):
        page = self.page("structhfdem_1_1LinearParallelBond_1_1Params.html")
        for words in ["tensile strength of the parallel bond; Pa; at least 0", "= 8e6",
                      "friction angle of the parallel bond; deg; at least 0 and less than 90"]:
            self.assertIn(words, page)

    def test_every_concept_has_its_page(self):
        headers = (ROOT / "include/hfdem/state").glob("*concepts.hpp")
        text = "".join(header.read_text() for header in headers)
        for name in re.findall(r"^concept (\w+)", text, re.M):
            page = "concepthfdem_1_1" + name.replace("_", "__") + ".html"
            self.assertTrue((self.html / page).exists(), name)

    def test_all_links_lead_somewhere_and_nothing_is_loaded_from_elsewhere(self):
        for page in self.html.glob("*.html"):
            links = Links(page)
            own = [t for t in links.targets if not t.startswith("https://www.doxygen.org/")]
            for target in links.loaded + own:
                if not target.startswith("javascript:"):
                    file = self.html / target.split("#")[0]
                    self.assertTrue(file.exists(), f"{page.name}: {target}")

    def test_a_name_without_a_description_is_seen(self):
        with tempfile.TemporaryDirectory() as folder:
            copy = pathlib.Path(folder) / "copy"
            for part in ("docs", "include"):
                shutil.copytree(ROOT / part, copy / part)
            (copy / "include/hfdem/base/blank.hpp").write_text(
                "/// @file\n/// A blank.\n#pragma once\nnamespace hfdem {\nstruct Blank { int member; };\n}\n")
            warnings, content = build(copy, folder)
            self.assertIn("hfdem::Blank is not documented", warnings)
            self.assertFalse(content)


if __name__ == "__main__":
    if not shutil.which("doxygen"):
        print("skipped: doxygen is not installed")
        sys.exit(77)
    unittest.main()
