"""What the host's fixes for forces, motion and averages do to ellipsoids: each against its closed form in
NumPy, on three bodies that move and spin apart from each other."""

import math
import unittest
from pathlib import Path

import numpy as np

from _engine import dump, read_dump, rotation, thermo
from _spinning import after, bodies, momenta, vectors

G = 9.81 * np.array([1.0, 2.0, 2.0]) / 3.0
GRAVITY = "fix gravity all gravity 9.81 vector 1 2 2\n"
STEP = 1e-6


def places():
    return np.array([p.position for p in bodies()])


def masses():
    return np.array([p.mass for p in bodies()])


def velocities():
    return np.array([p.velocity for p in bodies()])


class Forces(unittest.TestCase):
    """At the centres: no torque. One time step suffices: what follows is the integrator's."""

    def forces(self, commands, name):
        c = after(commands, name)
        np.testing.assert_allclose(vectors(c, "tqx", "tqy", "tqz"), 0.0, atol=1e-30)
        return vectors(c, "fx", "fy", "fz")

    def check(self, commands, name, expected):
        found = self.forces(commands, name)
        np.testing.assert_allclose(found, expected, rtol=1e-9, atol=1e-9 * np.abs(expected).max())

    def test_gravity_and_what_changes_it(self):
        weight = masses()[:, None] * G
        self.check(GRAVITY, "gravity", weight)
        self.check(GRAVITY + "fix f1 all setforce 0 0 NULL", "setforce", weight * [0, 0, 1])
        self.check(GRAVITY + "fix f1 all addforce 1e-4 -2e-4 3e-4", "addforce",
                   weight + [1e-4, -2e-4, 3e-4])
        mean = weight.copy()
        mean[:, 2] = weight[:, 2].mean()
        self.check(GRAVITY + "fix f1 all aveforce NULL NULL 0", "aveforce", mean)
        axis = np.array([2.0, -1.0, 2.0]) / 3.0
        along = (weight @ axis)[:, None] * axis
        self.check(GRAVITY + "fix f1 all lineforce 2 -1 2", "lineforce", along)
        self.check(GRAVITY + "fix f1 all planeforce 2 -1 2", "planeforce", weight - along)
        self.check(GRAVITY + "fix f1 all freeze", "freeze", 0.0 * weight)

    def test_drag_and_viscous(self):
        r = places()
        distance = np.linalg.norm(r - [0.001, 0, 0], axis=1, keepdims=True)
        self.assertGreater(distance.max(), 0.005)
        toward = np.where(distance > 0.005, -(r - [0.001, 0, 0]) / distance, 0.0)
        self.check("fix f1 all drag 0.001 0 0 1e-4 0.005", "drag", 1e-4 * toward)
        self.check("fix f1 all viscous 1e-3", "viscous", -1e-3 * velocities())

    def test_springs(self):
        shift = np.array([0.001, -0.002, 0.0005])
        words = " ".join(map(repr, shift.tolist()))
        self.check(f"fix f1 all spring/self 10\ndisplace_atoms all move {words} units box", "self",
                   np.tile(-10.0 * shift, (3, 1)))
        m, r = masses(), places()
        centre = m @ r / m.sum()
        share = m[:, None] / m.sum()
        self.check("fix f1 all spring tether 10 0 0 0 0", "tether", -10.0 * centre * share)

    def test_stored_forces(self):
        names = [f"f_kept[{k}]" for k in (1, 2, 3)]
        c = after(GRAVITY + "fix kept all store/force\nfix f1 all setforce 0 0 0", "kept", more=names)
        np.testing.assert_allclose(vectors(c, *names), masses()[:, None] * G, rtol=1e-9)
        np.testing.assert_allclose(vectors(c, "fx", "fy", "fz"), 0.0, atol=1e-30)

    def test_the_motion_is_that_of_the_force(self):
        c = after("fix f1 all addforce 1e-4 -2e-4 3e-4", "thrown", 200)
        force, time = np.array([1e-4, -2e-4, 3e-4]), 200 * STEP
        np.testing.assert_allclose(vectors(c, "vx", "vy", "vz"),
                                   velocities() + force / masses()[:, None] * time, rtol=1e-9)
        np.testing.assert_allclose(vectors(c, "x", "y", "z"), places() + velocities() * time
                                   + 0.5 * force / masses()[:, None] * time ** 2, rtol=1e-9)
        np.testing.assert_allclose(momenta(c), momenta(after("", "start")), rtol=1e-9)


