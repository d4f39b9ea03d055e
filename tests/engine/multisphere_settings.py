"""Settings of multi-spheres that cannot work are refused with one line that says what to do."""

import unittest

from _engine import LAW, Particle, Setup, quaternion_of, run
from _multisphere import SURFACE, multisphere_setup, subspheres, wall

AXES = (2.7e-3, 1.15e-3, 1.15e-3)


class Refusals(unittest.TestCase):
    number = 0

    def refused(self, script, *wanted):
        """The run on `script` stops, and one line of its output has all words of `wanted`."""
        type(self).number += 1
        outcome = run(script, check=False, timeout=60, name=f"in.{self._testMethodName}{self.number}")
        self.assertNotEqual(outcome.code, 0, f"{wanted}: accepted")
        lines = [line for line in outcome.text.splitlines() if line.startswith("ERROR")]
        self.assertTrue(lines, outcome.text[-500:])
        for word in wanted:
            self.assertIn(word, lines[0])

    @staticmethod
    def template(words):
        return (multisphere_setup().without_particles()
                + f"fix grain all particletemplate/ellipsoid 15485863 mass 2e-5 {words}\nrun 0\n")

    def test_templates(self):
        axes = "semiaxes 2.7e-3 1.15e-3 1.15e-3"
        for words, *wanted in (
                (f"{axes} subspheres 4", "subspheres", "4", "odd"),
                (f"{axes} subspheres -1", "subspheres", "'-1'", "0 to 9999"),
                (f"{axes} subspheres 1001", "subspheres", "1001", "1 to 999"),
                (f"{axes} subspheres 10001 spacing medial", "subspheres", "'10001'", "0 to 9999"),
                (f"{axes} subspheres 1002 spacing minimax_volume", "subspheres", "1002", "1 to 999"),
                (f"{axes} subspheres 5.0", "subspheres", "'5.0'", "integer"),
                (f"{axes} subspheres x", "subspheres", "'x'", "integer"),
                (f"{axes} subspheres", "subspheres", "lacks a value"),
                ("semiaxes 1e-3 1e-3 1e-3 subspheres 5", "subspheres", "1"),
                ("semiaxes 1e-3 2e-3 2e-3 subspheres 5", "subspheres", "a = 0.001", "a > b"),
                ("semiaxes 3e-3 2e-3 1e-3 subspheres 5", "b and c differ"),
                ("semiaxes 1e-2 1e-3 1e-3 subspheres 5", "subspheres", "smallest", "23"),
                (f"{axes} subspheres 5 spacing even", "spacing", "even", "minimax"),
                (f"{axes} subspheres 5 spacing", "spacing", "lacks a value")):
            with self.subTest(words=words):
                self.refused(self.template(words), *wanted)

    def test_settings_of_the_pair_style(self):
        for settings, *wanted in (
                ("contacts 0", "contacts", "'0'", "1 to 32767"),
                ("contacts 32768", "contacts", "'32768'", "1 to 32767"),
                ("contacts 1.5", "contacts", "'1.5'", "1 to 32767"),
                ("contacts x", "contacts", "'x'", "1 to 32767"),
                ("contacts", "contacts"),
                ("multicontact mean", "multicontact", "mean"),
                ("multicontact", "multicontact")):
            with self.subTest(settings=settings):
                self.refused(multisphere_setup(settings).without_particles(), *wanted)

    def test_settings_of_walls(self):
        for settings, *wanted in (
                ("contacts 0", "contacts", "'0'", "1 to 32767"),
                ("contacts", "contacts"),
                ("multicontact mean", "multicontact", "mean")):
            with self.subTest(settings=settings):
                self.refused(multisphere_setup().without_particles()
                             + wall("floor", "zplane", 0.0, settings) + "run 0\n", *wanted)

    def test_particles_without_spheres(self):
        one = [Particle((0.0, 0.0, 0.0), AXES)]
        setup = multisphere_setup()
        self.refused(setup.with_particles(one) + "run 0\n", "subspheres", "particletemplate/ellipsoid")
        self.refused(setup.with_particles(one) + subspheres(0) + "run 0\n", "atom 1", "0")
        self.refused(setup.with_particles(one) + subspheres(4) + "run 0\n", "atom 1", "odd")
        triaxial = [Particle((0.0, 0.0, 0.0), (3e-3, 2e-3, 1e-3))]
        self.refused(setup.with_particles(triaxial) + subspheres(5) + "run 0\n", "atom 1",
                     "b and c differ")

    def test_values_that_set_gives(self):
        """Neither rounded nor taken for another spacing."""
        body = Particle((0.0, 0.0, 0.0), AXES, quaternion_of((0, 0, 1), 0.3))
        script = (multisphere_setup().with_particles([body]) + subspheres(5) + "fix spacing all property/atom spacing scalar yes "
                  "yes no 0\nfix motion all nve/ellipsoid\nrun 1\n")
        for name, value, *wanted in (
                ("subspheres", "2.5", "atom 1", "subspheres is 2.5", "whole numbers"),
                ("subspheres", "1e12", "subspheres is 1e", "whole numbers"),
                ("subspheres", "4", "atom 1", "odd"),
                ("spacing", "77", "atom 1", "spacing is 77", "0 (paper)"),
                ("spacing", "-1", "spacing is -1", "0 (paper)"),
                ("spacing", "1.5", "spacing is 1.5", "whole numbers")):
            with self.subTest(name=name, value=value):
                self.refused(script + f"set group all property/atom {name} {value}\nrun 1\n", *wanted)

    def test_surface_of_another_pair_style(self):
        setup = Setup(pair=f"gran {LAW} {SURFACE}", atom_style="sphere")
        self.refused(setup.without_particles() + "run 0\n", "gran/ellipsoid")

    def flat_pair(self, settings):
        """Two particles flat on each other and on a floor at z = 0."""
        setup = multisphere_setup(settings)
        depth = 5e-5
        pair = [Particle((0.0, 0.0, k * (2 * AXES[1] - depth) + AXES[1] - depth), AXES) for k in (0, 1)]
        return setup.with_particles(pair) + subspheres(17)

    def test_history_larger_than_the_pages(self):
        """Of the host's neighbour lists: to be seen before the run, not as a crash in it."""
        self.refused(self.flat_pair("contacts 24") + "run 10\n", "contacts", "neigh_modify page", "240000")
        run(self.flat_pair("contacts 24") + "neigh_modify page 240000\nrun 10\n", name="in.pages_240000")
        self.refused(self.flat_pair("contacts 600") + "neigh_modify page 8000000 one 200\nrun 10\n",
                     "contacts", "neigh_modify page", str((2 ** 31 - 1) // 3000))  # the host counts by int
        run(self.flat_pair("contacts 24") + "neigh_modify one 800\nrun 10\n", name="in.one_800")

    def test_largest_settings(self):
        """What is allowed is not refused."""
        pair = [Particle((4e-3 * k, 0.0, 0.0), AXES, quaternion_of((0, 1, 0), 1.5)) for k in (0, 1)]
        setup = multisphere_setup("contacts 64 multicontact average")
        run(setup.with_particles(pair) + "neigh_modify page 1000000\n" + subspheres(1) + "run 2\n",
            name="in.largest")


if __name__ == "__main__":
    unittest.main(verbosity=2)
