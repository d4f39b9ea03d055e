"""fix check/timestep/ellipsoid: fractions of Rayleigh's and Hertz's time against closed forms (spheres, and
the time of a real collision) and against brute force over the surface; warning, error, wrong arguments."""

import math
import unittest

import numpy as np

from _engine import LAW, Material, Particle, Setup, dump, quaternion_of, read_dump, run, thermo

STEP = 1e-6
MODULUS, RATIO, DENSITY = 183e6, 0.2, 1340.0


def check(particles, more="", every=1, setup=None, extra="", limits="0.2 0.2"):
    """Fractions (rayleigh, hertz, skin) of the first step."""
    setup = setup or Setup(time_step=STEP)
    script = setup.with_particles(particles) + extra + f"""
fix motion all nve/ellipsoid
fix check all check/timestep/ellipsoid {every} {limits} {more}
thermo_style custom step f_check[1] f_check[2] f_check[3]
thermo 1
thermo_modify format float %.17g
run 1
"""
    outcome = run(script, check=False)
    return outcome, (thermo("log.in.run")[-1, 1:] if outcome.code == 0 else None)


def rayleigh(radius, density=DENSITY):
    shear = MODULUS / (2.0 * (1.0 + RATIO))
    return math.pi * radius * math.sqrt(density / shear) / (0.1631 * RATIO + 0.8766)


def hertz(mass2_over_radius, speed, modulus=MODULUS / (2.0 * (1.0 - RATIO ** 2))):
    return 2.87 * (mass2_over_radius / (modulus ** 2 * speed)) ** 0.2


def brute_force(particle, count=400):
    """Smallest m*^2/R over points of the surface, by its parametrisation."""
    a, b, c = particle.semiaxes
    u, v = np.meshgrid(np.linspace(0.0, 0.5 * math.pi, count), np.linspace(0.0, 0.5 * math.pi, count))
    r = np.stack([a * np.sin(v) * np.cos(u), b * np.sin(v) * np.sin(u), c * np.cos(v)], axis=-1)
    gradient = r / np.array([a * a, b * b, c * c])
    square = (gradient ** 2).sum(-1)
    gauss = 1.0 / (a * b * c * square) ** 2  # curvature of an ellipsoid at its point r
    n = gradient / np.sqrt(square)[..., None]
    mobility = 1.0 / particle.mass + (np.cross(r, n) ** 2 / np.array(particle.moments)).sum(-1)
    effective_mass, radius = 0.5 / mobility, 0.5 / np.sqrt(gauss)
    return (effective_mass ** 2 / radius).min()


