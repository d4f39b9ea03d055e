"""Linear spring and dashpot (model hooke/viscous) against the damped oscillator in closed form.

With the reduced mass m, a head-on impact at speed v is m h'' = -k h - eta m h':
  h = v/w exp(-eta t/2) sin(w t),  w = sqrt(k/m - eta^2/4),
so that it lasts pi/w, the speed after it is v exp(-pi eta/(2 w)), and the largest overlap is reached at
w t = atan2(w, eta/2).
"""

import math
import re
import unittest
from pathlib import Path

import numpy as np

from _engine import Particle, Setup, dump, read_dump, run

LAW = "model hooke/viscous tangential history/viscous"
SPEED, STEPS_PER_CONTACT, STIFFNESS = 0.2, 4000, 5e3
AXES = (2.7e-3, 1.8e-3, 1.2e-3)


def with_springs(script, normal=STIFFNESS, tangential=4e3):
    """The script with the springs of the law before its pair_style."""
    lines = "".join(f"fix {name} all property/global {name} peratomtypepair 1 {value!r}\n" for name, value in
                    (("springStiffnessNormal", normal), ("springStiffnessTangential", tangential)))
    return script.replace("pair_style", lines + "pair_style", 1)


def oscillator(mass, damping):
    """Frequency (1/s), contact time (s), restitution and largest overlap (m)."""
    frequency = math.sqrt(STIFFNESS / mass - 0.25 * damping ** 2)
    top = math.atan2(frequency, 0.5 * damping) / frequency
    return (math.pi / frequency, math.exp(-0.5 * math.pi * damping / frequency),
            SPEED / frequency * math.exp(-0.5 * damping * top) * math.sin(frequency * top))


def collide(name, damping, surface="smooth", axes=AXES, sub=""):
    """Overlaps (F,), velocities along x (F, 2) and the time step of an impact along x, tip to tip."""
    setup = Setup(damping_normal=damping, pair=f"gran/ellipsoid {LAW} surface {surface}")
    gap = 2e-7
    i = Particle((0.0, 0.0, 0.0), axes, velocity=(0.5 * SPEED, 0.0, 0.0))
    j = Particle((2.0 * axes[0] + gap, 0.0, 0.0), axes, velocity=(-0.5 * SPEED, 0.0, 0.0))
    duration, _, _ = oscillator(0.5 * i.mass, damping)
    setup.time_step = duration / STEPS_PER_CONTACT
    steps = int(1.1 * STEPS_PER_CONTACT + gap / SPEED / setup.time_step)
    script = with_springs(setup.with_particles([i, j], f"{name}.data")) + sub
    run(script + "fix motion all nve/ellipsoid\n" + dump(f"{name}.dump") + f"run {steps}\n",
        name=f"in.{name}")
    _, columns = read_dump(Path(f"{name}.dump"))
    return 2.0 * axes[0] - (columns["x"][:, 1] - columns["x"][:, 0]), columns["vx"], setup.time_step, 0.5 * i.mass


class HookeCollision(unittest.TestCase):
    def check(self, name, damping, **particles):
        overlap, velocity, step, mass = collide(name, damping, **particles)
        duration, restitution, largest = oscillator(mass, damping)
        inside = np.flatnonzero(overlap > 0.0)
        first, last = inside[0], inside[-1]
        begin = first - overlap[first] / (overlap[first] - overlap[first - 1])
        end = last + overlap[last] / (overlap[last] - overlap[last + 1])
        measured = ((end - begin) * step / duration,
                    (velocity[-1, 1] - velocity[-1, 0]) / (SPEED * restitution), overlap.max() / largest)
        print(f"{name}: contact time, restitution, overlap over the closed form: "
              + " ".join(f"{m:.8f}" for m in measured))
        # first order in the time step where damping acts: 4000 steps per contact
        for value in measured:
            self.assertAlmostEqual(value, 1.0, delta=1e-6 if damping == 0.0 else 2e-3)

    def test_without_damping(self):
        self.check("elastic", 0.0)

    def test_with_damping(self):
        self.check("damped", 1000.0)

    def test_multisphere(self):
        self.check("tip_spheres", 1000.0, surface="multisphere", axes=(2.7e-3, 1.15e-3, 1.15e-3),
                   sub="neigh_modify page 1000000\n"
                       "fix subspheres all property/atom subspheres scalar yes yes no 3\n")

    def test_runs_in_batches(self):
        setup = Setup(pair=f"gran/ellipsoid {LAW} surface smooth")
        pair = [Particle((0.0, 0.0, 0.0), AXES), Particle((0.02, 0.0, 0.0), AXES)]
        script = with_springs(setup.with_particles(pair, "far.data")) + "fix motion all nve/ellipsoid\nrun 1\n"
        self.assertIn("forces of contacts are computed in batches", run(script, name="in.far").text)

    def test_springs_out_of_range(self):
        for name, value, allowed in (("springStiffnessNormal", 0.0, "> 0"), ("springStiffnessNormal", -1.0, "> 0"),
                                     ("springStiffnessTangential", -1.0, ">= 0")):
            setup = Setup(pair=f"gran/ellipsoid {LAW} surface smooth")
            springs = {"normal": value} if name.endswith("Normal") else {"tangential": value}
            pair = [Particle((0.0, 0.0, 0.0), AXES), Particle((0.02, 0.0, 0.0), AXES)]
            script = with_springs(setup.with_particles(pair, "far.data"), **springs) + "run 0\n"
            outcome = run(script, check=False, name="in.refused")
            self.assertNotEqual(outcome.code, 0)
            self.assertRegex(outcome.text, rf"{name} for types 1 and 1 is {re.escape(f'{value:g}')}")
            self.assertIn(f"needs finite values {allowed} (force/length)", outcome.text)


if __name__ == "__main__":
    unittest.main(verbosity=2)
