"""compute continuum/weighted/ellipsoid against the sums of its definition, one by one in numpy: all particles and all
images, all contacts of all spheres and of walls, integrals along lines by Gauss's rule, the gradient of the mean velocity
by differences. Forces are those of overlapping spheres by Hertz's law, or of the engine's lists while bodies move."""
import itertools
import math
import unittest
from pathlib import Path

import numpy as np

from _brute_force import sphere_chain, turn
from _engine import LAW, Particle, Setup, quaternion_of, run, thermo

NODES, WEIGHTS = np.polynomial.legendre.leggauss(24)
LISTED = 17
AXES = (0, 1, 2)


def kernel(kind, radius):
    """phi(r) of distances (...,), its integral over space being 1 by Gauss's rule."""
    def shape(r):
        q = r / radius
        inside = {"Top_Hat": 1.0 + 0.0 * q, "Gaussian": np.exp(-9.0 * q ** 2),
                  "Wendland": np.maximum(0.0, 1.0 - q) ** 4 * (1.0 + 4.0 * q)}[kind]
        return np.where(q < 1.0, inside, 0.0)

    r = 0.5 * radius * (NODES + 1.0)
    total = 0.5 * radius * WEIGHTS @ (shape(r) * r ** 2)
    return lambda distance: shape(distance) / (4.0 * math.pi * total)


def line_mean(phi, radius, to_begin, way):
    """Mean of phi over a way whose first point is at `to_begin` (N, 3) from the middle; parts beyond the reach are left
    out, the others are cut where they are nearest to it."""
    length = np.linalg.norm(way)
    foot = -to_begin @ way / length ** 2
    squared = (to_begin ** 2).sum(1) - (foot * length) ** 2
    half = np.sqrt(np.maximum(0.0, radius ** 2 - squared)) / length
    found = np.zeros(len(to_begin))
    for low, high in ((foot - half, foot), (foot, foot + half)):
        low, high = np.clip(low, 0.0, 1.0), np.clip(high, 0.0, 1.0)
        for node, weight in zip(NODES, WEIGHTS):
            s = 0.5 * (low + high) + 0.5 * node * (high - low)
            found += 0.5 * weight * (high - low) * phi(np.linalg.norm(to_begin + s[:, None] * way, axis=1))
    return np.where(squared < radius ** 2, found, 0.0)


class Sums:
    """Of the definition, at places; `cell`: rows are the edges, `periodic` three times yes or no."""

    def __init__(self, kind, radius, cell, periodic):
        self.phi, self.radius, self.cell = kernel(kind, radius), radius, np.array(cell, float)
        heights = [abs(np.linalg.det(self.cell)) / np.linalg.norm(np.cross(self.cell[k - 2], self.cell[k - 1]))
                   for k in AXES]
        most = [math.ceil((radius + 0.02) / h) + 1 if p else 0 for h, p in zip(heights, periodic)]
        self.images = np.array(list(itertools.product(*[range(-m, m + 1) for m in most]))) @ self.cell

    def masses(self, places, x, v, m):
        """rho (P,), V (P, 3), sum m (v - V)(v - V) phi (P, 3, 3)."""
        rho, mean, motion = [], [], []
        for place in places:
            weight = m[:, None] * self.phi(np.linalg.norm(place - x[:, None] - self.images[None], axis=2))
            weight = weight.sum(1)
            rho.append(weight.sum())
            mean.append(weight @ v / rho[-1])
            off = v - mean[-1]
            motion.append(np.einsum("n,na,nb->ab", weight, off, off))
        return np.array(rho), np.array(mean), np.array(motion)

    def lines(self, places, lines):
        """(P, 3, 3) of [(begin, end, force on the body at begin)]."""
        total = np.zeros((len(places), 3, 3))
        for begin, end, force in lines:
            for p, place in enumerate(places):
                mean = line_mean(self.phi, self.radius, begin + self.images - place, end - begin).sum()
                total[p] -= np.outer(force, begin - end) * mean
        return total

    def strain(self, places, x, v, m, time_step):
        step = 1e-5 * self.radius
        gradient = np.zeros((len(places), 3, 3))
        for b in AXES:
            shift = step * np.eye(3)[b]
            ahead, behind = (self.masses(places + s, x, v, m)[1] for s in (shift, -shift))
            gradient[:, :, b] = (ahead - behind) / (2.0 * step)
        return 0.5 * time_step * (gradient + gradient.transpose(0, 2, 1))


def frame(file, columns):
    lines = Path(file).read_text().splitlines()
    starts = [k for k, line in enumerate(lines) if line.startswith("ITEM: TIMESTEP")]
    at, count = starts[-1], int(lines[starts[-1] + 3])
    rows = [line.split() for line in lines[at + 9:at + 9 + count]]
    return np.array(rows, float).reshape(count, columns)


