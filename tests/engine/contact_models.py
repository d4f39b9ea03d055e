"""The host's contact models with both surfaces of ellipsoids.

Oracles: spheres (a = b = c; N = 1) under each model move as under the host's own pair_style gran and
fix wall/gran; forces of ellipsoids have no moment left over: those of pairs turn both bodies by
opposite moments about any point, those of walls act at the contact point; cohesive forces in closed
form; models that cannot work are refused with the reason.
"""

import math
import os
import re
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

from _contact_rows import (PAIR_COLUMNS, WALL_COLUMNS, WIDTH, crowd, crowd_setup, floor_and_lid, lists,
                           named, read_rows, refusal)
from _engine import SPHERE_COLUMNS, Setup, dump, host_is_inl, read_dump, run, vectors
from _mesh import write_stl
from _multisphere import subspheres
from multisphere_sphere_limit import STEPS, TIME_STEP, impact

PAPER = "model hertz/viscous tangential history/viscous"
NORMAL = ("hertz", "hertz/stiffness", "hooke", "hooke/stiffness", "hooke/hysteresis", "luding")
WITHOUT_ROLLING = [
    *(f"model {normal} tangential history" for normal in NORMAL),
    "model hooke/viscous tangential history/viscous",
    "model hertz", "model hertz tangential no_history", "model luding tangential tan_luding",
    "model hertz tangential history cohesion sjkr", "model hertz tangential history cohesion sjkr2",
    "model hooke/stiffness tangential no_history cohesion sjkr2",
    f"{PAPER} cohesion sjkr", f"{PAPER} cohesion sjkr2"]
WITH_ROLLING = [
    *(f"model hertz tangential history rolling_friction {r}" for r in ("cdt", "epsd", "epsd2")),
    "model luding tangential tan_luding rolling_friction luding",
    f"{PAPER} cohesion sjkr rolling_friction cdt", f"{PAPER} rolling_friction epsd2"]
if host_is_inl():
    WITHOUT_ROLLING += ["model c2 tangential history",
                        *(f"model hysteretic/nonlinear{k} tangential hysteretic/nonlinear" for k in (1, 2))]
    WITH_ROLLING += [f"{PAPER} rolling_friction cdtnonlinear2"]
HOST_IS_PICI = (Path(os.environ["ELLIPSOID_BUILD"]) / "liggghts/patched/src/jkr_lookup_table.h").exists()
if HOST_IS_PICI:
    WITHOUT_ROLLING += ["model hertz/wet tangential history"]
COHESION_ENERGY_DENSITY = 2e5
RELATIVE = 1e-10  # rounding, which two impacts have amplified
PROPERTIES = {
    "springStiffnessNormal": 1e4, "springStiffnessTangential": 8e3,
    "kn": 3e7, "kt": 2e7, "gamman": 1e4, "gammat": 1e4,
    "coefficientRollingFriction": 0.1, "coefficientRollingViscousDamping": 0.0,
    "cohesionEnergyDensity": COHESION_ENERGY_DENSITY, "coefficientMaxElasticStiffness": 4.0,
    "coefficientAdhesionStiffness": 0.3, "coefficientPlasticityDepth": 0.02,
    "LoadingStiffness": 1e4, "UnloadingStiffness": 3.0, "pullOffForce": 0.0,
    "coeffFrictionStiffness": 0.3, "coeffRollingStiffness": 0.2,
    "FluidViscosity": 0.9, "FrictionViscosity": 0.5}
if host_is_inl():
    PROPERTIES |= {"alphaCustom": 20.0, "cinCustom": 1e-7, "aoneCustom": 5e7, "atwoCustom": 1e6, "athreeCustom": 2.5,
                   "kcinCustom": 0.1}
LINEAR = {"kn": 1e4, "kt": 8e3, "gamman": 400.0, "gammat": 200.0}  # of hooke/stiffness


def with_properties(script, law, **changed):
    """The script with the properties of all models before its pair_style."""
    values = {**PROPERTIES, **(LINEAR if "hooke/stiffness" in law else {}), **changed}
    text = "fix velocity all property/global characteristicVelocity scalar 0.5\n"
    if HOST_IS_PICI:  # asks for it and does not use it
        text += "fix restitution all property/global RestitutionConstant scalar 0.7\n"
    for k, (name, value) in enumerate(values.items()):
        text += f"fix model{k} all property/global {name} peratomtypepair 1 {value!r}\n"
    return script.replace("pair_style", text + "pair_style", 1)


