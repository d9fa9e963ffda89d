"""The program kgd_reference as a user meets it: numbers, units, profiles, refusals.

    python3 tests/programs/kgd_reference_test.py build/release/examples/kgd_reference
"""

import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

KGD_REFERENCE = sys.argv.pop(1)
ROCK = {"--E-prime": "35.1e9", "--K-IC": "1.88e6", "--viscosity": "0", "--leak-off": "0",
        "--rate": "0.5e-4", "--time": "0.9"}
FRACTURE = ("half_length_m", "full_length_m", "aperture_at_injection_m", "net_pressure_Pa",
            "efficiency")


class KgdReferenceTest(unittest.TestCase):
    def run_program(self, *extra, status=0, without=None, **changes):
        options = dict(ROCK)
        options.update({"--" + name.replace("_", "-"): value for name, value in changes.items()})
        options.pop(without, None)
        words = [word for pair in options.items() for word in pair]
        done = subprocess.run([KGD_REFERENCE, *words, *extra], text=True, capture_output=True)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return done

    def answer(self, *extra, **changes):
        return json.loads(self.run_program(*extra, **changes).stdout)

    def check(self, value, reference, tolerance):
        self.assertAlmostEqual(value / reference, 1, delta=tolerance)

    def test_without_viscosity_and_leak_off_it_is_the_papers_equations(self):
        answer = self.answer()
        K = 4 * math.sqrt(2 / math.pi) * 1.88e6
        volume = 0.5e-4 * 0.9
        for fracture in (answer, answer["nearest_vertex"]):
            self.check(fracture["half_length_m"], 0.9324 * (35.1e9 * volume / K) ** (2 / 3), 1e-4)
            self.check(fracture["aperture_at_injection_m"],
                       0.6828 * (K * K * volume / 35.1e9 ** 2) ** (1 / 3), 1e-4)
            self.check(fracture["net_pressure_Pa"], 1.7139e6, 1e-4)
            self.check(fracture["full_length_m"], 0.7660, 1e-4)
            self.assertEqual(fracture["efficiency"], 1)
        self.assertEqual(answer["regime"], "storage-toughness")
        self.assertEqual(answer["nearest_vertex"]["name"], "storage-toughness")
        self.assertLess(answer["nearest_vertex"]["distance"], 1e-9)
        self.assertEqual(answer["tau"], 0)
        self.assertIsNone(answer["K_m"])

    def test_it_takes_viscosity_and_leak_off_in_their_own_units(self):
        # K_m = 2 and tau = 1e-6 in units E' = mu' = Q = C' = 1, from a converged solution.
        answer = self.answer(E_prime="1", K_IC=str(2 / math.sqrt(32 / math.pi)),
                             viscosity=str(1 / 12), leak_off="0.5", rate="1", time="1e-6")
        self.check(answer["tau"], 1e-6, 1e-9)
        self.check(answer["K_m"], 2, 1e-9)
        self.check(answer["half_length_m"], 4.74119e-05, 0.006)
        self.check(answer["aperture_at_injection_m"], 1.19159e-02, 0.009)
        self.check(answer["net_pressure_Pa"], 6.79530e+01, 0.009)
        self.assertAlmostEqual(answer["efficiency"], 0.85909, delta=0.002)
        self.assertEqual(answer["regime"], "transitional")
        self.assertEqual(answer["nearest_vertex"]["name"], "storage-toughness")

    def test_each_corner_of_the_map_is_named_and_close_to_its_vertex(self):
        for changes, name in (({"viscosity": "1e-7"}, "storage-toughness"),
                              ({"viscosity": "1", "K_IC": "0"}, "storage-viscosity"),
                              ({"viscosity": "0", "leak_off": "1"}, "leak-off-toughness"),
                              ({"viscosity": "1", "K_IC": "0", "leak_off": "1"},
                               "leak-off-viscosity")):
            with self.subTest(name):
                answer = self.answer(**changes)
                vertex = answer["nearest_vertex"]
                self.assertEqual(answer["regime"], name)
                self.assertEqual(vertex["name"], name)
                self.assertLess(vertex["distance"], 0.01)
                for number in FRACTURE:
                    self.check(answer[number], vertex[number], 0.01)

    def test_profiles_run_from_the_injection_to_the_tip_and_hold_the_fluid(self):
        answer = self.answer("--profile", "201", viscosity="0.1", leak_off="1e-6")
        profile = answer["profile"]
        x, width, pressure = profile["x_m"], profile["aperture_m"], profile["net_pressure_Pa"]
        self.assertEqual([len(column) for column in profile.values()], [201] * 3)
        self.assertEqual(x[0], 0)
        self.check(x[-1], answer["half_length_m"], 1e-11)
        self.assertEqual(width[0], answer["aperture_at_injection_m"])
        self.assertEqual(width[-1], 0)
        self.assertEqual(pressure[0], answer["net_pressure_Pa"])
        self.assertIsNone(pressure[-1])
        self.assertTrue(all(a > b for a, b in zip(width, width[1:])))
        self.assertTrue(all(a > b for a, b in zip(pressure, pressure[1:-1])))
        volume = sum((a + b) * (x[1] - x[0]) for a, b in zip(width, width[1:]))
        self.check(volume, answer["efficiency"] * 0.5e-4 * 0.9, 2e-3)
        self.assertNotIn("profile", self.answer())

    def test_without_viscosity_the_pressure_is_the_same_all_along(self):
        answer = self.answer("--profile", "5")
        self.assertEqual(answer["profile"]["net_pressure_Pa"], [answer["net_pressure_Pa"]] * 5)
        self.check(answer["profile"]["aperture_m"][2],
                   answer["aperture_at_injection_m"] * math.sqrt(0.75), 1e-11)

    def test_in_a_finite_plate(self):
        # Full length, width in um, net pressure in MPa: complex potentials.
        for sides, numbers in (("stress", (0.7269, 80.87, 1.0082)),
                               ("rigid", (0.7998, 70.18, 1.0772)),
                               ("fixed", (0.7998, 70.18, 3.0120))):
            with self.subTest(sides):
                plate = self.answer("--plate", "1", "--sides", sides, "--poisson", "0.3")["plate"]
                self.assertEqual(plate["sides"], sides)
                self.assertFalse(plate["split"])
                self.check(plate["full_length_m"], numbers[0], 1e-3)
                self.check(plate["half_length_m"], numbers[0] / 2, 1e-3)
                self.check(plate["aperture_at_injection_m"] * 1e6, numbers[1], 1e-3)
                self.check(plate["net_pressure_Pa"] / 1e6, numbers[2], 2e-3)
                self.assertIn("no viscosity, no leak-off", plate["assumes"])
        self.assertNotIn("plate", self.answer())

    def test_a_plate_that_has_split_has_no_crack_to_measure(self):
        plate = self.answer("--plate", "1", "--sides", "rigid", time="1.05")["plate"]
        self.assertTrue(plate["split"])
        self.assertIsNone(plate["full_length_m"])
        self.check(plate["time_at_splitting_s"], 1.00, 0.01)
        self.check(plate["full_length_at_splitting_m"], 0.912, 2e-3)

    def test_the_map_shows_the_fracture_among_the_regimes(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "map.svg"
            answer = self.answer("--map", str(file), viscosity="0.1", leak_off="1e-6")
            root = xml.etree.ElementTree.parse(file).getroot()
            self.assertEqual([f.name for f in file.parent.iterdir()], ["map.svg"])
        texts = {"".join(t.itertext()): t for t in root.iter("{http://www.w3.org/2000/svg}text")}
        for words in ("toughness (K)", "viscosity (M)", "toughness (K~)", "viscosity (M~)",
                      "no leak-off", "this fracture", "storage-viscosity"):
            self.assertIn(words, texts)
        self.assertIn("leak_off = 1e-06\u00a0m/s^0.5", root.find("{http://www.w3.org/2000/svg}desc").text)

        # The one ring is at its tau and K_m by the ticks of the axes.
        ring, = root.iter("{http://www.w3.org/2000/svg}circle")

        def logarithm(at, axis, low, high):
            (low_words, low_value), (high_words, high_value) = low, high
            start, end = (float(texts[words].get(axis)) for words in (low_words, high_words))
            return low_value + (at - start) / (end - start) * (high_value - low_value)

        self.assertAlmostEqual(logarithm(float(ring.get("cx")), "x", ("10\u221215", -15), ("105", 5)),
                               math.log10(answer["tau"]), delta=0.02)
        # The words of a tick have their base line 4 pixels below it.
        self.assertAlmostEqual(logarithm(float(ring.get("cy")) + 4, "y", ("0.1", -1),
                                         ("20", math.log10(20))),
                               math.log10(answer["K_m"]), delta=0.005)

    def test_the_map_says_how_far_the_nearest_vertex_is(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "map.svg"
            answer = self.answer("--map", str(file), viscosity="0.1")
            self.assertIn(f"{100 * answer['nearest_vertex']['distance']:.1f}\u00a0% from", file.read_text())

    def test_a_map_that_cannot_be_written_is_said(self):
        done = self.run_program("--map", "/nowhere/map.svg", status=1)
        self.check_refusal(done, "/nowhere/map.svg")

    def test_nonsense_is_refused_in_one_sentence_with_option_value_and_range(self):
        for option, range_words in (("--E-prime", "at least 1e-20 Pa"),
                                    ("--K-IC", "at least 0 Pa m^0.5"),
                                    ("--viscosity", "at least 0 Pa s"),
                                    ("--leak-off", "at least 0 m/s^0.5"),
                                    ("--rate", "at least 1e-20 m2/s"),
                                    ("--time", "at least 1e-20 s")):
            for value in ("-1", "nan", "inf", "-inf", "1e999", "abc", "1.5x", "0x10", "--rate"):
                with self.subTest(f"{option} {value}"):
                    self.check_refusal(self.run_program(option, value, without=option, status=2),
                                       option, value, range_words)
            self.check_refusal(self.run_program(without=option, status=2), option, "missing",
                               range_words)
        for option in ("--E-prime", "--rate", "--time"):
            self.check_refusal(self.run_program(option, "0", without=option, status=2), option,
                               "= 0 ", "at least 1e-20")

    def check_refusal(self, done, *words):
        self.assertEqual(done.stdout, "")
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        for word in ("kgd_reference: ",) + words:
            self.assertIn(word, done.stderr)

    def test_refusals_of_the_other_options(self):
        plate = ("--plate", "1", "--sides", "rigid")
        for extra, words in ((("--profile", "1"), ("--profile = 1 ", "at least 2", "10000")),
                             (("--profile", "2.5"), ("--profile = 2.5 ", "whole number", "10000")),
                             (("--profile", "1e9"), ("--profile = 1e9 ", "10000")),
                             (("--plate", "-1", "--sides", "rigid"), ("--plate = -1 ", "at least")),
                             (("--plate", "1"), ("--sides is missing", "stress, rigid or fixed")),
                             (("--plate", "1", "--sides", "soft"),
                              ("--sides = soft ", "stress, rigid or fixed")),
                             (("--sides", "rigid"), ("--plate is missing", "at least")),
                             (plate + ("--poisson", "0.5"), ("--poisson = 0.5 ", "less than 0.5")),
                             (("--nonsense", "1"), ("--nonsense",)),
                             (("7",), ("7",)),
                             (("--rate", "1"), ("--rate",))):
            with self.subTest(" ".join(extra)):
                self.check_refusal(self.run_program(*extra, status=2), *words)
        self.check_refusal(self.run_program(K_IC="0", status=2), "K_IC = 0 ", "viscosity = 0 ",
                           "at least 1e-20")
        self.check_refusal(self.run_program(*plate, K_IC="0", viscosity="1", status=2),
                           "--K-IC = 0 ", "--plate")

    def test_help_names_every_option_with_its_unit(self):
        done = subprocess.run([KGD_REFERENCE, "--help"], text=True, capture_output=True)
        self.assertEqual(done.returncode, 0)
        for words in ("--E-prime", "Pa", "--K-IC", "Pa m^0.5", "--viscosity", "Pa s",
                      "--leak-off", "m/s^0.5", "--rate", "m2/s", "both wings", "--time",
                      "--plate", "--sides", "--poisson", "--profile", "--map"):
            self.assertIn(words, done.stdout)


if __name__ == "__main__":
    unittest.main()