def output(tensors):
    columns = ["id", "mass", "x", "y", "z", "vx", "vy", "vz"] + [f"c_{t}[{k}]" for t in tensors for k in range(1, 10)]
    return (f"dump d all custom 20 state.dump {' '.join(columns)}\n"
            f"dump_modify d sort id format \"%d{' %.17g' * (len(columns) - 1)}\"\n")


LISTS = ("compute c all pair/ellipsoid/local pos force\n"
         f"dump l all local 20 pairs.local {' '.join(f'c_c[{k}]' for k in range(1, 10))}\n"
         f"dump_modify l format \"{' '.join(['%.17g'] * 9)}\"\n")
WALL_LISTS = ("compute w all wall/ellipsoid/local pos contactPoint force\n"
              f"dump w all local 20 walls.local {' '.join(f'c_w[{k}]' for k in range(1, 10))}\n"
              f"dump_modify w format \"{' '.join(['%.17g'] * 9)}\"\n")


def moving_bodies(random, counts, spacing, turned, speed=0.3):
    bodies = []
    for cell in itertools.product(*[range(n) for n in counts]):
        axes = (1.6e-3, 1.0e-3, 1.0e-3) if turned else tuple(1e-3 * random.uniform(0.8, 1.5, 3))
        q = random.normal(size=4)
        bodies.append(Particle(tuple(spacing * (np.array(cell) + 0.5 + random.uniform(-0.1, 0.1, 3))), axes,
                               tuple(q / np.linalg.norm(q)), tuple(random.uniform(-speed, speed, 3)),
                               tuple(random.uniform(-50, 50, 3))))
    return bodies


class AtRest(unittest.TestCase):
    """Forces by the overlaps of the spheres alone."""

    def test_all_contacts_of_a_pair_of_seventeen_spheres_count(self):
        a, b = 2.7e-3, 1.15e-3
        bodies = [Particle((0.0, y, 0.0), (a, b, b), quaternion_of((0, 0, 1), turned))
                  for y, turned in ((-1.12e-3, 0.01), (1.12e-3, 0.0))]
        setup = Setup(pair=f"gran/ellipsoid {LAW} surface multisphere contacts 40", friction=0.0)
        script = setup.with_particles(bodies) + (
            f"fix s all property/atom subspheres scalar yes yes no {LISTED}\n"
            "fix p all property/atom spacing scalar yes yes no 0\nfix motion all nve/ellipsoid\nneigh_modify page 2000000\n"
            "compute t all continuum/weighted/ellipsoid kernel_radius 0.02 compute stress\n"
            + output(["t"]) + "run 0\n")
        run(script)
        along, radii = sphere_chain(a, b, LISTED)
        modulus, ratio = setup.materials[0].youngs_modulus, setup.materials[0].poissons_ratio
        centres = [np.array(p.position) + np.outer(along, turn(np.array(p.quaternion))[:, 0]) for p in bodies]
        way = centres[0][:, None] - centres[1][None]
        length = np.linalg.norm(way, axis=2)
        h = radii[:, None] + radii[None] - length
        touching = h > 0.0
        reduced = radii[:, None] * radii[None] / (radii[:, None] + radii[None])
        size = np.where(touching, 4.0 / 3.0 * modulus / (2 * (1 - ratio ** 2)) * np.sqrt(
            reduced * np.where(touching, h, 0.0) ** 3), 0.0)
        force = (size[..., None] * way / length[..., None]).sum((0, 1))  # on the first
        self.assertGreater(touching.sum(), 6)
        branch = np.array(bodies[0].position) - np.array(bodies[1].position)
        expected = -np.outer(force, branch) / (4.0 / 3.0 * math.pi * 0.02 ** 3)  # all within the ball
        for row in frame("state.dump", 17):
            self.assertLess(np.abs(row[8:].reshape(3, 3) - expected).max(), 1e-9 * np.abs(expected).max())


    def test_a_box_shorter_than_a_body(self):
        """Contacts with images of itself; far averages are the virial."""
        length = 2.9e-3
        bodies = [Particle((0.5e-3, 0.6e-3, 0.7e-3), (2e-3, 1.5e-3, 1e-3), quaternion_of((1, 2, 3), 0.7)),
                  Particle((1.9e-3, 2.1e-3, 2.4e-3), (1e-3, 1.2e-3, 0.9e-3), quaternion_of((1, -2, 3), 0.4))]
        setup = Setup(box=(0.0, length, 0.0, length, 0.0, 1.2 * length), boundary="p p p", skin=2e-4)
        for ranks in (1, 2):
            run(setup.with_particles(bodies) + "fix motion all nve/ellipsoid\ncompute p all pressure thermo_temp virial\n"
                "compute t all continuum/weighted/ellipsoid kernel_radius 0.02 kernel_type Wendland compute stress\n"
                "compute mean all reduce ave c_t[1] c_t[5] c_t[9] c_t[4] c_t[7] c_t[8]\n"
                f"thermo_style custom step {' '.join(f'c_{c}[{k}]' for c in ('p', 'mean') for k in range(1, 7))}\n"
                "thermo_modify norm no format float %.15g\nrun 0\n", ranks)
            row = thermo("log.in.run", 13)[-1][1:]
            self.assertLess(np.abs(row[:6] + row[6:]).max(), 1e-4 * np.abs(row[:6]).max())


