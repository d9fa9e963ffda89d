"""The program joint_tests as a user meets it: its answer beside Coulomb's, files, errors.

    python3 tests/programs/joint_tests_test.py build/release/examples/joint_tests
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

JOINT_TESTS = sys.argv.pop(1)
FRICTION, COHESION, NORMAL_STIFFNESS = 0.5, 0.1e6, 120e9  # the paper's Table 3


def coulomb(angle, cohesion, confinement):
    """Normal stress n and shear stress t on the joint are linear in the major stress."""
    b = math.radians(angle)
    n, t = math.cos(b) ** 2, math.sin(b) * math.cos(b)  # of each Pa above the confinement
    return confinement + (cohesion + FRICTION * confinement) / (t - FRICTION * n)


class JointTestsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.done = cls.run_program("--quick", out="quick")

    @classmethod
    def path(cls, name):
        return pathlib.Path(cls.folder.name) / name

    @classmethod
    def run_program(cls, *options, out):
        return subprocess.run([JOINT_TESTS, "--out", str(cls.path(out)), *options], text=True,
                              capture_output=True)

    def table(self, name):
        with open(self.path("quick") / name, newline="") as file:
            return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]

    def refused(self, *options, words):
        done = self.run_program("--quick", *options, out="refused")
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(done.stdout, "")
        for word in words:
            self.assertIn(word, done.stderr)

    def test_joints_slip_as_coulomb_says(self):
        self.assertEqual(self.done.returncode, 0, self.done.stderr)
        tests = self.table("tests.csv")
        self.assertEqual([(t["angle_deg"], t["confinement_Pa"]) for t in tests],
                         [(angle, stress) for angle in (45, 60, 70) for stress in (5e6, 15e6)])
        for t in tests:
            with self.subTest(angle=t["angle_deg"], confinement=t["confinement_Pa"]):
                case = t["angle_deg"], t["confinement_Pa"]
                peak, residual = coulomb(case[0], COHESION, case[1]), coulomb(case[0], 0, case[1])
                self.assertAlmostEqual(t["peak_Pa"] / peak, 1, delta=0.06)
                self.assertAlmostEqual(t["residual_Pa"] / residual, 1, delta=0.03)
                self.assertAlmostEqual(t["peak_over_coulomb"], t["peak_Pa"] / peak, places=9)
                self.assertAlmostEqual(t["residual_over_coulomb"], t["residual_Pa"] / residual,
                                       places=9)
                self.assertAlmostEqual(t["normal_stiffness_Pa_per_m"] / NORMAL_STIFFNESS, 1,
                                       delta=0.02)

    def test_the_files_say_the_same(self):
        tests, curves = self.table("tests.csv"), self.table("curves.csv")
        summary = json.loads((self.path("quick") / "summary.json").read_text())
        self.assertEqual(summary["tests"], 6)
        ratios = {"peak": [t["peak_over_coulomb"] for t in tests],
                  "residual": [t["residual_over_coulomb"] for t in tests],
                  "normal_stiffness": [t["normal_stiffness_Pa_per_m"] / 120e9 for t in tests],
                  "shear_stiffness": [t["shear_stiffness_Pa_per_m"] / 60e9 for t in tests]}
        self.assertEqual(set(summary["worst"]), set(ratios))
        for key, of_tests in ratios.items():
            self.assertAlmostEqual(summary["worst"][key], max(abs(r - 1) for r in of_tests), places=8)
        for t in tests:
            case = [c for c in curves if all(c[k] == t[k] for k in
                                             ("angle_deg", "confinement_Pa", "seed"))]
            last = [c["stress_Pa"] for c in case if c["strain"] > 0.75 * case[-1]["strain"]]
            self.assertAlmostEqual(sum(last) / len(last) / t["residual_Pa"], 1, places=8)
            self.assertLessEqual(max(c["stress_Pa"] for c in case), t["peak_Pa"] * (1 + 1e-9))
            self.assertAlmostEqual(
                t["confinement_Pa"] / case[0]["closure_m"] / t["normal_stiffness_Pa_per_m"], 1,
                places=8)
        for name in ("strength.svg", "slip.svg"):
            xml.etree.ElementTree.parse(self.path("quick") / name)
        report = (self.path("quick") / "report.html").read_text()
        for words in ("A joint slips as Coulomb says", "cohesion of the joint", "tests.csv"):
            self.assertIn(words, report)
        self.assertEqual(len(self.done.stdout.splitlines()), 8)

    def test_bad_input_is_refused(self):
        self.refused("--set", "joints.friction=-1", words=["joints.friction", "at least 0"])
        self.refused("--set", "joints.initially=wet", words=["joints.initially", "dry", "filled"])
        self.refused("--set", "study.seeds=0", words=["study.seeds", "at least 1"])
        self.refused("--set", "study.low_confinement=0", words=["study.low_confinement", "greater"])
        self.refused("--set", "load_frame.strain_rate=2", words=["load_frame.strain_rate", "at most 1"])
        self.refused("--set", "joints.nonsense=1", words=["nonsense"])
        self.assertFalse((self.path("refused") / "summary.json").exists())


if __name__ == "__main__":
    unittest.main()
