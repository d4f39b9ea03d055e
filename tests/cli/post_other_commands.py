# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""Templates, measures in space, ParaView files, VTK input: what the commands print and write."""
import math
import os

from _synthetic import (A, B, COLUMNS, frame_text, json_of, particle, post, rows_of, wedge, write)


def check_template():
    # independent computation, a = 2.7, b = 1.15
    reference = {7: None, 13: (0.9908, 0.9837, 1.0022), 17: (0.9948, 0.9908, 1.0012)}
    rows = rows_of("template", "--aspect", 2.7 / 1.15, "--subspheres", "7,13,17")
    for row in rows:
        expected = reference[int(row["subspheres"])]
        if expected:
            found = [float(row[k]) for k in ("area_ratio", "volume_ratio", "perimeter_ratio")]
            assert all(abs(f - e) < 5.1e-5 for f, e in zip(found, expected)), (found, expected)
    (row,) = rows_of("template", "--aspect", "2.35", "--tolerance", "0.01")
    assert row["subspheres"] == "13"
    post("template", "--b", "1.15", "--aspect", 2.7 / 1.15, "--subspheres", 7, "--multisphere",
         "ms.txt", "--molecule", "ms.mol", "--spheres", "ms.csv", "--vtp", "ms.vtp", "--stl",
         "ms.stl", "--quiet")
    with open("ms.txt", encoding="ascii") as file:
        spheres = [[float(word) for word in line.split()] for line in file]
    for (x, y, z, r), (xe, re) in zip(spheres[3:], ((0, 1.15), (0.7974, 1.0870), (1.5592, 0.8853),
                                                    (2.2102, 0.4898))):
        assert abs(x - xe) < 5.1e-5 and abs(r - re) < 5.1e-5 and y == z == 0
    with open("ms.stl", encoding="ascii") as file:
        assert file.read().count("endfacet") > 1000
    with open("ms.mol", encoding="ascii") as file:
        assert "7 atoms" in file.read()
    with open("ms.mol", encoding="ascii") as file:
        assert "mass" not in file.read()
    rows = rows_of("template", "--aspect", "2.35,5", "--tolerance", "0.01")
    assert [row["subspheres"] for row in rows] == ["13", "29"]  # one for each aspect ratio
    (row,) = rows_of("template", "--aspect", "2.35", "--tolerance", "0.01", "--measure", "volume")
    assert row["subspheres"] == "17"
    (row,) = rows_of("template", "--aspect", "2.35", "--tolerance", "0.01", "--measure", "outline",
                     "--spacing", "minimax")
    assert row["subspheres"] == "13"
    molecule, _ = post("template", "--b", "1.15", "--aspect", 2.7 / 1.15, "--subspheres", 7, "--mass",
                       "5", "--molecule", "-")
    header = molecule.split("Coords")[0].splitlines()
    moments = [float(word) for word in header[5].split()[:6]]
    assert header[2:5] == ["7 atoms", "5 mass", "0 0 0 com"] and header[5].endswith(" inertia")
    for found, expected in zip(moments, (2 * 1.15 ** 2, 1.15 ** 2 + 2.7 ** 2, 1.15 ** 2 + 2.7 ** 2, 0, 0, 0)):
        assert abs(found - expected) < 1e-12, moments
    _, error = post("template", "--aspect", "2,3", "--subspheres", "13", "--stl", "x.stl", expect=2)
    assert "one --aspect" in error and not os.path.exists("x.stl")
    _, error = post("template", "--spacing", "even", expect=2)
    assert "minimax" in error
    _, error = post("template", "--subspheres", "4", expect=1)
    assert "4" in error
    _, error = post("template", "--aspect", "10", "--subspheres", "5", expect=1)
    assert error.count("\n") == 2, error  # which one cannot be built and why; that none is left


def png_size(name):
    with open(name, "rb") as file:
        head = file.read(24)
    return int.from_bytes(head[16:20], "big"), int.from_bytes(head[20:24], "big")


def lattice_in_space(count):
    rows = []
    for i in range(count):
        for j in range(count):
            for k in range(count):
                row = particle(len(rows) + 1, A * (2 * i + 1), B * (2 * j + 1))
                row["z"] = B * (2 * k + 1)
                rows.append(row)
    return rows


def cone(degrees, height):
    """Balls in square layers, each in the hollows of the one below, under a cone about z."""
    rows, step = [], 1.9999 * B
    slope = math.tan(math.radians(degrees))
    reach = round(height / slope / step) + 1
    for k in range(round(height / step * math.sqrt(2))):
        z, shift = B + k * step / math.sqrt(2), 0.5 * (k % 2)
        for i in range(-reach, reach + 1):
            for j in range(-reach, reach + 1):
                x, y = (i + shift) * step, (j + shift) * step
                if z < height - slope * math.hypot(x, y):
                    rows.append(particle(len(rows) + 1, x, y, a=B))
                    rows[-1]["z"] = z
    return rows


