"""fix wall/gran/ellipsoid on triangle meshes, smooth and multi-sphere.

Oracles: the primitive plane; contact at edges and corners by brute force over normals (smooth) or the
closed form of spheres (multi-sphere); sums of the particles' wall forces; a wall at rest seen from a
moving frame; an uninterrupted run; one rank.
"""

import math
import unittest
from pathlib import Path

import numpy as np

from _engine import (COLUMNS, LAW, Material, Particle, Setup, dump, quaternion_of, read_dump, rotation, run,
                     vectors)
from _mesh import floor, mesh, mesh_wall, quad, write_stl, write_vtk
from _multisphere import spheres

TRIAXIAL, PROLATE = (2.6e-3, 1.7e-3, 1.1e-3), (2.7e-3, 1.15e-3, 1.15e-3)
SPHERES = 5
GRAVITY = "fix g all gravity 9.81 vector 0 -1 0\n"
MOTION = "fix motion all nve/ellipsoid\n"
FORCES = ("fx", "fy", "fz"), ("tqx", "tqy", "tqz")
STATE = (("x", "y", "z"), ("vx", "vy", "vz"), ("omegax", "omegay", "omegaz"),
         ("quat1", "quat2", "quat3", "quat4"), *FORCES)


def head(surface, bodies, **settings):
    """Script up to the walls."""
    setup = Setup(pair=f"gran/ellipsoid {LAW} surface {surface}", **settings)
    script = setup.with_particles(bodies)
    if surface == "multisphere":
        script += f"fix ms all property/atom subspheres scalar yes yes no {SPHERES}\n"
    return script


def plane(surface, more=""):
    return (f"fix w all wall/gran/ellipsoid {LAW} surface {surface} primitive type 1 yplane 0.0 "
            f"{more}\n")


def axes(surface):
    return TRIAXIAL if surface == "smooth" else PROLATE


def differences(found, expected, groups=STATE):
    """Largest difference of each group of columns relative to the group's largest value."""
    return {names[0]: np.abs(vectors(found, *names) - vectors(expected, *names)).max()
            / (np.abs(vectors(expected, *names)).max() or 1.0) for names in groups}


SURFACES = "smooth", "multisphere"


class Seams(unittest.TestCase):
    """A particle hops, rolls and slides over a floor: plane, two triangles, many triangles."""

    def slide(self, surface, wall, name):
        height = axes(surface)[1] + 3e-4
        body = Particle((-0.01, height, -0.007), axes(surface), quaternion_of((0.2, 1, 0.1), 0.5),
                        (0.3, -0.02, 0.2), (5, 3, -4))
        start = head(surface, [body], time_step=2e-6, damping_normal=8000.0, damping_tangential=2000.0)
        run(start + GRAVITY + wall
            + MOTION + dump(f"{name}.dump", 100) + "run 30000\n", name=f"in.{name}")
        return read_dump(f"{name}.dump")[1]

    def test_triangles_of_one_plane_are_one_plane(self):
        write_stl("two.stl", floor(0.04))
        write_vtk("many.vtk", floor(0.04, 31))
        for surface in SURFACES:
            flat = self.slide(surface, plane(surface), f"{surface}_plane")
            touching = (flat["fy"] > 0.0).mean()
            self.assertGreater(touching, 0.05)
            self.assertGreater(flat["x"][-1, 0] - flat["x"][0, 0], 3e-3)
            for file in "two.stl", "many.vtk":
                found = self.slide(surface, mesh("cad", file) + mesh_wall("w", ["cad"], surface),
                                   f"{surface}_{file}")
                quarter = len(flat["x"]) // 4
                worst = max(differences({n: c[:quarter] for n, c in found.items()},
                                        {n: c[:quarter] for n, c in flat.items()}).values())
                # later on every hop multiplies the difference of roundings
                places = differences(found, flat, STATE[:1])["x"]
                print(f"{surface}, {file}: {touching:.0%} of the time in contact, relative difference "
                      f"of motion and forces {worst:.1e} in the first quarter, of places {places:.1e}")
                self.assertLess(worst, 1e-10)
                self.assertLess(places, 1e-9)

    def test_exactly_on_a_seam_and_a_node_the_force_is_that_of_the_plane(self):
        write_stl("cells.stl", floor(0.04, 4))  # the origin is a node, the axes are seams
        for surface in SURFACES:
            bodies = [Particle((x, 1.14e-3 if surface == "multisphere" else 1.69e-3, z), axes(surface))
                      for x, z in ((0.0, 0.0), (0.01, 0.01), (-0.015, 0.0), (0.0, 0.013))]
            results = []
            for name, wall in (("plane", plane(surface)),
                               ("mesh", mesh("cad", "cells.stl") + mesh_wall("w", ["cad"], surface))):
                run(head(surface, bodies) + wall + dump(f"on_{name}.dump") + "run 0\n")
                results.append(read_dump(f"on_{name}.dump")[1])
            self.assertTrue((results[0]["fy"] > 0.0).all())
            worst = differences(results[1], results[0])
            print(f"{surface}, on seams and nodes: largest relative difference {worst['fx']:.1e}")
            self.assertLess(worst["fx"], 1e-12)
            np.testing.assert_allclose(results[1]["tqz"], results[0]["tqz"], rtol=0, atol=1e-15)


