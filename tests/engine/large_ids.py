"""Ids of any size keep all their digits in lists of contacts, in the host's default format."""

import math
import unittest
from pathlib import Path

from _engine import LAW, Setup, run

IDS = (999999, 1000000, 1234567, 2147483646)


def data():
    """A row of four overlapping bodies on a floor."""
    mass = 1340.0 * 4.0 / 3.0 * math.pi * 2e-9
    rows = "\n".join(f"{i} 1 {0.0038 * k!r} 0 0.00099 0.002 0.001 0.001 1 0 0 0 {mass!r} 4e-12 1e-11 1e-11"
                     for k, i in enumerate(IDS))
    return (f"ids\n\n{len(IDS)} atoms\n1 atom types\n\n-0.05 0.05 xlo xhi\n-0.05 0.05 ylo yhi\n-0.05 0.05 zlo zhi\n\n"
            f"Atoms\n\n{rows}\n")


class LargeIds(unittest.TestCase):
    def rows(self, lines, columns):
        Path("ids.data").write_text(data())
        setup = Setup(time_step=1e-7)
        run(setup.header() + "atom_modify map hash\nread_data ids.data\n" + setup.properties()
            + f"fix floor all wall/gran/ellipsoid {LAW} surface smooth primitive type 1 zplane 0.0\n"
            "fix motion all nve/ellipsoid\n" + lines + "run 0\n", name="in.ids")
        text = Path("ids.local").read_text().split("ITEM: ENTRIES")[1].splitlines()[1:]
        return sorted(line.split()[:columns] for line in text)

    def test_pairs(self):
        found = self.rows("compute list all pair/ellipsoid/local id\n"
                          "dump l all local 1 ids.local c_list[1] c_list[2]\n", 2)
        self.assertEqual(sorted(found), sorted([str(IDS[k]), str(IDS[k + 1])] for k in range(3)))

    def test_walls_and_other_numbers(self):
        found = self.rows("compute list all wall/ellipsoid/local id delta\n"
                          "dump l all local 1 ids.local c_list[1] c_list[4]\n", 2)
        self.assertEqual(sorted(row[0] for row in found), sorted(map(str, IDS)))
        for row in found:
            self.assertAlmostEqual(float(row[1]), 1e-5, delta=1e-10)

    def test_a_given_format_is_kept(self):
        found = self.rows("compute list all pair/ellipsoid/local id\n"
                          "dump l all local 1 ids.local c_list[1] c_list[2]\ndump_modify l format \"%g %g\"\n", 2)
        self.assertIn(["1e+06", "1.23457e+06"], found)


if __name__ == "__main__":
    unittest.main(verbosity=2)
