"""What the host does to particles works with atom_style granular/ellipsoid: inserting, creating, setting,
freezing, moving, grouping, deleting, properties per atom, coupling to a flow solver."""

import math
import unittest
from pathlib import Path

import numpy as np

from _engine import (COLUMNS, LAW, Particle, Setup, dump, host_is_inl, quaternion_of, read_dump, rotation, run, thermo,
                     vectors)
from _multisphere import chain

AXES = (2.7e-3, 1.9e-3, 1.1e-3)
MORE = COLUMNS + ["density", "radius", "inertiax", "inertiay", "inertiaz", "angmomx", "angmomy", "angmomz"]
TEMPLATE = """
fix grain all particletemplate/ellipsoid 15485863 semiaxes 2.7e-3 1.9e-3 1.1e-3 density 1340 {0}
fix mix all particledistribution/discrete 32452843 1 grain 1.0
"""
MOTION = "fix motion all nve/ellipsoid\n"
STILL = "compute c all contacts/ellipsoid\nthermo_style custom step atoms c_c[1] c_c[6]\n"


def last(file="out.dump"):
    _, c = read_dump(file)
    return {name: values[-1] for name, values in c.items()}


def final(columns=MORE):
    return dump("out.dump", columns=columns) + "run 0\n"


class Insertion(unittest.TestCase):
    BOX = Setup(box=(-0.03, 0.03) * 3, time_step=1e-5)

    def insert(self, command, steps, surface="smooth", ranks=1):
        setup = Setup(box=self.BOX.box, time_step=1e-5, pair=f"gran/ellipsoid {LAW} surface {surface}")
        template = TEMPLATE.format("")
        if surface == "multisphere":
            template = template.replace("1.9e-3 1.1e-3", "1.1e-3 1.1e-3").format("").replace("1340", "1340 subspheres 9")
        run(setup.without_particles() + template + MOTION + STILL + command + f"run {steps}\n" + final(), ranks)
        c = last()
        touching = float(Path("log.in.run").read_text().split("Step")[-1].split("\n")[1].split()[2])
        return c, touching

    def check(self, c, touching, least):
        self.assertEqual(touching, 0, "inserted particles overlap")
        self.assertGreaterEqual(len(c["id"]), least)
        self.assertEqual(len(set(c["id"])), len(c["id"]))
        q = vectors(c, "quat1", "quat2", "quat3", "quat4")
        np.testing.assert_allclose(np.linalg.norm(q, axis=1), 1.0, rtol=1e-12)
        self.assertGreater(q.std(axis=0).min(), 0.2, "orientations are not random")

    def test_pack(self):
        command = """
region low block -0.03 0.03 -0.03 0.03 -0.03 0.03 units box
fix fill all insert/pack seed 32452867 distributiontemplate mix vel constant 0 0 0 orientation random &
    insert_every once overlapcheck yes all_in yes region low particles_in_region 150
"""
        for surface, ranks in ("smooth", 1), ("smooth", 2), ("multisphere", 1):
            with self.subTest(surface, ranks=ranks):
                c, touching = self.insert(command, 1, surface, ranks)
                self.check(c, touching, 100)
                self.assertLess(np.abs(vectors(c, "x", "y", "z")).max(), 0.03 - 2.7e-3)  # all_in: bounding sphere

    def test_stream(self):
        facet = "facet normal 0 0 1\nouter loop\n{}endloop\nendfacet\n"
        corners = ["vertex -0.02 -0.02 0.01\n", "vertex 0.02 -0.02 0.01\n", "vertex 0.02 0.02 0.01\n",
                   "vertex -0.02 0.02 0.01\n"]
        Path("face.stl").write_text("solid face\n" + facet.format("".join(corners[k] for k in (0, 1, 2)))
                                    + facet.format("".join(corners[k] for k in (0, 2, 3))) + "endsolid face\n")
        command = """
fix face all mesh/surface/planar file face.stl type 1 scale 1.
fix fill all insert/stream seed 32452867 distributiontemplate mix nparticles 60 vel constant 0 0 -1.0 &
    orientation random particlerate 3000 overlapcheck yes insertion_face face extrude_length 0.012
"""
        for surface, ranks in ("smooth", 1), ("smooth", 2), ("multisphere", 2):
            with self.subTest(surface, ranks=ranks):
                c, touching = self.insert(command, 3000, surface, ranks)
                self.check(c, touching, 25)
                np.testing.assert_array_equal(c["vz"], -1.0)

    def test_rate_region(self):
        command = """
region all block -0.03 0.03 -0.03 0.03 0.0 0.03 units box
fix fill all insert/rate/region seed 32452867 distributiontemplate mix nparticles 60 particlerate 3000 &
    insert_every 500 overlapcheck yes vel constant 0 0 -1.0 orientation random region all ntry_mc 10000
"""
        for surface in "smooth", "multisphere":
            with self.subTest(surface):
                c, touching = self.insert(command, 1500, surface)
                self.check(c, touching, 40)
                self.assertGreater(len(set(np.round(c["z"] + 0.0, 6))), 20)


