# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""Measures in boxes whose edges lie anywhere (`abc origin`), tilted ones, and straight ones: what `--per-particle` writes, partners,
Set-Voronoi cells, porosity, pairs, mixing, passages through an STL face; positions plain, unwrapped and scaled.

Oracle: numpy over all images; cells by random points and their nearest surface."""
import csv
import math

import numpy as np

from _oracles import contact_function, distance_to_ellipsoid, rotation, shifts_of
from _synthetic import json_of, post, write

SEED = 20240527
NAMES = "id type mass x y z quat1 quat2 quat3 quat4 shapex shapey shapez".split()


def turned(edges, rng):
    q = rng.normal(size=4)
    return edges @ rotation(q / np.linalg.norm(q)).T


def boxes(rng):
    """(kind, low corner, edges)"""
    tilted = np.array([[1.0, 0, 0], [0.35, 0.9, 0], [-0.2, 0.4, 1.1]])
    return [("straight", rng.uniform(-1, 1, 3), np.diag([1.0, 0.9, 1.1])), ("tilted", rng.uniform(-1, 1, 3), tilted),
            ("general", rng.uniform(-1, 1, 3), turned(tilted, rng)),
            ("general", rng.uniform(-1, 1, 3), np.array([[0, -1.0, 0], [0.9, 0, 0], [0, 0, 1.1]]))]


def box_lines(kind, low, edges, words="pp pp pp"):
    if kind == "general":
        return f"abc origin {words}\n" + "".join(" ".join(repr(float(x)) for x in (*edge, low[k])) + "\n" for k, edge in enumerate(edges))
    tilts = (edges[1, 0], edges[2, 0], edges[2, 1])
    if kind == "straight":
        return words + "\n" + "".join(f"{float(low[k])!r} {float(low[k] + edges[k, k])!r}\n" for k in range(3))
    sums = [(0, tilts[0], tilts[1], tilts[0] + tilts[1]), (0, tilts[2]), (0,)]
    return "xy xz yz " + words + "\n" + "".join(
        f"{float(low[k] + min(sums[k]))!r} {float(low[k] + edges[k, k] + max(sums[k]))!r} {float(tilts[k])!r}\n" for k in range(3))


class Scene:
    """Bodies of three axes, discs and balls at random; `spread` keeps them apart."""

    def __init__(self, rng, kind, low, edges, count, sizes, apart):
        self.kind, self.low, self.edges, self.shifts = kind, low, edges, shifts_of(edges)
        self.at, self.axes, self.q = [], [], []
        while len(self.at) < count:
            axes = rng.permutation(rng.uniform(*sizes, 3)) if len(self.at) % 3 else np.full(3, rng.uniform(*sizes))
            place = low + rng.uniform(0, 1, 3) @ edges
            reach = max(axes)
            if apart and any(np.linalg.norm(place - p + s) < reach + max(a) for p, a in zip(self.at, self.axes) for s in self.shifts):
                continue
            q = rng.normal(size=4)
            self.at.append(place)
            self.axes.append(axes)
            self.q.append(q / np.linalg.norm(q))
        self.turns = [rotation(q) for q in self.q]
        self.types = rng.integers(1, 3, count)

    def text(self, style="x", step=0, places=None, head="", words=False):
        places = np.array(self.at if places is None else places)
        if style == "xs":
            places = (places - self.low) @ np.linalg.inv(self.edges)
        names = [n + style[1:] if n in "xyz" else n for n in NAMES] + (["element"] if words else [])
        rows = [" ".join(repr(x) for x in (k + 1, int(self.types[k]), 1.0, *map(float, (*places[k], *self.q[k], *self.axes[k]))))
                + (" Si" if words else "") for k in range(len(places))]
        return (f"{head}ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ATOMS\n{len(rows)}\nITEM: BOX BOUNDS "
                + box_lines(self.kind, self.low, self.edges) + "ITEM: ATOMS " + " ".join(names) + "\n" + "\n".join(rows) + "\n")

    def shape(self, k):
        return self.turns[k] @ np.diag(self.axes[k] ** 2) @ self.turns[k].T


def partners_of(scene):
    """Of each body, over all images; None if a pair is too close to call."""
    partners = np.zeros(len(scene.at), int)
    for i in range(len(scene.at)):
        for j in range(i):
            for shift in scene.shifts:
                d = scene.at[j] + shift - scene.at[i]
                if np.linalg.norm(d) >= max(scene.axes[i]) + max(scene.axes[j]):
                    continue
                f = contact_function(d, scene.shape(i), scene.shape(j))
                if abs(f - 1) < 1e-6:
                    return None
                partners[[i, j]] += int(f < 1)
    return partners


def check_per_particle(rng, box):
    scene = Scene(rng, *box, 18, (0.1, 0.3), False)
    partners = partners_of(scene)
    assert partners is not None and partners.max() > 3, "another seed"
    head = "ITEM: UNITS\nsi\nITEM: TIME\n0.25\n"
    for style in ("x", "xs", "xu"):
        name = write("scene.dump", scene.text(style, 7, None, head, True))
        post("coordination", name, "--space", "--per-particle", f"z_{style}.csv", "--quiet")
        with open(f"z_{style}.csv", encoding="ascii") as file:
            rows = list(csv.DictReader(file))
        assert [int(r["partners"]) for r in rows] == list(partners), (box[0], style)
        _, error = post("coordination", name, "--space", "--per-particle", f"{box[0]}_{style}.dump", "--quiet")
        assert "element" in error and error.count("\n") == 1, error  # a column of words is left out, and this is said
    with open(f"{box[0]}_xs.dump", encoding="ascii") as file:
        text = file.read()
    assert text.startswith(head), text[:80]
    (before,), (after,) = json_of("contacts", "scene.dump"), json_of("contacts", f"{box[0]}_xs.dump")
    for key in before:  # run apart; positions of the scaled file are rounded once
        assert key == "run" or before[key] == after[key] or abs(before[key] - after[key]) < 1e-12, (box[0], key, before[key], after[key])
    assert json_of("fields", f"{box[0]}_xs.dump", "--at", 0, 0, 0, "--width", 0.1)[0]["time_s"] == 0.25


def check_cells(rng, box):
    """Each point belongs to the body whose surface is nearest."""
    scene = Scene(rng, *box, 14, (0.08, 0.16), True)
    points = scene.low + rng.uniform(0, 1, (2500, 3)) @ scene.edges
    distances = np.empty((len(scene.at), len(points)))
    for k, place in enumerate(scene.at):
        images = [distance_to_ellipsoid((points - place - s) @ scene.turns[k], scene.axes[k]) for s in scene.shifts]
        distances[k] = np.min(images, axis=0)
    volume = abs(np.linalg.det(scene.edges))
    shares = np.bincount(np.argmin(distances, axis=0), minlength=len(scene.at)) / len(points)
    post("voronoi", write("cells.dump", scene.text()), "--per-particle", "cells.csv", "--quiet")
    with open("cells.csv", encoding="ascii") as file:
        rows = list(csv.DictReader(file))
    for k, row in enumerate(rows):
        error = 4.5 * math.sqrt(shares[k] / len(points)) + 0.01 * shares[k]  # counting, and the points' distance on the surface
        assert abs(float(row["cell_volume_m3"]) / volume - shares[k]) < error, (box[0], k, row, shares[k], error)
        body = 4 / 3 * math.pi * np.prod(scene.axes[k])
        assert abs(float(row["packing_fraction"]) * float(row["cell_volume_m3"]) / body - 1) < 1e-9
    assert abs(sum(float(row["cell_volume_m3"]) for row in rows) / volume - 1) < 1e-9


def check_thin_boxes():
    """Bodies that stand alone along an edge: their own images lie on the other side of faces. The cells of a
    lattice are the same however many of them the box has; of spheres they are known."""
    axes, lengths = np.array([0.9e-3, 0.6e-3, 1.4e-3]), np.array([2.9e-3, 3.0e-3, 3.2e-3])  # the longest axis is z
    known = None
    for counts in ((2, 2, 2), (1, 1, 1), (2, 1, 1), (1, 3, 2), (3, 3, 1)):  # the first one: others on all sides
        rows = [(k + 1, 1, 1e-5, *(lengths * (np.array(n) + 0.4)), 0.5, 0.1, -0.7, 0.5, *axes) for k, n in enumerate(np.ndindex(*counts))]
        text = ("ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n" + f"{len(rows)}\nITEM: BOX BOUNDS pp pp pp\n"
                + "".join(f"0 {float(e)!r}\n" for e in lengths * counts) + "ITEM: ATOMS " + " ".join(NAMES) + "\n"
                + "".join(" ".join(repr(float(x)) if isinstance(x, float) else str(x) for x in row) + "\n" for row in rows))
        post("voronoi", write("thin.dump", text), "--per-particle", "thin.csv", "--quiet")
        with open("thin.csv", encoding="ascii") as file:
            for row in csv.DictReader(file):
                assert abs(float(row["cell_volume_m3"]) / np.prod(lengths) - 1) < 1e-6, (counts, row)
                cell = [float(row[key]) for key in ("cell_area_m2", "cell_anisotropy")]
                known = known or cell
                assert np.abs(np.array(cell) / known - 1).max() < 1e-4, (counts, cell, known)
                others = sum(min(2, n - 1) for n in counts)
                assert int(row["cell_neighbours"]) >= others, (counts, row)  # and those that touch at an edge, to rounding
    edge, shear = 1e-3, 0.3e-3
    areas = {}
    for high in (1, 2):
        rows = "".join(f"{k + 1} 1 1e-5 {0.1e-3 + shear * k!r} {0.2e-3 + edge * k!r} 3e-4 1 0 0 0 4e-4 4e-4 4e-4\n" for k in range(high))
        text = (f"ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n{high}\nITEM: BOX BOUNDS xy xz yz pp pp pp\n0 {edge + shear * high!r} {shear * high!r}\n"
                f"0 {edge * high!r} 0\n0 {edge!r} 0\nITEM: ATOMS " + " ".join(NAMES) + "\n" + rows)
        (row,) = json_of("voronoi", write("thin.dump", text))
        areas[high] = row["cell_anisotropy_mean"]
        assert abs(row["cell_volume_sum_m3"] / (high * edge ** 3) - 1) < 1e-9, row
    # a prism over the hexagon about a point of the sheared square lattice
    points = np.array([[i * edge + j * shear, j * edge] for i in range(-2, 3) for j in range(-2, 3) if (i, j) != (0, 0)])
    sides = hexagon_sides(points)
    hexagon = edge * edge
    w = np.zeros((3, 3))
    for n, length in sides:
        w += length * edge * np.outer([*n, 0], [*n, 0])
    w[2, 2] = 2 * hexagon
    values = np.linalg.eigvalsh(w)
    for high, value in areas.items():
        assert abs(value - values[0] / values[2]) < 1e-9, (high, value, values)


def hexagon_sides(points):
    """(normal, length) of the sides of the Voronoi cell of the origin among points of a plane."""
    sides = []
    for p in points:
        middle, along = p / 2, np.array([-p[1], p[0]]) / np.linalg.norm(p)
        low, high = -np.inf, np.inf
        for q in points:  # (middle + s along) . q <= q . q / 2
            slope, room = along @ q, q @ q / 2 - middle @ q
            if abs(slope) < 1e-12 * np.linalg.norm(q):
                if room < -1e-15:
                    low, high = 0.0, -1.0
                continue
            low, high = (low, min(high, room / slope)) if slope > 0 else (max(low, room / slope), high)
        if high > low:
            sides.append((p / np.linalg.norm(p), high - low))
    return sides


def check_bed_and_pairs(rng, box):
    """Solid share of a region across the cell's faces; distances of centres."""
    scene = Scene(rng, *box, 25, (0.08, 0.2), False)
    name = write("bed.dump", scene.text("xs"))
    low, high = scene.low + np.array((-0.2, 0.1, 0.3)), scene.low + np.array((0.5, 0.8, 0.9))
    points = rng.uniform(low, high, (8000, 3))
    inside = np.zeros(len(points), bool)
    for k, place in enumerate(scene.at):
        for shift in shifts_of(scene.edges, most=2):
            inside |= ((((points - place - shift) @ scene.turns[k]) / scene.axes[k]) ** 2).sum(axis=1) < 1
    share = inside.mean()
    (row,) = json_of("bed", name, "--up", "z", "--box", *(x for k in range(3) for x in (low[k], high[k])))
    assert abs(row["porosity"] - (1 - share)) < 4.5 * math.sqrt(0.25 / len(points)) + 1e-3, (box[0], row, 1 - share)
    farthest, bins = 0.4, 4
    counts = np.zeros(bins)
    for i in range(25):
        for j in range(i):
            for shift in scene.shifts:
                r = np.linalg.norm(scene.at[i] - scene.at[j] + shift)
                if r < farthest:
                    counts[int(bins * r / farthest)] += 1
    table = json_of("pairs", name, "--farthest", farthest, "--bins", bins)
    volume = abs(np.linalg.det(scene.edges))
    for n, row in enumerate(table):
        ideal = 25 * 24 / 2 * 4 / 3 * math.pi * ((n + 1) ** 3 - n ** 3) * (farthest / bins) ** 3 / volume
        assert abs(row["g"] * ideal - counts[n]) < 1e-6, (box[0], n, row, counts[n])


