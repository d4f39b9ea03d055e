"""Heat conduction (the host's fix heat/gran/conduction) by the true area of contact: closed forms for
bodies side by side, crossed and tip to tip, chains of spheres by brute force over their spheres, walls of
both kinds, and spheres against the host's own."""

import math
import unittest

import numpy as np

from _engine import LAW, Material, Particle, Setup, host_is_inl, quaternion_of, rotation, run
from _multisphere import pair_contacts, wall_contacts
from _spinning import turned

K = (5.0, 12.0)  # conductivities of the two types, W/(m K)
TEMPERATURES = (400.0, 300.0, 310.0)
A, B, C = 2.7e-3, 1.9e-3, 1.1e-3
OVERLAP = 1e-6


def conductance(area, k1=K[0], k2=K[1]):
    """4 k1 k2 / (k1 + k2) sqrt(area), W/K."""
    return 4.0 * k1 * k2 / (k1 + k2) * math.sqrt(area)


def script(particles, pair="gran/ellipsoid", surface="surface smooth", law=LAW, atom_style="granular/ellipsoid",
           options="contact_area overlap", extra="", name="heat"):
    """Particles of these temperatures; the flux (W) of each is written."""
    setup = Setup(pair=f"{pair} {law} {surface}", materials=2 * [Material()], time_step=1e-9,
                  atom_style=atom_style)
    return setup.with_particles(particles, f"{name}.data") + f"""
fix k all property/global thermalConductivity peratomtype {K[0]} {K[1]}
fix c all property/global thermalCapacity peratomtype 10 10
fix y all property/global youngsModulusOriginal peratomtype 183e9 183e9
fix heat all heat/gran/conduction initial_temperature 300 {options}
{extra}
run 0
""" + "".join(f"set atom {i} property/atom Temp {t}\n"
              for i, t in enumerate(TEMPERATURES[:len(particles)], 1)) + f"""
run 1
write_dump all custom {name}.dump id f_heatFlux modify sort id format "%d %.17g"
"""


def fluxes(particles, name, ranks=1, **options):
    run(script(particles, name=name, **options), ranks, name=f"in.{name}")
    return np.loadtxt(f"{name}.dump", skiprows=9, ndmin=2)[:, 1]


def pair_along(axis, length, first, second, overlap=OVERLAP):
    """Two bodies that overlap along an axis, at `length` from centre to centre at touch."""
    place = np.zeros(3)
    place[axis] = length - overlap
    turn = quaternion_of((1, 2, 3), 0.7)  # nothing lies along the axes of the box
    r = rotation(turn)
    return [Particle((0, 0, 0), first[0], tuple(turned(turn, first[1])), type=1),
            Particle(tuple(r @ place), second[0], tuple(turned(turn, second[1])), type=2)]


STRAIGHT = (1.0, 0.0, 0.0, 0.0)
CROSSED = quaternion_of((0, 1, 0), math.pi / 2)  # x goes to -z, z to x


