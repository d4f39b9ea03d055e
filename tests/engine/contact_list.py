"""compute pair/ellipsoid/local and wall/ellipsoid/local: every contact once, with the geometry and
the force that the particles felt.

Oracles: the sums of the listed forces and of their torques are the particles' forces and torques;
geometry of smooth pairs by _contact_geometry.py, of multi-spheres by brute force over all spheres,
of planes in closed form; the same rows on 1, 2 and 4 ranks.
"""

import math
import unittest
from pathlib import Path

import numpy as np

from _contact_geometry import contact, shape_matrix
from _contact_rows import (HEIGHT, PAIR_COLUMNS, WALL_COLUMNS, crowd, crowd_setup, floor_and_lid,
                           lists, named, read_rows, refusal, vector)
from _engine import LAW, Particle, Setup, dump, quaternion_of, read_dump, rotation, run, vectors
from _mesh import floor, mesh, mesh_wall, write_stl
from _multisphere import pair_contacts, spheres, subspheres, wall_contacts

STEPS = 20
SMOOTH_AXES = (2.6e-3, 2.3e-3, 1.8e-3)
MULTISPHERE_AXES, SPHERES = (2.5e-3, 1.7e-3, 1.7e-3), 7
MODELS = {"smooth": "smooth", "multisphere": "multisphere contacts 16",
          "average": "multisphere contacts 16 multicontact average"}


def simulate(name, ranks):
    """Dumps of the particles and of the contacts of steps 0 and STEPS: name.dump, .pairs, .walls."""
    surface = MODELS[name.split(".")[0]]
    smooth = surface == "smooth"
    setup = crowd_setup(surface)
    script = setup.with_particles(crowd(SMOOTH_AXES if smooth else MULTISPHERE_AXES), f"{name}.data")
    if not smooth:
        script += "neigh_modify page 1000000\n" + subspheres(SPHERES)
    script += floor_and_lid(surface) + "fix motion all nve/ellipsoid\n" + lists(name, STEPS)
    run(script + dump(f"{name}.dump", STEPS) + f"run {STEPS}\n", ranks, name=f"in.{name}")


def sorted_rows(file, columns):
    """Rows of the last frame in an order that does not depend on the ranks."""
    rows = read_rows(file)[STEPS]
    names = ("id_1", "id_2") if columns is PAIR_COLUMNS else ("id", "wall")
    keys = [rows[:, columns.index(n)] for n in (*names, "sphere_1", "sphere_2")]
    return rows[np.lexsort(keys[::-1])]


def as_dicts(rows, columns):
    return [dict(zip(columns, row)) for row in rows]