def spheres(law, surface, floor, settings="", **changed):
    """Frames of forces (F, 2, 3) and torques of an oblique impact; surface None: the host's own."""
    name = "_".join([f"{law} {settings}".strip().replace("/", "-").replace(" ", "."), surface or "host", str(floor)])
    setup = Setup(time_step=TIME_STEP, pair=f"gran/ellipsoid {law} surface {surface} {settings}")
    motion, fix = "nve/ellipsoid", f"wall/gran/ellipsoid {law} surface {surface}"
    if surface is None:
        setup.pair, setup.atom_style, motion = f"gran {law} {settings}", "sphere", "nve/sphere"
        fix = f"wall/gran {law}"
    script = with_properties(setup.with_particles(
        impact(1.8 if surface == "multisphere" else 1.0), f"{name}.data"), law, **changed)
    if surface == "multisphere":
        script += "neigh_modify page 1000000\n" + subspheres(1)
    if floor:
        script += f"fix floor all {fix} primitive type 1 zplane 0.0 {settings}\n"
    script += f"fix motion all {motion}\n" + dump(f"{name}.dump", columns=SPHERE_COLUMNS)
    run(script + f"run {STEPS}\n", name=f"in.{name}")
    _, columns = read_dump(Path(f"{name}.dump"))
    return vectors(columns, "fx", "fy", "fz"), vectors(columns, "tqx", "tqy", "tqz")


class SphereLimit(unittest.TestCase):
    def compare(self, law, tolerance, floor=True, **changed):
        expected = spheres(law, None, floor, **changed)
        touching = np.abs(expected[0]).max(axis=2) > 0.0
        self.assertGreater(touching.sum(axis=0).min(), 50, law)
        for surface in "smooth", "multisphere":
            found = spheres(law, surface, floor, **changed)
            errors = [np.abs(f - e).max() / np.abs(e).max() for f, e in zip(found, expected)
                      if np.abs(e).max() > 0.0]
            print(f"{law}, {surface}{'' if floor else ', no floor'}: {max(errors):.1e}")
            self.assertLess(max(errors), tolerance, f"{law}, {surface}")

    def test_models_without_rolling_friction(self):
        with ThreadPoolExecutor(2) as pool:
            list(pool.map(lambda law: self.compare(law, RELATIVE), WITHOUT_ROLLING))

    OF_INL = [(WITHOUT_ROLLING[k], "limitForce off", True, {"coefficientAdhesionStiffness": 0.0}) for k in (-3, -2)]
    OF_INL += [(WITH_ROLLING[-1], "torsionTorque on", False, {})]

    def test_settings(self):
        """Each setting of the host's models that works; it changes the motion, or the test says nothing."""
        for law, setting, floor, changed in (
                *(self.OF_INL if host_is_inl() else ()),
                ("model hooke tangential history", "viscous on", True,
                 {"CriticalStokes": 10.0, "MaximumRestitution": 0.9}),
                ("model hooke tangential history", "ktToKnUser on", True, {}),
                ("model hooke/stiffness tangential history", "absolute_damping on", True,
                 {"gamman_abs": 1e-2, "gammat_abs": 5e-3}),
                *((f"model {normal} tangential history", "tangential_damping off", True, {}) for normal in NORMAL),
                *((f"model {normal} tangential history", "limitForce on", True, {})
                  for normal in ("hertz", "hooke", "hooke/stiffness")),
                ("model hertz/stiffness tangential history", "limitForce on", True, {"gamman": 1e6}),
                *((f"model hertz tangential history rolling_friction {r}", "torsionTorque on", False, {})
                  for r in ("cdt", "epsd", "epsd2")),
                *((f"model hertz tangential history cohesion {c}", "tangential_reduce on", True, {})
                  for c in ("sjkr", "sjkr2"))):
            with self.subTest(law=law, setting=setting):
                self.compare(law, RELATIVE, floor, settings=setting, **changed)
                plain, changed_by_it = (spheres(law, "smooth", floor, settings=s, **changed) for s in ("", setting))
                self.assertGreater(max(np.abs(a - b).max() / np.abs(a).max() for a, b in zip(plain, changed_by_it)), 1e-6)

    def test_rolling_friction_of_pairs(self):
        for law in WITH_ROLLING:
            self.compare(law, RELATIVE, floor=False)

    def test_rolling_friction_at_walls(self):
        """There the host's spheres roll by omega (R - h/2) / (R - h), ours by omega; the direction
        alone, which cdt needs, is the same."""
        self.compare("model hertz tangential history rolling_friction cdt", RELATIVE)
        for model in "epsd", "epsd2":
            self.compare(f"model hertz tangential history rolling_friction {model}", 0.02)

    def test_rolling_dashpot(self):
        """Its moment of inertia is about the contact point, the host's spheres take 1.4 m R^2."""
        self.compare("model hertz tangential history rolling_friction epsd", 0.02, floor=False,
                     coefficientRollingViscousDamping=0.3)


