"""One impact of a tilted ellipsoid on a smooth plane, with damping: J = (1 + e) m v_n / (1 + m r_t^2 / I).

r_t is the distance of the contact normal from the centre, I the moment about the axis across both; in space the
compliance is 1 / m + (r x n) . I^-1 (r x n). e is the ratio of the normal velocities of the contact point after and
before; it is that of m_e x'' = -k x^(3/2) - eta m x' (eq. 23, with the mass of the particle beside a wall, and
the compliance's inverse m_e as the mass that moves), integrated here by Runge and Kutta's method.
"""

import math
import unittest
from pathlib import Path

import numpy as np

from _engine import LAW, Particle, Setup, dump, quaternion_of, read_dump, rotation, run, vectors

SHAPES = {"prolate": (2.5e-3, 1e-3, 1e-3), "oblate": (2e-3, 0.8e-3, 2e-3), "triaxial": (1.1e-3, 2.6e-3, 1.7e-3)}
TILTS = (0.3, 1.0)  # rad
SPEED = 0.2  # m/s
MODULUS, RATIO = 1e16, 0.2  # so hard that the body hardly turns while it touches
NORMAL = np.array([0.0, 1.0, 0.0])


def contact_arm(body):
    """Lowest point of the surface, from the centre (3,), and Gaussian radius of curvature there."""
    r = rotation(body.quaternion)
    a = r @ np.diag(np.square(body.semiaxes)) @ r.T
    reach = math.sqrt(NORMAL @ a @ NORMAL)
    return -(a @ NORMAL) / reach, np.prod(body.semiaxes) / reach ** 2


def restitution(mass, moved, stiffness, damping, speed, steps=20000):
    """e, time of contact (s) of moved x'' = -stiffness x^1.5 - damping mass x'."""
    time = 3.21 * (moved / stiffness) ** 0.4 / speed ** 0.2  # of the undamped contact, closely
    h = 1.5 * time / steps

    def rate(state):
        x, v = state
        return np.array([v, -(stiffness * max(x, 0.0) ** 1.5 + damping * mass * v) / moved])

    state, now = np.array([0.0, speed]), 0.0
    while True:
        k1 = rate(state)
        k2 = rate(state + 0.5 * h * k1)
        k3 = rate(state + 0.5 * h * k2)
        k4 = rate(state + h * k3)
        after = state + h / 6.0 * (k1 + 2 * k2 + 2 * k3 + k4)
        now += h
        if after[0] <= 0.0:
            return -after[1] / speed, now
        state = after


def impulse_solution(body, damping):
    """(impulse, e, change of angular velocity (3,), time of contact) of the rigid body."""
    arm, radius = contact_arm(body)
    turn = np.cross(arm, NORMAL)
    turning = np.linalg.solve(body.inertia, turn)
    moved = 1.0 / (1.0 / body.mass + turn @ turning)
    stiffness = 4.0 / 3.0 * MODULUS / (2.0 * (1.0 - RATIO ** 2)) * math.sqrt(radius)
    e, time = restitution(body.mass, moved, stiffness, damping, SPEED)
    return (1.0 + e) * moved * SPEED, e, (1.0 + e) * moved * SPEED * turning, time


def hit(body, damping, time, name):
    """Changes of velocity and angular velocity (3,), (3,)."""
    arm, _ = contact_arm(body)
    body.position = (0.0, -arm[1], 0.0)
    body.velocity = (0.0, -SPEED, 0.0)
    setup = Setup(damping_normal=damping, damping_tangential=0.0, friction=0.0, time_step=time / 4000)
    setup.materials[0].youngs_modulus = MODULUS
    script = setup.with_particles([body]).replace("neighbor ", "hard_particles yes\nneighbor ", 1)
    script += (f"fix w all wall/gran/ellipsoid {LAW} surface smooth primitive type 1 yplane 0.0\n"
               "fix motion all nve/ellipsoid\n" + dump(f"{name}.dump", 5500) + "run 5500\n")
    run(script, name=f"in.{name}")
    _, columns = read_dump(Path(f"{name}.dump"))
    after = columns["fy"][-1, 0], vectors(columns, "vx", "vy", "vz")[-1, 0], vectors(
        columns, "omegax", "omegay", "omegaz")[-1, 0]
    assert after[0] == 0.0, "still in contact"
    return after[1] - body.velocity, after[2]


class TiltedImpact(unittest.TestCase):
    def check(self, body, name):
        _, _, _, undamped_time = impulse_solution(body, 0.0)
        for damping in 0.0, 0.5 / undamped_time:
            impulse, e, spin, time = impulse_solution(body, damping)
            change, turned = hit(body, damping, time, name)
            errors = (abs(body.mass * change[1] / impulse - 1.0),
                      np.linalg.norm(turned - spin) / np.linalg.norm(spin))
            print(f"{name}: e = {e:.4f}, errors of J {errors[0]:.1e}, of omega {errors[1]:.1e}")
            self.assertLess(max(errors), 1e-4)
            if damping:
                self.assertLess(e, 0.9)

    def test_in_the_plane(self):
        for shape, semiaxes in SHAPES.items():
            for tilt in TILTS:
                body = Particle((0, 0, 0), semiaxes, quaternion_of((0, 0, 1), tilt))
                arm, _ = contact_arm(body)
                # the closed form of the plane is that of the compliance
                plane = 1.0 / body.mass * (1.0 + body.mass * arm[0] ** 2 / body.moments[2])
                turn = np.cross(arm, NORMAL)
                self.assertAlmostEqual(plane * body.mass,
                                       1.0 + body.mass * turn @ np.linalg.solve(body.inertia, turn), places=9)
                self.check(body, f"{shape}_{tilt}")

    def test_in_space(self):
        for shape, semiaxes in SHAPES.items():
            self.check(Particle((0, 0, 0), semiaxes, quaternion_of((1.0, -0.4, 0.7), 0.9)), f"{shape}_space")


if __name__ == "__main__":
    unittest.main(verbosity=2)
