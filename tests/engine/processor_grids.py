"""2 and 4 ranks in every processor grid, periodic box, particles much longer than the skin and than half a
sub-domain: forces and trajectories of one rank, to rounding."""

import math
import unittest

import numpy as np

from _engine import LAW, Particle, Setup, dump, quaternion_of, read_dump, run, vectors

# direction of the particles' long axes -> grids that cut the box across them
GRIDS = [["2 1 1", "4 1 1", "2 2 1"], ["1 2 1", "1 4 1", "1 2 2"], ["1 1 2", "1 1 4", "2 1 2"]]
AXES = (3e-3, 1e-3, 1e-3)  # a quarter of the box is 3.75 mm, the skin 0.2 mm
SIDE, STEPS = 0.015, 400
COMPARED = [("x", "y", "z"), ("vx", "vy", "vz"), ("omegax", "omegay", "omegaz"),
            ("quat1", "quat2", "quat3", "quat4")]


def crowd(along):
    """98 particles side by side, slightly turned, with their long axes about along x, y or z (0, 1, 2),
    that fly about and soon hit each other."""
    random = np.random.default_rng(12)
    third = quaternion_of((1, 1, 1), along * 2.0 * np.pi / 3.0)  # turns x into y or z
    particles = []
    for x, y, z in np.ndindex(2, 7, 7):
        place = np.array([x * SIDE / 2.0, y * SIDE / 7.0, z * SIDE / 7.0])
        w, v = math.cos(0.02), 0.02 * random.uniform(-1.0, 1.0, 3)
        tilt = np.array([w, *v]) / np.linalg.norm([w, *v])
        particles.append(Particle(tuple(np.roll(place, along) + random.uniform(0.0, 1e-5, 3)), AXES,
                                  product(tilt, third), tuple(random.normal(0.0, 0.7, 3)),
                                  tuple(random.normal(0.0, 50.0, 3))))
    return particles


def product(p, q):
    """Product of quaternions: the turn q, then p."""
    p, q = np.asarray(p), np.asarray(q)
    return (p[0] * q[0] - p[1:] @ q[1:],
            *(p[0] * q[1:] + q[0] * p[1:] + np.cross(p[1:], q[1:])))


class Grids(unittest.TestCase):
    def follow(self, surface, along, grid):
        setup = Setup(box=(0.0, SIDE) * 3, boundary="p p p", time_step=2e-6, skin=2e-4,
                      pair=f"gran/ellipsoid {LAW} surface {surface}")
        script = setup.with_particles(crowd(along), "crowd.data")
        script = script.replace("read_data", f"processors {grid}\nread_data")
        if surface == "multisphere":
            script += "fix subspheres all property/atom subspheres scalar yes yes no 7.\n"
        name = f"{surface}{along}_{grid.replace(' ', '')}"
        ranks = int(np.prod([int(n) for n in grid.split()]))
        run(script + "fix motion all nve/ellipsoid\n" + dump(f"{name}.dump", STEPS // 4)
            + f"run {STEPS}\n", ranks, name=f"in.{name}")
        return read_dump(f"{name}.dump")[1]

    def compare(self, surface):
        for along, grids in enumerate(GRIDS):
            one = self.follow(surface, along, "1 1 1")
            self.assertEqual(one["id"].shape, (5, 98))
            touched = (one["tqx"] != 0.0).any(axis=0).sum()
            self.assertGreater(touched, 60)
            for grid in grids:
                worst = self.largest_differences(one, self.follow(surface, along, grid))
                print(f"{surface}, {grid}: {touched} particles touched, largest relative differences "
                      + ", ".join(f"{name} {w:.0e}" for name, w in worst.items()))
                self.assertLess(max(worst.values()), 1e-9, grid)

    @staticmethod
    def largest_differences(one, other):
        worst = {}
        for names in COMPARED:
            difference = vectors(one, *names) - vectors(other, *names)
            if names[0] == "x":
                difference -= SIDE * np.round(difference / SIDE)
            worst[names[0]] = np.abs(difference).max() / np.abs(vectors(one, *names)).max()
        return worst

    def test_smooth(self):
        self.compare("smooth")

    def test_multisphere(self):
        self.compare("multisphere")


if __name__ == "__main__":
    unittest.main(verbosity=2)
