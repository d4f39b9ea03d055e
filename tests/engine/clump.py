"""Clumps of any spheres in the engine: against the host's fix multisphere with the same law, against
chains, walls and insertion by brute force, exchange between ranks, dumps, data and restart files, bad
input."""

import math
import os
import unittest
from pathlib import Path

import numpy as np

from _engine import (LAW, Particle, Setup, dump, ellipsoids_data, read_dump, rotation, run, run_example,
                     vectors)
from _multisphere import chain, multisphere_setup

# A hook: nothing symmetric about it (m).
HOOK = np.array([[0.0, 0.0, 0.0, 1.0], [1.2, 0.0, 0.0, 0.8], [2.0, 0.5, 0.0, 0.6],
                 [2.2, 1.2, 0.3, 0.5], [0.0, 0.0, 0.9, 0.5]]) * 1e-3
DENSITY = 1340.0


def write_spheres(file, spheres):
    Path(file).write_text("".join(" ".join(repr(float(v)) for v in row) + "\n" for row in spheres))
    return file


def body_frame(file):
    """Spheres in the body's frame as the engine wrote them (N, 4)."""
    return np.loadtxt(file, delimiter=",", skiprows=3)


def spheres_in_space(columns, frame, body):
    """Centres (particles, N, 3) and radii (N) of clumps of one template in a frame."""
    x = vectors(columns, "x", "y", "z")[frame]
    r = np.array([rotation([columns[f"quat{k}"][frame][i] for k in (1, 2, 3, 4)])
                  for i in range(len(x))])
    scale = columns["shapey"][frame] / (np.abs(body[:, 1]) + body[:, 3]).max()
    centres = x[:, None] + scale[:, None, None] * np.einsum("pij,nj->pni", r, body[:, :3])
    return centres, scale[:, None] * body[:, 3]


def gap(centres, radii, other, other_radii):
    distance = np.linalg.norm(centres[:, None] - other[None], axis=2)
    return (distance - radii[:, None] - other_radii[None]).min()


TEMPLATE = f"fix grain all particletemplate/ellipsoid 15485863 atom_type 1 density {DENSITY} "
BOX = (0.0, 0.03, 0.0, 0.03, 0.0, 0.03)


def insertion(template, count, seed=32452843, extra=""):
    return template + f"""
fix mix all particledistribution/discrete 15485867 1 grain 1.0
region all block 0 0.03 0 0.03 0 0.03 units box
fix fill all insert/pack seed {seed} distributiontemplate mix {extra} orientation random &
    insert_every once overlapcheck yes all_in yes region all particles_in_region {count}
run 1
unfix fill
"""


class Room(Setup):
    """With neighbour pages for the histories of 64 contacts."""

    def properties(self):
        return super().properties() + "neigh_modify page 1000000\n"


def setup(**options):
    arguments = dict(box=BOX, boundary="p p p", time_step=2e-6, skin=0.001,
                     pair=multisphere_setup("contacts 64").pair)
    arguments.update(options)
    return Room(**arguments)


COLUMNS = ("id type mass x y z vx vy vz omegax omegay omegaz fx fy fz tqx tqy tqz quat1 quat2 quat3 "
           "quat4 shapex shapey shapez radius f_subspheres f_spacing").split()