def crowd_script(law, surface, name, settings=""):
    """A crowd without walls and motion, from NAME.data, which is written."""
    setup = crowd_setup(surface)
    setup.pair = f"gran/ellipsoid {law} surface {surface} {settings}"
    axes = (2.6e-3, 2.3e-3, 1.8e-3) if surface == "smooth" else (2.5e-3, 1.7e-3, 1.7e-3)
    script = setup.with_particles(crowd(axes), f"{name}.data") + "neigh_modify page 1000000\n"
    return script if surface == "smooth" else script + subspheres(5)


def crowd_rows(law, surface, name, step=1, **changed):
    """Columns of the particles, rows of pairs and of walls, at a step of a crowd."""
    script = crowd_script(law, surface, name)
    script += floor_and_lid(surface, law) + "fix motion all nve/ellipsoid\n" + lists(name) + dump(f"{name}.dump") + "run 1\n"
    run(with_properties(script, law, **changed), name=f"in.{name}")
    _, columns = read_dump(f"{name}.dump")
    return (columns, named(read_rows(f"{name}.pairs")[step], PAIR_COLUMNS),
            named(read_rows(f"{name}.walls")[step], WALL_COLUMNS))


def moments(columns, pairs, walls):
    """Torques on the particles (N, 3), the moments of the listed forces about their centres (N, 3),
    and the torques' scale."""
    torque = vectors(columns, "tqx", "tqy", "tqz")[-1]
    listed = np.zeros_like(torque)
    for rows, key, centre, sign in ((pairs, "id_1", 1, 1.0), (pairs, "id_2", 2, -1.0),
                                    (walls, "id", 1, 1.0)):
        arm = vectors(rows, "px", "py", "pz") - vectors(rows, *(f"{n}_{centre}" for n in "xyz"))
        np.add.at(listed, rows[key].astype(int) - 1,
                  sign * np.cross(arm, vectors(rows, "fx", "fy", "fz")))
    return torque, listed, np.abs(listed).max()