def hertz(radius, overlap):
    return 4.0 / 3.0 * 183e6 / (2.0 * (1.0 - 0.2 ** 2)) * math.sqrt(radius * overlap ** 3)


def smooth_overlap(body, corners):
    """Normal into the wall, overlap, point from the centre and Gaussian radius, at a corner (1, 3) or a
    line through two points (2, 3): minimum of s(n) - n.p over the unit n (normal to the line), by
    trials in a range that shrinks around the best one."""
    r = rotation(body.quaternion)
    a = r @ np.diag(np.square(body.semiaxes)) @ r.T
    way = corners[0] - np.asarray(body.position)
    if len(corners) == 2:
        edge = (corners[1] - corners[0]) / np.linalg.norm(corners[1] - corners[0])
        across = np.eye(3) - np.outer(edge, edge)
    else:
        across = np.eye(3)
    generator = np.random.default_rng(1)
    n, width = np.zeros(3), 1.0
    while width > 1e-9:
        tries = (n + width * generator.normal(size=(400, 3))) @ across
        tries = np.vstack([tries / np.linalg.norm(tries, axis=1, keepdims=True),
                           n if n.any() else way @ across / np.linalg.norm(way @ across)])
        n = tries[(np.sqrt(np.einsum("ki,ij,kj->k", tries, a, tries)) - tries @ way).argmin()]
        width *= 0.8
    s = math.sqrt(n @ a @ n)
    overlap = s - n @ way
    return n, overlap, a @ n / s - 0.5 * overlap * n, np.prod(body.semiaxes) / s ** 2


class EdgesAndCorners(unittest.TestCase):
    """One contact at the ridge of a roof, the rim of a plate and the corner of a box."""

    def check(self, surface, triangles, body, corners):
        write_stl("shape.stl", triangles)
        run(head(surface, [body], damping_normal=0.0) + mesh("cad", "shape.stl")
            + mesh_wall("w", ["cad"], surface) + dump("one.dump") + "run 0\n")
        _, columns = read_dump("one.dump")
        force, torque = (vectors(columns, *names)[0, 0] for names in FORCES)
        if surface == "smooth":
            contacts = [smooth_overlap(body, corners)]
        else:
            contacts = []
            for centre, radius in zip(*spheres(body, SPHERES)):
                place = self.nearest(corners, centre + body.position)
                way = place - (centre + body.position)
                overlap = radius - np.linalg.norm(way)
                if overlap > 0.0:
                    normal = way / np.linalg.norm(way)
                    contacts.append((normal, overlap, centre + (radius - 0.5 * overlap) * normal,
                                     radius))
        self.assertGreater(min(c[1] for c in contacts), 0.0)
        expected = sum(-hertz(r, h) * n for n, h, _, r in contacts)
        turning = sum(np.cross(p, -hertz(r, h) * n) for n, h, p, r in contacts)
        error = max(np.abs(force - expected).max() / np.abs(expected).max(),
                    np.abs(torque - turning).max() / (np.linalg.norm(expected) * 1e-3))
        print(f"{surface}: {len(contacts)} contacts, relative error {error:.1e}")
        self.assertLess(error, 1e-7)

    @staticmethod
    def nearest(corners, place):
        """Nearest point of the segment, or the corner, that matters here."""
        if len(corners) == 1:
            return corners[0]
        way = corners[1] - corners[0]
        share = np.clip((place - corners[0]) @ way / (way @ way), 0.0, 1.0)
        return corners[0] + share * way

    def pose(self, surface, q, downward, overlap, place):
        """A body whose contact with a wall of normal -downward at `place` has about this overlap."""
        body = Particle((0, 0, 0), axes(surface), q)
        r = rotation(q)
        a = r @ np.diag(np.square(body.semiaxes)) @ r.T
        if surface == "smooth":
            support = a @ downward / math.sqrt(downward @ a @ downward)
        else:
            centres, radii = spheres(body, SPHERES)
            k = (centres @ downward + radii).argmax()
            support = centres[k] + radii[k] * downward
        body.position = tuple(np.asarray(place) - support + overlap * downward)
        return body

    def test_ridge(self):
        roof = np.concatenate([quad((0, 0, -.03), (0, 0, .03), (.03, -.02, .03), (.03, -.02, -.03)),
                               quad((0, 0, -.03), (-.03, -.02, -.03), (-.03, -.02, .03), (0, 0, .03))])
        for surface in SURFACES:
            for tilt in -0.3, 0.0, 0.35:
                down = np.array([math.sin(tilt), -math.cos(tilt), 0.0])
                body = self.pose(surface, quaternion_of((1, 2, -1), 0.7), down, 1.5e-5, (0, 0, 0.004))
                self.check(surface, roof, body, np.array([[0, 0, -.03], [0, 0, .03]]))

    def test_rim_of_a_plate(self):
        plate = quad((0, 0, -.03), (0, 0, .03), (.03, 0, .03), (.03, 0, -.03))
        for surface in SURFACES:
            for tilt in 0.2, 1.2, 1.5:
                side = np.array([math.sin(tilt), -math.cos(tilt), 0.0])
                body = self.pose(surface, quaternion_of((1, -2, 1), 0.9), side, 1.5e-5, (0, 0, 0.002))
                self.check(surface, plate, body, np.array([[0, 0, -.03], [0, 0, .03]]))

    def test_corner(self):
        s = 0.02
        box = np.concatenate([
            quad((0, 0, 0), (0, 0, -s), (-s, 0, -s), (-s, 0, 0)),
            quad((0, 0, 0), (-s, 0, 0), (-s, -s, 0), (0, -s, 0)),
            quad((0, 0, 0), (0, -s, 0), (0, -s, -s), (0, 0, -s))])
        for surface in SURFACES:
            for way in ((-1, -1, -1), (-0.3, -1, -0.2)):
                n = np.asarray(way) / np.linalg.norm(way)
                body = self.pose(surface, quaternion_of((2, 1, -1), 0.8), n, 1.5e-5, (0, 0, 0))
                self.check(surface, box, body, np.zeros((1, 3)))


