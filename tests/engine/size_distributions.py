"""Keyword `vary` of fix particletemplate/ellipsoid: drawn semi-axes, mass fractions of mixtures, chains of
spheres of any size, neighbour lists and forces of sizes from 1 to 20."""

import math
import unittest
from pathlib import Path

import numpy as np

from _engine import COLUMNS, LAW, Particle, Setup, dump, quaternion_of, read_dump, run, vectors

HEAD = "fix {0} all particletemplate/ellipsoid {1} semiaxes 2e-3 1.5e-3 1e-3 density 1340 {2}\n"
MORE = COLUMNS + ["density", "radius", "inertiax", "inertiay", "inertiaz"]


def inserted(templates, mix, count, columns=MORE, pair="smooth", more="", style="discrete"):
    """Columns of the particles that fix insert/pack makes of `mix`."""
    setup = Setup(box=(0.0, 0.3) * 3, pair=f"gran/ellipsoid {LAW} surface {pair}")
    run(setup.without_particles() + templates + f"""
fix mix all particledistribution/{style} 32452843 {mix}
region all block 0 0.3 0 0.3 0 0.3 units box
fix fill all insert/pack seed 32452867 distributiontemplate mix insert_every once orientation random &
    overlapcheck no all_in no region all particles_in_region {count}
fix motion all nve/ellipsoid
run 1
{more}
{dump('inserted.dump', columns=columns)}
run 0
""")
    _, c = read_dump("inserted.dump")
    return {name: values[-1] for name, values in c.items()}


def axes_of(c):
    return vectors(c, "shapex", "shapey", "shapez")


