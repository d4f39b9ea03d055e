"""Grains of any size: with every length times a power of two, and stiffness, density and speeds as they are, times are
longer by the same factor and forces by its square. No operation rounds otherwise then, so that all digits are the same;
an absolute tolerance anywhere would show."""

import unittest

import numpy as np

from _engine import Particle, Setup, run

STEPS = 2500
COLUMNS = "x y z vx vy vz omegax omegay omegaz fx fy fz quat1 quat2 quat3 quat4"
POWERS = np.array([1.0] * 3 + [0.0] * 3 + [-1.0] * 3 + [2.0] * 3 + [0.0] * 4)  # of the length, by column
MORE = """
fix p1 all property/global coefficientRollingFriction peratomtypepair 1 0.1
fix p2 all property/global coefficientRollingViscousDamping peratomtypepair 1 0.1
fix p3 all property/global cohesionEnergyDensity peratomtypepair 1 1000
"""
LAWS = {
    "smooth": ("hertz tangential history rolling_friction epsd2", "smooth", (4e-3, 2e-3, 1.5e-3)),
    "oblate": ("hertz tangential history cohesion sjkr2 rolling_friction cdt", "smooth", (2e-3, 3.5e-3, 3.5e-3)),
    "viscous": ("hertz/viscous tangential history/viscous", "smooth", (4e-3, 2e-3, 2e-3)),
    "spheres": ("hertz tangential history", "multisphere", (4e-3, 2e-3, 2e-3)),
}


def places():
    random = np.random.default_rng(3)
    for n in range(45):
        sites = np.array([7.5e-3 * (n % 3 - 1), 7.5e-3 * (n // 3 % 3 - 1), 4e-3 + 6.5e-3 * (n // 9)])
        yield sites + random.normal(size=3) * np.array([3e-4, 3e-4, 0.0]), random.normal(size=4)


def state(name, unit):
    """Places, speeds, forces and orientations (45, 16) of 45 grains that have fallen together, in units of length `unit`."""
    law, surface, semiaxes = LAWS[name]
    setup = Setup(box=tuple(v * unit for v in (-0.02, 0.02, -0.02, 0.02, 0.0, 0.08)), boundary="p f f", time_step=1e-5 * unit,
                  skin=2e-3 * unit, pair=f"gran/ellipsoid model {law} surface {surface}", damping_normal=100.0 / unit,
                  damping_tangential=100.0 / unit)
    setup.materials[0].youngs_modulus = 1e7
    axes = tuple(a * unit for a in semiaxes)
    grains = [Particle(tuple(p * unit), axes, tuple(q / np.linalg.norm(q)), velocity=(0.0, 0.0, -1.0)) for p, q in places()]
    spheres = "fix n all property/atom subspheres scalar yes yes no 7\n" if surface == "multisphere" else ""
    script = setup.with_particles(grains).replace("pair_style", MORE + spheres + "pair_style")
    wall = f"all wall/gran/ellipsoid model {law} surface {surface} primitive type 1"
    run(script + f"""
fix g all gravity {9.81 / unit!r} vector 0 0 -1
fix floor {wall} zplane 0.0
fix side1 {wall} yplane {-0.0125 * unit!r}
fix side2 {wall} yplane {0.0125 * unit!r}
fix motion all nve/ellipsoid
thermo_modify lost error
dump d all custom {STEPS} state.dump id {COLUMNS}
dump_modify d sort id format "%d {' '.join(['%.17g'] * 16)}"
run {STEPS}
""")
    with open("state.dump", encoding="ascii") as file:
        rows = file.read().split("ITEM: ATOMS")[-1].splitlines()[1:]
    return np.array([row.split()[1:] for row in rows], float)


class ScaleInvariance(unittest.TestCase):
    def test_all_digits(self):
        for name in LAWS:
            metres = state(name, 1.0)
            self.assertEqual(metres.shape, (45, 16))
            self.assertGreater(np.count_nonzero(metres[:, 9]), 6, f"{name}: grains touch, and bear sideways")
            for power in (-26, -10, 10):  # grains of 60 nm, 4 um and 4 m
                unit = 2.0 ** power
                with self.subTest(law=name, unit=unit):
                    np.testing.assert_array_equal(state(name, unit), metres * unit ** POWERS)


if __name__ == "__main__":
    unittest.main()
