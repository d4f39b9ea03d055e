# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""Commands on what happens inside a packing: tables, files, curves and maps, and one-line errors."""
import csv
import math
import os
import random

from _synthetic import COLUMNS, frame_text, json_of, particle, post, rows_of, wedge, write

G = 10.0


def frame(step, rows, box, bounds="pp pp ff", columns=COLUMNS, label="ATOMS"):
    """One frame of a text dump in a box (x0, x1, y0, y1, z0, z1)."""
    lines = ["ITEM: TIMESTEP", str(step), f"ITEM: NUMBER OF {'ATOMS' if label == 'ATOMS' else 'ENTRIES'}",
             str(len(rows)), f"ITEM: BOX BOUNDS {bounds}"]
    lines += [f"{box[2 * k]} {box[2 * k + 1]}" for k in range(3)]
    lines += [f"ITEM: {label} " + " ".join(columns)]
    lines += [" ".join(repr(row[c]) for c in columns) for row in rows]
    return "\n".join(lines) + "\n"


def ball(number, x, y, z, r=0.5, mass=0.2, kind=1):
    row = particle(number, x, y, a=r, b=r)
    row.update(z=z, mass=mass, type=kind)
    return row


def stack(count):
    """Balls on top of each other on a floor, and the forces between them: the weights above."""
    rows, pairs, walls = [], [], []
    for k in range(count):
        rows.append(ball(k + 1, 0.1, 0.2, k + 0.5))
        force = 0.2 * G * (count - k)
        contact = dict(x=0.1, y=0.2, z=float(k), nx=0.0, ny=0.0, nz=-1.0, fx=0.0, fy=0.0, fz=force)
        if k == 0:
            walls.append(dict(i=1, **contact))
        else:
            pairs.append(dict(i=k + 1, j=k, **contact))
    return rows, pairs, walls


LISTS = ("--contacts", "pairs.local", "--id-columns", "i", "j", "--point-columns", "x", "y", "z",
         "--force-columns", "fx", "fy", "fz", "--normal-columns", "nx", "ny", "nz",
         "--wall-contacts", "walls.local", "--wall-id-column", "i", "--wall-point-columns", "x", "y",
         "z", "--wall-force-columns", "fx", "fy", "fz")


