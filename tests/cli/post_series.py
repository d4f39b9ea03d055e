# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""Measures of whole series: errors of averaged fields, flow, residence times, collisions of lists, mixing by volume.

Oracles: numpy on the made particles themselves, random orders, closed forms of straight ways."""
import csv
import math
import os

import numpy as np

from _synthetic import COLUMNS, frame_text, json_of, particle, post, rows_of, write

SEED = 11


def frame(step, rows, box, bounds="ff ff ff", columns=COLUMNS):
    lines = ["ITEM: TIMESTEP", str(step), "ITEM: NUMBER OF ATOMS", str(len(rows)), f"ITEM: BOX BOUNDS {bounds}"]
    lines += [f"{box[2 * k]} {box[2 * k + 1]}" for k in range(3)]
    lines += ["ITEM: ATOMS " + " ".join(columns)] + [" ".join(repr(row[c]) for c in columns) for row in rows]
    return "\n".join(lines) + "\n"


def ball(number, place, radius=0.5, **more):
    row = particle(number, float(place[0]), float(place[1]), a=radius, b=radius)
    row.update(z=float(place[2]), **more)
    return row


def jackknife(values, weights, whole_of):
    """Standard error of whole_of(sum over blocks) by leaving out one block after the other (Busing et al. 1999)."""
    total, n, g = values.sum(axis=0), weights.sum(), len(weights)
    whole = whole_of(total / n)
    left = np.array([whole_of((total - v) / (n - w)) for v, w in zip(values, weights)])
    centre = g * whole - ((1 - weights / n)[:, None] * left).sum(axis=0)
    h = (n / weights)[:, None]
    pseudo = h * whole - (h - 1) * left
    return np.sqrt((((pseudo - centre) ** 2) / (h - 1)).sum(axis=0) / g)


def check_field_errors(rng):
    """One particle at a point far from the others: density and velocity there are those of its mass and velocity."""
    for frames in (2, 7, 45):
        mass, speed = rng.uniform(1, 2, frames), rng.normal(size=frames)
        text = "".join(frame(n, [ball(1, (0, 0, 0), mass=float(mass[n]), vx=float(speed[n]))], (-9, 9, -9, 9, -9, 9))
                       for n in range(frames))
        (row,) = json_of("fields", write("one.dump", text), "--at", 0, 0, 0, "--frame", "all", "--average",
                         "--standard-errors", "--width", 1, "--kernel", "heaviside")
        each = 1 if frames <= 40 else 2  # frames in a block: 40 blocks at most
        blocks = [range(k, min(k + each, frames)) for k in range(0, frames, each)]
        sums = np.array([[mass[list(b)].sum(), (mass * speed)[list(b)].sum()] for b in blocks])
        weights = np.array([float(len(b)) for b in blocks])
        phi = 3 / (4 * math.pi)
        errors = jackknife(sums, weights, lambda m: np.array([phi * m[0], m[1] / m[0]]))
        assert abs(row["density_kg_per_m3"] / (phi * mass.mean()) - 1) < 1e-9
        assert abs(row["density_standard_error_kg_per_m3"] / errors[0] - 1) < 1e-6, (row, errors)
        assert abs(row["velocity_x_standard_error_m_per_s"] / errors[1] - 1) < 1e-6, (row, errors)
        if each == 1:
            assert abs(errors[0] / (phi * mass.std(ddof=1) / math.sqrt(frames)) - 1) < 1e-9
    post("fields", "one.dump", "--at", 0, 0, 0, "--standard-errors", expect=2)
    (row,) = json_of("fields", write("single.dump", frame(0, [ball(1, (0, 0, 0))], (-9, 9, -9, 9, -9, 9))), "--at", 0, 0, 0,
                     "--frame", "all", "--average", "--standard-errors")
    assert row["density_standard_error_kg_per_m3"] is None


def check_flow(rng):
    """Balls on straight ways with speeds of their own: when and where each one passes is known."""
    count, steps, dt = 60, 40, 0.05
    start = np.column_stack([rng.uniform(-1, 1, count), rng.uniform(-1, 1, count), rng.uniform(0.3, 6, count)])
    speed = np.column_stack([rng.normal(0, 0.05, (count, 2)), -rng.uniform(1, 3, count)])
    born = rng.integers(0, 8, count)  # frame in which it is first there
    mass = rng.uniform(1, 2, count)
    text = ""
    for n in range(steps):
        there = [k for k in range(count) if born[k] <= n]
        text += frame(n, [ball(k + 1, start[k] + speed[k] * dt * n, 0.1, mass=float(mass[k])) for k in there],
                      (-9, 9, -9, 9, -200, 9))
    name = write("falls.dump", text)
    times = -start[:, 2] / speed[:, 2]
    passed = [k for k in range(count) if born[k] * dt <= times[k] <= dt * (steps - 1) and np.hypot(
        *(start[k] + speed[k] * times[k])[:2]) <= 1]
    disc = ("--disc", 0, 0, 0, 0, 0, -1, 1, "--dt", dt)
    (total,) = json_of("flow", name, *disc, "--total", "--passages", "out.csv")
    known = [k for k in passed if born[k] > 0]
    residence = np.array([times[k] - born[k] * dt for k in known])
    assert len(known) > 20 and total["forward"] == len(passed) and total["residence_count"] == len(known)
    assert total["residence_unknown"] == len(passed) - len(known) > 0
    for key, value in (("mean", residence.mean()), ("standard_deviation", residence.std(ddof=1)),
                       ("shortest", residence.min()), ("longest", residence.max())):
        assert abs(total[f"residence_{key}_s"] - value) < 1e-9, (key, total, value)
    with open("out.csv", encoding="ascii") as file:
        listed = {int(row["id"]) - 1: row for row in csv.DictReader(file)}
    assert sorted(listed) == sorted(passed)
    for k, row in listed.items():
        place = start[k] + speed[k] * times[k]
        assert abs(float(row["time_s"]) - times[k]) < 1e-9
        assert all(abs(float(row[f"{axis}_m"]) - place[a]) < 1e-9 for a, axis in enumerate("xyz"))
        assert all(abs(float(row[f"velocity_{axis}_m_per_s"]) - speed[k][a]) < 1e-9 for a, axis in enumerate("xyz"))
    # from an inlet at z = 0.3 m, seen by all
    (total,) = json_of("flow", name, *disc, "--total", "--inlet", 0, 0, 0.3, 0, 0, -1)
    inlet = [k for k in passed if (0.3 - start[k, 2]) / speed[k, 2] >= born[k] * dt]
    ways = np.array([-0.3 / speed[k, 2] for k in inlet])
    assert total["residence_count"] == len(inlet) > 20
    assert abs(total["residence_mean_s"] - ways.mean()) < 1e-9, total
    rings = json_of("flow", name, *disc, "--profile", 3)
    for n, ring in enumerate(rings):
        own = [k for k in passed if n <= 3 * np.hypot(*(start[k] + speed[k] * times[k])[:2]) < n + 1]
        area, duration = math.pi * ((n + 1) ** 2 - n ** 2) / 9, dt * (steps - 1)
        assert ring["forward"] == len(own) > 0
        assert abs(ring["mass_flux_kg_per_m2_s"] - mass[own].sum() / area / duration) < 1e-9
        mean = -(mass[own] * speed[own, 2]).sum() / mass[own].sum()
        assert abs(ring["normal_speed_m_per_s"] - mean) < 1e-9, (ring, mean)
        square = (mass[own] * speed[own, 2] ** 2).sum() / mass[own].sum()
        assert abs(ring["normal_speed_standard_deviation_m_per_s"] - math.sqrt(max(0, square - mean ** 2))) < 1e-6
        across = (mass[own] * np.hypot(*speed[own, :2].T)).sum() / mass[own].sum()
        assert abs(ring["speed_across_m_per_s"] - across) < 1e-9
    plane = ("--through", 0, 0, 0, 0, 0, -1, "--dt", dt)
    strips = json_of("flow", name, *plane, "--profile", 4, "--strips", 2, 0, 0, -2, 2)
    through = [k for k in range(count) if born[k] * dt <= times[k] <= dt * (steps - 1)]
    places = [(start[k] + speed[k] * times[k])[0] for k in through]
    assert [row["forward"] for row in strips] == list(np.histogram(places, 4, (-2, 2))[0])
    assert strips[0]["mass_flux_kg_per_m2_s"] is None
    for words, arguments in (("--dt", ("--through", 0, 0, 0, 0, 0, -1, "--passages", "x.csv")),
                             ("--strips", (*plane, "--profile", 3)),
                             ("ascending", (*plane, "--profile", 3, "--strips", 1, 0, 0, 2, 1))):
        _, error = post("flow", name, *arguments, expect=1)
        assert words in error and error.splitlines()[1:] == ["error: falls.dump: the same in 39 more frames"], (words, error)


def check_shared_edges():
    """A mesh of triangles counts a ball once, wherever it goes: through edges and corners, and resting in the plane."""
    n, text = 4, ["solid s"]
    for i in range(-n, n):
        for j in range(-n, n):
            a, b, c, d = (i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)
            for corners in ((a, b, c), (a, c, d)) if (i + j) % 2 else ((a, b, d), (b, c, d)):
                text += ["facet normal 0 0 1", "outer loop", *(f"vertex {x} {y} 0" for x, y in corners), "endloop", "endfacet"]
    write("tiles.stl", "\n".join(text + ["endsolid s"]) + "\n")
    places = [(0.5 * i, 0.5 * j) for i in range(-7, 8) for j in range(-7, 8)]  # middles of edges, corners, diagonals
    heights = (1.0, 0.25, 0.0, -0.5)  # one frame in the plane itself
    text = "".join(frame(n, [ball(k + 1, (*p, z), 0.1) for k, p in enumerate(places)], (-9, 9, -9, 9, -9, 9))
                   for n, z in enumerate(heights))
    (down,) = json_of("flow", write("rain.dump", text), "--face", "tiles.stl", "--total")
    assert down["backward"] == len(places) and down["forward"] == 0, down
    text = "".join(frame(n, [ball(k + 1, (*p, -z), 0.1) for k, p in enumerate(places)], (-9, 9, -9, 9, -9, 9))
                   for n, z in enumerate(heights))
    (up,) = json_of("flow", write("rise.dump", text), "--face", "tiles.stl", "--total")
    assert up["forward"] == len(places) and up["backward"] == 0, up


def check_collisions_of_lists():
    """Two pairs; the list names a contact in frames 2 and 3, whatever the geometry is."""
    text, lists = "", ""
    for n in range(6):
        sign = 1 if n < 3 else -1
        rows = [ball(1, (0.9, 0, 0), 0.1, vx=0.5 * sign), ball(2, (-0.9, 0, 0), 0.1, vx=-0.25 * sign, omegaz=2.0),
                ball(3, (0, 5, 0), 0.1)]
        text += frame(10 * n, rows, (-1, 1, -9, 9, -9, 9), "pp ff ff")
        touching = ["2 1 -1.0 0.01 0 3 0 0 1e-3"] if n in (2, 3) else []
        lists += "\n".join(["ITEM: TIMESTEP", str(10 * n), "ITEM: NUMBER OF ENTRIES", str(len(touching)),
                            "ITEM: BOX BOUNDS pp ff ff", "-1 1", "-9 9", "-9 9",
                            "ITEM: ENTRIES i j x y z nx ny nz h", *touching]) + "\n"
    write("two.dump", text)
    write("two.local", lists)
    options = ("--collisions", "--dt", 0.01, "--contacts", "two.local", "--id-columns", "i", "j")
    (row,) = json_of("trajectory", "two.dump", *options, "--point-columns", "x", "y", "z", "--normal-columns", "nx", "ny",
                     "nz", "--overlap-column", "h")
    assert (row["id_1"], row["id_2"]) == (1, 2) and abs(row["begin_s"] - 0.15) < 1e-12
    assert abs(row["duration_s"] - 0.2) < 1e-12 and row["largest_overlap_m"] == 1e-3
    # through the face: 1 at x = 0.9 and the image of 2 at 1.1, n = x; the contact is 0.1 from both, 0.01 above them
    v = (-0.25 - 0.5 - 2.0 * 0.01, 2.0 * -0.1)  # of 2's point as seen from 1: v2 + omega2 x r2, r2 = (-0.1, 0.01)
    assert abs(row["normal_speed_m_per_s"] + v[0]) < 1e-12, row
    assert abs(row["tangential_speed_m_per_s"] - abs(v[1])) < 1e-12, row
    (row,) = json_of("trajectory", "two.dump", *options)
    assert row["largest_overlap_m"] is None and abs(row["normal_speed_m_per_s"] - 0.75) < 1e-12
    assert json_of("trajectory", "two.dump", "--collisions", "--dt", 0.01) == []


def check_mixing_by_volume(rng):
    count, size = 400, 4
    radii = np.where(rng.uniform(size=count) < 0.3, 0.2, 0.1) * rng.uniform(0.9, 1.1, count)
    kinds = np.where(radii > 0.15, 1, 2)
    centres = rng.uniform(0, size, (count, 3))
    name = write("sizes.dump", frame(1, [ball(k + 1, c, float(r), type=int(t)) for k, (c, r, t) in
                                         enumerate(zip(centres, radii, kinds))], (0, size) * 3, "pp pp pp"))
    w, q = radii ** 3, (kinds == 1).astype(float)
    cells = np.floor(centres).astype(int) @ (1, 10, 100)

    def variance(q, w):
        p, total = (w * q).sum() / w.sum(), 0.0
        for cell in np.unique(cells):
            own = cells == cell
            total += w[own].sum() * ((w[own] * q[own]).sum() / w[own].sum() - p) ** 2
        return total / w.sum()

    (row,) = json_of("mixing", name, "--type", 1, "--cell", 1, "--by-volume", "--neighbours", 5)
    p = (w * q).sum() / w.sum()
    segregated = (w * (q - p) ** 2).sum() / w.sum()
    assert row["counted_by"] == "volume" and abs(row["tracer_mean"] - p) < 1e-9
    assert abs(row["variance"] / variance(q, w) - 1) < 1e-9 and abs(row["variance_segregated"] / segregated - 1) < 1e-9
    orders = [rng.permutation(count) for _ in range(400)]
    random = np.mean([variance(q[o], w[o]) for o in orders])
    assert abs(row["variance_random"] / random - 1) < 0.1, (row["variance_random"], random)  # to first order
    lacey = (segregated - row["variance"]) / (segregated - row["variance_random"])
    assert abs(row["lacey_index"] / lacey - 1) < 1e-9
    d = centres[:, None] - centres
    d -= size * np.round(d / size)
    near = np.argsort((d ** 2).sum(axis=2), axis=1)[:, 1:6]
    unlike = sum(w[i] * w[k] * (q[i] - q[k]) ** 2 for i in range(count) for k in near[i]) / (5 * count)
    pairs = w[:, None] * w * (q[:, None] - q) ** 2
    assert abs(row["neighbour_index"] / (unlike / (pairs.sum() / (count * (count - 1)))) - 1) < 1e-9
    x = centres - centres.min(axis=0)
    gmmi = [(w * q * x[:, k]).sum() / (w * x[:, k]).sum() / p for k in range(3)]
    assert abs(row["gmmi"] - np.mean(gmmi)) < 1e-9
    # no order goes beyond the bounds, and orders by w (q - L) come near them
    for order in orders[:50] + [np.argsort(w * (q - p)), np.argsort(-w * (q - p))]:
        wo, qo = w[order], q[order]
        index = np.mean([(wo * qo * np.sort(x[:, k])).sum() / (wo * np.sort(x[:, k])).sum() / p for k in range(3)])
        assert row["gmmi_lowest"] - 1e-12 <= index <= row["gmmi_highest"] + 1e-12
    assert row["gmmi_highest"] - index > 0.5 * (row["gmmi_highest"] - row["gmmi_lowest"])
    scan = json_of("mixing", name, "--type", 1, "--scan", 0.5, 2, 3)
    assert [round(r["cell_m"], 12) for r in scan] == [0.5, 1.0, 2.0] and scan[1]["counted_by"] == "number"
    (number,) = json_of("mixing", name, "--type", 1, "--cell", 1)
    assert abs(number["variance"] / variance(q, np.ones(count)) - 1) < 1e-9
    # jackknife over the cells, of the intensity
    ones = np.ones(count)
    names = np.unique(cells)

    def intensity(kept):
        qk, ck = q[kept], cells[kept]
        p = qk.mean()
        s2 = sum((ck == c).sum() * (qk[ck == c].mean() - p) ** 2 for c in np.unique(ck)) / len(qk)
        return s2 / (p * (1 - p)), math.sqrt(s2) / p

    left = np.array([intensity(cells != c) for c in names])
    error = np.sqrt(((left - left.mean(axis=0)) ** 2).sum(axis=0) * (len(names) - 1) / len(names))
    assert abs(number["segregation_intensity_standard_error"] / error[0] - 1) < 1e-6, (number, error)
    assert abs(number["relative_standard_deviation_standard_error"] / error[1] - 1) < 1e-6 and ones.sum() == count
    _, text = post("mixing", name, "--type", 1, "--scan", 2, 1, 3, expect=1)
    assert "ascending" in text


def check_walls_of_the_run(rng):
    """Walls of the log are those that are told by hand, on either side of a plane."""
    os.mkdir("walled")
    centres = rng.uniform(-1, 1, (200, 3)) * (1, 1, 2)
    name = write("walled/bed.dump", frame(1, [ball(k + 1, c, 0.1) for k, c in enumerate(centres)], (-3, 3) * 3))
    write("walled/roof.stl", "solid s\nfacet normal 0 0 1\nouter loop\nvertex -100 -100 10\nvertex 100 -100 10\n"
                             "vertex 0 100 10\nendloop\nendfacet\nendsolid s\n")
    write("walled/log.run", "fix a all wall/gran/ellipsoid model hertz primitive type 1 xplane 0.1\n"
          "fix b all wall/gran/ellipsoid model hertz primitive type 1 zcylinder 0.8 0.1 0.2\n"
          "fix gone all wall/gran/ellipsoid model hertz primitive type 1 yplane 0\nunfix gone\n"
          "fix roof all mesh/surface file roof.stl type 1 scale 0.1 move 0 0 0.5\n"
          "fix c all wall/gran/ellipsoid model hertz mesh n_meshes 1 meshes roof\nrun 1\n")
    (row,) = json_of("coordination", name, "--run-walls")
    radius = np.hypot(centres[:, 0] - 0.1, centres[:, 1] - 0.2)
    expected = (np.abs(centres[:, 0] - 0.1) <= 0.1).sum() + (np.abs(radius - 0.8) <= 0.1).sum() \
        + (np.abs(centres[:, 2] - 1.5) <= 0.1).sum()
    assert row["wall_contacts"] == expected > 50, (row["wall_contacts"], expected)
    write("turned.log", "fix m all mesh/surface file roof.stl type 1 rotate axis 1 0 0 angle 5\nrun 1\n")
    for log, words in (("turned.log", "turns"), (write("none.log", "run 1\n"), "found none")):
        _, error = post("coordination", name, "--run-walls", "--log", log, expect=1)
        assert words in error and error.count("\n") == 1, error


def main():
    rng = np.random.default_rng(SEED)
    check_field_errors(rng)
    check_flow(rng)
    check_shared_edges()
    check_collisions_of_lists()
    check_mixing_by_volume(rng)
    check_walls_of_the_run(rng)


main()
