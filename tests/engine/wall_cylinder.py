"""fix wall/gran/ellipsoid with the cylinders of the host as walls, inside and outside, smooth and
multi-sphere.

Oracles: distances of the surface's points from the axis, searched for both tips separately; spheres in
closed form; a cylinder so wide that it is a plane; the rigid rotation of the wall.
"""

import math
import unittest

import numpy as np

from _engine import (LAW, Particle, Setup, dump, quaternion_of, read_dump, rotation, run, vectors)
from _multisphere import spheres

SPHERES = 9
LONG = {"smooth": (5e-3, 1.3e-3, 1.1e-3), "multisphere": (5e-3, 1.3e-3, 1.3e-3)}
MODULUS = 183e6 / (2.0 * (1.0 - 0.2 ** 2))


def head(surface, bodies, **settings):
    script = Setup(pair=f"gran/ellipsoid {LAW} surface {surface}", **settings).with_particles(bodies)
    if surface == "multisphere":
        script += f"fix ms all property/atom subspheres scalar yes yes no {SPHERES}\n"
    return script


def cylinder(surface, name, radius, first, second, more=""):
    return (f"fix w all wall/gran/ellipsoid {LAW} surface {surface} primitive type 1 {name}cylinder "
            f"{radius!r} {first!r} {second!r} {more}\n")


def forces(file, frame=-1):
    _, columns = read_dump(file)
    return (vectors(columns, "fx", "fy", "fz")[frame, 0],
            vectors(columns, "tqx", "tqy", "tqz")[frame, 0])


def reduced_radius(at_plane, around, wall):
    """Eq. (19); `around`: radius of curvature around the axis; wall < 0 inside."""
    return at_plane / math.sqrt(max(0.01, 1.0 + around / wall))


def smooth_contacts(body, axis, centre, wall, inside):
    """(normal, overlap, reduced radius, point) of every extreme distance from the axis that touches:
    searched over the angle around the axis, each maximum on its own."""
    r = rotation(body.quaternion)
    a = r @ np.diag(np.square(body.semiaxes)) @ r.T
    to_axis = np.asarray(centre) - body.position
    e = [np.eye(3)[(axis + 1) % 3], np.eye(3)[(axis + 2) % 3]]
    angles = np.linspace(0.0, 2.0 * math.pi, 2001)[:-1]

    def support_excess(angle):  # signed distance beyond the axis of the farthest point along n
        n = np.cos(angle)[..., None] * e[0] + np.sin(angle)[..., None] * e[1]
        return np.sqrt(np.einsum("...i,ij,...j->...", n, a, n)) - n @ to_axis

    sign = 1.0 if inside else -1.0
    found = []
    # s(n) - n.m has its extrema in n where the surface's distance from the axis has them
    values = sign * support_excess(angles)
    for k in range(len(angles)):
        if values[k] <= values[k - 1] or values[k] < values[(k + 1) % len(angles)]:
            continue
        angle, width = angles[k], angles[1]
        while width > 1e-12:
            tries = angle + width * np.linspace(-1.0, 1.0, 21)
            angle = tries[(sign * support_excess(tries)).argmax()]
            width *= 0.3
        n = math.cos(angle) * e[0] + math.sin(angle) * e[1]
        overlap = float(support_excess(np.array(angle))) + (-wall if inside else wall)
        s = math.sqrt(n @ a @ n)
        tangent = np.cross(np.eye(3)[axis], n)
        around = (tangent @ a @ tangent - (n @ a @ tangent) ** 2 / s ** 2) / s
        radius = reduced_radius(np.prod(body.semiaxes) / s ** 2, around, -wall if inside else wall)
        found.append((n, overlap, radius, a @ n / s - 0.5 * overlap * n))
    if not inside:
        found = [min(found, key=lambda c: c[1])]  # convex bodies have one contact
    return [c for c in found if c[1] > 0.0]


