"""surface smooth ellipticalContact on: force and contact area of Hertz's elliptic contact.

Oracle: curvatures from the second fundamental form, and Hertz's equations by numerical integration
of the potential of the elliptic pressure (Johnson 1985, eqs. 3.68, 3.69), without elliptic functions.
"""

import math
import unittest

import numpy as np

from _contact_geometry import gap_curvatures, shape_matrix
from _contact_rows import read_rows, refusal
from _engine import LAW, Particle, Setup, quaternion_of, rotation, run

MODULUS = 183e6 / (2.0 * (1.0 - 0.2 ** 2))  # E*
OVERLAP = 2e-5
POINTS = np.exp(np.linspace(-60.0, 60.0, 6001))  # the trapezoidal rule converges exponentially
SPACING = 120.0 / 6000

SHAPES = [((2.7e-3, 1.15e-3, 1.15e-3), (1.9e-3, 1.4e-3, 0.7e-3)),
          ((3e-3, 3e-3, 0.6e-3), (2e-3, 0.8e-3, 0.8e-3)),
          ((6e-3, 1e-3, 1e-3), (6e-3, 1e-3, 1e-3))]


def potentials(k):
    """Integrals L, M, N for the semi-axes 1 and k."""
    t = POINTS * math.sqrt(k)
    one, two = 1.0 + t * t, k * k + t * t
    return [2.0 * SPACING * (t * one ** -p * two ** -q).sum()
            for p, q in ((0.5, 0.5), (1.5, 0.5), (0.5, 1.5))]


def hertz(a_curvature, b_curvature, overlap):
    """Force (N) and contact area (m2) of an elliptic contact."""
    low, high = 1e-6, 1.0
    for _ in range(80):
        middle = math.sqrt(low * high)
        _, m, n = potentials(middle)
        low, high = (low, middle) if n / m < b_curvature / a_curvature else (middle, high)
    k = math.sqrt(low * high)
    length, m, _ = potentials(k)
    axis = math.sqrt(overlap * m / (a_curvature * length))
    return 4.0 / 3.0 * math.pi * MODULUS * overlap * axis / length, math.pi * k * axis ** 2


def farthest(particle, normal):
    """The body's implicit matrix, and its farthest point along a normal, from its centre."""
    r = rotation(particle.quaternion)
    a = r @ np.diag(np.square(particle.semiaxes)) @ r.T
    return shape_matrix(particle.semiaxes, r), a @ normal / math.sqrt(normal @ a @ normal)


def touching_pair(axes_i, axes_j, seed):
    """Two turned particles that overlap by OVERLAP along a common normal, the first over a plane
    z = 0 with the same overlap; and the normals of both contacts."""
    random = np.random.default_rng(seed)
    i, j = (Particle((0, 0, 0), axes, quaternion_of(random.normal(size=3), random.uniform(0, 3)))
            for axes in (axes_i, axes_j))
    down, normal = np.array([0.0, 0.0, -1.0]), np.array([0.3, -0.5, 0.9])
    normal /= np.linalg.norm(normal)
    i.position = tuple(-(farthest(i, down)[1] @ down - OVERLAP) * down)
    way = farthest(i, normal)[1] - farthest(j, -normal)[1] - OVERLAP * normal
    j.position = tuple(np.add(i.position, way))
    return i, j, normal, down


def engine(pair, option, name):
    """(force, overlap, area, radius) of the contact of the pair and of that with the wall."""
    setup = Setup(pair=f"gran/ellipsoid {LAW} surface smooth {option}", friction=0.0,
                  damping_normal=0.0)
    script = setup.with_particles(pair, f"{name}.data")
    script += f"fix w all wall/gran/ellipsoid {LAW} surface smooth primitive type 1 zplane 0.0 {option}\n"
    for kind in "pair", "wall":
        script += (f"compute {kind} all {kind}/ellipsoid/local fn delta contactArea reducedRadius\n"
                   f"dump {kind} all local 1 {name}.{kind} "
                   + " ".join(f"c_{kind}[{k}]" for k in (1, 2, 3, 4))
                   + f'\ndump_modify {kind} format "%.17g %.17g %.17g %.17g"\n')
    run(script + "run 0\n", name=f"in.{name}")
    return read_rows(f"{name}.pair")[0][0], read_rows(f"{name}.wall")[0][0]


class EllipticalContact(unittest.TestCase):
    def test_force_and_area(self):
        for number, shapes in enumerate(SHAPES):
            i, j, normal, down = touching_pair(*shapes, number)
            found = engine((i, j), "ellipticalContact on", f"on{number}")
            circle = engine((i, j), "ellipticalContact off", f"off{number}")
            b_i, p = farthest(i, normal)
            curvatures = [gap_curvatures(b_i, p, *farthest(j, -normal)),
                          gap_curvatures(*farthest(i, down), np.diag([1e-12] * 3), down * 1e6)]
            for contact, plain, (a, b) in zip(found, circle, curvatures):
                force, area = hertz(a, b, contact[1])
                print(f"B/A {b / a:.2f}: force {contact[0]:.6g} N, by integration {force / contact[0] - 1:+.1e}, "
                      f"by (19) {plain[0] / contact[0] - 1:+.4f}")
                self.assertAlmostEqual(contact[0] / force, 1.0, delta=1e-8)
                self.assertAlmostEqual(contact[2] / area, 1.0, delta=1e-8)
                self.assertAlmostEqual(plain[3] * 2.0 * math.sqrt(a * b), 1.0, delta=1e-8)
                self.assertEqual(contact[1], plain[1])
                self.assertGreater(contact[0] / plain[0], 1.0)

    def test_spheres_do_not_change(self):
        pair = touching_pair((2e-3,) * 3, (1.3e-3,) * 3, 7)[:2]
        on, off = (engine(pair, f"ellipticalContact {s}", f"sphere_{s}") for s in ("on", "off"))
        np.testing.assert_allclose(on, off, rtol=1e-13)

    def test_wrong_use_is_refused(self):
        for option in "ellipticalContact maybe", "ellipticalContact":
            line = refusal("", Setup(pair=f"gran/ellipsoid {LAW} surface smooth {option}"))
            self.assertIn("ellipticalContact", line)
        line = refusal("", Setup(pair=f"gran/ellipsoid {LAW} surface multisphere ellipticalContact on"))
        self.assertIn("ellipticalContact", line)


if __name__ == "__main__":
    unittest.main(verbosity=2)