class ContactList(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        for model in MODELS:
            for ranks in (1, 2, 4) if model != "average" else (1,):
                simulate(f"{model}.{ranks}", ranks)

    def test_forces_and_torques_of_the_rows_are_those_of_the_particles(self):
        for name in [f"{m}.{r}" for m in ("smooth", "multisphere") for r in (1, 2, 4)] + ["average.1"]:
            _, columns = read_dump(f"{name}.dump")
            pairs, walls = read_rows(f"{name}.pairs"), read_rows(f"{name}.walls")
            worst = 0.0
            for frame, step in enumerate((0, STEPS)):
                totals = self.totals(pairs[step], walls[step], columns["id"].shape[1])
                for found, names in zip(totals, (("fx", "fy", "fz"), ("tqx", "tqy", "tqz"))):
                    expected = vectors(columns, *names)[frame]
                    worst = max(worst, np.abs(found - expected).max() / np.abs(expected).max())
            print(f"{name}: {len(pairs[STEPS])} contacts of pairs, {len(walls[STEPS])} of walls; "
                  f"sums differ from the particles' forces by {worst:.1e}")
            self.assertGreater(len(pairs[STEPS]), 50)
            self.assertGreater(len(walls[STEPS]), 10)
            self.assertLess(worst, 1e-12)

    @staticmethod
    def totals(pairs, walls, count):
        """Forces and torques (count, 3) of all particles from the rows."""
        force, torque = np.zeros((count, 3)), np.zeros((count, 3))
        for row in as_dicts(pairs, PAIR_COLUMNS):
            f, point = vector(row, "fx", "fy", "fz"), vector(row, "px", "py", "pz")
            for k, sign in (1, 1.0), (2, -1.0):
                centre = vector(row, *(f"{n}_{k}" for n in "xyz"))
                force[int(row[f"id_{k}"]) - 1] += sign * f
                torque[int(row[f"id_{k}"]) - 1] += sign * np.cross(point - centre, f)
        for row in as_dicts(walls, WALL_COLUMNS):
            f, point = vector(row, "fx", "fy", "fz"), vector(row, "px", "py", "pz")
            force[int(row["id"]) - 1] += f
            torque[int(row["id"]) - 1] += np.cross(point - vector(row, "x_1", "y_1", "z_1"), f)
        return force, torque

    def test_same_rows_on_any_number_of_ranks(self):
        for model in "smooth", "multisphere":
            for kind, columns in ("pairs", PAIR_COLUMNS), ("walls", WALL_COLUMNS):
                one = sorted_rows(f"{model}.1.{kind}", columns)
                for ranks in 2, 4:
                    other = sorted_rows(f"{model}.{ranks}.{kind}", columns)
                    scale = np.abs(one).max(axis=0)
                    scale[scale == 0.0] = 1.0
                    np.testing.assert_allclose(other / scale, one / scale, rtol=0, atol=1e-11)

    def test_pairs_appear_once_smaller_id_first(self):
        rows = named(read_rows("smooth.2.pairs")[STEPS], PAIR_COLUMNS)
        self.assertTrue((rows["id_1"] < rows["id_2"]).all())
        self.assertEqual(len(set(zip(rows["id_1"], rows["id_2"]))), len(rows["id_1"]))

    def test_derived_columns(self):
        for model in "smooth", "multisphere":
            for kind, columns in ("pairs", PAIR_COLUMNS), ("walls", WALL_COLUMNS):
                c = named(read_rows(f"{model}.1.{kind}")[STEPS], columns)
                force, normal = vectors(c, "fx", "fy", "fz"), vectors(c, "nx", "ny", "nz")
                along = (force * normal).sum(axis=1)
                scale = np.abs(force).max()
                normal_part = along[:, None] * normal
                for found, expected in (
                        (vectors(c, "fnx", "fny", "fnz"), normal_part), (c["fn"], -along),
                        (vectors(c, "ftx", "fty", "ftz"), force - normal_part),
                        (c["ft"], np.linalg.norm(force - normal_part, axis=1))):
                    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-13 * scale)
                np.testing.assert_allclose(c["area"], math.pi * c["radius"] * c["overlap"],
                                           rtol=1e-14)

    def particles(self, name):
        _, columns = read_dump(f"{name}.dump")
        quaternions = vectors(columns, "quat1", "quat2", "quat3", "quat4")[-1]
        places = vectors(columns, "x", "y", "z")[-1]
        axes = vectors(columns, "shapex", "shapey", "shapez")[-1]
        return [Particle(tuple(p), tuple(a), tuple(q)) for p, a, q in zip(places, axes, quaternions)]

    def test_geometry_of_smooth_contacts(self):
        particles, worst, worst_radius = self.particles("smooth.1"), 0.0, 0.0
        for row in as_dicts(read_rows("smooth.1.pairs")[STEPS], PAIR_COLUMNS):
            shapes = [shape_matrix(p.semiaxes, rotation(p.quaternion)) for p in (
                particles[int(row["id_1"]) - 1], particles[int(row["id_2"]) - 1])]
            place = [vector(row, *(f"{n}_{k}" for n in "xyz")) for k in (1, 2)]
            normal, overlap, point, radius = contact(*shapes, place[1] - place[0])
            worst_radius = max(worst_radius, abs(row["radius"] / radius - 1))
            worst = max(worst, abs(row["overlap"] - overlap) / 1e-3,
                        np.abs(vector(row, "nx", "ny", "nz") - normal).max(),
                        np.abs(vector(row, "px", "py", "pz") - place[0] - point).max() / 1e-3)
            self.assertEqual((row["sphere_1"], row["sphere_2"]), (0, 0))
        print(f"geometry of smooth contacts: largest difference {worst:.1e}, of reduced radii "
              f"{worst_radius:.1e}")
        self.assertLess(worst, 1e-12)
        self.assertLess(worst_radius, 1e-11)

    def test_geometry_of_multisphere_contacts(self):
        particles, seen, rows = self.particles("multisphere.1"), {}, as_dicts(
            read_rows("multisphere.1.pairs")[STEPS], PAIR_COLUMNS)
        for row in rows:
            seen.setdefault((int(row["id_1"]), int(row["id_2"])), []).append(row)
        for (first, second), found in seen.items():
            i = particles[first - 1]
            i.position = tuple(vector(found[0], "x_1", "y_1", "z_1"))
            j = Particle(tuple(vector(found[0], "x_2", "y_2", "z_2")),
                         particles[second - 1].semiaxes, particles[second - 1].quaternion)
            expected = pair_contacts(i, j, SPHERES, SPHERES)
            self.assertEqual(len(found), len(expected))
            # brute force goes through the spheres in order
            found.sort(key=lambda row: (row["sphere_1"], row["sphere_2"]))
            self.compare(found, expected, np.array(i.position))
        self.assertGreater(len(rows), len(seen), "no pair has several contacts")
        self.assertEqual({row["sphere_1"] for row in rows}, set(range(1, SPHERES + 1)))

    def test_geometry_of_walls(self):
        planes = {1: HEIGHT, 2: 0.0}  # in the order of their definition
        particles = self.particles("multisphere.1")
        walls = as_dicts(read_rows("multisphere.1.walls")[STEPS], WALL_COLUMNS)
        count = 0
        for number, p in enumerate(particles, 1):
            for wall, height in planes.items():
                found = sorted((r for r in walls if (r["id"], r["wall"]) == (number, wall)),
                               key=lambda row: row["sphere_1"])
                expected = wall_contacts(p, SPHERES, (0, 0, height),
                                         (0, 0, 1.0 if height > 0 else -1.0))
                self.assertEqual(len(found), len(expected))
                self.compare(found, expected, np.array(p.position))
                count += len(found)
        self.assertEqual(count, len(walls))

    def compare(self, rows, expected, centre):
        for row, (normal, overlap, radius, point) in zip(rows, expected):
            self.assertAlmostEqual(row["overlap"], overlap, delta=1e-12 * radius)
            self.assertAlmostEqual(row["radius"] / radius, 1.0, delta=1e-11)
            np.testing.assert_allclose(vector(row, "nx", "ny", "nz"), normal, atol=1e-11)
            np.testing.assert_allclose(vector(row, "px", "py", "pz") - centre, point, atol=1e-14)


