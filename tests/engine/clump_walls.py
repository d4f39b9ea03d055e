"""Clumps, of three kinds and sizes, mixed with chains in boxes that are periodic along x: forces, torques and heat
between them, and at cylinder and mesh walls, against sums over all spheres by brute force.

The bodies are thrown in with overlaps. What the engine wrote of them (positions, quaternions, velocities) and the
lists of spheres are all that the sums take.
"""

import itertools
import math
import unittest
from pathlib import Path
from types import SimpleNamespace

import numpy as np

from _engine import LAW, Setup, dump, read_dump, rotation, run, vectors
from _mesh import quad, write_stl
from _multisphere import chain, contact_force

HOOK = [[0.0, 0.0, 0.0, 1.0], [1.2, 0.0, 0.0, 0.8], [2.0, 0.5, 0.0, 0.6], [2.2, 1.2, 0.3, 0.5], [0.0, 0.0, 0.9, 0.5]]
BALL_OF_FOUR = [[1, 1, 1, 1.8], [1, -1, -1, 1.8], [-1, 1, -1, 1.8], [-1, -1, 1, 1.8]]  # all moments are alike
PLATE = [[0.6 * i, 0.6 * j, 0.0, 0.5] for i in range(5) for j in range(4)]
ROD = (2.4e-3, 1e-3, 5)
KINDS = {1001: HOOK, 1002: BALL_OF_FOUR, 1003: PLATE}
STEP = 1e-9  # what the springs have grown for
LENGTH = 0.012  # of the periodic box
MODULUS, CONDUCTIVITY, HOT = 183e6, 7.0, 450.0
COLUMNS = ("id mass x y z vx vy vz omegax omegay omegaz fx fy fz tqx tqy tqz quat1 quat2 quat3 quat4 shapey "
           "f_spacing").split()


def templates():
    lines, shares = "", ""
    for k, (code, spheres) in enumerate(KINDS.items()):
        Path(f"{code}.csv").write_text("".join(" ".join(map(str, row)) + "\n" for row in spheres))
        seed = (15485863, 32452867, 49979693)[k]
        lines += (f"fix kind{k} all particletemplate/ellipsoid {seed} atom_type 1 density 1340 clump {code}.csv "
                  f"clump_scale 5e-4 write_clump {code}.body vary all uniform 0.8 1.2\n")
        shares += f"kind{k} 0.25 "
    a, b, count = ROD
    lines += (f"fix rod all particletemplate/ellipsoid 67867979 atom_type 1 density 1340 semiaxes {a} {b} {b} "
              f"subspheres {count}\n")
    return lines + f"fix mix all particledistribution/discrete/numberbased 86028157 4 {shares} rod 0.25\n"


