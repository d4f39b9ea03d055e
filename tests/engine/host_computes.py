"""What the host's computes and regions give for ellipsoids, against NumPy: those of centres, masses and
velocities on three bodies that fly on, those of contacts on bodies that touch."""

import math
import unittest
from pathlib import Path

import numpy as np

from _engine import LAW, Particle, Setup, dump, quaternion_of, read_dump, run, thermo
from _spinning import COLUMNS, after, bodies, read_columns, vectors

STEP, STEPS = 1e-6, 20


def start():
    return (np.array([p.position for p in bodies()]), np.array([p.velocity for p in bodies()]),
            np.array([p.mass for p in bodies()]))


def values(commands, names, name, steps=STEPS, ranks=1):
    """Values of thermo columns at the end."""
    after(commands + f"\nthermo_style custom step {' '.join(names)}\nthermo_modify norm no format float "
          "%.14g", name, steps, ranks)
    return thermo(f"log.in.{name}", len(names) + 1)[-1, 1:]


class OfAll(unittest.TestCase):
    def test_sums_and_means(self):
        x0, v, m = start()
        x = x0 + v * STEP * STEPS
        centre = m @ x / m.sum()
        radius = math.sqrt(m @ ((x - centre) ** 2).sum(1) / m.sum())
        moved = x - x0
        for ranks in (1, 2):
            found = values("""compute c1 all ke
compute c2 all com
compute c3 all msd
compute c4 all gyration
compute c5 all reduce max z
compute c6 all reduce sum vx
region half block INF INF INF INF 0 INF units box
compute c7 all reduce/region half sum vy
compute c8 all temp
""", ["c_c1", "c_c2[1]", "c_c2[2]", "c_c2[3]", "c_c3[4]", "c_c4", "c_c5", "c_c6", "c_c7", "c_c8"],
                           f"sums{ranks}", ranks=ranks)
            energy = 0.5 * (m * (v ** 2).sum(1)).sum()
            boltzmann, freedom = 1.3806504e-23, 3 * len(m) - 3
            expected = [energy, *centre, (moved ** 2).sum(1).mean(), radius, x[:, 2].max(), v[:, 0].sum(),
                        v[x[:, 2] > 0, 1].sum(), 2.0 * energy / freedom / boltzmann]
            np.testing.assert_allclose(found, expected, rtol=1e-6)

    def test_pair_distances(self):
        """compute rdf counts pairs by the distance of centres: here within the reach of the lists."""
        random = np.random.default_rng(3)
        places = random.uniform(-0.01, 0.01, (60, 3))
        particles = [Particle(tuple(p), (2e-3, 1.5e-3, 1.2e-3)) for p in places]
        setup = Setup(skin=0.001)
        run(setup.with_particles(particles) + "fix motion all nve/ellipsoid\ncompute r all rdf 8\n"
            "fix a all ave/time 1 1 1 c_r[1] c_r[3] file rdf.txt mode vector\nrun 0\n")
        rows = np.array([[float(t) for t in line.split()] for line in
                         Path("rdf.txt").read_text().splitlines()[-8:]])
        distances = np.linalg.norm(places[:, None] - places[None], axis=-1)[np.triu_indices(60, 1)]
        edges = rows[:, 1] + 0.5 * (rows[1, 1] - rows[0, 1])
        # third column: neighbours per particle up to the end of the bin
        expected = [2.0 * (distances < edge).sum() / 60.0 for edge in edges]
        self.assertGreater(expected[-1], 0.0)
        np.testing.assert_allclose(rows[:, 2], expected, atol=1e-4)