class Fractions(unittest.TestCase):
    def test_spheres(self):
        r, speed = 1.5e-3, 0.3
        sphere = Particle((0, 0, 0), (r, r, r), velocity=(speed, 0, 0))
        _, (rayleigh_share, hertz_share, skin_share) = check([sphere])
        effective_mass, radius = 0.5 * sphere.mass, 0.5 * r
        np.testing.assert_allclose(
            [rayleigh_share, hertz_share, skin_share],
            [STEP / rayleigh(r), STEP / hertz(effective_mass ** 2 / radius, 2 * speed),
             2 * speed * STEP / 0.002], rtol=1e-12)

    def test_hertz_time_is_that_of_a_collision(self):
        # two equal spheres that collide at the relative speed that the check assumes
        r, speed = 1.5e-3, 0.1
        pair = [Particle((-r - 1e-6, 0, 0), (r, r, r), velocity=(speed, 0, 0)),
                Particle((r + 1e-6, 0, 0), (r, r, r), velocity=(-speed, 0, 0))]
        setup = Setup(time_step=STEP, damping_normal=0.0, damping_tangential=0.0, friction=0.0)
        _, shares = check(pair, setup=setup)
        run(setup.with_particles(pair) + "fix motion all nve/ellipsoid\n" + dump("pair.dump") + "run 600\n")
        _, c = read_dump("pair.dump")
        steps = (c["fx"][:, 0] != 0.0).sum()
        self.assertAlmostEqual(steps * shares[1], 1.0, delta=2.5 * shares[1])

    def test_rotation_counts_in_the_speed(self):
        body = Particle((0, 0, 0), (3e-3, 2e-3, 1e-3), velocity=(0, 0.2, 0), omega=(0, 0, 100.0))
        _, shares = check([body])
        self.assertAlmostEqual(shares[2] / (2 * (0.2 + 100.0 * 3e-3) * STEP / 0.002), 1.0, delta=1e-12)
        _, shares = check([body], "vmax 5.0")
        self.assertAlmostEqual(shares[2] / (2 * 5.0 * STEP / 0.002), 1.0, delta=1e-12)

    def test_ellipsoids_against_brute_force(self):
        for axes, moments in (((2.7e-3, 1.15e-3, 1.15e-3), ()), ((3e-3, 2e-3, 1e-3), ()),
                              ((1e-3, 3e-3, 3e-3), ()), ((3e-3, 2.9e-3, 0.3e-3), ()),
                              ((2e-3, 1e-3, 1e-3), (1e-12, 2e-12, 2e-12))):
            body = Particle((0, 0, 0), axes, quaternion_of((1, 2, 3), 0.7), (0, 0.4, 0), moments=moments)
            _, shares = check([body])
            self.assertAlmostEqual(shares[0] / (STEP / rayleigh(min(axes))), 1.0, delta=1e-12)
            expected = STEP / hertz(brute_force(body), 0.8)
            # the brute force's points are 0.2 degrees apart: it is above the minimum by that squared
            self.assertAlmostEqual(shares[1] / expected, 1.0, delta=2e-5, msg=f"{axes}")
            self.assertGreater(shares[1] / expected, 1.0 - 1e-9)

    def test_the_worst_of_all_types_and_sizes(self):
        setup = Setup(time_step=STEP, materials=[Material(), Material(1e9, 0.3)])
        small, large = (Particle((x, 0, 0), (r, r, r), velocity=(0.1, 0, 0)) for x, r in ((0, 5e-4), (0.02, 3e-3)))
        for ranks_of_types in ((1, 2), (1, 1)):
            small.type, large.type = ranks_of_types
            _, shares = check([small, large], setup=setup)
            # the stiffest partner counts, also one of a type that only a wall has
            compliance = (1 - RATIO ** 2) / MODULUS, (1 - 0.3 ** 2) / 1e9
            modulus = 1.0 / (compliance[0] + compliance[1])
            of_small = hertz((0.5 * small.mass) ** 2 / 2.5e-4, 0.2, modulus)
            self.assertAlmostEqual(shares[1] / (STEP / of_small), 1.0, delta=1e-12)

    def test_multispheres(self):
        body = Particle((0, 0, 0), (2e-3, 1e-3, 1e-3), velocity=(0.1, 0, 0))
        setup = Setup(time_step=STEP, pair=f"gran/ellipsoid {LAW} surface multisphere")
        extra = "fix subspheres all property/atom subspheres scalar yes yes no 3.\n"
        _, shares = check([body], setup=setup, extra=extra)
        # N = 3: a sphere of radius b, two of radius (a - b)/2 that touch it, at (a + b)/2
        def value(radius, arm):
            return 0.5 / radius / (1.0 / body.mass + arm ** 2 / body.moments[1]) ** 2
        expected = hertz(min(value(1e-3, 0.0), value(0.5e-3, 1.5e-3)), 0.2)
        self.assertAlmostEqual(shares[1] / (STEP / expected), 1.0, delta=1e-12)