class Scene:
    """A script of bodies thrown into a region, walls, and what the engine found."""

    def __init__(self, name, region, count, walls, average=False, ranks=1):
        self.name, self.average = name, average
        word = "multicontact average" if average else ""
        self.setup = Setup(box=(0.0, LENGTH, -0.02, 0.02, -0.02, 0.02), boundary="p f f", time_step=STEP, skin=1e-3,
                           pair=f"gran/ellipsoid {LAW} surface multisphere contacts 64 {word}")
        temperature = f"300+7*id-50*(id>{count // 2})"
        script = self.setup.without_particles() + f"""
neigh_modify page 1000000
fix k all property/global thermalConductivity peratomtype {CONDUCTIVITY}
fix c all property/global thermalCapacity peratomtype 1e6
fix heat all heat/gran/conduction initial_temperature 300 contact_area overlap
{templates()}{walls.replace('AVERAGE', word)}
{region}
fix fill all insert/pack seed 32452843 distributiontemplate mix maxattempt 100 vel uniform 0 0 0 0.5 0.5 0.5 &
    omega constant 30 -80 55 orientation random insert_every once overlapcheck no all_in no region here &
    particles_in_region {count}
run 1
unfix fill
variable t atom {temperature}
set group all property/atom Temp v_t
""" + dump(f"{name}.dump", 1, COLUMNS) + f"""run 0
undump d
run 1
write_dump all custom {name}.heat {' '.join(COLUMNS)} f_Temp f_heatFlux modify sort id format &
    "{' '.join(['%.17g'] * (len(COLUMNS) + 2))}"
"""
        run(script, ranks, name=f"in.{name}")
        self.bodies = self.read(f"{name}.dump", -1)
        self.warm = self.read(f"{name}.heat", -1)

    def read(self, file, frame):
        _, c = read_dump(file)
        bodies = []
        for i in range(c["id"].shape[1]):
            one = {name: values[frame, i] for name, values in c.items()}
            get = lambda *names: np.array([one[n] for n in names])
            turn = rotation([one[f"quat{k}"] for k in (1, 2, 3, 4)])
            centres, radii = self.spheres(int(one["f_spacing"]), one["shapey"])
            bodies.append(SimpleNamespace(
                position=get("x", "y", "z"), velocity=get("vx", "vy", "vz"), omega=get("omegax", "omegay", "omegaz"),
                mass=one["mass"], centres=centres @ turn.T, radii=radii, force=get("fx", "fy", "fz"),
                torque=get("tqx", "tqy", "tqz"), temperature=one.get("f_Temp"), flux=one.get("f_heatFlux"),
                kind=int(one["f_spacing"])))
        return bodies

    @staticmethod
    def spheres(code, size):
        if code in KINDS:
            body = np.loadtxt(f"{code}.body", delimiter=",", skiprows=3)
            scale = size / (np.abs(body[:, 1]) + body[:, 3]).max()
            return scale * body[:, :3], scale * body[:, 3]
        x, radii = chain(*ROD)
        return np.outer(x, (1.0, 0.0, 0.0)), radii

    def pairs(self, bodies):
        """(i, j, contacts of spheres) over the three images along x; j has been moved there."""
        for i, j in itertools.combinations(range(len(bodies)), 2):
            for shift in (-LENGTH, 0.0, LENGTH):
                first = bodies[i]
                second = SimpleNamespace(**{**vars(bodies[j]), "position": bodies[j].position + (shift, 0, 0)})
                between = second.position - first.position
                way = between + second.centres[None] - first.centres[:, None]
                length = np.linalg.norm(way, axis=2)
                contacts = []
                for k, m in np.argwhere(length < first.radii[:, None] + second.radii):
                    n, r, s = way[k, m] / length[k, m], first.radii[k], second.radii[m]
                    h = r + s - length[k, m]
                    contacts.append((n, h, r * s / (r + s), first.centres[k] + (r - 0.5 * h) * n))
                if contacts:
                    yield i, j, second, contacts

    def expected(self, bodies, wall_contacts, hot_walls):
        """Forces, torques (N, 3), heat (N,) and contacts with walls (N,)."""
        force, torque = np.zeros((len(bodies), 3)), np.zeros((len(bodies), 3))
        heat, touches = np.zeros(len(bodies)), np.zeros(len(bodies), int)
        for i, j, second, contacts in self.pairs(bodies):
            weight = 1.0 / len(contacts) if self.average else 1.0
            for contact in contacts:
                f = weight * contact_force(contact, bodies[i], second, self.setup, STEP)
                force[i] += f
                force[j] -= f
                torque[i] += np.cross(contact[3], f)
                torque[j] -= np.cross(contact[3] + bodies[i].position - second.position, f)
                if bodies[i].temperature is not None:
                    flux = weight * self.conductance(2.0 * math.pi * contact[2] * contact[1]) * (
                        second.temperature - bodies[i].temperature)
                    heat[i] += flux
                    heat[j] -= flux
        for i, body in enumerate(bodies):
            contacts = wall_contacts(body)
            weight = 1.0 / len(contacts) if self.average and contacts else 1.0
            touches[i] = len(contacts)
            for contact in contacts:
                f = weight * contact_force(contact, body, None, self.setup, STEP)
                force[i] += f
                torque[i] += np.cross(contact[3], f)
                if body.temperature is not None and hot_walls:
                    # a sphere that is beyond the wall has no section with it
                    area = math.pi * max(0.0, 2.0 * contact[2] - contact[1]) * contact[1]
                    heat[i] += weight * self.conductance(area) * (HOT - body.temperature)
        return force, torque, heat, touches

    @staticmethod
    def conductance(area):
        return 2.0 * CONDUCTIVITY * math.sqrt(area)