class Motion(unittest.TestCase):
    SPEED = 0.15

    def test_moving_belt(self):
        """fix move/mesh along the floor is the primitive plane with `shear`."""
        write_stl("belt.stl", floor(0.04, 3))
        for surface in SURFACES:
            body = Particle((0, axes(surface)[1] + 1e-6, 0), axes(surface))
            start = head(surface, [body], time_step=2e-6) + GRAVITY
            run(start + plane(surface, f"shear x {self.SPEED}") + MOTION + dump("a.dump", 100)
                + "run 8000\n")
            run(start + mesh("cad", "belt.stl") + mesh_wall("w", ["cad"], surface)
                + f"fix belt all move/mesh mesh cad linear {self.SPEED} 0. 0.\n" + MOTION
                + dump("b.dump", 100) + "run 8000\n")
            still, moving = read_dump("a.dump")[1], read_dump("b.dump")[1]
            self.assertGreater(still["vx"].max(), 0.01)
            worst = differences(moving, still, [("x", "y", "z"), ("vx", "vy", "vz")])
            print(f"{surface}, belt: {worst}")
            self.assertLess(max(worst.values()), 1e-6)

    def test_turning_table(self):
        """The wall's velocity at the contact point: the viscous part of the tangential force."""
        write_stl("table.stl", floor(0.04, 3))
        rate, damping = 1.0, 100.0
        for surface in SURFACES:
            body = Particle((0.01, 1.149e-3 if surface == "multisphere" else 1.69e-3, 0.006),
                            axes(surface))
            run(head(surface, [body], damping_tangential=damping, friction=50.0)
                + mesh("cad", "table.stl") + mesh_wall("w", ["cad"], surface)
                + f"fix turn all move/mesh mesh cad rotate origin 0. 0. 0. axis 0. 1. 0. period "
                f"{2.0 * math.pi / rate!r}\n" + dump("c.dump") + "run 1\n")
            force = vectors(read_dump("c.dump")[1], *FORCES[0])[-1, 0]
            velocity = rate * np.cross([0, 1, 0], np.array(body.position))
            slip = np.array([velocity[0], 0.0, velocity[2]])
            along = force @ slip / np.linalg.norm(slip) ** 2
            across = np.cross(force, slip)[1] / np.linalg.norm(slip)
            print(f"{surface}, table: viscous coefficient {along / body.mass:.2f} 1/s")
            # every contact has the viscous force and a spring that has grown for one step
            self.assertGreater(along / body.mass, 0.99 * damping)
            self.assertLess(abs(across), 1e-6 * np.linalg.norm(force))

    def test_servo_wall_presses_with_the_wanted_force(self):
        target = 5e-3
        write_stl("base.stl", floor(0.02, 2))
        for surface in SURFACES:
            height = axes(surface)[2]
            write_stl("lid.stl", floor(0.02, 2, 2.0 * height + 2e-6))
            flat = quaternion_of((1, 0, 0), math.pi / 2)  # the shortest axis upright
            bodies = [Particle((x, height - 1e-8, z), axes(surface), flat)
                      for x, z in ((-0.01, -0.01), (0.01, -0.008), (0.0, 0.011))]
            script = head(surface, bodies, time_step=2e-6, damping_normal=2000.0,
                          damping_tangential=2000.0)
            script += mesh("base", "base.stl", "", "mesh/surface/stress")
            script += mesh("lid", "lid.stl", f"com 0. 0. 0. ctrlPV force axis 0. -1. 0. target_val {target} "
                           "vel_max 0.02 kp 0.1", "mesh/surface/stress/servo")
            script += mesh_wall("w", ["base", "lid"], surface) + MOTION
            script += "thermo_style custom step f_lid[2] f_base[2]\nthermo 1000\n"
            run(script + "run 40000\n", name="in.servo")
            lines = [line.split() for line in Path("log.in.servo").read_text().splitlines()]
            last = [float(w) for w in [row for row in lines if row and row[0] == "40000"][-1]]
            print(f"{surface}, servo: force on the lid {last[1]:.4e} N, on the base {last[2]:.4e} N")
            self.assertAlmostEqual(last[1] / target, 1.0, delta=0.02)
            self.assertAlmostEqual(last[2] / target, -1.0, delta=0.02)