def resting(axes, multisphere):
    """16 turned particles that overlap with the plane y = 0 by 10 to 25 micrometres."""
    random, particles = np.random.default_rng(8), []
    for k in range(16):
        p = Particle((6e-3 * (k % 4) - 8.3e-3, 0.0, 6e-3 * (k // 4) - 8.7e-3), axes,
                     quaternion_of(random.normal(size=3), random.uniform(0, math.pi)),
                     (0.1, -0.05, 0.2), (3.0, -4.0, 5.0))
        r = rotation(p.quaternion)
        reach = math.sqrt(((r @ np.diag(axes))[1] ** 2).sum())
        if multisphere:
            centres, radii = spheres(p, SPHERES)
            reach = (radii - centres[:, 1]).max()
        p.position = (p.position[0], reach - 1e-5 - 1e-6 * k, p.position[2])
        particles.append(p)
    return particles


class MeshWall(unittest.TestCase):
    """Rows of a floor of 8 triangles are those of the plane, with the triangle under the contact."""

    def rows(self, name, surface, wall):
        multisphere = surface != "smooth"
        setup = Setup(pair=f"gran/ellipsoid {LAW} surface {surface}")
        script = setup.with_particles(
            resting(MULTISPHERE_AXES if multisphere else SMOOTH_AXES, multisphere), f"{name}.data")
        run(script + (subspheres(SPHERES) if multisphere else "") + wall + lists(name) + "run 0\n",
            name=f"in.{name}")
        rows = read_rows(f"{name}.walls")[0]
        return rows[np.lexsort([rows[:, WALL_COLUMNS.index(n)] for n in ("sphere_1", "id")])]

    def test_rows_of_a_mesh_are_those_of_the_plane(self):
        triangles = floor(0.02, 2)
        write_stl("floor.stl", triangles)
        for surface in "smooth", "multisphere":
            plane = self.rows(f"plane_{surface}", surface, f"fix w all wall/gran/ellipsoid {LAW} "
                              f"surface {surface} primitive type 1 yplane 0.0\n")
            meshed = self.rows(f"mesh_{surface}", surface,
                               mesh("m", "floor.stl") + mesh_wall("w", ["m"], surface))
            triangle = WALL_COLUMNS.index("triangle")
            self.assertGreaterEqual(len(plane), 16)
            self.assertEqual(set(plane[:, triangle]), {-1})
            same = np.arange(len(WALL_COLUMNS)) != triangle
            scale = np.maximum(np.abs(plane).max(axis=0), 1e-9)
            forces = [k for k, name in enumerate(WALL_COLUMNS) if name.startswith("f")]
            scale[forces] = np.abs(plane[:, forces]).max()  # each is a part of the same force
            np.testing.assert_allclose((meshed / scale)[:, same], (plane / scale)[:, same], atol=1e-9)
            for row in as_dicts(meshed, WALL_COLUMNS):
                a, b, c = triangles[int(row["triangle"])]
                foot = vector(row, "px", "pz") - a[[0, 2]]
                weights = np.linalg.solve(np.stack([b - a, c - a], axis=1)[[0, 2]], foot)
                self.assertTrue((weights >= 0).all() and weights.sum() <= 1, row)


class Selection(unittest.TestCase):
    """A group lists contacts between its members; columns come in the order asked for."""

    def test_group_and_order(self):
        script = crowd_setup("smooth").with_particles(crowd(SMOOTH_AXES), "group.data")
        script += floor_and_lid("smooth") + "group some id <= 16\n"
        for group in "some", "all":
            for kind in "pair", "wall":
                script += (f"compute {kind}_{group} {group} {kind}/ellipsoid/local delta id\n"
                           f"dump {kind}_{group} all local 1 {group}.{kind} "
                           + " ".join(f"c_{kind}_{group}[{k}]" for k in (1, 2, 3)) + "\n")
        run(script + "run 0\n")
        for kind, members in ("pair", slice(1, 3)), ("wall", slice(1, 2)):
            every, some = (read_rows(Path(f"{g}.{kind}"))[0] for g in ("all", "some"))
            expected = every[(every[:, members] <= 16).all(axis=1)]
            self.assertTrue(0 < len(expected) < len(every))
            np.testing.assert_array_equal(some, expected)
            self.assertTrue((every[:, 0] < 2e-3).all() and (every[:, 1] >= 1).all())


class WrongUse(unittest.TestCase):
    def refused(self, commands, *words, setup=None):
        line = refusal(commands, setup)
        for word in words:
            self.assertIn(word, line)

    def test_wrong_use_is_refused(self):
        for kind in "pair", "wall":
            style = f"{kind}/ellipsoid/local"
            self.refused(f"compute c all {style} id heatFlux\n", style, "heatFlux", "contactArea")
        self.refused("compute c all wall/ellipsoid/local\n", "wall/ellipsoid/local",
                     "fix wall/gran/ellipsoid")
        self.refused("compute c all pair/ellipsoid/local\n", "pair_style gran does not work",
                     "gran/ellipsoid", setup=Setup(pair="gran model hertz surface superquadric"))


if __name__ == "__main__":
    unittest.main(verbosity=2)