class Pairs(unittest.TestCase):
    #: name: (bodies, principal radii of curvature of the first, of the second along the same two axes)
    SCENES = {
        "side by side": (pair_along(1, 2 * B, ((A, B, C), STRAIGHT), ((A, B, C), STRAIGHT)),
                         (A * A / B, C * C / B), (A * A / B, C * C / B)),
        "crossed": (pair_along(1, 2 * B, ((A, B, C), STRAIGHT), ((A, B, C), CROSSED)),
                    (A * A / B, C * C / B), (C * C / B, A * A / B)),
        "tip to tip": (pair_along(0, 2 * A, ((A, B, C), STRAIGHT), ((A, B, C), STRAIGHT)),
                       (B * B / A, C * C / A), (B * B / A, C * C / A)),
        "oblate on its face": (pair_along(2, 2 * C, ((B, B, C), STRAIGHT), ((A, B, C), STRAIGHT)),
                               (B * B / C, B * B / C), (A * A / C, B * B / C)),
    }

    def expected(self, scene):
        _, first, second = self.SCENES[scene]
        product = math.prod(1.0 / r + 1.0 / s for r, s in zip(first, second))
        return conductance(2.0 * math.pi * OVERLAP / math.sqrt(product)) * 100.0

    def test_area_of_overlap(self):
        for number, scene in enumerate(self.SCENES):
            for law in (LAW, "model hertz tangential history"):
                found = fluxes(self.SCENES[scene][0], f"scene{number}", law=law)
                np.testing.assert_allclose(found, np.array([-1.0, 1.0]) * self.expected(scene), rtol=2e-3,
                                           err_msg=scene)  # h over the radii of curvature

    def test_constant_area_and_true_stiffness(self):
        bodies = self.SCENES["crossed"][0]
        found = fluxes(bodies, "constant", options="contact_area constant 3e-8")
        np.testing.assert_allclose(found, np.array([-1.0, 1.0]) * conductance(3e-8) * 100.0, rtol=1e-9)
        found = fluxes(bodies, "corrected", options="contact_area overlap area_correction yes")
        softer = (183e6 / 183e9) ** (2.0 / 3.0)  # overlaps at the same force, F ~ E h^1.5
        np.testing.assert_allclose(found, np.array([-1.0, 1.0]) * self.expected("crossed") * math.sqrt(softer),
                                   rtol=2e-3)

    def test_temperatures_follow_the_fluxes(self):
        bodies, steps = self.SCENES["crossed"][0], 200
        text = script(bodies, name="follow").replace("run 1\n", f"run {steps}\n").replace(
            "f_heatFlux", "f_Temp")
        run(text, name="in.follow")
        temperatures = np.loadtxt("follow.dump", skiprows=9)[:, 1]
        change = self.expected("crossed") * steps * 1e-9 / (10.0 * bodies[0].mass)  # capacity 10 J/(kg K)
        np.testing.assert_allclose(temperatures - TEMPERATURES[:2], [-change, change], rtol=1e-2)

    def test_projection_is_refused(self):
        for text in (script(self.SCENES["crossed"][0], options="contact_area projection"),
                     script(self.SCENES["crossed"][0], extra=f"fix w all wall/gran/ellipsoid {LAW} surface "
                            "smooth primitive type 1 zplane -0.04 temperature 300 contact_area projection")):
            outcome = run(text, check=False)
            self.assertEqual(outcome.code, 1)
            self.assertRegex(outcome.text, "ERROR[^\n]*projection[^\n]*use 'contact_area overlap' or 'constant")

    def test_shape_of_the_area_of_liggghts_inl(self):
        """`area_shape circle`: by the radius of a circle of this area; other hosts have no such keyword."""
        bodies = self.SCENES["crossed"][0]
        options = "contact_area overlap area_shape circle"
        if not host_is_inl():
            outcome = run(script(bodies, options=options), check=False)
            self.assertEqual(outcome.code, 1)
            self.assertRegex(outcome.text, "ERROR[^\n]*unknown keyword")
            return
        found = fluxes(bodies, "circle", options=options)
        np.testing.assert_allclose(found, np.array([-1.0, 1.0]) * self.expected("crossed") / math.sqrt(math.pi),
                                   rtol=2e-3)

    def test_areas_of_other_bodies_are_refused(self):
        for area in ("superquadric", "convex"):
            for text in (script(self.SCENES["crossed"][0], options=f"contact_area {area}"),
                         script(self.SCENES["crossed"][0], extra=f"fix w all wall/gran/ellipsoid {LAW} surface "
                                f"smooth primitive type 1 zplane -0.04 temperature 300 contact_area {area}")):
                outcome = run(text, check=False)
                self.assertEqual(outcome.code, 1)
                self.assertRegex(outcome.text, "ERROR[^\n]*'overlap'" if not host_is_inl() else
                                 "ERROR[^\n]*'contact_area superquadric' and 'convex'[^\n]*use 'contact_area overlap'")

    def test_chain_of_spheres_sums_over_its_contacts(self):
        count = 17
        bodies = pair_along(1, 2 * C, ((A, C, C), STRAIGHT), ((A, C, C), STRAIGHT), overlap=5e-5)
        contacts = pair_contacts(*bodies, count, count)
        self.assertGreater(len(contacts), 2)
        total = 100.0 * sum(conductance(2.0 * math.pi * radius * overlap) for _, overlap, radius, _ in contacts)
        extra = f"fix subspheres all property/atom subspheres scalar yes yes no {count}"
        found = fluxes(bodies, "chains", surface="surface multisphere", extra=extra)
        np.testing.assert_allclose(found, [-total, total], rtol=2e-3)
        mean = fluxes(bodies, "mean", surface="surface multisphere multicontact average", extra=extra)
        np.testing.assert_allclose(mean, found / len(contacts), rtol=1e-9)

    def test_spheres_are_those_of_the_host(self):
        radius, h = 2e-3, 1e-5
        bodies = [Particle((0.0, 0.0, 0.0), (radius,) * 3, type=1),
                  Particle((0.0, 2 * radius - h, 0.0), (radius,) * 3, type=2),
                  Particle((2 * radius - h, 0.0, 0.0), (radius,) * 3, type=1)]
        law = "model hertz tangential history"
        host = fluxes(bodies, "host", pair="gran", surface="", law=law, atom_style="sphere")
        for ranks in (1, 4):
            found = fluxes(bodies, f"spheres{ranks}", ranks, law=law)
            np.testing.assert_allclose(found, host, rtol=h / radius)
            self.assertAlmostEqual(found.sum(), 0.0, delta=1e-9 * np.abs(found).max())


