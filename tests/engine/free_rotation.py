"""fix nve/ellipsoid: torque-free rotation against Jacobi's elliptic functions, second order, norm and
angular momentum kept; confinement to the xy plane.

Oracle: _free_rotation.py.
"""

import math
import unittest
from pathlib import Path

import numpy as np

from _engine import Particle, Setup, dump, quaternion_of, read_dump, rotation, run, vectors
from _free_rotation import FreeBody, jacobi

AXES = (2.7e-3, 1.9e-3, 1.1e-3)
TIME, STEPS = 0.05, 1000  # about 6 turns, at the coarsest time step


def quaternion_from(matrix):
    """Unit quaternion of a rotation matrix (the trace is positive here)."""
    w = 0.5 * math.sqrt(1.0 + np.trace(matrix))
    return (w, *(np.array([matrix[2, 1] - matrix[1, 2], matrix[0, 2] - matrix[2, 0],
                           matrix[1, 0] - matrix[0, 1]]) / (4.0 * w)))


class FreeRotation(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        body = Particle((0.0, 0.0, 0.0), AXES)
        cls.reference = FreeBody(body.moments, 250.0, 600.0)
        cls.tilt = rotation(quaternion_of((1, -2, 0.5), 0.4))  # the angular momentum is not along z

    def start(self):
        r = self.tilt @ self.reference.rotation(0.0)
        return Particle((0.001, 0.002, 0.003), AXES, quaternion_from(r),
                        omega=tuple(r @ self.reference.omega(0.0)))

    def follow(self, steps, every):
        setup = Setup(time_step=TIME / steps)
        script = setup.with_particles([self.start()]) + "fix motion all nve/ellipsoid\n"
        run(script + dump(f"{steps}.dump", every) + f"run {steps}\n")
        return read_dump(Path(f"{steps}.dump"))[1]

    def errors(self, steps):
        """Errors at TIME: of the angular velocity (relative) and of the axes."""
        columns = self.follow(steps, steps)
        r = rotation(vectors(columns, "quat1", "quat2", "quat3", "quat4")[-1, 0])
        omega = vectors(columns, "omegax", "omegay", "omegaz")[-1, 0]
        true_r = self.tilt @ self.reference.rotation(TIME)
        true_omega = true_r @ self.reference.omega(TIME)
        return np.array([np.linalg.norm(omega - true_omega) / np.linalg.norm(true_omega),
                         np.linalg.norm(r - true_r)])

    def test_second_order_to_jacobis_solution(self):
        errors = np.array([self.errors(STEPS * 2 ** k) for k in range(5)])
        ratios = errors[:-1] / errors[1:]
        print(f"errors of omega and axes:\n{errors}\nratios on halving the time step:\n{ratios}")
        self.assertLess(np.abs(ratios - 4.0).max(), 0.2)
        self.assertLess(errors[-1].max(), 1e-5)

    def test_norm_energy_and_momentum_are_kept(self):
        columns = self.follow(100 * STEPS, STEPS)
        q = vectors(columns, "quat1", "quat2", "quat3", "quat4")[:, 0]
        omega = vectors(columns, "omegax", "omegay", "omegaz")[:, 0]
        norm = np.abs(np.linalg.norm(q, axis=1) - 1.0).max()
        body = [rotation(q_t).T @ w for q_t, w in zip(q, omega)]
        momentum = np.array([rotation(q_t) @ (self.start().moments * w) for q_t, w in zip(q, body)])
        drift = np.linalg.norm(momentum - momentum[0], axis=1).max() / np.linalg.norm(momentum[0])
        energy = np.array([0.5 * np.dot(self.start().moments, w ** 2) for w in body])
        wander = np.abs(energy / energy[0] - 1.0).max()
        print(f"norm {norm:.1e}, angular momentum {drift:.1e}, energy {wander:.1e} in "
              f"{100 * STEPS} steps")
        self.assertLess(norm, 4e-15)
        self.assertLess(drift, 1e-12)
        self.assertLess(wander, 1e-6)

    def test_reference_obeys_eulers_equations(self):
        # the oracle itself: central difference of its angular velocity and of its axes
        h, t, moments = 1e-6, 0.0137, self.reference.moments
        w = self.reference.omega(t)
        rate = (self.reference.omega(t + h) - self.reference.omega(t - h)) / (2.0 * h)
        torque = moments * rate + np.cross(w, moments * w)
        self.assertLess(np.linalg.norm(torque), 1e-6 * np.linalg.norm(np.cross(w, moments * w)))
        r = self.reference.rotation(t)
        spin = r.T @ (self.reference.rotation(t + h) - self.reference.rotation(t - h)) / (2.0 * h)
        np.testing.assert_allclose([spin[2, 1], spin[0, 2], spin[1, 0]], w, rtol=1e-6)
        sn, cn, dn = jacobi(0.75, 0.6)
        self.assertAlmostEqual(sn ** 2 + cn ** 2, 1.0, delta=1e-15)
        self.assertAlmostEqual(dn ** 2 + (0.6 * sn) ** 2, 1.0, delta=1e-15)


class Planar(unittest.TestCase):
    def test_exactly_in_the_plane(self):
        random = np.random.default_rng(7)
        particles = [Particle((0.012 * (k % 4) - 0.018, 0.012 * (k // 4) - 0.018, 0.0), AXES,
                              quaternion_of((0, 0, 1), random.uniform(-3, 3)),
                              tuple(random.uniform(-3, 3, 3)), tuple(random.uniform(-90, 90, 3)))
                     for k in range(16)]  # their v_z, omega_x, omega_y are to be taken out
        setup = Setup(box=(-0.025, 0.025, -0.025, 0.025, -0.01, 0.01), time_step=2e-6)
        walls = "".join(
            f"fix w{k} all wall/gran/ellipsoid model hertz/viscous tangential history/viscous surface "
            f"smooth primitive type 1 {'xy'[k // 2]}plane {(-1) ** k * 0.0245!r}\n" for k in range(4))
        run(setup.with_particles(particles) + walls + "fix motion all nve/ellipsoid planar yes\n"
            + "compute c all contacts/ellipsoid\n" + dump("planar.dump", 50) + "run 20000\n")
        _, columns = read_dump(Path("planar.dump"))
        hits = (np.abs(columns["tqz"]) > 0.0).any(axis=0).sum()
        self.assertEqual(hits, 16, "not every particle was hit")
        for name in "z", "quat2", "quat3":
            self.assertEqual(np.abs(columns[name]).max(), 0.0, name)
        for name in "vz", "omegax", "omegay":
            self.assertEqual(np.abs(columns[name][1:]).max(), 0.0, name)
            self.assertGreater(np.abs(columns[name][0]).max(), 0.0, name)

    def run_planar(self, axes, q):
        script = Setup().with_particles([Particle((0.0, 0.0, 0.0), axes, q, omega=(0, 0, 100.0))])
        script += dump("turned.dump", 10) + "fix motion all nve/ellipsoid planar yes\nrun 10\n"
        return run(script, check=False)

    def test_misaligned_body_is_refused(self):
        outcome = self.run_planar(AXES, quaternion_of((1, 0, 0), 0.3))
        self.assertEqual(outcome.code, 1, outcome.text)
        self.assertRegex(outcome.text, r"ERROR.*nve/ellipsoid.*planar yes.*atom 1 has no principal axis "
                                       r"along z; insert it with orientation planar")

    def test_body_turned_out_of_the_plane_between_runs_is_refused(self):
        script = Setup().with_particles([Particle((0.0, 0.0, 0.0), AXES, omega=(0, 0, 100.0))])
        script += "fix motion all nve/ellipsoid planar yes\nrun 10\n"
        turned = " ".join(repr(float(v)) for v in quaternion_of((1, 0, 0), 0.3))
        outcome = run(script + f"set atom 1 quat_direct {turned}\nrun 10\n", check=False)
        self.assertEqual(outcome.code, 1, outcome.text)
        self.assertRegex(outcome.text, "ERROR.*atom 1 has no principal axis along z")

    def test_symmetric_bodies_may_lie_rolled(self):
        # every axis across the symmetry axis is a principal one, and every axis of a sphere
        for axes, q in (((2e-3, 1e-3, 1e-3), quaternion_of((1, 0, 0), 0.3)),
                        ((1e-3, 1e-3, 1e-3), quaternion_of((1, 2, 3), 1.0))):
            outcome = self.run_planar(axes, q)
            self.assertEqual(outcome.code, 0, outcome.text)
            _, columns = read_dump(Path("turned.dump"))
            self.assertAlmostEqual(columns["omegaz"][-1, 0], 100.0, delta=1e-11)


class NewLists(unittest.TestCase):
    def test_every_body_keeps_its_own_moments_when_atoms_change_places(self):
        # when lists are new atoms are sorted, and fill the places of those that left; half of them
        # pass the others, each spins about its principal axis z
        count, leaving, spin = 6, (0, 2), 100.0
        particles = []
        for k in range(count):
            way = (-1) ** (k // 2)
            particles.append(Particle((0.015 * k - 0.0375, 0.045 if k in leaving else -0.01 * way, 0.0),
                                      tuple((0.5 + 0.2 * k) * a for a in AXES),
                                      quaternion_of((0, 0, 1), k),
                                      (0.0, 1.0 if k in leaving else way, 0.0), (0.0, 0.0, spin)))
        stay = [k for k in range(count) if k not in leaving]
        for planar in "yes", "no":
            name = f"{planar}.dump"
            run(Setup().with_particles(particles) + f"fix motion all nve/ellipsoid planar {planar}\n"
                + "thermo_modify lost ignore\n" + "atom_modify sort 1 0\n" + dump(name, 1000) + "run 20000\n")
            for frame, text in enumerate(Path(name).read_text().split("ITEM: ATOMS")[1:]):
                columns, *rows = (line.split() for line in text.split("ITEM")[0].strip().splitlines())
                values = {int(v["id"]) - 1: v for v in (dict(zip(columns, row)) for row in rows)}
                for k, body in values.items():
                    self.assertAlmostEqual(float(body["omegaz"]), spin, delta=1e-10)
                    angle = k + spin * 1e-3 * frame
                    found = [float(body[f"quat{n}"]) for n in (1, 4)]
                    np.testing.assert_allclose(found, [math.cos(angle / 2), math.sin(angle / 2)],
                                               atol=1e-8)
            self.assertEqual(sorted(values), stay)



if __name__ == "__main__":
    unittest.main(verbosity=2)