class OfEach(unittest.TestCase):
    def test_energies_shifts_and_properties(self):
        x0, v, m = start()
        names = ["c_c1", "c_c2[4]", "c_c3[1]", "c_c3[2]", "c_c3[3]", "c_c4[4]"]
        c = after("compute c1 all ke/atom\ncompute c2 all displace/atom\n"
                  "compute c3 all property/atom shapex mass angmomx\ncompute c4 all property/atom x y z vz\n",
                  "each", STEPS, more=names)
        np.testing.assert_allclose(c["c_c1"], 0.5 * m * (v ** 2).sum(1), rtol=1e-9)
        np.testing.assert_allclose(c["c_c2[4]"], np.linalg.norm(v, axis=1) * STEP * STEPS, rtol=1e-6)
        np.testing.assert_allclose(c["c_c3[1]"], [p.semiaxes[0] for p in bodies()])
        np.testing.assert_allclose(c["c_c3[2]"], m)
        np.testing.assert_allclose(c["c_c3[3]"], c["angmomx"], rtol=1e-9)
        np.testing.assert_allclose(c["c_c4[4]"], v[:, 2])

    def test_neighbours_by_distance_of_centres(self):
        places = np.array([[0, 0, 0], [0.0031, 0, 0], [0, 0.0038, 0], [0.015, 0, 0], [0.0175, 0, 0]])
        particles = [Particle(tuple(p), (2e-3, 1e-3, 1.5e-3)) for p in places]
        c = after("compute c1 all cluster/atom 0.0035\ncompute c2 all coord/atom 0.0039\n"
                  "region part sphere 0 0 0 0.01 units box\n"
                  "fix t all property/atom/tracer region_mark part mark_step 0 check_mark_every 1\n"
                  "compute n all nparticles/tracer/region tracer t region_count part\n"
                  "compute s all slice 1 3 1 c_n\nthermo_style custom step c_n[1] c_n[2] c_s[1] c_s[2]", "near", 2,
                  particles=particles, more=["c_c1", "c_c2"])
        near = np.linalg.norm(places[:, None] - places[None], axis=-1)
        np.testing.assert_array_equal(c["c_c2"], (near < 0.0039).sum(1) - 1)
        self.assertEqual(c["c_c1"][0], c["c_c1"][1])
        self.assertEqual(c["c_c1"][3], c["c_c1"][4])
        self.assertEqual(len(set(c["c_c1"])), 3)
        row = thermo("log.in.near", 5)[-1]
        np.testing.assert_array_equal(row[1:], [3, 3, 3, 3])  # all, marked; both once more


