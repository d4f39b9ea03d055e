"""What the host's fix massflow/mesh counts of ellipsoids: centres that cross the mesh, and their masses."""

import unittest

import numpy as np

from _engine import Particle, Setup, quaternion_of, run, thermo

FACE = """solid face
facet normal 0 0 1
outer loop
vertex -0.03 -0.03 0
vertex 0.03 -0.03 0
vertex -0.03 0.03 0
endloop
endfacet
facet normal 0 0 1
outer loop
vertex 0.03 -0.03 0
vertex 0.03 0.03 0
vertex -0.03 0.03 0
endloop
endfacet
endsolid face
"""


class MassFlow(unittest.TestCase):
    def test_centres_that_cross(self):
        """Long bodies, some of whose ends only reach through the mesh, and one that goes back up."""
        with open("face.stl", "w", encoding="ascii") as file:
            file.write(FACE)
        a, steps, step = 3e-3, 400, 1e-5
        upright = quaternion_of((0, 1, 0), 1.5707963267948966)
        heights = np.array([0.001, 0.0025, 0.004, -0.002])
        speeds = np.array([-1.0, -1.0, -0.1, 1.0])
        particles = [Particle((0.008 * k - 0.012, 0.0, z), (a, 1e-3, 1e-3), upright, (0, 0, v))
                     for k, (z, v) in enumerate(zip(heights, speeds))]
        ends = heights + speeds * steps * step
        for ranks in (1, 2):
            run(Setup(time_step=step).with_particles(particles) + f"""fix motion all nve/ellipsoid
fix cad all mesh/surface/planar file face.stl type 1
fix flux all massflow/mesh mesh cad count once vec_side 0 0 -1
thermo_style custom step f_flux[1] f_flux[2]
thermo_modify norm no format float %.12g
run {steps}
""", ranks, name=f"in.flux{ranks}")
            mass, number = thermo(f"log.in.flux{ranks}", 3)[-1, 1:]
            crossed = (heights > 0) & (ends < 0)
            self.assertEqual(crossed.sum(), 2)
            self.assertEqual(number, crossed.sum())
            self.assertAlmostEqual(mass, crossed.sum() * particles[0].mass, delta=1e-9 * mass)


if __name__ == "__main__":
    unittest.main(verbosity=2)