def sphere_contacts(body, axis, centre, wall, inside):
    found = []
    for place, radius in zip(*spheres(body, SPHERES)):
        way = place + body.position - centre
        way[axis] = 0.0
        distance = np.linalg.norm(way)
        overlap = radius + (distance - wall if inside else wall - distance)
        if overlap > 0.0:
            n = (1.0 if inside else -1.0) * way / distance
            found.append((n, overlap, reduced_radius(radius, radius, -wall if inside else wall),
                          place + (radius - 0.5 * overlap) * n))
    return found


class Contacts(unittest.TestCase):
    def check(self, surface, body, axis, centre, wall, inside, count):
        find = smooth_contacts if surface == "smooth" else sphere_contacts
        expected = find(body, axis, centre, wall, inside)
        self.assertEqual(len(expected), count)
        others = [centre[(axis + 1) % 3], centre[(axis + 2) % 3]]  # the host's order: y z, z x, x y
        run(head(surface, [body], damping_normal=0.0)
            + cylinder(surface, "xyz"[axis], wall, *others) + dump("c.dump") + "run 0\n")
        force, torque = forces("c.dump")
        single = [-4.0 / 3.0 * MODULUS * math.sqrt(r * h ** 3) * n for n, h, r, _ in expected]
        total, turning = sum(single), sum(np.cross(c[3], f) for c, f in zip(expected, single))
        scale = max(np.linalg.norm(f) for f in single)
        error = max(np.abs(force - total).max() / scale,
                    np.abs(torque - turning).max() / (scale * 5e-3))
        print(f"{surface}, {'xyz'[axis]}cylinder, {'inside' if inside else 'outside'}: {count} "
              f"contacts, relative error {error:.1e}")
        self.assertLess(error, 1e-7)  # a maximum fixes its place to the root of rounding

    def test_both_tips_inside(self):
        for surface in LONG:
            for axis in range(3):
                long_way = np.eye(3)[(axis + 1) % 3] * 0.95 + np.eye(3)[axis] * 0.3122498999199199
                turn = np.cross([1, 0, 0], long_way)
                q = quaternion_of(turn, math.asin(np.linalg.norm(turn))) if turn.any() else (1, 0, 0, 0)
                if axis == 0:  # the two nearly coincide with x: half turn aside
                    q = quaternion_of(turn, math.acos(long_way[0]))
                centre = np.array([1e-3, -2e-3, 3e-3])
                body = Particle((0, 0, 0), LONG[surface], q)
                place = centre + np.eye(3)[axis] * 4e-3 + np.eye(3)[(axis + 1) % 3] * 1e-6
                body.position = tuple(place)
                reach = max(h for _, h, _, _ in (smooth_contacts if surface == "smooth" else
                                                 sphere_contacts)(body, axis, centre, 1e-4, True)) + 1e-4
                self.check(surface, body, axis, centre, reach - 1e-5, True, 2)

    def test_one_side_inside_and_outside(self):
        for surface in LONG:
            find = smooth_contacts if surface == "smooth" else sphere_contacts
            for axis in range(3):
                centre = np.array([2e-3, 1e-3, -1e-3])
                q = quaternion_of((1.0, 2.0, -1.0 + axis), 0.9)
                for inside, wall in (True, 0.02), (False, 0.006):
                    side = np.roll([0.0, 0.8, 0.6], axis)
                    low, high = (0.0, wall) if inside else (wall, wall + 6e-3)
                    for _ in range(60):  # until the overlap is 1e-5
                        middle = 0.5 * (low + high)
                        body = Particle(tuple(centre + middle * side), LONG[surface], q)
                        deep = [h for _, h, _, _ in find(body, axis, centre, wall, inside)]
                        low, high = ((low, middle) if (max(deep, default=0.0) > 1e-5) == inside
                                     else (middle, high))
                    self.check(surface, body, axis, centre, wall, inside, 1)