class CreateAndSet(unittest.TestCase):
    def test_create_atoms_and_set(self):
        setup = Setup(box=(-0.03, 0.03) * 3)
        a, b, c = AXES
        run(setup.without_particles() + MOTION + f"""
create_atoms 1 single 0.01 0 0 units box
create_atoms 1 single -0.01 0 0 units box
set group all shape {a} {b} {c} density 1340 quat 0 0 1 30
set atom 2 quat_direct 0.6 0 0.8 0 omegaz 50 vx 0.2
set atom 2 type 1
""" + final())
        out = last()
        mass = 1340.0 * 4.0 / 3.0 * math.pi * a * b * c
        np.testing.assert_allclose(out["mass"], mass, rtol=1e-12)
        self.assertTrue(np.all((a <= out["radius"]) & (out["radius"] < 1.001 * a)))  # the host adds a little
        np.testing.assert_allclose(vectors(out, "inertiax", "inertiay", "inertiaz"),
                                   [[0.2 * mass * s for s in (b * b + c * c, a * a + c * c, a * a + b * b)]] * 2,
                                   rtol=1e-12)
        np.testing.assert_allclose(vectors(out, "shapex", "shapey", "shapez"), [AXES] * 2, rtol=1e-15)
        q = vectors(out, "quat1", "quat2", "quat3", "quat4")
        np.testing.assert_allclose(q, [quaternion_of((0, 0, 1), math.pi / 6), (0.6, 0, 0.8, 0)], atol=1e-15)
        self.assertEqual(out["vx"][1], 0.2)
        # omega set by the host reaches the angular momentum, from which the particle turns
        inertia = rotation(q[1]) @ np.diag(vectors(out, "inertiax", "inertiay", "inertiaz")[1]) @ rotation(q[1]).T
        np.testing.assert_allclose(vectors(out, "angmomx", "angmomy", "angmomz")[1],
                                   inertia @ np.array([0.0, 0.0, 50.0]), rtol=1e-12, atol=1e-20)


