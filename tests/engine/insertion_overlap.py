"""`overlapcheck yes` of the insertions: no two bodies overlap, whatever their sizes, and few places are refused that
are free. Overlaps are found by brute force over all pairs and images (_brute_force.py)."""

import math
import re
import unittest
from pathlib import Path

import numpy as np

from _brute_force import BruteForce, Frame
from _engine import LAW, Particle, Setup, dump, quaternion_of, run

COLUMNS = "id type mass x y z quat1 quat2 quat3 quat4 shapex shapey shapez".split()
TEMPLATE = "fix {name} all particletemplate/ellipsoid {seed} atom_type 1 density 2500 volume_limit 1e-15 semiaxes {axes}\n"
PACK = ("fix {name} all insert/pack seed {seed} distributiontemplate {mix} maxattempt {tries} insert_every {every} "
        "overlapcheck yes orientation random all_in {all_in} region {region} particles_in_region {count}\n")


def body(a, b, c, spheres=0):
    return f"{a!r} {b!r} {c!r} subspheres {spheres}" if spheres else f"{a!r} {b!r} {c!r}"


def setup(spheres=0, **keywords):
    surface = "multisphere" if spheres else "smooth"
    return Setup(pair=f"gran/ellipsoid {LAW} surface {surface}", skin=5e-4, time_step=1e-9, **keywords)


def pack(name, axes, region="cloud", count=100, tries=500, all_in="yes", every="once", seed=32452867):
    """A template, its distribution and an insertion of it."""
    return (TEMPLATE.format(name=f"t{name}", seed=15485863, axes=axes)
            + f"fix d{name} all particledistribution/discrete 32452843 1 t{name} 1.0\n"
            + PACK.format(name=f"i{name}", mix=f"d{name}", region=region, count=count, tries=tries, all_in=all_in,
                          every=every, seed=seed))


def frame(file, spheres=0):
    """Bodies of the last frame."""
    lines = Path(file).read_text().split("ITEM: ATOMS")[-1].splitlines()[1:]
    values = np.array([line.split() for line in lines], float)
    columns = {n: values[:, k] for k, n in enumerate(COLUMNS)}
    axes = np.stack([columns[f"shape{n}"] for n in "xyz"], 1)
    chains = np.full(len(axes), spheres)
    zero = np.zeros_like(axes)
    return Frame(columns["id"].astype(int), columns["type"].astype(int) - 1, columns["mass"], zero + 1.0, axes,
                 np.stack([columns[n] for n in "xyz"], 1), zero, zero,
                 np.stack([columns[f"quat{k}"] for k in (1, 2, 3, 4)], 1), chains)


def overlaps(bodies, periods=(np.inf,) * 3):
    """Deepest overlap (m), 0 where there is none."""
    return max((c[3] for c in BruteForce(None, periods).contacts(bodies).values()), default=0.0)


def solid_volume(bodies):
    return 4.0 / 3.0 * math.pi * bodies.axes.prod(1).sum()


BLOCK = "region cloud block -0.01 0.01 -0.01 0.01 -0.01 0.01 units box\n"
OUT = dump("out.dump", columns=COLUMNS)