class Insertion(unittest.TestCase):
    def test_exact_and_without_overlap(self):
        """Two templates and chains mixed; no two spheres overlap, also over periodic sides, and some
        bounding spheres do."""
        write_spheres("hook.csv", HOOK)
        write_spheres("cross.csv", [[0, 0, 0, 1e-3], [1.5e-3, 0, 0, 8e-4], [-1.5e-3, 0, 0, 8e-4],
                                    [0, 1.5e-3, 0, 8e-4]])
        templates = (TEMPLATE + "clump hook.csv write_clump hook.body vary all uniform 0.8 1.2\n"
                     + TEMPLATE.replace("grain", "cross").replace("15485863", "32452867") + "clump cross.csv write_clump cross.body\n"
                     + TEMPLATE.replace("grain", "rod").replace("15485863", "49979687")
                     + "semiaxes 2.4e-3 1e-3 1e-3 subspheres 5\n")
        script = insertion(templates, 150).replace(
            "1 grain 1.0", "3 grain 0.4 cross 0.3 rod 0.3")
        for ranks in (1, 2):
            run(setup().without_particles() + script + dump("mix.dump", 1, COLUMNS) + "run 0\n", ranks)
            _, columns = read_dump("mix.dump")
            codes = columns["f_spacing"][-1].astype(int)
            self.assertEqual(set(codes), {0, 1001, 1002})
            self.assertGreater(len(codes), 100)
            bodies = {1001: body_frame("hook.body"), 1002: body_frame("cross.body")}
            centres, radii = chain(2.4e-3, 1e-3, 5)
            bodies[0] = np.column_stack([centres, 0 * radii, 0 * radii, radii])
            placed = []
            for i, code in enumerate(codes):
                one = {name: [values[-1][i:i + 1]] for name, values in columns.items()}
                c, r = spheres_in_space({k: np.array(v) for k, v in one.items()}, 0, bodies[code])
                placed.append((c[0], r[0]))
                self.assertEqual(columns["f_subspheres"][-1][i], len(bodies[code]))
            x, bounds = vectors(columns, "x", "y", "z")[-1], columns["radius"][-1]
            smallest, tight = np.inf, 0
            for i in range(len(codes)):
                for j in range(i):
                    shift = 0.03 * np.round((x[j] - x[i]) / 0.03)
                    tight += np.linalg.norm(x[j] - x[i] - shift) < bounds[i] + bounds[j]
                    smallest = min(smallest, gap(*placed[i], placed[j][0] - shift, placed[j][1]))
            print(f"{ranks} ranks: {len(codes)} particles, smallest gap {smallest:.1e} m, {tight} pairs "
                  "with overlapping bounding spheres")
            self.assertGreaterEqual(smallest, 0.0)
            self.assertGreater(tight, 20)

    def test_mass_and_moments_of_the_union(self):
        """Against points thrown into the box around the spheres."""
        write_spheres("hook.csv", HOOK)
        run(setup().without_particles() + insertion(TEMPLATE + "clump hook.csv write_clump body.csv", 1)
            + dump("one.dump", 1, COLUMNS) + "run 0\n")
        _, columns = read_dump("one.dump")
        body = body_frame("body.csv")
        random = np.random.default_rng(6)
        low, high = (body[:, :3] - body[:, 3:]).min(axis=0), (body[:, :3] + body[:, 3:]).max(axis=0)
        points = random.uniform(low, high, (2000000, 3))
        inside = np.zeros(len(points), bool)
        for *centre, radius in body:
            inside |= ((points - centre) ** 2).sum(axis=1) < radius ** 2
        mass = DENSITY * np.prod(high - low) * inside.mean()
        self.assertAlmostEqual(columns["mass"][-1][0] / mass, 1.0, delta=3e-3)
        self.assertLess(np.abs(points[inside].mean(axis=0)).max(), 5e-3 * (high - low).max())
        self.assertAlmostEqual(columns["radius"][-1][0],
                               (np.linalg.norm(body[:, :3], axis=1) + body[:, 3]).max(), delta=1e-15)

    def test_a_region_is_filled_up_by_volume(self):
        """`volumefraction_region` counts the volume of the union, also of those that are there already; so does
        `compute property/atom volume`."""
        write_spheres("hook.csv", HOOK)
        pack = insertion(TEMPLATE + "clump hook.csv", 0).replace("insert_every once", "insert_every 1").replace(
            "particles_in_region 0", "volumefraction_region 0.08").replace("unfix fill\n", "")
        half = "variable even atom id%2\ngroup even variable even\ndelete_atoms group even\n"
        columns = COLUMNS + ["c_body[1]", "c_body[2]"]
        run(setup().without_particles() + pack.replace("run 1\n", "compute body all property/atom volume eqradius\n")
            + "fix motion all nve/ellipsoid\n"
            + "".join(f"run 1\nwrite_dump all custom {name}.dump {' '.join(columns)}\n{after}"
                      for name, after in (("first", half), ("second", ""))))
        for name in ("first", "second"):
            mass, volume, radius = (read_dump(f"{name}.dump")[1][c][-1] for c in ("mass", "c_body[1]", "c_body[2]"))
            np.testing.assert_allclose(volume, mass / DENSITY, rtol=1e-4)  # dumped with six digits
            np.testing.assert_allclose(4.0 / 3.0 * math.pi * radius ** 3, volume, rtol=1e-4)
            print(f"{name}: {len(mass)} clumps, {mass.sum() / DENSITY / 0.03 ** 3:.4f} of the region")
            self.assertLess(abs(mass.sum() / DENSITY - 0.08 * 0.03 ** 3), 1.01 * mass[0] / DENSITY)


