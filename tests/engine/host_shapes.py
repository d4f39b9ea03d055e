"""What the README says of the host's own shapes beside ellipsoids: sliding over the seams of a flat
mesh against sliding on a plane, and going on from a restart file, with the host's law for all.

The oracle is the primitive plane: a floor of triangles is the same body, so that every difference
of the two motions is an error of the contact with triangles.
"""

import math
import unittest
from pathlib import Path

import numpy as np

from _engine import read_dump, rigid_bodies, run, vectors
from _mesh import floor, write_stl

A, B = 4e-3, 2e-3
LAW = "model hertz tangential history"
HALF_TURN = math.radians(15.0)  # half of 30 degrees about z, oblique to the seams
QUATERNION = (math.cos(HALF_TURN), 0.0, 0.0, math.sin(HALF_TURN))
CHAIN = [(-2e-3, 1.5e-3), (-1e-3, 1.8e-3), (0.0, 2e-3), (1e-3, 1.8e-3), (2e-3, 1.5e-3)]
ROUNDING = 1e-14  # m; of motions over some mm


class Shape:
    """How a script has particles of one kind; `surface` is of pairs and walls."""

    def __init__(self, name, style, pair, wall, surface, motion, template, own):
        self.name, self.style, self.pair, self.wall = name, style, pair, wall
        self.surface, self.motion, self.template, self.own = surface, motion, template, own


ELLIPSOID = f"particletemplate/ellipsoid 15485863 atom_type 1 density 2500 semiaxes {A} {B} {B}"
SHAPES = [
    Shape("smooth", "granular/ellipsoid", "gran/ellipsoid", "wall/gran/ellipsoid",
          "surface smooth", "nve/ellipsoid", ELLIPSOID, own=True),
    Shape("multisphere", "granular/ellipsoid", "gran/ellipsoid", "wall/gran/ellipsoid",
          "surface multisphere", "nve/ellipsoid", f"{ELLIPSOID} subspheres 5", own=True),
    Shape("superquadrics", "superquadric", "gran", "wall/gran", "surface superquadric",
          "nve/superquadric integration_scheme 1",
          f"particletemplate/superquadric 15485863 atom_type 1 density constant 2500 "
          f"shape constant {A} {B} {B} blockiness constant 2 2", own=False),
    Shape("fix_multisphere", "sphere", "gran", "wall/gran", "", "multisphere",
          "particletemplate/multisphere 15485863 atom_type 1 density constant 2500 nspheres 5 "
          "ntry 100000 spheres file chain.multisphere scale 1.0 type 1", own=False),
]


def head(shape, begin, walls):
    motion = rigid_bodies() if shape.motion == "multisphere" else f"fix motion all {shape.motion}\n"
    return f"""
atom_style {shape.style}
atom_modify map array
boundary f f f
newton off
communicate single vel yes
units si
{begin}
neighbor 0.002 bin
neigh_modify delay 0
fix m1 all property/global youngsModulus peratomtype 1e7
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientFriction peratomtypepair 1 0.5
fix m4 all property/global coefficientRestitution peratomtypepair 1 0.5
pair_style {shape.pair} {LAW} {shape.surface}
pair_coeff * *
fix gravity all gravity 9.81 vector 0 0 -1
{walls}
fix grain all {shape.template}
fix mix all particledistribution/discrete 32452843 1 grain 1.0
{motion}"""


def box(half):
    return (f"region box block {-half} {half} {-half} {half} -0.001 0.08 units box\n"
            f"create_box 1 box\n")


def insertion(region, more):
    return (f"region place block {region} units box volume_limit 1e-22\n"
            f"fix ins all insert/pack seed 32452867 distributiontemplate mix maxattempt 500 "
            f"insert_every once {more} region place ntry_mc 1000\n")


def dump(file, every):
    return (f"dump frames all custom {every} {file} id x y z vx vy vz omegax omegay omegaz\n"
            f'dump_modify frames sort id first no format "%d{" %.16g" * 9}"\n')