class InsertionOverlap(unittest.TestCase):
    def test_as_dense_as_spheres(self):
        """Of a region of 16 mm spheres fill about 0.3 in so many attempts; bounding spheres allowed 0.11 at aspect 3.5."""
        side, spheres_reach = 0.016, None
        for aspect, spheres in ((1.0, 0), (2.0, 0), (3.5, 0), (2.0, 5), (3.5, 9)):
            b = 1e-3 / aspect ** (1.0 / 3.0)
            axes = body(aspect * b, b, b, spheres)
            count = int(0.36 * side ** 3 / (4.0 / 3.0 * math.pi * 1e-9))
            run(setup(spheres, box=(-0.012, 0.012) * 3).without_particles() + BLOCK.replace("0.01", repr(side / 2)) + pack("a", axes, count=count)
                + "fix motion all nve/ellipsoid\n" + OUT + "run 1\n", name="in.dense")
            bodies = frame("out.dump", spheres)
            self.assertEqual(overlaps(bodies), 0.0)
            density = solid_volume(bodies) / side ** 3
            print(f"aspect {aspect}, {spheres} spheres: {len(bodies.ids)} bodies, {density:.3f} solid")
            spheres_reach = spheres_reach or density
            self.assertGreaterEqual(density, spheres_reach)
            self.assertGreater(density, 0.28)

    def test_among_larger_bodies(self):
        """Bodies there already, six times larger, also below the region and beyond a periodic face."""
        for ranks, boundary, spheres in ((1, "f f f", 0), (1, "p p p", 0), (2, "p p f", 5), (4, "p p p", 0)):
            large = [Particle((x, y, z), (6e-3, 4e-3, 4e-3), quaternion_of((1, 2, x * 900), 1.0 + y * 300))
                     for x, y, z in ((0.0, 0.0, 0.0), (0.0095, 0.009, 0.0), (-0.009, 0.003, -0.0115), (0.0, -0.009, -0.011))]
            text = setup(spheres, boundary=boundary, box=(-0.0125, 0.0125) * 3).with_particles(large)
            if spheres:
                text += (f"fix subspheres all property/atom subspheres scalar yes yes no {spheres}\n"
                         "fix spacing all property/atom spacing scalar yes yes no 0\n")
            text += "region cloud block -0.0124 0.0124 -0.0124 0.0124 -0.008 0.012 units box\n"
            run(text + pack("a", body(9e-4, 5e-4, 5e-4, spheres), count=600, tries=100)
                + "fix motion all nve/ellipsoid\n" + OUT + "run 1\n", ranks, name="in.among")
            bodies = frame("out.dump", spheres)
            periods = [0.025 if b == "p" else np.inf for b in boundary.split()]
            self.assertGreater(len(bodies.ids), 300)
            before = BruteForce(None, periods).contacts(frame_of(large, spheres))
            new = {k for k in BruteForce(None, periods).contacts(bodies) if max(k[:2]) > len(large)}
            self.assertFalse(new, f"{ranks} ranks, {boundary}: {sorted(new)[:3]}")
            self.assertLess(len(before), 40)

    def test_several_insertions_of_one_step_and_of_many(self):
        for ranks in (1, 3):
            text = setup(boundary="p p p", box=(-0.01, 0.01) * 3).without_particles()
            text += "region cloud block -0.01 0.01 -0.01 0.01 -0.01 0.01 units box\n"
            text += pack("a", body(2e-3, 1.5e-3, 1e-3), count=60, every=1, tries=30)
            text += pack("b", body(4e-4, 5e-4, 6e-4), count=500, every=1, seed=49979687, tries=30)
            run(text + "fix motion all nve/ellipsoid\n" + OUT + "run 4\n", ranks, name="in.several")
            bodies = frame("out.dump")
            self.assertGreater(len(bodies.ids), 200)
            self.assertEqual(overlaps(bodies, (0.02,) * 3), 0.0)

    def test_the_true_body_lies_in_the_region(self):
        """Regions into which the bounding sphere (2 mm) does not fit."""
        regions = {"block": "block -0.01 0.01 -0.0015 0.0015 -0.01 0.01", "sphere": "sphere 0.001 0 0 0.003",
                   "cylinder": "cylinder y 0.001 -0.002 0.0018 -0.006 0.008"}
        for name, words in regions.items():
            run(setup(box=(-0.012, 0.012) * 3).without_particles() + f"region cloud {words} units box\n"
                + pack("a", body(2e-3, 6e-4, 5e-4), count=20, tries=20000, all_in="yes").replace("once", "1")
                + "fix motion all nve/ellipsoid\n" + OUT + "run 1\n", name="in.inside")
            bodies = frame("out.dump")
            self.assertGreater(len(bodies.ids), 0 if name == "sphere" else 3, name)
            self.assertEqual(overlaps(bodies), 0.0)
            theta, phi = np.meshgrid(np.linspace(0, math.pi, 60), np.linspace(0, 2 * math.pi, 120))
            unit = np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)], -1).reshape(-1, 3)
            for k in range(len(bodies.ids)):
                p = bodies.x[k] + (unit * bodies.axes[k]) @ bodies.turn[k].T
                outside = {"block": np.abs(p / [0.01, 0.0015, 0.01]).max() - 1.0,
                           "sphere": np.linalg.norm(p - [0.001, 0, 0], axis=1).max() / 0.003 - 1.0,
                           "cylinder": max(np.hypot(p[:, 0] - 0.001, p[:, 2] + 0.002).max() / 0.0018 - 1.0,
                                           p[:, 1].max() / 0.008 - 1.0, -p[:, 1].min() / 0.006 - 1.0)}[name]
                self.assertLessEqual(outside, 1e-12, name)

    def test_the_true_body_lies_in_other_regions(self):
        """Cones, prisms, planes, unions, intersections, outsides: no point of a body is beyond, by the region's
        own definition; bodies of aspect 2.5 lie where their bounding spheres would not."""
        h = 0.01
        regions = {
            "cone": (["cloud cone z 0.0 0.0 0.002 0.008 -0.01 0.01"],
                     lambda p: np.maximum(np.hypot(p[:, 0], p[:, 1]) - (0.005 + 0.3 * p[:, 2]), abs(p[:, 2]) - h)),
            "prism": (["cloud prism -0.008 0.004 -0.008 0.008 -0.008 0.008 0.004 0.0 0.0"],
                      lambda p: np.max([abs(p[:, 1]) - 8e-3, abs(p[:, 2]) - 8e-3,
                                        abs(p[:, 0] + 0.002 - 0.004 * (p[:, 1] + 0.008) / 0.016) - 6e-3], axis=0)),
            "union": (["one sphere -0.005 0 0 0.005", "two block 0.0 0.01 -0.004 0.004 -0.004 0.004",
                       "cloud union 2 one two"],
                      lambda p: np.minimum(np.linalg.norm(p + [0.005, 0, 0], axis=1) - 0.005,
                                           np.max([-p[:, 0], p[:, 0] - h, abs(p[:, 1]) - 4e-3, abs(p[:, 2]) - 4e-3],
                                                  axis=0))),
            "intersect": (["one sphere -0.003 0 0 0.007", "two block -0.006 0.01 -0.004 0.01 -0.01 0.01",
                           "cloud intersect 2 one two"],
                          lambda p: np.max([np.linalg.norm(p + [0.003, 0, 0], axis=1) - 0.007, -0.006 - p[:, 0],
                                            -0.004 - p[:, 1]], axis=0)),
            "outside": (["one cylinder z 0 0 0.004 -0.02 0.02 side out", "two block -0.01 0.01 -0.01 0.01 -0.01 0.01",
                         "cloud intersect 2 one two"],
                        lambda p: np.maximum(0.004 - np.hypot(p[:, 0], p[:, 1]), abs(p).max(1) - h)),
            "edge": (["one block -0.01 0.01 -0.01 0.0 -0.01 0.01", "two block -0.01 0.0 -0.01 0.01 -0.01 0.01",
                      "cloud union 2 one two"],  # an L, whose inner edge is in no face's foot
                     lambda p: np.maximum(abs(p).max(1) - h, np.minimum(p[:, 0], p[:, 1]))),
            "silo": (["one cone z 0 0 0.002 0.009 -0.01 0.0", "two cylinder z 0 0 0.009 0.0 0.01", "cloud union 2 one two"],
                     lambda p: np.maximum(np.hypot(p[:, 0], p[:, 1]) - np.minimum(0.009, 0.009 + 0.7 * p[:, 2]),
                                          abs(p[:, 2]) - h)),
            "wedge": (["one cylinder y 0 0 0.01 -0.01 0.01", "two plane 0 0 0 0 0 1", "three plane 0 0 0 1 0 -0.2",
                       "cloud intersect 3 one two three"],
                      lambda p: np.max([np.hypot(p[:, 0], p[:, 2]) - h, abs(p[:, 1]) - h, -p[:, 2],
                                        (0.2 * p[:, 2] - p[:, 0]) / math.hypot(1, 0.2)], axis=0)),
            "hole": (["one block -0.004 0.003 -0.004 0.004 -0.02 0.02 side out", "two cone x 0 0 0.01 0.008 -0.01 0.01",
                      "cloud intersect 2 one two"],
                     lambda p: np.max([np.min([p[:, 0] + 4e-3, 3e-3 - p[:, 0], 4e-3 - abs(p[:, 1])], axis=0),
                                       np.hypot(p[:, 1], p[:, 2]) - (0.009 - 0.1 * p[:, 0]), abs(p[:, 0]) - h], axis=0)),
            "complement": (["one block -0.002 0.02 -0.02 0.02 -0.002 0.02", "two sphere -0.005 0 0 0.004",
                            "three union 2 one two side out", "four block -0.01 0.01 -0.01 0.01 -0.01 0.01",
                            "cloud intersect 2 three four"],
                           lambda p: np.max([abs(p).max(1) - h, 0.004 - np.linalg.norm(p + [0.005, 0, 0], axis=1),
                                             np.minimum(p[:, 0], p[:, 2]) + 0.002], axis=0))}
        theta, phi = np.meshgrid(np.linspace(0, math.pi, 40), np.linspace(0, 2 * math.pi, 80))
        unit = np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)], -1).reshape(-1, 3)
        for name, (lines, beyond) in regions.items():
            with self.subTest(region=name):
                text = "".join(f"region {line} units box\n" if "union" not in line and "intersect" not in line
                               else f"region {line}\n" for line in lines)
                run(setup(box=(-0.012, 0.012) * 3).without_particles() + text
                    + pack("a", body(2.0e-3, 8e-4, 6e-4), count=100, tries=300, every="1")
                    + "fix motion all nve/ellipsoid\n" + OUT + "run 1\n", name=f"in.{name}")
                bodies = frame("out.dump")
                self.assertGreater(len(bodies.ids), 20)
                self.assertEqual(overlaps(bodies), 0.0)
                sticking_out = 0  # bounding spheres that do
                for k in range(len(bodies.ids)):
                    p = bodies.x[k] + (unit * bodies.axes[k]) @ bodies.turn[k].T
                    self.assertLessEqual(beyond(p).max(), 1e-12)
                    sticking_out += beyond(bodies.x[k] + unit * bodies.axes[k].max()).max() > 0.0
                self.assertGreater(sticking_out, 5)

    def test_regions_that_change_are_refused(self):
        for region, message in (
                ("sphere 0 0 0 v_size units box", "\\(id ia\\) in region 'cloud'.*use one region for each run"),
                ("cylinder z 0 0 v_size -0.006 0.006 units box", "radius is a variable"),
                ("block -0.006 0.006 -0.006 0.006 -0.006 0.006 move v_size NULL NULL units box", "dynamic regions")):
            for name in ("cloud", "part"):
                if name == "part" and "move" in region:
                    continue  # the host refuses such unions by themselves
                text = f"variable size equal 0.006-1e-5*step\nregion {name} {region}\n"
                text += "" if name == "cloud" else "region cloud intersect 2 part box\n"
                outcome = run(setup(box=(-0.012, 0.012) * 3).without_particles() + text
                              + pack("a", body(1e-3, 6e-4, 5e-4), count=20) + "fix motion all nve/ellipsoid\nrun 1\n",
                              check=False, name="in.changing")
                (line,) = [line for line in outcome.text.splitlines() if line.startswith("ERROR")]
                self.assertRegex(line, message)

    def mixture(self, count, every):
        text = setup(box=(-0.02, 0.02) * 3).without_particles() + BLOCK
        text += TEMPLATE.format(name="grain", seed=15485863, axes=body(4e-3, 2e-3, 2e-3))
        text += TEMPLATE.format(name="ball", seed=15485867, axes=body(1e-3, 1e-3, 1e-3))
        text += "fix mix all particledistribution/discrete 32452843 2 grain 0.5 ball 0.5\n"
        text += PACK.format(name="ins", mix="mix", region="cloud", count=count, tries=100, all_in="yes", every=every,
                            seed=32452867)
        return run(text + "fix motion all nve/ellipsoid\nrun 1\n", check=False, name="in.mixture")

    def test_a_mixture_that_finds_no_room(self):
        outcome = self.mixture(900, "once")
        self.assertNotEqual(outcome.code, 0)
        line = re.search(r"ERROR.*no room for all particles.*", outcome.text)[0]
        placed = {name: (int(n), int(of)) for n, of, name in re.findall(r"(\d+) of (\d+) of template '(\w+)'", line)}
        self.assertEqual(set(placed), {"grain", "ball"})
        self.assertEqual(sum(of for _, of in placed.values()), 900)
        self.assertLess(placed["ball"][0], placed["ball"][1])
        outcome = self.mixture(900, "5")  # goes on: what is missing is said
        self.assertEqual(outcome.code, 0)
        self.assertRegex(outcome.text, r"WARNING.*\(id ins\): no room for all particles.*of template 'ball'")
        outcome = self.mixture(60, "once")
        self.assertEqual(outcome.code, 0)
        self.assertNotIn("no room", outcome.text)


def frame_of(particles, spheres):
    axes = np.array([p.semiaxes for p in particles])
    zero = np.zeros_like(axes)
    return Frame(np.arange(1, len(axes) + 1), np.zeros(len(axes), int), np.ones(len(axes)), zero + 1.0, axes,
                 np.array([p.position for p in particles]), zero, zero,
                 np.array([p.quaternion for p in particles]), np.full(len(axes), spheres))


if __name__ == "__main__":
    unittest.main(verbosity=2)