class Prescribed(unittest.TestCase):
    """A body on another one that is frozen or moved by the host: triaxial ones."""

    AXES, SURFACE, SUBSPHERES = AXES, "smooth", ""

    def run_on(self, fix, steps, motion=MOTION.replace("all", "upper"), time_step=2e-6):
        c = self.AXES[2]
        setup = Setup(time_step=time_step, damping_normal=20000.0, damping_tangential=20000.0,
                      pair=f"gran/ellipsoid {LAW} surface {self.SURFACE}")
        bodies = [Particle((0.0, 0.0, 0.0), self.AXES), Particle((0.0, 0.0, 2 * c - 2e-6), self.AXES)]
        run(setup.with_particles(bodies) + self.SUBSPHERES + "group lower id 1\ngroup upper id 2\n" + motion + fix
            + f"run {steps}\n" + final())
        return last()

    def test_freeze(self):
        out = self.run_on("fix hold lower freeze\nfix gravity upper gravity 9.81 vector 0 0 -1\n", 4000)
        self.assertEqual([out[n][0] for n in ("x", "y", "z", "fx", "fy", "fz", "tqx", "tqy", "tqz")], [0.0] * 9)
        self.assertGreater(out["fz"][1] + out["mass"][1] * 9.81, 0.0)
        self.assertAlmostEqual(out["z"][1], 2 * self.AXES[2], delta=1e-5)  # it rests on the frozen one

    def test_move_linear_and_wiggle(self):
        out = self.run_on("fix go lower move linear 0.5 0 0 units box\n", 1000)
        self.assertAlmostEqual(out["x"][0], 0.5 * 1000 * 2e-6, delta=1e-12)
        self.assertEqual(tuple(out[f"quat{k}"][0] for k in (1, 2, 3, 4)), (1.0, 0.0, 0.0, 0.0))
        self.assertGreater(out["vx"][1], 1e-4, "friction does not drag the upper body along")
        out = self.run_on("fix go lower move wiggle 0 0.001 0 0.01 units box\n", 1000)
        self.assertAlmostEqual(out["y"][0], 0.001 * math.sin(2 * math.pi * 0.002 / 0.01), delta=1e-12)

    def test_move_rotate_turns_the_body(self):
        out = self.run_on("fix go lower move rotate 0.01 0 0 0 0 1 0.008 units box\n", 1000)
        self.assertAlmostEqual(out["x"][0], 0.01, delta=1e-9)
        self.assertAlmostEqual(out["y"][0], -0.01, delta=1e-9)
        self.assertAlmostEqual(out["quat1"][0], math.cos(math.pi / 4), delta=1e-12)  # a quarter turn
        self.assertAlmostEqual(out["quat4"][0], math.sin(math.pi / 4), delta=1e-12)
        self.assertAlmostEqual(out["omegaz"][0], 2 * math.pi / 0.008, delta=1e-9)

    def test_a_body_that_is_turned_meets_another(self):
        """A long body at rest is turned upright below another: contact where the tip arrives."""
        a, b = 3e-3, 1e-3
        bodies = [Particle((0.0, 0.0, 0.0), (a, b, b)),
                  Particle((0.0, 0.0, a + b - 2e-5), (a, b, b))]
        setup = Setup(time_step=1e-6, pair=f"gran/ellipsoid {LAW} surface {self.SURFACE}")
        run(setup.with_particles(bodies) + self.SUBSPHERES + "group lower id 1\ngroup upper id 2\n"
            + "fix hold upper freeze\nfix go lower move rotate 0 0 0 0 1 0 0.008 units box\n"
            + "compute c all contacts/ellipsoid\nthermo_style custom step c_c[1]\nthermo_modify norm no\nthermo 10\n"
            + "run 2000\n")
        rows = thermo("log.in.run", 2)
        first = rows[rows[:, 1] > 0, 0][0]
        angles = 2 * math.pi * rows[:, 0] * 1e-6 / 0.008
        if self.SURFACE == "smooth":  # the tip passes the height of the other's lowest point
            touches = np.hypot(a * np.sin(angles), b * np.cos(angles)) > a - 2e-5
        else:  # any two of the spheres
            x, radii = chain(a, b, 9)
            lower = np.stack([np.outer(np.cos(angles), x), np.outer(np.sin(angles), x)], -1)
            upper = np.stack([x, np.full(len(x), a + b - 2e-5)], -1)
            distances = np.linalg.norm(lower[:, :, None] - upper, axis=-1)
            touches = (distances < radii[:, None] + radii).any((1, 2))
        expected = rows[touches, 0][0]
        self.assertGreater(expected, 1500)
        self.assertLessEqual(abs(first - expected), 20)


class PrescribedChains(Prescribed):
    AXES, SURFACE = (2.7e-3, 1.1e-3, 1.1e-3), "multisphere"
    SUBSPHERES = "fix subspheres all property/atom subspheres scalar yes yes no 9\n"


def row_of_bodies(count=6):
    return [Particle((0.008 * k - 0.02, 0.0, 0.0), AXES, quaternion_of((1, 2, 3), 0.2 * k), (0.1 * k, 0, 0),
                     (0, 0, 10.0 * k)) for k in range(count)]