class Default(unittest.TestCase):
    """Of scripts without the fix."""

    WORDS = "The check of the time step"

    @staticmethod
    def pair(step, speed=0.2, more=""):
        """Two bodies that collide, the time step over the duration of the collision by brute force."""
        bodies = [Particle((s * 2.7e-3, 0, 0), (2.7e-3, 1.9e-3, 1.1e-3), velocity=(-s * speed, 0, 0)) for s in (-1, 1)]
        outcome = run(Setup(time_step=step).with_particles(bodies) + more + "fix motion all nve/ellipsoid\nrun 20\n",
                      check=False)
        return outcome, step / hertz(brute_force(bodies[0]), 2 * speed)

    def test_twenty_times_the_duration_of_a_collision(self):
        _, share = self.pair(1e-6)
        for factor in (20.0, 1.1):
            outcome, share_now = self.pair(factor * 1e-6 / share)
            self.assertAlmostEqual(share_now, factor, delta=1e-6)
            self.assertEqual(outcome.code, 1, outcome.text[-500:])
            self.assertRegex(outcome.text, rf"ERROR: {self.WORDS}: the time step over the shortest duration of a "
                                           r"collision[^\n]* use a smaller time step")

    def test_warning_once(self):
        _, share = self.pair(1e-6)
        outcome, _ = self.pair(0.9 * 1e-6 / share)
        self.assertEqual(outcome.code, 0)
        self.assertEqual(outcome.text.count(f"WARNING: {self.WORDS}"), 1)
        outcome, _ = self.pair(0.05 * 1e-6 / share)
        self.assertNotIn(self.WORDS, outcome.text)

    def test_a_fix_of_the_script_takes_its_place(self):
        _, share = self.pair(1e-6)
        outcome, _ = self.pair(0.9 * 1e-6 / share, more="fix mine all check/timestep/ellipsoid 1 1e3 1e3\n")
        self.assertEqual(outcome.code, 0)
        self.assertNotIn("the time step over", outcome.text)

    def test_bodies_that_touch_nothing(self):
        """A free flight has no collisions: the step is named and the run goes on."""
        body = Particle((0, 0, 0), (3e-3, 2e-3, 1e-3), velocity=(0.5, 0, 0))
        outcome = run(Setup(time_step=1e-3).with_particles([body]) + "fix motion all nve/ellipsoid\nrun 20\n")
        self.assertEqual(outcome.text.count(f"WARNING: {self.WORDS}"), 1)


class Answers(unittest.TestCase):
    BODY = [Particle((0, 0, 0), (3e-3, 2e-3, 1e-3), velocity=(0.5, 0, 0))]

    def test_warning_error_or_nothing(self):
        outcome, _ = check(self.BODY, limits="1e-3 1e-3")
        self.assertEqual(outcome.code, 0)
        for what in "Rayleigh time", "collision":
            self.assertRegex(outcome.text, rf"WARNING: Fix check/timestep/ellipsoid \(id check\).*{what}.* is "
                                           rf"[\d.e-]+, allowed is up to 0.001; use a smaller time step")
        outcome, _ = check(self.BODY, "warn no", limits="1e-3 1e-3")
        self.assertNotIn("Rayleigh", outcome.text)
        outcome, _ = check(self.BODY)
        self.assertNotIn("Rayleigh", outcome.text)
        outcome, _ = check(self.BODY, "error yes", limits="1e-3 1e-3")
        self.assertEqual(outcome.code, 1)
        self.assertRegex(outcome.text, "ERROR.*check/timestep/ellipsoid.*Rayleigh.*use a smaller time step")

    def test_wrong_arguments(self):
        for every, limits, more, word in ((0, "0.2 0.2", "", "every"), ("x", "0.2 0.2", "", "every"),
                                          (1, "0 0.2", "", "rayleigh"), (1, "0.2 nan", "", "hertz"),
                                          (1, "0.2", "", "hertz"), (1, "0.2 0.2", "warn on", "warn"),
                                          (1, "0.2 0.2", "vmax -1", "vmax"), (1, "0.2 0.2", "error", "error"),
                                          (1, "0.2 0.2", "speed 1", "speed")):
            outcome, _ = check(self.BODY, more, every, limits=limits)
            lines = [line for line in outcome.text.splitlines() if line.startswith("ERROR")]
            self.assertEqual((outcome.code, len(lines)), (1, 1), outcome.text[-500:])
            self.assertRegex(lines[0], rf"check/timestep/ellipsoid \(id check\).*'{word}'.*(allowed|add)")


if __name__ == "__main__":
    unittest.main(verbosity=2)
