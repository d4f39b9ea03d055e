"""N -> 55: collisions of multi-spheres converge to those of the smooth ellipsoids.

Pairs of particles hit each other off-centre in space, each pair away from all others. Without friction
and damping the impulse depends on the contact's place and normal only, which converge; the stiffness
of a multi-sphere's contact does not, because more and more spheres share it. The error is that of all
velocities and spins after the impact, against surface smooth; the order is p of error ~ N^-p.
"""

import unittest
from pathlib import Path

import numpy as np

from _engine import LAW, Particle, Setup, dump, quaternion_of, read_dump, run, vectors
from _multisphere import multisphere_setup, subspheres

PAIRS, COUNTS = 40, (5, 9, 17, 33, 55)
STEPS, TIME_STEP, SPEED, A, B = 1800, 5e-6, 0.5, 2.7e-3, 1.15e-3


def pairs():
    """Particles 1, 2 of each pair approach each other from a gap; random axes and offsets."""
    random = np.random.default_rng(55)
    bodies = []
    for k in range(PAIRS):
        place = 0.03 * np.array([k % 8 - 3.5, k // 8 - 2.0, 0.0])
        direction = random.normal(size=3)
        direction /= np.linalg.norm(direction)
        offset = np.cross(direction, random.normal(size=3))
        offset *= random.uniform(0.2e-3, 0.8e-3) / np.linalg.norm(offset)
        for sign in (-1.0, 1.0):
            bodies.append(Particle(tuple(place + sign * (2.75e-3 * direction + 0.5 * offset)), (A, B, B),
                                   quaternion_of(random.normal(size=3), random.uniform(0.0, 6.0)),
                                   tuple(-0.5 * SPEED * sign * direction), mass=2e-5))
    return bodies


def after(name, pair_style, commands):
    """Momenta after the impact as velocities (particles, 6): v, and spin times b."""
    setup = Setup(box=(-0.14, 0.14, -0.1, 0.1, -0.02, 0.02), friction=0.0, damping_normal=0.0,
                  damping_tangential=0.0, time_step=TIME_STEP, pair=pair_style)
    script = setup.with_particles(pairs(), f"{name}.data") + "neigh_modify page 1000000\n" + commands
    script += "fix motion all nve/ellipsoid\n" + dump(f"{name}.dump", STEPS) + f"run {STEPS}\n"
    run(script, name=f"in.{name}")
    _, columns = read_dump(Path(f"{name}.dump"))
    velocity = vectors(columns, "vx", "vy", "vz")
    moved = np.abs(velocity[1] - velocity[0]).max(axis=1) > 1e-3 * SPEED
    force = vectors(columns, "fx", "fy", "fz")[1]
    assert np.abs(force).max() == 0.0, "an impact is not over"
    return np.hstack([velocity[1], B * vectors(columns, "omegax", "omegay", "omegaz")[1]]), moved


class Convergence(unittest.TestCase):
    def test_to_the_smooth_ellipsoid(self):
        smooth, hit = after("smooth", f"gran/ellipsoid {LAW} surface smooth", "")
        errors = []
        for count in COUNTS:
            found, _ = after(f"n{count}", multisphere_setup("contacts 60").pair, subspheres(count))
            errors.append(np.sqrt(((found - smooth)[hit] ** 2).sum(axis=1).mean()) / SPEED)
        order = -np.polyfit(np.log(COUNTS), np.log(errors), 1)[0]
        print(f"{hit.sum() // 2} impacts; root mean square error of velocities and spins after them: "
              + ", ".join(f"N = {n}: {e:.4f}" for n, e in zip(COUNTS, errors)))
        print(f"measured order: error ~ N^-{order:.2f}")
        self.assertGreater(hit.sum() // 2, 15)
        self.assertTrue((np.diff(errors) < 0.0).all(), "not smaller with every N")
        self.assertGreater(order, 1.5)
        self.assertLess(errors[-1], 0.005)


if __name__ == "__main__":
    unittest.main(verbosity=2)
