"""The inputs that are there to be copied, in their short forms, on one and two ranks, with both surfaces: each shows what its header says, and nothing is lost, created or pressed into each other."""

import math
import os
import subprocess
import unittest
from pathlib import Path

import numpy as np

from _contact_geometry import contact
from _engine import SLOWNESS, kinetic_energy, read_dump, run_example
from _examples import GRAVITY, SINK, frame, frames, lowest_points, potential_energy, total_energy
from _overlaps import scales, shape_squares, touching

ONE_VOLUME = 4.0 / 3.0 * math.pi * 1.5e-9  # of a particle of inputs/compression.in, m3


class Compression(unittest.TestCase):
    """Uniaxial compression of a periodic box: columns strain, stresses x y z, contacts, energy, density."""

    STRAIN, BACK = 0.12, 0.01
    MODULUS, POISSON = 5e6, 0.2

    def stresses(self, name, ranks, **changes):
        run_example("compression", {"particles": 60, "out": name, "rate": 2.0, **changes}, ranks)
        return np.loadtxt(f"{name}/stress_strain.txt"), read_dump(f"{name}/compression.dump")[1]

    def check(self, name, ranks, **changes):
        table, columns = self.stresses(name, ranks, **changes)
        strain, sx, sy, sz = table[:, :4].T
        top = int(strain.argmax())
        lateral = 0.5 * (sx[top] + sy[top]) / sz[top]
        print(f"{name}, {ranks} ranks: axial stress {sz[top]:.0f} Pa at a strain of {strain[top]:.3f}, "
              f"lateral to axial {lateral:.2f}, contacts {table[top, 4]:.2f}")
        self.assertAlmostEqual(strain[top], self.STRAIN, delta=0.005)
        number = columns["id"].shape[1]
        self.assertTrue(50 <= number <= 60)  # the host's insertion finds no room for a few
        self.assertTrue(np.allclose(columns["mass"], 2500 * ONE_VOLUME, rtol=1e-6))
        self.assertAlmostEqual(table[top, 6] * (1.0 - strain[top]), 0.58, delta=1e-6)
        return strain, sx, sy, sz, table, top, lateral, number

    def check_stress(self, name, ranks, **changes):
        strain, sx, sy, sz, table, top, lateral, number = self.check(name, ranks, **changes)
        # small samples of frictional grains: at rest 0.4 to 0.8, alike in both directions
        self.assertTrue(0.35 < lateral < 0.85)
        self.assertAlmostEqual(sx[top] / sy[top], 1.0, delta=0.35)
        # no packing is stiffer than the solid its particles are made of (P-wave modulus)
        nu = self.POISSON
        solid = self.MODULUS * (1 - nu) / ((1 + nu) * (1 - 2 * nu))
        self.assertTrue((sz[:top] < solid * strain[:top]).all())
        # stiffens: the stress rises faster than linearly once the particles are jammed
        jammed = np.searchsorted(sz[:top], 0.02 * sz[top])
        middle = (jammed + top) // 2
        self.assertLess(sz[middle], 0.5 * (sz[jammed] + sz[top]))
        # dissipation: on the way back the stress is below that of the way there
        back = strain[top:]
        forth = np.interp(back, strain[:top + 1], sz[:top + 1])
        self.assertTrue((sz[top + 1:] < forth[1:]).all())
        # slow: the particles' motion holds little of the work done on the box
        volume = number * ONE_VOLUME / 0.58
        work = np.trapezoid if hasattr(np, "trapezoid") else np.trapz
        self.assertLess(table[top, 5], 0.05 * volume * work(sz[:top], strain[:top]))

    def test_smooth_on_two_ranks(self):
        self.check_stress("smooth", 2)

    def test_multisphere_on_one_rank(self):
        self.check_stress("multisphere", 1, surface="multisphere", subspheres=5)

    def test_stress_from_the_contacts_of_the_last_frame(self):
        # without friction and nearly at rest the stress is the sum of Hertz's forces times the lines
        # of centres, over the volume; contacts and curvatures by another formulation
        table, columns = self.stresses("frictionless", 1, mu=0, rate=0.5, strain=0.21,
                                       back=self.BACK)
        side = (columns["id"].shape[1] * ONE_VOLUME / 0.58) ** (1.0 / 3.0)
        periods = np.array([side, side, side * (1.0 - 0.21 + self.BACK)])
        shapes = np.linalg.inv(shape_squares(columns))
        place = np.stack([columns[n][0] for n in "xyz"], axis=1)
        effective = self.MODULUS / (2.0 * (1.0 - self.POISSON ** 2))
        stress = np.zeros((3, 3))
        for i, j in touching(columns, periods):
            line = place[j] - place[i]
            line -= periods * np.round(line / periods)
            normal, overlap, _, radius = contact(shapes[i], shapes[j], line)
            force = 4.0 / 3.0 * effective * math.sqrt(radius) * overlap ** 1.5
            stress += force * np.outer(normal, line) / periods.prod()
        deviation = np.diag(stress) / table[-1, 1:4] - 1.0
        print(f"stress of the engine {table[-1, 1:4]} Pa, again from the contacts: {deviation} relative")
        # viscous forces at this rate are 1 % of the elastic ones at most
        self.assertLess(np.abs(deviation).max(), 0.02)


