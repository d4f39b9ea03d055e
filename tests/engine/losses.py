"""Particles that leave the box are noticed: `thermo_modify lost` with right numbers, also while others are
inserted or deleted."""

import re
import unittest

from _engine import Particle, Setup, run, thermo
from _mesh import quad, write_stl


def dropping(lost, every):
    """20 particles, one each 1e-3 s; two of the first ones are shot out of the box."""
    setup = Setup(time_step=1e-5)
    return setup.header() + setup.create_box() + setup.properties() + f"""
fix grain all particletemplate/ellipsoid 15485863 semiaxes 2.5e-3 1e-3 1e-3 density 2500
fix drop all insert/drop seed 1 template grain particles 20 interval 1e-3 box -0.04 0.04 -0.04 0.04 -0.04 0.04
fix motion all nve/ellipsoid
thermo_style custom step atoms f_drop
thermo {every}
thermo_modify lost {lost}
run 250
set atom 2 vx 100
run 750
set atom 5 vx 100
run 1200
"""


class Losses(unittest.TestCase):
    def test_error_while_particles_are_inserted(self):
        for every in (100, 500, 5000):
            outcome = run(dropping("error", every), check=False, name=f"in.{every}")
            self.assertNotEqual(outcome.code, 0, f"thermo {every}: the loss was not noticed")
            numbers = re.search(r"Lost atoms: original (\d+) current (\d+)", outcome.text)
            original, current = map(int, numbers.groups())
            self.assertEqual(original - current, 1)
            self.assertIn(original, {100: (3, 4), 500: (5,), 5000: (10,)}[every])  # inserted until that output

    def test_warning_and_numbers(self):
        outcome = run(dropping("warn", 100), name="in.warn")
        found = re.findall(r"Lost atoms: original (\d+) current (\d+)", outcome.text)
        self.assertEqual(len(set(found)), 1)
        self.assertEqual(int(found[0][0]) - int(found[0][1]), 1)
        self.assertEqual(thermo("log.in.warn", 3)[-1][1:].tolist(), [18, 20])

    def test_insert_pack(self):
        """Every round inserts what is missing in the region: the loss is made up for at once."""
        text = dropping("error", 200).replace(
            "fix drop all insert/drop seed 1 template grain particles 20 interval 1e-3 box "
            "-0.04 0.04 -0.04 0.04 -0.04 0.04",
            "fix mix all particledistribution/discrete 32452843 1 grain 1.0\n"
            "region all block -0.045 0.045 -0.045 0.045 -0.045 0.045 units box\n"
            "fix drop all insert/pack seed 32452867 distributiontemplate mix insert_every 50 overlapcheck yes "
            "orientation random all_in yes region all particles_in_region 20").replace(" f_drop", " elapsed")
        outcome = run(text, check=False, name="in.pack")
        self.assertRegex(outcome.text, r"Lost atoms: original 21 current 20")

    def test_deleted_particles_are_not_lost(self):
        """fix massflow/mesh deletes those that pass: half of them are no loss."""
        write_stl("sink.stl", quad((-0.04, -0.04, -0.02), (0.04, -0.04, -0.02), (0.04, 0.04, -0.02),
                                   (-0.04, 0.04, -0.02)))
        grains = [Particle((0.006 * k - 0.02, 0.0, 0.001 if k % 2 else -0.03), (2e-3, 1e-3, 1e-3),
                           velocity=(0, 0, -2.0 if k % 2 else 0.0)) for k in range(8)]
        for ranks in (1, 2):
            text = Setup(time_step=1e-5).with_particles(grains) + """
fix sink all mesh/surface/planar file sink.stl type 1
fix flow all massflow/mesh mesh sink vec_side 0. 0. -1. count once delete_atoms yes
fix motion all nve/ellipsoid
thermo_style custom step atoms
thermo 500
thermo_modify lost error
run 1500
"""
            run(text, ranks, name=f"in.sink{ranks}")
            self.assertEqual(thermo(f"log.in.sink{ranks}", 2)[-1][1], 4)


if __name__ == "__main__":
    unittest.main(verbosity=2)
