"""Scenes for the tests of fix balance/ellipsoid, and the planes that it leaves."""

import struct
from pathlib import Path

import numpy as np

from _engine import LAW, Particle, Setup, dump, quaternion_of, read_dump, run, thermo, vectors

SIDE, AXES = 0.03, (3e-3, 1e-3, 1e-3)
COMPARED = [("x", "y", "z"), ("vx", "vy", "vz"), ("omegax", "omegay", "omegaz"),
            ("quat1", "quat2", "quat3", "quat4")]

#: thermo output: imbalance, imbalance before and after the last check, shifts, most particles of a rank
SHOW = "thermo_style custom step atoms f_share f_share[1] f_share[2] f_share[3] f_share[4]\nthermo 20\n"


def shifts(log):
    """Number of shifts at the end of a run with SHOW."""
    return thermo(log, 7)[-1, 5]


def heap(count=70, axes=AXES):
    """Particles side by side in one corner of a box of SIDE, long axes about along z, that fly about and hit each
    other."""
    random = np.random.default_rng(15)
    cells = random.permutation(np.array(list(np.ndindex(5, 5, 3))))[:count]
    particles = []
    for place in (cells + 0.5) * [2.2e-3, 2.2e-3, 6.2e-3]:
        q = quaternion_of((0.02 * random.uniform(-1.0, 1.0), 1.0, 0.02 * random.uniform(-1.0, 1.0)), 0.5 * np.pi)
        particles.append(Particle(tuple(place + random.uniform(0.0, 1e-4, 3)), axes, q,
                                  tuple(random.normal(0.0, 0.7, 3)), tuple(random.normal(0.0, 50.0, 3))))
    return particles


def crowd(grid, fix="", surface="smooth", boundary="p p p", particles=None, file="heap.data"):
    """Script of the heap on a grid of ranks, up to its run, with the commands of `fix` at the end."""
    setup = Setup(box=(0.0, SIDE) * 3, boundary=boundary, time_step=2e-6, skin=2e-4,
                  pair=f"gran/ellipsoid {LAW} surface {surface}")
    script = setup.with_particles(particles or heap(), file).replace("read_data", f"processors {grid}\nread_data")
    if surface == "multisphere":
        script += "fix subspheres all property/atom subspheres scalar yes yes no 7.\n"
    return script + "fix motion all nve/ellipsoid\n" + fix


def ranks_of(grid):
    return int(np.prod([int(n) for n in grid.split()]))


def follow(name, script, grid, steps, every):
    """Frames of the run."""
    outcome = run(script + dump(f"{name}.dump", every) + f"run {steps}\n", ranks_of(grid), name=f"in.{name}")
    return read_dump(f"{name}.dump")[1], outcome


def largest_differences(one, other, side=SIDE):
    """Relative to the largest component, of places, velocities, spins and orientations."""
    worst = {}
    for names in COMPARED:
        difference = vectors(one, *names) - vectors(other, *names)
        if names[0] == "x":
            difference -= side * np.round(difference / side)
        worst[names[0]] = np.abs(difference).max() / np.abs(vectors(one, *names)).max()
    return worst


def planes_in(restart):
    """[planes across x, y, z] of the fix's record in a restart file, as fractions of the box."""
    data = Path(restart).read_bytes()
    at = data.index(b"balance/ellipsoid\0") + len(b"balance/ellipsoid\0")
    size = struct.unpack_from("i", data, at)[0]
    state = np.frombuffer(data, count=size // 8, offset=at + 4)
    planes, first = [], 7
    for ranks in state[4:7].astype(int):
        planes.append(state[first:first + ranks + 1])
        first += ranks + 1
    assert first == len(state)
    return planes


def counts(places, planes, side=SIDE):
    """Particles of each brick (nx, ny, nz)."""
    return np.histogramdd(places, bins=[side * p for p in planes])[0]