def check_mixing(rng, box, neighbours=5):
    scene = Scene(rng, *box, 45, (0.05, 0.1), False)
    q = (scene.types == 1).astype(float)
    size = 0.37
    (row,) = json_of("mixing", write("mixed.dump", scene.text("xu")), "--type", 1, "--neighbours", neighbours, "--cell", size)
    count, p = len(q), q.mean()
    unlike = 0.0
    for i in range(count):
        others = sorted((min(np.linalg.norm(scene.at[j] + s - scene.at[i]) for s in scene.shifts), j) for j in range(count) if j != i)
        unlike += sum((q[i] - q[j]) ** 2 for _, j in others[:neighbours])
    expected = unlike / (count * neighbours) / (2 * p * (1 - p) * count / (count - 1))
    assert abs(row["neighbour_index"] - expected) < 1e-9, (box[0], row["neighbour_index"], expected)
    # cells: equal shares of the edges, as many as come nearest to the size between the planes
    volume = abs(np.linalg.det(scene.edges))
    thick = [volume / np.linalg.norm(np.cross(scene.edges[(k + 1) % 3], scene.edges[(k + 2) % 3])) for k in range(3)]
    parts = np.maximum(1, np.round(np.array(thick) / size))
    shares = ((np.array(scene.at) - scene.low) @ np.linalg.inv(scene.edges)) % 1
    cells = {}
    for cell, value in zip(map(tuple, np.floor(shares * parts).astype(int)), q):
        cells.setdefault(cell, []).append(value)
    variance = sum(len(c) * (np.mean(c) - p) ** 2 for c in cells.values()) / count
    random = p * (1 - p) * (len(cells) - 1) / (count - 1)
    assert abs(row["lacey_index"] - (p * (1 - p) - variance) / (p * (1 - p) - random)) < 1e-9, (box[0], row)


