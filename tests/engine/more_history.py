"""Contact histories that the host's own lists would lose or mix up: of several images of one partner that touch at
the same time, in a short periodic box, of a particle and its own image, and of multi-spheres that touch each other, or a
wall, at more places than `contacts` says.

Brute force (_brute_force.py), and the same run with room for all, are what it is compared with.
"""

import unittest
from pathlib import Path

import numpy as np

from _brute_force import REPLAYED, BruteForce, Law, Plane, replay
from _engine import LAW, Particle, Setup, dump, quaternion_of, read_dump, rotation, run, vectors
from _multisphere import SURFACE, multisphere_setup, pair_contacts, subspheres, wall

STEPS, TIME_STEP = 60, 1e-6
FORM = " ".join("%d" if c in ("id", "type") else "%.17g" for c in REPLAYED)


def two_images(spheres):
    """Body 2 touches body 1 on its left and the next image of it on its right, and turns between them."""
    along = [Particle((1e-3, 0.0, 0.0), (2e-3, 1e-3, 1e-3), omega=(0.0, 0.0, 30.0)),
             Particle((1e-3 + 4e-3 - 4e-6, 1e-5, 0.0), (2e-3, 1e-3, 1e-3), velocity=(0.0, 0.1, 0.02),
                      omega=(5.0, 40.0, -90.0))]
    return along, 8e-3 - 1e-5


def own_image(spheres):
    """A turned body that touches itself."""
    turn = quaternion_of((0.3, 0.2, 1.0), 0.4)
    one = Particle((1e-3, 0.0, 0.0), (2e-3, 1e-3, 1e-3), turn, velocity=(0.1, 0.0, 0.0), omega=(5.0, 15.0, 20.0))
    r = rotation(turn)
    radius = 1.0 / np.sqrt((r @ np.diag(1.0 / np.square(one.semiaxes)) @ r.T)[0, 0])  # along the box
    return [one], 2.0 * radius - (2e-5 if spheres == 0 else 4e-4)


def with_dump(text, name, steps=STEPS, lists="every 1 delay 0 check no"):
    return (text + f"neigh_modify {lists}\nfix motion all nve/ellipsoid\n" + dump(f"{name}.dump", columns=REPLAYED)
            + f'dump_modify d format "{FORM}"\nrun {steps}\n')


def frames_of(name):
    steps, c = read_dump(f"{name}.dump")
    return steps, vectors(c, *REPLAYED)


def go_on_from_restart(text):
    """A run that wrote a file half way, between two rebuilds of the lists, and the one that goes on from it."""
    half = STEPS // 2
    run(with_dump(text, "whole", lists="every 7 delay 0 check no").replace(
        f"run {STEPS}", f"restart {half} whole.*.restart\nrun {STEPS}"), name="in.whole")
    head, rest = text.split("read_data", 1)
    second = head + f"read_restart whole.{half}.restart\n" + rest.split("\n", 1)[1]
    run(with_dump(second, "second", STEPS - half), name="in.second")
    whole, second = frames_of("whole")[1], frames_of("second")[1]
    largest = np.abs(whole[:, :, 19:22]).max()
    # the first and the last frame were dumped after or before the forces that a file is written with
    np.testing.assert_allclose(second[1:-1, :, 19:22], whole[half + 1:-1, :, 19:22], rtol=0, atol=1e-9 * largest)