class Ellipsoids(unittest.TestCase):
    def test_forces_act_at_the_contact_points(self):
        for surface in "smooth", "multisphere contacts 16":
            worst = 0.0
            for k, law in enumerate(WITHOUT_ROLLING):
                torque, listed, scale = moments(*crowd_rows(law, surface, f"{surface[0]}{k}"))
                self.assertLess(np.abs(torque - listed).max() / scale, 1e-11, law)
                worst = max(worst, np.abs(torque - listed).max() / scale)
            print(f"surface {surface}, {len(WITHOUT_ROLLING)} models: torques and moments of the "
                  f"forces differ by {worst:.1e}")

    def test_rolling_friction_adds_opposite_couples(self):
        for surface in "smooth", "multisphere contacts 16":
            for k, law in enumerate(WITH_ROLLING):
                columns, pairs, walls = crowd_rows(law, surface, f"{surface[0]}r{k}")
                torque, listed, scale = moments(columns, pairs, walls)
                couples = torque - listed
                free = np.ones(len(couples), bool)
                free[walls["id"].astype(int) - 1] = False
                self.assertGreater(np.abs(couples[free]).max() / scale, 1e-9, law)
                # walls take up couples; without them the couples of all particles cancel
                linked = set(zip(pairs["id_1"].astype(int) - 1, pairs["id_2"].astype(int) - 1))
                for group in self.groups(len(couples), linked):
                    if free[group].all():
                        self.assertLess(np.abs(couples[group].sum(axis=0)).max() / scale, 1e-12, law)

    @staticmethod
    def groups(count, links):
        """Index lists of particles that are linked with each other."""
        label = list(range(count))
        for _ in range(count):
            for i, j in links:
                label[i] = label[j] = min(label[i], label[j])
        return [[i for i in range(count) if label[i] == k] for k in set(label)]

    def test_cohesive_forces(self):
        """Those with and without cohesion in the same state, against the host's definition of the
        area: sjkr2 by R and h alone, sjkr with a wall the section of the sphere of radius R."""
        for surface in "smooth", "multisphere contacts 16":
            for model in "sjkr", "sjkr2":
                law = f"{PAPER} cohesion {model}"
                sticky, dry = (crowd_rows(law, surface, f"{model}{d:g}", 0,
                                          cohesionEnergyDensity=d)
                               for d in (COHESION_ENERGY_DENSITY, 0.0))
                for rows, dry_rows, area in (
                        (sticky[1], dry[1], self.pair_area if model == "sjkr2" else None),
                        (sticky[2], dry[2], self.wall_area if model == "sjkr2" else self.section)):
                    if area is None:
                        continue
                    pull = dry_rows["fn"] - rows["fn"]
                    expected = COHESION_ENERGY_DENSITY * area(rows["radius"], rows["overlap"])
                    np.testing.assert_allclose(pull, expected, rtol=0, atol=1e-12 * np.abs(dry_rows["fn"]).max())

    @staticmethod
    def pair_area(radius, overlap):
        return 4.0 * math.pi * radius * overlap

    @staticmethod
    def wall_area(radius, overlap):
        return 2.0 * math.pi * radius * overlap

    @staticmethod
    def section(radius, overlap):
        return math.pi * (radius ** 2 - (radius - overlap) ** 2)


def check_same(test, law, found, wanted, least):
    """Particles of the last frame, and more than `least` contacts in each frame, are the same to 1e-9 of the largest."""
    (particles, contacts), (same_particles, same_contacts) = found, wanted
    for columns in ("fx", "fy", "fz"), ("tqx", "tqy", "tqz"), ("vx", "vy", "vz"):
        values, expected = vectors(particles, *columns), vectors(same_particles, *columns)
        test.assertLess(np.abs(values - expected).max() / np.abs(expected).max(), 1e-9, law)
    for step, expected in same_contacts.items():
        test.assertEqual(contacts[step].shape, expected.shape)
        test.assertGreater(len(expected), least)
        scale = np.abs(expected).max(axis=0)
        difference = np.abs(contacts[step] - expected) / np.where(scale > 0.0, scale, 1.0)
        test.assertLess(difference.max(), 1e-9, law)


