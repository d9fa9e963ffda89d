"""The program fractured as a user meets it: its fractures, files, counts, seeds, errors.

    python3 tests/programs/fractured_test.py build/release/examples/fractured
"""

import csv
import json
import pathlib
import subprocess
import sys
import tempfile
import tomllib
import unittest
import xml.etree.ElementTree

FRACTURED = sys.argv.pop(1)
SHIPPED = pathlib.Path(__file__).resolve().parents[2] / "examples/data/fractures.csv"
SHORT = ["--quick", "--set", "run.end_time=0.045", "--set", "readings.propagation_from=0.02",
         "--set", "readings.propagation_to=0.045"]
# A fracture across the way of the crack, and one far from it.
ACROSS = "x1_m,y1_m,x2_m,y2_m\n0.12,0.23,0.2,0.27\n0.05,0.05,0.1,0.09\n"


class FracturedTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.path("across.csv").write_text(ACROSS)
        cls.done = cls.run_fractured("--quick", "--set", "run.energy=true", "--fractures",
                                     str(cls.path("across.csv")), out="across")

    @classmethod
    def path(cls, name):
        return pathlib.Path(cls.folder.name) / name

    @classmethod
    def run_fractured(cls, *options, out):
        return subprocess.run([FRACTURED, "--out", str(cls.path(out)), *options], text=True,
                              capture_output=True)

    def succeed(self, *options, out):
        done = self.run_fractured(*options, out=out)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def refuse(self, *options, words):
        done = self.run_fractured(*options, out="refused")
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)

    def summary(self, out):
        return json.loads((self.path(out) / "summary.json").read_text())

    def table(self, name, out):
        with open(self.path(out) / name, newline="") as file:
            return list(csv.DictReader(line for line in file if not line.startswith("#")))

    def config(self, out):
        return tomllib.loads((self.path(out) / "config.toml").read_text())

    def test_a_crack_that_meets_a_fracture_opens_it(self):
        self.assertEqual(self.done.returncode, 0, self.done.stderr)
        summary = self.summary("across")
        self.assertGreater(summary["microcracks"]["connected_joints"], 0)
        first, far = self.table("natural_fractures.csv", "across")
        self.assertGreater(float(first["connected_length_m"]), 0.01)
        self.assertGreater(float(first["largest_slip_m"]), 1e-6)
        # Nothing slides or opens by more than the crack does.
        self.assertLess(float(first["largest_slip_m"]), 1e-3)
        self.assertLess(float(first["largest_opening_m"]), 1e-3)
        self.assertEqual(int(far["connected_microcracks"]), 0)
        self.assertLess(summary["energy_balance_relative_error"], 1e-5)
        report = (self.path("across") / "report.html").read_text()
        for words in ("2 natural fractures", "in natural fractures, connected", "Table 5"):
            self.assertIn(words, report)
        for name in ("fracture.svg", "joints.svg", "joint_lengths.svg"):
            xml.etree.ElementTree.parse(self.path("across") / name)

    def test_the_counts_are_those_of_the_tables(self):
        summary, cracks = self.summary("across"), self.table("cracks.csv", "across")
        counts, joints = summary["microcracks"], summary["joints"]
        for place, name in (("rock", "rock"), ("joint", "joints")):
            of_place = [c["mode"] for c in cracks if c["place"] == place]
            self.assertEqual(counts[name], len(of_place))
            for mode in ("tension", "shear"):
                self.assertEqual(sum(joints[f"in_{name}_{fluid}"][mode]
                                     for fluid in ("connected", "unconnected")),
                                 of_place.count(mode))
        self.assertEqual(sum(joints["in_joints_connected"].values()), counts["connected_joints"])
        self.assertEqual(counts["unconnected"], sum(joints["in_joints_unconnected"].values()) +
                         sum(joints["in_rock_unconnected"].values()))
        each = self.table("natural_fractures.csv", "across")
        last = self.table("joints.csv", "across")[-1]
        self.assertEqual(counts["joints"], sum(int(f["microcracks"]) for f in each))
        self.assertEqual(counts["joints"], int(last["microcracks"]))
        self.assertEqual(counts["connected_joints"], int(last["connected_microcracks"]))
        for key in ("broken_length_m", "connected_length_m"):
            self.assertAlmostEqual(joints[key], sum(float(f[key]) for f in each), places=9)
            self.assertAlmostEqual(joints[key], float(last[key]), places=9)
        length = sum(float(c["length_m"]) for c in cracks if c["place"] == "joint")
        self.assertAlmostEqual(joints["broken_length_m"], length, places=8)
        broken = [f for f in each if float(f["broken_length_m"]) > 0]
        mean = (sum(float(f["mean_slip_m"]) * float(f["broken_length_m"]) for f in broken) /
                joints["broken_length_m"])
        self.assertAlmostEqual(joints["mean_slip_m"] / mean, 1, places=8)
        largest = max(float(f["largest_slip_m"]) for f in each)
        self.assertAlmostEqual(joints["largest_slip_m"] / largest, 1, places=8)

    def test_the_default_fractures_are_those_of_the_shipped_file(self):
        # Nothing runs for long: the specimen is that of the paper, only coarser.
        self.succeed("--set", "specimen.grains=700", "--set", "specimen.radius_min=0.016",
                     "--set", "specimen.radius_max=0.024", "--set", "crack.length=0.15",
                     "--set", "fractures.clearance=0.06", "--set", "run.end_time=0.001",
                     out="default")
        ends = [list(f.values()) for f in self.table("fractures.csv", "default")]
        with open(SHIPPED, newline="") as file:
            shipped = list(csv.reader(line for line in file if not line.startswith("#")))[1:]
        self.assertEqual(ends, shipped)

    def test_a_case_of_the_paper_sets_its_stresses_and_its_time(self):
        for case, yy in (("N2-S1", 12e6), ("N2-S2", 15e6)):
            self.succeed("--case", case, *SHORT, out=case)
            self.assertEqual(self.config(case)["in_situ"], {"xx": 10e6, "yy": yy})
        self.refuse("--case", "2-S1", words=["--case", "N2-S1"])

    def test_a_viscous_fluid_flows_into_a_natural_fracture(self):
        self.succeed("--quick", "--case", "N1-S1", "--set", "fluid.viscosity=0.001", "--fractures",
                     str(self.path("across.csv")), out="viscous")
        self.assertEqual(self.config("viscous")["in_situ"]["yy"], 12e6)
        summary = self.summary("viscous")
        self.assertEqual(summary["scheme"], "implicit")
        self.assertLess(summary["fluid_balance_relative_error"], 1e-10)
        self.assertGreater(summary["microcracks"]["connected_joints"], 0)
        self.assertGreater(summary["pressure_drop_Pa"], 1e5)

    def test_config_toml_and_the_fractures_repeat_a_run_on_any_number_of_threads(self):
        self.succeed("--config", str(self.path("across") / "config.toml"), "--threads", "2",
                     "--fractures", str(self.path("across") / "fractures.csv"), out="repeated")
        for name in ("history.csv", "joints.csv", "natural_fractures.csv", "cracks.csv",
                     "fractures.csv", "fracture.svg", "joints.svg", "energy.csv"):
            self.assertEqual((self.path("across") / name).read_bytes(),
                             (self.path("repeated") / name).read_bytes(), name)

    def test_random_fractures_are_another_set(self):
        self.succeed(*SHORT, "--random-fractures", "3", "--set", "run.end_time=0.002", out="three")
        self.succeed(*SHORT, "--set", "fractures.seed=3", "--set", "run.end_time=0.002", out="same")
        self.succeed(*SHORT, "--set", "run.end_time=0.002", out="other")
        self.assertEqual(len(self.table("fractures.csv", "three")), 5)
        self.assertEqual(self.table("fractures.csv", "three"), self.table("fractures.csv", "same"))
        self.assertNotEqual(self.table("fractures.csv", "three"),
                            self.table("fractures.csv", "other"))

    def test_several_rocks_have_the_same_fractures(self):
        self.succeed(*SHORT, "--seeds", "2", "--fractures", str(self.path("across.csv")),
                     out="rocks")
        counts = []
        for seed in (1, 2):
            self.assertEqual(self.table("fractures.csv", f"rocks/seed_{seed}"),
                             self.table("fractures.csv", "across"))
            counts.append(self.summary(f"rocks/seed_{seed}")["microcracks"])
        summary = self.summary("rocks")
        for key in ("rock", "joints", "connected_joints"):
            self.assertEqual(summary["microcracks"][key], sum(c[key] for c in counts) / 2)

    def test_bad_fractures_are_refused_with_their_line(self):
        bad = self.path("bad.csv")
        for rows, words in (("0.1,0.1,0.2\n", ["line 2 of", "3 columns"]),
                            ("0.1,0.1,0.2,0.2\n0.1,0.1,0.2,0.5\n", ["line 3 of", "0.32 m"]),
                            ("0.1,0.1,0.2,0.15\n0.1,0.1,0.2,0.2\n", ["line 3 of", "injection"])):
            bad.write_text("x1_m,y1_m,x2_m,y2_m\n" + rows)
            self.refuse("--quick", "--fractures", str(bad), words=["bad.csv", *words])
        self.refuse("--quick", "--fractures", "none.csv", words=["--fractures"])
        self.refuse("--quick", "--set", "fractures.count=500", words=["fractures.count"])
        self.assertFalse((self.path("refused") / "summary.json").exists())


if __name__ == "__main__":
    unittest.main()
