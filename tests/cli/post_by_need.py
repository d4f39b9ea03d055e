# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""A value that is no number stops the commands that need its column, and no others; rigid bodies of the host: their motion
from the spheres alone, across faces of periodic boxes, in contact lists; inertia from columns."""
import math

import numpy as np

from _synthetic import COLUMNS, frame_text, json_of, particle, post, rows_of, write

BOX = ("--box", 0, 0.01, 0, 0.01, 0, 0.01)
# command: (arguments behind the file, columns that it needs besides places, sizes and orientations)
NEEDS = {
    "pile": ((), "vx omegax"), "repose": ((), ""), "porosity": ((), ""), "coordination": ((), ""), "contacts": ((), ""),
    "bed": (BOX, ""), "orientation": ((), "type"), "pairs": (("--gap", 1e-4), ""), "trajectory": ((), ""),
    "energy": ((), "mass vx omegax"), "mixing": (("--size", "--cell", 0.004), ""),
    "flow": (("--through", 0, 0.01, 0, 0, 1, 0), "mass"), "fields": (("--at", 0, 0, 0), "mass vx omegax"),
    "render": (("-o", "x.svg"), ""), "render3d": (("-o", "x.png"), ""), "paraview": (("-o", "x"), ""), "view": (("-o", "x.html"), "")}
MOTION = ("mass", "vx", "omegax", "type", "c_extra")


def rows_of_pile():
    rows = []
    for k in range(160):  # a slope: columns of balls beside a wall
        i, j = k // 20, k % 20
        if j < 20 - 2 * i:
            row = particle(len(rows) + 1, 0.001 + 0.002 * i, 0.00099 + 0.00198 * j, a=0.001, b=0.001)
            row.update(type=1 + k % 2, c_extra=1.0, shapex=0.001 + 1e-6 * (k % 3))
            rows.append(row)
    return rows


def check_needs():
    rows, columns = rows_of_pile(), [*COLUMNS, "c_extra"]
    name = write("good.dump", frame_text(1, rows, columns) + frame_text(2, rows, columns))
    reference = {command: post(command, name, *arguments, expect=0)[0] for command, (arguments, _) in NEEDS.items()}
    for column in MOTION:
        broken = [dict(row) for row in rows]
        broken[7][column] = math.nan
        text = frame_text(1, rows, columns) + frame_text(2, broken, columns)
        write("good.dump", text)
        for command, (arguments, needed) in NEEDS.items():
            stops = column in needed.split()
            out, error = post(command, name, *arguments, expect=1 if stops else 0)
            line = 9 + 9 + len(rows) + 7 + 1
            if stops:
                assert f'good.dump:{line}: frame 2: expected a finite number in column "{column}", found "nan"' in error, error
            else:
                assert out == reference[command], (command, column, out)
    # a stray word in what a command does not look at by itself, but is asked for
    broken = [dict(row, c_extra=math.nan if row["id"] == 3 else 1.0) for row in rows]
    write("good.dump", frame_text(1, broken, columns))
    for command, arguments in (("mixing", ("--value", "c_extra")), ("render", ("-o", "x.svg", "--colour", "c_extra")),
                               ("view", ("-o", "x.html", "--colour", "c_extra")),
                               ("render3d", ("-o", "x.png", "--colour", "c_extra"))):
        _, error = post(command, name, *arguments, expect=1)
        assert "c_extra" in error, (command, error)
    # spheres need no orientation; ellipsoids do
    for shape, code in ((0.001, 0), (0.0011, 1)):
        broken = [dict(row, shapex=shape, quat1=math.nan) for row in rows]
        post("contacts", write("turned.dump", frame_text(1, broken)), expect=code)
    # no speeds to colour by
    still = write("still.dump", frame_text(1, rows, [c for c in COLUMNS if c not in ("vx", "vy", "vz")]))
    _, error = post("render", still, "-o", "x.svg", "--colour", "speed", expect=1)
    assert "vx vy vz" in error


def body_dump(name, bodies, box, bounds="pp pp pp", extra=()):
    """Spheres of rigid bodies, wrapped into the box: (number, [(place, radius)], velocity of the centre, spin, mass)."""
    lines, k = [], 0
    low, high = np.array(box[::2]), np.array(box[1::2])
    for number, spheres, velocity, spin, mass in bodies:
        centre = np.mean([p for p, _ in spheres], axis=0)
        for place, radius in spheres:
            k += 1
            at = low + (np.array(place) - low) % (high - low) if "p" in bounds else place
            v = np.array(velocity) + np.cross(spin, np.array(place) - centre)
            lines.append(" ".join(map(repr, map(float, (k, number, mass, radius, *at, *v, *spin)))))
    lines += [" ".join(map(repr, map(float, row))) for row in extra]
    head = ["ITEM: TIMESTEP", "0", "ITEM: NUMBER OF ATOMS", str(len(lines)), "ITEM: BOX BOUNDS " + bounds,
            *(f"{box[2 * a]} {box[2 * a + 1]}" for a in range(3)),
            "ITEM: ATOMS id id_multisphere mass radius x y z vx vy vz omegax omegay omegaz"]
    return write(name, "\n".join(head + lines) + "\n")


def chain(centre, direction, half=1.5):
    d = np.array(direction) / np.linalg.norm(direction)
    return [(np.array(centre) + s * d, r) for s, r in ((-half, 0.5), (0.0, 1.0), (half, 0.5))]


def check_bodies():
    rng, box = np.random.default_rng(2), (0, 10, 0, 9, 0, 8)
    bodies = [(n + 1, chain(rng.uniform(0, 8, 3), rng.normal(size=3)), rng.normal(size=3), rng.normal(size=3), 2.0)
              for n in range(40)]
    split = body_dump("split.dump", bodies, box)
    whole = body_dump("whole.dump", bodies, box, "ff ff ff")
    (cut,), (one,) = json_of("energy", split), json_of("energy", whole)
    speed = sum(0.5 * 2 * np.dot(v, v) for _, _, v, _, _ in bodies)
    turning = 0.0
    for _, spheres, _, w, _ in bodies:  # about the axis 2/5 m b^2, across it m (a^2 + b^2) / 5, a = 2, b = 1
        u = (spheres[2][0] - spheres[0][0]) / np.linalg.norm(spheres[2][0] - spheres[0][0])
        turning += 0.5 * (2 * 2 / 5 * (w @ u) ** 2 + 2 * (4 + 1) / 5 * (w @ w - (w @ u) ** 2))
    for row in cut, one:
        assert abs(row["translation_J"] / speed - 1) < 1e-9 and abs(row["rotation_J"] / turning - 1) < 1e-9, (row, speed, turning)
    a, b = json_of("orientation", split)[0], json_of("orientation", whole)[0]
    assert abs(a["nematic_order"] - b["nematic_order"]) < 1e-9
    # contacts over all images, sphere by sphere; spheres of one body do not count
    spheres = [(n, np.array(p), r) for n, parts, *_ in bodies for p, r in parts]
    edges, touching = np.array([10.0, 9.0, 8.0]), set()
    for i, (n, p, r) in enumerate(spheres):
        for m, q, s in spheres[i + 1:]:
            d = q - p
            if n != m and np.linalg.norm(d - edges * np.round(d / edges)) <= r + s:
                touching.add((n, m))
    (found,) = json_of("coordination", split, "--space")
    assert found["contacts"] == len(touching) > 30, (found["contacts"], len(touching))
    # without spins the centres' velocities are still known
    text = open(split, encoding="ascii").read().replace("omegax omegay omegaz", "u1 u2 u3")
    (row,) = json_of("energy", write("nospin.dump", text))
    assert abs(row["translation_J"] / speed - 1) < 1e-9 and row["rotation_J"] is None


def check_lists_of_bodies():
    """The host's lists name spheres, not bodies."""
    bodies = [(7, chain((2, 2, 2), (1, 0, 0)), (0, 0, 0), (0, 0, 0), 1.0), (3, chain((2, 4, 2), (1, 0, 0)), (0, 0, 0), (0, 0, 0), 1.0),
              (9, chain((2, 7, 2), (1, 0, 0)), (0, 0, 0), (0, 0, 0), 1.0)]
    name = body_dump("three.dump", bodies, (0, 10, 0, 10, 0, 10), "ff ff ff")
    pairs = write("three.local", "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ENTRIES\n2\nITEM: BOX BOUNDS ff ff ff\n0 10\n0 10\n0 10\n"
                                 "ITEM: ENTRIES i j h\n2 5 0.1\n1 4 0.2\n")
    (row,) = json_of("coordination", name, "--space", "--contacts", pairs, "--id-columns", "i", "j", "--overlap-column", "h",
                     "--per-particle", "z.csv")
    assert row["contacts"] == 1 and row["zss"] == 4 / 3 and abs(row["mean_overlap_b"] - 0.15) < 1e-12, row
    with open("z.csv", encoding="ascii") as file:
        partners = {line.split(",")[2]: line.split(",")[7] for line in file.read().splitlines()[1:]}
    assert partners == {"7": "1", "3": "1", "9": "0"}, partners


