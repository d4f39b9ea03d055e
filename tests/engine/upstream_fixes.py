"""What the host's authors mended after the release of 2017, and what this package has patches for where
a tree lacks it: each of these is wrong or stops in the release."""

import math
import re
import unittest
from pathlib import Path

import numpy as np

from _engine import Particle, Setup, dump, quaternion_of, read_dump, run, vectors

CAPILLARY = ("surfaceLiquidContentInitial scalar 0.01", "surfaceTension scalar 0.072",
             "fluidViscosity scalar 1e-3", "minSeparationDistanceRatio scalar 0.01",
             "maxSeparationDistanceRatio scalar 1.1")


def capillary_force(model, angles):
    """Force (N) on the first of two touching spheres whose types have these contact angles (deg)."""
    setup = Setup(atom_style="sphere", pair=f"gran model hertz tangential history cohesion {model}")
    setup.materials = 2 * setup.materials
    radius = 1e-3
    particles = [Particle((side * 0.9995e-3, 0.0, 0.0), 3 * (radius,), type=kind)
                 for side, kind in ((-1, 1), (1, 2))]
    name = f"{model.split('/')[0]}_{'_'.join(map(str, angles))}"
    script = setup.with_particles(particles, f"{name}.data")
    properties = "".join(f"fix c{k} all property/global {line}\n"
                         for k, line in enumerate(CAPILLARY))
    properties += f"fix angles all property/global contactAngle peratomtype {angles[0]} {angles[1]}\n"
    script = script.replace("pair_style ", properties + "pair_style ", 1)
    run(script + "fix motion all nve/sphere\n" + dump(f"{name}.dump", columns=["id", "fx"])
        + "run 0\n", name=f"in.{name}")
    return read_dump(f"{name}.dump")[1]["fx"][0, 0]


class UpstreamFixes(unittest.TestCase):
    def test_contact_angle_of_a_bridge_is_the_mean_of_both(self):
        for model in ("easo/capillary/viscous", "washino/capillary/viscous"):
            with self.subTest(model=model):
                expected = capillary_force(model, (40, 40))
                self.assertGreater(abs(capillary_force(model, (80, 80)) / expected - 1.0), 1e-4)
                self.assertAlmostEqual(capillary_force(model, (10, 70)) / expected, 1.0, delta=1e-9)

    def test_atom_variables_have_the_orientation(self):
        particles = [Particle((0.01 * k, 0.0, 0.0), (0.003, 0.002, 0.001),
                              quaternion_of((1.0, k, -2.0), 0.4 + k)) for k in range(4)]
        variables = "".join(f"variable q{k} atom quat{k}\nvariable of{k} equal quat{k}[3]\n"
                            for k in range(1, 5))
        names = ["id", *(f"quat{k}" for k in range(1, 5)), *(f"v_q{k}" for k in range(1, 5))]
        run(Setup().with_particles(particles) + variables + dump("quat.dump", columns=names)
            + 'run 0\nprint "third: ${of1} ${of2} ${of3} ${of4}"\n', name="in.quat")
        _, columns = read_dump("quat.dump")
        np.testing.assert_array_equal(vectors(columns, *names[5:]), vectors(columns, *names[1:5]))
        third = re.search(r"^third: (.*)$", Path("log.in.quat").read_text(), re.M)[1]
        np.testing.assert_allclose([float(t) for t in third.split()], particles[2].quaternion,
                                   rtol=1e-6)

    def test_create_atoms_random_takes_its_seed(self):
        places = []
        for seed in (15485863, 32452843):
            run(Setup().without_particles() + f"create_atoms 1 random 10 {seed} NULL\n"
                + "set group all shape 0.003 0.002 0.001\nset group all density 1340\n"
                + dump("random.dump", columns=["id", "x", "y", "z"]) + "run 0\n", name="in.random")
            places.append(vectors(read_dump("random.dump")[1], "x", "y", "z")[0])
        self.assertEqual(places[0].shape, (10, 3))
        self.assertGreater(np.abs(places[0] - places[1]).max(), 1e-3)

    def test_inertia_of_a_tilted_dumbbell(self):
        radius, density, lever = 1e-3, 1340.0, np.array([0.0, 1.2e-3, 1.5e-3])
        Path("dumbbell.txt").write_text("".join(
            " ".join(repr(float(v)) for v in (*(side * lever), radius)) + "\n" for side in (-1, 1)))
        run(Setup(atom_style="sphere", pair="gran model hertz tangential history")
            .without_particles() + "fix t all particletemplate/multisphere 15485863 atom_type 1 "
            f"density constant {density!r} nspheres 2 ntry 1000000 spheres file dumbbell.txt "
            "scale 1.0 type 1\n", name="in.dumbbell")
        mass = density * 4.0 / 3.0 * math.pi * radius ** 3
        along = 2.0 * 0.4 * mass * radius ** 2
        across = along + 2.0 * mass * lever @ lever
        log = Path("log.in.dumbbell").read_text()
        found = [float(t) for t in
                 re.search(r"Principal moments of inertia_?: (.*)", log)[1].split(",")]
        # a million random points, of which one in fifteen is inside: errors of half a percent
        np.testing.assert_allclose(sorted(found), [along, across, across], rtol=0.02)

    def test_a_mesh_turns_by_a_variable_that_needs_a_run(self):
        Path("plate.stl").write_text("solid plate\nfacet normal 0 0 1\nouter loop\n"
                                     "vertex 0.01 0 0\nvertex 0.02 0 0\nvertex 0.01 0.01 0\n"
                                     "endloop\nendfacet\nendsolid plate\n")
        rate, steps, time_step = 50.0, 1000, 1e-5
        run(Setup(time_step=time_step).with_particles(
            [Particle((0.0, 0.0, 0.02), (0.003, 0.002, 0.001))]) + f"""
fix plate all mesh/surface file plate.stl type 1
fix motion all nve/ellipsoid
compute energy all ke
variable rate equal {rate!r}+c_energy
fix turn all move/mesh mesh plate rotate/variable origin 0 0 0 axis 0 0 1 omega v_rate
dump d all mesh/stl {steps} turned*.stl
run {steps}
""", name="in.turn")
        corners = np.array([[float(t) for t in line.split()[1:]] for line in
                            Path(f"turned{steps}.stl").read_text().splitlines()
                            if line.strip().startswith("vertex")])
        angle = rate * steps * time_step
        np.testing.assert_allclose(corners[0], [0.01 * math.cos(angle), 0.01 * math.sin(angle), 0.0],
                                   atol=1e-7)


if __name__ == "__main__":
    unittest.main(verbosity=2)
