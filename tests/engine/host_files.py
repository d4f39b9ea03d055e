"""What the host writes of ellipsoids and meshes besides its text and VTK dumps of particles (which
engine.stock_dumps has): dump xyz, mesh/stl, mesh/vtk and decomposition/vtk; and run_time and info."""

import os
import re
import unittest
from pathlib import Path

import numpy as np

from _engine import Setup, host_is_inl, run, thermo
from _spinning import MOTION, bodies

CORNERS = [(-0.01, -0.01, 0.0), (0.02, -0.01, 0.001), (-0.01, 0.02, 0.002)]


def script(commands, steps=0):
    corners = "\n".join("vertex {} {} {}".format(*c) for c in CORNERS)
    Path("cad.stl").write_text(f"solid cad\nfacet normal 0 0 1\nouter loop\n{corners}\nendloop\nendfacet\n"
                               "endsolid cad\n")
    return (Setup(time_step=1e-6).with_particles(bodies()) + MOTION
            + "fix cad all mesh/surface file cad.stl type 1\n" + commands + f"run {steps}\n")


def numbers_after(text, word, count):
    """The first `count` numbers after the line that begins with a word."""
    rest = text[text.index(word):].split("\n", 1)[1]
    return [float(t) for t in rest.split()[:count]]


def planes_between_domains(text):
    """Sets of coordinates, one for each axis; LIGGGHTS-INL writes the corners of every sub-domain."""
    if "UNSTRUCTURED_GRID" in text:
        count = int(re.search(r"POINTS (\d+)", text).group(1))
        return [set(axis) for axis in np.reshape(numbers_after(text, "POINTS", 3 * count), (count, 3)).T]
    words = ("X_COORDINATES", "Y_COORDINATES", "Z_COORDINATES")
    counts = [int(re.search(rf"{word} (\d+)", text).group(1)) for word in words]
    return [set(numbers_after(text, word, count)) for word, count in zip(words, counts)]


class Files(unittest.TestCase):
    def test_positions(self):
        run(script("dump d all xyz 1 positions.xyz\n"))
        lines = Path("positions.xyz").read_text().splitlines()
        self.assertEqual(lines[0], "3")
        found = np.array([[float(t) for t in line.split()[1:4]] for line in lines[2:5]])
        np.testing.assert_allclose(sorted(map(tuple, found)), sorted(p.position for p in bodies()), rtol=1e-5)

    def test_mesh_as_it_was_read(self):
        run(script("dump d all mesh/stl 1 mesh*.stl\n"))
        text = Path("mesh0.stl").read_text()
        found = np.array([[float(t) for t in line.split()[1:]] for line in text.splitlines()
                          if line.split()[:1] == ["vertex"]])
        np.testing.assert_allclose(found, CORNERS, atol=1e-8)

    def test_mesh_and_domains_for_vtk(self):
        text = script("dump m all mesh/vtk 1 mesh*.vtk id\ndump_modify m binary no\n"
                      "dump b all decomposition/vtk 1 boxes*.vtk\n"
                      + "dump_modify b binary no\n" * host_is_inl())
        if os.environ["ELLIPSOID_VTK"] != "1":
            outcome = run(text, check=False)
            self.assertEqual(outcome.code, 1)
            self.assertIn("Unknown dump style 'mesh/vtk'", outcome.text)
            return
        run(text, ranks=2)
        points = numbers_after(Path("mesh0.vtk").read_text(), "POINTS", 9)
        np.testing.assert_allclose(sorted(map(tuple, np.reshape(points, (3, 3)))), sorted(CORNERS), atol=1e-8)
        text = Path("boxes0.vtk").read_text()
        corners = set()
        for values in planes_between_domains(text):
            self.assertEqual((min(values), max(values)), (-0.05, 0.05))
            corners.add(len(values))
        self.assertEqual(corners, {2, 3})  # one axis is cut in the middle

    def test_run_for_a_time(self):
        run(script("run_time 4.95e-5\nthermo_style custom step time\n"))
        self.assertEqual(thermo("log.in.run", 2)[-1, 0], 50)
        text = run(script("info computes fixes\n")).text
        self.assertRegex(text, r"motion.*nve/ellipsoid")


if __name__ == "__main__":
    unittest.main(verbosity=2)