class Images(unittest.TestCase):
    """Neighbour lists are made anew in every step."""

    def script(self, scene, spheres):
        bodies, length = scene(spheres)
        surface = "surface multisphere" if spheres else "surface smooth"
        setup = Setup(box=(0.0, length, -0.01, 0.01, -0.01, 0.01), boundary="p f f", time_step=TIME_STEP,
                      friction=0.5, pair=f"gran/ellipsoid model hertz/viscous tangential history/viscous {surface}")
        return setup.with_particles(bodies) + (subspheres(spheres) if spheres else ""), length

    def compare(self, frames, length, spheres, contacts):
        brute = BruteForce(Law([(183e6, 0.2)], [[0.5]], [[100.0]], [[100.0]], TIME_STEP), (length, np.inf, np.inf))
        largest = np.abs(frames[:, :, 19:25]).max((0, 1))
        largest[:3] = max(largest[:3].max(), largest[3:].max() / 2e-3)  # forces of a body on itself cancel
        self.assertGreater(largest[3:].max(), 0.0)
        touching = 0
        for k, (*found, rows) in enumerate(replay(brute, frames, TIME_STEP, spheres)):
            touching += len(rows) >= contacts
            for first, values in zip((0, 3), found):
                np.testing.assert_allclose(values, frames[k][:, 19 + first:22 + first], rtol=0, err_msg=f"step {k}",
                                           atol=1e-7 * largest[first:first + 3].max())
        self.assertGreaterEqual(touching, STEPS if contacts > 1 else 10)
        # springs differ, or else the test says nothing
        springs = np.array(list(brute.springs.values()))
        if contacts > 1:
            self.assertGreater(np.abs(springs - springs[0]).max(), 0.1 * np.abs(springs).max())

    def test_two_images_of_a_partner(self):
        for spheres in (0, 5):
            for ranks in (1, 2):
                with self.subTest(spheres=spheres, ranks=ranks):
                    text, length = self.script(two_images, spheres)
                    name = f"images{spheres}_{ranks}"
                    run(with_dump(text.replace("newton", "processors * 1 1\nnewton", 1), name), ranks,
                        name=f"in.{name}")
                    self.compare(frames_of(name)[1], length, spheres, 2)

    def test_own_image(self):
        for spheres in (0, 5):
            with self.subTest(spheres=spheres):
                text, length = self.script(own_image, spheres)
                run(with_dump(text, f"own{spheres}"), name=f"in.own{spheres}")
                self.compare(frames_of(f"own{spheres}")[1], length, spheres, 1)

    def test_restart(self):
        go_on_from_restart(self.script(two_images, 0)[0])


class MoreContactsThanSlots(unittest.TestCase):
    """Two chains of 101 spheres side by side slide along each other and across the border of ranks."""

    COUNT = 101
    AXES = (2.7e-3, 1.15e-3, 1.15e-3)

    def text(self, slots):
        depth = 1e-4
        pair = [Particle((-2e-5, 0.0, k * (2 * self.AXES[1] - depth)), self.AXES,
                         velocity=(0.5 + 0.4 * k, 0.2 * k, 0.0), omega=(0.0, 0.0, 50.0 * k)) for k in (0, 1)]
        self.touching = len(pair_contacts(*pair, self.COUNT, self.COUNT))
        setup = multisphere_setup(f"contacts {slots}" if slots else "")
        return (setup.with_particles(pair).replace("newton", "processors 2 1 1\nnewton") + subspheres(self.COUNT)
                + (f"neigh_modify page {max(1000, 100 * 5 * slots)} one 100\n" if slots else ""))

    def test_as_with_room_for_all(self):
        wanted = None
        for slots, ranks, lists in ((400, 1, "check yes"), (0, 1, "check no"), (0, 2, "check no"), (1, 2, "check yes")):
            with self.subTest(slots=slots, ranks=ranks, lists=lists):
                name = f"slots{slots}_{ranks}"
                text = self.text(slots)
                self.assertGreater(self.touching, 64)
                text = text if ranks > 1 else text.replace("processors 2 1 1\n", "")
                run(with_dump(text, name, STEPS, f"every 1 delay 0 {lists}"), ranks, name=f"in.{name}")
                values = frames_of(name)[1]
                if wanted is None:
                    wanted = values
                    self.assertGreater(values[-1, :, 3].min(), 0.0)  # both bodies have crossed the border
                largest = np.abs(wanted[:, :, 19:22]).max()
                np.testing.assert_allclose(values[:, :, 19:22], wanted[:, :, 19:22], rtol=0, atol=1e-9 * largest)

    def test_restart(self):
        go_on_from_restart(self.text(0).replace("processors 2 1 1\n", ""))


