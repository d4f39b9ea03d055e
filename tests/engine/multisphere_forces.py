"""Forces and torques of multi-sphere ellipsoids in random poses against brute force over all N^2 pairs
of sub-spheres (all N spheres at a wall), with the contact law written down once more."""

import unittest
from pathlib import Path

import numpy as np

from _engine import Particle, dump, quaternion_of, read_dump, rotation, run, vectors
from _multisphere import (multisphere_setup, pair_contacts, subspheres, summed, wall, wall_contacts)

PAIRS, COUNTS = 240, (3, 5, 17)
SPACING = 0.014
TIME_STEP = 1e-6
RELATIVE = 1e-11  # of the largest force of a contact; the chain here and the engine's differ by rounding


def random_pairs():
    """Overlapping pairs ((i, N_i), (j, N_j)): every combination of N, sizes up to 1:2, every fourth
    pair nearly parallel side by side."""
    random = np.random.default_rng(2010)
    pairs = []
    for k in range(PAIRS):
        count_i, count_j = COUNTS[k % 3], COUNTS[k // 3 % 3]
        bodies = []
        axis = random.normal(size=3)
        for scale in (1.0, random.uniform(0.5, 1.0)):
            about = axis if k % 4 == 0 else random.normal(size=3)
            angle = 1.0 + 0.03 * random.normal() if k % 4 == 0 else random.uniform(0.0, 6.0)
            bodies.append(dict(semiaxes=(2.7e-3 * scale, 1.15e-3 * scale, 1.15e-3 * scale),
                               quaternion=quaternion_of(about, angle),
                               velocity=tuple(0.2 * random.normal(size=3)),
                               omega=tuple(60.0 * random.normal(size=3))))
        place = SPACING * np.array([k % 16 - 7.5, k // 16 - 7.0, 0.0])
        i = Particle(position=tuple(place), **bodies[0])
        direction = random.normal(size=3)
        if k % 4 == 0:
            direction = np.cross(i_axis(i), direction)
        direction /= np.linalg.norm(direction)
        # moved together until the spheres overlap by up to 4 % of b
        low, high = 0.0, 6e-3
        while high - low > 1e-9:
            middle = 0.5 * (low + high)
            j = Particle(position=tuple(place + middle * direction), **bodies[1])
            low, high = (middle, high) if pair_contacts(i, j, count_i, count_j) else (low, middle)
        j = Particle(position=tuple(place + (low - random.uniform(1e-6, 5e-5)) * direction),
                     **bodies[1])
        pairs.append(((i, count_i), (j, count_j)))
    return pairs


def i_axis(particle):
    return rotation(particle.quaternion)[:, 0]


class PairForces(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.pairs = random_pairs()
        cls.found = {rule: cls.measure(rule) for rule in ("sum", "average")}

    @classmethod
    def measure(cls, rule):
        """Forces and torques (steps, particles, 3), particles held still."""
        cls.setup = multisphere_setup(f"contacts 24 multicontact {rule}", time_step=TIME_STEP,
                                      box=(-0.13, 0.13, -0.13, 0.13, -0.03, 0.03))
        bodies = [body for pair in cls.pairs for body in pair]
        script = cls.setup.with_particles([p for p, _ in bodies], "pairs.data")
        script += "neigh_modify page 1000000\n"
        script += subspheres(3, [(k, n) for k, (_, n) in enumerate(bodies, 1)])
        run(script + dump(f"{rule}.dump") + "run 1\n", name=f"in.{rule}")
        _, columns = read_dump(Path(f"{rule}.dump"))
        return vectors(columns, "fx", "fy", "fz"), vectors(columns, "tqx", "tqy", "tqz")

    def check(self, rule):
        force, torque = self.found[rule]
        worst, several = 0.0, 0
        for k, ((i, count_i), (j, count_j)) in enumerate(self.pairs):
            contacts = pair_contacts(i, j, count_i, count_j)
            several += len(contacts) > 1
            weight = 1.0 / len(contacts) if rule == "average" else 1.0
            expected = summed(contacts, i, j, self.setup, TIME_STEP, weight)
            found = np.array([force[1, 2 * k], torque[1, 2 * k],
                              force[1, 2 * k + 1], torque[1, 2 * k + 1]])
            scale = max(np.linalg.norm(summed([c], i, j, self.setup, TIME_STEP, weight)[0])
                        for c in contacts) * np.array([1.0, 2.7e-3, 1.0, 2.7e-3])[:, None]
            error = np.abs((found - expected) / scale).max()
            worst = max(worst, error)
            self.assertLess(error, RELATIVE, f"pair {k}: N = {count_i}, {count_j}")
        print(f"multicontact {rule}: {PAIRS} pairs, {several} with several contacts, worst relative "
              f"error {worst:.1e}")
        self.assertGreater(several, PAIRS // 6)

    def test_sum(self):
        self.check("sum")

    def test_average(self):
        self.check("average")

    def test_action_is_reaction(self):
        """Forces cancel to the last bit of the sum; torques about one common point cancel, too."""
        force, torque = (values[1] for values in self.found["sum"])
        worst = 0.0
        for k, ((i, _), (j, _)) in enumerate(self.pairs):
            scale = np.linalg.norm(force[2 * k])
            lever = np.subtract(j.position, i.position)
            total = torque[2 * k] + torque[2 * k + 1] + np.cross(lever, force[2 * k + 1])
            worst = max(worst, np.abs(total).max() / scale / 2.7e-3)
            self.assertLessEqual(np.abs(force[2 * k] + force[2 * k + 1]).max(), 1e-15 * scale)
        print(f"torques about one point cancel to {worst:.1e}")
        self.assertLess(worst, 1e-12)


class WallForces(unittest.TestCase):
    """One particle at the floor in each pose: tilted, flat (several spheres), upright."""

    COUNT = 13
    TILTS = (0.0, 0.002, 0.01, 0.4, 1.0, 1.5707)  # rad
    DEPTHS = (1.2e-4, 1.2e-4, 1.2e-4, 1.2e-4, 5e-6, 1e-5)  # m

    def particles(self):
        random = np.random.default_rng(7)
        bodies = []
        for k, (tilt, depth) in enumerate(zip(self.TILTS, self.DEPTHS)):
            q = quaternion_of((0.0, 1.0, 0.0), tilt)
            lowest = Particle((0.0, 0.0, 0.0), (2.7e-3, 1.15e-3, 1.15e-3), q)
            low, high = 0.0, 3e-3
            while high - low > 1e-12:
                middle = 0.5 * (low + high)
                touches = wall_contacts(lowest, self.COUNT, (0.0, 0.0, -middle), (0.0, 0.0, -1.0))
                low, high = (middle, high) if touches else (low, middle)
            bodies.append(Particle((0.012 * (k - 2.5), 0.0, low - depth), lowest.semiaxes, q,
                                   tuple(0.2 * random.normal(size=3)),
                                   tuple(40.0 * random.normal(size=3))))
        return bodies

    def check(self, rule):
        setup = multisphere_setup(time_step=TIME_STEP)
        bodies = self.particles()
        script = setup.with_particles(bodies, "wall.data") + subspheres(self.COUNT)
        script += wall("floor", "zplane", 0.0, f"contacts 13 multicontact {rule}")
        run(script + dump(f"wall_{rule}.dump") + "run 1\n", name=f"in.wall_{rule}")
        _, columns = read_dump(Path(f"wall_{rule}.dump"))
        force, torque = vectors(columns, "fx", "fy", "fz")[1], vectors(columns, "tqx", "tqy", "tqz")[1]
        numbers, worst = [], 0.0
        for k, body in enumerate(bodies):
            contacts = wall_contacts(body, self.COUNT, (0.0, 0.0, 0.0), (0.0, 0.0, -1.0))
            numbers.append(len(contacts))
            weight = 1.0 / len(contacts) if rule == "average" else 1.0
            expected = summed(contacts, body, None, setup, TIME_STEP, weight)
            scale = np.linalg.norm(expected[0])
            worst = max(worst, np.abs(force[k] - expected[0]).max() / scale,
                        np.abs(torque[k] - expected[1]).max() / scale / 2.7e-3)
        print(f"wall, multicontact {rule}: contacts {numbers}, worst relative error {worst:.1e}")
        self.assertGreater(max(numbers), 4)
        self.assertEqual(min(numbers), 1)
        self.assertLess(worst, RELATIVE)

    def test_sum(self):
        self.check("sum")

    def test_average(self):
        self.check("average")


if __name__ == "__main__":
    unittest.main(verbosity=2)
