"""write_data and read_data of atom_style granular/ellipsoid: every column comes back, bit for bit."""

import unittest
from pathlib import Path

import numpy as np

from _engine import COLUMNS, Particle, Setup, dump, quaternion_of, read_dump, run

MORE = COLUMNS + ["ix", "iy", "iz", "density", "radius"]


def particles():
    random = np.random.default_rng(16)
    return [Particle(tuple(random.uniform(-0.02, 0.02, 3)), tuple(random.uniform(1e-4, 3e-4, 3)),
                     quaternion_of(random.normal(size=3), random.uniform(0.0, 6.0)),
                     tuple(random.normal(size=3)), tuple(random.normal(size=3)),
                     mass=random.uniform(1e-9, 2e-9),
                     moments=tuple(1e-17 * random.uniform(1.0, 1.9, 3)), type=1 + k % 2)
            for k in range(40)]


class DataFile(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        setup = Setup(materials=[Setup().materials[0]] * 2, boundary="p p p",
                      box=(-0.021, 0.021) * 3, time_step=1e-4)
        cls.particles = particles()
        # some steps, so that particles have crossed the periodic boundary and turned
        run(setup.with_particles(cls.particles, "first.data") + dump("first.dump", columns=MORE)
            + "fix motion all nve/ellipsoid\nrun 100\nwrite_data second.data\n", name="in.write")
        for k, file in enumerate(("second.data", "third.data")):
            script = setup.header() + f"read_data {file}\n" + setup.properties()
            script += dump(f"{k}.dump", columns=MORE) + "fix motion all nve/ellipsoid\nrun 0\n"
            run(script + "write_data third.data\n", name=f"in.read{k}")

    def test_the_file_is_read_as_written_here(self):
        _, columns = read_dump(Path("first.dump"))
        first = {name: values[0] for name, values in columns.items()}
        for k, p in enumerate(self.particles):
            found = [first[n][k] for n in ("x", "y", "z", "vx", "vy", "vz", "omegax", "omegay", "omegaz",
                                           "shapex", "shapey", "shapez", "quat1", "quat2", "quat3",
                                           "quat4", "mass", "type", "radius")]
            given = [*p.position, *p.velocity, *p.omega, *p.semiaxes, *p.quaternion, p.mass, p.type,
                     max(p.semiaxes)]
            np.testing.assert_allclose(found, given, rtol=1e-15, atol=1e-300)
            volume = 4.0 / 3.0 * np.pi * np.prod(p.semiaxes)
            self.assertAlmostEqual(first["density"][k] / (p.mass / volume), 1.0, delta=1e-14)

    def test_what_was_written_is_read_back(self):
        _, written = read_dump(Path("first.dump"))
        _, read = read_dump(Path("0.dump"))
        self.assertGreater(np.abs(written["ix"][-1]).max(), 0, "nothing crossed the boundary")
        for name in MORE:
            np.testing.assert_array_equal(written[name][-1], read[name][0], err_msg=name)

    def test_moments_of_inertia_come_back(self):
        rows = self.atoms("second.data")
        for k, p in enumerate(self.particles, 1):
            np.testing.assert_array_equal([float(t) for t in rows[k][13:16]], p.moments)

    def test_sub_spheres_that_cannot_be_are_refused(self):
        """Under surface smooth as well, which does not look at them."""
        for columns, axes, pattern in (("5 3", (2e-3, 1e-3, 1e-3), "spacing is 3, which is for N = 3, and N is 5"),
                                       ("4 0", (2e-3, 1e-3, 1e-3), "N is 4, allowed are 0 and odd numbers"),
                                       ("5 1", (2e-3, 1e-3, 9e-4), "N is 5, and b and c differ; allowed is 0"),
                                       ("3 3", (2e-3, 1e-3, 1e-3), None), ("0 3", (3e-3, 2e-3, 1e-3), None)):
            script = Setup().with_particles([Particle((0, 0, 0), axes)], "chain.data") + "run 0\n"
            head, row, *rest = Path("chain.data").read_text().partition("\n1 1 ")
            row = row + rest[0].split("\n", 1)[0] + f" {columns}\n" + rest[0].split("\n", 1)[1]
            Path("chain.data").write_text(head + row)
            outcome = run(script, check=False, name="in.chain")
            self.assertEqual(outcome.code, 0 if pattern is None else 1, outcome.text[-500:])
            if pattern:
                self.assertRegex(outcome.text, f"ERROR[^\n]*Atoms section, atom 1: column {pattern}")

    def test_written_again_it_is_the_same_file(self):
        self.assertEqual(self.atoms("second.data"), self.atoms("third.data"))

    def atoms(self, file):
        """Rows of the section Atoms, {id: tokens}."""
        text = Path(file).read_text()
        section = text.split("Atoms", 1)[1].split("Velocities")[0]
        rows = [line.split() for line in section.splitlines() if line.split()]
        self.assertEqual(len(rows), len(self.particles))
        return {int(row[0]): row for row in rows}


if __name__ == "__main__":
    unittest.main(verbosity=2)
