"""The program rock_tests as a user meets it: files, repeatability, errors, exit status.

    python3 tests/programs/rock_tests_test.py build/release/examples/rock_tests
"""

import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

ROCK_TESTS = sys.argv.pop(1)
TABLES = ["seeds.csv", "curves.csv", "breaks.csv"]
FIGURES = ["cracks.svg", "compression.svg", "tension.svg", "envelope.svg"]
# Sane bounds of a small specimen, about the paper's Table 2.
BOUNDS = {"E_Pa": (26e9, 33e9), "poisson_ratio": (0.25, 0.33), "ucs_Pa": (15e6, 35e6),
          "tensile_strength_Pa": (3e6, 7e6), "friction_angle_deg": (30, 46),
          "cohesion_Pa": (3e6, 9e6), "brazilian_strength_Pa": (2.5e6, 9e6)}
PAPER = {"E_Pa": 29.1e9, "poisson_ratio": 0.30, "ucs_Pa": 22.3e6, "tensile_strength_Pa": 4.8e6,
         "friction_angle_deg": 37.5, "cohesion_Pa": 5.8e6}


class RockTestsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.done = cls.run_program("--quick", "--seeds", "2", "--seed", "5", out="two")

    @classmethod
    def path(cls, name):
        return pathlib.Path(cls.folder.name) / name

    @classmethod
    def run_program(cls, *options, out="out"):
        return subprocess.run([ROCK_TESTS, "--out", str(cls.path(out)), *options], text=True,
                              capture_output=True)

    def summary(self, out="two"):
        return json.loads((self.path(out) / "summary.json").read_text())

    def table(self, name, out="two"):
        with open(self.path(out) / name, newline="") as file:
            return list(csv.DictReader(file))

    def refused(self, *options, words):
        done = self.run_program("--quick", *options, out="refused")
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(done.stdout, "")
        for word in words:
            self.assertIn(word, done.stderr)

    def test_it_writes_its_answer(self):
        self.assertEqual(self.done.returncode, 0, self.done.stderr)
        self.assertIn("from 2 specimens", self.done.stdout)
        summary = self.summary()
        for key, (low, high) in BOUNDS.items():
            self.assertGreater(summary[key], low, key)
            self.assertLess(summary[key], high, key)
            one, other = (seed[key] for seed in summary["seeds"])
            self.assertAlmostEqual(summary[key] / ((one + other) / 2), 1, places=10)
            # Student's t of one degree of freedom; the standard error is half the difference.
            self.assertAlmostEqual(summary[key + "_ci95"] / (12.7062 * abs(one - other) / 2), 1, places=4)
        for key, value in PAPER.items():
            self.assertEqual(summary["paper"][key]["reference"], value)
            self.assertAlmostEqual(summary["paper"][key]["relative_difference"],
                                   summary[key] / value - 1, places=9)
        self.assertEqual([seed["seed"] for seed in summary["seeds"]], [5, 6])
        for name in FIGURES:
            root = xml.etree.ElementTree.parse(self.path("two") / name).getroot()
            self.assertTrue(root.tag.endswith("svg"))
        page = (self.path("two") / "report.html").read_text()
        self.assertIn("5 to 6", page)
        self.assertIn("least squares", page)

    def test_the_tables_say_the_same(self):
        for seed, row in zip(self.summary()["seeds"], self.table("seeds.csv")):
            q = [float(row[f"strength_at_{s}_Pa"]) for s in ("0", "5e+06", "1e+07")]
            slope = (q[2] - q[0]) / 10e6
            self.assertAlmostEqual(math.degrees(math.asin((slope - 1) / (slope + 1))),
                                   seed["friction_angle_deg"], places=6)
            self.assertAlmostEqual((sum(q) / 3 - slope * 5e6) / (2 * slope ** 0.5)
                                   / seed["cohesion_Pa"], 1, places=8)
            curve = [float(r["stress_Pa"]) for r in self.table("curves.csv")
                     if r["seed"] == row["seed"] and r["test"] == "tension"]
            self.assertLessEqual(max(curve), seed["tensile_strength_Pa"] * (1 + 1e-9))
            self.assertGreater(max(curve), 0.95 * seed["tensile_strength_Pa"])
        breaks = self.table("breaks.csv")
        self.assertEqual({b["mode"] for b in breaks}, {"tension", "shear"})
        self.assertTrue(all(0 < float(b["length_m"]) <= 0.01 for b in breaks))

    def test_the_same_bytes_again_from_its_own_parameters_and_with_two_threads(self):
        self.run_program("--quiet", "--threads", "2", "--config",
                         str(self.path("two") / "config.toml"), out="again")
        for name in TABLES + FIGURES + ["config.toml"]:
            self.assertEqual((self.path("two") / name).read_bytes(),
                             (self.path("again") / name).read_bytes(), name)

    def test_a_single_specimen_has_no_interval(self):
        done = self.run_program("--quick", "--quiet", "--set", "study.confinements=1", out="one")
        self.assertEqual(done.stdout + done.stderr, "")
        self.assertIsNone(self.summary("one")["ucs_Pa_ci95"])
        self.assertEqual(len(self.table("seeds.csv", "one")), 1)

    def test_scattered_bonds_make_a_weaker_rock(self):
        self.run_program("--quick", "--quiet", "--seed", "5", "--set", "contact.weibull_modulus=2",
                         "--set", "study.confinements=1", out="scattered")
        even, scattered = self.summary()["seeds"][0], self.summary("scattered")
        self.assertLess(scattered["tensile_strength_Pa"], 0.9 * even["tensile_strength_Pa"])
        self.assertAlmostEqual(scattered["E_Pa"] / even["E_Pa"], 1, delta=0.05)

    def test_bad_input_is_refused(self):
        self.refused("--set", "load_frame.grip_depth=0.1", words=["load_frame.grip_depth", "0.05"])
        self.refused("--set", "load_frame.end_below=1", words=["load_frame.end_below", "less than 1"])
        self.refused("--set", "brazilian.diameter=0.05", words=["brazilian.diameter", "0.08"])
        self.refused("--set", "specimen.radius_min=0.006", words=["specimen.radius_min", "radius_max"])
        self.refused("--set", "contact.weibull_modulus=0.5", words=["contact.weibull_modulus", "at least 1"])
        self.refused("--set", "study.confinements=0", words=["study.confinements", "at least 1"])
        self.refused("--seeds", "0", words=["study.seeds", "at least 1"])
        self.refused("--seed", "2147483647", words=["specimen.seed", "study.seeds"])
        self.refused("--seed", "-1", words=["specimen.seed", "at least 0"])
        self.refused("--set", "nonsense=1", words=["nonsense"])

    def test_tests_without_a_failure_are_said(self):
        done = self.run_program("--quick", "--set", "load_frame.largest_strain=2e-4", out="short")
        self.assertEqual(done.returncode, 3)
        self.assertIn("the specimen of seed 1 is left out", done.stderr)
        self.assertIn("load_frame.largest_strain", done.stderr)
        self.assertFalse((self.path("short") / "summary.json").exists())


if __name__ == "__main__":
    unittest.main()