def dome():
    """Triangles of half a ball about the origin, outwards, and where they lie in a file of millimetres."""
    rings, parts, triangles = 5, 9, []
    corner = lambda i, j: 0.37 * np.array((math.sin(0.5 * math.pi * i / rings) * math.cos(2 * math.pi * j / parts),
                                           math.sin(0.5 * math.pi * i / rings) * math.sin(2 * math.pi * j / parts), math.cos(0.5 * math.pi * i / rings)))
    for i in range(rings):
        for j in range(parts):
            a, b, c, d = corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)
            triangles += [(a, b, c)] + ([(a, c, d)] if i else [])
    return triangles


def write_stl(name, triangles, scale):
    lines = ["solid s"]
    for t in triangles:
        lines += ["facet normal 0 0 0", "outer loop", *("vertex " + " ".join(repr(float(x)) for x in np.asarray(c) * scale) for c in t),
                  "endloop", "endfacet"]
    return write(name, "\n".join(lines + ["endsolid s"]) + "\n")


def passes(begins, way, triangles):
    """Ways outwards less ways inwards through all triangles (n, 3, 3), from each of the begins (Moeller and Trumbore's equations)."""
    a, u, v = triangles[:, 0], triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]
    normal = np.cross(u, v)
    slope = normal @ way
    with np.errstate(divide="ignore", invalid="ignore"):
        t = np.einsum("nj,mnj->mn", normal, a[None] - begins[:, None]) / slope
        foot = begins[:, None] + t[:, :, None] * way - a[None]
        p = np.einsum("mnj,nj->mn", np.cross(foot, v[None]), normal) / (normal ** 2).sum(axis=1)
        q = np.einsum("mnj,nj->mn", np.cross(u[None], foot), normal) / (normal ** 2).sum(axis=1)
        is_through = (t > 0) & (t <= 1) & (p >= 0) & (q >= 0) & (p + q <= 1)
    return int((np.sign(slope)[None, :] * is_through).sum())