class Motion(unittest.TestCase):
    def test_linear_momentum_is_taken_off(self):
        c = after("fix f1 all momentum 1 linear 1 0 1", "linear", 1)
        total = c["mass"] @ vectors(c, "vx", "vy", "vz")
        expected = masses() @ velocities()
        np.testing.assert_allclose(total, expected * [0, 1, 0], atol=1e-9 * np.abs(expected).max())

    def test_time_step_follows_the_fastest(self):
        speed = np.linalg.norm(velocities(), axis=1).max()
        after("fix f1 all dt/reset 1 1e-9 1e-3 1e-7 units box\nthermo_style custom step dt\n"
              "thermo_modify format float %.12g\n", "reset", 2)
        self.assertAlmostEqual(thermo("log.in.reset", 2)[-1, 1], 1e-7 / speed, delta=1e-6 * 1e-7 / speed)

    def test_commands_between_runs(self):
        c = after("velocity all ramp vx 0 0.1 x -0.01 0.01 units box", "ramp")
        share = np.clip((places()[:, 0] + 0.01) / 0.02, 0, 1)
        np.testing.assert_allclose(c["vx"], 0.1 * share, rtol=1e-12)
        c = after("velocity all set 0.1 NULL -0.3 units box", "velocity")
        np.testing.assert_allclose(vectors(c, "vx", "vy", "vz"),
                                   np.stack([[0.1] * 3, velocities()[:, 1], [-0.3] * 3], -1), rtol=1e-12)
        c = after("velocity all zero linear", "still")
        np.testing.assert_allclose(c["mass"] @ vectors(c, "vx", "vy", "vz"), 0.0, atol=1e-18)
        c = after("displace_atoms all move 0.001 0 -0.002 units box", "moved")
        np.testing.assert_allclose(vectors(c, "x", "y", "z"), places() + [0.001, 0, -0.002], rtol=1e-12)
        c = after("displace_atoms all ramp z 0 0.002 x -0.01 0.01 units box", "ramped")
        np.testing.assert_allclose(c["z"], places()[:, 2] + 0.002 * share, rtol=1e-12)
        c = after("displace_atoms all random 0.001 0.001 0.001 15485863 units box", "random")
        shift = np.abs(vectors(c, "x", "y", "z") - places())
        self.assertTrue((shift <= 0.001).all() and (shift > 0.0).all())
        c = after("change_box all z final -0.06 0.06 units box", "box")
        np.testing.assert_allclose(vectors(c, "x", "y", "z"), places(), rtol=1e-12)
        c = after("set atom 2 vx 0.7 y 0.003", "set")
        self.assertEqual((c["vx"][1], c["y"][1]), (0.7, 0.003))
        np.testing.assert_allclose(c["vx"][[0, 2]], velocities()[[0, 2], 0], rtol=1e-12)


