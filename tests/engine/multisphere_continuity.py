"""What must not change a run of multi-spheres: 1, 2 or 4 ranks, rebuilds of the neighbour lists, an
interruption with a restart file in the middle of rich contact.

Two populations of different size and N rain into a box; friction springs of many sphere contacts are
loaded. The springs show in the forces: a history that is lost, exchanged between contacts or turned
round changes them by far more than rounding.
"""

import unittest
from pathlib import Path

import numpy as np

from _engine import Material, dump, run
from _multisphere import multisphere_setup, wall

DROPS, BEFORE, AFTER, EVERY = 12, 10000, 1000, 100
KINEMATIC = slice(3, 12)  # columns of positions, velocities, angular velocities


def heap(start="", ranks=1, skin=0.0006, settings="contacts 10"):
    """Script of two populations that fall into a narrow box; `start` reads a restart file."""
    grid = {1: "1 1 1", 2: "2 1 1", 4: "2 2 1"}[ranks]
    setup = multisphere_setup(settings, box=(0.0, 0.012, 0.0, 0.012, -0.001, 0.02), skin=skin,
                              boundary="m m f", time_step=5e-6, damping_normal=20000.0,
                              damping_tangential=20000.0, materials=[Material(5e6, 0.2)])
    walls = "".join(wall(name, plane, position, settings) for name, plane, position in (
        ("left", "xplane", 0.0), ("right", "xplane", 0.012), ("front", "yplane", 0.0),
        ("back", "yplane", 0.012), ("floor", "zplane", 0.0)))
    text = setup.header() + f"processors {grid}\n" + (start or setup.create_box()) + setup.properties()
    text += "fix gravity all gravity 60 vector 0.1 0 -1\n" + walls
    for k, (scale, count) in enumerate(((1.0, 5), (0.8, 25))):
        a, b = 2.7e-3 * scale, 1.15e-3 * scale
        text += f"""
fix grain{k} all particletemplate/ellipsoid {15485863 + 4 * k} semiaxes {a} {b} {b} density 1340 &
    subspheres {count}
fix drop{k} all insert/drop seed {7 + k} template grain{k} particles {DROPS} interval 2.2e-3 &
    box 0.0035 0.0085 0.0035 0.0085 0.010 0.0125 velocity 0 0 -0.8
"""
    return text + """fix motion all nve/ellipsoid
compute search all contacts/ellipsoid
thermo_style custom step atoms c_search[1] c_search[2]
thermo_modify norm no lost error
"""


def rows(file):
    """{(step, id): values} of a text dump."""
    found, lines, at = {}, Path(file).read_text().splitlines(), 0
    while at < len(lines):
        count = int(lines[at + 3])
        for line in lines[at + 9:at + 9 + count]:
            tokens = line.split()
            found[int(lines[at + 1]), int(tokens[0])] = np.array(tokens, float)
        at += 9 + count
    return found


def largest_difference(one, other):
    """Of positions over a, and of forces over the largest one."""
    assert one.keys() == other.keys(), "other particles or steps"
    x = max(np.abs(one[k][3:6] - other[k][3:6]).max() for k in one) / 2.7e-3
    largest = max(np.abs(row[12:15]).max() for row in one.values())
    return x, max(np.abs(one[k][12:15] - other[k][12:15]).max() for k in one) / largest


class Continuity(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        run(heap() + f"thermo 1000\nrun {BEFORE}\nwrite_restart half.restart\n", name="in.first")
        contacts = [line.split() for line in Path("log.in.first").read_text().splitlines()
                    if line.split()[:1] == [str(BEFORE)]][0]
        cls.pairs, cls.contacts = float(contacts[2]), float(contacts[3])
        cls.reference = cls.go_on("one")

    @staticmethod
    def go_on(name, **options):
        script = heap("read_restart half.restart\n", **options)
        run(script + "thermo 100\n" + dump(f"{name}.dump", EVERY) + f"run {AFTER}\n",
            options.get("ranks", 1), name=f"in.{name}")
        return rows(f"{name}.dump")

    def test_the_heap_is_in_rich_contact(self):
        print(f"at the interruption: {self.pairs:.0f} pairs of particles touch at {self.contacts:.0f} "
              "places")
        self.assertGreater(self.pairs, 15)
        self.assertGreater(self.contacts, 1.2 * self.pairs)
        self.assertEqual(sum(step == BEFORE for step, _ in self.reference), 2 * DROPS)

    def test_restart_goes_on_bit_for_bit(self):
        run(heap() + f"run {BEFORE}\nwrite_restart whole.restart\n" + dump("whole.dump", EVERY)
            + f"run {AFTER}\n", name="in.whole")
        whole = rows("whole.dump")
        self.assertEqual(whole.keys(), self.reference.keys())
        worst = max(np.abs(whole[k] - self.reference[k]).max() for k in whole)
        self.assertEqual(worst, 0.0)

    def test_restart_files_of_a_run_in_one_go(self):
        """At some of the interruptions a drop waits for its place, which is taken."""
        end, every = 15000, 3000
        for ranks in 1, 2:
            name = f"go{ranks}"
            restart, sample = f"restart {every} {{0}}.*.restart\n", "thermo 1000\n"
            run(heap(ranks=ranks) + sample + restart.format(name) + dump(f"{name}.dump", EVERY) + f"run {end}\n",
                ranks, name=f"in.{name}")
            whole = rows(f"{name}.dump")
            self.assertIn("it waits", Path(f"log.in.{name}").read_text())
            for step in range(every, end, every):
                with self.subTest(ranks=ranks, step=step):
                    run(heap(f"read_restart {name}.{step}.restart\n", ranks=ranks) + sample
                        + restart.format("again") + dump("again.dump", EVERY) + f"run {end} upto\n",
                        ranks, name="in.again")
                    again = rows("again.dump")
                    later = {key for key in whole if key[0] >= step}
                    self.assertEqual(later, again.keys())
                    self.assertEqual(max(np.abs(whole[k] - again[k]).max() for k in again), 0.0)

    def test_ranks(self):
        for ranks in (2, 4):
            x, force = largest_difference(self.reference, self.go_on(f"ranks{ranks}", ranks=ranks))
            print(f"{ranks} ranks: positions differ by {x:.1e} a, forces by {force:.1e}")
            self.assertLess(x, 1e-11)
            self.assertLess(force, 1e-8)

    def test_rebuilds_of_the_neighbour_lists(self):
        """A skin so small that lists are rebuilt all the time changes the order of sums only."""
        x, force = largest_difference(self.reference, self.go_on("skin", skin=2e-6))
        builds = [int(line.split("=")[1]) for name in ("one", "skin")
                  for line in Path(f"log.in.{name}").read_text().splitlines() if "list builds" in line]
        print(f"{builds[0]} and {builds[1]} rebuilds: positions differ by {x:.1e} a, forces by {force:.1e}")
        self.assertGreater(builds[1], 10 * max(1, builds[0]))
        self.assertLess(x, 1e-11)
        self.assertLess(force, 1e-8)


if __name__ == "__main__":
    unittest.main(verbosity=2)