class Walls(unittest.TestCase):
    HOT = 500.0

    def check(self, wall, surface, body, areas, extra=""):
        found = fluxes([body], "wall", surface=f"surface {surface}", extra=extra + "\n" + wall)
        expected = sum(conductance(area) for area in areas) * (self.HOT - TEMPERATURES[0])
        np.testing.assert_allclose(found, [expected], rtol=2e-3)

    def test_plane_and_mesh(self):
        turn = quaternion_of((1, 2, 3), 0.7)
        up = rotation(turn).T @ [0.0, 0.0, 1.0]  # in the frame of the body
        stretched = np.array([A, B, C]) * up
        height = np.linalg.norm(stretched)
        body = Particle((0, 0, height - OVERLAP), (A, B, C), turn, type=1)
        radius = A * B * C / height ** 2  # Gaussian, of the surface where it is level
        area = 2.0 * math.pi * radius * OVERLAP
        plane = (f"fix w all wall/gran/ellipsoid {LAW} surface smooth primitive type 2 zplane 0.0 "
                 f"temperature {self.HOT}")
        self.check(plane, "smooth", body, [area])
        with open("floor.stl", "w", encoding="ascii") as file:
            file.write("solid floor\nfacet normal 0 0 1\nouter loop\nvertex -0.02 -0.02 0\n"
                       "vertex 0.03 -0.02 0\nvertex -0.02 0.03 0\nendloop\nendfacet\nendsolid floor\n")
        mesh = (f"fix cad all mesh/surface file floor.stl type 2 temperature {self.HOT}\nfix w all "
                f"wall/gran/ellipsoid {LAW} surface smooth mesh n_meshes 1 meshes cad")
        self.check(mesh, "smooth", body, [area])
        if host_is_inl():
            for wall in (f"{plane} area_shape circle", f"{mesh} area_shape circle"):
                self.check(wall, "smooth", body, [area / math.pi])
        chain = Particle((0, 0, B - OVERLAP), (A, B, B), type=1)
        areas = [2.0 * math.pi * r * h for _, h, r, _ in wall_contacts(chain, 17, (0, 0, 0), (0, 0, -1.0))]
        self.check(plane.replace("smooth", "multisphere"), "multisphere", chain, areas,
                   "fix subspheres all property/atom subspheres scalar yes yes no 17")

    def test_chain_on_a_mesh(self):
        chain = Particle((0, 0, C - 5e-5), (A, C, C), type=1)
        contacts = wall_contacts(chain, 17, (0, 0, 0), (0, 0, -1.0))
        self.assertGreater(len(contacts), 2)
        with open("two.stl", "w", encoding="ascii") as file:  # a seam below the middle of the body
            file.write("solid two\n" + "".join(
                "facet normal 0 0 1\nouter loop\n" + "".join(f"vertex {x} {y} 0\n" for x, y in corners)
                + "endloop\nendfacet\n" for corners in (
                    ((-0.02, -0.02), (0.02, -0.02), (0.02, 0.02)), ((-0.02, -0.02), (0.02, 0.02), (-0.02, 0.02))))
                + "endsolid two\n")
        mesh = (f"fix cad all mesh/surface file two.stl type 2 temperature {self.HOT}\nfix w all wall/gran/ellipsoid "
                f"{LAW} surface multisphere mesh n_meshes 1 meshes cad contacts 20")
        found = fluxes([chain], "wall", surface="surface multisphere", extra="fix subspheres all property/atom "
                       "subspheres scalar yes yes no 17\n" + mesh)
        expected = sum(conductance(2.0 * math.pi * r * h) for _, h, r, _ in contacts) * (self.HOT - TEMPERATURES[0])
        np.testing.assert_allclose(found, [expected], rtol=2e-2)  # overlap over radius of the spheres

    def test_cylinder(self):
        """The gap has the curvature of the body, less (inside) or more (outside) that of the wall around the axis:
        an ellipse 2 pi R h with 1/R^2 = k_along k_around."""
        radius = 5e-3
        for side, sign in (("inside", -1.0), ("outside", 1.0)):
            wall = (f"fix w all wall/gran/ellipsoid {LAW} surface smooth primitive type 2 xcylinder {radius} 0 0 "
                    f"temperature {self.HOT}")
            with self.subTest(side=side):
                for axes in ((A, B, C), (B, A, C), (C, A, B)):  # along the axis, around it, to the wall
                    h = OVERLAP
                    at = radius + sign * (axes[2] - h)
                    body = Particle((1e-3, 0.0, -at), axes, type=1)
                    if axes[1] ** 2 / axes[2] > radius and side == "inside":
                        continue  # rests on its tips
                    along = axes[2] / axes[0] ** 2
                    around = axes[2] / axes[1] ** 2 + sign / radius
                    self.check(wall, "smooth", body, [2.0 * math.pi * h / math.sqrt(along * around)])
                chain = Particle((1e-3, 0.0, -(radius + sign * (C - OVERLAP))), (A, C, C), type=1)
                areas = [2.0 * math.pi * h / math.sqrt((1.0 / r) * (1.0 / r + sign / radius))
                         for _, h, r, _ in wall_contacts(chain, 17, (0, 0, -radius), (0, 0, sign))]
                self.check(wall.replace("smooth", "multisphere"), "multisphere", chain, areas,
                           "fix subspheres all property/atom subspheres scalar yes yes no 17")

    def test_settings_of_the_models_change_no_area(self):
        """An elliptic contact has another radius in the law, and averaged contacts share their force."""
        body = Particle((0, 0, C - OVERLAP), (A, B, C), type=1)
        wall = (f"fix w all wall/gran/ellipsoid {LAW} surface smooth primitive type 2 zplane 0.0 "
                f"temperature {self.HOT} ellipticalContact on")
        self.check(wall, "smooth ellipticalContact on", body, [2.0 * math.pi * A * B / C * OVERLAP])
        chain = Particle((0, 0, C - 5e-5), (A, C, C), type=1)
        contacts = wall_contacts(chain, 17, (0, 0, 0), (0, 0, -1.0))
        self.assertGreater(len(contacts), 2)
        mean = [2.0 * math.pi * r * h / len(contacts) ** 2 for _, h, r, _ in contacts]
        wall = wall.replace("smooth", "multisphere").replace("ellipticalContact on", "multicontact average")
        found = fluxes([chain], "shared", surface="surface multisphere multicontact average", extra="fix subspheres "
                       "all property/atom subspheres scalar yes yes no 17\n" + wall)
        expected = sum(map(conductance, mean)) * (self.HOT - TEMPERATURES[0])
        np.testing.assert_allclose(found, [expected], rtol=2e-2)  # overlap over radius of the spheres


if __name__ == "__main__":
    unittest.main(verbosity=2)