def check_space():
    name = write("bed.dump", frame_text(5, lattice_in_space(6)))
    (bed,) = json_of("bed", name, "--box", 0, 12 * A, 0, 12 * B, 0, 12 * B, "--planes", 600)
    assert abs(bed["porosity"] - (1 - math.pi / 6)) <= bed["porosity_error"] + 1e-9, bed
    layers = rows_of("bed", name, "--box", 0, 12 * A, 0, 12 * B, 0, 12 * B, "--profile", "height",
                     "--slices", 6)
    assert len(layers) == 6
    assert all(abs(float(row["porosity"]) - (1 - math.pi / 6)) < 1e-3 for row in layers)
    box = ("--box", 0, 12 * A, 0, 12 * B, 0, 12 * B)
    (low,) = json_of("bed", name, *box[:-1], 24 * B, "--below-surface", "--columns", 0.05)
    # 11 semi-axes below the middles of the highest layer, half an ellipsoid above, pi/4 of the plan
    total = math.pi * A * B * 36 * (11 * B + 2 * B / 3)
    assert abs(low["total_volume_m3"] / total - 1) < 2e-3, (low, total)
    _, error = post("bed", name, "--box", 0, 12 * A, 0, 12 * B, 13 * B, 14 * B, "--below-surface",
                    expect=1)
    assert "no volume below the free surface" in error
    _, error = post("bed", name, expect=1)
    assert "--box" in error
    (order,) = json_of("orientation", name)
    assert abs(order["nematic_order"] - 1) < 1e-12 and order["rose_0_to_10_deg"] == 1
    (fabric,) = json_of("contacts", name, "--contact-gap", 0.001)
    assert fabric["contacts"] == 3 * 6 * 6 * 5 and abs(fabric["fabric_1"] - 1 / 3) < 1e-3
    (energy,) = json_of("energy", name, "--gravity", 0, 0, -10)
    heights = sum(row["z"] for row in lattice_in_space(6))
    assert abs(energy["potential_J"] - 2e-5 * 10 * heights) < 1e-15
    assert energy["is_at_rest"] is True
    (moving,) = json_of("energy", write("moving.dump", frame_text(6, [particle(1, 0, 0, speed=2)])))
    assert abs(moving["translation_J"] - 4e-5) < 1e-18 and moving["is_at_rest"] is False
    post("render3d", name, "-o", "bed.png", "--width", 200, "--height", 150, "--colour", "id")
    with open("bed.png", "rb") as file:
        assert file.read(8) == b"\x89PNG\r\n\x1a\n"
    post("render3d", name, "-o", "bed.jpg", expect=2)
    post("render3d", name, "-o", "film_*.svg", "--colour", "id", "--colour-range", 0, 500, "--title",
         "A lattice")
    with open("film_0000000005.svg", encoding="utf8") as file:
        text = file.read()
    assert text.count("<image ") == 1 and "data:image/png;base64" in text
    for words in "A lattice", ">0<", ">500<", ">id<", " mm<":
        assert words in text, words
    post("render3d", name, "-o", "bare.png", "--bare", "--width", 200, "--height", 150)
    assert png_size("bare.png") == png_size("bed.png") == (200, 150)
    _, error = post("render3d", name, "-o", "x.svg", "--bare", expect=1)
    assert ".png" in error
    _, error = post("render3d", name, "-o", "x.png", "--view", 0, 1, 0, 1, 1, 0, expect=1)
    assert "lower bound first" in error
    _, error = post("render3d", name, "-o", "x.png", "--width", 1600, "--height", 100, expect=1)
    assert "--height" in error
    for command in ("pile", "repose", "porosity", "render"):
        more = ("-o", "bed.svg") if command == "render" else ("--no-wall",)
        fit = ("--cut-top", 0, "--cut-bottom", 0) if command != "porosity" else ()
        done = post(command, "bed.dump", *more, *fit, expect=None)
        assert "out of the plane" in done[1] and "`bed`" in done[1], (command, done)
    (heap,) = json_of("heap", write("cone.dump", frame_text(7, cone(25, 0.03))), "--sectors", 6)
    # steps of 1.4 B over its 0.03 m of height
    assert abs(heap["repose_angle_deg"] - 25) < 1.5, heap
    assert abs(heap["axis_x_m"]) < B and heap["strays"] == 0
    assert "flat on top" not in post("heap", "cone.dump", "--sectors", 6)[1]
    # the same cone cut off at a fifth of its height: its edge only has an angle
    low = [row for row in cone(25, 0.03) if row["z"] < 0.006]
    _, error = post("heap", write("disc.dump", frame_text(7, low)), "--sectors", 6)
    assert error.count("\n") == 1 and "flat on top" in error and "in a cone over 75 %" in error, error
    _, error = post("heap", write("one.dump", frame_text(7, [particle(1, 0, 0)])), expect=1)
    assert "rings" in error
    for up in "y", "z":
        _, error = post("heap", write("plane.dump", frame_text(7, wedge())), "--up", up, expect=1)
        assert "in one plane" in error and "`repose`" in error, error


