"""Walls of flawed and faceted meshes: cracks, steps, second sheets, careless drawings, files in single
precision, hollows of few facets, meshes that are gone.

Oracles: the primitive plane; Hertz's closed form; a body at rest on two supports.
"""

import math
import unittest

import numpy as np

from _engine import LAW, Material, Particle, Setup, dump, quaternion_of, read_dump, run, thermo, vectors
from _mesh import careless_floor, mesh, mesh_wall, quad, write_stl

AXES = (2.0e-3, 1.5e-3, 1.5e-3)
MODULUS = 1e7
SOFT = [Material(youngs_modulus=MODULUS)]
GRAVITY = "fix g all gravity 9.81 vector 0 -1 0\n"
MOTION = "fix motion all nve/ellipsoid\n"
PLANE = f"fix w all wall/gran/ellipsoid {LAW} surface smooth primitive type 1 yplane 0.0\n"
SIZE = max(AXES)


def plate(x0, x1, height=0.0, z=0.02):
    return quad((x0, height, -z), (x0, height, z), (x1, height, z), (x1, height, -z))


def vertical_force(walls, places, overlap, meshes, name):
    """On a body at each place; the bodies are far apart in z and do not see each other."""
    bodies = [Particle((x, AXES[1] - overlap, 5e-3 * k), AXES) for k, x in enumerate(places, -2)]
    setup = Setup(box=(-0.03, 0.03, -0.01, 0.02, -0.03, 0.03), materials=SOFT)
    script = setup.with_particles(bodies) + walls
    if meshes:
        script += mesh_wall("w", meshes)
    run(script + dump(f"{name}.dump") + "run 0\n")
    return read_dump(f"{name}.dump")[1]["fy"][0]


def hertz(overlap):
    radius = AXES[0] * AXES[2] / AXES[1]
    return 4.0 / 3.0 * MODULUS / (2.0 * (1.0 - 0.2 ** 2)) * math.sqrt(radius * overlap ** 3)


class OneContact(unittest.TestCase):
    PLACES = (-2e-5, -3e-7, 0.0, 1e-6, 1.5e-5)  # the patch of the overlap below is 5e-5 wide
    OVERLAP = 1.304e-6

    def test_plane(self):
        np.testing.assert_allclose(vertical_force(PLANE, self.PLACES, self.OVERLAP, [], "plane"),
                                   hertz(self.OVERLAP), rtol=1e-9)

    def test_second_sheet_close_behind(self):
        write_stl("front.stl", plate(-0.02, 0.02))
        for behind in (1e-9, 1e-8, 1e-7, 1e-6, 1e-5):
            write_stl("back.stl", plate(-0.018, 0.018, -behind))
            force = vertical_force(mesh("c1", "front.stl") + mesh("c2", "back.stl"), self.PLACES, self.OVERLAP,
                                   ["c1", "c2"], "sheets")
            np.testing.assert_allclose(force, hertz(self.OVERLAP), rtol=1e-9, err_msg=f"{behind}")

    def test_crack_and_step(self):
        """Up to 1e-3 of the body's size, a crack lets the body sink in by width^2 / 8 R, a step lifts it."""
        for width in (1e-7, 1e-6, 1e-3 * SIZE):
            for step in (0.0, 1e-9, 1e-7):
                write_stl("plates.stl", np.concatenate([plate(-0.02, -0.5 * width),
                                                        plate(0.5 * width, 0.02, step)]))
                force = vertical_force(mesh("c1", "plates.stl"), self.PLACES, self.OVERLAP, ["c1"], "crack")
                dip = width ** 2 / (8.0 * AXES[1] ** 2 / AXES[0])
                self.assertGreater(force.min(), hertz(self.OVERLAP - dip) * (1.0 - 1e-4), f"{width} {step}")
                self.assertLess(force.max(), hertz(self.OVERLAP + step) * (1.0 + 1e-9), f"{width} {step}")

    def test_single_precision(self):
        """Corners near x = 1 m are off by 6e-8 m then; the body of 2 mm rests anywhere near a seam."""
        generator = np.random.default_rng(11)
        places = 1.0 + generator.uniform(-3e-5, 3e-5, 40)
        cells = np.concatenate([quad((x0, 0, z0), (x0, 0, z1), (x1, 0, z1), (x1, 0, z0))
                                for x0, x1 in ((0.99, 1.0 - 1e-9), (1.0 + 1e-9, 1.01))
                                for z0, z1 in zip(np.arange(0.0, 0.2, 0.01), np.arange(0.01, 0.21, 0.01))])
        turned = cells.copy()  # a slope, so that no coordinate is exact
        slope = 0.3
        turned[..., 0], turned[..., 1] = 1.0 + (cells[..., 0] - 1.0) * math.cos(slope), \
            0.7 + (cells[..., 0] - 1.0) * math.sin(slope)
        write_stl("single.stl", turned.astype(np.float32))
        normal, along = np.array((-math.sin(slope), math.cos(slope))), np.array((math.cos(slope), math.sin(slope)))
        overlap = 1e-5
        bodies = [Particle((*(np.array((1.0, 0.7)) + (x - 1.0) * along + (AXES[1] - overlap) * normal),
                            0.004 + 4.5e-3 * k), AXES, quaternion_of((0, 0, 1), slope))
                  for k, x in enumerate(places)]
        setup = Setup(box=(0.97, 1.03, 0.67, 0.73, 0.0, 0.2), materials=SOFT)
        run(setup.with_particles(bodies) + mesh("c1", "single.stl") + mesh_wall("w", ["c1"])
            + dump("single.dump") + "run 0\n")
        force = vectors(read_dump("single.dump")[1], "fx", "fy")[0]
        # 6e-8 m are 0.9 % of the force; two contacts would be 100 %
        np.testing.assert_allclose(force @ normal, hertz(overlap), rtol=0.02)
        self.assertLess(np.abs(force @ along).max(), 0.01 * hertz(overlap))