class MoreWallContactsThanSlots(unittest.TestCase):
    """Chains of 101 spheres that lie on a floor slide across the border of ranks; one stands first, and is deleted."""

    COUNT, FLOOR = 101, 1e-5

    def text(self, slots, floor):
        a, b, _ = MoreContactsThanSlots.AXES
        turned = quaternion_of((0.0, 0.0, 1.0), 0.7)
        bodies = [Particle((0.0, 9e-3 * k, self.FLOOR + b - 4e-5 + 1e-5 * k), (a, b, b), turned, mass=2e-3,
                           velocity=(0.7 + 0.2 * k, 0.3, 0.01), omega=(20.0, 10.0, -60.0)) for k in (-1, 0, 1)]
        for body in bodies[1:]:
            body.position = (-2e-5, *body.position[1:])
        setup = multisphere_setup()
        text = setup.with_particles(bodies).replace("newton", "processors 2 1 1\nnewton") + subspheres(self.COUNT)
        if floor == "plane":
            return text + wall("floor", "zplane", self.FLOOR, f"contacts {slots}")
        triangles = [((-0.03, -0.03), (0.03, -0.03), (0.03, 0.03)), ((-0.03, -0.03), (0.03, 0.03), (-0.03, 0.03))]
        Path("floor.stl").write_text("solid floor\n" + "".join(
            "facet normal 0 0 1\nouter loop\n" + "".join(f"vertex {x} {y} {self.FLOOR}\n" for x, y in t)
            + "endloop\nendfacet\n" for t in triangles) + "endsolid floor\n")
        return text + (f"fix cad all mesh/surface file floor.stl type 1\nfix floor all wall/gran/ellipsoid {LAW} {SURFACE} "
                       f"mesh n_meshes 1 meshes cad contacts {slots}\n")

    def frames(self, name, text, ranks=1, runs=f"run {STEPS}\n"):
        text = text if ranks > 1 else text.replace("processors 2 1 1\n", "")
        text = with_dump(text, name, lists="every 1 delay 0 check yes").replace(f"run {STEPS}\n", runs)
        run(text, ranks, name=f"in.{name}")
        return frames_of(name)[1]

    def test_brute_force(self):
        for floor, ranks, slots in (("plane", 1, 1), ("plane", 2, 3), ("mesh", 1, 8), ("mesh", 2, 2)):
            with self.subTest(floor=floor, ranks=ranks):
                frames = self.frames(f"{floor}{ranks}", self.text(slots, floor), ranks)
                self.assertGreater(frames[-1, 1:, 3].min(), 0.0)  # two bodies have crossed the border
                brute = BruteForce(Law([(183e6, 0.2)], [[0.3]], [[100.0]], [[100.0]], TIME_STEP), (np.inf,) * 3,
                                   [Plane((0.0, 0.0, -1.0), lambda time: (0.0, 0.0, self.FLOOR))])
                largest = np.abs(frames[:, :, 19:25]).max((0, 1))
                for k, (force, torque, _) in enumerate(replay(brute, frames, TIME_STEP, self.COUNT)):
                    np.testing.assert_allclose(frames[k][:, 19:22], force, rtol=0, atol=1e-9 * largest[:3].max())
                    np.testing.assert_allclose(frames[k][:, 22:25], torque, rtol=0, atol=1e-9 * largest[3:].max())
                    if k > 0:  # springs begin with the first step
                        of_each = np.bincount([key[0] for key in brute.springs])
                        self.assertGreater(of_each[1:].min(), 8)

    def test_deletion(self):
        """Springs beyond the slots stay with their bodies when the first one is gone."""
        runs = f"run {STEPS // 2}\ngroup gone id 1\ndelete_atoms group gone\nundump d\n"
        after = f'dump d all custom 1 after.dump {" ".join(REPLAYED)}\ndump_modify d sort id format "{FORM}"\nrun 20\n'
        found = []
        for slots in (200, 2):
            self.frames(f"deleted{slots}", self.text(slots, "plane"), runs=runs + after)
            found.append(vectors(read_dump("after.dump")[1], *REPLAYED))
        self.assertEqual(found[0].shape[1], 2)
        np.testing.assert_array_equal(found[0], found[1])

    def test_restart(self):
        for floor in ("plane", "mesh"):
            go_on_from_restart(self.text(2, floor).replace("processors 2 1 1\n", ""))


if __name__ == "__main__":
    unittest.main(verbosity=2)