def check_contact_list():
    rows = [{"c_c[1]": 1.0, "c_c[2]": 0.0, "c_c[3]": 0.0, "c_c[4]": f} for f in (1.0, 1.0, 1.0, 5.0)]
    text = frame_text(7, rows, list(rows[0])).replace("ATOMS", "ENTRIES")
    (forces,) = json_of("contacts", write("contacts.local", text), "--local", "--normal-columns",
                        "c_c[1]", "c_c[2]", "c_c[3]", "--force-columns", "c_c[4]", "c_c[2]",
                        "c_c[3]")
    assert forces["mean_force_N"] == 2 and forces["fabric_1"] == 1
    assert forces["strong_load_share"] == 0.625
    post("contacts", "contacts.local", "--local", expect=1)


def vtk_text(rows):
    """As the host's dump custom/vtk writes it, ASCII, double precision."""
    def vectors(name, keys):
        return [f"{name} 3 {len(rows)} double"] + [
            " ".join(repr(float(row[k])) for k in keys) for row in rows]
    lines = ["# vtk DataFile Version 2.0", "Generated by LIGGGHTS", "ASCII", "DATASET POLYDATA",
             f"POINTS {len(rows)} double"]
    lines += [" ".join(repr(float(row[k])) for k in "xyz") for row in rows]
    lines += [f"VERTICES {len(rows)} {2 * len(rows)}"] + [f"1 {k}" for k in range(len(rows))]
    names = ("id", "type", "mass", "shapex", "shapey", "shapez", "f_subspheres")
    lines += [f"POINT_DATA {len(rows)}", f"FIELD FieldData {len(names) + 3}"]
    for name in names:
        lines += [f"{name} 1 {len(rows)} double"] + [repr(float(row[name])) for row in rows]
    lines += vectors("v", ("vx", "vy", "vz")) + vectors("omega", ("omegax", "omegay", "omegaz"))
    lines += [f"TENSOR 9 {len(rows)} double"]
    for row in rows:
        c, s = row["quat1"] ** 2 - row["quat4"] ** 2, 2 * row["quat1"] * row["quat4"]
        lines.append(f"{c!r} {-s!r} 0 {s!r} {c!r} 0 0 0 1")
    return "\n".join(lines) + "\n"


def check_vtk():
    rows = [particle(k + 1, A + 0.005 * k, 2 * B, 0.3 * k - 2, 7 * (k % 2)) for k in range(15)]
    name = write("pile_100.vtk", vtk_text(rows))
    if os.environ["ELLIPSOID_VTK"] != "1":
        _, error = post("pile", name, expect=1)
        assert "ELLIPSOID_VTK" in error
        return
    options = ("--no-wall", "--cluster-gap", 5)
    (vtk,) = rows_of("porosity", name, *options)
    (text,) = rows_of("porosity", write("pile_100.dump", frame_text(100, rows, COLUMNS)), *options)
    assert vtk["timestep"] == "100" and vtk["particles"] == text["particles"]
    for key in ("porosity", "total_area_m2", "solid_area_m2"):
        # the rotation matrix was written instead of the quaternion: rounding differs
        assert abs(float(vtk[key]) / float(text[key]) - 1) < 1e-12, key
    for broken in ("", "rubbish\n", vtk_text(rows)[:900], vtk_text(rows).replace("0.01", "nan", 1)):
        out, error = post("pile", write("broken_1.vtk", broken), expect=1)
        assert out == "" and "broken_1.vtk" in error and error.count("\n") == 1, (out, error)
    post("paraview", write("wedge.dump", frame_text(3, wedge())), "-o", "surfaces")
    # our own surface file can be read back by VTK: as many points as 16 x 11 + 2 per particle
    (surface,) = rows_of("orientation", "surfaces_3.vtp", "--semiaxes", 1, 1, 1)
    assert surface["timestep"] == "3"
    (energy,) = json_of("contacts", "surfaces_3.vtp", "--semiaxes", 1e-9, 1e-9, 1e-9)
    assert energy["timestep"] == 3
    with open("surfaces.pvd", encoding="ascii") as file:
        assert 'file="surfaces_3.vtp"' in file.read()
    _, error = post("paraview", "missing.dump", "-o", "nothing", expect=1)
    assert "missing.dump" in error and not os.path.exists("nothing.pvd"), error


check_template()
check_space()
check_contact_list()
check_vtk()
