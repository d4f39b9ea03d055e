"""A run that is interrupted and goes on from its restart file against the run in one go.

What the restart file must give back: every particle with its motion, the contact history (springs and
remembered normals) and the schedule of fix insert/drop. The input is the paper's piling problem.
"""

import unittest
from pathlib import Path

import numpy as np

from _engine import LAW, Setup, dump, run

HALF, DROPS = 30000, 30
SAMPLE = 200


def pile(start):
    """Script of a small in-plane pile; `start` reads the restart file or makes the box."""
    setup = Setup(box=(0.0, 0.1, -0.005, 0.1, -0.01, 0.01), boundary="m m f", time_step=5e-6,
                  damping_normal=20000.0, damping_tangential=20000.0)
    return setup.header() + start(setup) + setup.properties() + f"""
fix gravity all gravity 9.81 vector 0 -1 0
fix wall all wall/gran/ellipsoid {LAW} surface smooth primitive type 1 xplane 0.0
fix floor all wall/gran/ellipsoid {LAW} surface smooth primitive type 1 yplane 0.0
fix grain all particletemplate/ellipsoid 15485863 atom_type 1 semiaxes 2.7e-3 1.15e-3 1.15e-3 &
    mass 2e-5 inertia 1.058e-11 3.445e-11 3.445e-11 orientation planar
fix drop all insert/drop seed 3 template grain particles {DROPS} interval 8e-3 &
    box 0.003 0.02 0.03 0.03 0 0 velocity 0 -0.5 0
fix motion all nve/ellipsoid planar yes
"""


class Restart(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        whole = pile(lambda setup: setup.create_box())
        end = 2 * HALF
        run(whole + f"run {HALF}\nwrite_restart half.restart\n" + dump("whole.dump", SAMPLE)
            + f"run {HALF}\n", name="in.whole")
        run(whole + f"restart {HALF} one_go.restart.*\n" + dump("one_go.dump", SAMPLE) + f"run {end}\n",
            name="in.one_go")
        for name, file in (("again", "half.restart"), ("twice", "half.restart"),
                           ("periodic", f"one_go.restart.{HALF}")):
            again = pile(lambda setup: f"read_restart {file}\n")
            run(again + dump(f"{name}.dump", SAMPLE) + f"run {HALF}\n", name=f"in.{name}")
        cls.end = end

    @staticmethod
    def frames(file):
        """{step: {id: values}}."""
        frames, lines, at = {}, Path(file).read_text().splitlines(), 0
        while at < len(lines):
            count = int(lines[at + 3])
            rows = [line.split() for line in lines[at + 9:at + 9 + count]]
            frames[int(lines[at + 1])] = {int(r[0]): np.array(r[1:], float) for r in rows}
            at += 9 + count
        return frames

    def test_write_restart_goes_on_bit_for_bit(self):
        self.compare("whole.dump", "again.dump")

    def test_periodic_restart_file_holds_the_same_state(self):
        # Against the run in one go only the forces at the interruption differ: LIGGGHTS evaluates them
        # with the velocities of the whole step when it sets up a run, and of the half step during it.
        self.assertEqual(Path("periodic.dump").read_bytes(), Path("again.dump").read_bytes())

    def test_run_in_one_go_stays_close(self):
        # without the springs bodies would be off by about mu g t^2/2 = 1.5e-6 m after 200 steps; later
        # on collisions amplify any difference
        one_go, again = self.frames("one_go.dump"), self.frames("periodic.dump")
        position = slice(2, 5)
        worst = max(np.abs(one_go[HALF + SAMPLE][i][position] - row[position]).max()
                    for i, row in again[HALF + SAMPLE].items())
        print(f"positions after {SAMPLE} further steps differ by {worst:.1e} m from the run in one go")
        self.assertEqual(max(np.abs(one_go[HALF][i][:11] - row[:11]).max()
                             for i, row in again[HALF].items()), 0.0)
        self.assertLess(worst, 1e-7)

    def compare(self, whole, again):
        whole, again = self.frames(whole), self.frames(again)
        whole = {step: rows for step, rows in whole.items() if step >= HALF}
        self.assertEqual(whole.keys(), again.keys())
        torque = 16  # of a body that rests on others or on a wall
        touched = sum(values[torque] != 0.0 for values in whole[HALF].values())
        self.assertGreater(touched, 5, "hardly any contact at the interruption")
        self.assertEqual(max(whole), self.end)
        self.assertEqual(len(whole[self.end]), DROPS)
        self.assertGreater(len(whole[self.end]), len(whole[HALF]), "no drop after the interruption")
        for step in sorted(whole):
            self.assertEqual(whole[step].keys(), again[step].keys(), f"step {step}")
            for i, values in whole[step].items():
                difference = np.abs(values - again[step][i])
                worst = int(difference.argmax())
                self.assertEqual(difference.max(), 0.0, f"step {step}, particle {i}, column {worst + 1}: "
                                 f"{values[worst]!r} and {again[step][i][worst]!r}")

    def test_the_same_restart_gives_the_same_run(self):
        self.assertEqual(Path("again.dump").read_bytes(), Path("twice.dump").read_bytes())


if __name__ == "__main__":
    unittest.main(verbosity=2)