def check_fields():
    count, box = 8, (0, 3, 0, 2, -2, 11)
    rows, pairs, walls = stack(count)
    write("stack.dump", frame(0, rows, box) + frame(10, rows, box))
    entries = "x y z nx ny nz fx fy fz".split()
    write("pairs.local", "".join(frame(s, pairs, box, label="ENTRIES", columns=["i", "j"] + entries)
                                 for s in (0, 10)))
    write("walls.local", "".join(frame(s, walls, box, label="ENTRIES", columns=["i"] + entries)
                                 for s in (0, 10)))
    profile = json_of("fields", "stack.dump", "--profile", "z", "--slices", 1300, "--width", 0.6,
                      *LISTS)
    step = 13 / 1300
    mass = sum(r["density_kg_per_m3"] for r in profile) * step * 6
    # the function's end is a kink: a sum over planes is good to the square of their distance
    assert len(profile) == 1300 and abs(mass / (0.2 * count) - 1) < 1e-6
    above = 0.0  # weight of what lies above less what the floor bears, per area
    for row in reversed(profile):
        load = G * row["density_kg_per_m3"] + row["boundary_force_z_N_per_m3"]
        above += 0.5 * step * load
        assert abs(row["stress_zz_Pa"] - above) < 1e-4 * count, (row["z_m"], above)
        above += 0.5 * step * load
        assert abs(row["pressure_Pa"] * 3 - row["stress_zz_Pa"]) < 1e-12
    mean = json_of("fields", "stack.dump", "--profile", "z", "--slices", 1300, "--width", 0.6, *LISTS,
                   "--frame", "all", "--average")
    assert mean[600]["frames"] == 2 and mean[600]["stress_zz_Pa"] == profile[600]["stress_zz_Pa"]
    each = json_of("fields", "stack.dump", "--at", 0.1, 0.2, 3, 1, 1, 1, "--frame", "all", "--dt", 0.5)
    assert [row["time_s"] for row in each] == [0, 0, 5, 5] and "stress_zz_Pa" not in each[0]
    post("fields", "stack.dump", "--grid", 6, 4, 13, "--vti", "stack_*.vti", "--quiet")
    with open("stack_0000000010.vti", encoding="ascii") as file:
        text = file.read()
    assert 'WholeExtent="0 5 0 3 0 12"' in text and 'Name="density_kg_per_m3"' in text
    grid = rows_of("fields", "stack.dump", "--grid", 12, 8, 52, "--kernel", "lucy", "--width", 0.8)
    total = sum(float(row["density_kg_per_m3"]) for row in grid) * (3 * 2 * 13) / (12 * 8 * 52)
    assert abs(total / (0.2 * count) - 1) < 1e-3, total
    rings = json_of("fields", "stack.dump", "--profile", "radius", "--cylinder", 0.1, 0.2, 1, 2, 6,
                    "--slices", 4, *LISTS)
    assert all(row["stress_rr_Pa"] == 0 and row["stress_zz_Pa"] >= 0 for row in rings)
    for words, arguments in (
            ("--grid nx ny nz", ("stack.dump",)), ("--vti needs --grid", ("stack.dump", "--at", 0, 0, 0,
                                                                        "--vti", "x.vti")),
            ("three numbers", ("stack.dump", "--at", 0, 0)),
            ("needs --cylinder", ("stack.dump", "--profile", "radius")),
            ("--force-on-second", ("stack.dump", "--at", 0, 0, 0, *LISTS, "--force-on-second")),
            ("x0 < x1", ("stack.dump", "--profile", "z", "--box", 1, 0, 0, 1, 0, 1))):
        _, error = post("fields", *arguments, expect=1)
        assert words in error and error.count("\n") == 1, (words, error)
    post("fields", "stack.dump", "--contacts", "pairs.local", "--at", 0, 0, 0, expect=2)
    light = [dict(row, mass=0.0) for row in rows]
    _, error = post("fields", write("light.dump", frame(0, light, box)), "--at", 0, 0, 0, expect=1)
    assert "--density" in error
    (heavy,) = json_of("fields", "light.dump", "--at", 0.1, 0.2, 3, "--density", 3)
    assert abs(heavy["density_kg_per_m3"] - 3 * heavy["solid_fraction"]) < 1e-12


def lattice(n, cell, semiaxes, kinds=lambda i, j, k: 1):
    rows = []
    for k in range(n):
        for j in range(n):
            for i in range(n):
                row = ball(len(rows) + 1, cell[0] * (i + 0.5), cell[1] * (j + 0.5), cell[2] * (k + 0.5),
                           kind=kinds(i, j, k))
                row.update(zip(("shapex", "shapey", "shapez"), semiaxes))
                rows.append(row)
    return rows, tuple(v for k in range(3) for v in (0, n * cell[k]))


