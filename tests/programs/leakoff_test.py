"""The programs leakoff and permeability as a user meets them: three runs, tables, pictures, errors.

    python3 tests/programs/leakoff_test.py build/release/examples/leakoff \
        build/release/examples/permeability
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

PERMEABILITY = sys.argv.pop(2)
LEAKOFF = sys.argv.pop(1)
PARTS = ("without", "unsaturated", "saturated")
SHORT = ("--quick", "--set", "run.end_time=0.06", "--set", "readings.propagation_from=0.03",
         "--set", "readings.propagation_to=0.06")


class LeakoffTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.done = cls.run_program(*SHORT, out="whole")

    @classmethod
    def path(cls, name):
        return pathlib.Path(cls.folder.name) / name

    @classmethod
    def run_program(cls, *options, out, program=LEAKOFF):
        return subprocess.run([program, "--out", str(cls.path(out)), *options], text=True,
                              capture_output=True)

    def summary(self, part, out="whole"):
        return json.loads((self.path(out) / part / "summary.json").read_text())

    def rows(self, name, out="whole"):
        with open(self.path(out) / name, newline="") as file:
            return list(csv.DictReader(file))

    def test_three_runs_of_one_rock(self):
        self.assertEqual(self.done.returncode, 0, self.done.stdout + self.done.stderr)
        for part in PARTS:
            answer = self.summary(part)
            self.assertEqual(answer["seed"], 1)
            self.assertLess(answer["fluid_balance_relative_error"], 1e-10)
            self.assertEqual(answer["viscosity_Pa_s"], 0.1)
            self.assertEqual("leakoff" in answer, part != "without")
        discs = {(self.path("whole") / part / "specimen.txt").read_text() for part in PARTS}
        self.assertEqual(len(discs), 1)
        self.assertEqual(self.summary("unsaturated")["leakoff"]["saturation"], 0)
        self.assertEqual(self.summary("saturated")["leakoff"]["saturation"], 1)
        # Pressure spreads through full pores at once, and through dry ones once they are full.
        self.assertGreater(self.summary("saturated")["leakoff"]["pores_with_pressure"],
                           10 * self.summary("unsaturated")["leakoff"]["pores_with_pressure"])

    def test_what_leaks_is_found_in_the_pores(self):
        for part in PARTS[1:]:
            rows = self.rows(f"{part}/leakoff.csv")
            self.assertGreater(len(rows), 10)
            for row in rows:
                injected, leaked = float(row["injected_m2"]), float(row["leaked_m2"])
                self.assertAlmostEqual(float(row["efficiency"]), 1 - leaked / injected, places=6)
            leakoff = self.summary(part)["leakoff"]
            self.assertTrue(0.5 < leakoff["efficiency"] < 1)
            saturation = leakoff["saturation"]
            entered = full = 0
            for pore in self.rows(f"{part}/pores.csv"):
                filling, pressure = float(pore["filling"]), float(pore["pressure_Pa"])
                self.assertTrue(saturation <= filling <= 1)
                if pore["in_crack"] == "0":
                    self.assertFalse(pressure > 0 and filling < 1)
                    entered += filling > saturation
                    full += pressure > 0
            self.assertEqual(entered, leakoff["pores_that_gained"])
            self.assertEqual(full, leakoff["pores_with_pressure"])

    def test_pictures_and_reports(self):
        for name in ("pressure", "length", "leaked"):
            text = (self.path("whole") / f"{name}.svg").read_text()
            xml.etree.ElementTree.fromstring(text)
            self.assertIn("dry pores", text)
        for part in PARTS[1:]:
            for name in ("pores", "leaked", "efficiency", "fracture"):
                xml.etree.ElementTree.parse(self.path("whole") / part / f"{name}.svg")
            self.assertIn("Leak-off", (self.path("whole") / part / "report.html").read_text())
        report = (self.path("whole") / "report.html").read_text()
        for words in ("A crack in rock that leaks", "saturated/report.html", "without leak-off"):
            self.assertIn(words, report)
        self.assertFalse((self.path("whole") / "checkpoint").exists())

    def test_several_rocks_are_compared_rock_by_rock(self):
        done = self.run_program(*SHORT, "--seeds", "2", out="rocks")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        rows = {(r["part"], r["reading"]): r for r in self.rows("comparison.csv", "rocks")}
        for part in PARTS[1:]:
            row = rows[part, "breakdown_pressure_Pa"]
            self.assertEqual(row["rocks"], "2")
            own = [float(r["breakdown_pressure_Pa"]) for r in self.rows(f"{part}/seeds.csv", "rocks")]
            self.assertAlmostEqual(float(row["mean"]) / (sum(own) / 2), 1, places=9)
            self.assertAlmostEqual(float(row["change"]),
                                   float(row["mean"]) - float(row["mean_without"]), delta=1)
        self.assertIn("saturated pores beside without leak-off", done.stdout)

    def test_carbon_dioxide_and_uniform_pressure(self):
        done = self.run_program(*SHORT, "--fluid", "sc-co2", "--scheme", "uniform",
                                "--set", "run.end_time=0.02", out="uniform")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        for part in PARTS:
            answer = self.summary(part, "uniform")
            self.assertEqual(answer["viscosity_Pa_s"], 6e-5)
            self.assertEqual(answer["scheme"], "uniform")
            self.assertLess(answer["fluid_balance_relative_error"], 1e-10)

    def test_an_interrupted_study_goes_on_to_the_same_bytes(self):
        folder = self.path("broken")
        process = subprocess.Popen([LEAKOFF, "--quiet", "--out", str(folder), "--checkpoint", "0.1",
                                    *SHORT], stderr=subprocess.PIPE, text=True)
        while process.poll() is None and not (folder / "unsaturated" / "checkpoint").exists():
            time.sleep(0.002)
        process.send_signal(signal.SIGINT)
        words = process.communicate()[1]
        self.assertEqual(process.returncode, 4, words)
        done = subprocess.run([LEAKOFF, "--quiet", "--resume", str(folder)], text=True,
                              capture_output=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        for part in PARTS:
            name = f"{part}/history.csv"
            self.assertEqual((folder / name).read_bytes(), (self.path("whole") / name).read_bytes())

    def test_bad_input_is_refused_by_name(self):
        for options, words in ((("--set", "leakoff.saturation=1.5"), ("saturation", "1.5", "1")),
                               (("--set", "leakoff.least_porosity=0"), ("least_porosity", "0")),
                               (("--fluid", "water"), ("water", "sc-co2")),
                               (("--set", "leakoff.coefficient=1"), ("coefficient",))):
            done = self.run_program("--quick", *options, out="refused")
            self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
            for word in words:
                self.assertIn(word, done.stderr)

    def test_permeability_and_its_scatter(self):
        done = self.run_program("--quick", "--seeds", "3", out="permeability",
                                program=PERMEABILITY)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        rows = self.rows("permeability.csv", "permeability")
        self.assertEqual([row["seed"] for row in rows], ["1", "2", "3"])
        answer = json.loads((self.path("permeability") / "summary.json").read_text())
        for axis in ("along_x", "along_y"):
            values = [float(row[axis + "_m2"]) for row in rows]
            self.assertAlmostEqual(answer[axis]["mean_m2"] / (sum(values) / 3), 1, places=9)
            self.assertTrue(1e-17 < min(values) and max(values) < 1e-15)


if __name__ == "__main__":
    unittest.main()
