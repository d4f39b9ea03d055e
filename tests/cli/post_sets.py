# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""Sets of spheres of `template`: for ellipsoids of any axes, from lists, from surfaces.

Oracles are random points, points of surfaces and sums over triangles, all in numpy.
"""
import csv
import io
import os
import struct
import subprocess

import numpy as np

from _synthetic import POST, post, rows_of, write

SEMIAXES = np.array([3e-3, 1e-3, 2e-3])  # the longest axis is not the second, none are equal


def spheres_of(*arguments):
    """Centres (N, 3) and radii (N,) of the set that `template` makes (m)."""
    text = post("template", *arguments, "--spheres", "-")[0]
    values = np.array([line.split(",")[1:] for line in text.splitlines()[1:]], float)
    return values[:, :3], values[:, 3]


def in_union(points, centres, radii):
    """Whether points (M, 3) are in one of the spheres."""
    inside = np.zeros(len(points), bool)
    for centre, radius in zip(centres, radii):
        inside |= ((points - centre) ** 2).sum(1) < radius * radius
    return inside


def in_ellipsoid(points, semiaxes):
    return ((points / semiaxes) ** 2).sum(1) < 1.0


def random_share(semiaxes, centres, radii, count=400000):
    """Volume in exactly one of the two over the ellipsoid's, and its standard deviation."""
    box = 1.1 * semiaxes
    points = np.random.default_rng(7).uniform(-box, box, (count, 3))
    share = np.mean(in_union(points, centres, radii) != in_ellipsoid(points, semiaxes))
    scale = np.prod(2.0 * box) / (4.0 / 3.0 * np.pi * np.prod(semiaxes))
    return scale * share, scale * np.sqrt(share * (1.0 - share) / count)


def sphere_points(count):
    """Even over the unit sphere."""
    k = np.arange(count)
    z = 1.0 - (2.0 * k + 1.0) / count
    angle = np.pi * (3.0 - 5.0 ** 0.5) * k
    return np.stack([np.sqrt(1.0 - z * z) * np.cos(angle), np.sqrt(1.0 - z * z) * np.sin(angle), z], 1)


def distance_to_spheres(points, centres, radii):
    """Of points outside all of them."""
    return (np.linalg.norm(points[:, None] - centres[None], axis=2) - radii).min(1)


