"""Homogeneous shear of spheroids by inputs/shear.in: what it prints is what its particles do, the flow is homogeneous, the
height follows the pressure, and shape acts as published.

Oracles: velocities, volumes and orientations of the dumps, by NumPy. Published (Bilotto, Trulsson, Molinari,
arXiv 2507.04429, made with LIGGGHTS's superquadrics): spheroids align with the flow, lentils as well as rice, the more the
further they are from spheres. That paper prints friction and solid fraction in figures only; here they are held to what
holds for spheres of this friction in any dense flow (da Cruz et al., Phys. Rev. E 72, 021309, 2005; Azema and Radjai, Phys.
Rev. Lett. 112, 078001, 2014): 0.3 to 0.7, 0.5 to 0.65.

ELLIPSOID_SHEAR_FULL=1: 800 particles, a strain of 12, aspect 0.33 to 3 and three inertial numbers, as a table.
"""

import os
import unittest
from pathlib import Path

import numpy as np

from _engine import read_dump, rotation, run_example, vectors

FULL = bool(os.environ.get("ELLIPSOID_SHEAR_FULL"))
ASPECTS = (0.33, 0.5, 1.0001, 2.0, 3.0) if FULL else (0.4, 1.0001, 2.5)
INERTIAL = (0.01, 0.03, 0.1) if FULL else (0.2,)
PARTICLES, STRAIN = 800 if FULL else 160, 12.0
#: Student's t of 99.9 % for the mean of six values, one for each strain of 1 of the second half
STUDENT = 6.87
PRESSURE, RADIUS, DENSITY = 50.0, 1e-3, 1000.0
COLUMNS = "strain friction fraction normal pressure inertial contacts".split()


def cell(file):
    """Sides (3,) and tilt xy of the box of a dump, m."""
    lines = Path(file).read_text().splitlines()
    assert "xy" in lines[4], lines[4]
    rows = np.array([[float(t) for t in line.split()] for line in lines[5:8]])
    tilt = rows[0, 2]
    width = rows[0, 1] - rows[0, 0] - abs(tilt)  # bounds hold the tilted box
    return np.array([width, rows[1, 1] - rows[1, 0], rows[2, 1] - rows[2, 0]]), tilt


def order_and_angle(columns, aspect):
    """Largest eigenvalue of the nematic tensor of the symmetry axes, and the angle in degrees of its director from the
    flow in the plane of the shear."""
    quaternions = vectors(columns, *(f"quat{k}" for k in (1, 2, 3, 4)))[0]
    axes = np.stack([rotation(q)[:, 0] for q in quaternions])
    tensor = 1.5 * np.einsum("ni,nj->ij", axes, axes) / len(axes) - 0.5 * np.eye(3)
    values, directors = np.linalg.eigh(tensor)
    x, y, _ = directors[:, -1]
    return values[-1], np.degrees(np.arctan2(y, x)) % 180.0


def shear(aspect, inertial):
    """Means over the second half of the strain; checks each of the last frames."""
    out = f"shear_{aspect}_{inertial}"
    run_example("shear", {"aspect": aspect, "inertial": inertial, "particles": PARTICLES, "strain": STRAIN, "out": out},
                timeout=6000)
    table = dict(zip(COLUMNS, np.loadtxt(f"{out}/shear.txt").T))
    late = table["strain"] > 0.5 * STRAIN
    frames = sorted(Path(out).glob("shear.*.dump"))
    frames = frames[len(frames) // 2:]
    rate = inertial * np.sqrt(PRESSURE / DENSITY) / (2.0 * RADIUS)
    slopes, orders, angles, fractions = [], [], [], []
    for frame in frames:
        columns = read_dump(frame)[1]
        sides, _ = cell(frame)
        volumes = 4.0 / 3.0 * np.pi * np.prod(vectors(columns, "shapex", "shapey", "shapez")[0], axis=1)
        fractions.append(volumes.sum() / sides.prod())
        slopes.append(np.polyfit(columns["y"][0], columns["vx"][0], 1)[0] / rate)
        order, angle = order_and_angle(columns, aspect)
        orders.append(order)
        angles.append(angle)
    means = {name: values[late].mean() for name, values in table.items()}
    # the slope of so few particles wanders, for a strain of about 1 at a time
    spread = np.std(slopes, ddof=1) / np.sqrt(0.5 * STRAIN)
    return {**means, "slope": np.mean(slopes), "slope_error": spread, "S2": np.mean(orders), "angle": np.median(angles),
            "counted": np.mean(fractions), "particles": columns["id"].shape[1]}


class Shear(unittest.TestCase):
    def test_what_is_printed_and_published(self):
        found = {}
        for inertial in INERTIAL:
            for aspect in ASPECTS:
                m = found[aspect, inertial] = shear(aspect, inertial)
                print(f"| {aspect:g} | {m['inertial']:.3f} | {m['friction']:.3f} | {m['fraction']:.3f} | "
                      f"{m['contacts']:.2f} | {m['S2']:.2f} | {m['angle']:.0f} |", flush=True)
                self.assertGreaterEqual(m["particles"], 0.95 * PARTICLES)
                self.assertAlmostEqual(m["normal"] / PRESSURE, 1.0, delta=0.1)
                self.assertAlmostEqual(m["fraction"] / m["counted"], 1.0, delta=0.01)
                self.assertLess(m["slope_error"], 0.05)
                self.assertAlmostEqual(m["slope"], 1.0, delta=STUDENT * m["slope_error"])
                self.assertAlmostEqual(m["inertial"] / inertial, 1.0, delta=0.15)
                self.assertTrue(0.3 < m["friction"] < 0.7, m)
                self.assertTrue(0.5 < m["fraction"] < 0.65, m)
            for aspect in ASPECTS:
                if not 0.9 < aspect < 1.1:
                    self.assertGreater(found[aspect, inertial]["S2"], found[1.0001, inertial]["S2"] + 0.1, aspect)


if __name__ == "__main__":
    unittest.main(verbosity=2)