class Cells(unittest.TestCase):
    """fix ave/euler in cells of upright and tilted periodic boxes, against sums over the bodies of each cell."""

    LENGTH, SIDE = 0.0125, 5

    def crowd(self):
        random = np.random.default_rng(3)
        found = []
        for cell in np.ndindex(*[self.SIDE] * 3):
            place = (np.array(cell) + 0.5 + random.uniform(-0.45, 0.45, 3)) * self.LENGTH / self.SIDE
            if cell == (2, 1, 3):
                place[0] = 0.5 * self.LENGTH  # between two ranks
            found.append(Particle(tuple(place), tuple(random.uniform(0.3e-3, 0.6e-3, 3)), quaternion_of(random.normal(size=3), 1.0),
                                  tuple(random.uniform(-1.0, 1.0, 3))))
        return found

    def test_each_body_counts_once(self):
        for tilt, ranks in (((0, 0, 0), 1), ((0, 0, 0), 2), ((4e-3, 0, 0), 1), ((2e-3, -3e-3, 1e-3), 1)):
            self.check(tilt, ranks)

    def check(self, tilt, ranks):
        setup = Setup(box=(0.0, self.LENGTH) * 3, boundary="p p p", skin=2e-4)
        script, upright = setup.with_particles(self.crowd()), not any(tilt)
        if not upright:
            text = Path("particles.data").read_text()
            Path("particles.data").write_text(text.replace("zlo zhi\n", "zlo zhi\n{} {} {} xy xz yz\n".format(*tilt)))
        columns = [1, 2, 3, 4, 5, 6, 7]
        counted, most = 0, 64
        wanted = [f"f_e[{i}][{k}]" for i in range(1, most + 1) for k in columns]
        run(script + "fix motion all nve/ellipsoid\n"
            f"fix e all ave/euler nevery 1 cell_size_relative 2.2 parallel {'no' if upright else 'yes'}\n"
            f"thermo_style custom step {' '.join(wanted)}\nthermo_modify norm no format float %.14g\n"
            + dump("cells.dump") + "run 0\n", ranks, name="in.cells")
        values = thermo("log.in.cells", 1 + len(wanted))[-1, 1:].reshape(most, len(columns))
        cells = values[np.any(values[:, :3] != 0.0, axis=1)]
        count = round(len(cells) ** (1.0 / 3.0))
        self.assertEqual(len(cells), count ** 3)
        self.assertGreater(count, 1)
        c = {k: v[-1] for k, v in read_dump("cells.dump")[1].items()}
        edges = self.LENGTH * np.eye(3) + [[0, 0, 0], [tilt[0], 0, 0], [tilt[1], tilt[2], 0]]
        share = vectors(c, "x", "y", "z") @ np.linalg.inv(edges) % 1.0
        place = np.floor(share * count).astype(int)
        volume = 4.0 / 3.0 * math.pi * c["shapex"] * c["shapey"] * c["shapez"]
        for row in cells:
            index = np.floor(row[:3] @ np.linalg.inv(edges) * count).astype(int)
            inside = (place == index).all(1)
            counted += inside.sum()
            mean = c["mass"][inside] @ vectors(c, "vx", "vy", "vz")[inside] / max(c["mass"][inside].sum(), 1e-300)
            np.testing.assert_allclose(row[3:], [volume[inside].sum() * count ** 3 / self.LENGTH ** 3, *mean], rtol=1e-9)
        self.assertEqual(counted, self.SIDE ** 3)

    def test_cells_of_one_rank_are_not_all(self):
        script = Setup(boundary="p p p").with_particles(self.crowd()) + "fix e all ave/euler nevery 1 cell_size_relative 3 "
        outcome = run(script + "parallel yes\n", 2, check=False)
        self.assertNotEqual(outcome.code, 0)
        self.assertIn("tells the cells of the first rank only; use 'parallel no'", outcome.text)
        text = Path("particles.data").read_text()
        Path("particles.data").write_text(text.replace("zlo zhi\n", "zlo zhi\n1e-3 0 0 xy xz yz\n"))
        outcome = run(script.replace("fix e", "region r block INF INF INF INF 0 1 units box\nfix e")
                      + "parallel yes basevolume_region r\n", check=False)
        self.assertNotEqual(outcome.code, 0)
        self.assertIn("leave 'basevolume_region' out", outcome.text)