def inside(body):
    """Not beyond an end of a mesh."""
    x = body.position[0] + body.centres[:, 0]
    return (x - body.radii).min() > 0.0 and (x + body.radii).max() < LENGTH


def in_cylinder(wall, inside, at=(0.0, 0.0)):
    """Contacts with a cylinder along x: normal into the wall, overlap, reduced radius, point."""
    def contacts(body):
        found = []
        for place, radius in zip(body.centres, body.radii):
            way = (body.position + place) * (0.0, 1.0, 1.0) - (0.0, *at)
            distance = np.linalg.norm(way)
            overlap = radius + (distance - wall if inside else wall - distance)
            if overlap > 0.0:
                n = (1.0 if inside else -1.0) * way / distance
                flat = radius / math.sqrt(max(0.01, 1.0 - radius / wall if inside else 1.0 + radius / wall))
                found.append((n, overlap, flat, place + (radius - 0.5 * overlap) * n))
        return found
    return contacts


def faces(planes):
    """Contacts with half planes (normal into the wall, way from the edge at the origin), where the foot is on them."""
    def contacts(body):
        found = []
        for normal, along in planes:
            for place, radius in zip(body.centres, body.radii):
                overlap = radius + (body.position + place) @ normal
                if overlap > 0.0 and (body.position + place) @ along > 0.0:
                    found.append((normal, overlap, radius, place + (radius - 0.5 * overlap) * normal))
        return found
    return contacts


def ridge(triangles):
    """Contacts with a convex mesh: the one nearest point of each sphere whose centre is in front of it."""
    def nearest(p, t):
        best = None
        n = np.cross(t[1] - t[0], t[2] - t[0])
        foot = p - ((p - t[0]) @ n) / (n @ n) * n
        if all(np.cross(t[(k + 1) % 3] - t[k], foot - t[k]) @ n >= 0.0 for k in range(3)):
            return foot
        for k in range(3):
            a, b = t[k], t[(k + 1) % 3]
            q = a + np.clip((p - a) @ (b - a) / ((b - a) @ (b - a)), 0.0, 1.0) * (b - a)
            if best is None or np.linalg.norm(q - p) < np.linalg.norm(best - p):
                best = q
        return best

    def contacts(body):
        found = []
        for place, radius in zip(body.centres, body.radii):
            p = body.position + place
            way = min((nearest(p, t) - p for t in triangles), key=np.linalg.norm)
            distance = np.linalg.norm(way)
            if distance < radius:
                n, h = way / distance, radius - distance
                found.append((n, h, radius, place + (radius - 0.5 * h) * n))
        return found
    return contacts