class Drawn(unittest.TestCase):
    def test_every_quantity_belongs_to_the_drawn_semiaxes(self):
        vary = "vary a uniform 0.5 2 vary b gaussian 1 0.1 vary c lognormal 0 0.3"
        c = inserted(HEAD.format("grain", 15485863, vary), "1 grain 1.0", 2000)
        self.assertGreater(len(c["id"]), 1900)
        axes = axes_of(c)
        mass = 1340.0 * 4.0 / 3.0 * math.pi * axes.prod(-1)
        np.testing.assert_allclose(c["mass"], mass, rtol=1e-12)
        np.testing.assert_allclose(c["density"], 1340.0, rtol=1e-12)
        np.testing.assert_allclose(c["radius"], axes.max(-1), rtol=1e-12)
        squares = axes ** 2
        np.testing.assert_allclose(vectors(c, "inertiax", "inertiay", "inertiaz"),
                                   0.2 * mass[:, None] * (squares.sum(-1, keepdims=True) - squares), rtol=1e-12)
        factors = axes / np.array([2e-3, 1.5e-3, 1e-3])
        a, b, c = factors.T
        error = 4.0 / math.sqrt(len(a))  # four standard errors, times the standard deviation
        self.assertTrue(0.5 <= a.min() < 0.51 and 1.99 < a.max() <= 2.0)
        self.assertAlmostEqual(a.mean(), 1.25, delta=error * 1.5 / math.sqrt(12))
        self.assertAlmostEqual(b.mean(), 1.0, delta=error * 0.1)
        self.assertAlmostEqual(b.std(), 0.1 * 0.9866, delta=error * 0.1)  # cut at 3 standard deviations
        self.assertAlmostEqual(np.log(c).mean(), 0.0, delta=error * 0.3)
        self.assertAlmostEqual(np.log(c).std(), 0.3 * 0.9866, delta=error * 0.3)
        self.assertLess(np.abs(np.corrcoef(factors.T) - np.eye(3)).max(), error, "the axes depend on each other")

    def test_one_factor_for_several_axes(self):
        c = inserted(HEAD.format("grain", 15485863, "vary all uniform 0.5 2 vary bc uniform 0.5 1"),
                     "1 grain 1.0", 300)
        a, b, c = (axes_of(c) / np.array([2e-3, 1.5e-3, 1e-3])).T
        np.testing.assert_allclose(b, c, rtol=1e-14)
        self.assertGreater((b / a).max() / (b / a).min(), 1.9)
        self.assertGreater(a.max() / a.min(), 3.8)

    def test_shares_by_number_and_by_mass(self):
        # 1 in 4 particles, or a quarter of the mass, is of a kind with 8 times the volume of the others
        templates = ("fix large all particletemplate/ellipsoid 15485863 semiaxes 4e-3 3e-3 2e-3 density 1340\n"
                     + HEAD.format("small", 15485867, ""))
        for style, by_number in (("discrete/numberbased", 0.25), ("discrete/massbased", 0.25 / (0.25 + 0.75 * 8.0))):
            c = inserted(templates, "2 large 0.25 small 0.75", 6000, style=style)
            large = axes_of(c)[:, 0] > 3e-3
            self.assertGreater(len(large), 5900)
            error = 4.0 * math.sqrt(by_number * (1.0 - by_number) / len(large))
            print(f"{style}: {large.mean():.4f} of the particles are large, expected {by_number:.4f}")
            self.assertAlmostEqual(large.mean(), by_number, delta=error)

    def test_mass_fractions_of_a_mixture(self):
        # 30 % of the mass in particles of very unlike sizes, 70 % in others
        templates = (HEAD.format("wide", 15485863, "vary all uniform 0.2 1.8")
                     + HEAD.format("narrow", 15485867, "atom_type 1 vary all lognormal 0 0.1 vary bc gaussian 0.9 0.05"))
        c = inserted(templates, "2 wide 0.3 narrow 0.7", 6000)
        wide = np.abs(axes_of(c)[:, 1] / axes_of(c)[:, 0] - 0.75) < 1e-9
        share = c["mass"][wide].sum() / c["mass"].sum()
        error = 4.0 * c["mass"][wide].std() * math.sqrt(wide.sum()) / c["mass"].sum()
        print(f"{wide.sum()} of {len(wide)} particles have {share:.3f} of the mass, 4 standard errors {error:.3f}")
        self.assertLess(error, 0.06)
        self.assertAlmostEqual(share, 0.3, delta=error)

    def test_insert_drop_on_any_number_of_ranks(self):
        frames = []
        for ranks in 1, 2:
            setup = Setup(box=(-0.03, 0.03) * 3, time_step=1e-4)
            run(setup.without_particles() + HEAD.format("grain", 15485863, "vary all gaussian 1 0.3 vary a uniform 1 2")
                + "fix drop all insert/drop seed 3 template grain particles 8 interval 1e-4 "
                "box -0.025 0.025 -0.025 0.025 -0.025 0.025 velocity 0 0 0\nfix motion all nve/ellipsoid\n"
                + "run 10\n" + dump("drop.dump", columns=MORE) + "run 0\n", ranks)
            _, c = read_dump("drop.dump")
            frames.append(axes_of(c)[-1])
        self.assertEqual(frames[0].shape, (8, 3))
        self.assertEqual(len(set(frames[0][:, 0])), 8)
        np.testing.assert_array_equal(frames[0], frames[1])

    def test_chains_of_any_size(self):
        template = ("fix grain all particletemplate/ellipsoid 15485863 semiaxes 2e-3 1e-3 1e-3 density 1340 "
                    "subspheres 7 vary all uniform 0.5 1 vary bc uniform 0.8 1.2\n")
        c = inserted(template, "1 grain 1.0", 50, MORE + ["f_subspheres"], "multisphere", more="run 50")
        self.assertEqual(set(c["f_subspheres"]), {7.0})
        self.assertGreater(np.ptp(axes_of(c)[:, 0] / axes_of(c)[:, 1]), 0.5)


