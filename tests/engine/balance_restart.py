"""fix balance/ellipsoid in restart files: a run goes on bit for bit on the same grid of ranks, with the planes of
the run that wrote the file, and to rounding on another grid."""

import unittest
from pathlib import Path

import numpy as np

from _balance import crowd, largest_differences, planes_in, ranks_of
from _engine import dump, read_dump, run

FIX = "fix share all balance/ellipsoid every 70 threshold 1.02\n"
EVERY, STEPS = 100, 300


def frames(file, begin):
    """Text of the frames from step `begin` on."""
    parts = Path(file).read_text().split("ITEM: TIMESTEP\n")[1:]
    return [part for part in parts if int(part.split("\n")[0]) >= begin]


class Restart(unittest.TestCase):
    def one_go(self, name, grid, surface, boundary="p p p"):
        script = crowd(grid, FIX, surface, boundary)
        run(script + f"restart {EVERY} {name}.*.restart\n" + dump(f"{name}.dump", EVERY // 2) + f"run {STEPS}\n",
            ranks_of(grid), name=f"in.{name}")
        return script

    def go_on(self, script, restart, grid, name, fix=FIX):
        lines = [f"processors {grid}" if line.startswith("processors") else
                 f"read_restart {restart}" if line.startswith("read_data") else line
                 for line in script.replace(FIX, fix).splitlines()]
        run("\n".join(lines) + f"\nrestart {EVERY} {name}.again.*\n" + dump(f"{name}.dump", EVERY // 2)
            + f"run {STEPS} upto\n", ranks_of(grid), name=f"in.{name}")

    def test_bit_for_bit_on_the_same_grid(self):
        for grid, surface, boundary in (("2 1 1", "multisphere", "p p p"), ("2 2 1", "smooth", "m m m")):
            name = f"whole_{surface}_{grid.replace(' ', '')}"
            script = self.one_go(name, grid, surface, boundary)
            for step in (EVERY, 2 * EVERY):
                with self.subTest(grid=grid, surface=surface, step=step):
                    restart = f"{name}.{step}.restart"
                    uneven = [np.abs(np.diff(p) - 1.0 / (len(p) - 1)).max() for p in planes_in(restart)]
                    self.assertGreater(max(uneven), 0.05)
                    self.go_on(script, restart, grid, f"again_{step}")
                    self.assertEqual(frames(f"{name}.dump", step), frames(f"again_{step}.dump", step))
                    np.testing.assert_array_equal(np.concatenate(planes_in(f"again_{step}.again.{STEPS}")),
                                                  np.concatenate(planes_in(f"{name}.{STEPS}.restart")))

    def test_to_rounding_on_other_grids_and_without_the_fix(self):
        script = self.one_go("source", "2 2 1", "smooth")
        whole = {step: text for step, text in zip((200, 250, 300), frames("source.dump", 200))}
        self.assertEqual(len(whole), 3)
        for name, grid, fix in (("other", "2 1 1", FIX), ("one", "1 1 1", FIX), ("without", "2 2 1", "")):
            self.go_on(script, "source.200.restart", grid, name, fix)
            steps, other = read_dump(f"{name}.dump")
            all_steps, all_columns = read_dump("source.dump")
            same = {k: v[np.isin(all_steps, steps)] for k, v in all_columns.items()}
            worst = largest_differences(same, other)
            print(name, grid, worst)
            self.assertLess(max(worst.values()), 1e-9)

    def test_files_of_each_rank(self):
        """`%`: every rank reads some of the files, and particles go to their ranks by the planes."""
        script = crowd("2 2 1", FIX)
        run(script + f"run 100\nwrite_restart many.%.restart\nrestart {EVERY} many.again.*\n"
            + dump("many.dump", 50) + "run 200\n", 4, name="in.many")
        self.go_on(script, "many.%.restart", "2 2 1", "from_many")
        _, whole = read_dump("many.dump")
        steps, again = read_dump("from_many.dump")
        same = {k: v[steps <= 300] for k, v in again.items()}
        self.assertLess(max(largest_differences(whole, same).values()), 1e-9)


if __name__ == "__main__":
    unittest.main(verbosity=2)
