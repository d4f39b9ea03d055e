"""compute coordination/ellipsoid and erotate/ellipsoid on a crowd of touching particles.

Oracles: contacts of multi-spheres by brute force over all spheres of all pairs and periodic images;
of smooth ellipsoids the contact list, which contact_list.py tests; rotational energy from angular
velocities in the space frame.
"""

import itertools
import unittest

import numpy as np

from _contact_rows import (HEIGHT, PAIR_COLUMNS, WALL_COLUMNS, WIDTH, crowd, crowd_setup,
                           floor_and_lid, lists, named, read_rows, refusal)
from _engine import COLUMNS, Setup, dump, read_dump, run, thermo, vectors
from _multisphere import pair_contacts, subspheres, wall_contacts

AXES, SPHERES = (2.5e-3, 1.7e-3, 1.7e-3), 7
STEPS = 5
COUNTS = [f"c_count[{k}]" for k in (1, 2, 3)]


def simulate(surface, ranks, more=""):
    """Counts (frames, particles, 3), all columns of the particles, and the thermo table."""
    name = f"{surface}.{ranks}"
    settings = surface + (" contacts 16" if surface == "multisphere" else "")
    script = crowd_setup(settings).with_particles(crowd(AXES), f"{name}.data")
    script += "neigh_modify page 1000000\n"
    if surface == "multisphere":
        script += subspheres(SPHERES)
    script += floor_and_lid(settings) + "fix motion all nve/ellipsoid\n" + lists(name, STEPS) + f"""
compute count all coordination/ellipsoid
compute spin all erotate/ellipsoid
group some id <= 10
compute spin10 some erotate/ellipsoid
compute count10 some coordination/ellipsoid
compute pairs all contacts/ellipsoid
compute sums all reduce sum c_count[1] c_count[2] c_count[3] c_count10[1]
thermo_style custom step c_spin c_spin10 c_pairs[1] c_pairs[2] c_sums[1] c_sums[2] c_sums[3] c_sums[4]
thermo_modify format float %.16g norm no
thermo {STEPS}
{more}"""
    run(script + dump(f"{name}.dump", STEPS, COLUMNS + COUNTS) + f"run {STEPS}\n", ranks,
        name=f"in.{name}")
    _, columns = read_dump(f"{name}.dump")
    return vectors(columns, *COUNTS), columns, thermo(f"log.in.{name}")[-2:]


def listed(name, step, particles):
    """Counts (particles, 3) by the contact list."""
    counts = np.zeros((particles, 3))
    pairs = named(read_rows(f"{name}.pairs")[step], PAIR_COLUMNS)
    touching = set(zip(pairs["id_1"], pairs["id_2"]))
    for column, rows in ((0, touching), (1, list(zip(pairs["id_1"], pairs["id_2"])))):
        for i in itertools.chain(*rows):
            counts[int(i) - 1, column] += 1
    for i in named(read_rows(f"{name}.walls")[step], WALL_COLUMNS)["id"]:
        counts[int(i) - 1, 2] += 1
    return counts


def brute_force(particles):
    """Counts (particles, 3) of multi-spheres from all pairs of spheres and all images."""
    counts = np.zeros((len(particles), 3))
    shifts = [np.array([dx, dy, 0.0]) * WIDTH for dx in (-1, 0, 1) for dy in (-1, 0, 1)]
    for (a, i), (b, j) in itertools.combinations(enumerate(particles), 2):
        place = np.array(j.position)
        for shift in shifts:
            if np.linalg.norm(place + shift - i.position) > 2 * AXES[0]:
                continue
            j.position = tuple(place + shift)
            contacts = len(pair_contacts(i, j, SPHERES, SPHERES))
            for k in a, b:
                counts[k, :2] += (contacts > 0, contacts)
        j.position = tuple(place)
    for k, p in enumerate(particles):
        for height, side in (0.0, -1.0), (HEIGHT, 1.0):
            counts[k, 2] += len(wall_contacts(p, SPHERES, (0, 0, height), (0, 0, side)))
    return counts


class Coordination(unittest.TestCase):
    def test_counts_and_energies(self):
        for surface in "smooth", "multisphere":
            for ranks in 1, 2, 4:
                counts, columns, table = simulate(surface, ranks)
                for frame, step in enumerate((0, STEPS)):
                    expected = listed(f"{surface}.{ranks}", step, counts.shape[1])
                    np.testing.assert_array_equal(counts[frame], expected)
                    # c_pairs: [1] touching pairs, [2] contacts
                    np.testing.assert_array_equal(table[frame, 3:5], 0.5 * expected[:, :2].sum(axis=0))
                    np.testing.assert_array_equal(table[frame, 5:8], expected.sum(axis=0))
                    self.assertEqual(table[frame, 8], expected[:10, 0].sum())
                    for column, members in (1, slice(None)), (2, slice(0, 10)):
                        energy = self.rotational_energy(columns, frame, members)
                        self.assertAlmostEqual(table[frame, column] / energy, 1.0, delta=1e-13)
            print(f"{surface}: {counts[-1].sum(axis=0)} touching particles, contacts, wall contacts")
        np.testing.assert_array_equal(counts[0], brute_force(crowd(AXES)))
        self.assertGreater(counts[0, :, 1].sum(), counts[0, :, 0].sum())

    @staticmethod
    def rotational_energy(columns, frame, members):
        """omega^T I omega / 2 of homogeneous prolate spheroids: I = I_2 + (I_1 - I_2) e e^T."""
        c = {n: v[frame, members] for n, v in columns.items()}
        w, x, y, z = (c[f"quat{k}"] for k in (1, 2, 3, 4))
        axis = np.stack([1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)], axis=-1)
        omega = vectors(c, "omegax", "omegay", "omegaz")
        a, b = c["shapex"], c["shapey"]
        along, across = 0.4 * c["mass"] * b * b, 0.2 * c["mass"] * (a * a + b * b)
        squared, projected = (omega ** 2).sum(axis=-1), (omega * axis).sum(axis=-1)
        return 0.5 * (across * squared + (along - across) * projected ** 2).sum()


class WrongUse(unittest.TestCase):
    def refused(self, commands, *words, **setup):
        line = refusal(commands, Setup(**setup))
        for word in words:
            self.assertIn(word, line)

    def test_wrong_use_is_refused(self):
        for style in "coordination/ellipsoid", "erotate/ellipsoid":
            self.refused(f"compute c all {style} 3\n", style, "no arguments", "remove")
        self.refused("compute c all coordination/ellipsoid\n", "pair_style gran does not work",
                     "gran/ellipsoid", pair="gran model hertz surface superquadric")
        self.refused("compute c all erotate/ellipsoid\n", "erotate/ellipsoid",
                     "granular/ellipsoid", pair="gran model hertz", atom_style="sphere")


if __name__ == "__main__":
    unittest.main(verbosity=2)
