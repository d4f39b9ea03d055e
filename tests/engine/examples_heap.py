"""Heaps poured from a narrow hopper on to a dish by inputs/hopper.in: the angle of repose grows from spheres to both sides.

Reference: Zhou, Zou, Pinson, Yu, Granular Matter 16, 695 (2014): with aspect ratios that deviate from 1 the angle of repose of
a sandpile grows, for discs as for rods. Here: particles of one volume, friction 0.5, rolling friction 0.1; the dish has a rim
of one and a half particles, and what is too much falls over it.

The angle is measured here from the centres of the highest particles in cells of rings and sectors, by NumPy.

ELLIPSOID_HEAP_FULL=1: six aspect ratios and three seeds, as a table.
"""

import os
import unittest
from pathlib import Path

import numpy as np

from _engine import read_dump, run_example, thermo

FULL = bool(os.environ.get("ELLIPSOID_HEAP_FULL"))
ASPECTS = (0.4, 0.6, 1.0, 1.5, 2.35, 3.5) if FULL else (0.5, 1.0, 2.0)
SEEDS = (32452867, 49979687, 86028121) if FULL else (32452867,)
DISH, PARTICLES = 0.6, 1150
RADIUS = 6.8e-4  # m, of the sphere of the same volume
OUTLET = 0.018  # m, height of the hopper's


def angle_of_centres(columns, sectors=8):
    """Angle of repose (deg) of the heap on the dish: least squares line through the mean over sectors of the highest centre
    in rings as wide as 2 RADIUS, from 0.3 to 0.9 of the dish's radius; without what is still in the hopper."""
    below = columns["z"][0] < OUTLET
    x, y, z = (columns[name][0, below] for name in "xyz")
    turn = np.floor((np.arctan2(y, x) / (2.0 * np.pi) + 0.5) * sectors).astype(int) % sectors
    ring = np.floor(np.hypot(x, y) / (2.0 * RADIUS)).astype(int)
    heights = np.full((ring.max() + 1, sectors), np.nan)
    np.fmax.at(heights, (ring, turn), z)
    middles = (np.arange(len(heights)) + 0.5) * 2.0 * RADIUS / (0.025 * DISH)
    flank = (middles > 0.3) & (middles < 0.9)
    slope = np.polyfit(middles[flank], np.nanmean(heights[flank], axis=1) / (0.025 * DISH), 1)[0]
    return np.degrees(np.arctan(-slope))


def heap(aspect, seed):
    """Angle and number of particles."""
    out = f"heap_{aspect}_{seed}"
    run_example("hopper", {"mesh": "hopper_narrow.stl", "meshes": Path(os.environ["ELLIPSOID_SOURCE"]) / "inputs" / "meshes",
                           "ground": "dish", "dish": DISH, "particles": PARTICLES, "a": RADIUS * aspect ** (2.0 / 3.0),
                           "b": RADIUS * aspect ** (-1.0 / 3.0), "mu": 0.5, "mu_r": 0.1, "fill": 0.12, "flow": 0.9, "seed": seed,
                           "dump_time": 0.1, "out": out}, timeout=3000)
    rows = thermo(f"{out}/log.hopper", columns=7)
    placed, last = rows[0, 2], rows[-1]
    assert placed > 0.98 * PARTICLES and last[3] > 0.99 * placed, "a few still roll about in the hopper"
    # no particle moves faster, in the mean, than one that has fallen by a tenth of its radius
    file = sorted(Path(out).glob("hopper.*.dump"))[-1]
    columns = read_dump(file)[1]
    assert last[5] < 0.1 * columns["mass"].sum() * 9.81 * RADIUS, last
    return angle_of_centres(columns), columns["id"].shape[1]


class Heap(unittest.TestCase):
    def test_angle_over_aspect_ratio(self):
        found = {}
        for aspect in ASPECTS:
            angles, counts = np.transpose([heap(aspect, seed) for seed in SEEDS])
            found[aspect] = angles.mean()
            print(f"| {aspect:g} | {angles.mean():.1f} | {angles.min():.1f} to {angles.max():.1f} | {counts.mean():.0f} |",
                  flush=True)
        middle = ASPECTS.index(1.0)
        for nearer, farther in ((middle, middle - 1), (middle, middle + 1)):
            self.assertGreater(found[ASPECTS[farther]], found[ASPECTS[nearer]] + 3.0)


if __name__ == "__main__":
    unittest.main(verbosity=2)