def check_voronoi():
    cell, semiaxes = (0.7, 0.4, 0.5), (0.3, 0.15, 0.2)
    rows, box = lattice(3, cell, semiaxes)
    name = write("lattice.dump", frame(3, rows, box, "pp pp pp"))
    expected = 4 / 3 * math.pi * math.prod(semiaxes) / math.prod(cell)
    (row,) = json_of("voronoi", name, "--per-particle", "cells_*.dump")
    assert abs(row["packing_fraction"] / expected - 1) < 1e-9 and row["inner_cells"] == 27
    assert abs(row["cell_volume_sum_m3"] / (27 * math.prod(cell)) - 1) < 1e-9
    assert abs(row["local_packing_fraction_mean"] / expected - 1) < 1e-3, row
    post("voronoi", name, "--per-particle", "cells.csv", "--quiet")
    with open("cells.csv", encoding="ascii") as file:
        each = list(csv.DictReader(file))
    assert len(each) == 27 and all(abs(float(r["packing_fraction"]) - expected) < 1e-3 for r in each)
    post("render3d", "cells_0000000003.dump", "--colour", "packing_fraction", "-o", "cells.svg")
    _, error = post("voronoi", name, "--per-particle", "cells.txt", expect=1)
    assert ".csv or .dump" in error
    _, error = post("voronoi", write("two.dump", frame(3, rows, box, "pp pp pp") +
                                     frame(4, rows, box, "pp pp pp")), "--frame", "all",
                    "--per-particle", "one.csv", expect=1)
    assert "asterisk" in error and error.count("\n") == 1, error
    open_box = write("open.dump", frame(3, rows, box, "pp pp ff"))
    (row,) = json_of("voronoi", open_box)
    assert row["inner_cells"] == 9
    (row,) = json_of("voronoi", open_box, "--box", 0, 1, 0, 1, -1, 2.5)
    assert abs(row["cell_volume_sum_m3"] / (2.1 * 1.2 * 3.5) - 1) < 1e-9
    _, error = post("voronoi", open_box, "--box", 0, 1, 0, 1, 0.6, 1, expect=1)
    assert "outside the box" in error and error.count("\n") == 1


def check_mixing():
    rows, box = lattice(12, (1, 1, 1), (0.4, 0.4, 0.4), lambda i, j, k: 1 if k < 3 else 2)
    shuffled = [dict(row) for row in rows]
    kinds = [row["type"] for row in rows]
    random.Random(5).shuffle(kinds)
    for row, kind in zip(shuffled, kinds):
        row["type"] = kind
    name = write("mix.dump", frame(0, rows, box, "pp pp pp") + frame(1, shuffled, box, "pp pp pp"))
    apart, mixed = json_of("mixing", name, "--frame", "all", "--type", 1, "--cell", 3)
    assert abs(apart["lacey_index"]) < 1e-12 and abs(apart["gmmi_z"] - 1 / 5.5) < 1e-12, apart
    assert abs(mixed["lacey_index"] - 1) < 4 * mixed["lacey_index_standard_error"]
    assert abs(mixed["neighbour_index"] - 1) < 4 * mixed["neighbour_index_standard_error"]
    assert abs(mixed["gmmi"] - 1) < 4 * mixed["gmmi_standard_error"]
    scan = json_of("mixing", name, "--type", 1, "--cell", 2, 3, 4)
    assert [row["cell_m"] for row in scan] == [2, 3, 4] and scan[0]["cells"] == 216
    traced = json_of("mixing", name, "--frame", "all", "--region", 0, 12, 0, 12, 0, 3, "--cell", 3)
    assert [row["tracer"] for row in traced] == ["region"] * 2
    assert abs(traced[1]["lacey_index"]) < 1e-12  # the particles stay where they are
    _, error = post("mixing", name, "--size", expect=1)
    assert "alike" in error and error.count("\n") == 1
    post("mixing", name, expect=2)
    post("mixing", name, "--type", 1, "--size", expect=2)
    post("plot", "curve", write("m.csv", post("mixing", name, "--frame", "all", "--type", 1, "--csv", "-",
                                              "--cell", 3)[0]),
         "--x", "timestep", "--y", "lacey_index,gmmi", "-o", "mixing.svg")
    with open("mixing.svg", encoding="utf8") as file:
        text = file.read()
    assert ">lacey index<" in text and ">gmmi<" in text and ">timestep<" in text
    (summary,) = json_of("summary", "m.csv", "--quantity", "lacey_index", "--group", "tracer")
    assert abs(summary["lacey_index_mean"] - 0.5 * mixed["lacey_index"]) < 1e-9


def stl(triangles, scale=1):
    """An STL file's text; x and y of the corners are multiplied."""
    lines = ["solid s"]
    for triangle in triangles:
        lines += ["facet normal 0 0 1", "outer loop"]
        lines += [f"vertex {scale * x!r} {scale * y!r} {z!r}" for x, y, z in triangle]
        lines += ["endloop", "endfacet"]
    return "\n".join(lines + ["endsolid s"]) + "\n"


