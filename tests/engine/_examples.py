"""What the tests of the inputs share: frames, energies, lowest points."""

from pathlib import Path

import numpy as np

from _engine import kinetic_energy, read_dump, vectors
from _overlaps import shape_squares

GRAVITY = 9.81
# How far (m) a particle's lowest point may lie below the floor: 2 % of b while it comes to rest on so
# soft a floor; ellipsoids around inscribed sub-spheres reach lower by the outline deviation, 0.06 b.
SINK = {"smooth": 3e-5, "multisphere": 1.2e-4}


def potential_energy(columns):
    """m g z of all particles per frame (F,), J."""
    return (columns["mass"] * GRAVITY * columns["z"]).sum(-1)


def lowest_points(columns):
    """Height (N,) of each particle's lowest point in the first frame (m)."""
    return columns["z"][0] - np.sqrt(shape_squares(columns)[:, 2, 2])


def frames(pattern):
    """Dumps of one frame each, in the order of time, as the columns of one dump."""
    parts = [read_dump(file)[1] for file in sorted(Path().glob(pattern))]
    return {name: np.concatenate([p[name] for p in parts]) for name in parts[0]}


def frame(columns, number):
    return {name: values[number][None] for name, values in columns.items()}


def total_energy(columns):
    """Potential and kinetic energy of all particles per frame (F,), J."""
    return potential_energy(columns) + kinetic_energy(columns)


def surface_points(columns, count=400):
    """Points (N, count, 3) on the surfaces of the particles of the first frame (m), by the support
    function in directions of a Fibonacci lattice."""
    height = (np.arange(count) + 0.5) / count * 2.0 - 1.0
    turn = np.pi * (3.0 - np.sqrt(5.0)) * np.arange(count)
    across = np.sqrt(1.0 - height ** 2)
    directions = np.stack([across * np.cos(turn), across * np.sin(turn), height], axis=1)
    reached = np.einsum("nij,dj->ndi", shape_squares(columns), directions)
    length = np.sqrt(np.einsum("ndi,di->nd", reached, directions))
    return vectors(columns, *"xyz")[0][:, None] + reached / length[..., None]
