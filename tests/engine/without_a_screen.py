"""Batch jobs with `-screen none`: nothing writes to a screen that is not there, and errors of one rank are told."""

import re
import subprocess
import unittest
from pathlib import Path

from _engine import LAW, LIGGGHTS, Setup
from _mesh import quad, write_stl

SCRIPT = """
fix grain all particletemplate/ellipsoid 15485863 semiaxes 2.5e-3 1e-3 1e-3 density 2500
fix mix all particledistribution/discrete 32452843 1 grain 1.0
region fill block -0.04 0.04 -0.04 0.04 0.01 0.04 units box
fix fill all insert/pack seed 32452867 distributiontemplate mix insert_every once overlapcheck yes orientation random &
    region fill particles_in_region 20
fix cad all mesh/surface file floor.stl type 1 scale 0.001 rotate axis 0 0 1 angle 10 curvature_tolerant yes
fix floor all wall/gran/ellipsoid {law} surface smooth mesh n_meshes 1 meshes cad
fix motion all nve/ellipsoid
run 20
"""
# version 5, on networks that it does not use; those of two ranks may share a line
REMARKS_OF_OPEN_MPI = re.compile("mca_btl_tcp|reachable pairing between local and remote interfaces")


def engine(script, ranks, *more):
    Path("in.quiet").write_text(script)
    command = ["mpirun", "-np", str(ranks)] if ranks > 1 else []
    return subprocess.run([*command, str(LIGGGHTS), "-in", "in.quiet", "-log", "log.quiet", *more], capture_output=True,
                          text=True, check=False, timeout=300)


class WithoutAScreen(unittest.TestCase):
    def setUp(self):
        floor = quad((-45.0, -45.0, 1.0), (45.0, -45.0, 1.0), (45.0, 45.0, 1.0), (-45.0, 45.0, 1.0))
        sliver = [[(0.0, 0.0, -40.0), (20.0, 0.0, -40.0), (40.0, 0.1, -40.0)]]  # the host has remarks on it
        write_stl("floor.stl", list(floor) + sliver)
        setup = Setup(time_step=1e-6)
        self.script = setup.without_particles() + SCRIPT.format(law=LAW)

    def test_meshes_and_insertion(self):
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                done = engine(self.script, ranks, "-screen", "none")
                told = [line for line in done.stderr.splitlines() if not REMARKS_OF_OPEN_MPI.search(line)]
                self.assertEqual((done.returncode, done.stdout, told), (0, "", []))
                self.assertIn("Loop time of", Path("log.quiet").read_text())

    def test_errors_are_told(self):
        """A row of a data file that cannot be read is an error of the rank that reads it."""
        rows = ("one row\n\n1 atoms\n1 atom types\n-0.05 0.05 xlo xhi\n-0.05 0.05 ylo yhi\n-0.05 0.05 zlo zhi\n\nAtoms\n\n"
                "1 1 0 0 0 nan 1e-3 1e-3 1 0 0 0 1e-5 1e-9 1e-9 1e-9\n")
        Path("broken.data").write_text(rows)
        script = Setup().header() + "read_data broken.data\n"
        for ranks in (1, 2):
            for screen in ("none", "screen.txt"):
                with self.subTest(ranks=ranks, screen=screen):
                    done = engine(script, ranks, "-screen", screen)
                    self.assertNotEqual(done.returncode, 0)
                    self.assertIn("Atoms section, atom 1: column", done.stderr)


if __name__ == "__main__":
    unittest.main()
