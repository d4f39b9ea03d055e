"""A crowd in a periodic box whose members touch each other and, over all faces, each other's images, and brute force
for its forces."""

import numpy as np

from _brute_force import BruteForce, Law
from _engine import Material, Particle, Setup, quaternion_of

LENGTHS = (8.7e-3, 5.8e-3, 5.8e-3)
TIME_STEP = 2e-6
MATERIAL = Material(5e7, 0.3)
FRICTION, DAMPING = 0.5, (300.0, 200.0)  # damping along the normal, and tangential


def members():
    random = np.random.default_rng(5)
    return [Particle(tuple(2.9e-3 * (np.array((x, y, z)) + 0.5) + random.uniform(-1e-4, 1e-4, 3)),
                     (1.4e-3, 1.65e-3, 1.5e-3), quaternion_of(random.normal(size=3), 2.0),
                     tuple(random.normal(0, 0.6, 3)), tuple(random.normal(0, 200, 3)))
            for x in range(3) for y in range(2) for z in range(2)]


def script(boundary="p p p"):
    """Up to the settings of the materials; the particles come from crowd.data, which is written."""
    setup = Setup(box=(0.0, LENGTHS[0], 0.0, LENGTHS[1], 0.0, LENGTHS[2]), boundary=boundary, skin=3e-4,
                  friction=FRICTION, materials=[MATERIAL], time_step=TIME_STEP, damping_normal=DAMPING[0],
                  damping_tangential=DAMPING[1])
    return setup.with_particles(members(), "crowd.data")


def brute_force(periods=LENGTHS):
    return BruteForce(Law([(MATERIAL.youngs_modulus, MATERIAL.poissons_ratio)], [[FRICTION]], [[DAMPING[0]]],
                          [[DAMPING[1]]], TIME_STEP), periods)