class InMotion(unittest.TestCase):
    def compare(self, sums, tensors, walls, time_step):
        rows = frame("state.dump", 8 + 9 * len(tensors))
        m, x, v = rows[:, 1], rows[:, 2:5], rows[:, 5:8]
        pairs = frame("pairs.local", 9)
        lines = [(r[:3], r[3:6], r[6:]) for r in pairs]
        if walls:
            at_walls = frame("walls.local", 9)
            self.assertGreater(len(at_walls), 0)
            lines += [(r[:3], r[3:6], r[6:]) for r in at_walls]
        self.assertGreater(len(pairs), 10)
        expected = {"stress": sums.lines(x, lines) - sums.masses(x, x, v, m)[2]}
        if "strain" in tensors:
            expected["strain"] = sums.strain(x, x, v, m, time_step)
        for k, name in enumerate(tensors):
            found = rows[:, 8 + 9 * k:17 + 9 * k].reshape(-1, 3, 3)
            error = np.abs(found - expected[name]).max() / np.abs(expected[name]).max()
            self.assertLess(error, {"stress": 2e-8, "strain": 1e-6}[name], name)

    def scene(self, kind, radius, ranks, counts=(4, 3, 3), periodic="ppp", tilt=None, multisphere=False, floor=False):
        random = np.random.default_rng(len(kind) + ranks)
        spacing = 2.05e-3
        lengths = spacing * np.array(counts)
        box = tuple(v for k, n in enumerate(lengths) for v in
                    ((0.0, float(n)) if periodic[k] == "p" else (-3e-3, float(n) + 3e-3)))
        surface = "multisphere contacts 40" if multisphere else "smooth"
        setup = Setup(box=box, boundary=" ".join(periodic), skin=3e-4, pair=f"gran/ellipsoid {LAW} surface {surface}")
        script = setup.with_particles(moving_bodies(random, counts, spacing, multisphere))
        cell = np.diag(lengths)
        if tilt:
            text = Path("particles.data").read_text()
            Path("particles.data").write_text(text.replace("zlo zhi\n", "zlo zhi\n" + "{} {} {} xy xz yz\n".format(*tilt)))
            cell[1, 0], cell[2, 0], cell[2, 1] = tilt
        if multisphere:
            script += ("fix s all property/atom subspheres scalar yes yes no 5\n"
                       "fix p all property/atom spacing scalar yes yes no 0\nneigh_modify page 2000000\n")
        if floor:
            script += (f"fix floor all wall/gran/ellipsoid {LAW} surface {surface.split()[0]} primitive type 1 "
                       "zplane 0.2e-3" + (" contacts 40\n" if multisphere else "\n"))
        has_strain = kind != "Top_Hat"
        tensors = ["stress", "strain"] if has_strain else ["stress"]
        for name in tensors:
            script += f"compute {name} all continuum/weighted/ellipsoid kernel_radius {radius} kernel_type {kind} compute {name}\n"
        script += ("fix motion all nve/ellipsoid\n" + output(tensors) + LISTS + (WALL_LISTS if floor else "")
                   + "run 20\n")
        run(script, ranks)
        self.compare(Sums(kind, radius, cell, [p == "p" for p in periodic]), tensors, floor, setup.time_step)

    def test_top_hat_in_a_periodic_box(self):
        self.scene("Top_Hat", 3.1e-3, 1)

    def test_wendland_wider_than_a_tilted_box_on_four_ranks(self):
        self.scene("Wendland", 6e-3, 4, counts=(3, 2, 2), tilt=(2.0e-3, -1.1e-3, 0.9e-3))

    def test_gaussian_over_a_floor_on_two_ranks(self):
        self.scene("Gaussian", 5e-3, 2, counts=(3, 3, 2), periodic="fpf", floor=True)

    def test_bodies_of_five_spheres_over_a_floor(self):
        self.scene("Wendland", 4e-3, 2, counts=(3, 3, 2), periodic="ppf", multisphere=True, floor=True)

    def test_a_reach_shorter_than_a_body(self):
        self.scene("Top_Hat", 0.4e-3, 2, periodic="pfp")

    def test_both_tensors_in_one_and_a_group(self):
        random = np.random.default_rng(5)
        bodies = moving_bodies(random, (3, 3, 3), 2.05e-3, False)
        setup = Setup(box=(0.0, 6.15e-3) * 3, boundary="p p p", skin=3e-4)
        both = "continuum/weighted/ellipsoid kernel_radius 4e-3 kernel_type Wendland compute"
        run(setup.with_particles(bodies) + "group some id <> 3 20\n"
            f"compute stress some {both} stress\ncompute strain some {both} strain\ncompute both some {both} stress_strain\n"
            "fix motion all nve/ellipsoid\n"
            + output(["stress", "strain", "both"]).replace(" c_both[9]", " " + " ".join(f"c_both[{k}]" for k in range(9, 19)))
            .replace("%.17g\"", "%.17g" + " %.17g" * 9 + "\"")
            + LISTS.replace("all pair", "some pair") + "run 20\n")
        rows = frame("state.dump", 44)
        inside = (rows[:, 0] >= 3) & (rows[:, 0] <= 20)
        self.assertTrue((rows[:, 8:26] == rows[:, 26:]).all())
        self.assertFalse(rows[~inside, 8:].any())
        x, v, m = rows[inside, 2:5], rows[inside, 5:8], rows[inside, 1]
        sums = Sums("Wendland", 4e-3, np.diag([6.15e-3] * 3), (True,) * 3)
        expected = sums.lines(x, [(r[:3], r[3:6], r[6:]) for r in frame("pairs.local", 9)]) - sums.masses(x, x, v, m)[2]
        self.assertLess(np.abs(rows[inside, 8:17].reshape(-1, 3, 3) - expected).max(), 2e-8 * np.abs(expected).max())

    def test_images_of_a_sheared_box_are_faster(self):
        random = np.random.default_rng(6)
        bodies = moving_bodies(random, (3, 3, 3), 2.05e-3, False)
        setup = Setup(box=(0.0, 6.15e-3) * 3, boundary="p p p", skin=3e-4)
        script = setup.with_particles(bodies)
        text = Path("particles.data").read_text()
        Path("particles.data").write_text(text.replace("zlo zhi\n", "zlo zhi\n0 0 0 xy xz yz\n"))
        run(script + "compute strain all continuum/weighted/ellipsoid kernel_radius 4e-3 kernel_type Wendland compute strain\n"
            "fix shear all deform 1 xy erate 50 remap v\nfix motion all nve/ellipsoid\n" + output(["strain"]) + "run 20\n")
        rows = frame("state.dump", 17)
        x, v, m = rows[:, 2:5], rows[:, 5:8], rows[:, 1]
        length, rate = 6.15e-3, 50.0
        cell = length * np.array([[1, 0, 0], [rate * 20 * setup.time_step, 1, 0], [0, 0, 1]])
        near = np.array(list(itertools.product((-1, 0, 1), repeat=3)))
        everyone = (x[None] + (near @ cell)[:, None]).reshape(-1, 3)
        speeds = (v[None] + np.outer(near[:, 1], (rate * length, 0, 0))[:, None]).reshape(-1, 3)
        sums = Sums("Wendland", 4e-3, cell, (False,) * 3)
        expected = sums.strain(x, everyone, speeds, np.tile(m, len(near)), setup.time_step)
        found = rows[:, 8:].reshape(-1, 3, 3)
        self.assertLess(np.abs(found - expected).max(), 1e-6 * np.abs(expected).max())


