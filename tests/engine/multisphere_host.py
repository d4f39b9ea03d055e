"""Trajectories against the host's own rigid bodies of spheres (fix multisphere) with the same law.

One cloud of 60 particles, N = 5 and N = 13, bounded by walls, with friction. The host places the
bodies without overlap; their spheres tell position, axis, velocity and spin of each particle, which
the other run starts from. Every sphere of the host carries the body's whole mass, as eq. (23) needs.

In the plane (the paper's piling) both integrators differ by the cube of the angle turned per step.
The host's other degrees of freedom are switched off by fflag and tflag. In space the host's spin at
the time of the forces is that of half a step before; forces of the first contacts therefore agree,
and trajectories to first order of the time step; extrapolated to no time step, to second.
"""

import math
import os
import subprocess
import unittest
from pathlib import Path

import numpy as np

from _engine import (LAW, Particle, Setup, dump, quaternion_of, read_dump, rigid_bodies, rotation, run,
                     vectors)
from _multisphere import chain, multisphere_setup, subspheres, wall

A, B, MASS, MOMENTS = 2.7e-3, 1.15e-3, 2e-5, (1.058e-11, 3.445e-11, 3.445e-11)
GROUPS, PER_GROUP = 12, 5
SEEDS = (15485863, 15485867, 32452843, 32452867, 49979687, 49979693, 67867967, 67867979, 86028121,
         86028157, 10007, 10009)  # primes, as the host wants them
COLUMNS = "id x y z vx vy vz omegax omegay omegaz fx fy fz tqx tqy tqz".split()
AGREEMENT = 1e-8  # of the semi-axis a


def template_file(count):
    """The host's file of the chain, as ellipsoid-post writes it."""
    name = f"chain{count}.multisphere"
    subprocess.run([str(Path(os.environ["ELLIPSOID_BIN"]) / "ellipsoid-post"), "template",
                    "--aspect", repr(A / B), "--b", repr(B), "--subspheres", str(count),
                    "--multisphere", name], check=True, capture_output=True)
    centres, radii = chain(A, B, count)
    written = np.loadtxt(name)
    np.testing.assert_allclose(written[:, 0], centres, rtol=0, atol=1e-12 * A)
    np.testing.assert_allclose(written[:, 3], radii, rtol=0, atol=1e-12 * A)
    return name


class Cloud:
    """One cloud of bodies: how the host makes it, and what both engines make of it."""

    def __init__(self, count, planar, overlapping=False):
        self.count, self.planar, self.overlapping = count, planar, overlapping
        self.name = f"n{count}_{'plane' if planar else 'space'}{'_overlapping' * overlapping}"
        self.gravity = "" if overlapping else "fix gravity all gravity 9.81 vector 0 -1 0\n"

    def setup(self, time_step, **options):
        return Setup(box=(0.0, 0.06, 0.0, 0.04, -0.02, 0.02), time_step=time_step, skin=0.001,
                     **options)

    def groups(self):
        """(quaternion, velocity, spin) of each group of bodies."""
        random = np.random.default_rng(60)
        for k in range(GROUPS):
            axis = np.array([0.0, 0.0, 1.0]) if self.planar else random.normal(size=3)
            angle = 10.0 * math.pi * k / GROUPS
            spin = (0.0, 0.0, 20.0 * (-1) ** k) if self.planar else tuple(15.0 * random.normal(size=3))
            velocity = (0.2 * math.cos(angle) - 0.3, 0.2 * math.sin(angle) - 0.3, 0.0)
            if self.overlapping:
                velocity = spin = (0.0, 0.0, 0.0)
            yield quaternion_of(axis, math.pi * (k + 0.3) / GROUPS), velocity, spin

    def host_script(self, time_step):
        """The host's cloud up to its first step, after which all bodies are there."""
        flags = "fflag on on off tflag off off on" if self.planar else ""
        check, depth = "no" if self.overlapping else "yes", 1e-5 if self.planar else 0.006
        i_x, i_y, i_z = MOMENTS
        setup = self.setup(time_step, atom_style="sphere", pair=f"gran {LAW}")
        script = setup.without_particles() + self.gravity + f"""
fix left all wall/gran {LAW} primitive type 1 xplane 0.0
fix floor all wall/gran {LAW} primitive type 1 yplane 0.0
fix grain all particletemplate/multisphere 10037 atom_type 1 density constant 1340 &
    nspheres {self.count} ntry 1000 spheres file {template_file(self.count)} scale 1.0 type 1 &
    mass {MASS} inertia_tensor {i_x} 0 0 {i_y} 0 {i_z} use_density {flags}
fix mixture all particledistribution/discrete 10039 1 grain 1.0
region cloud block 0.0031 0.046 0.0031 0.030 {-depth!r} {depth!r} units box
{rigid_bodies()}"""
        for k, (q, velocity, spin) in enumerate(self.groups()):
            script += (f"fix insert{k} all insert/pack seed {SEEDS[k]} distributiontemplate mixture "
                       f"maxattempt 2000 insert_every once overlapcheck {check} all_in no "
                       f"vel constant {words(velocity)} omega constant {words(spin)} "
                       f"orientation constant {words(q)} region cloud ntry_mc 1000 "
                       f"particles_in_region {PER_GROUP * (k + 1)}\n")
        return script + "run 1\nreset_timestep 0\n"

    def run_host(self, time_step, every=1, steps=0):
        """Frames of the host's bodies from its first step on."""
        file = f"{self.name}_host.dump"
        run(self.host_script(time_step) + dump(file, every, COLUMNS) + f"run {steps}\n",
            name=f"in.{self.name}_host")
        return Bodies(file, self.count)