class Files(unittest.TestCase):
    """Restart, data files, ranks."""

    def script(self, more):
        return setup().without_particles() + insertion(
            TEMPLATE + "clump hook.csv", 60, extra="vel uniform 0 0 0 2 2 2") + more

    def setUp(self):
        write_spheres("hook.csv", HOOK)

    MOTION = "fix motion all nve/ellipsoid\n"

    def frame(self, file):
        _, columns = read_dump(file)
        return {name: np.asarray(values[-1]) for name, values in columns.items()}

    def test_restart_goes_on_bit_for_bit(self):
        run(self.script(self.MOTION + "run 300\nwrite_restart half\nrun 300\n"
                        + dump("whole.dump", 1, COLUMNS) + "run 0\n"))
        again = (setup().header() + "read_restart half\n" + setup().properties())
        properties = "fix subspheres all property/atom subspheres scalar yes yes no 0.\n" \
                     "fix spacing all property/atom spacing scalar yes yes no 0.\n"
        for name, template in (("template", TEMPLATE + "clump hook.csv\n"), ("table", properties)):
            run(again + template + self.MOTION + "run 300\n" + dump("again.dump", 1, COLUMNS)
                + "run 0\n")
            whole, found = self.frame("whole.dump"), self.frame("again.dump")
            for column in COLUMNS:
                np.testing.assert_array_equal(found[column], whole[column], f"{name}: {column}")

    def test_what_a_restart_needs_is_said(self):
        """Without template and fix property/atom: whether the bounding sphere tells that it is a clump (a hook), or not
        (a chain)."""
        repeat = "after read_restart repeat the templates with 'subspheres' or 'clump', or give 'fix subspheres all property/atom"
        for words, begin in (("clump hook.csv", "as clumps have; "), ("semiaxes 2.4e-3 1e-3 1e-3 subspheres 5", "fix particletemplate")):
            run(setup().without_particles() + insertion(TEMPLATE + words, 10) + "write_restart bare\n")
            message = fails(setup().header() + "read_restart bare\n" + setup().properties() + self.MOTION + "run 1\n")
            (line,) = [line for line in message.splitlines() if line.startswith("ERROR")]
            self.assertIn(begin, line)
            self.assertIn(repeat, line)

    def test_doubled_spheres_count_once(self):
        write_spheres("twice.csv", np.vstack([HOOK, HOOK[2:4]]))
        outcome = run(self.script("").replace("hook.csv", "twice.csv") + dump("twice.dump", 1, COLUMNS) + "run 0\n")
        self.assertEqual(outcome.text.count("'twice.csv': 2 spheres equal an earlier one and are left out"), 1)
        run(self.script(dump("once.dump", 1, COLUMNS) + "run 0\n"))
        once, twice = self.frame("once.dump"), self.frame("twice.dump")
        for column in COLUMNS:
            np.testing.assert_array_equal(twice[column], once[column], column)

    def test_another_clump_of_the_name_is_refused(self):
        run(self.script("write_restart refused\n"))
        write_spheres("hook.csv", HOOK * [1.0, 1.0, 1.0, 0.99])
        message = fails(setup().header() + "read_restart refused\n" + setup().properties() + TEMPLATE
                        + "clump hook.csv\n")
        self.assertIn("another clump of this name is there", message)

    def test_ranks(self):
        """The same forces on 1, 2 and 4 ranks; nobody is lost or doubled."""
        frames = []
        run(self.script("write_data start.data\n"))
        for ranks in (1, 2, 4):
            run(setup().header() + "read_data start.data\n" + setup().properties() + TEMPLATE
                + "clump hook.csv\n" + self.MOTION + dump("ranks.dump", 200, COLUMNS) + "run 400\n",
                ranks)
            frames.append(self.frame("ranks.dump"))
        self.assertEqual(len(frames[0]["id"]), len(set(frames[0]["id"])))
        for other in frames[1:]:
            for column in ("id", "x", "y", "z", "vx", "omegax", "fx", "tqy", "f_spacing"):
                scale = np.abs(frames[0][column]).max()
                np.testing.assert_allclose(other[column], frames[0][column], rtol=0,
                                           atol=1e-9 * scale, err_msg=column)

    def test_data_file_keeps_the_particles(self):
        run(self.script(dump("before.dump", 1, COLUMNS) + "run 0\nwrite_data kept.data\n"))
        run(setup().header() + "read_data kept.data\n" + setup().properties() + TEMPLATE
            + "clump hook.csv\n" + dump("after.dump", 1, COLUMNS) + "run 0\n")
        before, after = self.frame("before.dump"), self.frame("after.dump")
        for column in COLUMNS:
            np.testing.assert_allclose(after[column], before[column], rtol=1e-14, err_msg=column)
        message = fails(setup().header() + "read_data kept.data\n" + setup().properties()
                        + "run 0\n")
        self.assertIn("give the templates", message)


