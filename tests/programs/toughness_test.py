"""The program toughness, and kgd with what it measured.

    python3 tests/programs/toughness_test.py build/release/examples/toughness build/release/examples/kgd
"""

import csv
import json
import math
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
import tomllib
import unittest

TOUGHNESS, KGD = sys.argv.pop(1), sys.argv.pop(1)
SHIPPED = pathlib.Path(__file__).resolve().parents[2] / "examples/data/toughness.toml"


class ToughnessTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.slits = cls.run_program(TOUGHNESS, "--quick", out="slits")

    @classmethod
    def path(cls, name):
        return pathlib.Path(cls.folder.name) / name

    @classmethod
    def run_program(cls, program, *options, out):
        return subprocess.run([program, "--out", str(cls.path(out)), *options], text=True,
                              capture_output=True)

    def summary(self, out):
        return json.loads((self.path(out) / "summary.json").read_text())

    def refused(self, program, *options, words):
        done = self.run_program(program, *options, out="refused")
        self.assertEqual(done.returncode, 2, done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)

    def changed_file(self, pattern, replacement):
        text, count = re.subn(pattern, replacement, SHIPPED.read_text(), flags=re.M)
        self.assertEqual(count, 1)
        file = self.path("changed.toml")
        file.write_text(text)
        return str(file)

    def test_it_writes_its_answer(self):
        self.assertEqual(self.slits.returncode, 0, self.slits.stderr)
        summary = self.summary("slits")
        # The closed form of the infinite orthotropic plane: E' = 2 E / sqrt(2 + 2 rho), rho = 2.5.
        self.assertAlmostEqual(summary["E_prime_over_E"], 2 / 7 ** 0.5, delta=0.01)
        self.assertEqual(len(summary["slits"]), 3)
        page = (self.path("slits") / "report.html").read_text()
        self.assertIn("is not one number", page)
        with open(self.path("slits") / "slits.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(sum(float(row["breaks"]) for row in rows), 3)
        for figure in ("toughness.svg", "opening.svg"):
            self.assertIn("<svg", (self.path("slits") / figure).read_text())

    def test_its_file_repeats_its_summary(self):
        summary = self.summary("slits")
        file = tomllib.loads((self.path("slits") / "toughness.toml").read_text())
        self.assertAlmostEqual(file["toughness"]["E_prime"] / summary["E_prime_Pa"], 1, places=9)
        self.assertEqual(file["specimen"]["columns"], 40)

    def test_the_shipped_file_is_of_the_default_lattice(self):
        file = tomllib.loads(SHIPPED.read_text())
        self.assertEqual(file["specimen"]["columns"], 100)
        self.assertAlmostEqual(file["toughness"]["E_prime"], 25.70e9, delta=0.01 * 25.70e9)
        self.assertAlmostEqual(file["toughness"]["K_IC"], 1.564e6, delta=0.03 * 1.564e6)
        self.assertAlmostEqual(file["toughness"]["K_IC_per_pressure"], 0.0588, delta=0.03 * 0.0588)

    def test_kgd_stands_beside_what_the_slits_predict(self):
        done = self.run_program(KGD, "--quick", "--toughness", str(SHIPPED), "--set",
                                "scheme.equilibrium=true", out="predicted")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("predicted from slits", done.stdout)
        toughness = self.summary("predicted")["toughness"]
        self.assertTrue(toughness["same_lattice"])
        self.assertEqual(toughness["regime"], "storage-toughness")
        # K_m = (K'^4 / (mu' E'^3 Q))^(1/4)
        K_prime = 4 * (2 / 3.141592653589793) ** 0.5 * toughness["K_IC_Pa_sqrt_m"]
        K_m = (K_prime ** 4 / (12 * 6e-5 * toughness["E_prime_Pa"] ** 3 * 0.5e-4)) ** 0.25
        self.assertAlmostEqual(toughness["K_m"] / K_m, 1, places=6)
        self.assertEqual(toughness["tau"], 0)
        predicted = toughness["in_specimen"]
        self.assertLess(abs(predicted["full_length_m"]["relative_difference"]), 0.03)
        self.assertLess(abs(predicted["opening_at_injection_m"]["relative_difference"]), 0.03)
        page = (self.path("predicted") / "report.html").read_text()
        self.assertIn("Prediction from measured toughness", page)
        self.assertNotIn("Beware", page)
        self.assertIn("predicted from slits", (self.path("predicted") / "length.svg").read_text())

    def test_kgd_says_that_the_slits_were_of_another_lattice(self):
        done = self.run_program(KGD, "--quick", "--toughness", str(SHIPPED), "--set",
                                "contact.tensile_strength=9e6", out="other")
        self.assertIn("contact.tensile_strength is 9e+06, and was 8e+06 for the slits", done.stdout)
        self.assertFalse(self.summary("other")["toughness"]["same_lattice"])
        self.assertIn("Beware", (self.path("other") / "report.html").read_text())

    def test_a_run_too_short_for_a_growing_crack_says_so(self):
        done = self.run_program(KGD, "--quick", "--toughness", str(SHIPPED), "--set",
                                "run.end_time=0.001", out="short")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("too short to grow steadily", done.stdout)
        self.assertNotIn("in_infinite_plane", self.summary("short")["toughness"])
        self.assertNotIn("inf ", done.stdout)

    def test_kgd_runs_where_slits_predict_nothing(self):
        done = self.run_program(KGD, "--quick", "--toughness", str(SHIPPED), "--set",
                                "specimen.rows=100", "--set", "run.end_time=0.01", out="oblong")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("no prediction from slits: specimen.rows = 100", done.stdout)
        self.assertIn("specimen.rows", self.summary("oblong")["toughness"]["no_prediction"])

    def test_kgd_says_that_the_injection_is_not_in_the_middle(self):
        done = self.run_program(KGD, "--quick", "--toughness", str(SHIPPED), "--set",
                                "injection.position=[0.1, 0.2]", "--set", "run.end_time=0.02",
                                out="aside")
        self.assertIn("injection.position is not the middle", done.stdout)

    def test_kgd_predicts_nothing_for_changing_rates_and_several_points(self):
        for setting in ("injection.schedule=[[0.01, 0]]", "injection.rise=0.01",
                        "injection.further_points=[[0.1, 0.2]]"):
            done = self.run_program(KGD, "--quick", "--toughness", str(SHIPPED), "--set", setting,
                                    "--set", "run.end_time=0.02", out="other")
            self.assertIn("no prediction from slits: " + setting.split("=")[0], done.stdout)
            self.assertIn("one point and a constant rate", done.stdout)

    def test_files_that_are_no_toughness_files_are_refused(self):
        self.refused(KGD, "--quick", "--toughness", str(self.path("nowhere.toml")), words=["nowhere"])
        self.refused(KGD, "--quick", "--toughness", self.changed_file(r"^E_prime.*\n", ""),
                     words=["no whole toughness file", "toughness.E_prime is missing"])
        self.refused(KGD, "--quick", "--toughness", self.changed_file(r"(?s)^\[contact\].*", ""),
                     words=["no whole toughness file", "contact.E is missing"])
        self.refused(KGD, "--quick", "--toughness", "", words=["--toughness"])
        self.refused(KGD, "--quick", "--toughness", self.changed_file(r"^K_IC = ", "K_1C = "),
                     words=["line 6", "K_1C"])
        self.refused(KGD, "--quick", "--toughness", self.changed_file(r"^K_IC = \S+", "K_IC = -1"),
                     words=["toughness", "K_IC", "-1"])

    def test_slits_that_cannot_be_are_refused(self):
        self.refused(TOUGHNESS, "--set", "slits.count=40", words=["slits.count", "at most 16"])
        self.refused(TOUGHNESS, "--quick", "--set", "in_situ.xx=0", "--set", "in_situ.yy=0",
                     words=["in_situ.xx", "greater than 0"])
        self.refused(TOUGHNESS, "--quick", "--set", "specimen.columns=100",
                     words=["specimen.rows = 40", "half to twice"])
        self.refused(TOUGHNESS, "--quick", "--set", "contact.stiffness_ratio=8", "--set",
                     "contact.bond_stiffness_ratio=8", words=["contact.stiffness_ratio", "0.3 to 6"])
        self.refused(TOUGHNESS, "--set", "slits.longest=4", words=["slits.longest"])
        self.refused(TOUGHNESS, "--set", "slits.longest=120", words=["slits.longest", "at most 90"])

    def test_a_rock_that_breaks_by_itself_or_never_ends_with_a_sentence(self):
        done = self.run_program(TOUGHNESS, "--quick", "--set", "contact.cohesion=0", "--set",
                                "contact.friction_angle=0", "--set", "in_situ.yy=40e6", out="weak")
        self.assertEqual(done.returncode, 3)
        self.assertIn("without any net pressure", done.stderr)

    def test_doubtful_numbers_say_so(self):
        done = self.run_program(TOUGHNESS, "--quick", "--set", "in_situ.xx=1e5", "--set",
                                "in_situ.yy=1e5", out="doubt")
        self.assertIn("Beware: E' of the slits differs by", done.stdout)
        self.assertGreater(self.summary("doubt")["E_prime_spread"], 0.05)


class RandomRockTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.study = cls.run_program(out="study")

    @classmethod
    def path(cls, name):
        return pathlib.Path(cls.folder.name) / name

    @classmethod
    def run_program(cls, *options, out):
        return subprocess.run([TOUGHNESS, "--rock", "random", "--quick", "--out", str(cls.path(out)),
                               *options], text=True, capture_output=True)

    def refused(self, *options, words):
        done = self.run_program(*options, out="refused")
        self.assertEqual(done.returncode, 2, done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)

    def summary(self):
        return json.loads((self.path("study") / "summary.json").read_text())

    def rows(self, name):
        with open(self.path("study") / name, newline="") as file:
            return list(csv.DictReader(file))

    def test_modulus_and_toughness_are_those_of_the_rock(self):
        self.assertEqual(self.study.returncode, 0, self.study.stderr)
        summary = self.summary()
        # Slits in large packings say 31.7 +- 1.6 GPa, and cracks that run through them 2.57 +- 0.31;
        # in one as small as this, tips are near the rim and K is lower.
        self.assertAlmostEqual(summary["E_prime"]["mean_Pa"], 31.7e9, delta=3e9)
        self.assertAlmostEqual(summary["K_IC_above_in_situ"]["mean_Pa_sqrt_m"], 2.4e6, delta=0.4e6)
        # Two other ways to the same modulus.
        self.assertAlmostEqual(summary["E_prime_from_opening"]["mean_Pa"] /
                               summary["E_prime"]["mean_Pa"], 1, delta=0.06)
        self.assertAlmostEqual(summary["E"]["mean_Pa"] / summary["E_prime"]["mean_Pa"], 1,
                               delta=0.1)

    def test_the_answer_is_the_mean_of_the_seeds(self):
        summary = self.summary()
        self.assertEqual([seed["seed"] for seed in summary["seeds"]], [1, 2])
        for key, name in (("E_prime", "E_prime_Pa"), ("K_IC", "K_IC_Pa_sqrt_m")):
            values = [seed[name] for seed in summary["seeds"]]
            unit = name[len(key) + 1:]
            self.assertAlmostEqual(summary[key]["mean_" + unit] / statistics.mean(values), 1,
                                   places=9)
            # Student's t for two samples, to the digits of the textbook: 12.706.
            interval = 12.706 * statistics.stdev(values) / 2 ** 0.5
            self.assertAlmostEqual(summary[key]["interval_95_" + unit] / interval, 1, places=4)
        rock = tomllib.loads((self.path("study") / "toughness.toml").read_text())
        self.assertAlmostEqual(rock["rock"]["K_IC"] / summary["K_IC"]["mean_Pa_sqrt_m"], 1,
                               places=9)
        self.assertAlmostEqual(rock["rock"]["E_prime"] / summary["E_prime"]["mean_Pa"], 1, places=9)
        self.assertEqual(rock["specimen"]["width"], 0.3)

    def test_slits_and_cracks_are_in_its_tables(self):
        slits = self.rows("slits.csv")
        self.assertEqual(len(slits), 2 * 2 * 2)  # seeds, lengths, pressures
        for low, high in zip(slits[::2], slits[1::2]):
            self.assertGreater(float(high["volume_m2"]), float(low["volume_m2"]))
        growth = [row for row in self.rows("growth.csv") if row["seed"] == "1"]
        lengths = [float(row["full_length_m"]) for row in growth]
        self.assertEqual(lengths, sorted(lengths))
        # The crack opens as much as is injected.
        for row in growth[50:]:
            self.assertAlmostEqual(float(row["crack_volume_m2"]) / (0.5e-4 * float(row["time_s"])),
                                   1, delta=2e-3)
        page = (self.path("study") / "report.html").read_text()
        self.assertIn("Why a running crack", page)
        for figure in ("pressure.svg", "opening.svg", "length.svg"):
            self.assertIn("<svg", (self.path("study") / figure).read_text())

    def test_the_predicted_growth_holds_the_injected_volume(self):
        summary = self.summary()
        self.assertGreater(len(summary["growth"]), 1)
        for at in summary["growth"]:
            self.assertAlmostEqual(at["predicted_full_length_m"] / at["full_length"]["mean_m"], 1,
                                   delta=0.15)
            # V = pi / 4 * length * width of an ellipse, nearly.
            volume = math.pi / 4 * at["predicted_full_length_m"] * at["predicted_opening_m"]
            self.assertAlmostEqual(volume / (0.5e-4 * at["time_s"]), 1, delta=0.02)
        self.assertGreater(summary["splitting"]["time_s"], summary["growth"][-1]["time_s"])

    def test_the_number_of_threads_and_a_repetition_change_no_byte(self):
        done = self.run_program("--threads", "2", "--config", str(self.path("study/config.toml")),
                                out="again")
        self.assertEqual(done.returncode, 0, done.stderr)
        for name in ("toughness.toml", "slits.csv", "growth.csv", "config.toml", "length.svg"):
            self.assertEqual((self.path("study") / name).read_bytes(),
                             (self.path("again") / name).read_bytes(), name)

    def test_what_cannot_be_is_refused(self):
        self.refused("--seeds", "0", words=["study.seeds = 0", "at least 1"])
        self.refused("--seed", "-1", words=["specimen.seed = -1"])
        self.refused("--set", "slits.longest=0.28", words=["slits.longest = 0.28 m", "0.27"])
        self.refused("--set", "slits.longest=0.05", words=["slits.longest", "slits.shortest"])
        self.refused("--set", "slits.highest_pressure=1e6", words=["slits.highest_pressure"])
        self.refused("--set", "study.opening_reach=0.05", words=["study.opening_reach", "0.04 m"])
        self.refused("--set", "crack.length=0.1", words=["crack.length = 0.1 m", "0.06 m"])
        self.refused("--set", "running.from=0.7", words=["running.to = 0.6", "running.from"])
        self.refused("--set", "specimen.height=1", words=["specimen.height = 1 m", "half to twice"])
        self.refused("--set", "specimen.columns=40", words=["columns", "radius_min"])
        self.refused("--set", "in_situ.xx=0", "--set", "in_situ.yy=0", words=["in_situ.xx"])
        self.refused("--rock", "granite", words=["--rock"])
        done = subprocess.run([TOUGHNESS, "--quick", "--seeds", "2", "--out", str(self.path("no"))],
                              text=True, capture_output=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("--rock random", done.stderr)

    def test_a_crack_that_does_not_run_is_no_toughness(self):
        done = self.run_program("--seeds", "1", "--set", "study.end_time=0.002", out="short")
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("no crack of 0.06 to 0.18 m ran", done.stderr)
        self.assertFalse((self.path("short") / "summary.json").exists())

    def test_kgd_says_that_the_file_is_of_another_rock(self):
        done = subprocess.run([KGD, "--quick", "--out", str(self.path("kgd")), "--toughness",
                               str(self.path("study/toughness.toml"))], text=True,
                              capture_output=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn('there is no section "rock"', done.stderr)


if __name__ == "__main__":
    unittest.main()
