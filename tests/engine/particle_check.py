"""No particle that cannot be simulated goes unnoticed: bodies that cannot be, numbers that are not finite,
particles that nobody moves or that two fixes move."""

import struct
import unittest
from pathlib import Path

from _engine import Particle, Setup, run
from _spinning import MOTION, bodies

REMEDY = r"shorten the time step and look with 'fix check/timestep/ellipsoid'"


class Bodies(unittest.TestCase):
    def refused(self, script, pattern):
        outcome = run(script, check=False)
        lines = [line for line in outcome.text.splitlines() if line.startswith("ERROR")]
        self.assertEqual((outcome.code, len(lines)), (1, 1), outcome.text[-500:])
        self.assertRegex(lines[0], pattern)

    def test_moments_that_no_body_has(self):
        script = Setup().with_particles(bodies()) + MOTION
        self.refused(script + "set atom 2 inertiax 1e-3\nrun 1\n",
                     "atom 2 has the principal moments 0.001 .* none larger than the sum of the two others")
        self.refused(script + "run 1\nset atom 3 inertiay 1e-3\nrun 1\n", "atom 3 has the principal moments")
        inadmissible = Particle((0, 0, 0), (3e-3, 2e-3, 1e-3), moments=(1e-11, 1e-11, 3e-11))
        self.refused(Setup().with_particles([inadmissible]) + MOTION + "run 1\n",
                     "atom 1 has the principal moments 1e-11 1e-11 3e-11")

    def test_a_created_particle_without_a_shape(self):
        script = Setup().without_particles() + MOTION + "create_atoms 1 single 0 0 0 units box\n"
        self.refused(script + "run 1\n", "atom 1 has the bounding radius 0.5, .*add 'set ... shape a b c'")
        run(script + "set group all shape 0.003 0.002 0.001\nset group all density 2000\nrun 1\n")
        large = Setup(box=(-2.0, 2.0, -2.0, 2.0, -2.0, 2.0), skin=0.1)  # a sphere of this size has room
        run(large.without_particles() + MOTION + "create_atoms 1 single 0 0 0 units box\nrun 1\n")


    def test_particles_of_a_restart_file(self):
        """The only way left for other superquadrics and other bounding spheres: the commands that make them are
        refused. The file is altered, and goes without its seal, as one of an unpatched LIGGGHTS."""
        axes, shift = (3e-3, 2e-3, 1e-3), 8 * 10  # from shape to radius, in the row of a particle
        setup = Setup()
        run(setup.with_particles([Particle((0, 0, 0), axes)]) + MOTION + "run 0\nwrite_restart whole.restart\n")
        whole = Path("whole.restart").read_bytes()[:-32].replace(b"with liggghts-ellipsoid", b"with_other_extensions__")
        place = whole.index(struct.pack("<5d", *axes, 2.0, 2.0))
        for at, value, pattern in (
                (place + 24, None, None), (place + 24, 8.0, "has the blockiness 8 2, allowed is 2 2"),
                (place + 32, 2.5, "has the blockiness 2 2.5, allowed is 2 2"),
                (place - shift, 2.9e-3, "has the bounding radius 0.0029, allowed is the largest of its semi-axes"),
                (place - shift, 4e-3, "has the bounding radius 0.004, allowed is"),
                (place, 2e-3, "has the bounding radius 0.003, allowed is")):
            altered = whole if value is None else whole[:at] + struct.pack("<d", value) + whole[at + 8:]
            Path("altered.restart").write_bytes(altered)
            script = setup.header() + "read_restart altered.restart\n" + setup.properties() + MOTION + "run 1\n"
            if value is None:
                run(script)
            else:
                self.refused(script, pattern)

    def test_other_atom_styles(self):
        for style in ("sphere", "superquadric"):
            setup = Setup(atom_style=style)
            self.refused(setup.without_particles() + "run 1\n", "gran/ellipsoid.*use atom_style granular/ellipsoid")


