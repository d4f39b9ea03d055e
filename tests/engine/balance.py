"""fix and command balance/ellipsoid: the planes are the best there are, and particles move as on one rank, to
rounding, on 2 and 4 ranks; insertion and meshes: balance_insertion.py."""

import itertools
import re
import unittest
from pathlib import Path

import numpy as np

from _balance import SHOW, SIDE, counts, crowd, follow, heap, largest_differences, planes_in, ranks_of, shifts
from _engine import Setup, dump, read_dump, run, thermo, vectors

STEPS = 300


class Trajectories(unittest.TestCase):
    def compare(self, fix, grids, surface="smooth", least_shifts=1):
        one, _ = follow(f"one_{surface}", crowd("1 1 1", surface=surface), "1 1 1", STEPS, STEPS // 3)
        touched = (one["tqx"] != 0.0).any(axis=0).sum()
        self.assertGreater(touched, 30)
        for grid in grids:
            name = f"{surface}_{grid.replace(' ', '')}"
            other, _ = follow(name, crowd(grid, fix + SHOW, surface), grid, STEPS, STEPS // 3)
            worst = largest_differences(one, other)
            rows = thermo(f"log.in.{name}", 7)
            print(f"{surface}, {grid}: {touched} touched, {rows[-1, 5]:.0f} shifts, imbalance at first "
                  f"{rows[0, 3]:.2f}, largest relative differences "
                  + ", ".join(f"{name} {w:.0e}" for name, w in worst.items()))
            self.assertGreaterEqual(rows[-1, 5], least_shifts)
            self.assertGreater(rows[0, 3], 1.2)
            self.assertLess(max(worst.values()), 1e-11, grid)

    def test_smooth_in_one_two_and_three_directions(self):
        self.compare("fix share all balance/ellipsoid every 20 threshold 1.0\n",
                     ["2 1 1", "4 1 1", "2 1 2"])

    def test_multispheres(self):
        self.compare("fix share all balance/ellipsoid every 20 threshold 1.0\n", ["2 2 1"], "multisphere")

    def test_bricks_much_thinner_than_a_particle(self):
        """Bricks of 2.2 mm and less, particles of 6 mm: ghosts come from ranks that are further away."""
        self.compare("fix share all balance/ellipsoid every 30 threshold 1.0 width 2e-4\n", ["4 1 1", "1 1 4"],
                     least_shifts=5)

    def test_by_time(self):
        self.compare("fix share all balance/ellipsoid every 50 threshold 1.0 by time\n", ["2 1 1"])

    def test_two_runs_are_the_same_bit_for_bit(self):
        fix = "fix share all balance/ellipsoid every 20 threshold 1.05\n"
        for name in "first", "second":
            follow(name, crowd("2 2 1", fix), "2 2 1", STEPS, 50)
        self.assertEqual(Path("first.dump").read_bytes(), Path("second.dump").read_bytes())

    def test_spheres_of_the_host(self):
        setup = Setup(box=(0.0, SIDE) * 3, boundary="p p p", time_step=2e-6, skin=2e-4, atom_style="sphere",
                      pair="gran model hertz tangential history")
        columns = "id x y z vx vy vz omegax omegay omegaz".split()

        def trajectory(name, grid, fix):
            script = setup.with_particles(heap(axes=(1.05e-3,) * 3), "spheres.data")
            run(script.replace("read_data", f"processors {grid}\nread_data") + "fix motion all nve/sphere\n" + fix
                + dump(f"{name}.dump", 100, columns) + f"run {STEPS}\n", ranks_of(grid), name=f"in.{name}")
            return read_dump(f"{name}.dump")[1]
        one = trajectory("spheres1", "1 1 1", "")
        two = trajectory("spheres2", "2 1 1", "fix share all balance/ellipsoid every 20 threshold 1.0\n" + SHOW)
        self.assertGreater(shifts("log.in.spheres2"), 0)
        self.assertGreater((one["omegax"][-1] != one["omegax"][0]).sum(), 20)
        for names in ("x", "y", "z"), ("vx", "vy", "vz"), ("omegax", "omegay", "omegaz"):
            difference = vectors(one, *names) - vectors(two, *names)
            difference -= SIDE * np.round(difference / SIDE) if names[0] == "x" else 0.0
            self.assertLess(np.abs(difference).max(), 1e-11 * np.abs(vectors(one, *names)).max())


class Planes(unittest.TestCase):
    def planes(self, name, grid, fix, particles):
        run(crowd(grid, fix + SHOW, particles=particles, boundary="f f f") + f"run 0\nwrite_restart {name}.restart\n",
            ranks_of(grid), name=f"in.{name}")
        places = np.array([p.position for p in particles])
        return counts(places, planes_in(f"{name}.restart")), thermo(f"log.in.{name}", 7)[-1]

    def test_no_planes_across_one_direction_are_better(self):
        particles = heap(71)
        for k, grid in enumerate(["4 1 1", "1 4 1", "1 1 4"]):
            found, row = self.planes(f"line{k}", grid, "fix share all balance/ellipsoid every 9 threshold 1 width 1e-6\n",
                                     particles)
            self.assertEqual(found.sum(), 71)
            self.assertEqual(found.max(), 18)  # 71 = 18 + 18 + 18 + 17
            self.assertEqual(row[6], 18)
            self.assertAlmostEqual(row[2], 18 * 4 / 71, places=6)
            self.assertEqual(row[2], row[4])

    def test_planes_across_two_directions_are_near_the_best(self):
        """Of all planes between centres (brute force): the fix plans one direction after the other."""
        particles = heap(31)
        found, row = self.planes("square", "2 2 1", "fix share all balance/ellipsoid every 9 threshold 1 width 1e-6\n",
                                 particles)
        x, y = np.array([p.position[:2] for p in particles]).T
        best = min(max(np.sum(left & low), np.sum(left & ~low), np.sum(~left & low), np.sum(~left & ~low))
                   for left, low in itertools.product((x < p for p in x), (y < p for p in y)))
        print(f"31 particles, 2 x 2 ranks: {found.max():.0f} on one, {best} with the best of all planes")
        self.assertGreaterEqual(found.max(), best)
        self.assertLessEqual(found.max(), best + 1)
        self.assertLess(row[4], 1.3)

    def test_least_width_and_directions(self):
        particles = heap(71)
        name = "wide"
        self.planes(name, "2 2 1", "fix share all balance/ellipsoid every 9 threshold 1 directions x width 0.008\n",
                    particles)
        planes = planes_in(f"{name}.restart")
        np.testing.assert_array_equal(planes[1], [0.0, 0.5, 1.0])
        self.assertAlmostEqual(SIDE * planes[0][1], 0.008, delta=1e-6)
        self.planes("standard", "4 1 1", "fix share all balance/ellipsoid every 9 threshold 1\n", particles)
        widths = SIDE * np.diff(planes_in("standard.restart")[0])
        self.assertGreaterEqual(widths.min(), SIDE / 8 - 1e-12)  # the reach of ghosts is wider

    def test_nothing_is_shifted_below_the_threshold(self):
        _, row = self.planes("calm", "2 1 1", "fix share all balance/ellipsoid every 9 threshold 5\n", heap(71))
        self.assertEqual(row[5], 0)
        self.assertEqual(row[3], row[4])
        np.testing.assert_array_equal(planes_in("calm.restart")[0], [0.0, 0.5, 1.0])

    def test_command(self):
        outcome = run(crowd("4 1 1", "balance/ellipsoid width 1e-6\n", particles=heap(71)) + dump("command.dump", 100)
                      + "run 100\n", 4, name="in.command")
        found = re.search(r"balance/ellipsoid: imbalance ([\d.]+) before, ([\d.]+) after", outcome.text)
        self.assertGreater(float(found[1]), 1.2)
        self.assertAlmostEqual(float(found[2]), 18 * 4 / 71, delta=1e-3)
        one, _ = follow("command1", crowd("1 1 1", particles=heap(71)), "1 1 1", 100, 100)
        self.assertLess(max(largest_differences(one, read_dump("command.dump")[1]).values()), 1e-9)


BAD = {
    "every": ["every 0", "every 1.5", "every abc", ""],
    "threshold": ["every 5 threshold 0.9", "every 5 threshold x", "every 5 threshold nan", "every 5 threshold"],
    "by": ["every 5 by weight", "every 5 by"],
    "directions": ["every 5 directions a", "every 5 directions xx", "every 5 directions"],
    "width": ["every 5 width 0", "every 5 width -1", "every 5 width wide"],
    "shift": ["every 5 shift xyz"],
}


class BadInput(unittest.TestCase):
    def fails(self, script, *words):
        outcome = run(script + "run 1\n", 2, check=False, name="in.bad")
        self.assertNotEqual(outcome.code, 0)
        lines = [line for line in outcome.text.splitlines() if line.startswith("ERROR")]
        self.assertEqual(len(lines), 1, outcome.text[-2000:])
        for word in words:
            self.assertIn(word, lines[0])

    def test_each_in_one_line(self):
        particles = heap(9)
        for keyword, cases in BAD.items():
            for case in cases:
                with self.subTest(case):
                    self.fails(crowd("2 1 1", f"fix share all balance/ellipsoid {case}\n", particles=particles),
                               "balance/ellipsoid", keyword)
        twice = "fix {} all balance/ellipsoid every 5\n"
        self.fails(crowd("2 1 1", twice.format("a") + twice.format("b"), particles=particles), "remove one")
        self.fails(crowd("2 1 1", "group some id 1\nfix share some balance/ellipsoid every 5\n", particles=particles),
                   "group 'all'")
        self.fails(crowd("2 1 1", "balance/ellipsoid every 5\n", particles=particles), "balance/ellipsoid", "every")
        self.fails("balance/ellipsoid\n", "balance/ellipsoid", "create_box")


if __name__ == "__main__":
    unittest.main(verbosity=2)
