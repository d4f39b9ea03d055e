"""inputs/compaction.in with all its shapes: the host's superquadrics, another code for the same bodies, take up the same
energy as smooth ellipsoids; multi-spheres of many spheres as well, spheres without turning.

Moments of inertia are those of homogeneous ellipsoids here, as superquadrics have them (the paper gives others).
"""

import os
import subprocess
import sys
import unittest
from pathlib import Path

import numpy as np

SOURCE = Path(os.environ["ELLIPSOID_SOURCE"])
BENCH = SOURCE / "tests" / "bench"
DURATION = 0.01  # s: a fiftieth of the paper's, so a side fifty times as fast


def start(shape):
    """Writes the initial state, and that of superquadrics beside it."""
    file = Path(f"{shape}.data")
    text = subprocess.run([sys.executable, "-B", BENCH / "start.py", "compaction", "--shape", shape], check=True,
                          capture_output=True, text=True).stdout
    if shape != "sphere":
        head, rest = text.split("\nAtoms\n\n")
        atoms, velocities = rest.split("\nVelocities\n")
        rows = []
        for words in map(str.split, atoms.strip().split("\n")):
            a, b, c, mass = (float(words[k]) for k in (5, 6, 7, 12))
            moments = (0.2 * mass * (p * p + q * q) for p, q in ((b, c), (c, a), (a, b)))
            rows.append(" ".join(words[:13] + [repr(m) for m in moments]))
        text = head + "\nAtoms\n\n" + "\n".join(rows) + "\n\nVelocities\n" + velocities
    file.write_text(text)
    if shape == "smooth":
        subprocess.run([sys.executable, "-B", BENCH / "start.py", "superquadric", file], check=True)
    return file


def energies(shape, file, **variables):
    """Kinetic energy (J) at the eleven times of the thermo output."""
    words = [str(w) for name, value in {"shape": shape, "start": file, "duration": DURATION, **variables}.items()
             for w in ("-var", name, value)]
    output = subprocess.run([Path(os.environ["ELLIPSOID_BIN"]) / "liggghts", "-in", SOURCE / "inputs" / "compaction.in",
                             "-log", f"log.{shape}", *words], check=True, capture_output=True, text=True).stdout
    steps = round(DURATION / 5e-6)
    rows = [line.split() for line in output.splitlines()]
    return np.array([float(r[2]) for r in rows if len(r) >= 4 and r[0].isdigit() and r[1][0].isdigit()
                     and int(r[0]) % (steps // 10) == 0 and abs(float(r[1]) - int(r[0]) * 5e-6) < 1e-9])


class Compaction(unittest.TestCase):
    def test_all_shapes(self):
        smooth_start = start("smooth")
        smooth = energies("smooth", smooth_start)
        self.assertEqual(len(smooth), 11)
        self.assertGreater(smooth[-1], 100.0 * smooth[0])
        superquadric = energies("superquadric", smooth_start)
        chains = energies("multisphere", start("multisphere"), subspheres=17, contacts=16)
        sphere = energies("sphere", start("sphere"))
        print("kinetic energy over that of smooth ellipsoids: superquadrics", (superquadric / smooth).round(4),
              "N = 17", (chains / smooth).round(4), "spheres", (sphere / smooth).round(2))
        # the row hits the first particles; later overlaps count, which the two codes define differently
        np.testing.assert_allclose(superquadric[:2], smooth[:2], rtol=1e-3)
        np.testing.assert_allclose(superquadric, smooth, rtol=0.08)
        np.testing.assert_allclose(chains, smooth, rtol=0.08)
        self.assertEqual(len(sphere), 11)


if __name__ == "__main__":
    unittest.main(verbosity=2)
