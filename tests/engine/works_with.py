"""The tables of src_liggghts/doc/what_works_with_what.md: every row is run with smooth and with multi-sphere particles and does what the table says. Rows of computes and of output that are accepted run together.

What `set`, `freeze` and `delete_atoms` do, and what the page says about them, is checked here as well.
"""

import math
import os
import re
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

from _engine import LAW, Material, Particle, Setup, host_is_inl, run

PAGE = Path(os.environ["ELLIPSOID_SOURCE"]) / "src_liggghts" / "doc" / "what_works_with_what.md"
SURFACES = {"smooth": 0, "multisphere": 7}
TOGETHER = ("Computes", "Output and averages")
COUNT = 9
COLUMNS = "id x y z vx vy vz omegax angmomx shapex quat1 quat4 mass inertiax inertiaz".split()
SEMIAXES = (0.003, 0.002, 0.002)


def script(surface, name):
    """Nine touching particles on a floor; more in the region `above` when a row inserts them."""
    subspheres = SURFACES[surface]
    setup = Setup(box=(-0.02, 0.02, -0.02, 0.02, 0.0, 0.05), materials=2 * [Material(5e6, 0.2)],
                  pair=f"gran/ellipsoid {LAW} surface {surface}", time_step=1e-5)
    particles = [Particle((0.006 * (i % 3 - 1), 0.0041 * (i // 3 - 1), 0.0021), SEMIAXES,
                          velocity=(-0.1 * (i % 3 - 1), 0.0, -0.1), type=1 + i % 2)
                 for i in range(COUNT)]
    per_atom = f"""
fix subspheres all property/atom subspheres scalar yes yes no {subspheres}
fix spacing all property/atom spacing scalar yes yes no 0
""" if subspheres else ""
    return setup.with_particles(particles, f"{name}.data") + per_atom + f"""
fix heat1 all property/global thermalConductivity peratomtype 5 5
fix heat2 all property/global thermalCapacity peratomtype 10 10
fix gravity all gravity 9.81 vector 0 0 -1
fix floor all wall/gran/ellipsoid {LAW} surface {surface} primitive type 1 zplane 0.0
fix motion all nve/ellipsoid
fix grain all particletemplate/ellipsoid 15485863 semiaxes 0.003 0.002 0.002 density 1340 &
    subspheres {subspheres}
fix mix all particledistribution/discrete 32452843 1 grain 1.0
variable law string "{LAW}"
variable surface string {surface}
variable meshes string {PAGE.parents[2] / "inputs" / "meshes"}
region above block -0.015 0.015 -0.015 0.015 0.02 0.05 units box
thermo_modify lost error norm no
"""


def rows(page):
    """[(section, [commands], {surface: outcome})] of all tables with commands."""
    found = []
    for part in page.split("\n## ")[1:]:
        title = part.splitlines()[0]
        for line in part.splitlines():
            cells = [c.strip() for c in line.strip("|").split("|")]
            if line.startswith("| `") and len(cells) == 4:
                commands = re.findall(r"`([^`]+)`", cells[0])
                found.append((title, commands, dict(zip(SURFACES, cells[1:3]))))
    return found


def after(surface, name, commands, steps=100):
    """Runs the commands; the particles (N, columns) at the end, or the text of the error."""
    text = script(surface, name) + "\n".join(commands) + f"""
run {steps}
write_dump all custom {name}.final id {' '.join(COLUMNS[1:])} modify sort id &
    format "%d{' %.12g' * (len(COLUMNS) - 1)}"
"""
    outcome = run(text, check=False, name=f"in.{name}")
    if outcome.code != 0:
        return re.search(r"ERROR[^\n]*", outcome.text).group(0)
    return np.loadtxt(f"{name}.final", skiprows=9, ndmin=2)


def complaint(surface, name, commands, expected, least=COUNT - 2):
    """What differs from the table, or nothing."""
    if os.environ["ELLIPSOID_VTK"] != "1" and "vtk" in " ".join(commands):
        expected = "refused: `Unknown dump style`"
    if host_is_inl():  # which has a scheme of its own for drag, for spheres alone
        commands = [re.sub(r"couple/cfd/force$", r"\g<0> force explicit", command) for command in commands]
    found = after(surface, name, commands)
    if isinstance(found, str):
        message = re.fullmatch(r"refused: `([^`]+)`", expected)
        return None if message and message.group(1) in found else f"{commands}, {surface}: {found}"
    if expected != "works":
        return f"{commands}, {surface}: runs, the table says {expected}"
    if len(found) < least or not np.isfinite(found).all():
        return f"{commands}, {surface}: {len(found)} particles, values {found}"
    return None


class WorksWith(unittest.TestCase):
    def test_every_row(self):
        jobs, together = [], {surface: [] for surface in SURFACES}
        table = rows(PAGE.read_text())
        for number, (title, commands, outcomes) in enumerate(table):
            for surface, expected in outcomes.items():
                if title in TOGETHER and expected == "works":
                    together[surface] += commands
                else:
                    jobs.append((surface, f"row{number}_{surface}", commands, expected))
        for surface, commands in together.items():
            used = [f"c_{m.group(1)}" for m in re.finditer(r"compute (c[1268]) ", "\n".join(commands))]
            used = ["c_c6[1]" if name == "c_c6" else name for name in used]
            per_atom = "dump used all custom 50 used id c_c3[1] c_c4 c_c10[1] c_c11[4] c_c12 c_c13"
            jobs.append((surface, f"together_{surface}",
                         commands + [f"thermo_style custom step {' '.join(used)}", per_atom],
                         "works"))
        with ThreadPoolExecutor(2) as pool:
            found = [c for c in pool.map(lambda job: complaint(*job), jobs) if c]
        print(f"{len(table)} rows, {len(jobs)} runs")
        self.assertGreater(len(table), 60)
        self.assertEqual(found, [], "\n" + "\n".join(found))

    def value(self, found, column):
        return found[:, COLUMNS.index(column)]

    def test_what_set_does(self):
        volume = 4.0 / 3.0 * math.pi * np.prod(SEMIAXES)
        for surface in SURFACES:
            found = after(surface, f"shape_{surface}", ["set group all shape 0.0029 0.002 0.002"], 0)
            mass = 1340 * volume * 29 / 30
            np.testing.assert_allclose(self.value(found, "shapex"), 0.0029)
            np.testing.assert_allclose(self.value(found, "mass"), mass, rtol=1e-6)
            np.testing.assert_allclose(self.value(found, "inertiaz"),
                                       0.2 * mass * (0.0029 ** 2 + 0.002 ** 2), rtol=1e-6)
            found = after(surface, f"quat_{surface}", ["set group all quat 0 0 1 30"], 0)
            np.testing.assert_allclose(self.value(found, "quat4"), math.sin(math.pi / 12), rtol=1e-6)
            found = after(surface, f"density_{surface}", ["set group all density 2000"], 0)
            np.testing.assert_allclose(self.value(found, "mass"), 2000 * volume, rtol=1e-6)
            np.testing.assert_allclose(self.value(found, "inertiax"), 0.2 * 2000 * volume * 8e-6,
                                       rtol=1e-6)
            before = 0.2 * 1340 * volume * 8e-6
            found = after(surface, f"omega_{surface}", ["set group all omegax 2.0"], 0)
            np.testing.assert_allclose(self.value(found, "angmomx"), 2.0 * before, rtol=1e-6)

    def test_created_atoms_get_their_shape(self):
        page = PAGE.read_text()
        (commands,) = [c for _, c, _ in rows(page) if c[0].startswith("create_atoms")]
        for surface in SURFACES:
            found = after(surface, f"created_{surface}", commands, 0)
            self.assertEqual(len(found), COUNT + 1)
            # the same body as those of the data file, but turned
            np.testing.assert_allclose(found[-1, 9], found[0, 9])
            np.testing.assert_allclose(found[-1, 12:], found[0, 12:], rtol=1e-6)
            self.assertAlmostEqual(self.value(found, "quat4")[-1], math.sin(math.pi / 12), delta=1e-6)

    def test_freeze_moves_nothing_and_delete_atoms_deletes(self):
        for surface in SURFACES:
            found = after(surface, f"freeze_{surface}", ["velocity all set 0 0 0", "fix f all freeze"])
            places = np.array([[0.006 * (i % 3 - 1), 0.0041 * (i // 3 - 1), 0.0021]
                               for i in range(COUNT)])
            np.testing.assert_allclose(found[:, 1:4], places, atol=1e-15)
            found = after(surface, f"delete_{surface}", ["group some id 1 2", "delete_atoms group some"],
                          0)
            np.testing.assert_allclose(sorted(map(tuple, found[:, 1:4])), sorted(map(tuple, places[2:])))


if __name__ == "__main__":
    unittest.main(verbosity=2)