class Walls(unittest.TestCase):
    def check(self, scene, wall_contacts, chosen=lambda body: True, hot_walls=True):
        keep = np.array([chosen(body) for body in scene.bodies])
        force, torque, _, touches = scene.expected(scene.bodies, wall_contacts, hot_walls)
        found = np.array([b.force for b in scene.bodies]), np.array([b.torque for b in scene.bodies])
        size = np.abs(force[keep]).max()
        off = max(np.abs(found[0] - force)[keep].max() / size, np.abs(found[1] - torque)[keep].max() / (1e-3 * size))
        _, _, heat, _ = scene.expected(scene.warm, wall_contacts, hot_walls)
        flux = np.array([b.flux for b in scene.warm])
        warm = np.abs(flux - heat)[keep].max() / np.abs(heat[keep]).max()
        kinds = {b.kind for b, k in zip(scene.bodies, keep) if k}
        print(f"{scene.name}: {keep.sum()} bodies of {len(kinds)} kinds, {touches[keep].sum()} contacts with walls; "
              f"forces off by {off:.1e}, heat by {warm:.1e}")
        self.assertEqual(kinds, {0, *KINDS})
        self.assertLess(off, 1e-8)
        self.assertLess(warm, 1e-8)
        self.assertGreater(touches[keep].sum(), 15)
        self.assertGreater(touches[keep].max(), 2)

    def cylinder(self, radius, at=(0.0, 0.0)):
        return (f"fix w all wall/gran/ellipsoid {LAW} surface multisphere primitive type 1 xcylinder {radius!r} "
                f"{at[0]!r} {at[1]!r} temperature {HOT} contacts 64 AVERAGE\n")

    def test_inside_a_cylinder(self):
        region = "region here cylinder x 0 0 0.0058 0 0.012 units box"
        for average in (False, True):
            for ranks in (1, 2):
                scene = Scene(f"inside_{average}_{ranks}", region, 60, self.cylinder(0.006), average, ranks)
                self.check(scene, in_cylinder(0.006, True))

    def test_outside_a_cylinder(self):
        region = "region here cylinder x 0.001 0.002 0.006 0 0.012 units box"
        scene = Scene("outside", region, 60, self.cylinder(0.003, (0.001, 0.002)))
        away = lambda body: np.linalg.norm(body.position[1:] - (0.001, 0.002)) > 0.003
        self.check(scene, in_cylinder(0.003, False, (0.001, 0.002)), away)

    def test_in_the_groove_of_a_mesh(self):
        """Two planes of many triangles that meet in a groove; seams are no contacts. Spheres may be beyond them."""
        ticks, across = np.linspace(0.0, LENGTH, 9), np.linspace(0.0, 0.015, 9)
        slope = np.array([0.0, math.cos(0.9), math.sin(0.9)])
        triangles = []
        for x0, x1 in zip(ticks, ticks[1:]):
            for s0, s1 in zip(across, across[1:]):
                triangles.append(quad((x0, s0, 0), (x1, s0, 0), (x1, s1, 0), (x0, s1, 0)))
                a, b = -s0 * slope * (-1, 1, -1), -s1 * slope * (-1, 1, -1)
                triangles.append(quad((x0, *a[1:]), (x0, *b[1:]), (x1, *b[1:]), (x1, *a[1:])))
        write_stl("groove.stl", np.concatenate(triangles))
        wall = (f"fix cad all mesh/surface file groove.stl type 1 temperature {HOT}\n"
                f"fix w all wall/gran/ellipsoid {LAW} surface multisphere mesh n_meshes 1 meshes cad contacts 64 AVERAGE\n")
        down, aside = np.array([0.0, 0.0, -1.0]), np.array([0.0, -math.sin(0.9), -math.cos(0.9)])
        region = "region here block 0 0.012 0 0.003 0.0004 0.0016 units box"
        planes = [(down, np.array([0.0, 1.0, 0.0])), (aside, slope * (-1, -1, 1))]

        def in_front(body):
            """The body's centre, and in the groove those of its spheres: they may be beyond one plane alone."""
            places = body.position + body.centres
            return inside(body) and all(
                body.position @ n < -3e-4 and not np.any((places @ n > 0.0) & (places @ along < 2.0 * body.radii))
                for n, along in planes)

        for average in (False, True):
            scene = Scene(f"groove_{average}", region, 60, wall, average)
            self.check(scene, faces(planes), in_front)

    def test_on_the_ridge_of_a_mesh(self):
        """A roof: along the ridge a sphere touches an edge once."""
        triangles = np.concatenate([
            quad((0, 0, 0), (LENGTH, 0, 0), (LENGTH, -0.008, -0.006), (0, -0.008, -0.006)),
            quad((0, 0, 0), (0, 0.008, -0.004), (LENGTH, 0.008, -0.004), (LENGTH, 0, 0))])
        write_stl("roof.stl", triangles)
        wall = (f"fix cad all mesh/surface file roof.stl type 1 temperature {HOT}\n"
                f"fix w all wall/gran/ellipsoid {LAW} surface multisphere mesh n_meshes 1 meshes cad contacts 64 AVERAGE\n")
        region = "region here block 0 0.012 -0.0006 0.0006 0.0004 0.0014 units box"
        normals = [np.array([0.0, -0.6, 0.8]), np.array([0.0, 1.0, 2.0]) / math.sqrt(5.0)]
        in_front = lambda body: inside(body) and all(max((body.position + place) @ n for n in normals) > 1e-5
                                    for place in [np.zeros(3), *body.centres])
        scene = Scene("ridge", region, 60, wall)
        edges = 0
        for body in filter(in_front, scene.bodies):
            for n, *_ in ridge(triangles)(body):
                edges += all(abs(abs(n @ m) - 1.0) > 1e-6 for m in normals)
        self.assertGreater(edges, 5)
        self.check(scene, ridge(triangles), in_front)


if __name__ == "__main__":
    unittest.main(verbosity=2)
