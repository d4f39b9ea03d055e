"""fix nve/ellipsoid integrator gear: order of convergence against Jacobi's elliptic functions, collisions
against the default integrator, restart bit for bit, exchange between ranks, confinement to a plane."""

import unittest
from pathlib import Path

import numpy as np

from _engine import (LAW, Particle, Setup, dump, kinetic_energy, quaternion_of, read_dump, rotation, run,
                     vectors)
from _free_rotation import FreeBody

AXES = (2.7e-3, 1.9e-3, 1.1e-3)
SPACING = 0.0056  # no contact at the start
MOTION = "fix motion all nve/ellipsoid integrator gear\n"


def quaternion_from(matrix):
    """Unit quaternion of a rotation matrix with positive trace."""
    w = 0.5 * np.sqrt(1.0 + np.trace(matrix))
    return (w, *(np.array([matrix[2, 1] - matrix[1, 2], matrix[0, 2] - matrix[2, 0],
                           matrix[1, 0] - matrix[0, 1]]) / (4.0 * w)))


class Order(unittest.TestCase):
    TIME, STEPS = 0.02, 100  # about 2.5 turns

    def test_fifth_order_to_jacobis_solution(self):
        body = FreeBody(Particle((0, 0, 0), AXES).moments, 250.0, 600.0)
        tilt = rotation(quaternion_of((1, -2, 0.5), 0.4))
        r = tilt @ body.rotation(0.0)
        start = Particle((0.001, 0.002, 0.003), AXES, quaternion_from(r), omega=tuple(r @ body.omega(0.0)))
        true_r = tilt @ body.rotation(self.TIME)
        true_omega = true_r @ body.omega(self.TIME)
        errors = []
        for steps in (self.STEPS * 2 ** k for k in range(4)):
            run(Setup(time_step=self.TIME / steps).with_particles([start]) + MOTION
                + dump("free.dump", steps) + f"run {steps}\n")
            _, c = read_dump("free.dump")
            r = rotation(vectors(c, "quat1", "quat2", "quat3", "quat4")[-1, 0])
            omega = vectors(c, "omegax", "omegay", "omegaz")[-1, 0]
            errors.append([np.linalg.norm(omega - true_omega) / np.linalg.norm(true_omega),
                           np.linalg.norm(r - true_r)])
        orders = np.log2(np.array(errors[:-1]) / np.array(errors[1:]))
        print(f"errors of omega and axes:\n{np.array(errors)}\norders:\n{orders}")
        self.assertLess(np.abs(orders - 5.0).max(), 0.3)


def cloud(count, motion, boundary="p p p"):
    """Script of triaxial bodies that collide without damping and friction."""
    random = np.random.default_rng(21)
    size = count * SPACING
    places = np.array(list(np.ndindex(count, count, count))) * size / count
    particles = [Particle(tuple(p), AXES, quaternion_of(random.normal(size=3), random.uniform(0, 6)),
                          tuple(random.normal(0.0, 0.4, 3)), tuple(random.normal(0.0, 100.0, 3)))
                 for p in places]
    setup = Setup(box=(0.0, size) * 3, boundary=boundary, damping_normal=0.0, damping_tangential=0.0,
                  friction=0.0, time_step=2e-6, skin=5e-4)
    return setup, setup.with_particles(particles, "cloud.data") + motion


class Collisions(unittest.TestCase):
    def apart(self, friction):
        """Largest relative difference of the integrators after an oblique, eccentric impact of two rotating
        bodies, for 1000, 4000 and 16000 steps."""
        pair = [Particle((0.0, 0.0, 0.0), AXES, quaternion_of((1, 2, 3), 0.8), (0.3, 0, 0), (0, 50, 20)),
                Particle((0.0045, 0.0004, 0.0003), AXES, quaternion_of((3, -1, 1), 1.9), (-0.3, 0, 0))]
        time, apart = 2e-3, []
        for steps in 1000, 4000, 16000:
            last = []
            for integrator in "verlet", "gear":
                setup = Setup(time_step=time / steps, friction=friction)
                if not friction:
                    setup.damping_normal = setup.damping_tangential = 0.0
                run(setup.with_particles(pair) + f"fix motion all nve/ellipsoid integrator {integrator}\n"
                    + dump("pair.dump", steps) + f"run {steps}\n")
                _, c = read_dump("pair.dump")
                last.append(vectors(c, "vx", "vy", "vz", "omegax", "omegay", "omegaz")[-1])
                self.assertGreater(abs(c["omegax"][-1, 1]), 1.0, "they did not collide")
            apart.append(np.abs(last[0] - last[1]).max() / np.abs(last[0]).max())
        print(f"friction {friction}: apart after the collision by {apart}")
        return apart

    def test_both_integrators_tend_to_the_same_collision(self):
        apart = self.apart(0.0)
        self.assertLess(apart[2], 1e-5)
        self.assertLess(apart[2], 0.1 * apart[1])  # second order: that of the default

    def test_with_friction_the_spring_makes_it_first_order(self):
        apart = self.apart(0.3)
        self.assertLess(apart[2], 2e-3)
        self.assertLess(apart[2], 0.3 * apart[1])

    def test_energy_stays(self):
        _, script = cloud(4, MOTION)
        run(script + dump("energy.dump", 500) + "run 10000\n", name="in.energy")
        _, c = read_dump("energy.dump")
        energy = kinetic_energy(c)
        touching = np.abs(vectors(c, "fx", "fy", "fz")).max(axis=(1, 2)) > 0.0
        free = energy[~touching] / energy[0]
        print(f"{touching.sum()} moments of contact; energy at the others {free}")
        self.assertGreater(touching.sum(), 5)
        self.assertGreater(len(free), 5)
        self.assertLess(np.abs(free - 1.0).max(), 3e-3)


