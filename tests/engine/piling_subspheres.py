"""inputs/piling.in with every number of sub-spheres that the paper piles, and 55: the script
needs no other change, nothing is lost, and no sub-sphere lies deep in a wall or in another particle's
(by brute force over all spheres)."""

import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

from _engine import Particle, read_dump, run_example, vectors
from _multisphere import pair_contacts, wall_contacts

COUNTS = 3, 5, 7, 9, 13, 17, 55
PARTICLES, A, B = 20, 2.7e-3, 1.15e-3
DEEPEST = 0.02 * B  # the paper's mean overlap is 2e-4 b; an impact from y0 reaches about 0.01 b


def pile(count):
    """Particles of every frame."""
    changes = {"surface": "multisphere", "subspheres": count, "particles": PARTICLES, "dt": 1e-5,
               "y0": 0.03, "settle": 1.5, "dump_time": 0.1, "vtk": "no", "out": f"pile{count}"}
    run_example("piling", changes)
    return [particles_of(file, count) for file in sorted(Path(f"pile{count}").glob("pile.*.dump"))[1:]]


def particles_of(file, count):
    _, columns = read_dump(file)
    if set(columns["f_subspheres"][0]) != {float(count)}:
        raise AssertionError(f"{file} holds other particles")
    return [Particle(tuple(x), (A, B, B), tuple(q)) for x, q in
            zip(vectors(columns, *"xyz")[0], vectors(columns, *(f"quat{k}" for k in (1, 2, 3, 4)))[0])]


def overlaps(particles, count):
    """Of all touching spheres of different particles; of all with wall and floor (m)."""
    near = [(p, q) for k, p in enumerate(particles) for q in particles[:k]
            if np.linalg.norm(np.subtract(p.position, q.position)) < 2 * A]
    pairs = [c[1] for p, q in near for c in pair_contacts(p, q, count, count)]
    walls = [c[1] for p in particles for normal in ((-1.0, 0, 0), (0, -1.0, 0))
             for c in wall_contacts(p, count, (0, 0, 0), np.array(normal))]
    return pairs, walls


class PilingOfSubspheres(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with ThreadPoolExecutor(2) as pool:
            cls.piles = dict(zip(COUNTS, pool.map(pile, COUNTS)))

    def test_nothing_is_lost(self):
        for count, frames in self.piles.items():
            sizes = [len(particles) for particles in frames]
            self.assertEqual(sizes, sorted(sizes), count)
            # short chains roll away slowly: the last few particles wait for their place to be free
            self.assertGreaterEqual(sizes[-1], PARTICLES if count > 3 else PARTICLES // 2, count)

    def test_overlaps_are_small(self):
        for count, frames in self.piles.items():
            pairs, walls = [sum(lists, []) for lists in zip(*(overlaps(p, count) for p in frames))]
            deepest = max(pairs + walls)
            print(f"N = {count}: {len(frames)} frames, {len(pairs)} and {len(walls)} contacts of spheres "
                  f"with each other and with walls, largest overlap {deepest / B:.1e} b")
            self.assertGreater(len(pairs) + len(walls), 20, count)
            self.assertLess(deepest, DEEPEST, count)
            self.assertEqual(max(abs(p.position[2]) for particles in frames for p in particles), 0.0,
                             "left the plane")


if __name__ == "__main__":
    unittest.main(verbosity=2)