def check_refusals():
    one = [(5, chain((2, 2, 2), (1, 0, 0)), (0, 0, 0), (0, 0, 0), 1.0)]
    single = (5, 0, 1, 0.5, 8, 8, 8, 0, 0, 0, 0, 0, 0)
    _, error = post("contacts", body_dump("same.dump", one, (0, 10) * 3, extra=[single]), expect=1)
    assert "5 for both" in error and "--bodies none" in error and error.count("\n") == 1, error
    post("contacts", body_dump("other.dump", one, (0, 10) * 3, extra=[(6, *single[1:])]))
    _, error = post("contacts", "other.dump", "--subspheres", 5, expect=1)
    assert "--subspheres" in error
    rows = [particle(k, 0.01 * k, 0) for k in (1, 2)]
    for row in rows:
        row["mol"] = 1
    _, error = post("contacts", write("mol.dump", frame_text(1, rows, [*COLUMNS, "mol"])), "--bodies", "mol", expect=1)
    assert "a sphere of a rigid body" in error
    smooth = write("smooth.dump", frame_text(1, rows))
    _, error = post("contacts", smooth, "--spacing", "minimax_outline", expect=1)
    assert "--spacing" in error and "--subspheres" in error


def check_inertia():
    """Moments of the file's columns; of a bent body, which is no chain, those of the union (here spheres apart)."""
    moments = (3e-11, 5e-11, 7e-11)
    row = particle(1, 0.0, 0.0, angle=0.7)
    row.update(zip(("inertiax", "inertiay", "inertiaz"), moments), omegax=3.0, omegay=-2.0, omegaz=5.0)
    columns = [*COLUMNS, "inertiax", "inertiay", "inertiaz"]
    (found,) = json_of("energy", write("moments.dump", frame_text(1, [row], columns)))
    c, s = math.cos(0.7), math.sin(0.7)
    spin = (3 * c - 2 * s, -3 * s - 2 * c, 5.0)
    expected = 0.5 * sum(i * w * w for i, w in zip(moments, spin))
    assert abs(found["rotation_J"] / expected - 1) < 1e-9, (found, expected)
    (other,) = json_of("energy", "moments.dump", "--inertia", *(2 * m for m in moments))
    assert abs(other["rotation_J"] / expected - 2) < 1e-9
    places = [np.array(p, float) for p in ((1, 1, 0), (-1, 1, 0), (-1, -1, 0), (1, -1, 0))]
    w, mass, radius = np.array((0.3, -0.4, 0.5)), 8.0, 0.6
    name = body_dump("square.dump", [(1, [(p + 5, radius) for p in places], (0, 0, 0), w, mass)], (0, 10) * 3, "ff ff ff")
    (found,) = json_of("energy", name)
    turning = sum(0.5 * mass / 4 * (0.4 * radius ** 2 * (w @ w) + (p @ p) * (w @ w) - (p @ w) ** 2) for p in places)
    assert abs(found["rotation_J"] / turning - 1) < 1e-9, (found, turning)
    assert "--inertia" in post("energy", name)[1]


check_needs()
check_bodies()
check_lists_of_bodies()
check_refusals()
check_inertia()
