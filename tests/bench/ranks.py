"""What ranks would have to do in recorded states, with equal bricks and with those of fix balance/ellipsoid.

    python3 ranks.py pile.*.dump --ranks 2 4 8                     # states as they are
    python3 ranks.py packing.*.dump --hopper 1000000 --ranks 8 64 512

Prints a row for each number of ranks and grid: efficiency by numbers of particles (mean over largest), by pairs that
are treated (all pairs over ranks times the pairs of the rank with most: pairs across a plane are treated on both
sides), ghosts of the rank with most of them, and the bytes that these bring in a step. With --hopper a periodic packing
is repeated and a hopper of that many particles is cut out of it. Planes are found as the engine finds them, by a second
implementation. Nothing is run in parallel: the numbers are counted.
"""

import argparse
import gzip
import itertools
from pathlib import Path

import numpy as np

SLABS = 4096
SKIN = 0.002  # of a pile or hopper with the paper's particles (m)
BYTES = 8 * (7 + 6)  # of a ghost and step: place and orientation, velocities


class State:
    """Places (N, 3), largest semi-axes (N,), box (3, 2), pairs that are near (P, 2)."""

    def __init__(self, places, radii, box, pairs=None):
        self.places, self.radii, self.box = places, radii, box
        self.reach = 2.0 * radii.max() + SKIN
        self.pairs = near_pairs(places, radii) if pairs is None else pairs
        self.fractions = (places - box[:, 0]) / (box[:, 1] - box[:, 0])


def read_state(file):
    """Last frame of a text dump: places, largest semi-axes, box."""
    opener = gzip.open if str(file).endswith(".gz") else open
    with opener(file, "rt") as text:
        lines = text.read().split("ITEM: TIMESTEP\n")[-1].splitlines()
    box = np.array([[float(t) for t in line.split()[:2]] for line in lines[4:7]])
    names = lines[7].split()[2:]
    rows = np.array([line.split() for line in lines[8:]], float)
    column = {name: rows[:, k] for k, name in enumerate(names)}
    places = np.stack([column[c] for c in "xyz"], axis=1)
    return places, np.max([column[f"shape{c}"] for c in "xyz"], axis=0), box


def near_pairs(places, radii):
    """Pairs whose bounding spheres are nearer than the skin, by brute force."""
    found = []
    for i in range(len(places) - 1):
        reach = radii[i] + radii[i + 1:] + SKIN
        near = np.sum((places[i + 1:] - places[i]) ** 2, axis=1) < reach ** 2
        found.append(np.stack([np.full(near.sum(), i), i + 1 + np.flatnonzero(near)], axis=1))
    return np.concatenate(found)


def periodic_pairs(places, radii, sides):
    """(i, j, shift) of near pairs of a periodic cell, each once: `shift` counts cells from i's to j's."""
    found = []
    for shift in itertools.product((-1, 0, 1), repeat=3):
        moved = places + np.array(shift) * sides
        for i in range(len(places)):
            near = np.flatnonzero(np.sum((moved - places[i]) ** 2, axis=1) < (radii[i] + radii + SKIN) ** 2)
            found += [(i, j, shift) for j in near if (shift, j) > ((0, 0, 0), i)]
    return found


def hopper(packing, count):
    """A conical hopper below a cylinder, filled with copies of a periodic packing; axis z, cone of 60 degrees, outlet
    a quarter of the cylinder's diameter, which is two thirds of the filled height."""
    places, radii, box = packing
    sides = box[:, 1] - box[:, 0]
    volume = count * np.prod(sides) / len(places)
    slope = np.tan(np.radians(60.0))

    def cone_height(r):
        return 0.75 * r * slope
    def inside(x, y, z, r):
        return np.hypot(x, y) <= np.minimum(r, 0.25 * r + np.maximum(z, 0.0) / slope)
    low, high = 1e-3, 10.0
    for _ in range(60):  # radius with that volume
        r = 0.5 * (low + high)
        cone = np.pi * cone_height(r) * r ** 2 * (1 + 0.25 + 0.0625) / 3.0
        low, high = (r, high) if cone + np.pi * r ** 2 * max(3.0 * r - cone_height(r), 0.0) < volume else (low, r)
    cells = np.ceil(np.array([2 * r, 2 * r, 3 * r]) / sides).astype(int)
    corner = np.stack(np.meshgrid(*[np.arange(n) for n in cells], indexing="ij"), axis=-1)
    index = np.full((*cells, len(places)), -1)
    everything = corner[..., None, :] * sides + (places - box[:, 0]) - np.array([r, r, 0.0])
    kept = inside(*np.moveaxis(everything, -1, 0), r) & (everything[..., 2] < 3 * r)
    index[kept] = np.arange(kept.sum())
    pairs = []
    for i, j, shift in periodic_pairs(places, radii, sides):
        a, b = index[..., i], index[..., j]
        for axis, s in enumerate(shift):
            a = np.take(a, np.arange(max(0, -s), cells[axis] - max(0, s)), axis)
            b = np.take(b, np.arange(max(0, s), cells[axis] - max(0, -s)), axis)
        both = (a >= 0) & (b >= 0)
        pairs.append(np.stack([a[both], b[both]], axis=1))
    room = np.array([[-1.1 * r, 1.1 * r], [-1.1 * r, 1.1 * r], [-0.2 * r, 3.6 * r]])  # with a floor and air
    return State(everything[kept], np.broadcast_to(radii, kept.shape)[kept], room, np.concatenate(pairs))


