"""The program crossing as a user meets it: its map, files, a run that is interrupted, errors.

    python3 tests/programs/crossing_test.py build/release/examples/crossing
"""

import csv
import json
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import xml.etree.ElementTree

CROSSING = sys.argv.pop(1)
SHORT = ("--quick", "--set", "study.end_time=0.03")
LETTERS = {"arrested": "A", "offset": "O", "crossing": "X", "stopped": "-"}


class CrossingTest(unittest.TestCase):
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
        return subprocess.run([CROSSING, "--out", str(cls.path(out)), *options], text=True,
                              capture_output=True)

    def encounters(self):
        with open(self.path("whole") / "encounters.csv", newline="") as file:
            return list(csv.DictReader(file))

    def refused(self, *options, words):
        done = self.run_program("--quick", *options, out="refused")
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(done.stdout, "")
        for word in words:
            self.assertIn(word, done.stderr)

    def test_a_crack_crosses_a_joint_that_a_high_stress_holds_and_no_other(self):
        self.assertEqual(self.done.returncode, 0, self.done.stderr)
        fates = {(float(e["angle_deg"]), float(e["stress_along_Pa"])): e["encounter"]
                 for e in self.encounters()}
        self.assertEqual(set(fates), {(90, 11e6), (90, 25e6), (30, 11e6), (30, 25e6)})
        self.assertEqual([case for case, fate in fates.items() if fate == "crossing"], [(90, 25e6)])
        for e in self.encounters():
            self.assertLessEqual(float(e["time_s"]), 0.03 + 1e-9)
            if e["encounter"] == "arrested":
                self.assertAlmostEqual(float(e["time_s"]), 0.03, places=9)

    def test_the_map_in_letters_is_that_of_the_table(self):
        lines = self.done.stdout.splitlines()
        letters = {float(line.split()[0]) * 1e6: line.split()[2:] for line in lines
                   if " MPa " in line}
        self.assertEqual(list(letters), [25e6, 11e6])
        for e in self.encounters():
            column = {90: 0, 30: 1}[float(e["angle_deg"])]
            self.assertEqual(letters[float(e["stress_along_Pa"])][column], LETTERS[e["encounter"]])

    def test_summary_and_report_go_with_it(self):
        summary = json.loads((self.path("whole") / "summary.json").read_text())
        fates = [e["encounter"] for e in self.encounters()]
        self.assertEqual(summary["rocks"], 4)
        for fate in ("arrested", "offset", "crossing"):
            self.assertEqual(summary[fate], fates.count(fate))
        # At a flat angle no stress lets the crack cross; the search ends at 1 GPa.
        least = {angle: summary["criterion"][f"{angle}_deg"]["least_stress_along_Pa"]
                 for angle in (90, 30)}
        self.assertTrue(10e6 < least[90] < 25e6)
        self.assertIsNone(least[30])  # it never does
        xml.etree.ElementTree.parse(self.path("whole") / "map.svg")
        report = (self.path("whole") / "report.html").read_text()
        for words in ("Arrested, offset or crossing", "Gu and Weng", "encounters.csv"):
            self.assertIn(words, report)
        self.assertFalse((self.path("whole") / "checkpoint").exists())

    def test_an_interrupted_run_goes_on_to_the_same_map(self):
        folder = self.path("broken")
        process = subprocess.Popen([CROSSING, "--quiet", "--out", str(folder), *SHORT],
                                   stderr=subprocess.PIPE, text=True)
        checkpoint = folder / "checkpoint"
        saved = set()  # at the beginning, then after each rock
        while process.poll() is None and len(saved) < 2:
            if checkpoint.exists():
                saved.add(checkpoint.stat().st_ino)
            time.sleep(0.005)
        process.send_signal(signal.SIGINT)
        _, words = process.communicate()
        self.assertEqual(process.returncode, 4, words)
        self.assertIn("--resume", words)
        self.assertFalse((folder / "encounters.csv").exists())
        resumed = subprocess.run([CROSSING, "--quiet", "--resume", str(folder)], text=True,
                                 capture_output=True)
        self.assertEqual(resumed.returncode, 0, resumed.stderr)
        for name in ("encounters.csv", "map.svg", "summary.json"):
            self.assertEqual((folder / name).read_bytes(),
                             (self.path("whole") / name).read_bytes(), name)
        self.assertFalse(checkpoint.exists())

    def test_bad_input_is_refused(self):
        self.refused("--set", "joints.friction=-1", words=["joints.friction", "at least 0"])
        self.refused("--set", "study.every=0", words=["study.every", "at least 1"])
        self.refused("--set", "study.distance=-0.1", words=["study.distance", "greater than 0"])
        self.refused("--set", "study.nonsense=1", words=["nonsense"])
        self.refused("--set", "study.length=1", words=["fracture 0", "x must be"])
        self.assertFalse((self.path("refused") / "summary.json").exists())


if __name__ == "__main__":
    unittest.main()