class CarelessDrawing(unittest.TestCase):
    """A long body rolls, and a triaxial one slides, over a floor of several thousand triangles."""

    def travel(self, walls, name):
        rest = 1.3e-6
        roller = Particle((-8e-3, AXES[1] - rest, -4e-3), AXES, quaternion_of((0, 1, 0), math.pi / 2),
                          (0.2, 0, 0), (0, 0, -0.2 / AXES[1]))
        slider = Particle((-8e-3, 1.1e-3 - rest, 4e-3), (2.6e-3, 1.1e-3, 1.7e-3), velocity=(0.4, 0, 0))
        setup = Setup(box=(-0.02, 0.02, -0.01, 0.02, -0.02, 0.02), materials=SOFT, time_step=2e-6,
                      damping_normal=3000.0, damping_tangential=3000.0)
        run(setup.with_particles([roller, slider]) + GRAVITY + walls + MOTION + dump(f"{name}.dump", 500)
            + "compute w all wall/ellipsoid/local delta\ncompute most all reduce sum c_w[1]\n"
              "thermo_style custom step c_most\nrun 30000\n", name=f"in.{name}")
        return read_dump(f"{name}.dump")[1]

    def test_is_a_plane(self):
        noise = 1e-5 * SIZE
        triangles = careless_floor(0.012, 0.008, noise, seed=7)
        self.assertGreater(len(triangles), 3000)
        write_stl("cad.stl", triangles)
        flat = self.travel(PLANE, "plane")
        found = self.travel(mesh("cad", "cad.stl", "curvature_tolerant yes") + mesh_wall("w", ["cad"]), "cad")
        way = np.abs(flat["x"][-1] - flat["x"][0])
        self.assertGreater(way.min(), 5e-3)
        off = [np.abs(vectors(found, *names) - vectors(flat, *names)).max(axis=(0, 2))
               for names in (("x", "z"), ("y",), ("vx", "vz"))]
        print(f"{len(triangles)} triangles: way {way}, off along the floor {off[0]}, in height {off[1]}, in "
              f"velocity {off[2]}")
        self.assertLess((off[0] / way).max(), 2e-4)
        self.assertLess(off[1].max(), 5 * noise)
        self.assertLess(off[2].max(), 5e-4 * 0.4)