def check_coordination():
    rows, r = [], math.sqrt(0.125) * 1.0001  # face-centred cubic, spheres that just overlap
    for i in range(6):
        for j in range(6):
            for k in range(6):
                if (i + j + k) % 2 == 0:
                    rows.append(ball(len(rows) + 1, 0.5 * i, 0.5 * j, 0.5 * k, r=r, kind=1 + k % 2))
    name = write("fcc.dump", frame(0, rows, (0, 3, 0, 3, 0, 3), "pp pp pp"))
    (row,) = json_of("coordination", name, "--per-particle", "z.csv")
    assert row["zpp"] == 12 and row["zss"] == 12 and row["rattlers"] == 0, row
    assert row["particles_with_12_contacts"] == len(rows) == 108
    assert row["z_type_1_with_1"] == 4 and row["z_type_1_with_2"] == 8  # within a layer, beside it
    assert abs(row["mean_overlap_b"] - 2e-4 / 1.0001) < 1e-9
    with open("z.csv", encoding="ascii") as file:
        assert all(float(r["partners"]) == 12 and float(r["is_rattler"]) == 0
                   for r in csv.DictReader(file))
    open_z = write("fcc_open.dump", frame(0, rows, (0, 3, 0, 3, 0, 3), "pp pp ff"))
    (row,) = json_of("coordination", open_z, "--plane-wall", 0, 0, -r, 0, 0, 1, "--with-walls")
    assert row["wall_contacts"] == 18 and row["contacts"] == 108 * 6 - 18 * 4
    (row,) = json_of("coordination", open_z, "--box-wall", -9, 9, -9, 9, -r * 0.999999, 9)
    assert row["wall_contacts"] == 18
    wide = 2.5 + 0.999 * r
    (row,) = json_of("coordination", open_z, "--cylinder-wall", 0, 0, 0, 0, 0, 2, wide)
    near = sum(abs(math.hypot(q["x"], q["y"]) - wide) <= r for q in rows)
    assert row["wall_contacts"] == near > 0, (row["wall_contacts"], near)
    corners = ((-9, -9), (9, -9), (9, 9), (-9, 9))
    write("floor.stl", stl([[(*corners[k], -1e3 * r * 0.999999) for k in face]
                            for face in ((0, 1, 2), (0, 2, 3))], 1e3))
    (row,) = json_of("coordination", open_z, "--mesh-wall", "floor.stl", "--mesh-scale", 1e-3)
    assert row["wall_contacts"] == 18
    _, error = post("coordination", open_z, "--plane-wall", 0, 0, 1, expect=1)
    assert "6 numbers" in error and error.count("\n") == 1
    flat = write("flat.dump", frame(0, [q for q in rows if q["z"] == 0], (0, 3, 0, 3, 0, 3), "pp pp ff"))
    (row,) = json_of("coordination", flat, "--space")
    assert row["zpp"] == 4