def words(values):
    return " ".join(repr(float(v)) for v in values)


class Bodies:
    """Rigid bodies of `count` spheres each, from a dump of their spheres: arrays (F, bodies, 3)."""

    def __init__(self, file, count):
        _, columns = read_dump(file)
        def values(*names):
            array = vectors(columns, *names)
            return array.reshape(array.shape[0], -1, count, 3)
        x, force = values("x", "y", "z"), values("fx", "fy", "fz")
        self.position = x[:, :, count // 2]
        self.velocity = values("vx", "vy", "vz")[:, :, count // 2]
        self.spin = values("omegax", "omegay", "omegaz")[:, :, 0]
        self.force = force.sum(axis=2)
        self.torque = (values("tqx", "tqy", "tqz")
                       + np.cross(x - self.position[:, :, None], force)).sum(axis=2)
        axis = x[:, :, -1] - x[:, :, 0]
        self.axis = axis / np.linalg.norm(axis, axis=2, keepdims=True)
        self.touching = np.linalg.norm(self.force, axis=2) > 0.0


class Ours(Bodies):
    """The same arrays from a dump of our particles."""

    def __init__(self, file):
        _, columns = read_dump(file)
        self.position, self.velocity = vectors(columns, "x", "y", "z"), vectors(columns, "vx", "vy", "vz")
        self.spin = vectors(columns, "omegax", "omegay", "omegaz")
        self.force, self.torque = vectors(columns, "fx", "fy", "fz"), vectors(columns, "tqx", "tqy", "tqz")
        quaternion = [columns[f"quat{k}"] for k in (1, 2, 3, 4)]
        self.axis = np.moveaxis(rotation(quaternion)[:, 0], 0, -1)


def quaternion_to(axis):
    """A turn of the x axis to `axis`; about z for an axis in the plane."""
    if axis[2] == 0.0:
        return quaternion_of((0.0, 0.0, 1.0), math.atan2(axis[1], axis[0]))
    about = np.cross((1.0, 0.0, 0.0), axis)
    return quaternion_of(about, math.atan2(np.linalg.norm(about), axis[0]))


def run_ours(cloud, start, time_step, every, steps, motion):
    """Frames from the first frame of `start` on."""
    bodies = [Particle(tuple(x), (A, B, B), quaternion_to(axis), tuple(v), tuple(w), MASS, MOMENTS)
              for x, axis, v, w in zip(start.position[0], start.axis[0], start.velocity[0],
                                       start.spin[0])]
    setup = cloud.setup(time_step, pair=multisphere_setup("contacts 64").pair)
    script = setup.with_particles(bodies, f"{cloud.name}.data") + "neigh_modify page 1000000\n"
    script += subspheres(cloud.count) + cloud.gravity
    script += wall("left", "xplane", 0.0) + wall("floor", "yplane", 0.0) + motion
    file = f"{cloud.name}_ours.dump"
    run(script + dump(file, every) + f"run {steps}\n", name=f"in.{cloud.name}_ours")
    return Ours(file)


def both(cloud, time_step, duration, motion):
    """Frames of the host and of ours, every 0.05 ms, from the same cloud."""
    every, steps = round(5e-5 / time_step), round(duration / time_step)
    host = cloud.run_host(time_step, every, steps)
    return host, run_ours(cloud, host, time_step, every, steps, f"fix motion all {motion}\n")


def difference(host, ours):
    """Largest difference of positions over a, and of axes (rad), per frame (F,)."""
    position = np.abs(host.position - ours.position).max(axis=(1, 2)) / A
    return np.maximum(position, np.abs(host.axis - ours.axis).max(axis=(1, 2)))


def at_walls(host, count):
    """Which bodies overlap a wall (F, bodies)."""
    x, radii = chain(A, B, count)
    centres = host.position[:, :, None] + x[:, None] * host.axis[:, :, None]
    return (centres[..., :2].min(axis=3) < radii).any(axis=2)


class InThePlane(unittest.TestCase):
    DURATION = 7e-3  # s

    def check(self, count):
        cloud = Cloud(count, planar=True)
        host, ours = both(cloud, 5e-7, self.DURATION, "nve/ellipsoid planar yes")
        self.assertEqual(host.position.shape[1], GROUPS * PER_GROUP)
        self.assertEqual(host.touching[0].sum(), 0)
        found = difference(host, ours)
        wall_ones = at_walls(host, count)
        self.assertTrue(host.touching[wall_ones].all())
        pairs, walls = (host.touching & ~wall_ones).any(axis=0).sum(), wall_ones.any(axis=0).sum()
        print(f"N = {count}, in plane: {pairs} bodies hit another one, {walls} a wall; spins up to "
              f"{np.abs(host.spin).max():.0f}/s; largest difference {found.max():.1e}")
        self.assertGreater(pairs, 20)
        self.assertGreater(walls, 5)
        self.assertLess(found.max(), AGREEMENT)

    def test_5_spheres(self):
        self.check(5)

    def test_13_spheres(self):
        self.check(13)

    def test_what_differs_is_the_integrators(self):
        """The difference falls with the square of the time step."""
        cloud, worst = Cloud(5, planar=True), []
        for time_step in (2e-6, 1e-6):
            worst.append(difference(*both(cloud, time_step, 2e-3, "nve/ellipsoid planar yes")).max())
        print(f"in plane: difference {worst[0]:.2e} with 2 us, {worst[1]:.2e} with 1 us")
        self.assertAlmostEqual(worst[0] / worst[1], 4.0, delta=0.8)


class InSpace(unittest.TestCase):
    DURATION = 4e-3  # s

    def test_forces_at_the_same_configuration(self):
        """Overlapping bodies, put in at rest: their first step gives velocities but no springs."""
        time_step = 1e-6
        for count in (5, 9):
            cloud = Cloud(count, planar=False, overlapping=True)
            host = cloud.run_host(time_step)
            ours = run_ours(cloud, host, time_step, 1, 0, "")
            force = np.linalg.norm(host.force[0], axis=1)
            touching = host.touching[0]
            worst = [np.abs((got - wanted)[touching] / (size * force[touching])[:, None]).max()
                     for got, wanted, size in ((ours.force[0], host.force[0], 1.0),
                                               (ours.torque[0], host.torque[0], A))]
            print(f"N = {count}, in space: {touching.sum()} bodies touch, forces up to "
                  f"{force.max():.1f} N; largest relative difference of forces {worst[0]:.1e}, of "
                  f"torques {worst[1]:.1e}")
            self.assertGreater(touching.sum(), 10)
            self.assertLess(max(worst), 1e-10)

    def test_trajectories_converge(self):
        """To first order (the host's spin); extrapolated to no time step they agree to second."""
        cloud, differences = Cloud(5, planar=False), []
        for time_step in (1e-6, 5e-7):
            host, ours = both(cloud, time_step, self.DURATION, "nve/ellipsoid")
            differences.append((host.position - ours.position) / A)
        self.assertGreaterEqual(host.touching.any(axis=0).sum(), 8)
        coarse, fine = (np.abs(d).max() for d in differences)
        extrapolated = np.abs(2.0 * differences[1] - differences[0]).max()
        print(f"in space: {host.touching.any(axis=0).sum()} bodies touch; largest difference "
              f"{coarse:.2e} with 1 us, {fine:.2e} with 0.5 us, extrapolated {extrapolated:.1e}")
        self.assertAlmostEqual(coarse / fine, 2.0, delta=0.2)
        self.assertLess(extrapolated, AGREEMENT)


if __name__ == "__main__":
    unittest.main(verbosity=2)