class Restarts(unittest.TestCase):
    def test_nobody_lost_in_50_periodic_restarts(self):
        write_spheres("hook.csv", HOOK * 0.5)
        common = setup(time_step=4e-6).properties() + TEMPLATE + "clump hook.csv\n" \
            + "fix motion all nve/ellipsoid\n"
        head = setup(time_step=4e-6).header()
        script = setup(time_step=4e-6).without_particles() + insertion(
            TEMPLATE + "clump hook.csv", 40, extra="vel uniform 0 0 0 8 8 8") \
            + "fix motion all nve/ellipsoid\nrun 40\nwrite_restart r.0\n" \
            + dump("first.dump", 1, ["id"]) + "run 0\n"
        for k in range(50):
            script += f"clear\n{head}read_restart r.{k}\n{common}run 40\nwrite_restart r.{k + 1}\n"
        script += dump("last.dump", 1, ["id"]) + "run 0\n"
        for ranks in (1, 2):
            run(script, ranks)
            first, last = (sorted(read_dump(f)[1]["id"][-1]) for f in ("first.dump", "last.dump"))
            self.assertEqual(len(first), 40)
            np.testing.assert_array_equal(first, last)


class ManyContacts(unittest.TestCase):
    def test_more_than_the_lists_have_room_for(self):
        """Two plates of 400 spheres face to face touch at some 500 places, by brute force; `contacts` 8, 64 and 1500
        go the same way, bit for bit, with friction."""
        along = (np.arange(20) - 9.5) * 1e-4
        x, y = (v.ravel() for v in np.meshgrid(along, 0.8 * along))
        plate = np.column_stack([x, y, 0.0 * x, np.full(len(x), 9e-5)])
        Path("plate.csv").write_text("# frame: body\n")
        with open("plate.csv", "a") as file:
            np.savetxt(file, plate, fmt="%.17g")
        reach = tuple((np.abs(plate[:, :3]) + plate[:, 3:]).max(axis=0))
        mass, moments, box, angle = 1e-2, (2e-9, 3e-9, 5e-9), (0.0, 0.01) * 3, 0.2
        below, above = np.full(3, 5e-3), np.array([5.02e-3, 5.03e-3, 5.17e-3])
        turned = (math.cos(angle / 2), 0.0, 0.0, math.sin(angle / 2))
        two = [Particle(tuple(below), reach, (1.0, 0.0, 0.0, 0.0), (0.02, 0.0, 0.05), (3.0, 0.0, 20.0), mass, moments),
               Particle(tuple(above), reach, turned, (0.0, 0.0, -0.05), (0.0, 0.0, 0.0), mass, moments)]
        before, rest = ellipsoids_data(two, box, 1).split("Atoms\n\n")
        rows, after = rest.split("\n\nVelocities")
        rows = "\n".join(f"{row} {len(plate)} 1001" for row in rows.split("\n"))
        Path("two.data").write_text(f"{before}Atoms\n\n{rows}\n\nVelocities{after}")
        columns, frames = "id x y z fx fy fz tqx tqy tqz omegax omegay omegaz".split(), []
        for contacts in (8, 64, 1500):
            start = Setup(box=box, boundary="p p p", time_step=1e-7, skin=2e-4, pair=multisphere_setup(f"contacts {contacts}").pair)
            run(start.header() + "read_data two.data\n" + start.properties() + "neigh_modify one 30 page 280000\n"
                + f"fix grain all particletemplate/ellipsoid 15485863 mass {mass} inertia {' '.join(map(repr, moments))} clump plate.csv\n"
                + "fix motion all nve/ellipsoid\ncompute found all contacts/ellipsoid\nvariable pairs equal c_found[2]\n"
                + dump("two.dump", 100, columns) + 'fix table all print 100 "${pairs}" file pairs.txt screen no\nrun 1000\n')
            frames.append(read_dump("two.dump")[1])
        centres = plate[:, :3] @ rotation(turned).T + above
        touching = (np.linalg.norm((plate[:, None, :3] + below) - centres[None], axis=2) < 1.8e-4).sum()
        found = np.loadtxt("pairs.txt", comments="#")
        print(f"{touching} pairs of spheres touch at the start, {found.min():.0f} to {found.max():.0f} later")
        self.assertGreater(touching, 400)
        self.assertGreater(found.min(), 400)
        for column in columns:
            for other in frames[:2]:
                np.testing.assert_array_equal(other[column], frames[2][column], column)
        first = np.array([frames[2][f][0][0] for f in ("fx", "fy", "fz")])
        self.assertLess(np.abs(first + [frames[2][f][0][1] for f in ("fx", "fy", "fz")]).max(), 1e-9 * np.abs(first).max())