class TurningWall(unittest.TestCase):
    def test_velocity_of_the_surface(self):
        """`shear` along the axis shifts the wall, across it turns it; here seen by the friction force."""
        rate, wall, damping = 7.0, 0.02, 100.0
        for surface in LONG:
            for axis in range(3):
                half, tall = LONG[surface][0], LONG[surface][1]
                along = np.eye(3)[axis]
                q = [(1, 0, 0, 0), quaternion_of((0, 0, 1), math.pi / 2),
                     quaternion_of((0, 1, 0), -math.pi / 2)][axis]  # long axis along the tube
                outward = rotation(q)[:, 1]
                body = Particle(tuple((wall - tall + 1e-6) * outward), LONG[surface], q)
                for dim, velocity in ((axis, rate * along),
                                      ((axis + 1) % 3, rate * np.cross(along, wall * outward))):
                    run(head(surface, [body], damping_tangential=damping, friction=1e3)
                        + cylinder(surface, "xyz"[axis], wall, 0.0, 0.0, f"shear {'xyz'[dim]} {rate}")
                        + dump("s.dump") + "run 0\n")
                    force, _ = forces("s.dump")
                    tangential = force - (force @ outward) * outward
                    expected = damping * body.mass * velocity
                    self.assertGreater(half, tall)
                    error = np.abs(tangential - expected).max() / np.abs(expected).max()
                    self.assertLess(error, 1e-3, f"{surface} {axis} {dim}")  # contact at R + 5e-7 m


class Sliding(unittest.TestCase):
    def test_tips_keep_their_own_springs(self):
        """A rod across a tube rests on both tips under gravity along the tube: friction carries it."""
        for surface in LONG:
            wall = 4.9995e-3 if surface == "smooth" else 4.9995e-3
            body = Particle((0, 0, 0), LONG[surface])
            script = head(surface, [body], time_step=1e-6, friction=0.5, damping_normal=2e4,
                          damping_tangential=2e4) + "fix g all gravity 9.81 vector 0 0 -1\n"
            script += cylinder(surface, "z", wall, 0.0, 0.0) + "fix motion all nve/ellipsoid\n"
            run(script + dump("r.dump", 1000) + "run 20000\n")
            _, c = read_dump("r.dump")
            print(f"{surface}, held by both tips: fell {-c['z'][-1, 0]:.1e} m, last velocity "
                  f"{c['vz'][-1, 0]:.1e} m/s")
            self.assertLess(abs(c["z"][-1, 0]), 1e-6)  # free fall: 2e-3 m
            self.assertLess(abs(c["vz"][-1, 0]), 1e-6)

    def test_a_wide_cylinder_is_a_plane(self):
        wide = 1e5
        for surface in LONG:
            q = quaternion_of((0.2, 0.1, 1.0), 0.4)
            body = Particle((0, 0.0, 0), LONG[surface], q, (0.2, -0.1, 0.1), (10, 20, -5))
            body.position = (0.0, 3.0e-3, 0.0)
            results = []
            for wall in (cylinder(surface, "z", wide, 0.0, wide),
                         f"fix w all wall/gran/ellipsoid {LAW} surface {surface} primitive type 1 "
                         "yplane 0.0\n"):
                run(head(surface, [body], time_step=1e-6, damping_normal=2e3)
                    + "fix g all gravity 9.81 vector 0 -1 0\n" + wall
                    + "fix motion all nve/ellipsoid\n" + dump("p.dump", 200) + "run 12000\n")
                results.append(read_dump("p.dump")[1])
            self.assertGreater(results[1]["fy"].max(), 0.0)
            difference = np.abs(vectors(results[0], "x", "y", "z")
                                - vectors(results[1], "x", "y", "z")).max()
            print(f"{surface}, wide cylinder: largest difference of places {difference:.1e} m")
            self.assertLess(difference, 1e-7)


if __name__ == "__main__":
    unittest.main(verbosity=2)
