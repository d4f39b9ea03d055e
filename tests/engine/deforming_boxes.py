"""Forces in boxes that `fix deform` stretches, shears and flips, with every way to take the particles along, against
brute force: images by the box of the step, which move with its edges where velocities are remapped."""

import unittest
from pathlib import Path

import numpy as np

import _crowd
from _brute_force import REPLAYED, Frame
from _crowd import LENGTHS, TIME_STEP
from _engine import read_dump, run, thermo, vectors

STEPS = 60
COLUMNS = (*REPLAYED, "ix", "iy", "iz")
FORM = " ".join("%d" if c in ("id", "type", "ix", "iy", "iz") else "%.17g" for c in COLUMNS)


def script(tilt):
    text = _crowd.script() + "fix motion all nve/ellipsoid\n"
    if tilt:
        data = Path("crowd.data").read_text()
        Path("crowd.data").write_text(data.replace(" zlo zhi\n", " zlo zhi\n" + " ".join(map(repr, tilt)) + " xy xz yz\n"))
    return text


def frame_of(values):
    axes, mass = values[:, 16:19], values[:, 2]
    square = axes ** 2
    return Frame(values[:, 0].astype(int), np.zeros(len(values), int), mass,
                 0.2 * mass[:, None] * (square.sum(1)[:, None] - square), axes, values[:, 3:6], values[:, 6:9],
                 values[:, 9:12], values[:, 12:16], np.zeros(len(values), int))


def after_flip(springs, count):
    """Of contacts by the images of a cell whose xy has become smaller by so many lengths in x."""
    return {(i, j, (image[0] + count * image[1], *image[1:]), p, q): spring
            for (i, j, image, p, q), spring in springs.items()}


class DeformingBoxes(unittest.TestCase):
    def run_engine(self, deform, tilt, ranks):
        """Frames (F, N, columns), cells (F, 3, 3) and low corners (F, 3) of all steps."""
        run(script(tilt) + f"fix squeeze all deform {deform}\ndump d all custom 1 d.dump {' '.join(COLUMNS)}\n"
            f'dump_modify d sort id format "{FORM}"\nthermo 1\nthermo_style custom step lx ly lz xy xz yz xlo ylo zlo\n'
            f"thermo_modify lost error format float %.17g\nrun {STEPS}\n", ranks)
        rows = thermo("log.in.run", 10)
        cells = [np.array([[r[1], 0, 0], [r[4], r[2], 0], [r[5], r[6], r[3]]]) for r in rows]
        return vectors(read_dump("d.dump")[1], *COLUMNS), cells, rows[:, 7:10]

    def compare(self, deform, edge_rates, tilt=None, ranks=1, flips=0):
        """`fix deform` changes the box when the forces are there: they are of the box before, and where positions are
        remapped, of those before as well."""
        frames, cells, corners = self.run_engine(deform, tilt, ranks)
        brute = _crowd.brute_force()
        brute.edge_rates = np.array(edge_rates, float)
        before, contacts, found_flips = None, 0, 0
        for k, values in enumerate(frames):
            cell, corner = cells[max(k - 1, 0)], corners[max(k - 1, 0)]
            jump = round((brute.cell[1, 0] - cell[1, 0]) / cell[0, 0]) if k > 1 else 0
            found_flips += jump
            brute.cell, brute.springs = cell, after_flip(brute.springs, jump)
            frame = frame_of(values)
            if "remap" not in deform:
                frame.x = corner + (frame.x - corners[k]) @ np.linalg.inv(cells[k]) @ cell
            v = frame.v + values[:, 25:28] @ brute.edge_rates  # of the unwrapped place
            at_end, omega = v, frame.omega
            if before:
                old, old_v, force, torque = before
                v = old_v + 0.5 * TIME_STEP * force / old.mass[:, None]
                omega = frame.omega_of(old.spin() + 0.5 * TIME_STEP * torque)
            force, torque, rows, _ = brute.step(frame, 0.0, v, omega, advance=k > 0)
            for found, expected in ((values[:, 19:22], force), (values[:, 22:25], torque)):
                np.testing.assert_allclose(found, expected, rtol=0, atol=1e-10 * np.abs(expected).max(),
                                           err_msg=f"{deform}, step {k}")
            contacts += len(rows)
            before = frame, at_end, values[:, 19:22], values[:, 22:25]
        self.assertGreater(contacts, 1000)
        self.assertEqual(found_flips, flips)

    def test_stretched(self):
        for ranks in (1, 2):
            self.compare("1 x erate -100", np.zeros((3, 3)), ranks=ranks)
            self.compare("1 x erate -100 remap v", np.diag([-100 * LENGTHS[0], 0, 0]), ranks=ranks)
        self.compare("1 x vel 0.3 z vel -0.2 remap none", np.zeros((3, 3)))
        self.compare("3 x vel 0.3 z vel -0.2 remap v", np.diag([0.3, 0, -0.2]))

    def test_sheared(self):
        rates = np.array([[0, 0, 0], [300 * LENGTHS[1], 0, 0], [0, 0, 0]])
        for ranks in (1, 2):
            self.compare("1 xy erate 300 remap v", rates, (0.0, 0.0, 0.0), ranks)
            self.compare("1 xy erate 300 remap v", rates, (4.2e-3, 0.0, 0.0), ranks, flips=1)
        self.compare("1 xy erate 300", np.zeros((3, 3)), (1e-3, 0.0, 0.0))
        self.compare("1 xz vel 1.0 yz vel -0.5 remap v", np.array([[0, 0, 0], [0, 0, 0], [1.0, -0.5, 0]]),
                     (0.0, 5e-4, -7e-4), 2)


if __name__ == "__main__":
    unittest.main(verbosity=2)
