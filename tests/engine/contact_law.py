"""The contact law of Markauskas et al. 2010, eqs. (23) and (24), on pairs of rotated ellipsoids.

Oracle: the equations written down here once more in their published form (like materials) and with
the host's effective moduli (unlike materials), on contact geometry from the implicit surfaces
(_contact_geometry.py). Particles are held still while their velocities stay as given: the spring
then grows by exactly v_t dt per step.
"""

import math
import unittest
from pathlib import Path

import numpy as np

import _contact_geometry as geometry
from _engine import (Material, Particle, Setup, dump, quaternion_of, read_dump, rotation, run,
                     vectors)

SOFT, HARD = Material(183e6, 0.2), Material(0.9e9, 0.33)
FRICTION, ETA_N, ETA_T, TIME_STEP, STEPS = 0.3, 150.0, 90.0, 1e-6, 60
PAIRS = 12
SPACING = 0.03
RELATIVE = 1e-9  # the geometry below and the engine's each converge to 1e-12 of the semi-axes


def make_pairs():
    """Overlapping pairs (i, j), a != b != c, any orientation, sizes up to 1:3, four of each
    combination of materials."""
    random = np.random.default_rng(20100)
    pairs = []
    for k in range(PAIRS):
        centre = np.array([SPACING * (k % 4 - 1.5), SPACING * (k // 4 - 1.0), 0.0])
        bodies = []
        for scale in (1.0, random.uniform(0.6, 3.0)):
            axes = scale * 1e-3 * np.array([random.uniform(1.8, 2.6), random.uniform(1.3, 1.7),
                                            random.uniform(0.9, 1.2)])
            bodies.append((axes, quaternion_of(random.normal(size=3), random.uniform(0.0, 6.0))))
        direction = random.normal(size=3)
        shapes = [geometry.shape_matrix(axes, rotation(q)) for axes, q in bodies]
        distance = 4e-3 * direction / np.linalg.norm(direction)
        normal, overlap, _, _ = geometry.contact(*shapes, distance)
        wanted = random.uniform(0.002, 0.03) * min(bodies[0][0].min(), bodies[1][0].min())
        distance = distance + (overlap - wanted) * normal
        types = [(1, 1), (2, 2), (1, 2), (2, 1)][k % 4]
        # slow enough that nothing slips at first, some fast enough to slip before the last step
        speed = 2e-3 if k < 8 else 2.0
        i, j = (Particle(tuple(place), tuple(axes), q, tuple(speed * random.normal(size=3)),
                         tuple(300.0 * speed * random.normal(size=3)), type=t)
                for place, (axes, q), t in zip((centre, centre + distance), bodies, types))
        pairs.append((i, j))
    return pairs


def effective_moduli(material_i, material_j):
    """E* and G* of the host (Pa): 1/E* = sum (1 - nu^2)/E, 1/G* = sum 2 (2 - nu)(1 + nu)/E."""
    both = (material_i, material_j)
    e = 1.0 / sum((1.0 - m.poissons_ratio ** 2) / m.youngs_modulus for m in both)
    g = 1.0 / sum(2.0 * (2.0 - m.poissons_ratio) * (1.0 + m.poissons_ratio) / m.youngs_modulus
                  for m in both)
    return e, g


class PairLaw:
    """Everything of one pair that does not change while it is held."""

    def __init__(self, i, j):
        materials = {1: SOFT, 2: HARD}
        self.like = i.type == j.type
        self.material = materials[i.type]
        self.moduli = effective_moduli(materials[i.type], materials[j.type])
        distance = np.subtract(j.position, i.position)
        shapes = [geometry.shape_matrix(p.semiaxes, rotation(p.quaternion)) for p in (i, j)]
        normal, self.overlap, point, self.radius = geometry.contact(*shapes, distance)
        self.normal = -normal  # from j to i, as the law has it
        self.lever_i, self.lever_j = point, point - distance
        self.mass = i.mass * j.mass / (i.mass + j.mass)
        velocity = (np.add(i.velocity, np.cross(i.omega, self.lever_i))
                    - np.add(j.velocity, np.cross(j.omega, self.lever_j)))  # eqs. 16, 17
        self.approach = velocity @ self.normal
        self.slip = velocity - self.approach * self.normal

    def normal_force(self):
        """Component along the normal (N), eq. 23."""
        if self.like:
            e, nu = self.material.youngs_modulus, self.material.poissons_ratio
            elastic = 2.0 / 3.0 * e / (1.0 - nu ** 2) * math.sqrt(self.radius * self.overlap ** 3)
        else:
            elastic = 4.0 / 3.0 * self.moduli[0] * math.sqrt(self.radius * self.overlap ** 3)
        return elastic - ETA_N * self.mass * self.approach

    def tangential_stiffness(self):
        root = math.sqrt(self.radius * self.overlap)
        if self.like:
            nu = self.material.poissons_ratio
            shear_modulus = self.material.youngs_modulus / (2.0 * (1.0 + nu))
            return 8.0 / 3.0 * shear_modulus * root / (2.0 - nu)  # eq. 24
        return 16.0 / 3.0 * self.moduli[1] * root

    def forces(self, steps):
        """Force on i after 1 ... `steps` growths of the spring (steps, 3), and whether it slips."""
        normal_force, stiffness = self.normal_force(), self.tangential_stiffness()
        limit = FRICTION * abs(normal_force)
        damping = ETA_T * self.mass * self.slip
        spring = np.zeros(3)
        forces, slips = [], []
        for _ in range(steps):
            spring = spring + TIME_STEP * self.slip  # eq. 18
            trial = -stiffness * spring - damping
            magnitude = np.linalg.norm(trial)
            slips.append(magnitude > limit)
            force = trial * min(1.0, limit / magnitude)  # eq. 24
            if slips[-1]:
                spring = -(force + damping) / stiffness
            forces.append(force)
        return normal_force * self.normal + np.array(forces), np.array(slips)


class ContactLaw(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.pairs = make_pairs()
        setup = Setup(materials=[SOFT, HARD], friction=FRICTION, damping_normal=ETA_N,
                      damping_tangential=ETA_T, time_step=TIME_STEP,
                      box=(-0.08, 0.08, -0.08, 0.08, -0.03, 0.03))
        script = setup.with_particles([p for pair in cls.pairs for p in pair])
        run(script + dump("pairs.dump") + f"run {STEPS}\n")
        _, columns = read_dump(Path("pairs.dump"))
        cls.force = vectors(columns, "fx", "fy", "fz")
        cls.torque = vectors(columns, "tqx", "tqy", "tqz")
        cls.laws = [PairLaw(*pair) for pair in cls.pairs]

    def frames(self, k):
        """Forces and torques on i and j of pair k, frames 1 ... STEPS."""
        return (self.force[1:, 2 * k], self.force[1:, 2 * k + 1],
                self.torque[1:, 2 * k], self.torque[1:, 2 * k + 1])

    def assert_close(self, found, expected, scale, what):
        error = np.abs(found - expected).max() / scale
        self.worst = max(getattr(self, "worst", 0.0), error)
        self.assertLess(error, RELATIVE, f"{what}: relative error {error:.2e}")

    def test_normal_force_of_equation_23(self):
        for k, law in enumerate(self.laws):
            along = self.frames(k)[0] @ law.normal
            expected = law.normal_force()
            self.assert_close(along, expected, abs(expected), f"pair {k}, normal force")
        print(f"normal force, eq. 23: worst relative error {self.worst:.1e}")

    def test_forces_of_equations_23_and_24(self):
        sticking = sliding = 0
        for k, law in enumerate(self.laws):
            expected, slips = law.forces(STEPS)
            sticking, sliding = sticking + (~slips).sum(), sliding + slips.sum()
            found = self.frames(k)[0]
            tangential = np.linalg.norm(expected - np.outer(expected @ law.normal, law.normal), axis=1)
            self.assert_close(found, expected, tangential.max(), f"pair {k}, force")
        print(f"eqs. 23 and 24: worst error / tangential force {self.worst:.1e}; "
              f"{sticking} sticking, {sliding} sliding moments")
        self.assertGreater(sticking, 200)
        self.assertGreater(sliding, 50)

    def test_the_spring_grows_with_the_slip(self):
        for k, law in enumerate(self.laws[:4]):
            force = self.frames(k)[0]
            total = -law.tangential_stiffness() * TIME_STEP * (STEPS - 1) * law.slip
            self.assert_close(force[-1] - force[0], total, np.linalg.norm(total), f"pair {k}, growth")
            middle = STEPS // 2
            self.assert_close((force[middle] - force[0]) * (STEPS - 1) / middle, total,
                              np.linalg.norm(total), f"pair {k}, growth up to the middle")

    def test_coulomb_limit(self):
        for k, law in enumerate(self.laws[8:], 8):
            last = self.frames(k)[0][-1]
            tangential = last - (last @ law.normal) * law.normal
            self.assert_close(np.linalg.norm(tangential), FRICTION * abs(law.normal_force()),
                              abs(law.normal_force()), f"pair {k}, friction limit")
            against = -tangential @ law.slip / np.linalg.norm(tangential) / np.linalg.norm(law.slip)
            self.assertAlmostEqual(against, 1.0, delta=1e-9)

    def test_action_and_reaction_at_the_contact_point(self):
        for k, law in enumerate(self.laws):
            force_i, force_j, torque_i, torque_j = self.frames(k)
            np.testing.assert_array_equal(force_i, -force_j)
            scale = np.abs(force_i).max() * np.linalg.norm(law.lever_j)
            self.assert_close(torque_i, np.cross(law.lever_i, force_i), scale, f"pair {k}, torque i")
            self.assert_close(torque_j, np.cross(law.lever_j, force_j), scale, f"pair {k}, torque j")

    def test_cases_are_general(self):
        for law in self.laws:
            off_centre = np.linalg.norm(np.cross(law.lever_i, law.normal)) / np.linalg.norm(law.lever_i)
            self.assertGreater(off_centre, 0.01, "the normal is on the line of centres")


if __name__ == "__main__":
    unittest.main(verbosity=2)
