"""The program compare_fluids as a user meets it: signs, pairs, errors.

    python3 tests/programs/compare_fluids_test.py build/release/examples/compare_fluids
"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM = sys.argv.pop(1)


class CompareFluidsTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def study(self, name, text):
        folder = pathlib.Path(self.folder.name) / name
        folder.mkdir()
        (folder / "seeds.csv").write_text(text)
        return str(folder)

    def compare(self, *folders, status=0):
        done = subprocess.run([PROGRAM, *folders], text=True, capture_output=True)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return done

    def test_rocks_are_paired_and_changes_get_their_sign(self):
        viscous = self.study("viscous", "seed,breakdown_pressure_Pa,0.6_s/tortuosity,0.6_s/asymmetry\n"
                             "1,30e6,1.5,0.2\n2,32e6,1.7,0.4\n3,34e6,,0.3\n")
        slick = self.study("slick", "seed,0.6_s/tortuosity,breakdown_pressure_Pa,0.6_s/asymmetry\n"
                           "2,1.5,21e6,0.3\n1,1.3,20e6,0.3\n3,1.4,22e6,0.3\n")
        rows = {line.split(" | ")[0].strip("| "): [c.strip(" |") for c in line.split(" | ")[1:]]
                for line in self.compare(viscous, slick).stdout.splitlines() if line.startswith("| ")}
        # Changes of 10, 11 and 12 MPa; Student's t for two degrees of freedom is 4.303.
        self.assertEqual(rows["breakdown pressure, MPa"],
                         ["32.0", "21.0", "11.0", "2.484", "3", "as in the paper"])
        self.assertEqual(rows["tortuosity at 0.6 s"],
                         ["1.600", "1.400", "0.200", "0.000", "2", "the other way round"])
        self.assertEqual(rows["asymmetry at 0.6 s"][-1], "not told apart")

    def test_what_is_no_study_is_refused(self):
        whole = self.study("whole", "seed,breakdown_pressure_Pa\n1,30e6\n")
        self.assertIn("--seeds", self.compare(whole, self.folder.name + "/none", status=2).stderr)
        damaged = self.study("damaged", "seed,breakdown_pressure_Pa\n1\n")
        self.assertIn("damaged", self.compare(whole, damaged, status=2).stderr)


if __name__ == "__main__":
    unittest.main()
