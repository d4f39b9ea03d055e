"""Tilted periodic boxes: contacts across their faces are those of the same two particles in the middle
of the box, and a sheared box keeps its particles over many strains and shears them evenly."""

import unittest

import numpy as np

from _engine import LAW, Material, Setup, dump, read_dump, run, vectors

SEMIAXES = {"smooth": (0.002, 0.0015, 0.0016), "multisphere": (0.002, 0.0015, 0.0015)}
SIDES = (0.02, 0.018, 0.022)
TILTS = (0.006, -0.004, 0.005)  # xy, xz, yz
CELL = np.array([[SIDES[0], 0, 0], [TILTS[0], SIDES[1], 0], [TILTS[1], TILTS[2], SIDES[2]]])
PAIRS = {"smooth": f"gran/ellipsoid {LAW} surface smooth",
         "multisphere": f"gran/ellipsoid {LAW} surface multisphere contacts 32"}
SUBSPHERES = """
neigh_modify one 500
fix subspheres all property/atom subspheres scalar yes yes no 5
fix spacing all property/atom spacing scalar yes yes no 0
"""


def prism(surface, commands, sides=SIDES, tilts=TILTS, **settings):
    """A script with an empty tilted box, and the commands."""
    setup = Setup(boundary="p p p", pair=PAIRS[surface], **settings)
    bounds = " ".join(f"0 {side!r}" for side in sides) + " " + " ".join(repr(t) for t in tilts)
    extra = SUBSPHERES if surface == "multisphere" else ""
    return (setup.header() + f"region box prism {bounds} units box\ncreate_box 1 box\n"
            + setup.properties() + extra + commands)


def forces_on_pair(surface, first, second, name, ranks):
    """Forces and torques (2, 6) on two particles whose centres are given, wrapped into the box."""
    places = [np.linalg.solve(CELL.T, place) % 1.0 @ CELL for place in (first, second)]
    commands = "".join("create_atoms 1 single " + " ".join(repr(float(v)) for v in place)
                       + " units box\n" for place in places)
    commands += (f"set group all shape {' '.join(map(repr, SEMIAXES[surface]))}\n"
                 "set group all density 1340\n"
                 "set atom 1 quat_direct 0.5 0.1 -0.7 0.5\nset atom 2 quat_direct 0.1 0.7 -0.1 0.7\n"
                 "fix motion all nve/ellipsoid\n" + dump(f"{name}.dump") + "run 0\n")
    run(prism(surface, commands), ranks, name=f"in.{name}")
    _, columns = read_dump(f"{name}.dump")
    return vectors(columns, "fx", "fy", "fz", "tqx", "tqy", "tqz")[0]