class ForcesOnTheMesh(unittest.TestCase):
    def test_stress_sums_what_the_particles_feel(self):
        sheets = np.concatenate([floor(0.03, 5), quad((-.02, 0, -.03), (-.02, .03, -.03),
                                                      (-.02, .03, .03), (-.02, 0, .03))])
        write_stl("tray.stl", sheets)
        columns = COLUMNS + [f"f_force_w[{k}]" for k in (1, 2, 3)]
        for surface in SURFACES:
            generator = np.random.default_rng(3)
            bodies = [Particle((-0.0165 + 0.007 * k, axes(surface)[1] + 6e-4, -0.01 + 0.004 * k), axes(surface),
                               quaternion_of(generator.normal(size=3), 0.3), (-0.1, -0.1, 0.05))
                      for k in range(5)]
            script = head(surface, bodies, time_step=2e-6) + GRAVITY
            script += mesh("cad", "tray.stl", "reference_point 0.01 0.02 0.03 ", "mesh/surface/stress")
            script += mesh_wall("w", ["cad"], surface, general="store_force yes") + MOTION
            script += "thermo_style custom step f_cad[1] f_cad[2] f_cad[3] f_cad[4] f_cad[5] f_cad[6]\n"
            script += "thermo_modify format float %.15g\nthermo 50\n" + dump("s.dump", 50, columns)
            run(script + "run 6000\n", name="in.stress")
            lines = [line.split() for line in Path("log.in.stress").read_text().splitlines()]
            table = {int(r[0]): np.array(r[1:], float) for r in lines
                     if len(r) == 7 and r[0].isdigit()}
            steps, c = read_dump("s.dump")
            forces = vectors(c, *columns[-3:])
            torques = vectors(c, *FORCES[1])  # of the walls only: the particles stay apart
            places = vectors(c, "x", "y", "z") - np.array([0.01, 0.02, 0.03])
            worst = 0.0
            for k, step in enumerate(steps):
                total = -forces[k].sum(0)
                turning = -(np.cross(places[k], forces[k]) + torques[k]).sum(0)
                scale = np.abs(forces[k]).max() or 1.0
                if step == 0:
                    continue
                worst = max(worst, np.abs(table[step][:3] - total).max() / scale,
                            np.abs(table[step][3:] - turning).max() / (0.03 * scale))
            print(f"{surface}, forces and torques on the mesh: relative error {worst:.1e}")
            self.assertGreater(np.abs(forces).max(), 0.0)
            self.assertLess(worst, 1e-11)


