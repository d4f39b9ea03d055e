"""fix wall/gran/ellipsoid: contact with a plane in closed form, frictionless impact, resting weight,
sliding threshold on a slope.

Oracles: closed form of the support point and Gaussian radius a b c/s^2 of an ellipsoid; impulse of a
rigid body on a smooth plane; weight; Coulomb's law.
"""

import math
import unittest
from pathlib import Path

import numpy as np

from _engine import (LAW, Particle, Setup, dump, quaternion_of, read_dump, rotation, run, vectors,
                     COLUMNS)
from _incline import AXES, GRAVITY, slide
from _hertz import hertz

TRIAXIAL = (2.6e-3, 1.7e-3, 1.1e-3)
PLANES = [("x", 0, 1.0), ("x", 0, -1.0), ("y", 1, 1.0), ("z", 2, -1.0)]


def wall(name, axis, place=0.0, more=""):
    return (f"fix {name} all wall/gran/ellipsoid {LAW} surface smooth primitive type 1 {axis}plane "
            f"{place!r} {more}\n")


def support_point(particle, direction):
    """Surface point (3,), from the centre, farthest along the unit `direction`, and its distance."""
    r = rotation(particle.quaternion)
    a = r @ np.diag(np.square(particle.semiaxes)) @ r.T
    distance = math.sqrt(direction @ a @ direction)
    return a @ direction / distance, distance


class StaticContact(unittest.TestCase):
    def test_force_and_torque_of_every_plane(self):
        worst = 0.0
        for k, (name, axis, side) in enumerate(PLANES):
            inward = np.zeros(3)
            inward[axis] = side  # from the wall to the particle
            body = Particle((0, 0, 0), TRIAXIAL, quaternion_of((1 + k, 2, -1), 0.6 + k),
                            (0.02, -0.01, 0.03), (5.0, 7.0, -4.0))
            point, reach = support_point(body, -inward)
            overlap = 0.01 * min(TRIAXIAL)
            body.position = tuple((reach - overlap) * inward)
            setup = Setup(damping_normal=200.0, friction=0.0)
            run(setup.with_particles([body]) + wall("w", name) + dump("one.dump") + "run 0\n")
            _, columns = read_dump(Path("one.dump"))
            lever = point + 0.5 * overlap * inward
            velocity = np.add(body.velocity, np.cross(body.omega, lever))
            radius = np.prod(TRIAXIAL) / reach ** 2  # Gaussian
            modulus = 183e6 / (2.0 * (1.0 - 0.2 ** 2))
            force = (4.0 / 3.0 * modulus * math.sqrt(radius * overlap ** 3)
                     - 200.0 * body.mass * velocity @ inward) * inward  # eq. 23
            found = vectors(columns, "fx", "fy", "fz")[0, 0]
            torque = vectors(columns, "tqx", "tqy", "tqz")[0, 0]
            worst = max(worst, np.abs(found - force).max() / np.abs(force).max(),
                        np.abs(torque - np.cross(lever, force)).max()
                        / np.abs(np.cross(lever, force)).max())
        print(f"contact with planes: largest relative error {worst:.1e}")
        self.assertLess(worst, 1e-11)