class ChainAsClump(unittest.TestCase):
    def test_same_trajectories(self):
        """A chain of 7 as a list of spheres, with the chain's mass and moments: the same motion."""
        a, b = 2.7e-3, 1.15e-3
        centres, radii = chain(a, b, 7)
        write_spheres("chain.csv", np.column_stack([centres, 0 * radii, 0 * radii, radii]))
        mass = DENSITY * 4.0 / 3.0 * math.pi * a * b * b
        moments = [0.2 * mass * m for m in (2 * b * b, a * a + b * b, a * a + b * b)]
        by_file = TEMPLATE.replace(f"density {DENSITY}", f"mass {mass!r}") + "clump chain.csv inertia " \
            + " ".join(map(repr, moments))
        by_number = TEMPLATE + f"semiaxes {a!r} {b!r} {b!r} subspheres 7"
        frames = []
        for k, template in enumerate((by_number, by_file)):
            run(setup().without_particles()
                + insertion(template, 60, extra="vel uniform 0 0 0 1 1 1")
                + "fix motion all nve/ellipsoid\n" + dump(f"{k}.dump", 500, COLUMNS) + "run 3000\n")
            _, columns = read_dump(f"{k}.dump")
            frames.append(columns)
        x = [vectors(c, "x", "y", "z") for c in frames]
        hit = np.abs(vectors(frames[0], "omegax", "omegay", "omegaz")[-1]).max(axis=1) > 0.0
        worst = np.abs(x[0] - x[1]).max() / a
        print(f"{hit.sum()} of {len(hit)} particles have collided; positions differ by {worst:.1e} a")
        self.assertGreater(hit.sum(), 20)
        self.assertLess(worst, 1e-9)


class Example(unittest.TestCase):
    def test_drum(self):
        """inputs/clumps.in in a short form: all stay within the drum, of all three kinds."""
        source = Path(os.environ["ELLIPSOID_SOURCE"]) / "inputs"
        run_example("clumps", {"particles": 40, "fill": 0.05, "turn": 0.05, "dump_time": 0.05, "out": "drum",
                               "meshes": source / "meshes", "clumps": source / "clumps"})
        files = sorted(Path("drum").glob("clumps.*.dump"))
        self.assertGreaterEqual(len(files), 2)
        _, columns = read_dump(files[-1])
        self.assertEqual(columns["id"].shape[1], 40)
        self.assertEqual(set(columns["f_spacing"][-1]), {0.0, 1001.0, 1002.0})
        distance = np.hypot(columns["x"][-1], columns["z"][-1])
        self.assertLess(distance.max(), 0.030)  # the drum's radius
        self.assertLess(columns["z"][-1].mean(), -0.01)  # they have fallen


