"""A pair that touches when a run is set up and is apart in its first step, in which the neighbour lists are made
anew: nothing of it may be left. In a periodic box shorter than two bodies it is the other image of a pair that goes
on touching, whose friction spring must last.

The same run with lists that are not made anew, and brute force (_brute_force.py), are what it is compared with.
"""

import unittest

import numpy as np

from _brute_force import REPLAYED, BruteForce, Law, replay
from _engine import Particle, Setup, dump, read_dump, run

AXES, LENGTH, STEPS, TIME_STEP = (2e-3, 1e-3, 1e-3), 8e-3 - 1.1e-9, 100, 1e-6


def script(check, by_image):
    """Body 2 overlaps body 1 on its left and the next image of it on its right, one of them by 1e-9 m and the other by
    1e-10 m, from which it moves away; both slide along each other."""
    overlap, speed = (1e-10, 0.01) if by_image else (1e-9, -0.01)
    bodies = [Particle((1e-3, 0.0, 0.0), AXES),
              Particle((1e-3 + 4e-3 - overlap, 0.0, 0.0), AXES, velocity=(speed, 0.3, 0.0))]
    setup = Setup(box=(0.0, LENGTH, -0.01, 0.01, -0.01, 0.01), boundary="p f f", time_step=TIME_STEP, friction=0.5)
    form = " ".join("%d" if c in ("id", "type") else "%.17g" for c in REPLAYED)
    return (setup.with_particles(bodies) + f"neigh_modify every 1 delay 0 check {check}\nfix motion all nve/ellipsoid\n"
            + dump(f"{check}.dump", columns=REPLAYED) + f'dump_modify d format "{form}"\nrun {STEPS}\n')


class ContactFlags(unittest.TestCase):
    def test_spring_lasts_beside_a_contact_that_ended_at_once(self):
        for by_image in (False, True):
            with self.subTest(by_image=by_image):
                self.compare(by_image)

    def compare(self, by_image):
        frames = {}
        for check in ("yes", "no"):
            run(script(check, by_image), name=f"in.{check}")
            steps, c = read_dump(f"{check}.dump")
            frames[check] = np.stack([c[n] for n in REPLAYED], -1)
        forces = {check: f[:, :, 19:22] for check, f in frames.items()}
        largest = np.abs(forces["yes"]).max()
        self.assertLess(np.abs(forces["yes"] - forces["no"]).max(), 1e-9 * largest)
        self.assertGreater(np.abs(forces["yes"][-1, 0, 1]), 0.05 * largest)  # friction
        self.brute_force(frames["no"], largest)

    def brute_force(self, frames, largest):
        law = Law([(183e6, 0.2)], [[0.5]], [[100.0]], [[100.0]], TIME_STEP)
        brute = BruteForce(law, (LENGTH, np.inf, np.inf))
        for k, (force, _, rows) in enumerate(replay(brute, frames, TIME_STEP)):
            self.assertEqual(len(rows), 2 if k == 0 else 1)
            self.assertLess(np.abs(force - frames[k][:, 19:22]).max(), 1e-8 * largest, f"step {k}")


if __name__ == "__main__":
    unittest.main(verbosity=2)
