"""The law of pair_style gran/ellipsoid comes back with the restart file: without the command the run that goes
on is the run that wrote the file, digit by digit; with another law it stops and names both."""

import re
import unittest
from pathlib import Path

from _engine import LAW, Particle, Setup, dump, quaternion_of, run

STEPS = 300
FLOOR = f"fix floor all wall/gran/ellipsoid {LAW} surface SURFACE primitive type 1 zplane 0.0 SETTINGS\n"


def heap(surface):
    """Twelve bodies that slide over each other on a floor."""
    count = 5 if surface == "multisphere" else 0
    bodies = [Particle((0.0042 * (k % 3) - 0.004, 0.0024 * (k // 3 % 2), 0.00135 + 0.0021 * (k // 6)),
                       (2.4e-3, 1.2e-3, 1.2e-3), quaternion_of((0.3, 1.0, 0.2 * k), 0.05 * k),
                       (0.1 * (-1) ** k, 0.05, -0.1)) for k in range(12)]
    return bodies, (f"fix subspheres all property/atom subspheres scalar yes yes no {count}\n"
                    "fix spacing all property/atom spacing scalar yes yes no 0\n" if count else "")


def script(surface, pair, restart=None, law=LAW, settings=""):
    """`pair`: arguments of pair_style, or None to leave the command out."""
    setup = Setup(pair=f"gran/ellipsoid {pair}", damping_normal=2000.0, damping_tangential=2000.0, skin=1e-3)
    page = "neigh_modify page 1000000\n"
    bodies, properties = heap(surface)
    text = setup.with_particles(bodies) if restart is None else (
        setup.header() + f"read_restart {restart}\n" + setup.properties())
    text += page
    if pair is None:
        text = re.sub(r"pair_style.*\npair_coeff.*\n", "", text)
    return text + properties + FLOOR.replace("SURFACE", surface).replace("SETTINGS", settings).replace(
        LAW, law) + "fix gravity all gravity 60 vector 0 0 -1\nfix motion all nve/ellipsoid\n"


class RestartPairStyle(unittest.TestCase):
    def whole(self, surface, pair, law, settings=""):
        run(script(surface, pair, law=law, settings=settings) + f"run {STEPS}\nwrite_restart half.restart\n"
            + dump("whole.dump", 50) + f"run {STEPS}\n", name="in.whole")

    def test_without_the_command(self):
        cases = [("smooth", LAW, "direction velocity"), ("smooth", LAW, "ellipticalContact on"),
                 ("multisphere", LAW, "contacts 20 multicontact average"), ("multisphere", LAW, "limitForce on"),
                 ("smooth", "model hertz tangential history", "tangential_damping off"),
                 ("smooth", "model hertz tangential history", "")]
        for surface, law, settings in cases:
            pair = f"{law} surface {surface} {settings}"
            self.whole(surface, pair, law)
            for name, repeated in (("left_out", None), ("repeated", pair)):
                outcome = run(script(surface, repeated, "half.restart", law) + dump(f"{name}.dump", 50)
                              + f"run {STEPS}\n", name=f"in.{name}")
                frames = Path(f"{name}.dump").read_text()
                self.assertEqual(frames, Path("whole.dump").read_text(), f"{pair}, {name}")
                self.assertNotIn("Unknown contact model", outcome.text)

    def test_the_settings_matter(self):
        """What the test above compares does depend on them."""
        frames = set()
        for settings in ("", "tangential_damping off"):
            self.whole("smooth", f"model hertz tangential history surface smooth {settings}",
                       "model hertz tangential history")
            frames.add(Path("whole.dump").read_text())
        self.assertEqual(len(frames), 2)

    def refused(self, former, present, surface, law=LAW):
        self.whole(surface, former, law)
        text = script(surface, present, "half.restart", law).replace(
            "pair_style", "fix speed all property/global characteristicVelocity scalar 1.0\npair_style", 1)
        outcome = run(text + "run 10\n", check=False, name="in.other")
        self.assertNotEqual(outcome.code, 0, f"'{former}' went on as '{present}'")
        (line,) = [line for line in outcome.text.splitlines() if line.startswith("ERROR")]
        return line

    def test_another_law_stops_and_both_are_named(self):
        smooth = f"{LAW} surface smooth"
        for present in (f"{smooth} direction velocity", f"{smooth} limitForce on"):
            line = self.refused(smooth, present, "smooth")
            for word in (f"'pair_style gran/ellipsoid {smooth}'", f"'pair_style gran/ellipsoid {present}'"):
                self.assertIn(word, line)
        # equal length of the history: 3 values of a spring each
        hertz, hooke = ("model %s tangential history surface smooth" % m for m in ("hertz", "hooke"))
        line = self.refused(hertz, hooke, "smooth", "model hertz tangential history")
        self.assertIn(hertz, line)
        self.assertIn(hooke, line)
        many = f"{LAW} surface multisphere"
        line = self.refused(f"{many} multicontact sum", f"{many} multicontact average", "multisphere")
        self.assertIn("multicontact sum", line)
        self.assertIn("multicontact average", line)

    def test_another_order_of_settings_is_the_same_law(self):
        self.whole("smooth", f"{LAW} surface smooth direction velocity limitForce on", LAW)
        run(script("smooth", f"{LAW} surface smooth limitForce on direction velocity", "half.restart")
            + "run 10\n", name="in.order")

    def test_a_wall_that_is_gone_or_renamed(self):
        self.whole("smooth", f"{LAW} surface smooth", LAW)
        text = script("smooth", None, "half.restart")
        for changed in (re.sub("fix floor.*\n", "", text), text.replace("fix floor", "fix ground")):
            outcome = run(changed + "run 1\n", name="in.wall")
            self.assertRegex(outcome.text, "WARNING.*wall of fix wall/gran/ellipsoid 'floor', which is not there")
        self.assertNotIn("which is not there", run(text + "run 1\n", name="in.wall").text)

    def test_a_wall_with_another_law(self):
        """Of equal history length; another place, speed or temperature is no other law."""
        self.whole("smooth", f"{LAW} surface smooth", LAW)
        text = script("smooth", None, "half.restart")
        hertz = FLOOR.replace(LAW, "model hertz tangential history").replace("SURFACE", "smooth")
        for floor, words in ((hertz, ("model hertz tangential history surface smooth",)),
                             (FLOOR.replace("SETTINGS", "direction velocity"), ("direction velocity",)),
                             (FLOOR.replace("zplane 0.0", "zplane 0.0 shear x 0.1 limitForce on"), ("limitForce on",))):
            floor = floor.replace("SURFACE", "smooth").replace("SETTINGS", "")
            outcome = run(re.sub("fix floor.*\n", floor, text) + "run 1\n", check=False, name="in.wall")
            self.assertNotEqual(outcome.code, 0, floor)
            (line,) = [line for line in outcome.text.splitlines() if line.startswith("ERROR")]
            for word in ("'floor'", f"'{LAW} surface smooth'", *words):
                self.assertIn(word, line)
        for place in ("zplane -0.0001", "zplane 0.0 shear x 0.1", "zplane 0.0 store_force yes"):
            run(text.replace("zplane 0.0", place) + "run 1\n", name="in.wall")

    def test_a_wall_of_another_kind(self):
        """Of the same ID: its contacts are others. Behind the others meshes may be added, or taken away."""
        self.whole("smooth", f"{LAW} surface smooth", LAW)
        text = script("smooth", None, "half.restart")
        mesh = "fix {0} all mesh/surface file floor.stl type 1 move 0 0 {1}\n"
        corners = [(-0.05, -0.05), (0.05, -0.05), (0.05, 0.05), (-0.05, 0.05)]
        Path("floor.stl").write_text("solid a\n" + "".join(
            "facet normal 0 0 1\nouter loop\n" + "".join("vertex {} {} 0\n".format(*corners[k]) for k in corner)
            + "endloop\nendfacet\n" for corner in ((0, 1, 2), (0, 2, 3))) + "endsolid a\n")

        def on(*meshes):
            places = {"low": 0.0, "lower": -0.01, "lowest": -0.02}
            return "".join(mesh.format(m, places[m]) for m in meshes) + (
                f"fix floor all wall/gran/ellipsoid {LAW} surface smooth mesh n_meshes {len(meshes)} meshes "
                f"{' '.join(meshes)}\n")

        def other(former, floor):
            outcome = run(re.sub("fix floor.*\n", floor, text) + "run 1\n", check=False, name="in.wall")
            errors = [line for line in outcome.text.splitlines() if line.startswith("ERROR")]
            if not errors:
                self.assertEqual(outcome.code, 0)
                return
            self.assertIn(f"'floor' of kind '{former}', the script has '", errors[0])
            self.assertIn("or give the wall another ID", errors[0])
            return errors[0]

        plane = "fix floor all wall/gran/ellipsoid {} surface smooth primitive type 1 {}\n"
        for kind in ("xplane -0.02", "zcylinder 0.02 0 0"):
            self.assertIsNotNone(other("zplane", plane.format(LAW, kind)))
        self.assertIsNotNone(other("zplane", on("low")))
        start = script("smooth", f"{LAW} surface smooth")
        run(re.sub("fix floor.*\n", on("low", "lower"), start) + "run 300\nwrite_restart half.restart\n", name="in.mesh")
        for meshes in (("lower", "low"), ("lowest", "low", "lower"), ("lower",), ("low", "lowest")):
            self.assertIsNotNone(other("meshes low lower", on(*meshes)), meshes)
        self.assertIsNone(other("", on("low", "lower")))
        self.assertIsNone(other("", on("low", "lower", "lowest")))
        energies = set()
        for meshes in (("low",), ("low", "lower"), ("low", "lower", "lowest")):
            goes_on = re.sub("fix floor.*\n", on(*meshes), text) + "variable k equal ke\nrun 200\nprint 'energy ${k}'\n"
            energies.update(re.findall("^energy (.*)$", run(goes_on, name="in.wall").text, re.M))
        self.assertEqual(len(energies), 1, "the springs on the first mesh are the same")

    def test_other_numbers_of_subspheres(self):
        """They belong to the particles: those of the file keep theirs, a template of other N is named."""
        pair = f"{LAW} surface multisphere"
        self.whole("multisphere", pair, LAW)
        text = script("multisphere", None, "half.restart").replace("subspheres scalar yes yes no 5",
                                                                   "subspheres scalar yes yes no 9")
        run(text + dump("again.dump", 50) + f"run {STEPS}\n", name="in.again")
        self.assertEqual(Path("again.dump").read_text(), Path("whole.dump").read_text())
        template = "fix grain all particletemplate/ellipsoid 15485863 semiaxes 2e-3 1e-3 1e-3 density 1e3 subspheres "
        run(script("multisphere", pair) + template + "5\nrun 1\nwrite_restart half.restart\n", name="in.whole")
        outcome = run(text + template + "9 spacing minimax\nrun 1\n", name="in.again")
        self.assertRegex(outcome.text, "WARNING.*'grain' has subspheres 9 spacing minimax_outline, in the restart "
                                       "file it had subspheres 5 spacing paper")
        outcome = run(text + template + "5\nrun 1\n", name="in.again")
        self.assertNotIn("in the restart file it had", outcome.text)

    def test_file_of_an_earlier_version(self):
        """It ends its section after the number of the models: the command must be repeated."""
        pair = f"{LAW} surface smooth"
        run(script("smooth", pair) + "run 1\nwrite_restart new.restart\n", name="in.new")
        data = Path("new.restart").read_bytes()
        at = data.index(pair.encode())
        length = len(pair)
        # without mark and length (16 bytes), the arguments, and the state of fix pair_settings/ellipsoid; no seal,
        # as of an unpatched LIGGGHTS, whose files are read with a warning
        old = data[:at - 16] + data[at + length:-32]
        old = old.replace(b"with liggghts-ellipsoid", b"with_other_extensions__")
        Path("old.restart").write_bytes(old)
        outcome = run(script("smooth", None, "old.restart") + "run 1\n", check=False, name="in.old")
        self.assertNotEqual(outcome.code, 0)
        self.assertRegex(outcome.text, "ERROR.*repeat it after read_restart")
        run(script("smooth", pair, "old.restart") + "run 1\n", name="in.old")


if __name__ == "__main__":
    unittest.main(verbosity=2)
