"""Both laws of examples/own_aperture_law.cpp see the same contact force.

    python3 tests/interface/own_aperture_law.py build/release/examples/own_aperture_law

The hyperbolic law w = w0 F0 / (F + F0) gives the force from its width, and the exponential law
w = r + (w0 - r) exp(-F / F0) its width from the force; once open, both follow the gap.
"""

import math
import re
import subprocess
import sys
import unittest

PROGRAM = sys.argv.pop(1)
W0, RESIDUAL = 6, 1  # um


class OwnApertureLawTest(unittest.TestCase):
    def test_the_widths_of_both_laws_belong_to_one_force(self):
        printed = subprocess.run([PROGRAM], text=True, capture_output=True, check=True).stdout
        rows = re.findall(r"hyperbolic (\S+) um   exponential (\S+) um", printed)
        self.assertEqual(len(rows), 4)
        for hyperbolic, exponential in ((float(h), float(e)) for h, e in rows):
            expected = hyperbolic
            if hyperbolic < W0:
                expected = RESIDUAL + (W0 - RESIDUAL) * math.exp(1 - W0 / hyperbolic)
            self.assertAlmostEqual(exponential / expected, 1, delta=0.005)
        self.assertLess(float(rows[2][0]), W0)
        self.assertGreater(float(rows[3][0]), W0)


if __name__ == "__main__":
    unittest.main()