class OfContacts(unittest.TestCase):
    """Stress, pressure and averages over cells, from the forces of the contact list."""

    SURFACES = {"smooth": "", "multisphere": "fix n all property/atom subspheres scalar yes yes no 7\n"}

    def cluster(self):
        random = np.random.default_rng(8)
        return [Particle((0.0045 * i, 0.0028 * j, 0.0028 * k), (2.7e-3, 1.5e-3, 1.5e-3),
                         quaternion_of(random.normal(size=3), 0.2),
                         tuple(random.normal(0.0, 0.05, 3)))
                for i in range(2) for j in range(2) for k in range(2)]

    def test_stress_pressure_and_cells(self):
        for surface, properties in self.SURFACES.items():
            for ranks in (1, 2):
                self.check(surface, properties, ranks)

    def check(self, surface, properties, ranks):
        setup = Setup(box=(-0.01, 0.015, -0.01, 0.015, -0.01, 0.015), time_step=1e-6,
                      pair=f"gran/ellipsoid {LAW} surface {surface}")
        names = [f"c_s[{k}]" for k in range(1, 7)]
        cells = [f"f_e[1][{k}]" for k in [*range(4, 8), *range(9, 15)]]
        run(setup.with_particles(self.cluster()) + properties + f"""fix motion all nve/ellipsoid
compute s all stress/atom
compute p all pressure thermo_temp
compute l all pair/ellipsoid/local id pos force
dump l all local 1 contacts.*.dump c_l[1] c_l[2] c_l[3] c_l[4] c_l[5] c_l[6] c_l[7] c_l[8] c_l[9] c_l[10] c_l[11]
dump_modify l format "%g %g %.15g %.15g %.15g %.15g %.15g %.15g %.15g %.15g %.15g"
fix e all ave/euler nevery 1 cell_size_relative 100 parallel no
thermo_style custom step c_p {' '.join(f'c_p[{k}]' for k in range(1, 7))} {' '.join(cells)}
thermo_modify norm no format float %.14g
dump s all custom 3 stress.*.dump {' '.join([*COLUMNS, *names])}
dump_modify s sort id format "%d %d{' %.17g' * (len(COLUMNS) + len(names) - 2)}"
run 3
""", ranks, name="in.stress")
        c = read_columns("stress.3", names)
        table = np.loadtxt("contacts.3.dump", skiprows=9, ndmin=2)
        self.assertGreater(len(table), 8)
        count = len(self.cluster())
        tensor = np.zeros((count, 3, 3))
        for row in table:
            arm, force = row[2:5] - row[5:8], row[8:11]
            for particle in row[:2].astype(int) - 1:
                tensor[particle] -= 0.5 * np.outer(arm, force)
        v = vectors(c, "vx", "vy", "vz")
        tensor -= c["mass"][:, None, None] * v[:, :, None] * v[:, None, :]
        places = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)]
        expected = np.stack([tensor[:, a, b] for a, b in places], -1)
        np.testing.assert_allclose(vectors(c, *names), expected, rtol=1e-7, atol=1e-9 * np.abs(expected).max())
        row = thermo("log.in.stress", 18)[-1, 1:]
        total = -tensor.sum(0) / 0.025 ** 3
        np.testing.assert_allclose(row[1:7], [total[a, b] for a, b in places], rtol=1e-6,
                                   atol=1e-8 * np.abs(total).max())
        volume = sum(4.0 / 3.0 * math.pi * np.prod(p.semiaxes) for p in self.cluster())
        mean = c["mass"] @ v / c["mass"].sum()
        np.testing.assert_allclose(row[7:11], [volume / 0.025 ** 3, *mean], rtol=1e-6)
        flown = c["mass"].sum() * np.outer(mean, mean)  # the cell's own motion is no stress
        inside = (tensor.sum(0) + flown) / 0.025 ** 3
        np.testing.assert_allclose(row[11:], [inside[a, b] for a, b in places], rtol=1e-6,
                                   atol=1e-8 * np.abs(total).max())


class Regions(unittest.TestCase):
    def test_centres_in_regions(self):
        """Groups by region hold the bodies whose centres lie inside."""
        x, _, _ = start()
        r = np.linalg.norm(x, axis=1)
        cylinder = np.hypot(x[:, 0], x[:, 1])
        inside = {"block -0.02 0.02 -0.02 0.02 0 0.02": x[:, 2] > 0,
                  "sphere 0 0 0 0.008": r < 0.008,
                  "cylinder z 0 0 0.008 -0.05 0.05": cylinder < 0.008,
                  "cone z 0 0 0.02 0.001 -0.05 0.05": cylinder < 0.02 + (x[:, 2] + 0.05) / 0.1 * -0.019,
                  "plane 0 0 0 1 1 0": x[:, 0] + x[:, 1] > 0,
                  "prism -0.02 0.02 -0.02 0.02 0 0.02 0 0 0": x[:, 2] > 0}
        commands = "".join(f"region r{k} {words} units box\ngroup g{k} region r{k}\n"
                           for k, words in enumerate(inside))
        commands += ("region both intersect 2 r0 r1\nregion any union 2 r0 r1\ngroup g6 region both\n"
                     "group g7 region any\n")
        expected = list(inside.values())
        expected += [expected[0] & expected[1], expected[0] | expected[1]]
        counts = [f"v_n{k}" for k in range(8)]
        commands += "".join(f"variable n{k} equal count(g{k})\n" for k in range(8))
        found = values(commands, counts, "regions", 0)
        np.testing.assert_array_equal(found, [e.sum() for e in expected])
        self.assertTrue(any(0 < e.sum() < 3 for e in expected))


if __name__ == "__main__":
    unittest.main(verbosity=2)
