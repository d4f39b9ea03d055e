"""A run that is interrupted and goes on from its restart file against the run in one go.

What the restart file must give back: every particle with its motion, the contact history (springs and
remembered normals) and the schedule of fix insert/drop. The input is the paper's piling problem.
"""

import re
import struct
import unittest
from pathlib import Path

import numpy as np

from _engine import LAW, Setup, dump, run

HALF, DROPS = 30000, 30
SAMPLE, EVERY = 200, 9000


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
        cls.end = 2 * HALF
        whole = pile(lambda setup: setup.create_box())
        run(whole + f"run {HALF}\nwrite_restart half.restart\n" + dump("whole.dump", SAMPLE)
            + f"run {HALF}\n", name="in.whole")
        again = pile(lambda setup: "read_restart half.restart\n")
        for name in "again", "twice":
            run(again + dump(f"{name}.dump", SAMPLE) + f"run {HALF}\n", name=f"in.{name}")

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
        self.compare("whole.dump", "again.dump", HALF)

    def test_any_restart_file_goes_on_as_the_run_in_one_go(self):
        restart = f"restart {EVERY} {{0}}.*.restart\n"
        for ranks in 1, 2:
            name = f"one_go{ranks}"
            run(pile(lambda setup: setup.create_box()) + restart.format(name) + dump(f"{name}.dump", SAMPLE)
                + f"run {self.end}\n", ranks, name=f"in.{name}")
            falling = 0
            for step in range(EVERY, self.end, EVERY):
                with self.subTest(ranks=ranks, step=step):
                    again = f"{name}.again{step}"
                    run(pile(lambda setup: f"read_restart {name}.{step}.restart\n") + restart.format("again")
                        + dump(again, SAMPLE) + f"run {self.end} upto\n", ranks, name=f"in.{again}")
                    falling += self.compare(f"{name}.dump", again, step)
            self.assertGreater(falling, 2, "no particle was in the air at the interruptions")

    def compare(self, whole, again, begin):
        """From step `begin` on; returns how many particles touched nothing then."""
        whole, again = self.frames(whole), self.frames(again)
        whole = {step: rows for step, rows in whole.items() if step >= begin}
        self.assertEqual(whole.keys(), again.keys())
        torque = 16  # of a body that rests on others or on a wall
        touched = sum(values[torque] != 0.0 for values in whole[begin].values())
        if begin >= HALF:
            self.assertGreater(touched, 5, "hardly any contact at the interruption")
        else:
            self.assertGreater(len(whole[self.end]), len(whole[begin]), "no drop after the interruption")
        self.assertEqual(max(whole), self.end)
        self.assertEqual(len(whole[self.end]), DROPS)
        for step in sorted(whole):
            self.assertEqual(whole[step].keys(), again[step].keys(), f"step {step}")
            for i, values in whole[step].items():
                difference = np.abs(values - again[step][i])
                worst = int(difference.argmax())
                self.assertEqual(difference.max(), 0.0, f"step {step}, particle {i}, column {worst + 1}: "
                                 f"{values[worst]!r} and {again[step][i][worst]!r}")
        return len(whole[begin]) - touched

    def test_a_file_without_the_step_of_the_next_try_is_read(self):
        """Older files hold two numbers of fix insert/drop only: particles so far and the first step."""
        content = Path("half.restart").read_bytes()[:-32]  # without the checksum, as of another engine
        content = content.replace(b"liggghts-ellipsoid", b"something-else-abc", 1)
        (at,) = [m.start() for m in re.finditer(re.escape(struct.pack("<id", 48, -2.0)), content)]
        inserted, elapsed, since, time_step, next_try = struct.unpack_from("<5d", content, at + 12)
        first = HALF + since
        self.assertEqual((inserted, elapsed, first, time_step, next_try), (19, 0, 1, 5e-6, -1))
        for state in (struct.pack("<i2d", 16, inserted, first), struct.pack("<i4d", 32, -1.0, inserted, first, -1.0)):
            Path("old.restart").write_bytes(content[:at] + state + content[at + 52:])
            outcome = run(pile(lambda setup: "read_restart old.restart\n") + dump("old.dump", SAMPLE)
                          + f"run {HALF}\n", name="in.old")
            self.assertEqual(Path("old.dump").read_bytes(), Path("again.dump").read_bytes())
            self.assertIn("does not keep the time step", outcome.text)

    def test_the_same_restart_gives_the_same_run(self):
        self.assertEqual(Path("again.dump").read_bytes(), Path("twice.dump").read_bytes())


if __name__ == "__main__":
    unittest.main(verbosity=2)
