# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""What takes the place of the host's fix continuum/weighted, which is refused with ellipsoids: `fields` with the engine's
list of contacts. The stress at a place, of bodies of 17 spheres with all contacts of their spheres, against the sum over
the overlaps of the spheres themselves; its mean over a periodic box against the engine's virial."""
import itertools
import math
import os
import sys

import numpy as np

from _synthetic import json_of

sys.path.insert(0, os.path.join(os.environ["ELLIPSOID_SOURCE"], "tests", "engine"))
from _brute_force import sphere_chain, turn  # noqa: E402
from _engine import LAW, Particle, Setup, quaternion_of, run, thermo  # noqa: E402

A, B, COUNT = 2.0e-3, 1.2e-3, 17
MODULUS, RATIO = 5e7, 0.3
CELL = np.array([2.39e-3, 3.98e-3, 2.39e-3])
BOX = CELL * (4, 2, 2)
PLACES = np.array([[2.1e-3, 2.0e-3, 2.4e-3], [4.8e-3, 0.3e-3, 1.0e-3], [9.4e-3, 4.0e-3, 3.1e-3]])
AXES = "xyz"


def crowd():
    """Sixteen bodies at rest that touch each other side by side, over the faces of the box as well."""
    random = np.random.default_rng(3)
    return [Particle(tuple(CELL * (np.array(c) + 0.5)), (A, B, B),
                     quaternion_of((0, 0.02, 1), 0.5 * math.pi + random.uniform(-0.02, 0.02)))
            for c in itertools.product(range(4), range(2), range(2))]


def contacts(bodies):
    """[(x_i, x_j, point, force on i)] of all spheres that overlap, the images of j included; 4/3 E sqrt(R h^3)."""
    along, radii = sphere_chain(A, B, COUNT)
    stiff = MODULUS / (2 * (1 - RATIO ** 2))
    centres = [np.array(p.position) + np.outer(along, turn(np.array(p.quaternion))[:, 0]) for p in bodies]
    found = []
    for i, j in itertools.combinations(range(len(bodies)), 2):
        for image in itertools.product((-1, 0, 1), repeat=3):
            shift = np.array(image) * BOX
            way = centres[j][None] + shift - centres[i][:, None]
            length = np.linalg.norm(way, axis=2)
            for p, q in np.argwhere(length < radii[:, None] + radii[None]):
                h, n = radii[p] + radii[q] - length[p, q], way[p, q] / length[p, q]
                force = 4.0 / 3.0 * stiff * math.sqrt(radii[p] * radii[q] / (radii[p] + radii[q]) * h ** 3)
                found.append((np.array(bodies[i].position), np.array(bodies[j].position) + shift,
                              centres[i][p] + (radii[p] - 0.5 * h) * n, -force * n))
    return found


def share_within(place, radius, begin, end):
    """Of a straight way, within a ball."""
    way, offset = end - begin, begin - place
    a, b, c = way @ way, 2.0 * way @ offset, offset @ offset - radius ** 2
    root = b * b - 4.0 * a * c
    if root <= 0.0:
        return 0.0
    low, high = ((-b + sign * math.sqrt(root)) / (2.0 * a) for sign in (-1, 1))
    return max(0.0, min(1.0, high) - max(0.0, low))


def stress_at(place, radius, found):
    """Sum over both sides of each contact of f b, times the share of b in the ball, over the ball's volume."""
    total = np.zeros((3, 3))
    for x_i, x_j, point, force in found:
        for centre, f in ((x_i, force), (x_j, -force)):
            for image in itertools.product((-1, 0, 1), repeat=3):
                shift = np.array(image) * BOX
                total += np.outer(f, centre - point) * share_within(place, radius, point + shift, centre + shift)
    return total / (4.0 / 3.0 * math.pi * radius ** 3)


def simulate():
    setup = Setup(box=tuple(v for length in BOX for v in (0.0, float(length))), boundary="p p p", skin=3e-4,
                  pair=f"gran/ellipsoid {LAW} surface multisphere contacts 40", friction=0.0)
    setup.materials[0].youngs_modulus, setup.materials[0].poissons_ratio = MODULUS, RATIO
    columns = "id type mass x y z vx vy vz quat1 quat2 quat3 quat4 shapex shapey shapez f_subspheres"
    run(setup.with_particles(crowd()) + "neigh_modify page 2000000\n"
        f"fix subspheres all property/atom subspheres scalar yes yes no {COUNT}\n"
        "fix spacing all property/atom spacing scalar yes yes no 0\nfix motion all nve/ellipsoid\n"
        "compute c all pair/ellipsoid/local id contactPoint force\ncompute p all pressure thermo_temp virial\n"
        f"dump d all custom 1 bed.dump {columns}\ndump_modify d format \"%d %d{' %.17g' * 15}\"\n"
        f"dump l all local 1 contacts.local {' '.join(f'c_c[{k}]' for k in range(1, 9))}\n"
        f"dump_modify l format \"%.0f %.0f{' %.17g' * 6}\"\n"
        "thermo_style custom step c_p[1] c_p[2] c_p[3] c_p[4] c_p[5] c_p[6] vol\n"
        "thermo_modify format float %.17g\nrun 0\n")
    return thermo("log.in.run", 8)[-1][1:]


def tensor(row):
    return np.array([[row[f"contact_stress_{a}{b}_Pa"] for b in AXES] for a in AXES])


def main():
    *virial, _ = simulate()
    found = contacts(crowd())
    pairs = {(tuple(c[0]), tuple(c[1])) for c in found}
    assert len(found) > 2 * len(pairs) > 20, (len(found), len(pairs))  # several contacts of a pair
    lists = ("--contacts", "contacts.local", "--id-columns", "c_c[1]", "c_c[2]", "--point-columns", "c_c[3]",
             "c_c[4]", "c_c[5]", "--force-columns", "c_c[6]", "c_c[7]", "c_c[8]")
    for radius in (1.5e-3, 3e-3):
        rows = json_of("fields", "bed.dump", "--at", *PLACES.ravel(), "--kernel", "heaviside", "--width", radius, *lists)
        for place, row in zip(PLACES, rows):
            expected = stress_at(place, radius, found)
            error = np.abs(tensor(row) - expected).max() / np.abs(expected).max()
            assert error < 1e-9, (place, radius, error)
    mean = np.mean([tensor(row) for row in json_of("fields", "bed.dump", "--grid", 24, 12, 12, "--kernel", "lucy",
                                                   "--width", 1.5e-3, *lists)], axis=0)
    # of the parts apart from the diagonal the virial has those whose second index is that of the force
    found_virial = mean[[0, 1, 2, 1, 2, 2], [0, 1, 2, 0, 0, 1]]
    error = np.abs(found_virial - virial).max() / np.abs(virial).max()
    print(f"{len(found)} contacts of {len(pairs)} pairs; mean over the box: off the virial by {error:.1e}")
    assert error < 1e-3, (mean, virial)  # of the grid's sum over the function


main()
