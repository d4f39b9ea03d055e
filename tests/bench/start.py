"""Initial states for the benchmarks: data files of LIGGGHTS.

    python3 start.py compaction --shape smooth > start.data
    python3 start.py superquadric start.data     # the same bodies for the host's superquadrics:
                                                 # start.data.superquadric, start.data.superquadric.in

Particles are the paper's ellipsoids (table 1), or the sphere of the same section (compaction) or the
same volume (beds, clouds). SI units. Seeds are fixed: the same states in every run.
"""

import argparse
import math
import os
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parent.parent / "engine"))
os.environ.setdefault("ELLIPSOID_BIN", "")  # _engine wants to know it; nothing is run here
from _engine import Particle, ellipsoids_data, quaternion_of, spheres_data  # noqa: E402

A, B, MASS = 2.7e-3, 1.15e-3, 2e-5  # semi-axes (m), mass (kg): Markauskas et al. 2010, table 1
MOMENTS = (1.058e-11, 3.445e-11, 3.445e-11)
SECTION_RADIUS = math.sqrt(A * B)  # of the sphere with the same area in the plane (m)
VOLUME_RADIUS = (A * B * B) ** (1.0 / 3.0)  # of the sphere with the same volume (m)

COMPACTION_COUNT = 1000
COMPACTION_BOX = math.sqrt(math.pi * A * B * COMPACTION_COUNT / 0.45)  # length, height (m)
COMPACTION_WAY = COMPACTION_BOX * (1.0 - 0.45 / 0.80)  # of the moving side (m)
ROW_SPACING = 1.25  # of the spheres that are the moving side, over their radius
ALMOST_ONE = 1.0 + 1e-5  # multi-spheres need a > b: these are spheres all the same


def data_file(shape, particles, box, types=1):
    """Text of a data file for spheres or for all ellipsoidal shapes."""
    rows = spheres_data if shape == "sphere" else ellipsoids_data
    return rows(particles, box, types)


def separated(place, angle, places, angles, semiaxes):
    """Which of the ellipses `places` (k, 2), `angles` (k,) are proven apart from one ellipse.

    Perram and Wertheim 1985: apart if s (1 - s) r' (s B + (1 - s) A)^-1 r > 1 for some s in (0, 1).
    """
    def tensors(theta):
        c, s = np.cos(theta), np.sin(theta)
        aa, bb = semiaxes[0] ** 2, semiaxes[1] ** 2
        return np.stack([aa * c * c + bb * s * s, (aa - bb) * c * s, aa * s * s + bb * c * c])
    x, y = (places - place).T
    share = np.linspace(0.02, 0.98, 33)[:, None]
    xx, xy, yy = (share * t + (1 - share) * u
                  for t, u in zip(tensors(angles), tensors(np.array([angle]))))
    value = share * (1 - share) * (x * x * yy - 2 * x * y * xy + y * y * xx) / (xx * yy - xy * xy)
    return value.max(axis=0) > 1.0


def random_ellipses(semiaxes, count, length, height):
    """Places (N, 2) and angles (N,) of ellipses that do not overlap each other nor the box, put in
    one after the other at random."""
    random = np.random.default_rng(2010)
    places, angles = np.zeros((count, 2)), np.zeros(count)
    size, placed = np.array([length, height]), 0
    while placed < count:
        angle = random.uniform(0.0, math.pi)
        extent = np.hypot(semiaxes[0] * np.array([math.cos(angle), math.sin(angle)]),
                          semiaxes[1] * np.array([math.sin(angle), math.cos(angle)]))
        place = extent + random.uniform(size=2) * (size - 2.0 * extent)
        distance = np.linalg.norm(places[:placed] - place, axis=1)
        near = np.flatnonzero(distance < 2.0 * semiaxes[0])
        if near.size and not separated(place, angle, places[near], angles[near], semiaxes).all():
            continue
        places[placed], angles[placed] = place, angle
        placed += 1
    return places, angles


def compaction(shape):
    """Data file of the compaction: atom type 1 the particles, 2 the row that is the moving side."""
    sphere = shape == "sphere"
    semiaxes = (SECTION_RADIUS,) * 2 if sphere else (A, B)
    places, angles = random_ellipses(semiaxes, COMPACTION_COUNT, COMPACTION_BOX, COMPACTION_BOX)
    velocities = np.random.default_rng(17).normal(scale=0.05, size=places.shape)
    moments = (MOMENTS[1],) * 3 if sphere else MOMENTS
    particles = [
        Particle((*p, 0.0), (semiaxes[0], semiaxes[1], semiaxes[1]),
                 quaternion_of((0.0, 0.0, 1.0), angle), (*v, 0.0), mass=MASS, moments=moments)
        for p, angle, v in zip(places, angles, velocities)]
    steps = math.ceil((COMPACTION_BOX / B - 2.0) / ROW_SPACING)
    for y in np.linspace(B, COMPACTION_BOX - B, steps + 1):
        particles.append(Particle((COMPACTION_BOX + B, y, 0.0), (B * ALMOST_ONE, B, B), type=2))
    box = (-0.001, COMPACTION_BOX + 4 * B, -0.001, COMPACTION_BOX + 0.001, -2 * A, 2 * A)
    return data_file(shape, particles, box, 2)


