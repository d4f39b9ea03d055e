"""fix insert/drop counts simulated time: one particle per interval, whatever happens to the time step, to the
number of the step, and across restart files. The moments are compared with the times k T, step by step."""

import re
import unittest

from _engine import Setup, run, thermo

INTERVAL = 2e-4


def script(start=None, dt=1e-5, interval=INTERVAL, count=60):
    setup = Setup(box=(-0.5, 0.5, -0.5, 0.5, -0.5, 0.5), time_step=dt)
    return setup.header() + (start or setup.create_box()) + setup.properties() + f"""
fix grain all particletemplate/ellipsoid 15485863 semiaxes 2.5e-3 1e-3 1e-3 density 2500
fix drop all insert/drop seed 1 template grain particles {count} interval {interval!r} &
    box -0.4 0.4 -0.4 0.4 -0.4 0.4
fix motion all nve/ellipsoid
thermo_style custom step atoms f_drop
thermo 1
"""


def numbers(name, first_row=0):
    """Particles after each time step."""
    return [int(row[1]) for row in thermo(f"log.in.{name}", 3)[first_row:]]


def due(times, interval=INTERVAL):
    """Particles that have come after steps that end at these times since the first step of the fix: k T is
    rounded to a step."""
    return [sum(1 for k in range(60) if abs(k * interval - t) < 1e-12 or k * interval < t) for t in times]


class SimulatedTime(unittest.TestCase):
    def check(self, found, times, step):
        """`times`: of each step since the fix's first one; a drop may be half a (longest) step early or late."""
        self.assertEqual(len(found), len(times))
        for number, time in zip(found, times):
            early, late = due([time - 0.51 * step, time + 0.51 * step])
            self.assertTrue(early <= number <= late, f"{number} particles at {time!r}, expected {early} to {late}")

    def test_changed_time_steps(self):
        for factor in (0.25, 0.5, 2.0, 7.3):
            new = 1e-5 * factor
            run(script() + f"run 90\ntimestep {new!r}\nrun 120\ntimestep 1e-5\nrun 60\n", name="in.changed")
            rows = numbers("changed")
            found = rows[1:91] + rows[92:212] + rows[213:]
            steps = [1e-5] * 90 + [new] * 120 + [1e-5] * 60
            times = [sum(steps[1:k + 1]) for k in range(len(steps))]
            self.check(found, times, max(steps))

    def test_time_step_changed_between_parts_of_a_run(self):
        """`pre no`: no fix is told that a run begins."""
        run(script() + "run 50\ntimestep 2e-5\nrun 60 pre no\n", name="in.parts")
        rows = numbers("parts")
        steps = [1e-5] * 50 + [2e-5] * 60
        times = [sum(steps[1:k + 1]) for k in range(len(steps))]
        found = rows[1:51] + rows[-60:]
        self.check(found, times, 2e-5)

    def test_dt_reset(self):
        """Slow particles: fix dt/reset gives its largest step, 4e-5, from step 10 on."""
        text = script().replace("fix motion", "fix slow all dt/reset 10 1e-6 4e-5 1e-3 units box\nfix motion")
        text = text.replace("custom step atoms f_drop", "custom step atoms dt")
        run(text + "run 100\n", name="in.dtreset")
        rows = thermo("log.in.dtreset", 3)
        self.assertAlmostEqual(rows[-1][2], 4e-5)
        times, now = [], -rows[0][2]
        for before in rows[:-1]:
            now += before[2]
            times.append(now)
        self.check([int(r[1]) for r in rows[1:]], times, 4e-5)

    def test_reset_timestep(self):
        for to in (0, 100000):
            run(script() + f"run 100\nreset_timestep {to}\nrun 150\n", name="in.reset")
            rows = numbers("reset")
            self.check(rows[1:101] + rows[102:], [1e-5 * k for k in range(250)], 1e-5)

    def test_restart_with_another_time_step(self):
        run(script() + "run 73\nwrite_restart half.restart\n", name="in.half")
        first = numbers("half")[1:]
        for new in (4e-6, 1e-5, 3e-5):
            run(script("read_restart half.restart\n", dt=new) + "run 100\n", name="in.again")
            steps = [1e-5] * 73 + [new] * 100
            times = [sum(steps[1:k + 1]) for k in range(len(steps))]
            self.check(first + numbers("again")[1:], times, max(steps))

    def test_restart_with_another_step_number(self):
        run(script() + "run 73\nwrite_restart half.restart\n", name="in.half")
        first = numbers("half")[1:]
        run(script("read_restart half.restart\n") + "reset_timestep 5\nrun 100\n", name="in.again")
        self.check(first + numbers("again")[1:], [1e-5 * k for k in range(173)], 1e-5)

    def test_a_step_longer_than_the_interval_stops(self):
        for between in ("run 10", "run 10 pre no"):
            outcome = run(script() + f"run 10\ntimestep 3e-4\n{between}\n", check=False, name="in.long")
            self.assertNotEqual(outcome.code, 0)
            self.assertRegex(outcome.text, re.compile("'interval' is shorter than the time step"))

    def test_integrator_follows_the_time_step(self):
        """A free particle moves with the present step also after `pre no`."""
        for integrator in ("verlet", "gear"):
            text = script(count=1).replace("0.4 -0.4 0.4\n", "0.4 -0.4 0.4 velocity 0 0 1\n").replace(
                "nve/ellipsoid", f"nve/ellipsoid integrator {integrator}")
            run(text + "compute centre all reduce sum z\nthermo_style custom step atoms c_centre\nrun 1\n"
                "run 100\ntimestep 2e-5\nrun 100 pre no\n", name="in.free")
            rows = thermo("log.in.free", 3)
            by_step = {int(r[0]): r[2] for r in rows}
            self.assertAlmostEqual(by_step[201] - by_step[101], 100 * 2e-5, delta=1e-6)
            self.assertAlmostEqual(by_step[101] - by_step[1], 100 * 1e-5, delta=1e-6)


if __name__ == "__main__":
    unittest.main(verbosity=2)