class Polydisperse(unittest.TestCase):
    """400 particles of sizes from 1 to 20, of which many touch: triaxial, oblate and prolate ones, or
    chains of 7 spheres of three aspect ratios."""

    SHAPES = {"smooth": [[1.0, 0.7, 0.5], [1.0, 1.0, 0.5], [1.0, 0.5, 0.5]],
              "multisphere": [[1.0, 0.7, 0.7], [1.0, 0.6, 0.6], [1.0, 0.5, 0.5]]}

    def particles(self, surface="smooth"):
        random = np.random.default_rng(3)
        large = [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
        shapes = np.array(self.SHAPES[surface])
        particles = [Particle(tuple(8.5e-3 * np.array(p)), tuple(0.01 * shapes[k % 3]),
                              quaternion_of(random.normal(size=3), random.uniform(0, 6)))
                     for k, p in enumerate(large)]
        for k in range(392):
            size = 0.01 * 20.0 ** random.uniform(-1.0, -0.7)
            particles.append(Particle(tuple(random.uniform(-0.016, 0.016, 3)), tuple(size * shapes[k % 3]),
                                      quaternion_of(random.normal(size=3), random.uniform(0, 6))))
        return particles

    def test_neighbour_lists_find_every_contact(self):
        self.compare_lists("smooth", "smooth")

    def test_neighbour_lists_find_every_contact_of_chains(self):
        self.compare_lists("multisphere", "multisphere contacts 49",
                           "neigh_modify delay 0 page 1000000\nfix subspheres all property/atom subspheres "
                           "scalar yes yes no 7\n")

    def compare_lists(self, surface, settings, more=""):
        forces, contacts = {}, {}
        for style in "nsq", "bin":
            setup = Setup(box=(-0.04, 0.04) * 3, skin=5e-4, pair=f"gran/ellipsoid {LAW} surface {settings}")
            script = setup.with_particles(self.particles(surface)).replace(" bin\n", f" {style}\n") + more
            if style == "nsq":  # the oracle: every pair is a neighbour
                script = script.replace(f"neighbor        {setup.skin}", "neighbor        0.03")
            script += "compute c all contacts/ellipsoid\nthermo_style custom step c_c[1] c_c[3] c_c[6]\n"
            run(script + "fix motion all nve/ellipsoid\n" + dump("poly.dump") + "run 0\n")
            _, c = read_dump("poly.dump")
            forces[style] = vectors(c, "fx", "fy", "fz", "tqx", "tqy", "tqz")[0]
            log = Path("log.in.run").read_text()
            contacts[style] = [float(t) for t in log.split("Step")[1].split("\n")[1].split()]
        print("step, contacts, pairs in the list, not converged:", contacts)
        self.assertGreater(contacts["nsq"][1], 100)
        self.assertGreater(contacts["nsq"][2], 400 * 399 / 2 * 0.9)
        self.assertLess(contacts["bin"][2], 0.5 * contacts["nsq"][2])
        self.assertEqual(contacts["bin"][1], contacts["nsq"][1])
        scale = np.abs(forces["nsq"]).max(axis=0)
        # a pair is searched from either side: the normal is right to 7e-9 (unit.ellipsoid_contact)
        self.assertLess((np.abs(forces["bin"] - forces["nsq"]) / scale).max(), 1e-8)

    def test_the_host_s_neighbour_style_multi_is_refused(self):
        # it makes no list at all for granular pair styles, and every contact would be missed
        script = Setup().with_particles(self.particles()).replace(" bin\n", " multi\n")
        outcome = run(script + "fix motion all nve/ellipsoid\nrun 0\n", check=False)
        self.assertEqual(outcome.code, 1)
        self.assertRegex(outcome.text, "ERROR.*gran/ellipsoid.*neighbor.*multi.*use 'bin' or 'nsq'")


class Refused(unittest.TestCase):
    def test_wrong_values(self):
        base = "fix grain all particletemplate/ellipsoid 15485863 semiaxes 2e-3 1e-3 1e-3 "
        for words, pattern in (
                ("density 1340 vary", "'vary' lacks a value.*add"),
                ("density 1340 vary d uniform 1 2", "'vary' has the value 'd', allowed is one of 'all', 'a'"),
                ("density 1340 vary all flat 1 2", "'vary' has the value 'flat', allowed"),
                ("density 1340 vary all uniform 0 2", "'vary' has the value '0', allowed"),
                ("density 1340 vary all uniform 2 1", "'vary' has the value '1', allowed"),
                ("density 1340 vary all gaussian 1 0.34", "'vary' has the value '0.34', allowed"),
                ("density 1340 vary all lognormal 0 -1", "'vary' has the value '-1', allowed"),
                ("density 1340 vary all lognormal nan 1", "'vary' has the value 'nan', allowed"),
                ("mass 1e-5 vary all uniform 1 2", "'vary' does not go with 'mass' or 'inertia'.*use"),
                ("density 1340 inertia 1 1 1 vary a uniform 1 2", "'vary' does not go with"),
                ("density 1340 subspheres 5 vary b uniform 1 2", "'vary b' and 'vary c'.*use 'vary bc'"),
                ("density 1340 subspheres 3 vary a uniform 1 2", "the smallest N whose spheres overlap")):
            outcome = run(Setup().without_particles() + base + words + "\n", check=False)
            lines = [line for line in outcome.text.splitlines() if line.startswith("ERROR")]
            self.assertEqual((outcome.code, len(lines)), (1, 1), f"{words}: {outcome.text[-400:]}")
            self.assertRegex(lines[0], rf"particletemplate/ellipsoid.*{pattern}")


if __name__ == "__main__":
    unittest.main(verbosity=2)
