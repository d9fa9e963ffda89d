"""The program regimes as a user meets it: its map, files, a run that is interrupted, errors.

    python3 tests/programs/regimes_test.py build/release/examples/regimes
"""

import csv
import json
import math
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import xml.etree.ElementTree

REGIMES = sys.argv.pop(1)
SHORT = ("--quick", "--set", "study.slit_discs=20", "--set", "slits.shortest=4",
         "--set", "slits.longest=8")
CRACKS = ("toughness_vertex", "toughness_edge")


class RegimesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.done = cls.run_program(*SHORT, out="whole")

    @classmethod
    def path(cls, name):
        return pathlib.Path(cls.folder.name) / name

    @classmethod
    def run_program(cls, *options, out):
        return subprocess.run([REGIMES, "--out", str(cls.path(out)), *options], text=True,
                              capture_output=True)

    def summary(self):
        return json.loads((self.path("whole") / "summary.json").read_text())

    def rows(self, name):
        with open(self.path("whole") / name, newline="") as file:
            return list(csv.DictReader(file))

    def refused(self, *options, words):
        done = self.run_program("--quick", *options, out="refused")
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(done.stdout, "")
        for word in words:
            self.assertIn(word, done.stderr)

    def test_even_short_cracks_are_near_their_references(self):
        self.assertEqual(self.done.returncode, 0, self.done.stderr)
        cracks = self.summary()["cracks"]
        self.assertEqual(tuple(cracks), CRACKS)
        for crack in cracks.values():
            self.assertEqual(crack["unconverged_fluid_steps"], 0)
            self.assertEqual(crack["breaks_off_plane"], 0)
            self.assertLess(abs(crack["half_length_m"] - crack["kgd_half_length_m"]), 0.01)
            opening = crack["opening_m"] + crack["opening_offset_m"]
            self.assertLess(abs(opening / crack["kgd_opening_m"] - 1), 0.2)
            self.assertTrue(0.95 < crack["plate_width_factor"] < 1.05)
        # A slower fluid lets the crack grow less and opens it more.
        thin, thick = cracks.values()
        self.assertGreater(thin["K_m"], thick["K_m"])
        self.assertGreater(thick["opening_m"], thin["opening_m"])

    def test_toughness_is_that_of_the_slits_at_the_tip(self):
        summary = self.summary()
        rock = summary["rocks"]["tough"]
        self.assertLess(abs(rock["E_prime"] / 25.7e9 - 1), 0.05)
        for crack in summary["cracks"].values():
            K = rock["K_IC"] + rock["K_IC_per_pressure"] * crack["tip_pressure_Pa"]
            self.assertAlmostEqual(crack["K_IC_Pa_sqrt_m"] / K, 1, places=5)
            K_prime = 4 * math.sqrt(2 / math.pi) * K
            volume = (crack["rate_m2_per_s"] * crack["time_s"] +
                      2 * crack["kgd_half_length_m"] * rock["volume_offset"])
            K_m = (K_prime ** 4 / (12 * crack["viscosity_Pa_s"] * rock["E_prime"] ** 3 *
                                   volume / crack["time_s"])) ** 0.25
            self.assertAlmostEqual(crack["K_m"] / K_m, 1, places=5)

    def test_tables_say_what_the_summary_says(self):
        cracks = self.summary()["cracks"]
        self.assertEqual(tuple(row["crack"] for row in self.rows("points.csv")), CRACKS)
        for row in self.rows("points.csv"):
            for name in ("K_m", "half_length_m", "opening_m", "net_pressure_Pa"):
                self.assertAlmostEqual(float(row[name]) / cracks[row["crack"]][name], 1, places=9)
        profiles = self.rows("profiles.csv")
        for name, crack in cracks.items():
            own = [row for row in profiles if row["crack"] == name]
            # The middle contacts are at the injection, half a disc away from its domain.
            self.assertAlmostEqual(float(own[0]["along_m"]), 0.005, places=6)
            self.assertAlmostEqual(float(own[0]["opening_m"]) / crack["opening_m"], 1, places=6)
            openings = [float(row["opening_m"]) for row in own]
            self.assertEqual(openings, sorted(openings, reverse=True))
        for name in CRACKS:
            self.assertIn(name.replace("_", " "), self.done.stdout)

    def test_pictures_and_report_go_with_it(self):
        names = ["map.svg"] + [f"{c}_{what}.svg" for c in CRACKS for what in ("opening", "pressure")]
        for name in names:
            xml.etree.ElementTree.parse(self.path("whole") / name)
        report = (self.path("whole") / "report.html").read_text()
        for words in ("From toughness to viscosity", "toughness edge", "points.csv"):
            self.assertIn(words, report)
        self.assertFalse((self.path("whole") / "checkpoint").exists())

    def test_an_interrupted_run_goes_on_to_the_same_numbers(self):
        folder = self.path("broken")
        process = subprocess.Popen([REGIMES, "--quiet", "--out", str(folder), *SHORT],
                                   stderr=subprocess.PIPE, text=True)
        checkpoint = folder / "checkpoint"
        saved = set()  # at the beginning, then after each slit
        while process.poll() is None and len(saved) < 2:
            if checkpoint.exists():
                saved.add(checkpoint.stat().st_ino)
            time.sleep(0.005)
        process.send_signal(signal.SIGINT)
        _, words = process.communicate()
        self.assertEqual(process.returncode, 4, words)
        self.assertIn("--resume", words)
        self.assertFalse((folder / "points.csv").exists())
        resumed = subprocess.run([REGIMES, "--quiet", "--threads", "2", "--resume", str(folder)],
                                 text=True, capture_output=True)
        self.assertEqual(resumed.returncode, 0, resumed.stderr)
        for name in ("points.csv", "profiles.csv", "map.svg"):
            self.assertEqual((folder / name).read_bytes(),
                             (self.path("whole") / name).read_bytes(), name)
        self.assertFalse(checkpoint.exists())

    def test_bad_input_is_refused(self):
        self.refused("--set", "study.cracks=10", words=["study.cracks", "at most 9"])
        self.refused("--set", "middle.viscosity=0", words=["middle.viscosity", "greater than 0"])
        self.refused("--set", "middle.rock=\"soft\"", words=["middle.rock", "tough", "weak"])
        self.refused("--set", "study.nonsense=1", words=["nonsense"])
        self.assertFalse((self.path("refused") / "summary.json").exists())


if __name__ == "__main__":
    unittest.main()
