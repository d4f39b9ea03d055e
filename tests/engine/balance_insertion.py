"""fix balance/ellipsoid with insertion and meshes: the host's fixes insert the same particles as without it, at the
same places, and these move alike on planes, still and moving meshes, to rounding."""

import unittest

import numpy as np

from _balance import SHOW, SIDE, largest_differences, ranks_of, shifts
from _engine import LAW, Setup, dump, read_dump, run
from _mesh import floor, write_stl

SOURCE = "seed 32452867 distributiontemplate mix "
BODIES = "overlapcheck yes orientation random vel constant 0.3 0 -4 "
INSERTIONS = {
    "pack": f"fix i1 all insert/pack {SOURCE} insert_every 60 {BODIES} region above particles_in_region 12\n",
    "rate": f"fix i1 all insert/rate/region {SOURCE} nparticles 40 particlerate 60000 insert_every 50 {BODIES} "
            "region above\n",
    "stream": "fix face all mesh/surface/planar file face.stl type 1\n"
              f"fix i1 all insert/stream {SOURCE} nparticles 20 particlerate 50000 overlapcheck yes all_in yes "
              "vel constant 0.3 0 -6 insertion_face face extrude_length 0.006\n",
    "drop": "fix i1 all insert/drop seed 3 template grain particles 20 interval 4e-5 "
            "box 0.002 0.012 0.009 0.021 0.012 0.027 velocity 0 0 -4\n",
}
TURNING = "fix turn all move/mesh mesh floor rotate origin 0.015 0.015 0.006 axis 0 0 1 period 0.02\n"


class InsertionAndMeshes(unittest.TestCase):
    def setUp(self):
        tilted = floor(0.0095, cells=6)[:, :, [0, 2, 1]] + np.array([0.015, 0.015, 0.006])
        tilted[:, :, 2] += 0.2 * (tilted[:, :, 0] - 0.015)
        write_stl("floor.stl", tilted)
        write_stl("face.stl", floor(0.005)[:, :, [0, 2, 1]] + np.array([0.008, 0.015, 0.02]))

    def scene(self, name, grid, commands, steps):
        """Particles at the end: a box with a floor of 72 triangles and a wall, gravity towards both."""
        setup = Setup(box=(0.0, SIDE) * 3, boundary="f f f", time_step=4e-6, skin=5e-4)
        run(setup.without_particles().replace("create_box", f"processors {grid}\ncreate_box") + f"""
fix grain all particletemplate/ellipsoid 15485863 semiaxes 1.5e-3 1e-3 0.8e-3 density 1340
fix mix all particledistribution/discrete 32452843 1 grain 1.0
region above block 0.001 0.014 0.001 0.029 0.013 0.029 units box
fix gravity all gravity 9.81 vector -0.3 0 -1
fix floor all mesh/surface file floor.stl type 1
fix walls all wall/gran/ellipsoid {LAW} surface smooth mesh n_meshes 1 meshes floor
fix side all wall/gran/ellipsoid {LAW} surface smooth primitive type 1 xplane 0.0
fix motion all nve/ellipsoid
{commands}run {steps}
""" + dump(f"{name}.dump") + "run 0\n", ranks_of(grid), name=f"in.{name}")
        return read_dump(f"{name}.dump")[1]

    def compare(self, name, plain, shared, least_shifts, tolerance):
        np.testing.assert_array_equal(plain["id"], shared["id"])
        worst, number = max(largest_differences(plain, shared, 1e9).values()), shifts(f"log.in.{name}")
        print(f"{name}: {plain['id'].size} particles, {number:.0f} shifts, largest relative difference {worst:.0e}")
        self.assertGreater(plain["id"].size, 7)
        self.assertGreater((plain["omegax"] != 0.0).sum(), 1, "too few have touched anything")
        self.assertGreaterEqual(number, least_shifts)
        self.assertLess(worst, tolerance)

    def check_insertion(self, style, grid):
        name = f"{style}_{grid.replace(' ', '')}"
        plain = self.scene(name + "_plain", grid, INSERTIONS[style], 600)
        shared = self.scene(name, grid, INSERTIONS[style] + "fix share all balance/ellipsoid every 40 threshold 1.0\n"
                            + SHOW, 600)
        self.compare(name, plain, shared, 3 if style in ("pack", "rate") else 1, 1e-9)

    def test_pack(self):
        self.check_insertion("pack", "2 1 1")

    def test_rate(self):
        self.check_insertion("rate", "2 1 1")

    def test_stream(self):
        self.check_insertion("stream", "2 1 1")

    def test_drop(self):
        self.check_insertion("drop", "2 1 1")

    def check_mesh(self, name, motion, grid):
        one = self.scene(name + "_one", "1 1 1", motion + INSERTIONS["drop"], 800)
        shared = self.scene(name, grid, motion + INSERTIONS["drop"]
                            + "fix share all balance/ellipsoid every 30 threshold 1.0\n" + SHOW, 800)
        self.compare(name, one, shared, 3, 1e-8)

    def test_a_mesh_that_stands_still(self):
        self.check_mesh("still", "", "4 1 1")

    def test_a_mesh_that_turns(self):
        self.check_mesh("turning", TURNING, "1 2 1")


if __name__ == "__main__":
    unittest.main(verbosity=2)