class Batches(unittest.TestCase):
    """Forces in batches and by the host's own models, in the same state. `heating_tracking on` changes
    nothing but the way that is taken."""

    LAWS = [f"model {normal} tangential history {more}" for normal in ("hertz", "hooke") for more in
            ("", "cohesion sjkr rolling_friction cdt", "cohesion sjkr2 rolling_friction epsd2")]
    LAWS += ["model hertz/stiffness tangential history", "model hooke/stiffness tangential history",
             "model hertz tangential no_history rolling_friction epsd2"]

    def rows(self, law, surface, settings, name):
        script = crowd_script(law, surface, name, settings)
        script += "fix motion all nve/ellipsoid\n" + lists(name, 50).split("compute wall")[0] + dump(f"{name}.dump", 50) + "run 200\n"
        outcome = run(with_properties(script, law), name=f"in.{name}")
        return outcome.text, read_dump(f"{name}.dump")[1], read_rows(f"{name}.pairs")

    def test_results_of_the_hosts_models(self):
        for surface in "smooth", "multisphere contacts 16":
            for k, law in enumerate(self.LAWS):
                name = f"batch{surface[0]}{k}"
                text, particles, pairs = self.rows(law, surface, "tangential_damping on limitForce on", name)
                self.assertIn("forces of contacts are computed in batches", text)
                text, same_particles, same_pairs = self.rows(
                    law, surface, "tangential_damping on limitForce on heating_tracking on", f"{name}h")
                self.assertIn("one by one", text)
                self.assertIn("'heating_tracking on' does not run in batches", text)
                check_same(self, law, (particles, pairs), (same_particles, same_pairs), 20)

    def test_after_a_restart_file(self):
        """The models of the file, without pair_style: in batches as before, with the same forces."""
        law = self.LAWS[2]
        setup = crowd_setup("smooth")
        setup.pair = f"gran/ellipsoid {law} surface smooth"
        first = setup.with_particles(crowd((2.6e-3, 2.3e-3, 1.8e-3)), "kept.data") + "neigh_modify page 1000000\n"
        run(with_properties(first, law) + "fix motion all nve/ellipsoid\nrun 100\nwrite_restart kept.restart\n"
            + dump("written.dump", 100) + "run 100\n", name="in.written")
        again = with_properties(setup.header() + "read_restart kept.restart\n" + setup.properties(), law)
        again = re.sub(r"^pair_(style|coeff).*\n", "", again, flags=re.MULTILINE)
        text = run(again + "neigh_modify page 1000000\nfix motion all nve/ellipsoid\n" + dump("read.dump", 100)
                   + "run 100\n", name="in.read").text
        self.assertIn("forces of contacts are computed in batches", text)
        written, read = (read_dump(f"{name}.dump")[1] for name in ("written", "read"))
        for columns in ("fx", "fy", "fz"), ("tqx", "tqy", "tqz"), ("vx", "vy", "vz"):
            np.testing.assert_array_equal(vectors(read, *columns), vectors(written, *columns))
        self.assertGreater(np.abs(vectors(read, "fx", "fy", "fz")).max(), 0.0)

    def test_what_does_not_run_in_batches_says_so(self):
        for law, reason in (("model luding tangential history", "this 'model'"),
                            ("model hertz tangential history rolling_friction epsd", "this 'rolling_friction'")):
            text, _, _ = self.rows(law, "smooth", "", "one_by_one")
            self.assertIn(f"one by one, which takes longer: {reason} does not run in batches", text)