class Averages(unittest.TestCase):
    """Of bodies that fly straight on."""

    STEPS = np.arange(10, 51, 10)  # of ave/atom 10 5 50 and the like

    def track(self):
        """Positions (5, 3, 3) at these steps."""
        return places() + velocities() * (STEP * self.STEPS)[:, None, None]

    def rows(self, file):
        return np.loadtxt(file, comments="#", ndmin=2)

    def test_of_particles(self):
        names = ["id", "f_a[1]", "f_a[2]", "f_b[1]", "f_b[2]"]
        after("fix a all ave/atom 10 5 50 x vz\nfix b all store/state 0 x vy\n"
              + dump("every_50.dump", 50, names), "averaged", 50)
        c = {name: frames[-1] for name, frames in read_dump("every_50.dump")[1].items()}
        np.testing.assert_allclose(c["f_a[1]"], self.track()[:, :, 0].mean(0), rtol=1e-9)
        np.testing.assert_allclose(c["f_a[2]"], velocities()[:, 2], rtol=1e-9)
        np.testing.assert_allclose(c["f_b[1]"], places()[:, 0], rtol=1e-12)
        np.testing.assert_allclose(c["f_b[2]"], velocities()[:, 1], rtol=1e-12)

    def test_of_time_and_correlation(self):
        after("variable x equal x[1]\nfix a all ave/time 10 5 50 v_x file time.txt\n"
              "fix b all ave/correlate 10 2 50 v_x file correlation.txt", "time", 50)
        x = self.track()[:, 0, 0]
        np.testing.assert_allclose(self.rows("time.txt")[-1], [50, x.mean()], rtol=1e-5)  # six digits
        last = [line.split() for line in Path("correlation.txt").read_text().splitlines()
                if not line.startswith("#")][-2:]
        x = np.concatenate([[places()[0, 0]], x])  # from step 0 on
        np.testing.assert_allclose(float(last[0][3]), (x * x).mean(), rtol=1e-4)  # six digits
        np.testing.assert_allclose(float(last[1][3]), (x[1:] * x[:-1]).mean(), rtol=1e-4)

    def test_of_space_and_histogram(self):
        after("fix a all ave/spatial 10 5 50 z lower 0.025 vx file space.txt units box\n"
              "fix b all ave/histo 10 5 50 -0.2 0.2 4 vx mode vector file histogram.txt", "space", 50)
        layer = ((self.track()[:, :, 2] + 0.05) / 0.025).astype(int)
        rows = self.rows_of_table("space.txt", 4)
        for row in range(4):
            inside = layer == row
            self.assertAlmostEqual(rows[row, 2], inside.sum() / 5.0, delta=1e-5)
            if inside.any():
                mean = np.broadcast_to(velocities()[:, 0], inside.shape)[inside].mean()
                self.assertAlmostEqual(rows[row, 3], mean, delta=1e-5 * abs(mean))
        counts = np.histogram(np.tile(velocities()[:, 0], 5), 4, (-0.2, 0.2))[0]
        np.testing.assert_allclose(self.rows_of_table("histogram.txt", 4)[:, 2], counts)

    def rows_of_table(self, file, count):
        lines = [line.split() for line in Path(file).read_text().splitlines() if not line.startswith("#")]
        return np.array([[float(t) for t in line] for line in lines[-count:]])

    def test_print_and_tracer(self):
        after('variable v equal vx[2]\nfix p all print 50 "speed ${v}" file printed.txt title ""\n', "print", 50)
        self.assertAlmostEqual(float(Path("printed.txt").read_text().split()[-1]), velocities()[1, 0],
                               delta=1e-6)
        c = after("region part block INF INF INF INF 0 INF units box\n"
                  "fix t all property/atom/tracer region_mark part mark_step 10 check_mark_every 5", "tracer",
                  20, more=["f_t"])
        np.testing.assert_array_equal(c["f_t"], places()[:, 2] > 0)
        self.assertTrue(0 < c["f_t"].sum() < 3)


class Buoyancy(unittest.TestCase):
    LIQUID, LEVEL = 1000.0, 0.001

    def test_force_and_torque_of_what_is_immersed(self):
        """Against the sum over a fine lattice of points in each body."""
        for axis, name in enumerate("xyz"):
            for side in (-1, 1):
                direction = [side if k == axis else 0 for k in range(3)]
                c = after(f"fix g all gravity 9.81 vector {' '.join(map(str, direction))}\n"
                          f"fix b all buoyancy dim {name} level {self.LEVEL} density {self.LIQUID}",
                          f"liquid_{name}{side}", particles=self.floating(axis))
                for i, body in enumerate(self.floating(axis)):
                    force, torque = self.lattice(body, axis, side)
                    total = np.array([c[k][i] for k in ("fx", "fy", "fz")])
                    weight = body.mass * 9.81 * np.array(direction)
                    scale = self.LIQUID * 9.81 * 4.0 / 3.0 * math.pi * np.prod(body.semiaxes)
                    np.testing.assert_allclose(total - weight, force, atol=4e-3 * scale)
                    np.testing.assert_allclose([c[k][i] for k in ("tqx", "tqy", "tqz")], torque,
                                               atol=4e-3 * scale * max(body.semiaxes))

    def floating(self, axis):
        """One body under water, two in the surface, in the order of the depth."""
        found = bodies()
        for body, height in zip(found, (-0.004, -0.0002, 0.0004)):
            position = list(body.position)
            position[axis] = self.LEVEL + height
            body.position = tuple(position)
            body.velocity = body.omega = (0.0, 0.0, 0.0)
        return found

    def lattice(self, body, axis, side, count=60):
        steps = (np.arange(count) + 0.5) / count * 2.0 - 1.0
        unit = np.stack(np.meshgrid(steps, steps, steps), -1).reshape(-1, 3)
        unit = unit[(unit ** 2).sum(1) < 1.0]
        arms = (unit * body.semiaxes) @ rotation(body.quaternion).T
        below = side * (arms[:, axis] + body.position[axis] - self.LEVEL) > 0.0
        weight = self.LIQUID * 9.81 * np.prod(body.semiaxes) * (2.0 / count) ** 3
        up = np.zeros(3)
        up[axis] = -side
        return below.sum() * weight * up, np.cross(arms[below].sum(0), up) * weight


if __name__ == "__main__":
    unittest.main(verbosity=2)
