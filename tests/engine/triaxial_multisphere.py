"""Multi-spheres of any three semi-axes, spacings medial and minimax_volume, in the engine. Inscribed spheres
touch only where the smooth ellipsoids overlap (decided here by the function of Perram and Wertheim), and they do
touch where ellipsoids of 0.8 times the size overlap; at walls alike. Restart files, ranks, random shapes."""

import unittest

import numpy as np

from _engine import COLUMNS, Particle, Setup, dump, read_dump, rotation, run, vectors
from _multisphere import multisphere_setup, wall

AXES = (2.0e-3, 3.0e-3, 1.2e-3)  # the longest is not the first
COUNT, SHRUNK, PAIRS = 45, 0.8, 200
TEMPLATE = ("fix grain all particletemplate/ellipsoid 15485863 atom_type 1 density 1340 "
            f"semiaxes {AXES[0]} {AXES[1]} {AXES[2]} ")
ALL = COLUMNS + ["f_subspheres", "f_spacing"]
PAGE = "neigh_modify page 1000000\n"
LARGE_PAGE = "neigh_modify page 1000000 one 300\n"


def properties(count, spacing):
    return (f"fix subspheres all property/atom subspheres scalar yes yes no {count}\n"
            f"fix spacing all property/atom spacing scalar yes yes no {spacing}\n")


def square(q, factor):
    """R diag(s^2) R^T of the ellipsoid with the semi-axes times a factor (m^2)."""
    r = rotation(q)
    return r @ np.diag((factor * np.array(AXES)) ** 2) @ r.T


def overlap(q_i, q_j, distance, factor):
    """Perram and Wertheim 1985: apart where the largest of t (1 - t) d.((1 - t) A + t B)^-1.d is above 1."""
    a, b = square(q_i, factor), square(q_j, factor)
    values = [t * (1.0 - t) * distance @ np.linalg.solve((1.0 - t) * a + t * b, distance)
              for t in np.linspace(0.001, 0.999, 400)]
    return max(values) < 1.0