class BatchesAtWalls(unittest.TestCase):
    """Forces of walls in batches and by the host's own models, in the same state; `heating_tracking on` as above."""

    SURFACES = {"smooth": (1.8e-3, 2.3e-3, 2.6e-3), "multisphere contacts 16": (2.5e-3, 1.7e-3, 1.7e-3)}
    PLANES = """fix floor all {wall} primitive type 1 zplane 0.0 shear x 0.4 {settings}
fix lid all {wall} primitive type 1 zplane 0.0082 {settings}
"""
    # a floor that moves within itself, of two triangles; the thermo line has the force on it
    MESH = """fix plate all mesh/surface/stress file plate.stl type 1 surface_vel 0.3 -0.2 0.0
fix floor all {wall} mesh n_meshes 1 meshes plate {settings}
thermo_style custom step f_plate[1] f_plate[2] f_plate[3] f_plate[4] f_plate[5] f_plate[6]
thermo_modify format float %.15g
"""

    def rows(self, law, surface, settings, name, walls):
        """Output of the engine, last frame of the particles, frames of the contacts with walls, forces on the mesh."""
        setup = crowd_setup(surface)
        script = setup.with_particles(crowd(self.SURFACES[surface]), f"{name}.data") + "neigh_modify page 1000000\n"
        if surface != "smooth":
            script += subspheres(5)
        model, *contacts = surface.split(" ", 1)
        wall = f"wall/gran/ellipsoid {law} surface {model}"
        script += walls.format(wall=wall, settings=" ".join(contacts + [settings]))
        script += "fix motion all nve/ellipsoid\n" + lists(name, 50) + dump(f"{name}.dump", 50) + "thermo 50\nrun 200\n"
        text = run(with_properties(script, law), name=f"in.{name}").text
        table = re.findall(r"^ +(\d+)((?: +[-+.\de]+){6}) *$", text, flags=re.MULTILINE)
        return (text, read_dump(f"{name}.dump")[1], read_rows(f"{name}.walls"),
                np.array([[float(word) for word in row.split()] for _, row in table]))

    def compare(self, law, surface, name, walls):
        settings = "tangential_damping on limitForce on" if "/viscous" not in law else ""
        text, particles, contacts, forces = self.rows(law, surface, settings, name, walls)
        self.assertIn("(id floor): forces of contacts are computed in batches", text)
        text, same_particles, same_contacts, same_forces = self.rows(
            law, surface, f"{settings} heating_tracking on", f"{name}h", walls)
        self.assertIn("(id floor): forces of contacts are computed one by one, which takes longer: "
                      "'heating_tracking on' does not run in batches", text)
        check_same(self, law, (particles, contacts), (same_particles, same_contacts), 10)
        return forces, same_forces

    def test_planes(self):
        for surface in self.SURFACES:
            for k, law in enumerate(Batches.LAWS):
                self.compare(law, surface, f"plane{surface[0]}{k}", self.PLANES)

    def test_meshes(self):
        half, low = 0.5 * WIDTH, 0.0
        corners = [(-half, -half, low), (half, -half, low), (half, half, low), (-half, half, low)]
        write_stl("plate.stl", [[corners[k] for k in triangle] for triangle in ((0, 1, 2), (0, 2, 3))])
        for surface in self.SURFACES:
            for k in 1, 2, 8:
                forces, same = self.compare(Batches.LAWS[k], surface, f"mesh{surface[0]}{k}", self.MESH)
                self.assertEqual(forces.shape, (5, 6))
                self.assertGreater(np.abs(same[-1]).min(), 0.0)
                np.testing.assert_allclose(forces, same, rtol=1e-9, atol=1e-9 * np.abs(same).max())


class Refused(unittest.TestCase):
    LAWS = [("model edinburgh tangential history", "model edinburgh", "luding"),
            ("model edinburgh/stiffness tangential history", "model edinburgh/stiffness", "luding"),
            ("model thornton_ning tangential history", "model thornton_ning", "luding"),
            ("model hertz tangential history cohesion easo/capillary/viscous",
             "cohesion easo/capillary/viscous", "sjkr"),
            ("model hertz tangential history cohesion washino/capillary/viscous",
             "cohesion washino/capillary/viscous", "sjkr"),
            ("model hertz tangential history rolling_friction epsd3", "rolling_friction epsd3",
             "epsd")]
    if host_is_inl():
        LAWS += [(f"model hertz tangential history cohesion {bond}", f"cohesion {bond}", "sjkr")
                 for bond in ("bond", "bond/nonlinear")]
    if HOST_IS_PICI:
        LAWS += [("model jkr tangential history", "model jkr", "sjkr"),
                 ("model hertz tangential jkr_tan", "tangential jkr_tan", "history"),
                 ("model hertz tangential history rolling_friction cdt_jkr", "rolling_friction cdt_jkr", "cdt")]

    def test_models_that_need_another(self):
        laws = [("model hertz tangential tan_luding", "tan_luding needs 'model luding'"),
                ("model hertz tangential history rolling_friction luding", "luding needs 'model luding'")]
        if host_is_inl():
            laws += [("model hertz tangential hysteretic/nonlinear", "tangential hysteretic/nonlinear needs "
                      "'model hysteretic/nonlinear1' or 'model hysteretic/nonlinear2'")]
        for law, words in laws:
            self.assertIn(words, refusal("", Setup(pair=f"gran/ellipsoid {law} surface smooth")))
            self.assertIn(words, refusal(f"fix floor all wall/gran/ellipsoid {law} surface smooth primitive type 1 "
                                         "zplane 0.0\n"))

    def test_settings_that_cannot_work(self):
        for law, keyword in (
                *(("model hooke tangential history", f"compute{energy}") for energy in ("ElasticPotential", "DissipatedEnergy")),
                ("model luding tangential tan_luding rolling_friction luding", "torsion"),
                ("model hertz tangential history", "heating_normal_hertz"),
                ("model hooke tangential history", "heating_normal_hooke"),
                ("model hertz tangential history", "heating_tangential_history"),
                ("model hertz tangential history", "disableNormalWhenBonded"),
                ("model hertz tangential no_history", "disableTangentialWhenBonded")):
            properties = with_properties("pair_style", law).split("pair_style")[0]
            line = refusal(properties, Setup(pair=f"gran/ellipsoid {law} surface smooth {keyword} on"))
            self.assertIn(f"'{keyword}' has the value 'on'", line)
            if re.search("Energy|Elastic|Bonded", keyword):
                continue  # at walls the host itself stops before
            line = refusal(f"{properties}fix floor all wall/gran/ellipsoid {law} surface smooth primitive type 1 zplane 0.0 "
                           f"{keyword} on\n")
            self.assertIn(f"'{keyword}' has the value 'on'", line)

    def test_models_that_cannot_work(self):
        for surface in "smooth", "multisphere":
            for law, *words in self.LAWS:
                line = refusal("", Setup(pair=f"gran/ellipsoid {law} surface {surface}"))
                for word in ("gran/ellipsoid", "does not work with ellipsoids", *words):
                    self.assertIn(word, line)
        for law, *words in self.LAWS:
            line = refusal(f"fix floor all wall/gran/ellipsoid {law} surface smooth primitive type 1 "
                           "zplane 0.0\n")
            for word in ("wall/gran/ellipsoid", "does not work with ellipsoids", *words):
                self.assertIn(word, line)


