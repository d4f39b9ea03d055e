"""The scripts of src_liggghts/doc/howto_convert.md: spheres, superquadrics and ellipsoids run and end at rest on the floor; what the page's tables say is what the scripts do; nothing else differs.

The superquadrics have the ellipsoids' shape. (They do not begin at the same places: overlaps of ellipsoids
are looked for between the true bodies, so that fewer tries are given up.)
"""

import os
import re
import unittest
from pathlib import Path

import numpy as np

from _engine import read_dump, run, vectors

PAGE = Path(os.environ["ELLIPSOID_SOURCE"]) / "src_liggghts" / "doc" / "howto_convert.md"
KINDS = ("spheres", "superquadrics", "ellipsoids")
LAST = 10000
PARTICLES = 50


def joined(script):
    """A script with continued lines joined and blanks made single."""
    return re.sub(r"[ \t]+", " ", re.sub(r"&\s*\n", " ", script))


def codes(cell):
    return re.findall(r"`([^`]+)`", cell)


def table_rows(page, heading):
    """Cells of the table below a heading, without its head."""
    section = page.split(f"## {heading}\n", 1)[1].split("\n## ", 1)[0]
    lines = [line for line in section.splitlines() if line.startswith("|")]
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in lines[2:]]


def read_last(kind):
    return read_dump(f"{kind}_{LAST}.dump")[1]


class ConvertScripts(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.page = PAGE.read_text()
        found = [s for s in re.findall(r"^```liggghts\n(.*?)^```", cls.page, re.MULTILINE | re.DOTALL)
                 if re.search(r"^run\s", s, re.MULTILINE)]
        cls.scripts = dict(zip(KINDS, found, strict=True))
        for kind, script in cls.scripts.items():
            run(script, name=f"in.{kind}")

    def test_tables_are_what_the_scripts_do(self):
        for label, *cells in table_rows(self.page, "Side by side"):
            for kind, cell in zip(KINDS, cells, strict=True):
                for code in codes(cell):
                    self.assertIn(code, joined(self.scripts[kind]), f"{label}, {kind}")

    def test_nothing_else_differs(self):
        # with the table's commands taken out (longest first) the rest is the same, but for the names
        rests = []
        for column, kind in enumerate(KINDS):
            rest = joined(self.scripts[kind])
            for row in table_rows(self.page, "Side by side"):
                for code in codes(row[1 + column]):
                    if row[0] == "orientation":
                        code = " orientation random"
                    self.assertIn(code, rest, f"{kind}: {row[0]}")
                    rest = rest.replace(code, "")
            rests.append(re.sub(r" +", " ", rest.replace(kind, "KIND")))
        self.assertEqual(rests[0], rests[1])
        self.assertEqual(rests[1], rests[2])

    def test_all_come_to_lie_on_the_floor(self):
        for kind in KINDS:
            columns = read_last(kind)
            self.assertEqual(columns["id"].shape[1], PARTICLES, kind)
            self.assertTrue(0.0 < columns["z"].min() and columns["z"].max() < 0.02, kind)

    def test_superquadrics_have_the_ellipsoids_shapes(self):
        shapes = [vectors(read_last(kind), "shapex", "shapey", "shapez")[0]
                  for kind in ("superquadrics", "ellipsoids")]
        np.testing.assert_allclose(shapes[0], shapes[1], rtol=1e-5)  # digits of the dump

    def changed(self, heading, name):
        """Runs the ellipsoid script with the changes of a two-column table; its last frame."""
        script = joined(self.scripts["ellipsoids"]).replace("ellipsoids_", f"{name}_")
        for old, new in table_rows(self.page, heading):
            if codes(old):
                self.assertIn(codes(old)[0], script)
                script = script.replace(codes(old)[0], codes(new)[0])
            else:
                script = script.replace("pair_style", codes(new)[0] + "\npair_style")
        run(script, name=f"in.{name}")
        columns = read_last(name)
        self.assertEqual(columns["id"].shape[1], PARTICLES)
        self.assertTrue(0.0 < columns["z"].min() and columns["z"].max() < 0.02)

    def test_chains_of_spheres(self):
        self.changed("Chains of spheres instead of smooth ellipsoids", "chains")

    def test_law_of_the_paper(self):
        self.changed("The paper's contact law", "paper")


if __name__ == "__main__":
    unittest.main(verbosity=2)
