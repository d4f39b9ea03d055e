"""inputs/hopper.in and inputs/drum.in, in their short forms, with both surfaces: no particle gets through a mesh, the hopper empties at the rate of Beverloo's law, the drum carries its bed up to an angle of flow."""

import math
import os
import subprocess
import sys
import unittest
from pathlib import Path

import numpy as np

from _engine import kinetic_energy, run_example, thermo
from _examples import GRAVITY, SINK, frame, frames, lowest_points, surface_points, total_energy
from _overlaps import scales

MESHES = Path(os.environ["ELLIPSOID_SOURCE"]) / "inputs" / "meshes"
PARTICLES = 60
A, B, DENSITY = 2.5e-3, 1.25e-3, 2500.0
MASS = PARTICLES * DENSITY * 4.0 / 3.0 * math.pi * A * B * B
DUMP_TIME = 0.05  # s; the first frame is that of this time
SHORT = {"particles": PARTICLES, "dt": 2e-5, "meshes": MESHES}


class Meshes(unittest.TestCase):
    def test_files_are_those_of_the_script(self):
        subprocess.run([sys.executable, MESHES / "make_meshes.py"], check=True)
        names = sorted(file.name for file in MESHES.glob("*.stl"))
        self.assertEqual(sorted(str(file) for file in Path().glob("*.stl")), names)
        for name in names:
            self.assertEqual(Path(name).read_text(), (MESHES / name).read_text(), name)

    def test_fine_walls_are_closed_and_have_edges_of_the_length_asked_for(self):
        subprocess.run([sys.executable, MESHES / "make_meshes.py", "--edge", "7e-3"], check=True)
        for name, scale, area, border in (("shell", 1.0, 2.0 * math.pi * 0.1 * 0.06, 4.0 * math.pi * 0.1),
                                          ("disc", 0.1, math.pi * 0.1**2, 2.0 * math.pi * 0.1)):
            lines = Path(f"benchmark_{name}.stl").read_text().splitlines()
            corners = scale * np.array([line.split()[1:] for line in lines if line.startswith("vertex")], dtype=float)
            triangles = corners.reshape(-1, 3, 3)
            sides = triangles[:, 1:] - triangles[:, :1]
            areas = 0.5 * np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1)
            self.assertLess(abs(areas.sum() / area - 1.0), 0.002, name)
            edges = np.stack([triangles, np.roll(triangles, 1, axis=1)], axis=2).reshape(-1, 2, 3)
            lengths = np.linalg.norm(edges[:, 1] - edges[:, 0], axis=1)
            self.assertGreater(lengths.min(), 0.9 * 7e-3, name)
            self.assertLess(lengths.max(), 1.5 * 7e-3, name)
            points, numbers = np.unique(np.round(corners, 7), axis=0, return_inverse=True)
            ends = np.sort(numbers.reshape(-1, 3)[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
            edge, times = np.unique(ends, axis=0, return_counts=True)
            self.assertLessEqual(times.max(), 2, name)
            rim = np.linalg.norm(points[edge[times == 1, 0]] - points[edge[times == 1, 1]], axis=1).sum()
            self.assertLess(abs(rim / border - 1.0), 0.002, f"{name}: only its border is open")


class Hopper(unittest.TestCase):
    OUTLET, SHOULDER, FROM, TO = 0.010, 0.030, 0.018, 0.053  # radii and heights of the cone, m
    FILL = 0.25

    def check(self, name, **changes):
        run_example("hopper", {**SHORT, "flow": 0.3, "out": name, **changes})
        columns = frames(f"{name}/hopper.*.dump")
        self.assertEqual(columns["id"].shape[1], PARTICLES)
        surface = changes.get("surface", "smooth")
        self.check_filled(frame(columns, round(self.FILL / DUMP_TIME) - 1), surface)
        self.check_flow(name)
        last = frame(columns, -1)
        self.assertLess(last["z"].max(), 0.03, "the hopper is empty")
        self.assertGreater(lowest_points(last).min(), -SINK[surface])
        self.assertGreater(scales(last, 3 * [math.inf])[1].min(), 0.98 if surface == "smooth" else 0.9)
        energy = total_energy(columns)
        # nothing drives the particles; a lid that is pressed in gives back its elastic energy
        self.assertLess(np.diff(energy).max(), 1e-5 * energy[0])
        # grains that lie free still roll: nothing in this law resists that
        self.assertLess(kinetic_energy(last)[0], 0.05 * MASS * GRAVITY * self.FROM)

    def check_filled(self, columns, surface):
        """The particles rest in the hopper, on the lid."""
        points = surface_points(columns)
        radius, height = np.hypot(points[..., 0], points[..., 1]), points[..., 2]
        wall = np.interp(height, (self.FROM, self.TO), (self.OUTLET, self.SHOULDER))
        self.assertGreater(height.min(), self.FROM - SINK[surface])
        self.assertLess((radius - wall).max(), SINK[surface])
        fall = kinetic_energy(columns)[0] / (MASS * GRAVITY)
        print(f"filled: lowest point {height.min() - self.FROM:.1e} m above the lid, beyond the wall "
              f"{(radius - wall).max():.1e} m, energy that of a fall by {fall:.1e} m")
        self.assertLess(fall, 1e-3)

    def check_flow(self, name):
        """Mass flow of the middle half of the mass against Beverloo's law with its usual constants
        (Nedderman, Statics and kinematics of granular materials, 1992, eq. 10.2.7): 0.58 and 1.4."""
        rows = thermo(f"{name}/log.hopper", columns=7)
        rows = rows[rows[:, 1] > 0.0]
        time, out = rows[:, 1], rows[:, 4]
        self.assertEqual(out[time < self.FILL].max(), 0.0)
        self.assertAlmostEqual(out[-1] / MASS, 1.0, delta=1e-6)
        rises = np.concatenate([np.diff(out) > 0.0, [False]])  # rows before more has come out
        rises |= np.concatenate([[False], np.diff(out) > 0.0])
        begin, end = np.interp([0.25 * MASS, 0.75 * MASS], out[rises], time[rises])
        found = 0.5 * MASS / (end - begin)
        diameter = 2.0 * (A * B * B) ** (1.0 / 3.0)
        bulk = 0.58 * DENSITY
        beverloo = 0.58 * bulk * math.sqrt(GRAVITY) * (2.0 * self.OUTLET - 1.4 * diameter) ** 2.5
        print(f"{name}: mass flow {found:.3f} kg/s, Beverloo's law {beverloo:.3f} kg/s")
        # so few particles have no steady flow
        self.assertTrue(0.7 < found / beverloo < 1.4)

    def test_smooth(self):
        self.check("hopper")

    def test_multisphere(self):
        self.check("hopper_ms", surface="multisphere")

    def test_silo_keeps_what_lies_behind_its_outlet(self):
        run_example("hopper", {**SHORT, "flow": 0.6, "mesh": "silo.stl", "out": "silo"})
        columns = frames("silo/hopper.*.dump")
        filled = surface_points(frame(columns, round(self.FILL / DUMP_TIME) - 1))
        self.assertGreater(filled[..., 2].min(), self.FROM - SINK["smooth"])
        self.assertLess(np.hypot(filled[..., 0], filled[..., 1]).max(), self.SHOULDER + SINK["smooth"])
        last = frame(columns, -1)
        points, kept = surface_points(last), last["z"][0] > self.FROM
        print(f"silo: {kept.sum()} of {PARTICLES} stay")
        self.assertTrue(0.2 * PARTICLES < kept.sum() < 0.95 * PARTICLES)
        self.assertEqual(columns["id"].shape[1], PARTICLES)
        # those that stay lie on the flat bottom, but for what sticks out over the outlet's edge
        outside = np.hypot(points[kept, :, 0], points[kept, :, 1]) > self.OUTLET
        self.assertGreater(points[kept, :, 2][outside].min(), self.FROM - SINK["smooth"])
        self.assertGreater(lowest_points(last).min(), -SINK["smooth"])

    def test_first_moments_on_two_ranks(self):
        run_example("hopper", {**SHORT, "fill": 0.05, "flow": 0.01, "out": "hopper_two"}, 2)
        columns = frames("hopper_two/hopper.*.dump")
        self.assertGreater(columns["id"].shape[1], 0.8 * PARTICLES)  # the host finds less room
        self.assertGreater(columns["z"].min(), self.FROM)


class Drum(unittest.TestCase):
    RADIUS, HALF = 0.030, 0.010
    FILL = 0.2  # s: until then particles fall, afterwards they rest and are carried
    MODULUS = 5e6 / 2.0 / (1.0 - 0.2**2)

    def impact_depth(self, time):
        """Of a particle that has fallen for this time and meets the drum with its tip: Hertz's largest overlap,
        (15 m v^2 / (16 E* sqrt(R)))^(2/5)."""
        mass, tip = MASS / PARTICLES, B * B / A
        return (15.0 * mass * (GRAVITY * time)**2 / (16.0 * self.MODULUS * math.sqrt(tip)))**0.4

    def inside(self, name, ranks, **changes):
        """Runs the input; the frames, in which no particle reaches beyond the drum."""
        run_example("drum", {**SHORT, "turn": 0.5, "out": name, **changes}, ranks)
        columns = frames(f"{name}/drum.*.dump")
        self.assertGreater(columns["id"].shape[1], 0.8 * PARTICLES)  # the host finds less room
        for number in range(len(columns["id"])):
            points = surface_points(frame(columns, number))
            beyond = max((np.hypot(points[..., 0], points[..., 2]) - self.RADIUS).max(),
                         np.abs(points[..., 1]).max() - self.HALF)
            time = (number + 1) * DUMP_TIME
            falling = self.impact_depth(time) if time < self.FILL else 0.0
            self.assertLess(beyond, SINK[changes.get("surface", "smooth")] + falling, f"frame {number}")
        return columns

    def angle(self, columns):
        """Of the centre of mass from the vertical, positive where the drum carries it (degrees)."""
        return math.degrees(math.atan2(-columns["x"].mean(), -columns["z"].mean()))

    def check(self, name, **changes):
        columns = self.inside(name, 1, **changes)
        self.assertEqual(columns["id"].shape[1], PARTICLES)
        surface = changes.get("surface", "smooth")
        angles = [self.angle(frame(columns, number)) for number in range(len(columns["id"]))]
        print(f"{name}: angle of the centre of mass at rest {angles[3]:.1f}, then "
              + " ".join(f"{a:.1f}" for a in angles[4:]))
        self.assertLess(abs(angles[3]), 8.0)
        self.assertTrue(22.0 < np.mean(angles[-5:]) < 45.0)
        # carried with the drum, 9 degrees a frame, until it flows
        self.assertLess(np.diff(angles[3:]).max(), 1.2 * 9.0)
        self.assertGreater(scales(frame(columns, -1), 3 * [math.inf])[1].min(),
                           0.98 if surface == "smooth" else 0.9)

    def test_smooth(self):
        self.check("drum")

    def test_multisphere(self):
        self.check("drum_ms", surface="multisphere")

    def test_first_moments_on_two_ranks(self):
        self.inside("drum_two", 2, fill=0.05, turn=0.05)


if __name__ == "__main__":
    unittest.main(verbosity=2)