class Complete(unittest.TestCase):
    """Every model that the engine registers is tried or refused above, and on the page."""

    KEYWORDS = {"NORMAL": "model", "TANGENTIAL": "tangential", "COHESION": "cohesion",
                "ROLLING": "rolling_friction", "SURFACE": "surface"}

    def test_every_registered_model(self):
        page = (Path(os.environ["ELLIPSOID_SOURCE"]) / "src_liggghts/doc/contact_models.md").read_text()
        laws = WITHOUT_ROLLING + WITH_ROLLING + [row[0] for row in Refused.LAWS]
        tried = {tuple(pair) for law in laws for pair in re.findall(r"(\w+) (\S+)", law)}
        tried |= {("surface", name) for name in ("smooth", "multisphere")}
        unsuitable = {("surface", name) for name in ("default", "multicontact", "superquadric")}
        if host_is_inl():
            unsuitable |= {("surface", "superquadric/orthogonal")}
        registered = set()
        for header in (Path(os.environ["ELLIPSOID_BUILD"]) / "liggghts/patched/src").glob("*_model_*.h"):
            for kind, name in re.findall(r"^([A-Z]+)_MODEL\(\w+,\s*([^,]+?)\s*,", header.read_text(),
                                         re.MULTILINE):
                registered.add((self.KEYWORDS[kind], name))
        self.assertGreater(len(registered), 25)
        self.assertEqual(registered, tried | unsuitable)
        code = " ".join(re.findall(r"`([^`]+)`", page))
        for _, name in registered:
            self.assertRegex(code, rf"(?<![\w/]){re.escape(name)}(?![\w/])")
        for _, name in unsuitable:
            line = refusal("", Setup(pair=f"gran/ellipsoid model hertz surface {name}"))
            self.assertIn("needs 'surface smooth' or 'surface multisphere'", line)

    def test_every_setting_of_the_models_is_on_the_page(self):
        page = (Path(os.environ["ELLIPSOID_SOURCE"]) / "src_liggghts/doc/contact_models.md").read_text()
        code, settings = " ".join(re.findall(r"`([^`]+)`", page)), set()
        for header in (Path(os.environ["ELLIPSOID_BUILD"]) / "liggghts/patched/src").glob("*_model_*.h"):
            if not re.search("edinburgh|thornton|capillary|bond|epsd3|surface_model|viscous", header.name):  # refused, or our own
                settings |= set(re.findall(r'register(?:OnOff|YesNo|DoubleSetting)\("(\w+)"', header.read_text()))
        self.assertGreater(len(settings), 12)
        self.assertEqual([s for s in sorted(settings) if not re.search(rf"\b{s}\b", code)], [])


if __name__ == "__main__":
    unittest.main(verbosity=2)