def bodies(shape, places, quaternions, velocities, omegas=None, types=None):
    """Particles of one shape for the cases in space; arrays (N, 3), (N, 4)."""
    sphere = shape == "sphere"
    semiaxes = (VOLUME_RADIUS,) * 3 if sphere else (A, B, B)
    omegas = np.zeros_like(velocities) if omegas is None else omegas
    types = np.ones(len(places), int) if types is None else types
    return [Particle(tuple(x), semiaxes, tuple(q), tuple(v), tuple(w), mass=MASS,
                     moments=(MOMENTS[1],) * 3 if sphere else MOMENTS, type=int(t))
            for x, q, v, w, t in zip(places, quaternions, velocities, omegas, types)]


def lattice(shape, per_side, count, spacing):
    """Particles of random orientation and small random velocity on a cubic lattice above z = 0:
    `per_side` x `per_side` in a layer, `spacing` (m). Returns them, and the lattice's height."""
    random = np.random.default_rng(1789)
    index = np.arange(count)
    cells = np.stack([index % per_side, index // per_side % per_side, index // per_side ** 2], axis=1)
    quaternions = random.normal(size=(count, 4))
    quaternions /= np.linalg.norm(quaternions, axis=1, keepdims=True)
    particles = bodies(shape, (cells + 0.5) * spacing, quaternions,
                       random.normal(scale=0.1, size=(count, 3)))
    return particles, spacing * (cells[-1, 2] + 1)


def box_mesh(side, height, cells):
    """Floor and sides of a box in the corner of the axes, open above, as STL of 10 cells^2 triangles."""
    squares = ((0, 1, 2, 0.0), (1, 2, 0, 0.0), (1, 2, 0, side), (2, 0, 1, 0.0), (2, 0, 1, side))
    ticks = np.linspace(0.0, 1.0, cells + 1)
    lines = ["solid box"]
    for u, v, normal, at in squares:
        size = [height if axis == 2 else side for axis in range(3)]
        for u0, u1 in zip(ticks, ticks[1:]):
            for v0, v1 in zip(ticks, ticks[1:]):
                for corners in (((u0, v0), (u1, v0), (u1, v1)), ((u0, v0), (u1, v1), (u0, v1))):
                    lines += ["facet normal 0 0 0", "outer loop"]
                    for a, b in corners:
                        place = [at] * 3
                        place[u], place[v] = a * size[u], b * size[v]
                        lines.append("vertex " + " ".join(repr(float(x)) for x in place))
                    lines += ["endloop", "endfacet"]
    return "\n".join(lines + ["endsolid box"]) + "\n"


def tile(source, target, tiles, side):
    """Copies a data file `tiles` times in x and y, shifted by `side` (m) each."""
    head, rest = Path(source).read_text().split("\nAtoms\n\n")
    atoms, velocities = ([line.split() for line in part.strip().split("\n")]
                         for part in rest.split("\nVelocities\n"))
    x = 4 if len(atoms[0]) == 7 else 2  # column of x: spheres have diameter and density before it
    shifts = [(k * side, m * side) for k in range(tiles[0]) for m in range(tiles[1])]
    head = head.replace(f"{len(atoms)} atoms", f"{len(atoms) * len(shifts)} atoms")
    for name, count in zip("xy", tiles):
        head = head.replace(f"0.0 {side!r} {name}lo", f"0.0 {count * side!r} {name}lo")
    with open(target, "w") as file:
        file.write(head + "\nAtoms\n\n")
        first = 1
        for dx, dy in shifts:
            file.writelines(
                f"{first + k} {' '.join(w[1:x])} {float(w[x]) + dx!r} {float(w[x + 1]) + dy!r} "
                f"{' '.join(w[x + 2:])}\n" for k, w in enumerate(atoms))
            first += len(atoms)
        file.write("\nVelocities\n\n")
        for k in range(len(shifts)):
            file.writelines(f"{k * len(atoms) + m} {' '.join(w[1:])}\n"
                            for m, w in enumerate(velocities, 1))


def write_superquadrics(file):
    """A data file of ellipsoids for the host's atom style superquadric, which has no orientations in data files: these
    are commands of another file, to be included after it."""
    head, rest = Path(file).read_text().split("\nAtoms\n\n")
    atoms, velocities = rest.split("\nVelocities\n")
    rows, turns = [], []
    for words in map(str.split, atoms.strip().split("\n")):
        a, b, c, mass = (float(words[k]) for k in (5, 6, 7, 12))
        density = mass / (4.0 / 3.0 * math.pi * a * b * c)
        rows.append(" ".join([*words[:2], repr(density), *words[5:8], "2", "2", *words[2:5]]))
        turns.append(f"set atom {words[0]} quat_direct {' '.join(words[8:12])}\n")
    Path(f"{file}.superquadric").write_text(head + "\nAtoms\n\n" + "\n".join(rows) + "\n\nVelocities\n" + velocities)
    Path(f"{file}.superquadric.in").write_text("".join(turns))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    commands = parser.add_subparsers(dest="what", required=True)
    commands.add_parser("compaction").add_argument("--shape", choices=["sphere", "smooth", "multisphere"], default="smooth")
    commands.add_parser("superquadric").add_argument("file")
    arguments = parser.parse_args()
    if arguments.what == "superquadric":
        write_superquadrics(arguments.file)
    else:
        sys.stdout.write(compaction(arguments.shape))


if __name__ == "__main__":
    main()
