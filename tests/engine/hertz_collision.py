"""Head-on collisions without damping against Hertz's closed form.

With the reduced mass m, the reduced radius R of (19), the effective modulus E* and the approach speed
v, m d2h/dt2 = -4/3 E* sqrt(R) h^(3/2) gives
  largest overlap  h = (15 m v^2 / (16 E* sqrt(R)))^(2/5),
  contact time     t = 2 h/v int_0^1 du/sqrt(1 - u^(5/2)) = 2 sqrt(pi) Gamma(7/5)/Gamma(9/10) h/v,
which is 2.868 (m^2/(R E*^2 v))^(1/5), and the speed after the impact is that before.
"""

import math
import unittest
from pathlib import Path

import numpy as np

from _engine import Particle, Setup, dump, read_dump, run, vectors
from _hertz import hertz

SPEED, STEPS_PER_CONTACT = 0.2, 2000


def collide(axes_i, axes_j, reduced_radius, name):
    """Measured (overlap, time, restitution) over the closed form, of an impact along x."""
    setup = Setup(damping_normal=0.0, damping_tangential=0.0)
    gap = 2e-7
    i = Particle((0.0, 0.0, 0.0), axes_i, velocity=(0.5 * SPEED, 0.0, 0.0))
    j = Particle((axes_i[0] + axes_j[0] + gap, 0.0, 0.0), axes_j, velocity=(-0.5 * SPEED, 0.0, 0.0))
    modulus = setup.materials[0].youngs_modulus / (2.0 * (1.0 - 0.2 ** 2))
    overlap, time = hertz(i.mass * j.mass / (i.mass + j.mass), reduced_radius, modulus, SPEED)
    setup.time_step = time / STEPS_PER_CONTACT
    steps = int(1.1 * STEPS_PER_CONTACT + gap / SPEED / setup.time_step)
    script = setup.with_particles([i, j], f"{name}.data") + "fix motion all nve/ellipsoid\n"
    run(script + dump(f"{name}.dump") + f"run {steps}\n", name=f"in.{name}")
    _, columns = read_dump(Path(f"{name}.dump"))
    x, velocity = columns["x"], vectors(columns, "vx", "vy", "vz")
    measured = axes_i[0] + axes_j[0] - (x[:, 1] - x[:, 0])
    inside = np.flatnonzero(measured > 0.0)
    first, last = inside[0], inside[-1]
    begin = first - measured[first] / (measured[first] - measured[first - 1])
    end = last + measured[last] / (measured[last] - measured[last + 1])
    across = np.abs(velocity[..., 1:]).max() / SPEED
    return (measured.max() / overlap, (end - begin) * setup.time_step / time,
            (velocity[-1, 1, 0] - velocity[-1, 0, 0]) / SPEED, across)


class HertzCollision(unittest.TestCase):
    def check(self, name, axes_i, axes_j, reduced_radius):
        overlap, time, restitution, across = collide(axes_i, axes_j, reduced_radius, name)
        print(f"{name}: overlap {overlap:.8f}, time {time:.8f} of the closed form, "
              f"restitution {restitution:.9f}")
        # error of the time integration with 2000 steps per contact: measured 1.3e-7
        self.assertAlmostEqual(overlap, 1.0, delta=1e-6)
        self.assertAlmostEqual(time, 1.0, delta=1e-6)
        self.assertAlmostEqual(restitution, 1.0, delta=1e-6)
        self.assertLess(across, 1e-12)

    def test_constant_of_the_contact_time(self):
        overlap, time = hertz(1.0, 1.0, 1.0, 1.0)
        self.assertAlmostEqual(time, 2.87, delta=0.005)
        self.assertAlmostEqual(time / overlap, 2.94328, delta=5e-5)

    def test_spheres(self):
        self.check("spheres", (2e-3,) * 3, (1e-3,) * 3, 2.0 / 3.0 * 1e-3)

    def test_triaxial_tip_to_tip(self):
        # the radii of curvature at the tip are b^2/a and c^2/a: W_j = 2 W_i here, R = sqrt(det W) 2/3
        axes = (2.7e-3, 1.8e-3, 1.2e-3)
        self.check("tips", axes, tuple(2.0 * s for s in axes), 2.0 / 3.0 * axes[1] * axes[2] / axes[0])

    def test_flat_sides_crossed(self):
        # tips of the shortest axis; W_i = diag(9, 4) mm2 / 1.2 mm and W_j the same swapped
        r_1, r_2 = 3e-3 ** 2 / 1.2e-3, 2e-3 ** 2 / 1.2e-3
        self.check("crossed", (1.2e-3, 3e-3, 2e-3), (1.2e-3, 2e-3, 3e-3), r_1 * r_2 / (r_1 + r_2))


if __name__ == "__main__":
    unittest.main(verbosity=2)
