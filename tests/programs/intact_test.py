"""The program intact as a user meets it: files, cases, seeds, specimens, ends of runs, errors.

    python3 tests/programs/intact_test.py build/release/examples/intact
"""

import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import tomllib
import unittest
import xml.etree.ElementTree

INTACT = sys.argv.pop(1)
TABLES = ["history.csv", "profile.csv", "cracks.csv", "specimen.txt"]
FIGURES = ["fracture.svg", "aperture_map.svg", "pressure_map.svg", "stress.svg", "pressure.svg",
           "tips.svg", "length.svg", "aperture.svg"]
NUMBERS = """first_break_pressure_Pa breakdown_pressure_Pa propagation_pressure_Pa tip_distance_m
    crack_path_length_m tortuosity asymmetry mean_aperture_m fluid_volume_m2 crack_volume_m2 E_Pa
    poisson_ratio fluid_steps mechanical_steps wall_s threads""".split()
SHORT = ["--quick", "--set", "run.end_time=0.05", "--set", "readings.propagation_from=0.02",
         "--set", "readings.propagation_to=0.05"]


class IntactTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.done = cls.run_intact("--quick", out="quick")

    @classmethod
    def path(cls, name):
        return pathlib.Path(cls.folder.name) / name

    @classmethod
    def run_intact(cls, *options, out):
        return subprocess.run([INTACT, "--out", str(cls.path(out)), *options], text=True,
                              capture_output=True)

    def succeed(self, *options, out):
        done = self.run_intact(*options, out=out)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done

    def refuse(self, *options, words):
        done = self.run_intact(*options, out="refused")
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)

    def summary(self, out):
        return json.loads((self.path(out) / "summary.json").read_text())

    def table(self, name, out):
        with open(self.path(out) / name, newline="") as file:
            return list(csv.DictReader(file))

    def config(self, out):
        return tomllib.loads((self.path(out) / "config.toml").read_text())

    def check_same_results(self, a, b):
        for name in TABLES + FIGURES:
            self.assertEqual((self.path(a) / name).read_bytes(), (self.path(b) / name).read_bytes(), name)
        one, other = self.summary(a), self.summary(b)
        for varying in ("wall_s", "particle_steps_per_s", "threads"):
            del one[varying], other[varying]
        self.assertEqual(one, other)

    def test_a_quick_run_writes_everything(self):
        self.assertEqual(self.done.returncode, 0, self.done.stderr)
        for words in ("breakdown", "tortuosity", "report.html"):
            self.assertIn(words, self.done.stdout)
        summary = self.summary("quick")
        for name in NUMBERS:
            self.assertIsInstance(summary[name], (int, float), name)
        self.assertEqual(summary["discs"], 1800)
        self.assertIsNone(summary["reached_rim_at_s"])
        self.assertAlmostEqual(summary["E_Pa"] / 29.8e9, 1, delta=0.06)
        for name in FIGURES:
            root = xml.etree.ElementTree.parse(self.path("quick") / name).getroot()
            self.assertTrue(root.tag.endswith("svg"))
        self.assertTrue("<svg" in (self.path("quick") / "report.html").read_text())

    def test_the_summary_agrees_with_the_tables(self):
        summary = self.summary("quick")
        history, cracks = self.table("history.csv", "quick"), self.table("cracks.csv", "quick")
        last = {name: float(value) for name, value in history[-1].items()}
        for key, column in (("tip_distance_m", "tip_distance_m"), ("tortuosity", "tortuosity"),
                            ("total_length_m", "total_length_m"),
                            ("crack_path_length_m", "crack_path_length_m"),
                            ("injection_pressure_Pa", "injection_pressure_Pa")):
            self.assertAlmostEqual(summary[key] / last[column], 1, places=9)
        counts = summary["microcracks"]
        self.assertEqual(counts["tension"], sum(c["mode"] == "tension" for c in cracks))
        self.assertEqual(counts["shear"], sum(c["mode"] == "shear" for c in cracks))
        self.assertEqual(counts["rock"], len(cracks))
        self.assertAlmostEqual(summary["first_break_pressure_Pa"] /
                               float(cracks[0]["injection_pressure_Pa"]), 1, places=9)
        peak = max([float(row["injection_pressure_Pa"]) for row in history + cracks])
        self.assertAlmostEqual(summary["breakdown_pressure_Pa"] / peak, 1, places=9)
        window = [float(row["injection_pressure_Pa"]) for row in history
                  if 0.05 + 1e-9 < float(row["time_s"]) <= 0.15 + 1e-9]
        self.assertAlmostEqual(summary["propagation_pressure_Pa"] / (sum(window) / len(window)), 1,
                               places=9)

    def test_the_crack_is_where_its_microcracks_are(self):
        summary = self.summary("quick")
        profile = [{k: float(v) for k, v in row.items()} for row in self.table("profile.csv", "quick")]
        self.assertAlmostEqual(sum(p["length_m"] for p in profile), summary["crack_path_length_m"],
                               places=9)
        along = [p["along_crack_m"] for p in profile]
        self.assertAlmostEqual(max(along) - min(along), summary["tip_distance_m"], delta=0.012)
        self.assertGreater(summary["tortuosity"], 1.2)
        # The path runs along y, the greater stress, and stays near the middle.
        self.assertLess(max(abs(p["x_m"] - 0.16) for p in profile), 0.06)

    def test_a_case_of_the_paper_sets_its_stresses_and_its_time(self):
        for case, yy, end in (("2-S1", 12e6, 1.5), ("2-S2", 15e6, 0.9)):
            # Parameters that are set by hand count more than the case's.
            self.succeed("--case", case, *SHORT, out=case)
            config = self.config(case)
            self.assertEqual(config["in_situ"], {"xx": 10e6, "yy": yy})
            self.assertEqual(config["run"]["end_time"], 0.05)
        self.refuse("--case", "3-S1", words=["--case", "2-S1"])

    def test_a_viscous_case_has_a_fluid_that_flows(self):
        self.succeed(*SHORT, out="slick")
        for case, yy in (("1-S1", 12e6), ("1-S2", 15e6)):
            self.succeed("--case", case, *SHORT, out=case)
            config = self.config(case)
            self.assertEqual(config["in_situ"], {"xx": 10e6, "yy": yy})
            self.assertEqual(config["fluid"]["viscosity"], 0.1)
            summary = self.summary(case)
            self.assertEqual(summary["scheme"], "implicit")
            self.assertLess(summary["fluid_balance_relative_error"], 1e-10)
        viscous, slick = self.summary("1-S1"), self.summary("slick")
        self.assertEqual(slick["pressure_drop_Pa"], 0)
        self.assertGreater(viscous["pressure_drop_Pa"], 1e6)
        self.assertGreater(viscous["propagation_pressure_Pa"], slick["propagation_pressure_Pa"])
        self.assertLess(viscous["tip_distance_m"], slick["tip_distance_m"])
        self.assertIn("a fluid of 100 cp", (self.path("1-S1") / "report.html").read_text())
        self.succeed("--config", str(self.path("1-S1") / "config.toml"), out="again")
        self.check_same_results("1-S1", "again")
        self.refuse("--case", "1-S1", "--scheme", "uniform", words=["1-S1", "viscous", "implicit"])
        self.succeed("--scheme", "implicit", *SHORT, out="flows")  # of the usual case
        self.assertEqual(self.config("flows")["fluid"]["viscosity"], 6e-5)
        self.assertEqual(self.config("1-S1")["injection"]["rise"], 0.05)
        self.assertEqual(self.config("flows")["injection"]["rise"], 0)

    def test_the_preset_of_the_paper_is_what_it_says(self):
        self.succeed("--preset", "paper", *SHORT, out="preset")
        config = self.config("preset")
        self.assertEqual(config["channels"]["length"], "bond")
        self.assertEqual(config["boundary"]["kind"], "dead_loads")
        self.assertEqual(config["scheme"]["max_mechanical_steps"], 10)
        self.assertTrue("found by trial" in (self.path("preset") / "report.html").read_text())

    def test_a_seed_is_a_rock_and_threads_change_nothing(self):
        self.succeed(*SHORT, "--seed", "7", out="seven")
        self.succeed(*SHORT, "--seed", "7", "--threads", "2", out="again")
        self.check_same_results("seven", "again")
        self.succeed(*SHORT, "--seed", "8", out="eight")
        self.assertNotEqual(self.summary("seven")["first_break_pressure_Pa"],
                            self.summary("eight")["first_break_pressure_Pa"])

    def test_config_toml_repeats_a_run(self):
        self.succeed("--config", str(self.path("quick") / "config.toml"), out="repeated")
        self.check_same_results("quick", "repeated")

    def test_a_specimen_file_takes_the_place_of_the_packing(self):
        self.succeed(*SHORT, "--seed", "3", out="packed")
        self.succeed(*SHORT, "--specimen", str(self.path("packed") / "specimen.txt"), out="read")
        one, other = self.summary("packed"), self.summary("read")
        for key in ("first_break_pressure_Pa", "tip_distance_m", "bonds", "mechanical_steps"):
            self.assertEqual(one[key], other[key], key)
        cut = self.path("cut.txt")
        whole = (self.path("packed") / "specimen.txt").read_text()
        cut.write_text(whole[:len(whole) // 2])
        self.refuse(*SHORT, "--specimen", str(cut), words=["cut.txt"])
        self.refuse("--specimen", str(cut), "--seed", "3", words=["--seed"])

    def test_reaching_the_rim_is_a_normal_end(self):
        done = self.succeed("--quick", "--set", "run.end_time=2", out="rim")
        self.assertIn("reached the rim", done.stdout)
        summary = self.summary("rim")
        self.assertNotIn("stopped", summary)
        self.assertEqual(summary["reached_rim_at_s"], summary["time_s"])
        self.assertLess(summary["time_s"], 2)
        self.assertTrue("reached the rim" in (self.path("rim") / "report.html").read_text())

    def test_several_seeds_give_means_with_intervals(self):
        self.succeed(*SHORT, "--seed", "7", "--seeds", "3", out="three")
        rows = self.table("seeds.csv", "three")
        self.assertEqual([row["seed"] for row in rows], ["7", "8", "9"])
        values = [self.summary(f"three/seed_{s}")["breakdown_pressure_Pa"] for s in (7, 8, 9)]
        summary = self.summary("three")
        mean = sum(values) / 3
        self.assertAlmostEqual(summary["breakdown_pressure_Pa"] / mean, 1, places=9)
        deviation = math.sqrt(sum((v - mean) ** 2 for v in values) / 2)
        # Student's t for 95 % and two degrees of freedom is 4.303.
        self.assertAlmostEqual(summary["breakdown_pressure_Pa_ci95"] /
                               (4.303 * deviation / math.sqrt(3)), 1, places=3)
        self.assertTrue("3 rocks" in (self.path("three") / "report.html").read_text())

    def test_bad_input_is_refused_in_a_sentence(self):
        self.refuse("--set", "specimen.grains=-5", words=["specimen.grains", "-5", "at least 1"])
        self.refuse("--set", "specimen.radius_max=2", words=["specimen.radius_max", "at most"])
        self.refuse("--quick", "--set", "specimen.grains=4000", words=["specimen.grains"])
        self.refuse("--set", "channels.length=\"metres\"", words=["channels.length", "centroids"])
        self.refuse("--seeds", "0", words=["--seeds"])
        self.refuse("--preset", "guess", words=["--preset"])
        self.assertFalse((self.path("refused") / "summary.json").exists())


if __name__ == "__main__":
    unittest.main()