class Bookkeeping(unittest.TestCase):
    def test_groups_regions_and_deletion(self):
        script = Setup().with_particles(row_of_bodies()) + """
region right block 0.0 INF INF INF INF INF units box
group right region right
group fast id 5 6
group slow subtract right fast
fix motion slow nve/ellipsoid
run 10
delete_atoms group fast compress no
run 0
delete_atoms region right2 compress no
"""
        script = script.replace("group right region", "region right2 block -0.03 -0.015 INF INF INF INF units box\n"
                                "group right region")
        run(script + "run 10\n" + final())
        out = last()
        self.assertEqual(list(out["id"]), [2.0, 3.0, 4.0])
        for k, i in enumerate(out["id"]):
            start = row_of_bodies()[int(i) - 1]
            moved = start.position[0] > 0.0
            self.assertAlmostEqual(out["x"][k] - start.position[0], moved * start.velocity[0] * 20 * 1e-6,
                                   delta=1e-12)
            np.testing.assert_allclose([out[n][k] for n in ("shapex", "shapey", "shapez")], AXES)

    def test_property_atom_goes_along(self):
        setup = Setup(boundary="p p p", time_step=1e-5)
        script = setup.with_particles(row_of_bodies()) + MOTION
        define = "fix mark all property/atom mark scalar yes yes no 7.0\n"
        run(script + define + "run 1\nset atom 3 property/atom mark 2.5\nset atom 6 property/atom mark 9.0\n"
            + "run 20000\nwrite_restart mark.restart\n" + dump("mark.dump", columns=COLUMNS + ["f_mark"])
            + "run 0\n", ranks=2)
        values = last("mark.dump")["f_mark"]
        np.testing.assert_array_equal(values, [7, 7, 2.5, 7, 7, 9])
        self.assertGreater(last("mark.dump")["id"].size, 5)
        run(setup.header() + "read_restart mark.restart\n" + setup.properties() + MOTION + define
            + dump("again.dump", columns=COLUMNS + ["f_mark"]) + "run 0\n")
        np.testing.assert_array_equal(last("again.dump")["f_mark"], values)


class Coupling(unittest.TestCase):
    """The host's exchange by files, once in the run. LIGGGHTS-INL has other words for it, and tells the solver less."""

    BODIES = row_of_bodies(3)
    TORQUE = "force explicit torque explicit" if host_is_inl() else "transfer_torque yes"

    def couple(self, options):
        for name, value in ("dragforce", "1e-4 0 0"), ("hdtorque", "0 0 1e-8"):
            Path(f"{name}0").write_text(f"{len(self.BODIES)}\n" + f"{value}\n" * len(self.BODIES))
        return run(Setup(time_step=1e-5).with_particles(self.BODIES) + MOTION + f"""
fix cfd all couple/cfd couple_every 10 file ./
fix force all couple/cfd/force {options}
run 15
""" + final(), timeout=60, check=False)

    def test_forces_and_torques_of_a_flow_solver(self):
        outcome = self.couple(self.TORQUE + ("" if host_is_inl() else " transfer_density yes"))
        self.assertEqual(outcome.code, 0)
        self.assertRegex(outcome.text, "WARNING: Fix couple/cfd/force .*told the bounding radius.*transfer_superquadric yes")
        out = last()
        np.testing.assert_allclose(out["fx"], 1e-4, rtol=1e-12)
        np.testing.assert_allclose(out["tqz"], 1e-8, rtol=1e-12)
        self.assertTrue(np.all(out["vx"] > [p.velocity[0] for p in self.BODIES]))
        names = ("radius",) if host_is_inl() else ("radius", "density", "omega")
        written = {name: np.loadtxt(f"{name}1", skiprows=1) for name in names}
        np.testing.assert_allclose(written["radius"], AXES[0], rtol=1e-4)
        if not host_is_inl():
            np.testing.assert_allclose(written["density"], 1340.0, rtol=1e-4)
            np.testing.assert_allclose(written["omega"][:, 2], [0.0, 10.0, 20.0], rtol=0.05)

    def test_shapes_are_not_exchanged_by_files(self):
        outcome = self.couple(f"{self.TORQUE} transfer_superquadric yes")
        self.assertEqual(outcome.code, 1)
        self.assertIn("could not find property blockiness", outcome.text)

    def test_drag_of_an_integrator_of_spheres(self):
        """LIGGGHTS-INL alone has it; elsewhere these words are unknown to the host."""
        for options in ("", "force implicit", "force explicit torque implicit", "force explicit CAddRhoFluid 0.5 1.0",
                        "force explicit transfer_ellipsoid yes")[0 if host_is_inl() else 1:]:
            outcome = self.couple(options)
            self.assertEqual(outcome.code, 1, options)
            self.assertRegex(outcome.text, "ERROR: fix couple/cfd/force .id force. with.*integrator of spheres"
                             if host_is_inl() else "ERROR")


if __name__ == "__main__":
    unittest.main(verbosity=2)
