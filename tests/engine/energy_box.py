"""Energy of 100 undamped, frictionless ellipsoids (a != b != c) that collide in a periodic box, with a
time step of a fiftieth of the contact time: drifts less than 0.1 %.

The energy is that of motion at moments at which nothing touches, so that no elastic energy has to be
known. Eq. (23) has no potential when the reduced radius R of (19) changes during a contact: one impact
then changes the energy of its pair by about (turn during the contact) * d ln R/d angle, with either
sign, at any time step (1e-3 at 0.7 m/s and 100 rad/s, measured at a 50th to an 800th of the contact
time). So the bodies are slow here: they turn by less than 0.01 rad while they touch. By default 200,000 steps; the full million by hand:

    ELLIPSOID_ENERGY_STEPS=1000000 ctest -R engine.energy_box
"""

import os
import unittest
from pathlib import Path

import numpy as np

from _engine import Particle, Setup, quaternion_of, run, thermo
from _hertz import hertz

STEPS = int(os.environ.get("ELLIPSOID_ENERGY_STEPS", "200000"))
AXES = (2.7e-3, 1.8e-3, 1.2e-3)
BOX, SPEED, SPIN = 0.028, 0.05, 10.0  # m, m/s, rad/s


def particles():
    random = np.random.default_rng(100)
    cell = BOX / 5.0
    places = [(i, j, k) for i in range(5) for j in range(5) for k in range(5)]
    chosen = random.permutation(len(places))[:100]
    return [Particle(tuple((np.array(places[c]) + 0.5) * cell - 0.5 * BOX), AXES,
                     quaternion_of(random.normal(size=3), random.uniform(0.0, 6.0)),
                     tuple(SPEED / 3.0 ** 0.5 * random.normal(size=3)),
                     tuple(SPIN * random.normal(size=3))) for c in chosen]


class EnergyBox(unittest.TestCase):
    def test_energy_stays(self):
        bodies = particles()
        half = 0.5 * BOX
        setup = Setup(box=(-half, half) * 3, boundary="p p p", damping_normal=0.0, friction=0.0,
                      damping_tangential=0.0, skin=0.001)
        modulus = setup.materials[0].youngs_modulus / (2.0 * (1.0 - 0.2 ** 2))
        # of two bodies with the mean radius of curvature at the mean relative speed
        size = np.prod(AXES) ** (1.0 / 3.0)
        _, contact_time = hertz(0.5 * bodies[0].mass, 0.5 * size, modulus, 2.0 ** 0.5 * SPEED)
        setup.time_step = contact_time / 50.0
        script = setup.with_particles(bodies) + "fix motion all nve/ellipsoid\n"
        script += f"""compute search all contacts/ellipsoid
compute turning all erotate/ellipsoid
fix mean all ave/time 1 {STEPS} {STEPS} c_search[1] file contacts.txt
thermo_style custom step ke c_turning c_search[1] c_search[6]
thermo 100
thermo_modify norm no lost error format float %.16g
run {STEPS}
"""
        run(script, timeout=1500)
        rows = thermo("log.in.run")
        self.assertEqual(rows[-1, 0], STEPS)
        free = rows[rows[:, 3] == 0.0]
        energy = free[:, 1] + free[:, 2]
        drift = energy[-1] / energy[0] - 1.0
        largest = np.abs(energy / energy[0] - 1.0).max()
        mean_contacts = float(Path("contacts.txt").read_text().split()[-1])
        collisions = mean_contacts * STEPS * setup.time_step / contact_time
        share = free[:, 2] / energy
        print(f"{STEPS} steps of {setup.time_step:.2e} s, about {collisions:.0f} collisions, "
              f"{len(free)} of {len(rows)} moments without contact: drift {drift:.2e}, "
              f"largest {largest:.2e}; share of rotation {share[0]:.3f} -> {share[-1]:.3f}")
        self.assertGreater(collisions, STEPS / 1000)
        self.assertGreater(len(free), len(rows) / 10)
        self.assertGreater(np.abs(share - share[0]).max(), 0.1, "nothing turned")
        self.assertEqual(rows[:, 4].max(), 0.0, "a contact search did not converge")
        self.assertLess(largest, 1e-3)


if __name__ == "__main__":
    unittest.main(verbosity=2)