class Impact(unittest.TestCase):
    """A tilted, turning body hits a smooth plane; the harder it is, the nearer to a rigid body."""

    def body(self):
        q = quaternion_of((1.0, -0.4, 0.7), 0.9)
        body = Particle((0, 0, 0), TRIAXIAL, q, (0.1, -0.4, 0.05), (30.0, -20.0, 40.0))
        _, reach = support_point(body, np.array([0.0, -1.0, 0.0]))
        body.position = (0.0, reach, 0.0)
        return body

    def impulse_solution(self, body):
        """Velocity and angular velocity after the impact, restitution 1."""
        normal = np.array([0.0, 1.0, 0.0])
        arm, _ = support_point(body, -normal)
        turning = np.linalg.solve(body.inertia, np.cross(arm, normal))
        compliance = 1.0 / body.mass + np.cross(arm, normal) @ turning
        approach = normal @ (np.add(body.velocity, np.cross(body.omega, arm)))
        impulse = -2.0 * approach / compliance
        return (np.add(body.velocity, impulse / body.mass * normal),
                np.add(body.omega, impulse * turning), -approach, 1.0 / compliance)

    def errors(self, youngs_modulus):
        """Errors of velocity and angular velocity relative to their changes."""
        body = self.body()
        velocity, omega, speed, mass = self.impulse_solution(body)
        _, reach = support_point(body, np.array([0.0, -1.0, 0.0]))
        _, time = hertz(mass, np.prod(TRIAXIAL) / reach ** 2,
                        youngs_modulus / (2.0 * (1.0 - 0.2 ** 2)), speed)
        setup = Setup(damping_normal=0.0, damping_tangential=0.0, friction=0.0, time_step=time / 1000)
        setup.materials[0].youngs_modulus = youngs_modulus
        script = setup.with_particles([body]).replace("neighbor ", "hard_particles yes\nneighbor ", 1)
        script += wall("w", "y") + "fix motion all nve/ellipsoid\n" + dump("hit.dump", 50)
        run(script + "run 1150\n")
        _, columns = read_dump(Path("hit.dump"))
        self.assertEqual(columns["fy"][-1, 0], 0.0, "still in contact")
        self.assertGreater(columns["fy"][:, 0].max(), 0.0)
        after = vectors(columns, "vx", "vy", "vz")[-1, 0], vectors(
            columns, "omegax", "omegay", "omegaz")[-1, 0]
        return [np.linalg.norm(found - true) / np.linalg.norm(np.subtract(true, before))
                for found, true, before in zip(after, (velocity, omega), (body.velocity, body.omega))]

    def test_converges_to_the_impulse_of_a_rigid_body(self):
        moduli = [1e8 * 100.0 ** k for k in range(5)]
        errors = np.array([self.errors(modulus) for modulus in moduli])
        for modulus, row in zip(moduli, errors):
            print(f"E = {modulus:.0e} Pa: errors of v {row[0]:.2e}, of omega {row[1]:.2e}")
        # the body moves on while it is in contact, for a time that falls with E^(-2/5)
        np.testing.assert_allclose(errors[1:] / errors[:-1], 100.0 ** -0.4, rtol=0.1)
        self.assertLess(errors[-1].max(), 1e-5)


class RestingWeight(unittest.TestCase):
    def test_walls_carry_the_weight(self):
        upright = quaternion_of((0, 1, 0), 0.3)  # the flat side (axis b) stays down
        height = AXES[1]
        places = [(-0.01, height, 0.0), (0.01, height, 0.0), (0.01, 3.0 * height, 0.0)]
        bodies = [Particle(p, AXES, upright if k == 0 else (1, 0, 0, 0)) for k, p in enumerate(places)]
        setup = Setup(time_step=5e-6, box=(-0.03, 0.03, -0.005, 0.03, -0.02, 0.02))
        script = setup.with_particles(bodies) + f"fix g all gravity {GRAVITY} vector 0 -1 0\n"
        script += wall("floor", "y", 0.0, "store_force yes") + "fix motion all nve/ellipsoid\n"
        file = dump("rest.dump", 400000, COLUMNS + [f"f_force_floor[{k}]" for k in (1, 2, 3)])
        run(script + file + "run 400000\n")
        _, columns = read_dump(Path("rest.dump"))
        carried = columns["f_force_floor[2]"][-1]
        masses = columns["mass"][-1]
        error = carried.sum() / (GRAVITY * masses.sum()) - 1.0
        print(f"floor carries the weight to {error:.1e}; forces left over "
              f"{np.abs(columns['fy'][-1]).max() / (GRAVITY * masses[0]):.1e} of one weight")
        self.assertLess(abs(error), 1e-8)
        self.assertAlmostEqual(carried[1] / carried[0], 2.0, delta=1e-8)  # two bodies on one another
        self.assertEqual(carried[2], 0.0)


class SlidingThreshold(unittest.TestCase):
    FRICTION = 0.3

    def test_below_the_friction_angle_it_rests(self):
        times, way, speed = slide("below", 0.29, self.FRICTION, 0.3, 4e-6)
        print(f"slope 0.29: way {way[-1]:.1e} m, largest speed {np.abs(speed).max():.1e} m/s")
        self.assertLess(np.abs(way).max(), 1e-6)

    def test_above_it_slides_with_coulombs_acceleration(self):
        for slope in 0.31, 0.45:
            angle = math.atan(slope)
            expected = GRAVITY * (math.sin(angle) - self.FRICTION * math.cos(angle))
            times, way, speed = slide(f"above_{slope}", slope, self.FRICTION, 0.3, 4e-6)
            found = np.polyfit(times, speed, 1)[0]
            print(f"slope {slope}: acceleration {found:.5f}, Coulomb {expected:.5f} m/s2")
            self.assertAlmostEqual(found / expected, 1.0, delta=0.02)


if __name__ == "__main__":
    unittest.main(verbosity=2)
