"""Contact histories that the host's own lists would lose or mix up: of several images of one partner that touch at
the same time, in a short periodic box, of a particle and its own image, and of multi-spheres that touch at more places
than `contacts` says.

Brute force (_brute_force.py), and the same run with room for all, are what it is compared with.
"""

import unittest

import numpy as np

from _brute_force import REPLAYED, BruteForce, Law, replay
from _engine import Particle, Setup, dump, quaternion_of, read_dump, rotation, run, vectors
from _multisphere import multisphere_setup, pair_contacts, subspheres

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


if __name__ == "__main__":
    unittest.main(verbosity=2)