def drum(facets, radius=0.012, length=0.03):
    """A tube about the z axis, seen from inside, of 2 `facets` triangles."""
    turn = 2.0 * math.pi / facets
    rim = [(radius * math.cos(turn * k), radius * math.sin(turn * k)) for k in range(facets + 1)]
    return np.concatenate([quad((*a, -length), (*b, -length), (*b, length), (*a, length))
                           for a, b in zip(rim, rim[1:])])


class CurvedWall(unittest.TestCase):
    def test_spring_goes_along_from_facet_to_facet(self):
        """A body is carried and then slides in a turning tube of 72 facets. On a new facet without the springs
        of the one before, friction would start from none."""
        write_stl("drum.stl", drum(72))
        for surface in SURFACES:
            low = 2 if surface == "smooth" else 1  # the shortest axis upright
            flat = quaternion_of((1, 0, 0), math.pi / 2) if surface == "smooth" else (1, 0, 0, 0)
            body = Particle((0.0, -0.01199 + axes(surface)[low], 0.0), axes(surface), flat)
            script = head(surface, [body], time_step=2e-6, damping_normal=5e3, friction=0.2,
                          materials=[Material(youngs_modulus=5e6)])
            script += "fix g all gravity 100 vector 0 -1 0\n"
            script += mesh("cad", "drum.stl", "curvature 10. curvature_tolerant yes")
            script += mesh_wall("w", ["cad"], surface) + MOTION
            script += "fix turn all move/mesh mesh cad rotate origin 0. 0. 0. axis 0. 0. 1. period 1.\n"
            columns = COLUMNS + [f"f_history_w[{k}]" for k in range(1, 3)]
            run(script + dump("t.dump", 1, columns) + "run 30000\n")
            _, c = read_dump("t.dump")
            part, triangle = (c[f"f_history_w[{k}]"][:, 0] for k in (1, 2))
            passed = (part[1:] == part[:-1]) & (part[1:] > 0) & (triangle[1:] != triangle[:-1])
            place, force = vectors(c, "x", "y")[:, 0], vectors(c, "fx", "fy")[:, 0]
            force = force + np.array((0.0, 100.0 * body.mass))  # of the wall alone
            outward = place / np.linalg.norm(place, axis=1, keepdims=True)
            friction = np.abs(force[:, 0] * outward[:, 1] - force[:, 1] * outward[:, 0])
            change = friction[1:][passed] / friction[:-1][passed]
            print(f"{surface}, drum: {passed.sum()} changes of triangle, friction times {change.min():.3f} to "
                  f"{change.max():.3f}")
            self.assertGreater(passed.sum(), 1)
            self.assertGreater(change.min(), 0.5)
            self.assertLess(change.max(), 2.0)


class RestartAndRanks(unittest.TestCase):
    def pile(self, surface, start):
        script = (f"processors {start[1]} 1 1\n" if start[1] else "")
        generator = np.random.default_rng(8)
        bodies = [Particle((-0.02 + 0.006 * (k % 7), 2.4e-3 + 6e-3 * (k // 7), 0.002 * (k % 3)),
                           axes(surface), quaternion_of(generator.normal(size=3), 1.0), (0.1, -0.1, 0))
                  for k in range(14)]
        text = head(surface, bodies, time_step=5e-6)
        text = text.replace("units", script + "units", 1)
        if start[0]:
            text = text.replace("read_data particles.data", f"read_restart {start[0]}")
        return (text + GRAVITY + mesh("cad", "tray.stl") + mesh_wall("w", ["cad"], surface) + MOTION)

    def setUp(self):
        write_stl("tray.stl", np.concatenate([
            floor(0.03, 6), quad((.025, 0, -.03), (.025, .03, -.03), (.025, .03, .03), (.025, 0, .03))]))

    def test_restart_goes_on_bit_for_bit(self):
        for surface in SURFACES:
            run(self.pile(surface, ("", 0)) + "run 9000\nwrite_restart half.restart\n"
                + dump("whole.dump", 100) + "run 3000\n")
            run(self.pile(surface, ("half.restart", 0)) + dump("again.dump", 100) + "run 3000\n")
            self.assertEqual(Path("whole.dump").read_bytes(), Path("again.dump").read_bytes())

    def test_two_ranks(self):
        for surface in SURFACES:
            results = []
            for ranks in 1, 2:
                run(self.pile(surface, ("", ranks)) + dump(f"r{ranks}.dump", 500) + "run 6000\n",
                    ranks=ranks)
                results.append(read_dump(f"r{ranks}.dump")[1])
            worst = differences(results[1], results[0], [("x", "y", "z")])
            print(f"{surface}, two ranks: {worst}")
            self.assertLess(worst["x"], 1e-9)


if __name__ == "__main__":
    unittest.main(verbosity=2)