class Restart(unittest.TestCase):
    def compare(self, name, other):
        """All but forces, to rounding."""
        steps, a = read_dump(name)
        again, b = read_dump(other)
        np.testing.assert_array_equal(steps[-len(again):], again)
        for column in a:
            if column[:2] in ("fx", "fy", "fz", "tq"):
                continue
            x, y = a[column][-len(again):], b[column]
            if column in "xyz":
                y = y + 3 * SPACING * np.round((x - y) / (3 * SPACING))
            difference = np.abs(x - y).max() / max(np.abs(x).max(), 1e-300)
            self.assertLessEqual(difference, 1e-9, column)

    def test_bit_for_bit(self):
        for boundary, ranks in ("m m m", 1), ("p p p", 1), ("p p p", 2):
            with self.subTest(boundary, ranks=ranks):
                setup, script = cloud(3, MOTION, boundary)
                run(script + "restart 400 g.*.restart\n" + dump("whole.dump", 100) + "run 800\n", ranks,
                    name="in.whole")
                run(script + "run 400\nwrite_restart two.restart\n" + dump("two.dump", 100) + "run 400\n", ranks,
                    name="in.two")
                for file, whole, restart in (("g.400.restart", "whole.dump", "restart 400 again.*\n"),
                                             ("two.restart", "two.dump", "")):
                    run(setup.header() + f"read_restart {file}\n" + setup.properties() + MOTION + restart
                        + dump("again.dump", 100) + "run 400\n", ranks, name="in.again")
                    again = Path("again.dump").read_text()
                    self.assertEqual(again.count("TIMESTEP"), 5)
                    self.assertEqual(again, Path(whole).read_text()[-len(again):])

    def test_ranks(self):
        setup, script = cloud(3, MOTION)
        run(script + "restart 200 r.*.restart\n" + dump("one.dump", 100) + "run 400\n", name="in.one")
        for ranks in 2, 4:
            run(script + dump(f"{ranks}.dump", 100) + "run 400\n", ranks, name=f"in.{ranks}")
            self.compare("one.dump", f"{ranks}.dump")
        run(setup.header() + "read_restart r.200.restart\n" + setup.properties() + MOTION
            + dump("r.dump", 100) + "run 200\n", 2, name="in.r")
        self.compare("one.dump", "r.dump")

    def test_a_new_fix_starts_anew(self):
        # the derivatives of the old one are gone: a body that was stopped meanwhile stays where it is
        _, script = cloud(2, "fix gravity all gravity 9.81 vector 0 0 -1\n" + MOTION)
        run(script + "run 50\nunfix gravity\nunfix motion\nvelocity all set 0 0 0\n"
            "set group all omegax 0.0 omegay 0.0 omegaz 0.0\n" + MOTION + dump("still.dump", 10) + "run 10\n")
        _, c = read_dump("still.dump")
        np.testing.assert_array_equal(c["z"][0], c["z"][-1])


class Planar(unittest.TestCase):
    def test_in_the_plane_and_as_in_space(self):
        random = np.random.default_rng(7)
        particles = [Particle((0.012 * (k % 4) - 0.018, 0.012 * (k // 4) - 0.018, 0.0), AXES,
                              quaternion_of((0, 0, 1), random.uniform(-3, 3)),
                              (*random.uniform(-3, 3, 2), 0.0), (0.0, 0.0, random.uniform(-90, 90)))
                     for k in range(16)]
        setup = Setup(box=(-0.025, 0.025, -0.025, 0.025, -0.01, 0.01), time_step=2e-6)
        walls = "".join(
            f"fix w{k} all wall/gran/ellipsoid {LAW} surface smooth primitive type 1 "
            f"{'xy'[k // 2]}plane {(-1) ** k * 0.0245!r}\n" for k in range(4))
        for planar in "yes", "no":
            run(setup.with_particles(particles) + walls
                + f"fix motion all nve/ellipsoid planar {planar} integrator gear\n"
                + dump(f"{planar}.dump", 250) + "run 10000\n", name=f"in.{planar}")
        _, flat = read_dump("yes.dump")
        _, space = read_dump("no.dump")
        self.assertGreater((np.abs(flat["tqz"]) > 0.0).any(axis=0).sum(), 5)
        for name in "z", "vz", "omegax", "omegay", "quat2", "quat3":
            self.assertEqual(np.abs(flat[name]).max(), 0.0, name)
        for name in "x", "y", "vx", "vy", "omegaz", "quat1", "quat4":
            scale = np.abs(space[name]).max()
            self.assertLess(np.abs(flat[name] - space[name]).max(), 1e-5 * scale, name)

    def test_misaligned_body_is_refused(self):
        tilted = Particle((0.0, 0.0, 0.0), AXES, quaternion_of((1, 0, 0), 0.3), omega=(0, 0, 100.0))
        outcome = run(Setup().with_particles([tilted])
                      + "fix motion all nve/ellipsoid planar yes integrator gear\nrun 1\n", check=False)
        self.assertEqual(outcome.code, 1)
        self.assertRegex(outcome.text, "ERROR.*planar yes.*atom 1 has no principal axis along z")


if __name__ == "__main__":
    unittest.main(verbosity=2)
