# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""Random scenes: ellipsoids with any axis the longest, discs, spheres, chains of spheres, mixtures, in boxes that are straight,
tilted, repeating along some edges or none; rows shuffled, coordinates plain, wrapped, unwrapped or scaled.

Oracle: numpy over all pairs and images. Whether two ellipsoids touch is asked of Perram and Wertheim's function (1985, J. Comput.
Phys. 58, 409-416), volumes are Monte Carlo, all else is the definition. ELLIPSOID_SCENES sets the number of scenes."""
import csv
import io
import itertools
import math
import os

import numpy as np

from _oracles import contact_function, rotation
from _synthetic import json_of, post, write

SEED = 20100213
SCENES = int(os.environ.get("ELLIPSOID_SCENES", "12"))
COLUMNS = "id type mass x y z vx vy vz omegax omegay omegaz quat1 quat2 quat3 quat4 shapex shapey shapez f_subspheres".split()


def chain_of(a, b):
    """(abscissa, radius) of N = 5 spheres; the template has tests of its own."""
    out = post("template", "--b", repr(b), "--aspect", repr(a / b), "--subspheres", 5, "--spheres", "-")[0]
    return [(float(row["x_m"]), float(row["radius_m"])) for row in csv.DictReader(io.StringIO(out))]


CHAIN = chain_of(0.3, 0.15)


class Scene:
    """Particles and a box; edges: rows of a matrix."""

    def __init__(self, rng):
        self.rng, count = rng, int(rng.integers(25, 45))
        self.low = rng.uniform(-3, 3, 3)
        self.edges = np.diag(rng.uniform(2.4, 3.2, 3))
        self.is_tilted = rng.random() < 0.5
        if self.is_tilted:
            self.edges[1, 0], self.edges[2, 0], self.edges[2, 1] = rng.uniform(-1, 1, 3)
        self.repeats = rng.random(3) < 0.6
        self.kinds = rng.choice(["triaxial", "disc", "sphere", "chain"], count, p=[0.4, 0.2, 0.2, 0.2])
        self.types = rng.integers(1, 4, count)
        self.q = rng.normal(size=(count, 4))
        self.q /= np.linalg.norm(self.q, axis=1)[:, None]
        self.axes = np.array([self.axes_of(kind) for kind in self.kinds])
        self.at = self.low + rng.uniform(0, 1, (count, 3)) @ self.edges
        self.v, self.w, self.mass = rng.normal(size=(count, 3)), rng.normal(size=(count, 3)), rng.uniform(1, 2, count)
        self.turns = [rotation(q) for q in self.q]

    def axes_of(self, kind):
        if kind == "chain":
            return 0.3, 0.15, 0.15
        if kind == "sphere":
            return (self.rng.uniform(0.1, 0.3),) * 3
        axes = self.rng.permutation(self.rng.uniform(0.1, 0.4, 3))
        if kind == "disc":
            axes = self.rng.permutation([axes[0], 0.3, 0.3])
        return tuple(axes)

    def shifts(self):
        return [np.array(s) @ self.edges for s in itertools.product(*[(0, -1, 1) if r else (0,) for r in self.repeats])]

    def nearest(self, d):
        return min((d + s for s in self.shifts()), key=np.linalg.norm) if self.repeats.any() else d

    def parts(self, k):
        """Ellipsoids of a particle: (centre, inverse of the shape's matrix)."""
        turn = self.turns[k]
        if self.kinds[k] != "chain":
            return [(self.at[k], turn @ np.diag(self.axes[k] ** 2) @ turn.T)]
        return [(self.at[k] + turn @ (x, 0, 0), r * r * np.eye(3)) for x, r in CHAIN]

    def dump(self, name, style="x", step=7):
        words = " ".join("pp" if r else "ff" for r in self.repeats)
        e, low = self.edges, self.low
        bounds = [[low[k], low[k] + e[k, k]] for k in range(3)]
        lines = ["ITEM: TIMESTEP", str(step), "ITEM: NUMBER OF ATOMS", str(len(self.at))]
        if self.is_tilted:
            for a, tilts in enumerate(((0, e[1, 0], e[2, 0], e[1, 0] + e[2, 0]), (0, e[2, 1]))):
                bounds[a] = [bounds[a][0] + min(tilts), bounds[a][1] + max(tilts)]
            tilts = (e[1, 0], e[2, 0], e[2, 1])
            lines += ["ITEM: BOX BOUNDS xy xz yz " + words] + [f"{float(b[0])!r} {float(b[1])!r} {float(t)!r}" for b, t in
                                                              zip(bounds, tilts)]
        else:
            lines += ["ITEM: BOX BOUNDS " + words] + [f"{float(b[0])!r} {float(b[1])!r}" for b in bounds]
        places = self.at
        if style in ("xs", "xsu"):
            places = (self.at - low) @ np.linalg.inv(e)
        suffix = style[1:]
        names = [c + suffix if c in "xyz" else c for c in COLUMNS]
        order = self.rng.permutation(len(self.at))
        columns = list(self.rng.permutation(len(names)))
        lines += ["ITEM: ATOMS " + " ".join(names[c] for c in columns)]
        for k in order:
            row = [int(k) + 1, int(self.types[k]), self.mass[k], *places[k], *self.v[k], *self.w[k], *self.q[k], *self.axes[k],
                   5 if self.kinds[k] == "chain" else 0]
            lines.append(" ".join(repr(row[c]) if isinstance(row[c], int) else repr(float(row[c])) for c in columns))
        return write(name, "\n".join(lines) + "\n")


def touching(scene):
    """{(i, j): contacts of parts}, over all images; a pair that is too close to call gives None."""
    found, reach = {}, [max(axes) for axes in scene.axes]
    for i, j in itertools.combinations(range(len(scene.at)), 2):
        for shift in scene.shifts():
            if np.linalg.norm(scene.at[j] + shift - scene.at[i]) > reach[i] + reach[j]:
                continue
            for p, a in scene.parts(i):
                for q, b in scene.parts(j):
                    f = contact_function(q + shift - p, a, b)
                    if abs(f - 1) < 1e-6:
                        return None
                    if f < 1:
                        found.setdefault((i, j, tuple(shift)), 0)
                        found[i, j, tuple(shift)] += 1
    return found


def check_contacts(scene):
    found = touching(scene)
    if found is None:
        return
    for style in ("x", "xu", "xs", "xsu"):
        (row,) = json_of("contacts", scene.dump("scene.dump", style))
        assert row["contacts"] == sum(found.values()), (style, row["contacts"], sum(found.values()))
    count, partners = len(scene.at), np.zeros(len(scene.at), int)
    for i, j, _ in found:
        partners[i] += 1
        partners[j] += 1
    (row,) = json_of("coordination", "scene.dump", "--space")
    assert abs(row["zpp"] - partners.mean()) < 1e-12 and abs(row["zss"] - 2 * sum(found.values()) / count) < 1e-12
    assert row["rattlers"] == (partners < 4).sum()
    for z in range(partners.max() + 1):
        assert row[f"particles_with_{z}_contacts"] == (partners == z).sum()
    kinds = np.unique(scene.types)
    for one, other in itertools.product(kinds, kinds) if len(kinds) > 1 else ():
        pairs = sum(int(scene.types[i] == one and scene.types[j] == other) + int(scene.types[j] == one and scene.types[i] == other)
                    for i, j, _ in found)
        assert abs(row[f"z_type_{one}_with_{other}"] - pairs / (scene.types == one).sum()) < 1e-12, (one, other)


def check_bed(scene):
    """Solid share of a box within the cell, or anywhere where nothing repeats; up is y or z."""
    middle = scene.low + 0.5 * scene.edges.sum(axis=0)
    half = 0.25 * np.diag(scene.edges)
    box = [float(x) for k in range(3) for x in (middle[k] - half[k], middle[k] + half[k])]
    points = scene.rng.uniform(box[::2], box[1::2], (20000, 3))
    inside = np.zeros(len(points), bool)
    for k in range(len(scene.at)):
        for p, a in scene.parts(k):
            m = np.linalg.inv(a)
            for shift in scene.shifts():
                d = points - p - shift
                inside |= np.einsum("ni,ij,nj->n", d, m, d) < 1
    share = inside.mean()
    error = 5 * math.sqrt(share * (1 - share) / len(points)) + 1e-3
    name = scene.dump("scene.dump")
    (row,) = json_of("bed", name, "--up", "z", "--box", *box)
    assert abs(row["porosity"] - (1 - share)) < error, (row, share, error)
    (row,) = json_of("bed", name, "--up", "y", "--box", *box[4:], *box[:4])  # the plan's x is z, its y is x
    assert abs(row["porosity"] - (1 - share)) < error, (row, share, error)


def check_orders(scene):
    axes = []
    for k, kind in enumerate(scene.kinds):
        if kind in ("triaxial", "chain"):
            axes.append(scene.turns[k][:, int(np.argmax(scene.axes[k]))])
    (row,) = [r for r in json_of("orientation", scene.dump("scene.dump", "xs")) if r["type"] == "all" and r["axis"] == "longest"]
    # which of the triaxial ones are discs is the command's own rule: the closer one of the other axes; here by its words
    spheres = int((scene.kinds == "sphere").sum())
    assert row["spheres"] == spheres, (row, spheres)
    longest = [k for k in range(len(scene.at)) if scene.kinds[k] != "sphere"]
    longest = [k for k in longest if sorted(scene.axes[k])[2] * sorted(scene.axes[k])[0] > sorted(scene.axes[k])[1] ** 2]
    u = np.array([scene.turns[k][:, int(np.argmax(scene.axes[k]))] for k in longest])
    if row["particles"] == len(longest) and len(u):
        order = np.linalg.eigvalsh(1.5 * u.T @ u / len(u) - 0.5 * np.eye(3))
        assert abs(row["nematic_order"] - order[-1]) < 1e-9 or abs(row["nematic_order"] - order[0]) < 1e-9, (row, order)


def check_energies(scene):
    name = scene.dump("scene.dump", "xsu")
    (row,) = json_of("energy", name, "--gravity", 0.5, -2, -9)
    turning = 0.0
    for k, w in enumerate(scene.w):
        a, b, c = scene.axes[k]
        body = scene.turns[k].T @ w
        turning += 0.1 * scene.mass[k] * ((b * b + c * c) * body[0] ** 2 + (a * a + c * c) * body[1] ** 2 + (a * a + b * b) * body[2] ** 2)
    moving = 0.5 * (scene.mass * (scene.v ** 2).sum(axis=1)).sum()
    height = -(scene.mass * (scene.at @ (0.5, -2, -9))).sum()
    for key, value in (("translation_J", moving), ("rotation_J", turning), ("potential_J", height)):
        assert abs(row[key] - value) < 1e-9 * max(1, abs(value)), (key, row[key], value)


def check_pairs(scene):
    farthest = 0.9
    if not scene.repeats.all():
        return
    table = json_of("pairs", scene.dump("scene.dump"), "--farthest", farthest, "--bins", 5)
    volume, count, histogram = np.linalg.det(scene.edges), len(scene.at), np.zeros(5)
    shifts = [np.array(s) @ scene.edges for s in itertools.product(range(-2, 3), repeat=3)]
    for i, j in itertools.permutations(range(count), 2):
        for s in shifts:
            r = np.linalg.norm(scene.at[j] + s - scene.at[i])
            if r < farthest:
                histogram[int(5 * r / farthest)] += 1
    for n, row in enumerate(table):
        shell = 4 / 3 * math.pi * ((n + 1) ** 3 - n ** 3) * (farthest / 5) ** 3
        ideal = count * (count - 1) / volume * shell
        assert abs(row["g"] - histogram[n] / ideal) < 1e-9 * max(1, histogram[n] / ideal), (n, row, histogram[n] / ideal)


def check_ways(scene):
    """Steps shorter than half a cell, wrapped into it."""
    steps, start = 5, scene.at.copy()
    ways = [np.zeros_like(start)]
    text = ""
    for n in range(steps):
        if n:
            ways.append(ways[-1] + scene.rng.uniform(-0.5, 0.5, start.shape))
        shares = (start + ways[-1] - scene.low) @ np.linalg.inv(scene.edges)
        shares[:, scene.repeats] %= 1
        scene.at = scene.low + shares @ scene.edges
        with open(scene.dump("one.dump", "x", 10 * n), encoding="ascii") as file:
            text += file.read()
    scene.at = start
    table = json_of("trajectory", write("ways.dump", text), "--origins", 2)
    for row in table:
        lag = row["lag_frames"]
        d = np.concatenate([ways[k + lag] - ways[k] for k in (0, 1) if k + lag < steps])
        assert row["pairs"] == len(d) and abs(row["msd_m2"] - (d ** 2).sum(axis=1).mean()) < 1e-9, row
        assert all(abs(row[f"displacement_{a}_m"] - d[:, k].mean()) < 1e-9 for k, a in enumerate("xyz"))


def check_masses(scene):
    """Density over the whole of a repeating box is its mass; solid fraction that of the true bodies, counted one by one."""
    if not scene.repeats.all() or scene.is_tilted:
        return
    table = json_of("fields", scene.dump("scene.dump"), "--profile", "y", "--slices", 40, "--width", 0.3, "--kernel", "lucy")
    volume = np.linalg.det(scene.edges)
    assert abs(np.mean([row["density_kg_per_m3"] for row in table]) * volume / scene.mass.sum() - 1) < 1e-4
    momentum = np.mean([row["momentum_x_kg_per_m2_s"] for row in table]) * volume
    assert abs(momentum - (scene.mass * scene.v[:, 0]).sum()) < 1e-3 * np.abs(scene.mass * scene.v[:, 0]).sum()
    table = json_of("voronoi", "scene.dump") if "voro++" not in post("voronoi", "scene.dump", expect=None)[1] else []
    for row in table:
        assert abs(row["cell_volume_sum_m3"] / volume - 1) < 1e-6


def main():
    for number in range(SCENES):
        print(f"seed {SEED + number}")
        scene = Scene(np.random.default_rng(SEED + number))
        for check in (check_contacts, check_bed, check_orders, check_energies, check_pairs, check_ways, check_masses):
            check(scene)


main()