def check_face(rng, box, face, through):
    """Zigzag ways in steps shorter than half a cell, through a face in the middle, at a side, at a corner of the cell."""
    kind, low, edges = box
    scene = Scene(rng, *box, 30, (0.02, 0.05), False)
    middle = low + np.array(through) @ edges
    triangles = [tuple(np.asarray(c) + middle for c in t) for t in face]
    write_stl("dome.stl", triangles, 1e3)
    ways = [np.array(scene.at)]
    for _ in range(9):
        step = rng.normal(size=(30, 3))
        ways.append(ways[-1] + step / np.linalg.norm(step, axis=1)[:, None] * rng.uniform(0.05, 0.3, (30, 1)))
    forward = backward = 0
    for before, after in zip(ways[:-1], ways[1:]):
        for a, b in zip(before, after):
            home = np.floor((a - low) @ np.linalg.inv(edges)) @ edges
            net = passes(a - home + np.array(shifts_of(edges)), b - a, np.array(triangles))
            forward, backward = forward + (net > 0), backward + (net < 0)
    assert forward > 2 and backward > 2
    wrap = lambda places: low + (((places - low) @ np.linalg.inv(edges)) % 1) @ edges
    for style, places in (("x", [wrap(w) for w in ways]), ("xs", [wrap(w) for w in ways]), ("xu", ways)):
        text = "".join(scene.text(style, 10 * n, p) for n, p in enumerate(places))
        (row,) = json_of("flow", write("zigzag.dump", text), "--face", "dome.stl", "--scale", 1e-3, "--total")
        assert (row["forward"], row["backward"]) == (forward, backward), (kind, style, through, row, forward, backward)