def fails(script):
    """The error message of a script that must stop."""
    outcome = run(script, check=False)
    assert outcome.code != 0, "the script was accepted"
    return outcome.text


class BadInput(unittest.TestCase):
    def complaint(self, content, words="clump bad.csv"):
        if content is not None:
            Path("bad.csv").write_text(content)
        text = fails(setup().without_particles() + TEMPLATE + words + "\n")
        lines = [line for line in text.splitlines() if line.startswith("ERROR")]
        self.assertEqual(len(lines), 1, text)
        return lines[0]

    def test_one_line_each(self):
        for content, words, expected in (
                ("0 0 0 1\n1 0 0 0\n", "", "sphere 2 has the radius 0"),
                ("0 0 0 1\n3 0 0 1\n", "", "2 bodies apart"),
                ("".join(f"0 0 {k} 1\n" for k in range(300000)), "", "300000 spheres; allowed are 1 to 9999"),
                ("0 0 0 1\n", "clump_scale 1e-5", "volume of a particle is 4.18879e-15, keyword 'volume_limit' allows 1e-12"),
                ("0 0 0 1\n1 0 0\n", "", "line 2: 3 values"),
                ("", "", "it is empty"),
                ("0 0 0 1\n", "semiaxes 1 1 1", "leave 'semiaxes', 'subspheres' and 'spacing' out"),
                ("0 0 0 1\n", "spacing medial", "leave 'semiaxes', 'subspheres' and 'spacing' out"),
                ("0 0 0 1\n", "clump bad.csv", "'clump' is given twice"),
                ("0 0 0 1\r\n1 0 0 x\r\n", "", "line 2: 'x'"),
                ("x,y,z,r\0", "", "no plain text"),
                ("0 0 0 1\n", "vary a uniform 0.5 1.5", "use 'vary all'"),
                ("0 0 0 1\n", "clump_scale 0", "clump_scale"),
                ("# frame: body\n1 0 0 1\n", "", "give 'inertia'"),
                ("0 0 0 1\n", "write_clump no/such/folder", "cannot be written")):
            self.assertIn(expected, self.complaint(content, "clump bad.csv " + words))
        for words in ("clump_scale 2", "write_clump out.csv"):
            self.assertIn("are for clumps", self.complaint(None, "semiaxes 1e-3 1e-3 1e-3 " + words))
        self.assertIn("cannot be read", self.complaint(None, "clump missing.csv"))
        self.assertIn("cannot be read", self.complaint(None, "clump ."))

    def test_smooth_particles_beside_clumps(self):
        write_spheres("hook.csv", HOOK)
        text = fails(setup().without_particles() + insertion(
            TEMPLATE + "clump hook.csv\n" + TEMPLATE.replace("grain", "other").replace("15485863", "32452867")
            + "semiaxes 1e-3 1e-3 1e-3\n", 20).replace("1 grain 1.0", "2 grain 0.5 other 0.5") + "run 1\n")
        self.assertRegex(text, "ERROR[^\n]*\\(id other\\): it is smooth \\(subspheres 0\\)")
        self.assertNotIn("inserted", text)

    def test_no_smooth_surface(self):
        write_spheres("hook.csv", HOOK)
        smooth = setup(pair=f"gran/ellipsoid {LAW} surface smooth")
        text = fails(smooth.without_particles() + insertion(TEMPLATE + "clump hook.csv", 3))
        self.assertIn("clumps have no smooth surface", text)

    def test_set_that_makes_ellipsoids(self):
        write_spheres("hook.csv", HOOK)
        start = setup().without_particles() + insertion(TEMPLATE + "clump hook.csv", 3)
        self.assertIn("the semi-axes are not those of clump 'grain'",
                      fails(start + "set group all shape 1e-3 1e-3 2e-3\nrun 1\n"))
        self.assertIn("the moments are not those", fails(start + "set group all density 900\nrun 1\n"))


if __name__ == "__main__":
    unittest.main(verbosity=2)
