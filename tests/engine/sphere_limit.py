"""Two spheres (a = b = c) under pair_style gran/ellipsoid move as under the host's pair_style gran
with the same law: oblique impact with friction and spin, unequal sizes, unlike materials.

Oracle: LIGGGHTS' own loop, surface and integrator of spheres.
"""

import unittest
from pathlib import Path

import numpy as np

from _engine import (SPHERE_COLUMNS, Material, Particle, Setup, dump, quaternion_of, read_dump, run,
                     vectors)

STEPS = 900
RELATIVE = 1e-12


def impact():
    """Two spheres about to touch, fast across and spinning."""
    speed = np.array([0.35, -0.20, 0.15])
    turned = quaternion_of((1, 2, 3), 0.7)  # must not matter
    return [Particle((0.0, 0.0, 0.0), (2e-3,) * 3, turned, tuple(speed), (40.0, -70.0, 110.0)),
            Particle((2.41e-3, 1.12e-3, 2.29e-3), (1.5e-3,) * 3, velocity=tuple(-0.5 * speed),
                     omega=(-60.0, 20.0, 30.0), type=2)]


def collide(law, ellipsoids):
    """Forces and torques (STEPS, 2, 3) of one impact."""
    setup = Setup(materials=[Material(), Material(60e6, 0.3)], time_step=5e-7)
    if ellipsoids:
        setup.pair, columns, motion = f"gran/ellipsoid {law} surface smooth", None, "nve/ellipsoid"
    else:
        setup.pair, setup.atom_style, motion = f"gran {law}", "sphere", "nve/sphere"
    file = f"{law.replace('/', '_').replace(' ', '_')}_{motion.replace('/', '_')}"
    script = setup.with_particles(impact(), f"{file}.data") + f"fix motion all {motion}\n"
    script += dump(f"{file}.dump", columns=SPHERE_COLUMNS) + f"run {STEPS}\n"
    run(script, name=f"in.{file}")
    _, columns = read_dump(Path(f"{file}.dump"))
    return vectors(columns, "fx", "fy", "fz"), vectors(columns, "tqx", "tqy", "tqz")


class SphereLimit(unittest.TestCase):
    def compare(self, law):
        force, torque = collide(law, ellipsoids=True)
        sphere_force, sphere_torque = collide(law, ellipsoids=False)
        touching = np.linalg.norm(sphere_force[:, 0], axis=1) > 0.0
        self.assertGreater(touching.sum(), 100, "the spheres hardly touched")
        self.assertFalse(touching[0] or touching[-1], "the impact is not seen whole")
        self.assertGreater(np.abs(sphere_torque).max(), 0.0)
        worst = []
        for found, expected in ((force, sphere_force), (torque, sphere_torque)):
            worst.append(np.abs(found - expected).max() / np.abs(expected).max())
        print(f"{law}: {touching.sum()} steps in contact, largest error of forces {worst[0]:.1e}, "
              f"of torques {worst[1]:.1e}")
        self.assertLess(max(worst), RELATIVE)
        self.assertTrue(((np.linalg.norm(force[:, 0], axis=1) > 0.0) == touching).all())

    def test_hertz_viscous_with_history_viscous(self):
        self.compare("model hertz/viscous tangential history/viscous")

    def test_hertz_with_history(self):
        self.compare("model hertz tangential history")


if __name__ == "__main__":
    unittest.main(verbosity=2)
