"""Commands of the host whose effect on contacts of ellipsoids is shown here: `set type`, `neigh_modify exclude`,
`change_box boundary`. Forces by brute force from the positions, with the material of the types (_brute_force.py)."""

import unittest

import numpy as np

from _brute_force import REPLAYED, BruteForce, Frame, Law, Plane
from _engine import Material, Particle, Setup, dump, quaternion_of, read_dump, run, thermo, vectors

MATERIALS = [Material(183e6, 0.2), Material(60e6, 0.35)]
AXES = (3e-3, 2e-3, 1.5e-3)
FORM = " ".join("%d" if c in ("id", "type") else "%.17g" for c in REPLAYED)


def bodies(types):
    """A row of three that overlap one after the other, the first also the floor z = 0."""
    turns = [quaternion_of((1, 2, 3), angle) for angle in (0.4, 1.1, 2.0)]
    places = ((0.0, 0.0, 1.7e-3), (3.9e-3, 5e-4, 2.2e-3), (7.4e-3, 3e-4, 2.0e-3))
    return [Particle(place, AXES, turn, type=type) for place, turn, type in zip(places, turns, types)]


def script(types=(1, 1, 1), **options):
    setup = Setup(materials=MATERIALS, box=(-0.02, 0.02, -0.02, 0.02, -0.01, 0.02), **options)
    return (setup.with_particles(bodies(types)) + "fix floor all wall/gran/ellipsoid model hertz/viscous tangential "
            "history/viscous surface smooth primitive type 1 zplane 0.0\nfix motion all nve/ellipsoid\n")


def forces(text, name, steps=0):
    run(text + dump(f"{name}.dump", columns=REPLAYED) + f'dump_modify d format "{FORM}"\nrun {steps}\n', name=f"in.{name}")
    return vectors(read_dump(f"{name}.dump")[1], *REPLAYED)[-1]


def by_brute_force(values, leave_out=()):
    """Forces (N, 3) at rest; `leave_out`: pairs of ids without contact."""
    axes, mass = values[:, 16:19], values[:, 2]
    square = axes ** 2
    frame = Frame(values[:, 0].astype(int), values[:, 1].astype(int) - 1, mass,
                  0.2 * mass[:, None] * (square.sum(1)[:, None] - square), axes, values[:, 3:6], values[:, 6:9],
                  values[:, 9:12], values[:, 12:16], np.zeros(len(values), int))
    tables = [[[value] * 2] * 2 for value in (0.3, 100.0, 100.0)]
    brute = BruteForce(Law([(m.youngs_modulus, m.poissons_ratio) for m in MATERIALS], *tables, 1e-6), [np.inf] * 3,
                       [Plane((0, 0, -1), lambda time: (0, 0, 0), type=0)])
    force, _, rows, _ = brute.step(frame, 0.0, frame.v, frame.omega, advance=False)
    for pair in leave_out:
        for key, (_, _, _, f) in rows.items():
            if key[:2] == pair:
                force[pair[0] - 1] -= f
                force[pair[1] - 1] += f
    return force, len(rows)