class Restart(unittest.TestCase):
    def check(self, name, ranks, **changes):
        ends = []
        for out, parts in ((f"{name}_once", ["both"]), (f"{name}_twice", ["first", "second"])):
            for part in parts:
                run_example("restart", {"half": 9000, "steps": 12000, "part": part, "out": out,
                                        **changes}, ranks)
            ends.append(Path(f"{out}/end.dump").read_bytes())
        self.assertEqual(ends[0], ends[1], "the run in two parts ends elsewhere")
        columns = read_dump(f"{name}_once/end.dump")[1]
        self.assertEqual(columns["id"].shape[1], 60)
        pairs, factors = scales(columns, 3 * [math.inf])
        print(f"{name}: the same on {ranks} ranks; {int((factors < 1.0).sum())} pairs touch")
        self.assertGreater((factors < 1.0).sum(), 5)
        self.assertGreater(lowest_points(columns).min(), -SINK[changes.get("surface", "smooth")])

    def test_smooth_on_one_rank(self):
        self.check("smooth_restart", 1)

    def test_multisphere_on_two_ranks(self):
        self.check("multisphere_restart", 2, surface="multisphere")


class Mixture(unittest.TestCase):
    PARTICLES = 60

    def check(self, name, ranks, kinds, least=0.99, **changes):
        run_example("mixture", {"particles": self.PARTICLES, "time": 0.5, "dump_time": 0.05,
                                "out": name, **changes}, ranks)
        columns = frames(f"{name}/mixture.*.dump")
        first, last = frame(columns, 0), frame(columns, -1)
        self.assertTrue((columns["id"] == columns["id"][0]).all() and
                        (columns["mass"] == columns["mass"][0]).all(), "particles or masses change")
        self.assertEqual(len(last["id"][0]), self.PARTICLES)
        masses = {k: last["mass"][0][last["type"][0] == k].sum() for k in (1, 2)}
        one_large = last["mass"][0].max()
        self.assertAlmostEqual(masses[1], masses[2], delta=2.0 * one_large)
        for kind, axes in kinds.items():
            found = np.stack([last[n][0] for n in ("shapex", "shapey", "shapez")], axis=1)
            self.assertTrue((found[last["type"][0] == kind] == axes).all())
        # Contacts give back at most what they have stored: weight times overlap (0.05 % of the smallest
        # semi-axis, as measured in piles).
        energy = total_energy(columns)
        stored = last["mass"].sum() * GRAVITY * 5e-4 * min(min(axes) for axes in kinds.values())
        self.assertTrue((np.diff(energy) < stored).all(), f"energy grows: {energy}")
        fall = kinetic_energy(last)[0] / (last["mass"].sum() * GRAVITY)
        pairs, factors = scales(last, (0.02, 0.02, math.inf))
        top = (last["z"][0] + np.sqrt(shape_squares(last)[:, 2, 2])).max()
        print(f"{name}, {ranks} ranks: mass of the kinds {masses[1]:.2e} and {masses[2]:.2e} kg, energy "
              f"left that of a fall by {fall:.1e} m, least factor {factors.min():.4f}, height {top:.4f} m")
        self.assertLess(fall, 1e-5)
        self.assertGreater(factors.min(), least)
        self.assertGreater(lowest_points(last).min(), -SINK[changes.get("surface", "smooth")])
        volume = (4 / 3 * math.pi * last["shapex"] * last["shapey"] * last["shapez"]).sum()
        self.assertTrue(0.3 < volume / (0.02 ** 2 * top) < 0.74)
        self.assertLess(potential_energy(last)[0], 0.2 * potential_energy(first)[0])

    def test_smooth_on_two_ranks(self):
        self.check("mixture", 2, {1: (3e-3, 1.5e-3, 1.5e-3), 2: (1.2e-3, 1.6e-3, 1.6e-3)})

    def test_multisphere_on_one_rank(self):
        # the spheres are inscribed: ellipsoids around them overlap before they touch
        self.check("mixture_ms", 1, {1: (3e-3, 1.5e-3, 1.5e-3), 2: (1.8e-3, 1.2e-3, 1.2e-3)},
                   surface="multisphere", least=0.9)


class Batch(unittest.TestCase):
    """The script for Slurm, run without Slurm."""

    SCRIPT = Path(os.environ["ELLIPSOID_SOURCE"]) / "inputs" / "batch_slurm.sh"

    def test_runs_a_script_on_two_ranks(self):
        done = subprocess.run(
            ["bash", self.SCRIPT, "-in", self.SCRIPT.parent / "restart.in", "-var", "part", "first",
             "-var", "particles", "10", "-var", "half", "200", "-var", "out", "batch"],
            capture_output=True, text=True, timeout=300 * SLOWNESS,
            env={**os.environ, "SLURM_NTASKS": "2", "SLURM_SUBMIT_DIR": os.getcwd()})
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("on 2 procs", done.stdout)
        self.assertTrue(Path("batch/restart.half").stat().st_size > 0)

    def test_says_what_is_missing(self):
        done = subprocess.run(["bash", self.SCRIPT], capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 2)
        self.assertIn("its arguments", done.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)
