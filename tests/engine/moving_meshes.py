"""Every kind of motion of `fix move/mesh`: bodies that lie on a floor of triangles which moves in its own plane feel the
velocity that the motion's formula has at their contacts, in each step, against brute force (_brute_force.py). Of a
periodic box the floor leaves on one side and comes back on the other, seams and all."""

import math
import unittest
from pathlib import Path

import numpy as np

from _brute_force import REPLAYED, BruteForce, Law, Plane, replay
from _engine import LAW, Particle, Setup, dump, quaternion_of, read_dump, rotation, run, vectors
from _multisphere import subspheres

SIDE, TIME_STEP, STEPS = 0.012, 2e-6, 80
FORM = " ".join("%d" if c in ("id", "type") else "%.17g" for c in REPLAYED)
HINGE = np.array([0.5 * SIDE, 0.4 * SIDE, 0.0])
KINDS = {"smooth": ((1.2e-3, 1.5e-3, 0.9e-3), 0), "multisphere": ((1.6e-3, 0.8e-3, 0.8e-3), 5)}


def bodies(axes):
    """Across the sides of a periodic box and within, 30 micrometres deep in the floor at z = 0."""
    random, found = np.random.default_rng(3), []
    for x, y in ((1e-4, 2e-4), (0.5 * SIDE, 3e-4), (2e-4, 0.5 * SIDE), (0.55 * SIDE, 0.45 * SIDE), (0.25 * SIDE, 0.8 * SIDE)):
        q = quaternion_of(random.normal(size=3), random.uniform(0.0, 3.0)) if axes[1] > axes[0] else \
            quaternion_of((0.0, 0.0, 1.0), random.uniform(0.0, 3.0))
        r = rotation(q)
        height = math.sqrt((r @ np.diag(np.square(axes)) @ r.T)[2, 2])
        found.append(Particle((x, y, height - 3e-5), axes, q, tuple(random.normal(0.0, 0.1, 3)),
                              tuple(random.normal(0.0, 20.0, 3)), mass=2e-4))
    return found


def write_floor(low, high, count):
    """A square of 2 count^2 triangles."""
    marks = [float(x) for x in np.linspace(low, high, count + 1)]
    lines = ["solid floor"]
    for x, u in zip(marks, marks[1:]):
        for y, v in zip(marks, marks[1:]):
            for corners in (((x, y), (u, y), (u, v)), ((x, y), (u, v), (x, v))):
                lines += ["facet normal 0 0 1", "outer loop"] + [f"vertex {p!r} {q!r} 0.0" for p, q in corners]
                lines += ["endloop", "endfacet"]
    Path("floor.stl").write_text("\n".join([*lines, "endsolid floor", ""]))


def along(velocity):
    """Of all points the same; `velocity(time)` (x, y)."""
    return lambda point, time: (*velocity(time), 0.0)


def about(rate, hinge=HINGE):
    """A turn about the z axis through a point, `rate(time)` (rad/s)."""
    return lambda point, time: np.cross((0.0, 0.0, rate(time)), point - hinge)


def series(amplitudes, phases, periods):
    """Of the sum of C cos(2 pi t / P + phase)."""
    return lambda t: sum(-c * 2 * math.pi / p * math.sin(2 * math.pi * t / p + phase)
                         for c, phase, p in zip(amplitudes, phases, periods))


C, PHASES, PERIODS = (2e-4, 1e-4), (0.3, 1.1), (4e-4, 1.5e-4)
VIBRATION = (f"order 2 amplitude {{}} {{}} phase {PHASES[0]} {PHASES[1]} period {PERIODS[0]} {PERIODS[1]}")
TURN = f"origin {HINGE[0]!r} {HINGE[1]!r} 0 axis 0 0 1"
ALONG = {  # (variables, motion, velocity)
    "linear": ("", "linear 5.0 -3.0 0.0", along(lambda t: (5.0, -3.0))),
    "linear/variable": ("variable vx equal 2.0+1e4*step*dt\nvariable vy equal 1.0\nvariable vz equal 0.0\n",
                        "linear/variable v_vx v_vy v_vz", along(lambda t: (2.0 + 1e4 * t, 1.0))),
    "wiggle": ("", "wiggle amplitude 1e-4 -2e-4 0 period 3e-4",
               along(lambda t: [a * 2 * math.pi / 3e-4 * math.cos(2 * math.pi * t / 3e-4) for a in (1e-4, -2e-4)])),
    "viblin": ("", "viblin axis 0.6 0.8 0 " + VIBRATION.format(*C),
               along(lambda t: [a * series(C, PHASES, PERIODS)(t) for a in (0.6, 0.8)]))}
ABOUT = {
    "rotate": ("", f"rotate {TURN} period 0.02", about(lambda t: 2 * math.pi / 0.02)),
    "rotate/variable": ("variable w equal 100+2e6*step*dt\n", f"rotate/variable {TURN} omega v_w",
                        about(lambda t: 100.0 + 2e6 * t)),
    "riggle": ("", f"riggle {TURN} period 3e-4 amplitude 1.5",
               about(lambda t: math.radians(1.5) * 2 * math.pi / 3e-4 * math.cos(2 * math.pi * t / 3e-4))),
    "vibrot": ("", f"vibrot {TURN} " + VIBRATION.format(0.02, 0.01), about(series((0.02, 0.01), PHASES, PERIODS)))}


