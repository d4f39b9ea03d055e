"""Angular velocity, angular momentum and orientation belong together, whatever command of the host
writes one of them: compared with rigid-body mechanics in NumPy (full tensors in the space frame)."""

import math
import unittest
from pathlib import Path

import numpy as np

from _engine import Setup, quaternion_of, rotation, run, thermo
from _spinning import (MOTION, after, bodies, momenta, omegas, quaternions, read_columns, tensors, turned,
                       vectors, write_dump)


def same_up_to_sign(found, expected):
    """Quaternions q and -q are the same orientation."""
    sign = np.sign(np.sum(found * expected, axis=-1, keepdims=True))
    np.testing.assert_allclose(sign * found, expected, atol=1e-12)


class Spin(unittest.TestCase):
    def assert_agree(self, c):
        np.testing.assert_allclose(momenta(c), np.einsum("nij,nj->ni", tensors(c), omegas(c)),
                                   rtol=1e-9, atol=1e-20)

    def test_velocity(self):
        c = after("velocity all zero angularIndividual", "zero", 1)
        np.testing.assert_allclose(omegas(c), 0.0, atol=1e-15)
        np.testing.assert_allclose(momenta(c), 0.0, atol=1e-25)
        c = after("velocity all setAngular 1e-9 -2e-9 3e-9", "set_angular")
        np.testing.assert_allclose(momenta(c), [[1e-9, -2e-9, 3e-9]] * 3, rtol=1e-12)
        self.assert_agree(c)

    def test_set_keeps_omega(self):
        given = np.array([p.omega for p in bodies()])
        for k, command in enumerate(("density 2680", "shape 0.003 0.001 0.002", "quat 1 2 3 40",
                                     "quat/random 4242", "quat_direct 0.5 0.5 -0.5 0.5",
                                     "inertiax 4e-11 inertiay 5e-11 inertiaz 6e-11", "mass 3e-5")):
            with self.subTest(command):
                c = after(f"set group all {command}", f"set{k}")
                np.testing.assert_allclose(omegas(c), given, rtol=1e-12)
                self.assert_agree(c)
        c = after("set group all omegay 7", "omega")
        np.testing.assert_allclose(omegas(c)[:, 1], 7.0, rtol=1e-12)
        self.assert_agree(c)

    def test_set_mass_is_followed_by_moments_and_density(self):
        before = after("", "before")
        c = after("set group all mass 3e-5", "mass")
        factor = 3e-5 / before["mass"]
        for name in ("inertiax", "inertiay", "inertiaz", "density"):
            np.testing.assert_allclose(c[name], factor * before[name], rtol=1e-12)
        c = after("set group all mass 3e-5 inertiax 1e-11 inertiay 1e-11 inertiaz 1e-11", "given")
        np.testing.assert_allclose(c["inertiaz"], 1e-11)

    def test_axis_of_set_quat_may_have_any_length(self):
        for k, factor in enumerate((1.0, 2.0, 1e-3)):
            axis = factor * np.array([1.0, -2.0, 2.0]) / 3.0
            c = after(f"set group all quat {axis[0]!r} {axis[1]!r} {axis[2]!r} 50", f"axis{k}")
            same_up_to_sign(quaternions(c),
                            np.array([quaternion_of((1, -2, 2), math.radians(50))] * 3))

    def test_displace_atoms_turns_bodies(self):
        before = after("", "straight")
        for ranks in (1, 4):
            c = after("displace_atoms all rotate 0.001 0 0 1 1 2 75 units box", f"displaced{ranks}", ranks=ranks)
            turn = quaternion_of((1, 1, 2), math.radians(75))
            same_up_to_sign(quaternions(c), np.array([turned(turn, q) for q in quaternions(before)]))
            point = np.array([0.001, 0.0, 0.0])
            places = point + (vectors(before, "x", "y", "z") - point) @ rotation(turn).T
            np.testing.assert_allclose(vectors(c, "x", "y", "z"), places, atol=1e-15)
            np.testing.assert_allclose(omegas(c), omegas(before), rtol=1e-12)
            self.assert_agree(c)

    def test_fix_move_turns_bodies(self):
        start = np.array([p.quaternion for p in bodies()])
        commands = "unfix motion\nfix motion all move rotate 0 0 0 1 2 2 {period} units box"
        steps, period = 400, 4.8e-3  # 30 degrees
        c = after(commands.format(period=period), "rotate", steps)
        turn = quaternion_of((1, 2, 2), math.radians(30))
        same_up_to_sign(quaternions(c), np.array([turned(turn, q) for q in start]))
        axis = np.array([1.0, 2.0, 2.0]) / 3.0
        np.testing.assert_allclose(omegas(c), [2.0 * math.pi / period * axis] * 3, rtol=1e-12)
        self.assert_agree(c)
        for k, motion in enumerate(("wiggle 0.001 0 0 0.01", "linear 0.1 0 0")):
            c = after(f"unfix motion\nfix motion all move {motion} units box", f"shift{k}", 100)
            same_up_to_sign(quaternions(c), start)
            np.testing.assert_allclose(omegas(c), 0.0, atol=1e-15)
            np.testing.assert_allclose(momenta(c), 0.0, atol=1e-25)

    def test_fix_move_refuses_another_time(self):
        setup = Setup()
        for command in ("timestep 2e-6", "reset_timestep 0"):
            outcome = run(setup.with_particles(bodies()) + "fix motion all move rotate 0 0 0 1 2 2 1\n"
                          f"run 2\n{command}\nrun 1\n", check=False)
            self.assertEqual(outcome.code, 1)
            self.assertRegex(outcome.text, r"ERROR[^\n]*fix move \(id motion\) counts its time in steps")