def check_orientation():
    half = math.sqrt(0.5)
    rows = []
    for kind, (shape, turn) in enumerate((((3, 1, 1), (1, 0, 0, 0)), ((1, 3, 1), (half, 0, 0, -half)),
                                          ((1, 1, 3), (half, 0, half, 0)), ((2, 2, 0.5), (1, 0, 0, 0)),
                                          ((1, 1, 1), (1, 0, 0, 0))), start=1):
        row = ball(kind, 10 * kind, 0, 0, kind=kind)
        row.update(zip(("shapex", "shapey", "shapez", "quat1", "quat2", "quat3", "quat4"),
                       shape + turn))
        rows.append(row)
    name = write("kinds.dump", frame(0, rows, (0, 60, -5, 5, -5, 5)))
    table = json_of("orientation", name)
    assert [(r["type"], r["axis"]) for r in table] == [
        ("all", "longest"), ("all", "shortest"), ("1", "longest"), ("2", "longest"),
        ("3", "longest"), ("4", "shortest"), ("5", None)]
    assert table[0]["particles"] == 3 and table[0]["spheres"] == 1
    assert abs(table[0]["nematic_order"] - 1) < 1e-9 and abs(abs(table[0]["director_x"]) - 1) < 1e-9
    assert abs(abs(table[1]["director_z"]) - 1) < 1e-9 and abs(table[0]["flow_angle_deg"]) < 1e-6
    (yx,) = [r for r in json_of("orientation", name, "--plane", "yx") if r["type"] == "1"]
    assert abs(yx["flow_angle_deg"] - 90) < 1e-6
    (balls,) = json_of("orientation", write("balls.dump", frame(0, rows[4:], (0, 60, -5, 5, -5, 5))))
    assert balls["spheres"] == 1 and balls["particles"] == 0 and "nematic_order" not in balls


def check_pairs():
    rows, box = lattice(6, (1, 1, 1), (0.45, 0.45, 0.45))
    name = write("cubic.dump", frame(0, rows, box, "pp pp pp"))
    gaps = json_of("pairs", name, "--gap", 0.2, "--bins", 4)
    assert [round(row["neighbours"], 9) for row in gaps] == [0, 0, 6, 6] or \
        [round(row["neighbours"], 9) for row in gaps] == [0, 6, 6, 6], gaps
    table = json_of("pairs", name, "--farthest", 1.2, "--bins", 12)
    shell = 4 / 3 * math.pi * (1.1 ** 3 - 1.0 ** 3)
    near = sum(row["g"] * 4 / 3 * math.pi * ((row["distance_m"] + 0.05) ** 3 -
                                             (row["distance_m"] - 0.05) ** 3) for row in table)
    assert shell > 0 and abs(near * 215 / 216 - 6) < 1e-9 and table[0]["g2"] is None
    peaks = json_of("pairs", name, "--structure", 7, "--bins", 70)
    assert abs(sum(r["structure_factor"] * r["wave_vectors"] for r in peaks) - 6 * 216) < 1e-6
    _, error = post("pairs", name, "--farthest", 5, expect=1)
    assert "at most 3" in error
    post("plot", "curve", write("g.csv", post("pairs", name, "--csv", "-")[0]), "--x", "distance_m", "--y",
         "g", "-o", "g.png")


def check_trajectory():
    text = ""
    for n in range(5):
        row = ball(1, (0.9 + 0.3 * n) % 1, 0.5, 0.5, r=0.1)
        text += frame(10 * n, [row], (0, 1, 0, 1, 0, 1), "pp pp pp")
    name = write("flight.dump", text)
    table = json_of("trajectory", name, "--dt", 0.01, "--origins", 5)
    assert [row["lag_frames"] for row in table] == [0, 1, 2, 3, 4]
    assert [row["pairs"] for row in table] == [5, 4, 3, 2, 1]
    for row in table:
        way = 0.3 * row["lag_frames"]
        assert abs(row["msd_m2"] - way ** 2) < 1e-12 and abs(row["displacement_x_m"] - way) < 1e-12
        assert abs(row["lag_s"] - 0.1 * row["lag_frames"]) < 1e-12
    post("trajectory", name, "--per-particle", "ways_*.csv", "--quiet")
    with open("ways_0000000040.csv", encoding="ascii") as file:
        (row,) = csv.DictReader(file)
    assert abs(float(row["way_x_m"]) - 1.2) < 1e-12


