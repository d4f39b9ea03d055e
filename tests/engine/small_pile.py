"""The pile of inputs/quickstart.sh: 100 particles beside a wall, for two seeds. The pile comes to rest, nothing is lost, nothing overlaps by more than 5 % of b, its figures lie in stated ranges.

Overlaps and contacts are found again from the dump by ellipses in the plane, without the engine's
formulas. The ranges are wide: so few particles pile up differently for each seed.
"""

import math
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

from _contact_geometry import contact, shape_matrix
from _engine import kinetic_energy, read_dump, rotation, run_example, thermo

PARTICLES, A, B, MASS, GRAVITY = 100, 2.7e-3, 1.15e-3, 2e-5, 9.81


def pile(seed):
    """Run the piling input; returns the last frame as (columns {name: (N,)}, thermo rows)."""
    changes = {"seed": seed, "particles": PARTICLES, "dt": 5e-6, "out": f"pile{seed}", "settle": 3.0,
               "y0": 0.05, "dump_time": 0.5, "vtk": "no"}
    run_example("piling", changes)
    last = sorted(Path(f"pile{seed}").glob("pile.*.dump"))[-1]
    _, columns = read_dump(last)
    return columns, thermo(f"pile{seed}/log.piling")


def overlaps(columns):
    """Overlaps (m) of all touching pairs, and the number of contacts with wall and floor."""
    place = np.stack([columns[n][0] for n in "xyz"], axis=1)
    quaternions = np.stack([columns[f"quat{k}"][0] for k in (1, 2, 3, 4)], axis=1)
    shapes = [shape_matrix((A, B, B), rotation(q)) for q in quaternions]
    found = []
    for i in range(len(place)):
        for j in range(i + 1, len(place)):
            if np.linalg.norm(place[j] - place[i]) < 2.0 * A and _may_touch(
                    shapes[i], shapes[j], place[j] - place[i]):
                overlap = contact(shapes[i], shapes[j], place[j] - place[i])[1]
                if overlap > 0.0:
                    found.append(overlap)
    half = [np.sqrt(np.diag(np.linalg.inv(s)))[:2] for s in shapes]
    gaps = place[:, :2] - np.array(half)
    return np.array(found), int((gaps < 0.0).sum()), float(gaps.min())


def _may_touch(shape_i, shape_j, distance):
    """False when one of 180 lines in the plane separates the two by more than 2 % of b."""
    angle = np.linspace(0.0, 2.0 * math.pi, 180, endpoint=False)
    normals = np.stack([np.cos(angle), np.sin(angle), 0.0 * angle], axis=1)
    reach = sum(np.sqrt(np.einsum("ki,ij,kj->k", normals, np.linalg.inv(s), normals))
                for s in (shape_i, shape_j))
    return (reach - normals @ distance).min() > -0.02 * B


class SmallPile(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with ThreadPoolExecutor(2) as pool:
            cls.piles = dict(zip((1, 2), pool.map(pile, (1, 2))))

    def test_nothing_is_lost(self):
        for columns, rows in self.piles.values():
            self.assertEqual(sorted(columns["id"][0]), list(range(1, PARTICLES + 1)))
            self.assertEqual(rows[-1, 2], PARTICLES)

    def test_comes_to_rest(self):
        # The four fifths nearest to the wall; nothing in this law resists rolling, so a body that has
        # left the pile rolls on along the floor, and others rock a little.
        for seed, (columns, _) in self.piles.items():
            inside = columns["x"][0] < np.quantile(columns["x"][0], 0.8)
            pile_only = {name: values[:, inside] for name, values in columns.items()}
            fall = kinetic_energy(pile_only)[0] / inside.sum() / (MASS * GRAVITY * B)
            speed = np.hypot(columns["vx"][0], columns["vy"][0])
            print(f"seed {seed}: mean kinetic energy is that of a fall by {fall:.1e} b, largest speed "
                  f"{speed[inside].max():.1e} m/s in the pile, {speed.max():.1e} m/s of all")
            self.assertLess(fall, 1e-3)

    def test_no_large_overlap(self):
        for seed, (columns, _) in self.piles.items():
            found, _, deepest_gap = overlaps(columns)
            print(f"seed {seed}: {len(found)} contacts, largest overlap {found.max() / B:.2e} b, "
                  f"with walls {max(0.0, -deepest_gap) / B:.2e} b")
            self.assertLess(max(found.max(), -deepest_gap), 0.05 * B)

    def test_figures_of_the_pile(self):
        for seed, (columns, rows) in self.piles.items():
            found, walls, _ = overlaps(columns)
            coordination = 2.0 * len(found) / PARTICLES
            x, y = columns["x"][0], columns["y"][0]
            most = np.quantile(x, 0.8)  # the rest rolls far: nothing in this law resists rolling
            upper = (y > 2.0 * B).mean()
            print(f"seed {seed}: coordination {coordination:.2f}, {walls} contacts with walls, four "
                  f"fifths within {most:.4f} m, height {y.max() + B:.4f} m, {upper:.2f} above the floor")
            self.assertEqual(int(round(rows[-1, 5])), len(found), "contacts counted by the engine")
            self.assertTrue(2.7 < coordination < 3.8)
            self.assertTrue(B < y.min() + 1e-5 and 14.0 * B < y.max() + B < 34.0 * B)
            self.assertTrue(0.6 < upper < 0.9)
            self.assertTrue(12.0 * A < most < 30.0 * A)
            self.assertEqual(np.abs(columns["z"][0]).max(), 0.0)


if __name__ == "__main__":
    unittest.main(verbosity=2)