class Hollow(unittest.TestCase):
    def test_rests_on_two_facets(self):
        """A long body across the seam of two facets, which count as one surface by `curvature`."""
        radius, turn = 0.02, math.radians(10)
        angles = -0.5 * math.pi + turn * np.arange(-3, 4)
        corners = radius * np.stack([np.cos(angles), np.sin(angles)], axis=-1)
        write_stl("hollow.stl", np.concatenate([
            quad((*p, -0.01), (*q, -0.01), (*q, 0.01), (*p, 0.01)) for p, q in zip(corners, corners[1:])]))
        body = Particle((3e-4, -0.01935956463701404, 0.0), (1.5e-3, 4e-4, 4e-4))
        setup = Setup(box=(-0.025, 0.025, -0.025, 0.025, -0.01, 0.01), boundary="f f p", materials=SOFT,
                      friction=0.5, time_step=2e-6, damping_normal=2000.0, damping_tangential=2000.0,
                      skin=0.001)
        run(setup.with_particles([body]) + GRAVITY
            + mesh("cad", "hollow.stl", "curvature 15 curvature_tolerant yes") + mesh_wall("w", ["cad"]) + MOTION
            + "compute w all wall/ellipsoid/local normal delta\ncompute e all erotate/ellipsoid\n"
              "thermo_style custom step ke c_e\nthermo 20000\nthermo_modify norm no\nrun 200000\n"
              "dump l all local 1 contacts.txt c_w[1] c_w[2] c_w[4]\nrun 0\n")
        energy = thermo("log.in.run", 3)
        print(f"kinetic energy of translation and rotation at the end {energy[-1, 1:]} J")
        self.assertLess(energy[-1, 1:].max(), 1e-24)
        with open("contacts.txt", encoding="ascii") as file:
            rows = np.array([[float(t) for t in line.split()] for line in file.read().splitlines()[9:]])
        self.assertEqual(len(rows), 2)
        self.assertGreater(abs(rows[0, 0] - rows[1, 0]), 0.5 * turn)


class Refusals(unittest.TestCase):
    def refused(self, script, *words):
        outcome = run(script, check=False)
        self.assertEqual(outcome.code, 1)
        lines = [line for line in outcome.text.splitlines() if line.startswith("ERROR")]
        self.assertEqual(len(lines), 1, outcome.text[-2000:])
        for word in words:
            self.assertIn(word, lines[0])

    def test_two_walls_of_one_id(self):
        head = Setup().with_particles([Particle((0, 0, 0), AXES)])
        self.refused(head + PLANE + PLANE.replace("yplane 0.0", "xplane 0.0"), "(id w)", "unfix")
        write_stl("floor.stl", plate(-0.02, 0.02))
        wall = mesh("cad", "floor.stl") + mesh_wall("w", ["cad"])
        self.refused(head + wall + mesh_wall("w", ["cad"]), "(id w)", "unfix")

    def test_mesh_that_is_gone(self):
        """The host itself does not let a wall's mesh be deleted or replaced."""
        write_stl("floor.stl", plate(-0.02, 0.02))
        start = (Setup().with_particles([Particle((0, 0, 0), AXES)]) + mesh("cad", "floor.stl")
                 + mesh_wall("w", ["cad"]) + MOTION)
        self.refused(start + "unfix cad\nrun 1\n", "(id cad)", "unfix fix wall/gran first")
        self.refused(start + "run 1\n" + mesh("cad", "floor.stl"), "(id cad)", "unfix fix wall/gran first")

    def test_wall_defined_anew(self):
        write_stl("floor.stl", plate(-0.02, 0.02))
        wall = mesh("cad", "floor.stl") + mesh_wall("w", ["cad"])
        body = Particle((0, AXES[1] - 1e-6, 0), AXES)
        run(Setup(materials=SOFT).with_particles([body]) + wall + "run 0\nunfix w\nunfix cad\n" + wall
            + dump("anew.dump") + "run 0\n")
        np.testing.assert_allclose(read_dump("anew.dump")[1]["fy"][0], hertz(1e-6), rtol=1e-9)


if __name__ == "__main__":
    unittest.main(verbosity=2)
