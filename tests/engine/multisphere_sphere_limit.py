"""A multi-sphere of N = 1 is a sphere: two of them move as two spheres under the host's pair_style gran
with the same law. Oblique impact with friction and spin, unequal sizes and masses.

Oracle: LIGGGHTS' own loop, surface and integrator of spheres.
"""

import unittest
from pathlib import Path

import numpy as np

from _engine import LAW, SPHERE_COLUMNS, Particle, Setup, dump, quaternion_of, read_dump, run, vectors
from _multisphere import multisphere_setup, subspheres, wall

STEPS, TIME_STEP = 2600, 5e-7
RELATIVE = 1e-12


def impact(aspect):
    """A sphere at a floor (z = 0) that another one hits; `aspect` stretches the axis of the
    ellipsoids that have the same spheres of radius b, mass and moments."""
    bodies = []
    for place, b, velocity, omega in (
            ((0.0, 0.0, 2.0001e-3), 2e-3, (0.1, 0.05, -0.15), (40.0, -70.0, 110.0)),
            ((2.01e-3, 1.12e-3, 4.66e-3), 1.5e-3, (-0.25, -0.2, -0.35), (-60.0, 20.0, 30.0))):
        sphere = Particle(place, (b, b, b))
        bodies.append(Particle(place, (aspect * b, b, b), quaternion_of((1, 2, 3), 0.7), velocity,
                               omega, mass=sphere.mass, moments=sphere.moments))
    return bodies


def motion(name, setup, particles, commands):
    """Frames of positions, velocities, angular velocities, forces and torques (F, 2, 3)."""
    script = setup.with_particles(particles, f"{name}.data") + commands
    run(script + dump(f"{name}.dump", columns=SPHERE_COLUMNS) + f"run {STEPS}\n", name=f"in.{name}")
    _, columns = read_dump(Path(f"{name}.dump"))
    groups = ("x y z", "vx vy vz", "omegax omegay omegaz", "fx fy fz", "tqx tqy tqz")
    return {group: vectors(columns, *group.split()) for group in groups}


class SphereLimit(unittest.TestCase):
    def test_one_sphere_is_a_sphere(self):
        setup = multisphere_setup(time_step=TIME_STEP)
        ours = motion("ours", setup, impact(1.8), subspheres(1) + wall("floor", "zplane", 0.0)
                      + "fix motion all nve/ellipsoid\n")
        setup = Setup(time_step=TIME_STEP, pair=f"gran {LAW}", atom_style="sphere")
        spheres = motion("spheres", setup, impact(1.0),
                         f"fix floor all wall/gran {LAW} primitive type 1 zplane 0.0\n"
                         "fix motion all nve/sphere\n")
        force, torque = spheres["fx fy fz"], spheres["tqx tqy tqz"]
        both = (np.abs(force).max(axis=2) > 0.0).sum(axis=0)
        self.assertGreater(both.min(), 100, "the spheres hardly touched")
        self.assertEqual(np.abs(force[0]).max() + np.abs(force[-1]).max(), 0.0, "not seen whole")
        self.assertGreater(np.abs(torque).max(), 1e-3 * np.abs(force).max() * 1.5e-3)
        worst = {}
        for group, expected in spheres.items():
            worst[group] = np.abs(ours[group] - expected).max() / np.abs(expected).max()
        print(f"{both[0]} and {both[1]} steps in contact; largest relative difference of "
              + ", ".join(f"{group.split()[0]} {error:.1e}" for group, error in worst.items()))
        self.assertLess(max(worst.values()), RELATIVE)


if __name__ == "__main__":
    unittest.main(verbosity=2)
