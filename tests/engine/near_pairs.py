"""Pairs that are left out of the near pairs by their true shapes: no contact is ever missed.

Scenes of adversarial.py, drawn anew: needles, plates and triaxial bodies of aspect ratio up to 20 that spin so fast
that they come to touch by rotation alone, in lists with a thin or a wide skin, made in every way that neigh_modify
knows. Forces, torques and contacts of each step against brute force over all pairs and images. In a sheared periodic
box and in the plane: the forces of a run whose skin is so wide that no pair is asked again.
"""

import unittest
from pathlib import Path

import numpy as np

import adversarial
from _engine import Particle, Setup, dump, quaternion_of, read_dump, run, vectors

SCENES = 6
adversarial.STEPS = 50
#: of the host's lists; none of them breaks what they promise for centres
LISTS = (("1e-5", "every 1 delay 0 check yes"), ("2e-4", "every 1 delay 0 check yes"),
         ("2e-3", "every 1 delay 0 check yes"), ("2e-3", "every 10 delay 10 check no"),
         ("3e-3", "every 5 delay 20 check yes"), ("1e-3", "every 1 delay 0 check no"))


class SpinningScene(adversarial.Scene):
    def __init__(self, seed):
        super().__init__(seed)
        self.spin()

    def bodies(self):
        """Slender, flat and triaxial, longest axis anywhere."""
        self.multisphere = False
        super().bodies()
        r, largest = self.random, 0.0
        for k, (cell, kind, _, quaternion, _) in enumerate(self.rows):
            long, b = r.uniform(4.0, 20.0), 3e-4 * 2.0 ** r.uniform(0.0, 1.0)
            axes = b * r.permutation([long, 1.0, 1.0] if k % 3 else [long, 0.6 * long, 1.0])
            self.rows[k] = (cell, kind, axes, quaternion, 0)
            largest = max(largest, axes.max())
        factor = largest / self.cell
        self.cell, self.length = largest, self.length * factor
        self.low, self.high = (bound * factor for bound in (self.low, self.high))
        if self.floor is not None:
            self.floor = -0.5 * self.cell
        self.separate()

    def spin(self):
        """The tips move up to 20 m/s: 0.06 mm in a step."""
        longest = np.array([row[2].max() for row in self.rows])
        self.omega = self.random.uniform(-1.0, 1.0, (len(longest), 3)) * (20.0 / longest)[:, None]

    def head(self, start):
        skin, rebuilds = LISTS[self.seed % len(LISTS)]
        text = super().head(start).replace("neighbor 2e-4 bin", f"neighbor {skin} {'nsq' if self.seed % 4 == 1 else 'bin'}")
        return text.replace(f"neigh_modify delay 0 every 1 {self.rebuilds}", f"neigh_modify {rebuilds}").replace(
            "thermo_style", "compute search all contacts/ellipsoid\nfix search all ave/time 1 1 1 c_search[3] c_search[7] "
            f"file search.{start.split()[0]}.txt\nthermo_style")


SIDE, STEPS = 0.02, 250
#: initial angular velocity: needles turn by 1.5 rad in the run, more than a hundred steps of 1e-4 m at the tips
OMEGA = 3000.0


def crowd(planar, axes):
    """64 needles or plates on a grid, turned at random; 16 in the plane z = 0."""
    random, bodies, per_side = np.random.default_rng(11), [], 4
    pitch = SIDE / per_side
    for cell in np.ndindex(per_side, per_side, 1 if planar else per_side):
        place = (np.array(cell) + 0.5 + random.uniform(-0.1, 0.1, 3)) * pitch
        axis = (0.0, 0.0, 1.0) if planar else random.normal(size=3)
        omega = OMEGA * np.where([not planar, not planar, True], random.uniform(-1.0, 1.0, 3), 0.0)
        velocity = np.where([True, True, not planar], random.uniform(-1.0, 1.0, 3), 0.0)
        bodies.append(Particle(tuple(place * (1.0, 1.0, not planar)), axes,
                               quaternion_of(axis, random.uniform(0.0, np.pi)), tuple(velocity), tuple(omega)))
    return bodies


def simulate(name, planar, axes, skin, ranks):
    """Forces and torques (F, N, 6) of each fifth step, and pairs in the lists and near by shape."""
    box = (0.0, SIDE, 0.0, SIDE, -SIDE, SIDE) if planar else (0.0, SIDE) * 3
    setup = Setup(box=box, boundary="p p f" if planar else "p p p", skin=skin, time_step=2e-6)
    script = setup.with_particles(crowd(planar, axes), f"{name}.data")
    if not planar:
        script = script.replace("neighbor ", "change_box all triclinic\nneighbor ", 1)
        script += "fix shear all deform 1 xy erate 300.0 remap v\n"
    script += f"""fix motion all nve/ellipsoid{' planar yes' if planar else ''}
neigh_modify page 1000000 one 10000
compute search all contacts/ellipsoid
fix search all ave/time 1 1 1 c_search[1] c_search[3] c_search[7] file {name}.txt
{dump(f"{name}.dump", 5)}run {STEPS}
"""
    run(script, ranks, name=f"in.{name}")
    _, columns = read_dump(f"{name}.dump")
    return vectors(columns, "fx", "fy", "fz", "tqx", "tqy", "tqz"), np.loadtxt(f"{name}.txt")[:, 1:]


class NearPairs(unittest.TestCase):
    def test_spinning_bodies_against_brute_force(self):
        scene, adversarial.Scene = adversarial.Scene, SpinningScene
        try:
            contacts = adversarial.Adversarial().scenes(range(1, SCENES + 1))
        finally:
            adversarial.Scene = scene
        self.assertGreater(contacts, 100 * SCENES)
        counts = np.concatenate([np.loadtxt(file)[:, 1:] for file in Path().glob("seed*/search.*.txt")])
        listed, near = counts.sum(axis=0)
        print(f"near by their shapes: {near / listed:.2f} of the pairs of the lists")
        self.assertLess(near, 0.7 * listed)

    def test_same_forces_as_with_a_wide_skin(self):
        """So wide that what is left out at the beginning is so to the end."""
        for name, planar, axes in (("needles", False, (4e-3, 2.5e-4, 2.5e-4)), ("plates", False, (2e-4, 2e-3, 2.5e-3)),
                                   ("plane", True, (3e-3, 2e-4, 4e-4))):
            expected, counts = simulate(f"{name}.wide", planar, axes, 0.014, 1)
            self.assertTrue((counts[:, 1:] == counts[0, 1:]).all(), "pairs were chosen again")
            for ranks in 1, 2, 4:
                forces, counts = simulate(f"{name}.{ranks}", planar, axes, 2e-4, ranks)
                touching, listed, near = counts.sum(axis=0)
                error = np.abs(forces - expected).max((0, 1)) / np.abs(expected).max((0, 1)).clip(1e-300)
                print(f"{name} on {ranks} ranks: {touching / len(counts):.1f} touching, {near / len(counts):.0f} near, "
                      f"{listed / len(counts):.0f} in the lists; forces differ by {error.max():.1e}")
                self.assertGreater(touching, 2 * len(counts))
                self.assertLess(near, 0.5 * listed)
                self.assertGreater(len(np.unique(counts[:, 2])), 5, "pairs were hardly chosen again")
                self.assertLess(error.max(), 1e-7)


if __name__ == "__main__":
    unittest.main(verbosity=2)
