"""What the tests of multi-spheres share: the chain of spheres by the paper's equations, contacts by
brute force over all pairs of spheres, and set-ups.

The chain is computed here once more from eqs. (3) to (8) of Markauskas et al. 2010, so that the
engine's chain is tested, too.
"""

import math

import numpy as np

from _engine import LAW, Setup, rotation

SURFACE = "surface multisphere"


def chain(a, b, count):
    """Centres (N,) and radii (N,) of the paper's chain along the body's x axis (m)."""
    if count == 1:
        return np.zeros(1), np.array([b])
    if count == 3 and a >= 2 * b:  # the chain of the equations does not overlap
        return np.array([-1.0, 0.0, 1.0]) * 0.5 * (a + b), np.array([a - b, 2 * b, a - b]) / 2.0
    n, last = count // 2, a - b * b / a  # eq. 5

    def centres(first):
        x, distance = [0.0], first
        for _ in range(n):
            x.append(x[-1] + distance)
            distance *= math.sqrt(max(0.0, 1 - (x[-1] / a) ** 2) / (1 - (x[-2] / a) ** 2)) \
                if x[-1] < a else 0.0  # eq. 7
        return x

    low, high = 0.0, a
    while low < (middle := 0.5 * (low + high)) < high:  # eq. 8
        low, high = (middle, high) if centres(middle)[-1] < last else (low, middle)
    x = np.array(centres(low))
    radii = b * np.sqrt((a * a - b * b - x * x) / (a * a - b * b))  # eq. 4
    return np.concatenate([-x[:0:-1], x]), np.concatenate([radii[:0:-1], radii])


def spheres(particle, count):
    """Centres from the particle's centre (N, 3) in space, radii (N,)."""
    x, radii = chain(particle.semiaxes[0], particle.semiaxes[1], count)
    return np.outer(x, rotation(particle.quaternion)[:, 0]), radii


def pair_contacts(i, j, count_i, count_j):
    """All touching pairs of spheres: (normal from i to j, overlap, reduced radius, point from the
    centre of i), by brute force."""
    (centres_i, radii_i), (centres_j, radii_j) = spheres(i, count_i), spheres(j, count_j)
    between = np.subtract(j.position, i.position)
    found = []
    for c, r in zip(centres_i, radii_i):
        for d, s in zip(centres_j, radii_j):
            way = between + d - c
            length = np.linalg.norm(way)
            if length < r + s:
                normal, overlap = way / length, r + s - length
                found.append((normal, overlap, r * s / (r + s), c + (r - 0.5 * overlap) * normal))
    return found


def wall_contacts(i, count, wall_point, wall_normal):
    """The same with a plane; the normal points from the particle into the wall."""
    centres, radii = spheres(i, count)
    distance = (np.asarray(wall_point) - i.position) @ wall_normal
    return [(np.asarray(wall_normal), h, r, c + (r - 0.5 * h) * np.asarray(wall_normal))
            for c, r in zip(centres, radii) if (h := r + c @ wall_normal - distance) > 0.0]


def contact_force(contact, i, j, setup, spring_time=0.0):
    """Force on i (3,) by eqs. (23) and (24) of one contact; the spring has grown for `spring_time`
    at the present slip. `j` is None for a wall at rest."""
    normal, overlap, radius, point = contact
    e, nu = setup.materials[0].youngs_modulus, setup.materials[0].poissons_ratio
    velocity = np.add(i.velocity, np.cross(i.omega, point))
    mass = i.mass
    if j is not None:
        lever = point + np.subtract(i.position, j.position)
        velocity = velocity - np.add(j.velocity, np.cross(j.omega, lever))
        mass = i.mass * j.mass / (i.mass + j.mass)
    approach = velocity @ normal  # positive while the bodies approach
    slip = velocity - approach * normal
    root = math.sqrt(radius * overlap)
    pressing = (2.0 / 3.0 * e / (1.0 - nu ** 2) * root * overlap
                + setup.damping_normal * mass * approach)  # eq. 23
    stiffness = 8.0 / 3.0 * e / (2.0 * (1.0 + nu)) * root / (2.0 - nu)  # eq. 24
    trial = -(stiffness * spring_time + setup.damping_tangential * mass) * slip
    limit = setup.friction * abs(pressing)
    return -pressing * normal + trial * min(1.0, limit / max(np.linalg.norm(trial), 1e-300))


def summed(contacts, i, j, setup, spring_time=0.0, weight=1.0):
    """Force and torque on i, and on j about its own centre: eq. (25)."""
    total = np.zeros((4, 3))
    for contact in contacts:
        force = weight * contact_force(contact, i, j, setup, spring_time)
        total[0] += force
        total[1] += np.cross(contact[3], force)
        if j is not None:
            total[2] -= force
            total[3] -= np.cross(contact[3] + np.subtract(i.position, j.position), force)
    return total


def multisphere_setup(settings="", **options):
    """Setup with pair_style gran/ellipsoid ... surface multisphere."""
    return Setup(pair=f"gran/ellipsoid {LAW} {SURFACE} {settings}", **options)


def subspheres(count, counts=()):
    """Script lines that give all particles `count` sub-spheres; `counts` has (particle id, N) of
    those that have another number (the host allows `set` only after a run)."""
    text = f"fix subspheres all property/atom subspheres scalar yes yes no {count}\n"
    if counts:
        text += "run 0\n"
    return text + "".join(f"set atom {i} property/atom subspheres {n}\n" for i, n in counts)


def wall(name, plane, position, settings="", surface=SURFACE):
    """Script line of a wall."""
    return (f"fix {name} all wall/gran/ellipsoid {LAW} {surface} "
            f"primitive type 1 {plane} {position!r} {settings}\n")
