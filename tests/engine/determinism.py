"""Same input, same bits; 1, 2 and 4 ranks: the same inserted particles and the same trajectories to
rounding while the collisions have not yet amplified it."""

import unittest
from pathlib import Path

import numpy as np

from _engine import LAW, Setup, dump, read_dump, run, vectors

DROPS = 40


def rain():
    """Ellipsoids dropped one by one, turned at random, into a box with a floor."""
    setup = Setup(box=(-0.012, 0.012, -0.012, 0.012, -0.001, 0.03), time_step=5e-6, skin=0.001,
                  boundary="p p f")
    return setup.without_particles() + f"""
fix gravity all gravity 9.81 vector 0 0 -1
fix floor all wall/gran/ellipsoid {LAW} surface smooth primitive type 1 zplane 0.0
fix grain all particletemplate/ellipsoid 15485863 atom_type 1 semiaxes 2.7e-3 1.8e-3 1.2e-3 density 1340
fix drop all insert/drop seed 4711 template grain particles {DROPS} interval 2e-3 &
    box -0.0115 0.0115 -0.0115 0.0115 0.019 0.023 velocity 0 0 -0.5
fix motion all nve/ellipsoid
"""


def rows_by_id(file):
    """{(step, id): tokens} of a text dump with any number of particles per frame."""
    rows, step = {}, None
    lines = Path(file).read_text().splitlines()
    at = 0
    while at < len(lines):
        step, count = int(lines[at + 1]), int(lines[at + 3])
        for line in lines[at + 9:at + 9 + count]:
            tokens = line.split()
            rows[step, int(tokens[0])] = tokens
        at += 9 + count
    return rows


class Determinism(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        for name, ranks in (("a1", 1), ("b1", 1), ("a2", 2), ("b2", 2), ("a4", 4)):
            # often enough that no particle has hit anything at its first frame
            script = rain() + dump(f"{name}.dump", 100) + "run 24000\n"
            run(script, ranks, name=f"in.{name}")

    def test_same_run_same_bits(self):
        for ranks in 1, 2:
            first, second = (Path(f"{n}{ranks}.dump").read_bytes() for n in "ab")
            self.assertGreater(len(first), 100000)
            self.assertEqual(first, second, f"{ranks} ranks")

    def test_nothing_is_lost(self):
        for name in "a1", "a2", "a4":
            rows = rows_by_id(f"{name}.dump")
            last = max(step for step, _ in rows)
            self.assertEqual(sorted(i for step, i in rows if step == last), list(range(1, DROPS + 1)))

    def test_same_particles_on_any_number_of_ranks(self):
        # at the first frame after its drop a particle has fallen freely: exactly the same numbers
        one = self.first_rows("a1.dump")
        self.assertEqual(len(one), DROPS)
        for name in "a2", "a4":
            other = self.first_rows(f"{name}.dump")
            for particle, (step, tokens) in one.items():
                self.assertEqual((step, tokens), other[particle], f"{name}, particle {particle}")

    @staticmethod
    def first_rows(file):
        first = {}
        for (step, particle), tokens in sorted(rows_by_id(file).items()):
            kinematic = tokens[:12] + tokens[18:]
            first.setdefault(particle, (step, kinematic))
        return first

    def test_same_trajectories_to_rounding(self):
        one = rows_by_id("a1.dump")
        for name in "a2", "a4":
            other = rows_by_id(f"{name}.dump")
            self.assertEqual(one.keys(), other.keys())
            differences, hits = [], 0
            for (step, particle), tokens in one.items():
                position = np.array(tokens[3:6], float) - np.array(other[step, particle][3:6], float)
                position[:2] -= 0.024 * np.round(position[:2] / 0.024)
                differences.append((step, np.abs(position).max() / 1e-3))
                hits += step <= 14000 and tokens[15] != "0" and float(tokens[16]) != 0.0
            early = max(d for step, d in differences if step <= 14000)
            late = max(d for _, d in differences)
            print(f"{name}: largest difference {early:.1e} mm in the first 14000 steps "
                  f"({hits} moments of contact), {late:.1e} mm in 24000")
            self.assertGreater(hits, 10)
            self.assertLess(early, 1e-9)


if __name__ == "__main__":
    unittest.main(verbosity=2)