class Triclinic(unittest.TestCase):
    def test_contacts_across_faces_are_those_in_the_middle(self):
        middle, apart = CELL.sum(0) / 2, np.array([0.0011, 0.0014, 0.0016])
        ways = {"x": CELL[0], "y": CELL[1], "z": CELL[2], "corner": CELL.sum(0)}
        for surface in PAIRS:
            expected = forces_on_pair(surface, middle - apart / 2, middle + apart / 2,
                                      f"{surface}_middle", 1)
            self.assertGreater(np.abs(expected[:, :3]).max(), 0.1)
            np.testing.assert_allclose(expected[0, :3], -expected[1, :3], rtol=1e-12)
            for way, vector in ways.items():
                for ranks in (1, 2):
                    face = middle + vector / 2
                    found = forces_on_pair(surface, face - apart / 2, face + apart / 2,
                                           f"{surface}_{way}_{ranks}", ranks)
                    # places of 1e-2 m are rounded to 2e-18 m, overlaps are 1e-3 m
                    error = np.abs(found - expected).max(0) / np.abs(expected).max(0)
                    self.assertLess(error.max(), 1e-11, f"{surface}, {way}, {ranks} ranks")

    def sheared(self, surface, ranks):
        """A dense box sheared by 8 strains; the frames of the last two."""
        side, rate, time_step = 0.02, 100.0, 1e-5
        steps = round(1.0 / (rate * time_step))  # of one strain
        name = f"shear_{surface}_{ranks}"
        count = 5
        pitch = side / count
        commands = f"""
lattice sc {pitch!r}
create_atoms 1 box
set group all shape 0.0023 0.0018 0.0018
set group all density 1340
set group all quat/random 12345787
velocity all ramp vx {-rate * side / 2!r} {rate * side / 2!r} y 0 {side!r} units box
fix motion all nve/ellipsoid
fix shear all deform 1 xy erate {rate!r} remap v
thermo_modify lost error
run {6 * steps}
{dump(f'{name}.dump', steps // 20)}
run {2 * steps}
"""
        run(prism(surface, commands, sides=(side,) * 3, tilts=(0.0, 0.0, 0.0), time_step=time_step,
                  skin=0.001, materials=[Material(5e6, 0.2)]), ranks, name=f"in.{name}")
        return read_dump(f"{name}.dump")[1], count ** 3, rate * side, side

    def test_a_sheared_box_keeps_its_particles(self):
        for surface, ranks in (("smooth", 1), ("smooth", 2), ("multisphere", 1)):
            columns, count, speed, side = self.sheared(surface, ranks)
            self.assertEqual(columns["x"].shape[1], count)
            # the mean profile of the velocity is that of the shear
            slope = np.polyfit(columns["y"].ravel() / side, columns["vx"].ravel() / speed, 1)[0]
            self.assertAlmostEqual(slope, 1.0, delta=0.1, msg=f"{surface} on {ranks} ranks")
            touching = (np.abs(vectors(columns, "fx", "fy", "fz")).max(-1) > 0).mean()
            self.assertGreater(touching, 0.05) # collisions are short

    def test_drops_are_the_same_on_any_number_of_ranks(self):
        """Places that reach across the tilted periodic faces are those of their images within the box."""
        drop = ("fix grain all particletemplate/ellipsoid 15485863 atom_type 1 density 1340 semiaxes 4e-4 3e-4 3e-4\n"
                "fix drop all insert/drop seed 3 template grain particles 40 interval 2e-6 "
                f"box -0.004 {SIDES[0]!r} 0.001 0.017 0.002 0.02 velocity 3 1 -2\n"
                "fix motion all nve/ellipsoid\n")
        found = []
        for ranks in (1, 2, 4):
            run(prism("smooth", drop + "run 200\n" + dump("drops.dump") + "run 0\n", time_step=1e-6), ranks, name="in.drops")
            columns = read_dump("drops.dump")[1]
            self.assertEqual(columns["id"].shape[1], 40)
            fractions = np.linalg.solve(CELL.T, vectors(columns, *"xyz")[0].T).T
            self.assertGreaterEqual(fractions.min(), -1e-3)  # between two new lists particles may be out a little
            self.assertLess(fractions.max(), 1.0 + 1e-3)
            found.append(np.column_stack([fractions % 1.0, vectors(columns, "vx", "vy", "vz")[0]]))
        for other in found[1:]:
            np.testing.assert_allclose(other, found[0], rtol=0, atol=1e-9)

    def test_a_drop_beside_a_tilted_box_is_refused(self):
        """Along a direction that is not periodic."""
        setup = Setup(boundary="f f p", pair=PAIRS["smooth"])
        outcome = run(setup.header() + "region box prism 0 0.02 0 0.02 0 0.02 0 0 0.008 units box\ncreate_box 1 box\n"
                      + setup.properties() + "fix grain all particletemplate/ellipsoid 15485863 atom_type 1 density 1340 "
                      "semiaxes 8e-4 5e-4 6e-4\nfix drop all insert/drop seed 3 template grain particles 4 interval 2e-6 "
                      "box 0.001 0.002 0.001 0.002 0.015 0.016\nfix motion all nve/ellipsoid\nrun 1\n", check=False)
        self.assertRegex(outcome.text, "ERROR.*keyword 'box' reaches out of the simulation box")


if __name__ == "__main__":
    unittest.main(verbosity=2)
