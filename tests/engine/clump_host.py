"""Clumps against the host's own rigid bodies of spheres (fix multisphere): the same list of spheres, law,
masses and moments.

The clump is a hook, which nothing is symmetric about. The host puts 2 or 10 bodies; their spheres tell
the pose of each body, which the other run starts from. Every sphere of the host carries the body's whole
mass, as eq. (23) needs. The host's spin at the time of the forces is that of half a step before, so that
trajectories agree to first order of the time step, and extrapolated to no time step to second.
"""

import unittest
from pathlib import Path

import numpy as np

from _engine import (LAW, Particle, Setup, dump, ellipsoids_data, read_dump, rigid_bodies, rotation, run,
                     vectors)
from _multisphere import multisphere_setup, wall

HOOK = np.array([[0.0, 0.0, 0.0, 1.0], [1.2, 0.0, 0.0, 0.8], [2.0, 0.5, 0.0, 0.6],
                 [2.2, 1.2, 0.3, 0.5], [0.0, 0.0, 0.9, 0.5]]) * 1e-3
MASS, MOMENTS, SIZE = 1.2e-5, (8e-12, 1.7e-11, 2.0e-11), 2e-3
BOX = (0.0, 0.04) * 3
TEMPLATE = (f"fix grain all particletemplate/ellipsoid 15485863 atom_type 1 mass {MASS} inertia "
            + " ".join(map(repr, MOMENTS)) + " ")
SEEDS = (15485863, 15485867, 32452843, 32452867, 49979687, 49979693, 67867967, 67867979, 86028121,
         86028157)


def words(values):
    return " ".join(repr(float(v)) for v in values)


def body_frame():
    """The hook about its centre of mass, along its principal axes (5, 4), written by the engine."""
    Path("hook.csv").write_text("\n".join(words(row) for row in HOOK))
    setup = Setup(box=BOX, pair=f"gran/ellipsoid {LAW} surface multisphere")
    run(setup.without_particles() + TEMPLATE + "clump hook.csv write_clump hook.body\n")
    return np.loadtxt("hook.body", delimiter=",", skiprows=3)


def pose(body, x):
    """Turn and centre that bring the spheres of `body` (N, 3) to x (N, 3): Kabsch."""
    middle, there = body.mean(axis=0), x.mean(axis=0)
    u, _, v = np.linalg.svd((x - there).T @ (body - middle))
    r = u @ np.diag([1.0, 1.0, np.linalg.det(u @ v)]) @ v
    return r, there - r @ middle


def quaternion(r):
    """Scalar first, of a rotation matrix, by its largest component."""
    squares = 1.0 + np.array([r[0, 0] + r[1, 1] + r[2, 2], r[0, 0] - r[1, 1] - r[2, 2],
                              r[1, 1] - r[0, 0] - r[2, 2], r[2, 2] - r[0, 0] - r[1, 1]])
    k = int(squares.argmax())
    products = np.array([[squares[0], r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1]],
                         [r[2, 1] - r[1, 2], squares[1], r[0, 1] + r[1, 0], r[0, 2] + r[2, 0]],
                         [r[0, 2] - r[2, 0], r[0, 1] + r[1, 0], squares[2], r[1, 2] + r[2, 1]],
                         [r[1, 0] - r[0, 1], r[0, 2] + r[2, 0], r[1, 2] + r[2, 1], squares[3]]])
    return products[k] / np.linalg.norm(products[k])