class Contacts(unittest.TestCase):
    def check_pairs(self, spacing):
        random = np.random.default_rng(spacing)
        side, bodies = 0.016, []
        for k in range(PAIRS):
            place = side * (np.array([k % 6, k // 6 % 6, k // 36]) + 0.5)
            turns = random.normal(size=(2, 4))
            turns /= np.linalg.norm(turns, axis=1, keepdims=True)
            deep = True
            while deep:  # so deep that half of all spheres would touch
                way = random.normal(size=3)
                way *= random.uniform(2.4e-3, 5e-3) / np.linalg.norm(way)
                deep = overlap(*turns, way, 0.75)
            bodies += [Particle(tuple(place - 0.5 * way), AXES, tuple(turns[0])),
                       Particle(tuple(place + 0.5 * way), AXES, tuple(turns[1]))]
        setup = Setup(box=(0.0, 6 * side) * 3, pair=multisphere_setup("contacts 200").pair)
        run(setup.with_particles(bodies) + LARGE_PAGE + properties(COUNT, spacing) + dump("pairs.dump", 1, ALL)
            + "run 0\n")
        _, columns = read_dump("pairs.dump")
        force = np.linalg.norm(vectors(columns, "fx", "fy", "fz")[0], axis=1)
        touching, inside, deep = 0, 0, 0
        for k in range(PAIRS):
            i, j = bodies[2 * k], bodies[2 * k + 1]
            distance = np.subtract(j.position, i.position)
            smooth = overlap(i.quaternion, j.quaternion, distance, 1.0)
            shrunk = overlap(i.quaternion, j.quaternion, distance, SHRUNK)
            found = force[2 * k] > 0.0
            touching, inside, deep = touching + found, inside + smooth, deep + shrunk
            if spacing == 4:
                self.assertTrue(smooth or not found, f"pair {k} touches outside of its ellipsoids")
            self.assertTrue(found or not shrunk, f"pair {k} does not touch")
        print(f"spacing {spacing}: {touching} of {PAIRS} pairs touch, {inside} pairs of ellipsoids overlap, {deep} of "
              f"{SHRUNK} times the size")
        self.assertTrue(PAIRS // 5 < touching < 4 * PAIRS // 5)

    def test_medial(self):
        self.check_pairs(4)

    def test_minimax_volume(self):
        self.check_pairs(5)

    def test_plane(self):
        random = np.random.default_rng(8)
        bodies = []
        for k in range(PAIRS):
            q = random.normal(size=4)
            q /= np.linalg.norm(q)
            place = 0.008 * np.array([k % 15 + 0.5, k // 15 + 0.5, 0.0])
            bodies.append(Particle((place[0], place[1], random.uniform(0.8e-3, 3.2e-3)), AXES, tuple(q)))
        setup = Setup(box=(0.0, 0.12) * 3, pair=multisphere_setup("contacts 50").pair)
        run(setup.with_particles(bodies) + PAGE + properties(COUNT, 4)
            + wall("floor", "zplane", 0.0, "contacts 50") + dump("plane.dump", 1, ALL) + "run 0\n")
        force = read_dump("plane.dump")[1]["fz"][0]
        reach = np.array([np.sqrt(square(b.quaternion, 1.0)[2, 2]) for b in bodies])
        height = np.array([b.position[2] for b in bodies])
        self.assertGreater((force > 0.0).sum(), PAIRS // 5)
        self.assertTrue((height[force > 0.0] < reach[force > 0.0]).all())
        self.assertTrue((force[height < SHRUNK * reach] > 0.0).all())


class InARun(unittest.TestCase):
    INSERT = """
fix mix all particledistribution/discrete 15485867 1 grain 1.0
region all block 0 0.04 0 0.04 0 0.04 units box
fix fill all insert/pack seed 32452843 distributiontemplate mix vel uniform 0 0 0 4 4 4 orientation random &
    insert_every once overlapcheck yes all_in yes region all particles_in_region 120
run 1
unfix fill
"""

    def test_restart_and_ranks(self):
        """A restart goes on bit for bit; two ranks agree to rounding."""
        setup = Setup(box=(0.0, 0.04) * 3, boundary="p p p", time_step=2e-6, skin=0.001,
                      pair=multisphere_setup("contacts 50").pair)
        template = TEMPLATE + f"subspheres {COUNT} spacing medial\n"
        motion = "fix motion all nve/ellipsoid\n"
        last = motion + "run 300\n" + dump("end.dump", 1, ALL) + "run 0\n"
        run(setup.without_particles() + PAGE + template + self.INSERT + motion
            + "run 300\nwrite_restart half\nwrite_data half.data\nrun 300\n" + dump("whole.dump", 1, ALL) + "run 0\n")
        whole = read_dump("whole.dump")[1]
        self.assertTrue((whole["f_spacing"] == 4).all())
        run(setup.header() + "read_restart half\n" + setup.properties() + PAGE + template + last)
        again = read_dump("end.dump")[1]
        for column in ALL:
            np.testing.assert_array_equal(again[column], whole[column], column)
        ends = []
        for ranks in (1, 2):
            run(setup.header() + "read_data half.data\n" + setup.properties() + PAGE + last, ranks)
            ends.append(read_dump("end.dump")[1])
        for column in ("x", "vy", "omegaz", "fx", "f_subspheres"):
            np.testing.assert_allclose(ends[1][column], ends[0][column], rtol=0,
                                       atol=1e-9 * np.abs(ends[0][column]).max(), err_msg=column)

    def test_random_shapes_and_refusals(self):
        """Few particles: each shape has spheres of its own."""
        setup = Setup(box=(0.0, 0.04) * 3, boundary="p p p", pair=multisphere_setup().pair)
        start = setup.without_particles()
        run(start + TEMPLATE + "subspheres 24 spacing medial vary a uniform 0.9 1.1 vary c uniform 0.9 1.1\n"
            + self.INSERT.replace("region 120", "region 8") + dump("few.dump", 1, ALL) + "run 0\n")
        self.assertGreater(len(set(read_dump("few.dump")[1]["shapex"][0])), 4)
        for words, expected in (("subspheres 5 spacing medial", "not one body"),
                                ("subspheres 25 spacing paper", "medial")):
            outcome = run(start + TEMPLATE + words + "\n", check=False)
            self.assertNotEqual(outcome.code, 0)
            self.assertIn(expected, outcome.text)


if __name__ == "__main__":
    unittest.main(verbosity=2)
