"""The program kgd as a user meets it: files, repeatability, errors, exit status.

    python3 tests/programs/kgd_test.py build/release/examples/kgd
"""

import csv
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

KGD = sys.argv.pop(1)
TABLES = ["history.csv", "profile.csv", "cracks.csv"]
FIGURES = ["aperture.svg", "length.svg", "pressure.svg", "specimen.svg"]
NUMBERS = """time_s full_length_m tip_up_m tip_down_m aperture_at_injection_m opening_at_injection_m
    injection_pressure_Pa net_pressure_Pa first_break_pressure_Pa peak_pressure_Pa fluid_volume_m2
    crack_volume_m2 broken_bonds broken_bonds_off_plane E_Pa poisson_ratio fluid_steps
    mechanical_steps wall_s particle_steps_per_s threads""".split()


class KgdTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return pathlib.Path(self.folder.name) / name

    def run_kgd(self, *options, out="out", status=0):
        done = subprocess.run([KGD, "--out", str(self.path(out)), *options], text=True,
                              capture_output=True)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return done

    def summary(self, out="out"):
        return json.loads((self.path(out) / "summary.json").read_text())

    def table(self, name, out="out"):
        with open(self.path(out) / name, newline="") as file:
            return list(csv.DictReader(file))

    def check_same_results(self, a, b):
        for name in TABLES + FIGURES:
            self.assertEqual((self.path(a) / name).read_bytes(), (self.path(b) / name).read_bytes(), name)
        one, other = self.summary(a), self.summary(b)
        for varying in ("wall_s", "particle_steps_per_s", "threads"):
            del one[varying], other[varying]
        self.assertEqual(one, other)

    def test_a_quick_run_writes_everything(self):
        done = self.run_kgd("--quick")
        self.assertIn("crack length", done.stdout)
        summary = self.summary()
        for name in NUMBERS:
            self.assertIsInstance(summary[name], (int, float), name)
        self.assertEqual(summary["rule"], "paper")
        self.assertEqual(summary["paper"]["full_length_m"]["reference"], 0.770)
        self.assertAlmostEqual(summary["E_Pa"] / 34e9, 1, delta=1e-3)
        self.assertAlmostEqual(summary["fluid_volume_m2"], 0.5e-4 * 0.2, delta=1e-15)
        self.assertEqual(summary["broken_bonds_off_plane"], 0)
        self.assertEqual(summary["tip_up_m"], summary["tip_down_m"])
        for name in FIGURES:
            root = xml.etree.ElementTree.parse(self.path("out") / name).getroot()
            self.assertTrue(root.tag.endswith("svg"))

    def test_the_tables_agree_with_the_summary_and_with_each_other(self):
        self.run_kgd("--quick", "--quiet")
        summary, history = self.summary(), self.table("history.csv")
        profile, cracks = self.table("profile.csv"), self.table("cracks.csv")
        last = history[-1]
        for column in ("time_s", "full_length_m", "aperture_at_injection_m", "injection_pressure_Pa",
                       "crack_volume_m2"):
            self.assertAlmostEqual(float(last[column]) / summary[column], 1, delta=1e-8)
        self.assertEqual(len(history), 2000)
        self.assertTrue(all(row["tip_up_m"] == row["tip_down_m"] for row in history))
        self.assertEqual(len(cracks), summary["broken_bonds"])
        self.assertEqual(len(profile), summary["broken_bonds"] + summary["preset_contacts"])
        self.assertAlmostEqual(sum(0.01 * float(p["opening_m"]) for p in profile)
                               / summary["crack_volume_m2"], 1, delta=1e-8)
        self.assertEqual({c["mode"] for c in cracks}, {"tension"})
        self.assertTrue(all(float(c["length_m"]) == 0.01 for c in cracks))

    def test_the_same_bytes_again_from_its_own_parameters_and_with_two_threads(self):
        self.run_kgd("--quick", "--quiet", "--set", "scheme.equilibrium=true",
                     "--set", "run.end_time=0.05", out="first")
        config = str(self.path("first") / "config.toml")
        self.run_kgd("--quiet", "--config", config, out="again")
        self.check_same_results("first", "again")
        self.assertEqual((self.path("first") / "config.toml").read_bytes(),
                         (self.path("again") / "config.toml").read_bytes())
        self.run_kgd("--quiet", "--config", config, "--threads", "2", out="threads")
        self.check_same_results("first", "threads")

    def test_quiet_prints_nothing_and_progress_stays_off_where_nobody_looks(self):
        done = self.run_kgd("--quick", "--quiet", "--set", "run.end_time=0.01")
        self.assertEqual(done.stdout + done.stderr, "")

    def test_every_parameter_of_the_file_can_be_set(self):
        self.run_kgd("--quick", "--quiet", "--set", "run.end_time=0.001")
        for line in (self.path("out") / "config.toml").read_text().splitlines():
            if line.startswith("["):
                section = line.strip("[]")
            elif line:
                key, value = line.split("#")[0].split("=")
                if section != "run":
                    self.run_kgd("--quick", "--quiet", "--set", "run.end_time=0.001",
                                 "--set", f"{section}.{key.strip()}={value.strip()}")

    def test_bad_input_is_refused_with_the_field_the_value_and_the_range(self):
        for setting, words in {
            "contact.E=-1": ["contact.E", "-1", "Pa", "greater than 0"],
            "contact.E=nan": ["contact.E", "nan", "greater than 0"],
            "mechanics.damping=1": ["mechanics.damping", "1", "less than 1"],
            "specimen.columns=1": ["specimen.columns", "1", "at least 2"],
            "specimen.columns=7.5": ["specimen.columns", "7.5", "whole number"],
            "scheme.equilibrium=2": ["scheme.equilibrium", "2", "true or false"],
            "boundary.kind=rubber": ["boundary.kind", "rubber", "servo", "frozen", "dead_loads"],
            "injection.position=[2, 0.1]": ["injection.position", "[2, 0.1]", "inside the specimen"],
            "injection.position=3": ["injection.position", "3", "[x, y]"],
            "injection.position=[[0.1, 0.1]]": ["injection.position", "[[0.1, 0.1]]", "[x, y]"],
            "injection.schedule=[0.1, 1e-4]": ["injection.schedule", "[0.1, 1e-04]",
                                               "[[time, rate], ...]"],
            "injection.schedule=[[0.1, 1e-4, 2]]": ["injection.schedule", "[[0.1, 1e-04, 2]]",
                                                    "list of"],
            "injection.schedule=[[0.2, 1e-4], [0.1, 0]]": ["injection.schedule, entry 2, time",
                                                           "0.1 s", "greater than 0.2 s"],
            "injection.further_points=7": ["injection.further_points", "7", "[[x, y], ...]"],
            "injection.further_points=[[2, 0.1]]": ["injection.further_points, entry 1",
                                                    "[2, 0.1]", "inside the specimen"],
            "crack.contacts=0": ["crack.contacts", "0", "at least 1"],
            "crack.contacts=999": ["crack.contacts", "999", "at most 40"],
            "contact.Young=1": ["Young", "contact", "tensile_strength"],
            "rock.E=1": ["rock", "contact", "scheme"],
            "nonsense": ["nonsense", "section.key=value"],
        }.items():
            with self.subTest(setting):
                done = self.run_kgd("--quick", "--set", setting, status=2)
                for word in words:
                    self.assertIn(word, done.stderr)
                self.assertEqual(done.stdout, "")

    def test_a_bad_file_is_refused_with_its_line(self):
        file = self.path("bad.toml")
        for text, words in {
            "[contact]\nE = 1e9\nF = 2": ["line 3", "F", "contact"],
            "[contact]\nE = = 2": ["line 2"],
            "E = 2": ["line 1", "outside of a [section]"],
            "[contact]\nE = [1, 2, 3]": ["line 2", "contact.E"],
        }.items():
            file.write_text(text)
            done = self.run_kgd("--config", str(file), status=2)
            for word in words + ["bad.toml"]:
                self.assertIn(word, done.stderr)
        self.run_kgd("--config", str(self.path("missing.toml")), status=2)

    def test_the_command_line_itself(self):
        self.assertEqual(subprocess.run([KGD, "--help"], capture_output=True).returncode, 0)
        self.assertEqual(subprocess.run([KGD], capture_output=True).returncode, 2)
        self.run_kgd("--no-such-option", status=2)
        self.run_kgd("--threads", "0", status=2)

    def test_a_folder_that_cannot_be_written_is_said(self):
        self.path("file").write_text("in the way")
        done = self.run_kgd("--quick", out="file/out", status=1)
        self.assertIn("file/out", done.stderr)

    def test_a_crack_at_the_rim_stops_the_run_and_keeps_what_was_written(self):
        done = self.run_kgd("--quick", "--set", "run.end_time=2", status=3)
        self.assertIn("rim", done.stderr)
        self.assertIn("rim", self.summary()["stopped"])
        self.assertEqual(self.summary()["broken_bonds"], 36)
        self.assertGreater(len(self.table("history.csv")), 1000)

    def test_a_crack_that_runs_away_from_its_fluid_is_said(self):
        for gain in ("5e3", "1e9"):
            done = self.run_kgd("--quick", "--set", f"scheme.alpha={gain}",
                                "--set", "scheme.max_pressure_step=1e9", out=gain, status=3)
            self.assertIn("ran away", done.stderr)
            self.assertIn("scheme.alpha", done.stderr)
            self.assertIn("ran away", self.summary(gain)["stopped"])

    def test_the_books_of_energy_close_in_the_table_and_in_the_summary(self):
        options = ["--quick", "--set", "run.energy=true", "--set", "run.end_time=0.05"]
        self.run_kgd("--quiet", *options)
        summary = self.summary()
        self.assertLess(summary["energy_balance_relative_error"], 1e-9)
        self.assertGreater(summary["energy_balance_relative_error"], 0)
        entries = {name.removesuffix("_J_per_m"): value for name, value in summary["energy"].items()}
        self.assertGreater(entries["breaks"], 0.01 * entries["net_work"])
        rows = self.table("energy.csv")
        self.assertEqual([row["time_s"] for row in rows],
                         [row["time_s"] for row in self.table("history.csv")])
        for row in rows[9:]:
            e = {name.removesuffix("_J_per_m"): float(value) for name, value in row.items()}
            work = e["boundary_work"] + e["fluid_work"]
            spent = sum(e[name] for name in ("elastic", "kinetic", "friction", "damping", "breaks",
                                             "switching"))
            # ten digits are written
            self.assertLess(abs(work - spent), 1e-8 * (abs(e["boundary_work"]) + e["fluid_work"]))
        for name in ("boundary_work", "fluid_work", "damping", "breaks"):
            self.assertAlmostEqual(float(rows[-1][name + "_J_per_m"]) / entries[name], 1, delta=1e-8)
        self.assertAlmostEqual(entries["spent"], sum(entries[name] for name in
                                                     ("friction", "damping", "breaks")), delta=1e-9)
        page = (self.path("out") / "report.html").read_text()
        self.assertIn("Where the work went", page)

        self.run_kgd("--quiet", *options, "--threads", "2", out="threads")
        self.check_same_results("out", "threads")
        self.assertEqual((self.path("out") / "energy.csv").read_bytes(),
                         (self.path("threads") / "energy.csv").read_bytes())
        self.run_kgd("--quiet", "--quick", "--set", "run.end_time=0.05", out="out")
        self.assertFalse((self.path("out") / "energy.csv").exists())
        for name in TABLES + FIGURES:  # books change nothing
            self.assertEqual((self.path("out") / name).read_bytes(),
                             (self.path("threads") / name).read_bytes(), name)

    def test_other_orientations_and_positions(self):
        self.run_kgd("--quick", "--quiet", "--set", "in_situ.xx=14e6", "--set", "in_situ.yy=10e6",
                     "--set", "injection.position=[0.15, 0.25]", "--set", "run.end_time=0.05")
        for crack in self.table("cracks.csv"):
            self.assertAlmostEqual(float(crack["y_m"]), 0.25, delta=1e-9)
        self.assertEqual(self.summary()["broken_bonds_off_plane"], 0)

    def test_a_schedule_changes_the_rate_and_repeats_itself_from_its_file(self):
        self.run_kgd("--quick", "--quiet", "--set", "run.end_time=0.12", out="constant")
        self.assertNotIn("schedule", (self.path("constant") / "config.toml").read_text())
        self.run_kgd("--quick", "--quiet", "--set", "run.end_time=0.12",
                     "--set", "injection.schedule=[[0.04, 1.5e-4], [0.08, 0]]", out="steps")
        constant, steps = self.summary("constant"), self.summary("steps")
        self.assertAlmostEqual(steps["fluid_volume_m2"] / (0.04 * 0.5e-4 + 0.04 * 1.5e-4), 1,
                               delta=1e-12)
        # Without viscosity and leak-off the KGD fracture is as long as V^(2/3).
        volumes = steps["fluid_volume_m2"] / constant["fluid_volume_m2"]
        lengths = (steps["kgd"]["full_length_m"]["reference"]
                   / constant["kgd"]["full_length_m"]["reference"])
        self.assertAlmostEqual(lengths / volumes ** (2 / 3), 1, delta=1e-9)
        self.assertIn("at first, then by a schedule", (self.path("steps") / "report.html").read_text())
        config = self.path("steps") / "config.toml"
        self.assertIn("schedule = [[0.04, 0.00015], [0.08, 0]]", config.read_text())
        self.run_kgd("--quiet", "--config", str(config), out="again")
        self.check_same_results("steps", "again")
        self.run_kgd("--quiet", "--config", str(config), "--set", "injection.schedule=[]", out="none")
        self.check_same_results("constant", "none")

    def test_several_points_drive_a_crack_each(self):
        self.run_kgd("--quick", "--quiet", "--set", "injection.position=[0.1, 0.2]",
                     "--set", "injection.further_points=[[0.3, 0.2]]", "--set", "run.end_time=0.05")
        self.assertEqual(self.summary()["preset_contacts"], 8)
        self.assertEqual({round(float(crack["x_m"]), 9) for crack in self.table("cracks.csv")},
                         {0.1, 0.3})
        self.assertIn("through 2 points", (self.path("out") / "report.html").read_text())

    def test_a_viscous_crack_is_shorter_wider_and_under_more_pressure_with_both_schemes(self):
        short = ("--quick", "--quiet", "--set", "run.end_time=0.05", "--set", "fluid.viscosity=0.1")
        for scheme in ("uniform", "implicit", "conventional"):
            self.run_kgd(*short, "--scheme", scheme, out=scheme)
        uniform, implicit, explicit = (self.summary(s) for s in ("uniform", "implicit", "conventional"))
        for name in ("full_length_m", "aperture_at_injection_m", "net_pressure_Pa"):
            self.assertAlmostEqual(implicit[name] / explicit[name], 1, delta=0.02, msg=name)
        self.assertLess(implicit["full_length_m"], uniform["full_length_m"])
        self.assertGreater(implicit["aperture_at_injection_m"],
                           1.1 * uniform["aperture_at_injection_m"])
        self.assertGreater(implicit["net_pressure_Pa"], 1.5 * uniform["net_pressure_Pa"])
        for summary in (uniform, implicit, explicit):
            self.assertLess(summary["fluid_balance_relative_error"], 1e-10)
        # The widest channel limits explicit flow.
        profile = self.table("profile.csv", "conventional")
        widest = max(profile, key=lambda row: float(row["aperture_m"]))
        self.assertAlmostEqual(explicit["flow_limit"]["y_m"], float(widest["y_m"]), delta=0.011)
        width, length = float(widest["aperture_m"]), 0.01
        self.assertAlmostEqual(explicit["flow_limit"]["time_step_s"] /
                               (6 * 0.1 * length ** 2 / (2e9 * width ** 2)), 1, delta=0.1)
        # The pressure falls along the crack.
        pressure = [float(row["pressure_Pa"]) for row in self.table("profile.csv", "implicit")]
        self.assertLess(pressure[0], 0.9 * max(pressure))
        page = {s: (self.path(s) / "report.html").read_text() for s in ("uniform", "implicit")}
        self.assertIn("a fluid of 100 cp", page["implicit"])
        # Who asks for a viscosity and lets no fluid flow is told what that leaves out.
        lengths = [s["kgd"]["full_length_m"]["reference"] for s in (implicit, uniform)]
        self.assertIn("Uniform pressure leaves viscosity out: 100 cp make the KGD fracture "
                      f"{100 * (1 - lengths[0] / lengths[1]):.0f} % shorter.", page["uniform"])
        self.assertNotIn("leaves viscosity out", page["implicit"])
        self.assertNotIn("leaves viscosity out", self.run_kgd("--quick", out="thin").stdout)

    def test_a_parameter_file_knows_its_scheme(self):
        for scheme in ("implicit", "conventional"):
            self.run_kgd("--quick", "--quiet", "--scheme", scheme, "--set", "run.end_time=0.002",
                         "--set", "fluid.viscosity=0.1", out=scheme)
            self.run_kgd("--quiet", "--config", str(self.path(scheme) / "config.toml"), out="again")
            self.check_same_results(scheme, "again")
            self.assertEqual(self.summary("again")["scheme"], scheme)

    def test_bad_fluids_and_schemes_are_refused(self):
        for setting, words in {
            "fluid.viscosity=0": ["fluid.viscosity", "0 Pa s", "greater than 0"],
            "fluid.bulk_modulus=-1": ["fluid.bulk_modulus", "-1 Pa", "greater than 0"],
            "scheme.fluid_dt=0": ["scheme.fluid_dt", "0 s", "greater than 0"],
            "scheme.volume_tolerance=2": ["scheme.volume_tolerance", "2", "at most 1"],
            "scheme.alpha=1": ["alpha", "pressure_floor"],
        }.items():
            done = self.run_kgd("--quick", "--scheme", "implicit", "--set", setting, out="bad", status=2)
            for word in words:
                self.assertIn(word, done.stderr)
        done = self.run_kgd("--scheme", "magic", out="bad", status=2)
        for word in ("--scheme", "magic", "implicit"):
            self.assertIn(word, done.stderr)


if __name__ == "__main__":
    unittest.main()