class SeamsOfAFlatMesh(unittest.TestCase):
    """One body slides obliquely over the edges and corners of triangles, or on a plane."""

    STEPS = 20000

    def motion(self, shape, kind):
        primitive = f"fix floor all {shape.wall} {LAW} {shape.surface} primitive type 1 zplane 0.0"
        mesh = ("fix cad all mesh/surface file floor.stl type 1\n"
                f"fix floor all {shape.wall} {LAW} {shape.surface} mesh n_meshes 1 meshes cad")
        words = " ".join(repr(q) for q in QUATERNION)
        script = head(shape, box(0.06), {"plane": primitive, "mesh": mesh}[kind]) + insertion(
            "-0.02001 -0.02 0.003 0.00301 0.00199 0.002",
            f"overlapcheck no all_in no vel constant 0.3 0.05 0 omega constant 0 0 0 "
            f"orientation constant {words} particles_in_region 1")
        file = f"{shape.name}_{kind}.dump"
        run(script + "timestep 2e-6\nrun 1\n" + dump(file, 250) + f"run {self.STEPS}\n",
            name=f"in.{shape.name}_{kind}")
        return vectors(read_dump(file)[1], *"xyz")

    def test_motion_on_a_mesh_against_that_on_a_plane(self):
        write_stl("floor.stl", floor(0.05, 4)[:, ::-1][:, :, [0, 2, 1]])
        for shape in SHAPES:
            with self.subTest(shape=shape.name):
                plane, mesh = self.motion(shape, "plane"), self.motion(shape, "mesh")
                self.assertEqual(plane.shape, mesh.shape)
                way = np.linalg.norm(plane[-1, 0, :2] - plane[0, 0, :2])
                error = np.linalg.norm(mesh - plane, axis=-1).max()
                print(f"{shape.name}: slides {1e3 * way:.1f} mm, off by {error:.1e} m")
                self.assertGreater(way, 6e-3)
                if shape.name == "superquadrics":
                    self.assertGreater(error, 1e-8)  # else the README does them an injustice
                else:
                    self.assertLess(error, ROUNDING)


class GoesOnFromARestartFile(unittest.TestCase):
    """Thirty particles that fall on a floor: in one go, and continued from a file."""

    HALF = 6000

    def run_all(self, shape):
        walls = f"fix floor all {shape.wall} {LAW} {shape.surface} primitive type 1 zplane 0.0"
        cloud = insertion("-0.01 0.01 -0.01 0.01 0.005 0.03", "overlapcheck yes orientation random "
                          "all_in yes particles_in_region 30")
        once, twice = f"{shape.name}_once.dump", f"{shape.name}_twice.dump"
        run(head(shape, box(0.3), walls) + cloud + "timestep 1e-5\nrun 1\n"
            + dump(once, 2 * self.HALF) + f"run {self.HALF} upto\nwrite_restart {shape.name}.half\n"
            f"run {2 * self.HALF} upto\n",
            name=f"in.{shape.name}_once")
        run(head(shape, f"read_restart {shape.name}.half", walls) + "timestep 1e-5\n"
            + dump(twice, 2 * self.HALF) + f"run {2 * self.HALF} upto\n", name=f"in.{shape.name}_twice")
        return once, twice

    def test_the_same_numbers_as_in_one_go(self):
        for shape in SHAPES:
            with self.subTest(shape=shape.name):
                once, twice = (read_dump(file)[1] for file in self.run_all(shape))
                self.assertGreater(once["id"].shape[1], 8)
                self.assertGreater(abs(once["vz"]).max(), 1e-6)  # still in motion
                for name, values in once.items():
                    self.assertTrue(np.array_equal(values, twice[name]), name)


if __name__ == "__main__":
    Path("chain.multisphere").write_text("".join(f"{x} 0 0 {r}\n" for x, r in CHAIN))
    unittest.main()
