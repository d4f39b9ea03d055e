"""Populations of different N, size and spacing in one run, dropped by two templates into a box that is
periodic across: nothing is lost, and particles only exchange momentum with each other.
"""

import unittest
from pathlib import Path

import numpy as np

from _engine import COLUMNS, dump, run
from _multisphere import multisphere_setup

DROPS, STEPS, EVERY = 10, 14000, 500
TEMPLATES = ((1.0, 5, "paper"), (0.7, 13, "minimax"))


def script(name):
    """A free cloud (no gravity, no walls, periodic): drops in opposite directions collide."""
    setup = multisphere_setup(box=(0.0, 0.014, 0.0, 0.014, 0.0, 0.03), boundary="p p p",
                              time_step=5e-6, skin=0.001)
    text = setup.without_particles()
    for k, (scale, count, spacing) in enumerate(TEMPLATES):
        a, b, low = 2.7e-3 * scale, 1.15e-3 * scale, 0.004 + 0.02 * k
        text += f"""
fix grain{k} all particletemplate/ellipsoid {15485863 + 4 * k} semiaxes {a} {b} {b} density 1340 &
    subspheres {count} spacing {spacing}
fix drop{k} all insert/drop seed {7 + k} template grain{k} particles {DROPS} interval 2e-3 &
    box 0.001 0.013 0.001 0.013 {low} {low + 0.002} velocity 0 0 {0.5 - k}
"""
    columns = COLUMNS + ["f_subspheres", "f_spacing"]
    return (text + "fix motion all nve/ellipsoid\nthermo_modify lost error\nrun 5000\n"
            + dump(f"{name}.dump", EVERY, columns) + f"run {STEPS}\n"), columns


def frames(file, columns):
    """Per frame {column: (N,)}."""
    lines, at, found = Path(file).read_text().splitlines(), 0, []
    while at < len(lines):
        count = int(lines[at + 3])
        values = np.array([line.split() for line in lines[at + 9:at + 9 + count]], float)
        found.append(dict(zip(columns, values.T)))
        at += 9 + count
    return found


class Mixture(unittest.TestCase):
    def test_momentum_and_numbers(self):
        for ranks in (1, 2):
            text, columns = script(f"cloud{ranks}")
            run(text, ranks, name=f"in.cloud{ranks}")
            found = frames(f"cloud{ranks}.dump", columns)
            whole = [f for f in found if len(f["id"]) == 2 * DROPS]
            self.assertGreater(len(whole), 10)
            self.assertEqual(len(found[-1]["id"]), 2 * DROPS, "particles are lost")
            last = found[-1]
            kinds = sorted(zip(last["shapex"], last["f_subspheres"], last["f_spacing"]))
            self.assertEqual(kinds, sorted(((2.7e-3, 5.0, 0.0), (0.7 * 2.7e-3, 13.0, 1.0))
                                           * DROPS))
            self.check_momentum(whole, ranks)

    def check_momentum(self, whole, ranks):
        momenta = np.array([[(f["mass"] * f[c]).sum() for c in ("vx", "vy", "vz")] for f in whole])
        scale = np.abs(whole[0]["mass"] * whole[0]["vz"]).sum()
        drift = np.abs(momenta - momenta[0]).max() / scale
        large = np.array([(f["mass"] * f["vz"])[f["f_subspheres"] == 5].sum() for f in whole])
        exchanged = np.abs(large - large[0]).max() / scale
        print(f"{ranks} ranks, {len(whole)} frames with all particles: momentum drifts by {drift:.1e}; "
              f"the populations exchange {exchanged:.2f}")
        self.assertGreater(exchanged, 0.03)
        self.assertLess(drift, 1e-12)


if __name__ == "__main__":
    unittest.main(verbosity=2)