def plan(histogram, parts, least):
    """Planes (slabs below each) of the lightest heaviest part of all columns (K, B); each at least `least` slabs."""
    slabs = histogram.shape[1]
    below = np.concatenate([np.zeros((len(histogram), 1)), np.cumsum(histogram, axis=1)], axis=1)
    even = [np.searchsorted(below.sum(0), below[:, -1].sum() * k / parts) for k in range(parts + 1)]

    def goes_on(limit):
        reach = np.min([np.searchsorted(b, b + limit * (1 + 1e-12), side="right") - 1 for b in below], axis=0)
        good = [np.arange(slabs + 1) == slabs]
        for _ in range(parts):
            count = np.concatenate([[0], np.cumsum(good[0])])
            first = np.minimum(np.arange(slabs + 1) + least, slabs + 1)
            good.insert(0, count[np.minimum(reach, slabs) + 1] > count[first])
        return good, reach

    low, high = below[:, -1].max() / parts, below[:, -1].max()
    mean = below[:, -1].sum() / parts / len(below)
    while high - low > 1e-3 * mean:
        middle = 0.5 * (low + high)
        low, high = (low, middle) if goes_on(middle)[0][0][0] else (middle, high)
    good, reach = goes_on(high)
    planes = [0]
    for k in range(1, parts + 1):
        allowed = np.flatnonzero(good[k][:reach[planes[-1]] + 1])
        allowed = allowed[allowed >= planes[-1] + least]
        planes.append(int(allowed[np.abs(allowed - even[k]).argmin()]))
    return np.array(planes) / slabs


def balanced(state, grid):
    planes = [np.linspace(0.0, 1.0, n + 1) for n in grid]
    slab = np.minimum((state.fractions * SLABS).astype(int), SLABS - 1)
    directions = [k for k in range(3) if grid[k] > 1]
    for k in directions * (3 if len(directions) > 1 else 1):
        u, v = (k + 1) % 3, (k + 2) % 3
        column = bricks(state, planes, u) * grid[v] + bricks(state, planes, v)
        histogram = np.bincount(column * SLABS + slab[:, k], minlength=grid[u] * grid[v] * SLABS)
        side = state.box[k, 1] - state.box[k, 0]
        least = max(1, int(np.ceil(min(state.reach / side, 0.5 / grid[k]) * SLABS)))
        planes[k] = plan(histogram.reshape(-1, SLABS), grid[k], least)
    return planes


def bricks(state, planes, k):
    return np.searchsorted(planes[k][1:-1], state.fractions[:, k], side="right")


def measures(state, planes):
    """Efficiency by particles and by pairs, most ghosts of a rank, ghosts of all."""
    grid = [len(p) - 1 for p in planes]
    ranks = int(np.prod(grid))
    at = [bricks(state, planes, k) for k in range(3)]
    rank = (at[0] * grid[1] + at[1]) * grid[2] + at[2]
    particles = np.bincount(rank, minlength=ranks)
    a, b = rank[state.pairs[:, 0]], rank[state.pairs[:, 1]]
    pairs = np.bincount(a, minlength=ranks) + np.bincount(b[a != b], minlength=ranks)
    reach = state.reach / (state.box[:, 1] - state.box[:, 0])
    near = [[(state.fractions[:, k] >= p[i] - reach[k]) & (state.fractions[:, k] < p[i + 1] + reach[k])
             for i in range(grid[k])] for k, p in enumerate(planes)]
    ghosts = np.zeros(ranks)
    for i, j in np.ndindex(grid[0], grid[1]):
        column = np.flatnonzero(near[0][i] & near[1][j])
        for m in range(grid[2]):
            n = (i * grid[1] + j) * grid[2] + m
            ghosts[n] = near[2][m][column].sum() - particles[n]
    return particles.mean() / particles.max(), len(state.pairs) / ranks / pairs.max(), ghosts.max(), ghosts.sum()


def grids(ranks):
    return [(i, j, ranks // i // j) for i in range(1, ranks + 1) if ranks % i == 0
            for j in range(1, ranks // i + 1) if ranks // i % j == 0]


def standard_grid(state, ranks):
    """The host's: least surface of equal bricks."""
    sides = state.box[:, 1] - state.box[:, 0]

    def surface(grid):
        x, y, z = sides / grid
        return x * y + y * z + z * x
    return min(grids(ranks), key=surface)


def report(state, numbers):
    print(f"{len(state.places)} particles, {len(state.pairs) / len(state.places):.2f} near pairs per particle")
    print("| ranks | grid | planes | by particles | by pairs | most ghosts of a rank | MB per step, all |")
    print("|---|---|---|---|---|---|---|")
    for ranks in numbers:
        standard = standard_grid(state, ranks)
        rows = [("equal", standard, [np.linspace(0.0, 1.0, n + 1) for n in standard]),
                ("shifted", standard, balanced(state, standard))]
        fitting = max(((g, balanced(state, g)) for g in grids(ranks) if max(g) <= 32),
                      key=lambda candidate: measures(state, candidate[1])[1])
        rows.append(("shifted, best grid", *fitting))
        for words, grid, planes in rows:
            particles, pairs, most, ghosts = measures(state, planes)
            print(f"| {ranks} | {' x '.join(map(str, grid))} | {words} | {particles:.2f} | {pairs:.2f} | {most:.0f} | "
                  f"{ghosts * BYTES / 1e6:.2f} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("dumps", nargs="+", type=Path)
    parser.add_argument("--ranks", nargs="+", type=int, default=[2, 4, 8])
    parser.add_argument("--hopper", type=int, metavar="N", help="cut a hopper of N particles out of the packing")
    options = parser.parse_args()
    for file in options.dumps:
        print(f"{file}:")
        packing = read_state(file)
        report(hopper(packing, options.hopper) if options.hopper else State(*packing), options.ranks)


if __name__ == "__main__":
    main()