class NotFinite(unittest.TestCase):
    def test_a_gear_step_that_is_too_long(self):
        """Half a radian a step is beyond what this integrator can do."""
        for k, (planar, axis) in enumerate((("no", (1.0, 2.0, 3.0)), ("yes", (0.0, 0.0, 1.0)))):
            step = 1e-3
            scale = 0.5 / step / sum(a * a for a in axis) ** 0.5
            spinning = Particle((0.01, 0, 0), (3e-3, 2e-3, 1e-3), omega=tuple(scale * a for a in axis))
            still = Particle((-0.01, 0, 0), (3e-3, 2e-3, 1e-3))
            script = Setup(time_step=step).with_particles([still, spinning]) + \
                f"fix motion all nve/ellipsoid integrator gear planar {planar}\nrun 20000\n"
            for ranks in (1, 2):
                outcome = run(script, ranks, check=False, name=f"in.gear{k}_{ranks}")
                if planar == "yes":  # the turn about one axis is free of the rest: exact
                    self.assertEqual(outcome.code, 0)
                    continue
                lines = [line for line in outcome.text.splitlines() if line.startswith("ERROR")]
                self.assertNotEqual(outcome.code, 0)
                self.assertEqual(len(lines), 1, outcome.text[-800:])
                self.assertRegex(lines[0], f"atom 2 has the .*(nan|inf).*{REMEDY}")

    def test_a_force_that_is_too_large(self):
        """By the integrator's own means, before the next output and before a place is looked for."""
        for motion in ("", " integrator gear", " planar yes"):
            body = Particle((0, 0, 0), (3e-3, 2e-3, 1e-3))
            setup = Setup(boundary="p p p", time_step=1.0)
            script = setup.with_particles([body]) + f"fix motion all nve/ellipsoid{motion}\n" \
                "fix push all addforce 1e305 0 0\nrun 100\n"
            outcome = run(script, check=False)
            self.assertEqual(outcome.code, 1, outcome.text[-500:])
            self.assertRegex(outcome.text, f"ERROR[^\n]*atom 1 has the [a-z ]*(-?nan|-?inf)[^\n]*{REMEDY}")


class Integrators(unittest.TestCase):
    NONE, TWO = "are moved by no fix", "are moved by two fixes"

    def warnings(self, commands):
        text = run(Setup().with_particles(bodies()) + commands).text
        return [warning for warning in (self.NONE, self.TWO) if warning in text], text

    def test_none_and_two(self):
        found, text = self.warnings("run 1\n")
        self.assertEqual(found, [self.NONE])
        self.assertIn("3 ellipsoids are moved by no fix; add 'fix ID GROUP nve/ellipsoid'", text)
        found, text = self.warnings("group some id 1 2\nfix one all nve/ellipsoid\nfix two some nve/ellipsoid\n"
                                    "run 1\n")
        self.assertEqual(found, [self.TWO])
        self.assertIn("2 ellipsoids are moved by two fixes of nve/ellipsoid (id one), nve/ellipsoid (id two)", text)

    GRAINS = ("region nowhere block 0.049 0.05 0.049 0.05 0.049 0.05 units box\ngroup new region nowhere\n"
              "fix grain all particletemplate/ellipsoid 15485863 semiaxes 2e-3 1e-3 1e-3 density 2500\n"
              "fix mix all particledistribution/discrete 32452843 1 grain 1.0\n"
              "region cloud block 0.02 0.04 -0.04 0.04 -0.04 0.04 units box\n"
              "fix drop new insert/pack seed 32452867 distributiontemplate mix insert_every 5 overlapcheck yes region cloud "
              "particles_in_region 4\n")

    def test_particles_that_come_later(self):
        """The group of the insertion is moved by two fixes, or by none; said once."""
        for ranks, start in ((1, Setup().with_particles(bodies())), (2, Setup().without_particles())):
            for motion, wanted in (("fix one all nve/ellipsoid\nfix two new nve/ellipsoid\n", [self.TWO]),
                                   ("group old id 1 2 3\nfix one old nve/ellipsoid\n", [self.NONE]),
                                   ("fix one all nve/ellipsoid\n", [])):
                text = run(start + self.GRAINS + motion + "run 20\n", ranks).text
                found = [warning for warning in (self.NONE, self.TWO) if warning in text]
                self.assertEqual(found, wanted, (ranks, motion))
                for warning in wanted:
                    self.assertEqual(text.count(warning), 1)

    def test_no_particle_and_no_fix(self):
        text = run(Setup().without_particles() + self.GRAINS + "run 20\n").text
        self.assertIn("WARNING: new ellipsoids are moved by no fix", text)
        self.assertEqual(text.count(self.NONE), 1)
        self.assertEqual(self.warnings("fix hold all freeze\nrun 1\n")[0], [])

    def test_one_or_frozen(self):
        for commands in (MOTION + "run 1\n", "run 0\n" + MOTION + "run 1\n",
                         "group held id 1\ngroup free id 2 3\nfix go free nve/ellipsoid\nfix hold held freeze\nrun 1\n",
                         "fix go all move linear 1 0 0 units box\nrun 1\n"):
            self.assertEqual(self.warnings(commands)[0], [])


if __name__ == "__main__":
    unittest.main(verbosity=2)