class Refused(unittest.TestCase):
    def test_each_mistake_stops_in_a_line(self):
        cases = {"kernel_radius 0 compute stress": "kernel_radius",
                 "compute stress": "has no kernel_radius", "kernel_radius 0.01": "does not say what to compute",
                 "kernel_radius 0.01 compute strain": "gives no strain", "kernel_radius 0.01 compute heat": "compute",
                 "kernel_radius 0.01 compute stress kernel_type Lucy": "kernel_type",
                 "kernel_radius 0.01 compute stress radius 2": "unknown keyword 'radius'"}
        script = Setup().with_particles([Particle((0, 0, 0), (2e-3, 1e-3, 1e-3))])
        for words, message in cases.items():
            outcome = run(f"{script}compute t all continuum/weighted/ellipsoid {words}\n", check=False)
            self.assertNotEqual(outcome.code, 0, words)
            self.assertIn(message, outcome.text)

    def test_the_hosts_fix_names_this_compute(self):
        script = Setup().with_particles([Particle((0, 0, 0), (2e-3, 1e-3, 1e-3))])
        outcome = run(script + "fix t all continuum/weighted kernel_radius 0.01 compute stress\n", check=False)
        self.assertNotEqual(outcome.code, 0)
        self.assertIn("use 'compute ID GROUP continuum/weighted/ellipsoid' with the same keywords", outcome.text)


if __name__ == "__main__":
    unittest.main(verbosity=2)