class Commands(unittest.TestCase):
    def check(self, values, **options):
        force, contacts = by_brute_force(values, **options)
        self.assertEqual(contacts, 2)
        np.testing.assert_allclose(values[:, 19:22], force, rtol=0, atol=1e-8 * np.abs(force).max())

    def test_set_type(self):
        before = forces(script(), "types111")
        self.check(before)
        for change, types in (("set group all type 2", (2, 2, 2)), ("set atom 2 type 2", (1, 2, 1))):
            values = forces(script() + "run 0\n" + change + "\n", "set")
            np.testing.assert_array_equal(values[:, 1], types)
            self.check(values)
            self.assertGreater(np.abs(values[:, 19:22] - before[:, 19:22]).max(), 0.05 * np.abs(before[:, 19:22]).max())

    def test_exclude(self):
        """Between runs as well; walls and other pairs are as before."""
        exclude = "neigh_modify exclude type 1 2\n"
        for text in (script((1, 1, 2)) + exclude, script((1, 1, 2)) + "run 0\n" + exclude):
            self.check(forces(text, "exclude"), leave_out=[(2, 3)])
        group = "group some id 1 2\nneigh_modify exclude group some some\n"
        values = forces(script((1, 1, 2)) + "compute found all contacts/ellipsoid\ncompute near all coordination/"
                        "ellipsoid\ncompute sum all reduce sum c_near[1]\nthermo_style custom step c_found[2] c_sum\n"
                        + group, "group")
        self.check(values, leave_out=[(1, 2)])
        np.testing.assert_array_equal(thermo("log.in.group", 3)[-1][1:], [1, 2])

    def test_springs_after_delete_atoms(self):
        """It numbers the rest anew: springs stay with their contacts, as with `compress no`."""
        random = np.random.default_rng(5)
        cells = [(x, y, z) for x in range(3) for y in range(2) for z in range(2)]
        heap = [Particle(tuple(2.9e-3 * (np.array(c) + 0.5) + random.uniform(-1e-4, 1e-4, 3)), (1.6e-3, 1.4e-3, 1.5e-3),
                         quaternion_of(random.normal(size=3), 2.0), tuple(random.normal(0, 0.3, 3)),
                         tuple(random.normal(0, 100, 3))) for c in cells]
        head = (Setup(box=(0.0, 8.7e-3, 0.0, 5.8e-3, 0.0, 5.8e-3), boundary="p p p", skin=3e-4, friction=0.9)
                .with_particles(heap) + "fix motion all nve/ellipsoid\nrun 60\ngroup gone id 2 3 7\n")
        for ranks in (1, 2):
            found = {}
            for name, delete in (("kept", "compress no"), ("anew", "")):
                values = self.after_deletion(head + f"delete_atoms group gone {delete}\n", name, ranks)
                found[name] = values[np.lexsort(np.round(values[:, 3:6], 9).T)]
            largest = np.abs(found["kept"][:, 19:22]).max()
            self.assertGreater(np.abs(found["kept"][:, 0] - found["anew"][:, 0]).max(), 0)
            np.testing.assert_allclose(found["anew"][:, 3:], found["kept"][:, 3:], rtol=1e-7, atol=1e-7 * largest)

    def test_delete_atoms_overlap(self):
        """Before there are contacts it numbers the rest anew, also in a periodic box; then with `compress no` only."""
        places = [((k % 2 + 0.1) * 5e-3, (k // 2 % 2 + 0.1) * 5e-3, (k // 4 + 0.1) * 5e-3) for k in range(8)]
        twice = [Particle((x + shift, y, z - 6.0 * shift), (1.6e-3, 1.2e-3, 1.4e-3), omega=(0.0, 0.0, 10.0 + k))
                 for shift in (0.0, 1e-4) for k, (x, y, z) in enumerate(places)]
        for ranks in (1, 2):
            head = (Setup(box=(0.0, 1e-2) * 3, boundary="p p p", skin=3e-4).with_particles(twice, "twice.data")
                    + "fix motion all nve/ellipsoid\n")
            for compress, ids in (("", range(1, 9)), ("compress no", None)):
                values = self.after_deletion(head + f"delete_atoms overlap 1e-3 all all {compress}\n", "overlap", ranks)
                values = values[np.argsort(values[:, 0])]
                self.assertEqual(len(values), 8)
                if ids:
                    np.testing.assert_array_equal(values[:, 0], ids)
                away = values[:, None, 3:6] - values[None, :, 3:6]
                away = np.linalg.norm(away - 1e-2 * np.round(away / 1e-2), axis=2)
                self.assertGreater(away[~np.eye(8, dtype=bool)].min(), 4e-3)
                spins = values[:, REPLAYED.index("omegaz")]
                np.testing.assert_allclose(np.sort(spins), 10.0 + np.arange(8), rtol=1e-9)
            late = script((1, 1, 2)) + "run 1\nrun 0\ndelete_atoms overlap 1e-4 all all\n"
            outcome = run(late, ranks, check=False, name="in.late")
            self.assertEqual(outcome.code, 1)
            self.assertRegex(outcome.text, "ERROR: delete_atoms overlap [^\n]*add 'compress no'")

    @staticmethod
    def after_deletion(text, name, ranks):
        run(text + "run 1\n" + dump(f"{name}.dump", columns=REPLAYED)
            + f'dump_modify d format "{FORM}"\nrun 0\n', ranks, name=f"in.{name}")
        return vectors(read_dump(f"{name}.dump")[1], *REPLAYED)[-1]

    def test_deleting_with_old_lists(self):
        for commands in ("write_restart a.restart\ndelete_atoms group gone\n",
                         "delete_atoms group gone\ndelete_atoms group gone\n"):
            text = script() + "group gone id 3\nrun 1\n"
            outcome = run(text + commands + "run 1\n", check=False, name="in.old")
            self.assertEqual(outcome.code, 1)
            self.assertRegex(outcome.text, "ERROR: command delete_atoms: [^\n]*add 'run 0' before")
            run(text + commands.replace("\ndelete", "\nrun 0\ndelete") + "run 1\n", name="in.old")

    def test_boundaries(self):
        """A box whose walls follow the particles; a particle that would leave a fixed one stays."""
        still = forces(script(), "fixed", 50)
        moved = forces(script() + "change_box all boundary f f m units box\n", "shrunk", 50)
        np.testing.assert_allclose(moved, still, rtol=1e-9, atol=1e-15)
        fast = script() + "set atom 3 vx 400.0\nthermo_style custom step atoms xhi\nthermo_modify lost error\n"
        lost = run(fast + "run 200\n", check=False, name="in.lost")
        self.assertIn("Lost atoms", lost.text)
        for letter in "sm":
            run(fast + f"change_box all boundary {letter} f f units box\nrun 200\n", name="in.kept")
            atoms, high = thermo("log.in.kept", 3)[-1][1:]
            self.assertEqual(atoms, 3)
            self.assertGreater(high, 0.05)


if __name__ == "__main__":
    unittest.main(verbosity=2)