class MovingMeshes(unittest.TestCase):
    def check(self, kind, ranks, variables, motions, velocity, boundary):
        axes, spheres = KINDS[kind]
        surface = f"surface {kind}"
        setup = Setup(box=(0.0, SIDE, 0.0, SIDE, -0.001, 0.008), boundary=boundary, time_step=TIME_STEP, skin=4e-4,
                      friction=0.4, pair=f"gran/ellipsoid {LAW} {surface}")
        text = setup.with_particles(bodies(axes)) + (subspheres(spheres) if spheres else "") + variables
        text += ("fix cad all mesh/surface file floor.stl type 1\n"
                 f"fix w all wall/gran/ellipsoid {LAW} {surface} mesh n_meshes 1 meshes cad\n")
        text += "".join(f"fix move{k} all move/mesh mesh cad {motion}\n" for k, motion in enumerate(motions))
        run(text + "fix motion all nve/ellipsoid\n" + dump("d.dump", columns=REPLAYED)
            + f'dump_modify d format "{FORM}"\nrun {STEPS}\n', ranks, name="in.moving")
        frames = vectors(read_dump("d.dump")[1], *REPLAYED)
        periods = [SIDE if letter == "p" else np.inf for letter in boundary.split()]
        brute = BruteForce(Law([(183e6, 0.2)], [[0.4]], [[100.0]], [[100.0]], TIME_STEP), periods,
                           [Plane((0.0, 0.0, -1.0), lambda time: (0.0, 0.0, 0.0), velocity)])
        scale, touching = np.abs(frames[:, :, 19:25]).max((0, 1)), 0
        for k, (force, torque, _) in enumerate(replay(brute, frames, TIME_STEP, spheres)):
            touching += len(brute.springs)
            for found, expected, size in ((frames[k][:, 19:22], force, scale[:3].max()),
                                          (frames[k][:, 22:25], torque, scale[3:].max())):
                np.testing.assert_allclose(found, expected, rtol=0, atol=1e-9 * size, err_msg=f"{motions}, step {k}")
        self.assertGreater(touching, 3 * STEPS)

    def test_along_and_through_the_sides_of_a_periodic_box(self):
        for number, (name, (variables, motion, velocity)) in enumerate(ALONG.items()):
            write_floor(0.0, SIDE, 1 + 3 * (number % 2))
            for kind in KINDS:
                with self.subTest(motion=name, kind=kind):
                    self.check(kind, 1 + (number + (kind == "smooth")) % 2, variables, [motion], velocity, "p p f")

    def test_about_an_axis(self):
        write_floor(-0.5 * SIDE, 1.5 * SIDE, 2)
        for number, (name, (variables, motion, velocity)) in enumerate(ABOUT.items()):
            for kind in KINDS:
                with self.subTest(motion=name, kind=kind):
                    self.check(kind, 1 + (number + (kind == "smooth")) % 2, variables, [motion], velocity, "m m f")

    def test_two_motions_of_one_mesh(self):
        """The hinge of the second one moves with the mesh."""
        write_floor(-0.5 * SIDE, 1.5 * SIDE, 1)
        for kind in KINDS:
            def both(point, time):
                hinge = HINGE + (4.0 * time, 2.0 * time, 0.0)
                return np.array((4.0, 2.0, 0.0)) + np.cross((0.0, 0.0, 2 * math.pi / 0.02), point - hinge)
            self.check(kind, 1, "", ["linear 4 2 0", f"rotate {TURN} period 0.02"], both, "m m f")

    def test_motions_that_cannot_be(self):
        write_floor(0.0, SIDE, 1)
        start = Setup(box=(0.0, SIDE, 0.0, SIDE, -0.001, 0.008)).with_particles(bodies(KINDS["smooth"][0]))
        start += "fix cad all mesh/surface file floor.stl type 1\nfix turn all move/mesh mesh cad "
        for motion, message in (
                ("viblin axis 0 0 1 order 2 amplitude 1e-4 1e-4 phase 0 0 period 0.02", "'period' has 1 numbers, 'order' allows 2"),
                (f"vibrot {TURN} order 3 amplitude 1e-4 1e-4 phase 0 0 0 period 1 1 1", "'amplitude' has 2 numbers"),
                ("viblin axis 0 0 1 order 1 amplitude 1e-4 phase 0 0 period 0.02", "'phase' has 2 numbers"),
                ("wiggle amplitude 1e-4 0 0 period 0", "'period' has the value 0"),
                (f"rotate {TURN} period 0.0", "'period' has the value 0"),
                ("rotate origin 0 0 0 axis 0 0 0 period 1", "'axis' has the values 0 0 0")):
            outcome = run(start + motion + "\nrun 1\n", check=False, name="in.wrong")
            (line,) = [line for line in outcome.text.splitlines() if line.startswith("ERROR")]
            self.assertIn(f"fix move/mesh (id turn): keyword {message}", line)


if __name__ == "__main__":
    unittest.main(verbosity=2)