def largest_from_spheres(centres, radii):
    """Largest distance of the spheres' uncovered points from points of the ellipsoid (inside it)."""
    body, largest = sphere_points(20000) * SEMIAXES, 0.0
    for k, (centre, radius) in enumerate(zip(centres, radii)):
        points = centre + radius * sphere_points(1500)
        others = np.arange(len(radii)) != k
        points = points[~in_union(points, centres[others], radii[others])]
        for part in np.array_split(points, max(1, len(points) // 100)):
            if len(part):
                apart = np.linalg.norm(part[:, None] - body[None], axis=2).min(1)
                largest = max(largest, apart.max())
    return largest


def check_ellipsoid_sets():
    for spacing in ("medial", "minimax_volume"):
        arguments = ("--semiaxes", *SEMIAXES, "--subspheres", 33, "--spacing", spacing)
        (row,) = rows_of("template", *arguments)
        centres, radii = spheres_of(*arguments)
        assert len(radii) == 33
        assert np.all(centres[:, 1] == 0.0)  # the plane of the two larger semi-axes
        share, deviation = random_share(SEMIAXES, centres, radii)
        found = float(row["in_exactly_one"])
        assert abs(found - share) < 5.0 * deviation + 1e-4, (spacing, found, share)
        if spacing == "medial":  # inscribed
            assert abs(1.0 - float(row["volume_ratio"]) - found) < 2e-4
            gaps = distance_to_spheres(sphere_points(20000) * SEMIAXES, centres, radii)
            assert abs(gaps.max() / 1e-3 - float(row["largest_to_spheres_c"])) < 0.01, row
            back = largest_from_spheres(centres, radii)
            assert abs(back / 1e-3 - float(row["largest_to_body_c"])) < 0.03, (row, back)
            assert float(row["inertia_xx_ratio"]) < 1.0
        assert abs(float(row["centre_distance_c"])) < 1e-12
    assert found < 0.7 * (1.0 - float(rows_of("template", "--semiaxes", *SEMIAXES, "--subspheres",
                                              33)[0]["volume_ratio"]))


def check_levels():
    """The set of N + 2 begins with that of N, centres stay; without a sphere in the centre for even N."""
    for axes in (SEMIAXES, np.array([1.0, 1.0, 2.35]), np.array([0.4, 1.0, 1.0])):
        sets = {n: spheres_of("--semiaxes", *axes, "--subspheres", n) for n in range(29, 37)}
        for n, (centres, radii) in sets.items():
            assert len(radii) == n
            assert (np.linalg.norm(centres, axis=1).min() > 1e-3 * axes.max()) == (n % 2 == 0)
            assert np.linalg.norm(centres.mean(0)) < 1e-14
            if n - 2 in sets:
                assert np.array_equal(sets[n - 2][0], centres[:-2]) and np.array_equal(sets[n - 2][1], radii[:-2])
    shares = [random_share(SEMIAXES, *spheres_of("--semiaxes", *SEMIAXES, "--subspheres", n))[0] for n in (23, 26)]
    assert shares[1] < 1.05 * shares[0], shares


def check_even_minimax():
    """Without a sphere in the centre, mirrored, and as good as the odd numbers beside it."""
    shares = []
    for n in (23, 24, 26, 29):
        centres, radii = spheres_of("--semiaxes", *SEMIAXES, "--subspheres", n, "--spacing", "minimax_volume")
        assert len(radii) == n
        assert (np.linalg.norm(centres, axis=1).min() > 1e-6) == (n % 2 == 0)
        for mirror in ((-1, 1, 1), (1, 1, -1)):
            apart = np.linalg.norm(centres[:, None] * mirror - centres[None], axis=2).min(1)
            assert apart.max() < 1e-15
        shares.append(random_share(SEMIAXES, centres, radii)[0])
    assert shares[2] < 1.05 * shares[0] and shares[3] < 1.05 * shares[1], shares


def distance_to_ellipsoid(points, axes):
    """Of points inside or outside, (M,): the root of x^2 a^2 / (a^2 + t)^2 + ... = 1 by bisection."""
    squares, low = axes ** 2, np.full(len(points), -(axes.min() ** 2) * (1.0 - 1e-13))
    high = np.full(len(points), 10.0 * np.abs(points).max() * axes.max())
    for _ in range(70):
        middle = 0.5 * (low + high)
        outside = ((points * axes / (squares + middle[:, None])) ** 2).sum(1) > 1.0
        low, high = np.where(outside, middle, low), np.where(outside, high, middle)
    foot = points * squares / (squares + 0.5 * (low + high)[:, None])
    return np.linalg.norm(points - foot, axis=1)


def highest(points, onto, value, width, random):
    """Largest value found from the best 25 of the points by random steps, which become smaller."""
    values = value(points)
    best = np.argsort(-values)[:25]
    points, values = points[best], values[best]
    for _ in range(32):
        steps = points[None] + random.normal(size=(40, *points.shape)) * width
        tried = np.array([onto(step) for step in steps])
        found = np.array([value(step) for step in tried])
        which, own = found.argmax(0), np.arange(len(values))
        better = found[which, own] > values
        points[better], values[better] = tried[which, own][better], found[which, own][better]
        width *= 0.7
    return values.max()


def largest_both_ways(axes, centres, radii):
    """From the ellipsoid's points outside of all spheres to these, and from the spheres' uncovered points back."""
    random = np.random.default_rng(11)
    to_spheres = highest(sphere_points(20000) * axes, lambda p: p / np.linalg.norm(p / axes, axis=1)[:, None],
                         lambda p: distance_to_spheres(p, centres, radii), 0.03, random)
    to_body = 0.0
    for k, (centre, radius) in enumerate(zip(centres, radii)):
        others = np.arange(len(radii)) != k

        def onto(points):
            apart = points - centre
            return centre + radius * apart / np.linalg.norm(apart, axis=1)[:, None]

        def value(points):
            free = ~in_union(points, centres[others], radii[others] * (1.0 - 1e-12))
            apart = np.full(len(points), -1.0)
            if free.any():
                apart[free] = distance_to_ellipsoid(points[free], axes)
            return apart

        points = centre + radius * sphere_points(3000)
        if value(points).max() > 0.95 * to_body:
            to_body = max(to_body, highest(points, onto, value, 0.03, random))
    return to_spheres, to_body


def check_largest():
    """Largest distances, both ways, to 3e-4 of themselves; the last set sticks out, as much as it leaves."""
    for axes, n, spacing in ((np.array([2.5, 1.75, 1.0]), 45, "medial"), (np.array([1.0, 2.35, 1.0]), 13, "medial"),
                             (np.array([1.75, 1.0, 2.5]), 13, "minimax_volume")):
        arguments = ("--semiaxes", *axes, "--subspheres", n, "--spacing", spacing)
        (row,) = rows_of("template", *arguments)
        centres, radii = spheres_of(*arguments)
        to_spheres, to_body = largest_both_ways(axes, centres, radii)
        for name, truth in (("largest_to_spheres_c", to_spheres), ("largest_to_body_c", to_body)):
            assert abs(float(row[name]) / truth - 1.0) < 3e-4, (axes, name, row[name], truth)


def check_means_of_minimax():
    """Points of the ellipsoid in spheres are as far as the nearest point of the spheres' uncovered parts."""
    axes = np.array([2.5, 1.75, 1.0])
    arguments = ("--semiaxes", *axes, "--subspheres", 13, "--spacing", "minimax_volume")
    (row,) = rows_of("template", *arguments)
    centres, radii = spheres_of(*arguments)
    surface = []
    for k, (centre, radius) in enumerate(zip(centres, radii)):
        points, others = centre + radius * sphere_points(12000), np.arange(13) != k
        surface.append(points[~in_union(points, centres[others], radii[others])])
    surface = np.concatenate(surface)
    sphere = sphere_points(1500)
    body, weights = sphere * axes, np.linalg.norm(sphere / axes, axis=1)
    apart, inside = distances_from(body, surface), in_union(body, centres, radii)
    apart[~inside] = distance_to_spheres(body[~inside], centres, radii)
    mean = np.average(apart, weights=weights)  # inside too large, by the points' distances from each other
    assert 0.96 * mean < float(row["mean_to_spheres_c"]) < 1.005 * mean, (row, mean)
    assert apart.max() - 0.01 < float(row["largest_to_spheres_c"]), (row, apart.max())


def section_outline(centres, radii, axes):
    """Points of the uncovered arcs in the plane of two body axes (M, 2) and lengths they stand for (M,); area."""
    turn = (np.arange(40000) + 0.5) * 2.0 * np.pi / 40000
    circle = np.stack([np.cos(turn), np.sin(turn)], 1)
    flat, points, lengths, area = centres[:, list(axes)], [], [], 0.0
    for k, radius in enumerate(radii):
        own = flat[k] + radius * circle
        free = np.ones(len(own), bool)
        for m in range(len(radii)):
            if m != k:
                free &= ((own - flat[m]) ** 2).sum(1) >= radii[m] ** 2
        points.append(own[free])
        lengths.append(np.full(free.sum(), 2.0 * np.pi * radius / len(turn)))
        area += 0.5 * radius * ((own * circle).sum(1)[free]).sum() * 2.0 * np.pi / len(turn)
    return np.concatenate(points), np.concatenate(lengths), area


def ellipse_points(a, b, count=20001):
    turn = np.linspace(0.0, 2.0 * np.pi, count)
    return np.stack([a * np.cos(turn), b * np.sin(turn)], 1)


def distances_from(points, curve):
    """From the nearest point of a fine polygon, (M,)."""
    return np.concatenate([np.linalg.norm(part[:, None] - curve[None], axis=2).min(1)
                           for part in np.array_split(points, max(1, len(points) // 50))])


def check_roughness():
    """Eqs. (26) and (27) and root-mean-squares against points of the outline."""
    for spacing, n, more in (("paper", 3, ()), ("paper", 9, ()), ("minimax_area", 7, ()),
                             ("medial", 24, ("--semiaxes", *SEMIAXES)),
                             ("minimax_volume", 13, ("--semiaxes", *SEMIAXES))):
        a, b, plane = (3.0, 2.0, (0, 2)) if more else (2.35, 1.0, (0, 1))
        unit = 1e-3 if more else 1.0
        arguments = more + ("--spacing", spacing, "--subspheres", n)
        arguments += () if more else ("--aspect", 2.35, "--b", 1)
        (row,) = rows_of("template", *arguments)
        centres, radii = (values / unit for values in spheres_of(*arguments))
        points, lengths, area = section_outline(centres, radii, plane)
        curve = ellipse_points(a, b)
        perimeter = np.linalg.norm(np.diff(curve, axis=0), axis=1).sum()
        assert abs(float(row["area_shape_factor"]) - abs(area / (np.pi * a * b) - 1.0)) < 3e-4, row
        assert abs(float(row["perimeter_shape_factor"]) - abs(lengths.sum() / perimeter - 1.0)) < 2e-3, row
        if more:
            continue
        some = slice(None, None, 50)
        sign = np.where(((points[some] / (a, b)) ** 2).sum(1) > 1.0, 1.0, -1.0)
        apart, weight = sign * distances_from(points[some], curve), lengths[some]
        mean = np.average(apart, weights=weight)
        rms = np.sqrt(np.average(apart ** 2, weights=weight))
        rq = np.sqrt(np.average((apart - mean) ** 2, weights=weight))
        assert abs(float(row["outline_rms_b"]) / rms - 1.0) < 5e-3, (row, rms)
        assert abs(float(row["outline_rq_b"]) / rq - 1.0) < 5e-3, (row, rq)
    check_roughness_in_space()


def check_roughness_in_space():
    """Root-mean-squares over surfaces, both ways, of an inscribed set."""
    arguments = ("--semiaxes", *SEMIAXES, "--subspheres", 21)
    (row,) = rows_of("template", *arguments)
    centres, radii = spheres_of(*arguments)
    sphere = sphere_points(40000)
    stretch = np.prod(SEMIAXES) * np.linalg.norm(sphere / SEMIAXES, axis=1)  # area per solid angle
    gaps = distance_to_spheres(sphere * SEMIAXES, centres, radii)
    there = np.sqrt(np.average(gaps ** 2, weights=stretch)) / SEMIAXES.min()
    assert abs(float(row["rms_to_spheres_c"]) / there - 1.0) < 5e-3, (row, there)
    squares, areas = [], []
    for k, (centre, radius) in enumerate(zip(centres, radii)):
        points = centre + radius * sphere_points(400)
        others = np.arange(len(radii)) != k
        points = points[~in_union(points, centres[others], radii[others])]
        if len(points):
            squares.append(distances_from(points, sphere * SEMIAXES) ** 2)
            areas.append(np.full(len(points), radius ** 2))
    back = np.sqrt(np.average(np.concatenate(squares), weights=np.concatenate(areas))) / SEMIAXES.min()
    assert abs(float(row["rms_to_body_c"]) / back - 1.0) < 0.03, (row, back)


def check_ratios():
    """Rows of the table over b/a and c/a are those of --semiaxes; sets that are not one body are left out."""
    text, warnings = post("template", "--ratios", "0.3,1,0.6", "--subspheres", "17,34", "--csv", "-")
    rows = list(csv.DictReader(io.StringIO(text)))
    shapes = [(0.3, 0.3), (1.0, 0.3), (1.0, 0.6), (0.6, 0.3), (0.6, 0.6)]
    built = [(float(row["b_a"]), float(row["c_a"]), int(row["subspheres"])) for row in rows]
    assert built == [(*shape, n) for shape in shapes for n in (17, 34) if (*shape, n) in built], text
    assert len(built) >= 6 and warnings.count("is enough") == 10 - len(built), warnings
    for shape in shapes:
        for n in (17, 34):
            if (*shape, n) not in built:
                assert "one body" in post("template", "--semiaxes", 1, *shape, "--subspheres", n, expect=1)[1], shape
    for row in rows:
        assert row["shape"] == f"1 : {row['b_a']} : {row['c_a']}"
        (alone,) = rows_of("template", "--semiaxes", 2, 2 * float(row["b_a"]), 2 * float(row["c_a"]), "--subspheres",
                           row["subspheres"])
        for name in ("volume_ratio", "in_exactly_one", "largest_to_spheres_c", "mean_to_body_c", "inertia_yy_ratio"):
            assert abs(float(row[name]) / float(alone[name]) - 1.0) < 1e-6, (name, row, alone)
    for words, reason in (("--map", "requires --needed"), ("--tolerance", "has no effect with --ratios")):
        assert reason in post("template", "--ratios", 0.5, words, 0.1, expect=2)[1], words
    assert "no ratio is below 1" in post("template", "--ratios", 1, "--subspheres", 9, expect=1)[1]
    error = post("template", "--needed", 0.3, "--ratios", "0.5,0.8,1", "--map", "needed.svg")[1]
    assert "4 of 9 cells have no value" in error or "cells have no value in \"medial\" and stay blank" in error, error


def read_to_end(terminal):
    """What a program has written to a pseudo-terminal; its end is an error of reading."""
    shown = b""
    try:
        while part := os.read(terminal, 10000):
            shown += part
    except OSError:
        pass
    return shown.decode()


def check_progress():
    """On a terminal, and only there, standard error tells what is being computed; in the end the line is empty."""
    for words, line in ((("--needed", 0.3, "--ratios", "0.5"), "N needed for 1 : 0.5 : 0.5"),
                        (("--ratios", "0.5", "--subspheres", "9"), "1 : 0.5 : 0.5, N = 9"),
                        (("--semiaxes", 3, 2, 1, "--subspheres", 33), "measures of N = 33")):
        ours, its = os.openpty()
        subprocess.run([POST, "template", *map(str, words)], stderr=its, stdout=subprocess.DEVNULL, check=True)
        os.close(its)
        shown = read_to_end(ours)
        os.close(ours)
        assert line in shown and shown.split("\r")[-1] == "" and shown.split("\r")[-2].strip() == "", (words, shown)
        assert post("template", *words)[1] == "", words


def check_tolerance():
    (row,) = rows_of("template", "--semiaxes", *SEMIAXES, "--tolerance", 0.08)
    n = int(row["subspheres"])
    assert n % 2 == 1 and float(row["in_exactly_one"]) <= 0.08
    share, _ = random_share(SEMIAXES, *spheres_of("--semiaxes", *SEMIAXES, "--subspheres", n))
    fewer, _ = random_share(SEMIAXES, *spheres_of("--semiaxes", *SEMIAXES, "--subspheres", n - 6))
    assert share < 0.083 and fewer > 0.077, (n, share, fewer)
    (row,) = rows_of("template", "--semiaxes", *SEMIAXES, "--tolerance", 0.05, "--measure", "outline",
                     "--spacing", "minimax_volume")
    assert max(float(row["largest_to_spheres_c"]), float(row["largest_to_body_c"])) <= 0.05
    for words, reason in ((("--semiaxes", *SEMIAXES, "--subspheres", 33, "--tolerance", 0.05), "--subspheres: has no effect with --tolerance"),
                          (("--semiaxes", *SEMIAXES, "--subspheres", 33, "--measure", "volume"), "--measure: has no effect without --tol"),
                          (("--needed", 0.1, "--measure", "outline"), "--measure: has no effect with --needed")):
        assert reason in post("template", *words, expect=2)[1]
    check_ratios()
    rows = rows_of("template", "--needed", 0.1, "--ratios", "0.6,1")
    assert [(row["b_a"], row["c_a"]) for row in rows] == [("0.6", "0.6"), ("1", "0.6")], rows
    for row in rows:
        (at,) = rows_of("template", "--semiaxes", 1, row["b_a"], row["c_a"], "--subspheres",
                        row["medial"])
        assert float(at["in_exactly_one"]) <= 0.1, at
        assert int(row["minimax_volume"]) <= int(row["medial"])


def check_lists():
    """The three kinds of list; files that are written hold the same body."""
    centres = np.array([[0.0, 0.0, 0.0], [1.0, 0.5, 0.0], [0.2, 1.0, 0.7]]) + 5.0
    radii = np.array([1.0, 0.8, 0.6])
    rows = np.column_stack([centres, radii])
    lines = [[repr(float(value)) for value in row] for row in rows]
    write("host.txt", "\n".join(" ".join(line) for line in lines) + "\n")
    write("clump.txt", "\n".join(",".join(line) for line in lines) + "\n")
    write("named.csv", "name,r,x,y,z\n" + "\n".join(
        ",".join([f"s{k}", line[3], *line[:3]]) for k, line in enumerate(lines)) + "\n")
    points = np.random.default_rng(3).uniform(3.5, 7.5, (400000, 3))
    inside = in_union(points, centres, radii)
    volume = 64.0 * inside.mean()
    deviation = 64.0 * np.sqrt(inside.mean() * (1.0 - inside.mean()) / len(points))
    mean = points[inside].mean(0)
    for name in ("host.txt", "clump.txt", "named.csv"):
        (row,) = rows_of("template", "--clump", name)
        assert abs(float(row["volume_m3"]) - volume) < 5.0 * deviation
        for axis, wanted in zip("xyz", mean):
            assert abs(float(row[f"centre_{axis}_m"]) - wanted) < 0.01, row
    moments = np.mean(((points[inside] - mean) ** 2).sum(1)) * np.eye(3) - np.cov(
        points[inside].T, bias=True)
    post("template", "--clump", "named.csv", "--multisphere", "out.txt", "--molecule", "out.mol",
         "--spheres", "out.csv", "--mass", 2.0, "--picture", "out.svg")
    written = np.loadtxt("out.txt")
    assert np.allclose(written[:, 3], radii, rtol=1e-15)
    assert np.allclose(written[:, :3] - written[0, :3], centres - centres[0], atol=1e-12)
    assert np.allclose(written[0, :3] + mean, centres[0], atol=0.01)
    inertia = [float(value) for value in
               next(line for line in open("out.mol") if "inertia" in line).split()[:6]]
    wanted = 2.0 * moments[[0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]]
    assert np.allclose(inertia, wanted, atol=0.02), (inertia, wanted)
    assert open("out.svg").read().startswith("<?xml") or "<svg" in open("out.svg").read(200)
    os.makedirs("folder", exist_ok=True)
    write("folder/ball.csv", "0 0 0 1\n")
    assert post("template", "--clump", "folder/ball.csv", "--molecule", "-")[0].splitlines()[0].startswith("ball.csv N = 1")
    (again,) = rows_of("template", "--clump", "out.csv")
    assert again["volume_m3"] == row["volume_m3"]


def check_doubled_spheres():
    """As CLUMP writes them for a body that its images meet: the same sphere several times, also with -0."""
    once = ["0.25, 0.0, 0.0, 0.5", "-0.25, 0.125, 0.0, 0.5", "0.0, 0.0, 0.375, 0.25"]
    write("once.txt", "\n".join(once) + "\n")
    write("twice.txt", "\n".join([once[1], once[0], *once, "0.0, -0.0, 0.375000, 0.25"]) + "\n")
    (row,), (again,) = (rows_of("template", "--clump", name) for name in ("once.txt", "twice.txt"))
    _, error = post("template", "--clump", "twice.txt")
    assert "3 spheres equal an earlier one and are left out" in error and error.count("\n") == 1, error
    assert again["subspheres"] == row["subspheres"] == "3"
    for key in ("volume_m3", "surface_m2", "centre_x_m", "inertia_xx_m5"):
        assert abs(float(again[key]) - float(row[key])) < 1e-14, key  # another order of the sums
    assert post("template", "--clump", "once.txt")[1] == ""


def check_spheres_far_out():
    """Centres inside, and one radius that is not the body's: the farthest way out, by hand."""
    write("far.txt", "0 0 0 1\n0 0 0.5 0.4\n1 0 0 2.5\n")
    _, error = post("template", "--clump", "far.txt", "--semiaxes", 2, 2, 1)
    closest = np.linalg.norm(np.array([1.0, 0.0, 0.0]) - sphere_points(200000) * (2, 2, 1), axis=1).min()
    words = error.split("sphere 3 by up to ")[1].split()
    assert "1 of the 3 spheres stick out" in error and error.count("\n") == 1, error
    assert abs(float(words[0]) - (2.5 - closest)) < 1e-3, (error, closest)
    write("near.txt", "0 0 0 1.05\n0 0 0.5 0.5\n")
    assert post("template", "--clump", "near.txt", "--semiaxes", 2, 2, 1)[1] == ""


def check_bad_lists():
    def error_of(text, *more):
        write("bad.txt", text)
        _, error = post("template", "--clump", "bad.txt", *more, expect=1)
        assert error.count("\n") == 1, error
        return error

    assert "radius 0" in error_of("0 0 0 1\n1 0 0 0\n")
    assert "2 bodies apart" in error_of("0 0 0 1\n3 0 0 1\n")
    assert "line 2" in error_of("0 0 0 1\n1 0 0\n")
    assert "line 2" in error_of("0 0 0 1\n1 0 zero 1\n")
    assert "no sphere" in error_of("# nothing\n")
    assert "allowed are 1 to 9999" in error_of("".join(f"0 0 {k} 1\n" for k in range(100000)))
    error = error_of("0 0 0 1\n0 0 2.5 1.6\n", "--semiaxes", 2, 2, 2.2)
    assert "sphere 2" in error and "outside the body, by 0.3" in error, error
    for option in ("--clump", "--from"):
        for name in ("missing.txt", "."):
            error = post("template", option, name, expect=1)[1]
            assert f"{name}: cannot be opened; give " in error and error.count("\n") == 1, error
    for words in ((3, 2), (3, 2, 1, 1, 2, 2), (3, 2, "x")):
        _, error = post("template", "--semiaxes", *words, expect=2)
        assert "--semiaxes" in error and error.startswith("error: ") and error.count("\n") == 1, error
    with open("binary.txt", "wb") as file:
        file.write(bytes(range(256)))
    assert "no text" in post("template", "--clump", "binary.txt", expect=1)[1]
    for arguments, text in (
            (("--semiaxes", 3, 2, 1, "--spacing", "paper"), "b = c"),
            (("--semiaxes", 3, 2, 0), "> 0"),
            (("--semiaxes", 2, 1, 1, "--spacing", "paper", "--subspheres", 4), "odd"),
            (("--semiaxes", 5, 5, 1, "--subspheres", 5), "is enough"),
            (("--semiaxes", 3, 2, 1, "--aspect", 2), "is for chains"),
            (("--semiaxes", 3, 2, 1, "--tolerance", 0.1, "--measure", "area"), "section of a chain"),
            (("--picture", "a.svg"), "--semiaxes, --clump or --from"),
            (("--semiaxes", 2, 1.5, 1, "--subspheres", "13,33", "--spheres", "a.csv"), "one template")):
        _, error = post("template", *arguments, expect=1)
        assert text in error.splitlines()[-1], (arguments, error)


def box_triangles(size):
    """(12, 3, 3) of a box from the origin, turned outwards."""
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]) * np.array(size)
    quads = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
    return np.array([corners[[a, b, c]] for p, q, r, s in quads for a, b, c in ((p, q, r), (p, r, s))],
                    float)


def ellipsoid_triangles(semiaxes, rings=24, parts=36):
    """A mesh of latitudes and longitudes, (M, 3, 3)."""
    t = np.pi * np.arange(rings + 1) / rings
    f = 2.0 * np.pi * np.arange(parts) / parts
    grid = np.array([[[np.sin(a) * np.cos(b), np.sin(a) * np.sin(b), np.cos(a)] for b in f] for a in t])
    grid[0], grid[-1] = (0.0, 0.0, 1.0), (0.0, 0.0, -1.0)
    triangles = []
    for i in range(rings):
        for j in range(parts):
            p, q = grid[i, j], grid[i, (j + 1) % parts]
            r, s = grid[i + 1, j], grid[i + 1, (j + 1) % parts]
            triangles += [(p, r, s)] * (i < rings - 1) + [(p, s, q)] * (i > 0)
    return np.array(triangles) * np.array(semiaxes)


def write_stl(name, triangles, binary):
    if binary:
        with open(name, "wb") as file:
            file.write(bytes(80) + struct.pack("<I", len(triangles)))
            for t in triangles:
                file.write(struct.pack("<12fH", 0, 0, 0, *t.ravel(), 0))
        return
    facets = "".join("facet normal 0 0 0\nouter loop\n" + "".join(
        "vertex {} {} {}\n".format(*map(float, p)) for p in t) + "endloop\nendfacet\n" for t in triangles)
    write(name, "solid body\n" + facets + "endsolid body\n")


def check_surfaces():
    semiaxes = np.array([1.0, 0.6, 0.8])
    triangles = ellipsoid_triangles(semiaxes)
    # unevenly rounded corners would not be joined: the ASCII file holds all digits
    write_stl("ellipsoid.stl", triangles, False)
    for spacing, most in (("medial", 0.13), ("minimax_volume", 0.08)):
        (row,) = rows_of("template", "--from", "ellipsoid.stl", "--subspheres", 20, "--spacing", spacing)
        centres, radii = spheres_of("--from", "ellipsoid.stl", "--subspheres", 20, "--spacing", spacing)
        assert len(radii) == 20
        share, deviation = random_share(semiaxes, centres, radii)
        found = float(row["in_exactly_one"])
        assert abs(found - share) < 5.0 * deviation + 0.02, (found, share)  # mesh against ellipsoid
        assert found < most, (spacing, found)
    (row,) = rows_of("template", "--from", "ellipsoid.stl", "--tolerance", 0.1)
    assert float(row["in_exactly_one"]) <= 0.1 and 5 < int(row["subspheres"]) < 60, row
    # a box: volume and centre are known; inscribed balls stay inside
    write_stl("box.stl", box_triangles((3.0, 2.0, 1.0))[:, ::-1], True)  # inside out is mended
    post("template", "--from", "box.stl", "--spheres", 30, "--multisphere", "box.txt")
    (row,) = rows_of("template", "--from", "box.stl", "--spheres", 30)
    assert int(row["subspheres"]) == 30
    assert abs(float(row["volume_m3"]) / float(row["volume_ratio"]) - 6.0) < 1e-5
    centres, radii = spheres_of("--from", "box.stl", "--subspheres", 30)
    assert np.all(centres - radii[:, None] > -1e-6)
    assert np.all(centres + radii[:, None] < np.array([3.0, 2.0, 1.0]) + 1e-6)
    points = np.random.default_rng(5).uniform((0, 0, 0), (3, 2, 1), (200000, 3))
    inside = in_union(points, centres, radii).mean()
    assert abs(float(row["volume_ratio"]) - inside) < 0.006, (row, inside)
    # a box with a hollow, whichever way its surface is turned: no sphere reaches into it
    for turn in (1, -1):
        hollow = np.concatenate([box_triangles((4.0, 4.0, 4.0)), box_triangles((2.0, 2.0, 2.0))[:, ::turn] + 1.0])
        write_stl("hollow.stl", hollow, True)
        (row,) = rows_of("template", "--from", "hollow.stl", "--spheres", 60)
        assert abs(float(row["volume_m3"]) / float(row["volume_ratio"]) - 56.0) < 1e-4, row
        centres, radii = spheres_of("--from", "hollow.stl", "--subspheres", 60)
        away = np.linalg.norm(np.maximum(np.abs(centres - 2.0) - 1.0, 0.0), axis=1)
        assert np.all(away > radii - 1e-6)
        points = np.random.default_rng(6).uniform(0, 4, (200000, 3))
        solid = np.abs(points - 2.0).max(1) > 1.0
        share = np.mean(in_union(points, centres, radii) != solid) * 64.0 / 56.0
        assert abs(float(row["in_exactly_one"]) - share) < 0.006, (row, share)
    # a needle and a plate, not along the axes: as many spheres as wanted, by random points
    cos, sin = np.cos(0.7), np.sin(0.7)
    turn = np.array([[cos, -sin, 0.0], [0.6 * sin, 0.6 * cos, -0.8], [0.8 * sin, 0.8 * cos, 0.6]])
    for name, semiaxes, n in (("needle.stl", (1.0, 0.03, 0.02), 60), ("plate.stl", (1.0, 0.8, 0.04), 400)):
        write_stl(name, ellipsoid_triangles(semiaxes, 40, 48) @ turn.T, True)
        (row,) = rows_of("template", "--from", name, "--spheres", n)
        centres, radii = spheres_of("--from", name, "--subspheres", n)
        assert len(radii) == n
        own = centres @ turn
        share, deviation = random_share(np.array(semiaxes), own, radii)
        found = float(row["in_exactly_one"])
        assert abs(found - share) < 5.0 * deviation + 0.02, (name, found, share)
        print(f"{name}: {n} spheres leave {found:.3f} of the volume")
    write("ball.csv", "1.5,1,0.5,0.5\n")
    (row,) = rows_of("template", "--clump", "ball.csv", "--from", "box.stl")
    assert abs(float(row["in_exactly_one"]) - (1.0 - np.pi / 6.0 / 6.0)) < 1e-3


def pebble_radius(directions):
    """Of a lopsided body with dents (M,), as a scan may be: a = 1 within 0.55 to 1.4."""
    x, y, z = directions.T
    return (1.0 + 0.2 * x + 0.12 * np.sin(5.0 * y + 1.0) * np.cos(4.0 * z) - 0.25 * np.exp(-8.0 * ((x - 0.6) ** 2 + y ** 2)))


def check_irregular_body():
    """A dented pebble in mm, by random points: volume, centre, share; then to metres, as a simulation takes it."""
    corners = ellipsoid_triangles((1.0, 1.0, 1.0), 48, 72)
    unit = corners.reshape(-1, 3)
    write_stl("pebble.stl", (8.0 * pebble_radius(unit)[:, None] * unit).reshape(corners.shape) + (50.0, -20.0, 5.0), False)
    points = np.random.default_rng(9).uniform(-12, 12, (300000, 3))
    distance = np.linalg.norm(points, axis=1)
    body = distance < 8.0 * pebble_radius(points / distance[:, None])
    volume, per_point = body.mean() * 24.0 ** 3, 24.0 ** 3 / len(points)
    for spacing in ("medial", "minimax_volume"):
        words = ("--from", "pebble.stl", "--subspheres", 60, "--spacing", spacing)
        (row,) = rows_of("template", *words)
        centres, radii = spheres_of(*words)
        inside = in_union(points, centres - (50.0, -20.0, 5.0), radii)
        deviation = np.sqrt((inside != body).sum()) * per_point / volume
        found = float(row["in_exactly_one"])
        assert abs(found - (inside != body).sum() * per_point / volume) < 5.0 * deviation + 5e-3, row  # mesh against the body
        assert abs(float(row["volume_m3"]) / float(row["volume_ratio"]) / volume - 1.0) < 0.01, (row, volume)
        mean = points[inside].mean(0) + (50.0, -20.0, 5.0)
        assert all(abs(float(row[f"centre_{axis}_m"]) - wanted) < 0.1 for axis, wanted in zip("xyz", mean)), (row, mean)
        print(f"pebble, {spacing}: 60 spheres leave {found:.3f} of the volume")
    assert found < 0.09, found


def check_bad_surfaces():
    write_stl("open.stl", box_triangles((1.0, 1.0, 1.0))[1:], True)
    _, error = post("template", "--from", "open.stl", expect=1)
    assert "not closed: 3 of 18 edges" in error and error.count("\n") == 1, error
    turned = box_triangles((1.0, 1.0, 1.0))
    turned[4] = turned[4][::-1]
    write_stl("turned.stl", turned, False)
    assert "not closed" in post("template", "--from", "turned.stl", expect=1)[1]
    pair = np.concatenate([box_triangles((1.0, 1.0, 1.0)), box_triangles((1.0, 1.0, 1.0)) + 3.0])
    write_stl("pair.stl", pair, True)
    _, error = post("template", "--from", "pair.stl", expect=1)
    assert "2 bodies apart" in error and error.count("\n") == 1, error
    pair = np.concatenate([box_triangles((1.0, 1.0, 1.0)), box_triangles((1.0, 1.0, 1.0)) + 0.5])
    write_stl("cut.stl", pair, True)
    assert "cut each other" in post("template", "--from", "cut.stl", expect=1)[1]
    in_hollow = np.concatenate([box_triangles((size,) * 3) - 0.5 * size for size in (1.0, 3.0, 2.0)])
    write_stl("in_hollow.stl", in_hollow, True)
    assert "2 bodies apart in 3" in post("template", "--from", "in_hollow.stl", expect=1)[1]
    # one surface: its top pulled through its bottom, its upper part turned inside out, and a dent that is none of that
    body = ellipsoid_triangles((1.0, 0.6, 0.8))
    top = np.abs(body - (0.0, 0.0, 0.8)).max(2) < 1e-12
    through, turned, dent = body.copy(), body.copy(), body.copy()
    through[..., 2] -= np.where(body[..., 2] > 0.5, 1.8, 0.0)
    dent[top] = (0.0, 0.0, -0.5)
    turned[..., 0] *= np.where(turned[..., 2] > 0.3, -1.0, 1.0)
    for name, triangles in (("through.stl", through), ("turned.stl", turned)):
        write_stl(name, triangles, False)
        _, error = post("template", "--from", name, expect=1)
        assert f"{name}: the surface cuts itself" in error and error.count("\n") == 1, error
    write_stl("dent.stl", dent, False)
    assert post("template", "--from", "dent.stl", "--spheres", 5)[1] == ""
    words = ("--from", "dent.stl", "--spheres", 5, "--subspheres", 6)
    assert "--subspheres: has no effect with a number of --spheres" in post("template", *words, expect=2)[1]
    write("words.stl", "these are words\n")
    assert "STL file" in post("template", "--from", "words.stl", expect=1)[1]
    write_stl("box.stl", box_triangles((1.0, 1.0, 1.0)), True)
    _, error = post("template", "--from", "box.stl", "--spacing", "paper", "--subspheres", 5, expect=1)
    assert "medial or minimax_volume" in error, error
    _, error = post("template", "--from", "box.stl", "--subspheres", 100000, expect=1)
    assert "allowed are 1 to" in error, error


check_ellipsoid_sets()
check_levels()
check_even_minimax()
check_largest()
check_means_of_minimax()
check_roughness()
check_progress()
check_tolerance()
check_lists()
check_doubled_spheres()
check_spheres_far_out()
check_bad_lists()
check_surfaces()
check_irregular_body()
check_bad_surfaces()