class Cloud:
    def __init__(self, count, region, speed, body, overlap="no"):
        self.count, self.region, self.speed, self.body = count, region, speed, body
        self.check = {"no": "yes", "yes": "no"}[overlap]

    def setup(self, time_step, **options):
        return Setup(box=BOX, time_step=time_step, skin=0.001, **options)

    def host(self, time_step, every, steps):
        """Frames of the host's bodies, from the first step after their insertion on."""
        np.savetxt("hook.host", self.body, fmt="%.17g")
        i_x, i_y, i_z = MOMENTS
        script = self.setup(time_step, atom_style="sphere", pair=f"gran {LAW}").without_particles() + f"""
fix floor all wall/gran {LAW} primitive type 1 zplane 0.0
fix grain all particletemplate/multisphere 10037 atom_type 1 density constant 1340 &
    nspheres {len(self.body)} ntry 1000 spheres file hook.host scale 1.0 type 1 &
    mass {MASS} inertia_tensor {i_x} 0 0 {i_y} 0 {i_z} use_density
fix mixture all particledistribution/discrete 10039 1 grain 1.0
region cloud block {self.region} units box
{rigid_bodies()}"""
        random = np.random.default_rng(61)
        for k in range(self.count):
            velocity, spin = self.speed * random.normal(size=3), 60.0 * self.speed * random.normal(size=3)
            velocity[2] -= self.speed
            script += (f"fix insert{k} all insert/pack seed {SEEDS[k]} distributiontemplate mixture "
                       f"maxattempt 2000 insert_every once overlapcheck {self.check} all_in no "
                       f"vel constant {words(velocity)} omega constant {words(spin)} orientation random "
                       f"region cloud ntry_mc 1000 particles_in_region {k + 1}\n")
        columns = "id x y z vx vy vz omegax omegay omegaz fx fy fz tqx tqy tqz".split()
        run(script + "run 1\nreset_timestep 0\n" + dump("host.dump", every, columns) + f"run {steps}\n")
        return self.bodies(read_dump("host.dump")[1])

    def bodies(self, columns):
        count = len(self.body)

        def values(*names):
            array = vectors(columns, *names)
            return array.reshape(array.shape[0], -1, count, 3)
        x, force, spin = values("x", "y", "z"), values("fx", "fy", "fz"), values("omegax", "omegay", "omegaz")
        poses = [[pose(self.body[:, :3], b) for b in frame] for frame in x]
        found = {"turn": np.array([[p[0] for p in frame] for frame in poses]),
                 "x": np.array([[p[1] for p in frame] for frame in poses]), "spin": spin[:, :, 0],
                 "force": force.sum(axis=2)}
        arm = x - found["x"][:, :, None]
        found["v"] = values("vx", "vy", "vz")[:, :, 0] - np.cross(spin[:, :, 0], arm[:, :, 0])
        found["torque"] = (values("tqx", "tqy", "tqz") + np.cross(arm, force)).sum(axis=2)
        return found

    def ours(self, start, time_step, every, steps, motion="fix motion all nve/ellipsoid\n"):
        reach = (np.abs(self.body[:, :3]) + self.body[:, 3:]).max(axis=0)
        particles = [Particle(tuple(x), tuple(reach), tuple(quaternion(r)), tuple(v), tuple(w), MASS,
                              MOMENTS)
                     for x, r, v, w in zip(start["x"][0], start["turn"][0], start["v"][0],
                                           start["spin"][0])]
        before, rest = ellipsoids_data(particles, BOX, 1).split("Atoms\n\n")
        rows, after = rest.split("\n\nVelocities")
        rows = "\n".join(f"{row} {len(self.body)} 1001" for row in rows.split("\n"))
        Path("start.data").write_text(f"{before}Atoms\n\n{rows}\n\nVelocities{after}")
        setup = self.setup(time_step, pair=multisphere_setup("contacts 32").pair)
        run(setup.header() + "read_data start.data\n" + setup.properties()
            + "neigh_modify page 1000000\n" + TEMPLATE + "clump hook.csv\n"
            + wall("floor", "zplane", 0.0).replace("contacts 64", "contacts 32") + motion
            + dump("ours.dump", every) + f"run {steps}\n")
        _, c = read_dump("ours.dump")
        q = [c[f"quat{k}"] for k in (1, 2, 3, 4)]
        turns = np.moveaxis(rotation(q), (0, 1), (-2, -1))
        return {"x": vectors(c, "x", "y", "z"), "turn": turns,
                "force": vectors(c, "fx", "fy", "fz"), "torque": vectors(c, "tqx", "tqy", "tqz")}


class AgainstTheHost(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.body = body_frame()

    def test_forces_at_the_same_configuration(self):
        """Overlapping bodies at rest: the normal forces and their torques are the host's."""
        cloud = Cloud(10, "0.004 0.012 0.004 0.012 0.004 0.012", 0.0, self.body, overlap="yes")
        host = cloud.host(1e-7, 1, 0)
        ours = cloud.ours(host, 1e-7, 1, 0, "")
        size = np.linalg.norm(host["force"][0], axis=1)
        touching = size > 0.0
        force = np.abs(ours["force"][0] - host["force"][0])[touching] / size[touching, None]
        torque = np.abs(ours["torque"][0] - host["torque"][0])[touching] / (SIZE * size[touching, None])
        print(f"{touching.sum()} bodies touch, forces up to {size.max():.1f} N; largest relative difference "
              f"of forces {force.max():.1e}, of torques {torque.max():.1e}")
        self.assertGreater(touching.sum(), 7)
        self.assertLess(max(force.max(), torque.max()), 1e-9)

    def check(self, count, region, speed, duration):
        cloud, differences = Cloud(count, region, speed, self.body), []
        for time_step in (1e-6, 5e-7):
            steps = round(duration / time_step)
            host = cloud.host(time_step, steps // 10, steps)
            ours = cloud.ours(host, time_step, steps // 10, steps)
            differences.append((host["x"] - ours["x"]) / SIZE)
            turned = np.abs(host["turn"] - ours["turn"]).max()
        touched = np.abs(np.diff(host["v"], axis=0)).max(axis=(0, 2)) > 1e-6
        coarse, fine = (np.abs(d).max() for d in differences)
        extrapolated = np.abs(2.0 * differences[1] - differences[0]).max()
        print(f"{count} bodies, {touched.sum()} of them hit something: positions differ by {coarse:.1e} of the "
              f"size with 1 us, {fine:.1e} with 0.5 us, extrapolated {extrapolated:.1e}; turns by {turned:.1e}")
        self.assertGreaterEqual(touched.sum(), min(count, 4))
        self.assertAlmostEqual(coarse / fine, 2.0, delta=0.3)
        self.assertLess(extrapolated, 1e-6)

    def test_two_bodies(self):
        self.check(2, "0.018 0.0215 0.018 0.0215 0.004 0.0065", 0.3, 1e-2)

    def test_ten_bodies(self):
        self.check(10, "0.012 0.026 0.012 0.026 0.004 0.016", 0.5, 6e-3)


if __name__ == "__main__":
    unittest.main(verbosity=2)