class Groups(unittest.TestCase):
    def total(self, c):
        """Angular momentum about the centre of mass, and moments of inertia about it (3, 3)."""
        mass, x, v = c["mass"], vectors(c, "x", "y", "z"), vectors(c, "vx", "vy", "vz")
        r = x - mass @ x / mass.sum()
        spin = np.einsum("nij,nj->ni", tensors(c), omegas(c))
        momentum = (mass[:, None] * np.cross(r, v) + spin).sum(0)
        orbit = sum(m * (a @ a * np.eye(3) - np.outer(a, a)) for m, a in zip(mass, r))
        return momentum, orbit + tensors(c).sum(0)

    def test_group_functions_count_the_spin(self):
        names = ([f"angmom(all,{k})" for k in "xyz"] + [f"inertia(all,{k})" for k in
                                                        ("xx", "yy", "zz", "xy", "yz", "xz")]
                 + [f"omega(all,{k})" for k in "xyz"] + ["ke(all)", "ke(all,whole)", "angmom(all,x,whole)"]
                 + [f"torque(all,{k})" for k in "xyz"] + ["torque(all,y,whole)"])
        variables = "".join(f"variable v{k} equal {name}\n" for k, name in enumerate(names))
        # the liquid's force acts beside the centres of bodies in its surface
        commands = ("fix g all gravity 9.81 vector 0 0 -1\nfix b all buoyancy dim z level 0.0005 density 1000\n"
                    "region whole block INF INF INF INF INF INF units box\n" + variables
                    + "thermo_style custom step " + " ".join(f"v_v{k}" for k in range(len(names)))
                    + '\nthermo_modify format float %.15g\n')
        for ranks in (1, 2):
            c = after(commands, f"groups{ranks}", ranks=ranks)
            row = thermo(f"log.in.groups{ranks}", len(names) + 1)[-1, 1:]
            momentum, inertia = self.total(c)
            tensor = [inertia[0, 0], inertia[1, 1], inertia[2, 2], inertia[0, 1], inertia[1, 2],
                      inertia[0, 2]]
            v = vectors(c, "vx", "vy", "vz")
            energy = 0.5 * (c["mass"] * (v ** 2).sum(-1)).sum() + 0.5 * np.einsum(
                "ni,nij,nj", omegas(c), tensors(c), omegas(c))
            r = vectors(c, "x", "y", "z") - c["mass"] @ vectors(c, "x", "y", "z") / c["mass"].sum()
            torque = (np.cross(r, vectors(c, "fx", "fy", "fz")) + vectors(c, "tqx", "tqy", "tqz")).sum(0)
            self.assertGreater(np.abs(c["tqy"]).max(), 1e-3 * np.abs(torque[1]))
            np.testing.assert_allclose(row, [*momentum, *tensor, *np.linalg.solve(inertia, momentum),
                                             energy, energy, momentum[0], *torque, torque[1]], rtol=1e-9)

    def test_angular_momentum_is_taken_off(self):
        before, _ = self.total(after("", "spinning"))
        for name, command, steps in (("momentum", "fix stop all momentum 1 angular", 1),
                                     ("velocity", "velocity all zero angular", 0)):
            c = after(command, name, steps)
            self.assertLess(np.abs(self.total(c)[0]).max(), 1e-9 * np.abs(before).max())
            Spin.assert_agree(self, c)


class Stream(unittest.TestCase):
    def test_released_particles_have_the_given_spin(self):
        meshes = Path(__file__).resolve().parents[2] / "inputs" / "meshes"
        setup = Setup(box=(-0.03, 0.03, -0.03, 0.03, -0.01, 0.09), time_step=1e-5)
        script = setup.without_particles() + MOTION + f"""
fix face all mesh/surface/planar file {meshes}/hopper_lid.stl type 1 move 0 0 0.01
fix grain all particletemplate/ellipsoid 15485863 semiaxes 0.002 0.0013 0.0009 density 1340
fix mix all particledistribution/discrete 32452843 1 grain 1.0
fix ins all insert/stream seed 32452867 distributiontemplate mix nparticles 3 massrate 0.5 overlapcheck yes &
    all_in yes vel constant 0 0 -1.0 omega constant 10 -20 30 insertion_face face extrude_length 0.02
run 5000
"""
        run(script + write_dump("stream"))
        c = read_columns("stream")
        self.assertEqual(len(c["id"]), 3)
        Spin.assert_agree(self, c)
        # inserted with their axes along those of the box, carried without a turn, torque-free since
        expected = vectors(c, "inertiax", "inertiay", "inertiaz") * [10.0, -20.0, 30.0]
        np.testing.assert_allclose(momenta(c), expected, rtol=1e-9)


if __name__ == "__main__":
    unittest.main(verbosity=2)