def check_collisions():
    text = ""
    for n in range(6):  # two balls meet at n = 2 and 3, with 2 x 0.5 m/s
        x = abs(2.5 - n) * 0.05 + 0.05
        pair = [ball(1, -x, 0, 0, r=0.1), ball(2, x, 0, 0, r=0.1)]
        for row, sign in zip(pair, (1, -1)):
            row["vx"] = sign * (0.5 if n < 3 else -0.5)
        text += frame(10 * n, pair, (-1, 1, -1, 1, -1, 1), "ff ff ff")
    name = write("meet.dump", text)
    (row,) = json_of("trajectory", name, "--collisions", "--dt", 0.01)
    assert abs(row["begin_s"] - 0.15) < 1e-12 and abs(row["duration_s"] - 0.2) < 1e-12, row
    assert abs(row["normal_speed_m_per_s"] - 1) < 1e-12
    assert abs(row["departure_speed_m_per_s"] - 1) < 1e-12
    assert abs(row["largest_overlap_m"] - 0.05) < 1e-12
    _, error = post("trajectory", name, "--collisions", expect=1)
    assert "--dt" in error


def check_flow():
    text = "".join(frame(10 * n, [ball(1, 0, 0, 1 - 0.2 * n, mass=2), ball(2, 3, 0, 1 - 0.2 * n)],
                         (-5, 5, -5, 5, -5, 5), "ff ff ff") for n in range(11))
    name = write("falls.dump", text)
    rows = rows_of("flow", name, "--through", 0, 0, 0.01, 0, 0, -1, "--dt", 0.01)
    assert len(rows) == 10 and [int(r["forward"]) for r in rows].index(2) == 4, rows
    assert abs(sum(float(r["mass_by_volume_share_kg"]) for r in rows) - 2.2) < 1e-12
    assert abs(float(rows[-1]["mass_so_far_kg"]) - 2.2) < 1e-12
    (total,) = json_of("flow", name, "--disc", 0, 0, 0.01, 0, 0, -1, 1, "--dt", 0.01, "--total")
    assert total["forward"] == 1 and abs(total["rate_kg_per_s"] - 2) < 1e-12
    assert abs(total["rate_standard_deviation_kg_per_s"] - math.sqrt((18 ** 2 + 9 * 4) / 9)) < 1e-9
    down = write("down.stl", stl([[(-1, -1, 0.01), (0, 1, 0.01), (1, -1, 0.01)]]))
    (total,) = json_of("flow", name, "--face", down, "--dt", 0.01, "--total")
    assert total["forward"] == 1 and total["mass_forward_kg"] == 2
    assert total["mass_by_volume_share_kg"] is None
    _, error = post("flow", name, "--through", 0, 0, 0, 0, 0, 0, expect=1)
    assert "length 0" in error
    post("flow", name, expect=2)


def check_map():
    rows = [{"x": i, "y": j, "v": i * j} for i in range(4) for j in range(3)]
    write("map.csv", "x,y,v\n" + "".join(f"{r['x']},{r['y']},{r['v']}\n" for r in rows))
    post("plot", "map", "map.csv", "--x", "x", "--y", "y", "--value", "v", "-o", "map.svg")
    with open("map.svg", encoding="utf8") as file:
        assert file.read().count("<p") > 12
    pile = write("pile.dump", frame_text(1, wedge()))
    post("report", pile, "-o", "r.html", "--curve", "map.csv", "x", "v", "map.csv", "y", "v", "--map",
         "map.csv", "x", "y", "v")
    with open("r.html", encoding="utf8") as file:
        text = file.read()
    assert "<h2>Measures</h2>" in text and "v over x: map.csv" in text and "v: map.csv" in text
    _, error = post("report", pile, "-o", "none.html", "--curve", "map.csv", "x", expect=1)
    assert "3 words" in error and not os.path.exists("none.html"), error
    for words, arguments in (("--x and --y", ("curve", "map.csv")), ("--value", ("map", "map.csv", "--x", "x",
                                                                               "--y", "y")),
                             ('"w"', ("curve", "map.csv", "--x", "x", "--y", "w"))):
        _, error = post("plot", *arguments, "-o", "no.svg", expect=1)
        assert words in error and not os.path.exists("no.svg"), error


check_fields()
check_voronoi()
check_mixing()
check_coordination()
check_orientation()
check_pairs()
check_trajectory()
check_collisions()
check_flow()
check_map()