def check_plane(rng, box):
    """Falling through a plane across the third edge's way, unwrapped: each time around it passes, and its volume with it."""
    kind, low, edges = box
    normal = np.cross(edges[0], edges[1])
    normal /= np.linalg.norm(normal)
    scene = Scene(rng, *box, 12, (0.02, 0.05), False)
    point = low + 0.5 * edges[2]
    text, counts = {"xu": "", "x": ""}, 0
    ways = [np.array(scene.at) - 0.3 * n * edges[2] for n in range(8)]
    for n, w in enumerate(ways):
        text["xu"] += scene.text("xu", n, w)
        text["x"] += scene.text("x", n, low + (((w - low) @ np.linalg.inv(edges)) % 1) @ edges)
    height = lambda w: ((w - low) @ np.linalg.inv(edges))[:, 2] - 0.5
    for a, b in zip(ways[:-1], ways[1:]):
        counts += int((np.floor(height(a)) - np.floor(height(b))).sum())
    for style in text:
        (row,) = json_of("flow", write("falling.dump", text[style]), "--through", *point, *-normal, "--total")
        assert (row["forward"], row["backward"]) == (counts, 0), (kind, style, row, counts)


def main():
    print("seed", SEED)
    rng = np.random.default_rng(SEED)
    check_thin_boxes()
    face = dome()
    for box in boxes(rng):
        check_per_particle(rng, box)
        check_cells(rng, box)
        check_bed_and_pairs(rng, box)
        check_mixing(rng, box)
        for through in ((0.5, 0.5, 0.5), (0.02, 0.5, 0.4), (0.03, 0.98, 0.02)):
            check_face(rng, box, face, through)
        check_plane(rng, box)


main()
