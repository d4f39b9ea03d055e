# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""Files of other programs, boxes that repeat, bodies of spheres: right values, or a refusal that names
the option that decides. Expected values are closed forms or numpy's brute force over all images."""
import bz2
import gzip
import itertools
import lzma
import math
import os
import subprocess
import threading

import numpy as np

from _synthetic import POST, frame_text, json_of, particle, post, rows_of, wedge, write

ELLIPSOIDS = "id type x y z quat1 quat2 quat3 quat4 shapex shapey shapez"


def dump(name, columns, rows, box=("ff ff ff", "0 1", "0 1", "0 1"), step=0):
    lines = ["ITEM: TIMESTEP", str(step), "ITEM: NUMBER OF ATOMS", str(len(rows)),
             "ITEM: BOX BOUNDS " + box[0], *box[1:], "ITEM: ATOMS " + columns]
    return write(name, "\n".join(lines + [" ".join(map(str, row)) for row in rows]) + "\n")


def contacts(*arguments):
    return json_of("contacts", *arguments)[0]["contacts"]


def refused(*arguments, words):
    out, error = post(*arguments, expect=1)
    assert out == "" and error.startswith("error: ") and error.count("\n") == 1, (out, error)
    assert all(word in error for word in words), (error, words)


def pairs_by_brute_force(centres, radii, edges, repeats):
    """Touching pairs of spheres over all images, each once."""
    count = 0
    reach = [range(-2, 3) if r else (0,) for r in repeats]
    for shift in itertools.product(*reach):
        d = centres[None, :, :] + np.array(shift) @ edges - centres[:, None, :]
        touch = np.sqrt((d ** 2).sum(axis=2)) <= radii[None, :] + radii[:, None]
        if shift == (0, 0, 0):
            np.fill_diagonal(touch, False)
        count += int(touch.sum())
    return count // 2


def check_periodic_boxes():
    random = np.random.default_rng(3)
    centres, radii = random.uniform(0, 1, (120, 3)), random.uniform(0.02, 0.12, 120)
    tilted = np.array([[1.0, 0, 0], [0.35, 0.9, 0], [-0.2, 0.4, 1.1]])
    straight = np.diag([1.0, 0.9, 1.1])
    for repeats in (True, True, True), (True, False, True), (False, False, True):
        words = " ".join("pp" if r else "ff" for r in repeats)
        rows = [(k + 1, 1, *map(repr, map(float, c)), repr(float(r)))
                for k, (c, r) in enumerate(zip(centres, radii))]
        # fractions: centres are shares of the edges; the rectangle around: -0.2 to 1.35, 0 to 1.3
        box = (f"xy xz yz {words}", "-0.2 1.35 0.35", "0 1.3 -0.2", "0 1.1 0.4")
        name = dump("tilted.dump", "id type xs ys zs radius", rows, box)
        expected = pairs_by_brute_force(centres @ tilted, radii, tilted, repeats)
        assert contacts(name) == expected, (contacts(name), expected)
        rows = [(k + 1, 1, *map(repr, map(float, c @ straight)), repr(float(r)))
                for k, (c, r) in enumerate(zip(centres, radii))]
        box = (words, "0 1", "0 0.9", "0 1.1")
        name = dump("straight.dump", "id type x y z radius", rows, box)
        expected = pairs_by_brute_force(centres @ straight, radii, straight, repeats)
        assert contacts(name) == expected
        alone = pairs_by_brute_force(centres @ straight, radii, straight, (False,) * 3)
        assert contacts(name, "--periodic", "none") == alone != expected
    # a particle is no partner of its own images
    thin = dump("thin.dump", "id type x y z radius", [(1, 1, 0.5, 0.5, 0.1, 0.2), (2, 1, 0.5, 0.85, 0.1, 0.2)],
                ("pp pp pp", "0 1", "0 1", "0 0.38"))
    images = pairs_by_brute_force(np.array([[0.5, 0.5, 0.1], [0.5, 0.85, 0.1]]), np.array([0.2, 0.2]),
                                  np.diag([1.0, 1.0, 0.38]), (True,) * 3)
    assert contacts(thin) == 1 and images == 3 and "own images" in post("contacts", thin)[1]
    general = ("abc origin pp pp pp", "1 0 0 0.5", "0.35 0.9 0 -1", "-0.2 0.4 1.1 0.25")
    rows = [(k + 1, 1, *map(repr, map(float, c)), repr(float(r)))
            for k, (c, r) in enumerate(zip(centres, radii))]
    expected = pairs_by_brute_force(centres @ tilted, radii, tilted, (True,) * 3)
    assert contacts(dump("general.dump", "id type xs ys zs radius", rows, general)) == expected
    # a body across the face x = 0 of the cell: all of it is in the cell
    ball = 4 / 3 * math.pi * 0.2 ** 3
    name = dump("face.dump", "id type x y z radius", [(1, 1, 0.05, 0.5, 0.5, 0.2)],
                ("pp pp pp", "0 1", "0 1", "0 1"))
    (bed,) = json_of("bed", name, "--box", 0, 1, 0, 1, 0, 1, "--planes", 4000)
    assert abs(bed["solid_volume_m3"] / ball - 1) < 1e-6, bed
    (half,) = json_of("bed", name, "--box", 0.5, 1, 0, 1, 0, 1, "--planes", 4000)
    cap = math.pi * 0.15 ** 2 * (3 * 0.2 - 0.15) / 3
    assert abs(half["solid_volume_m3"] / cap - 1) < 1e-6, half
    refused("pile", name, words=("repeats along x", "--periodic none"))
    refused("heap", name, words=("repeats along x", "--periodic none"))


def lens(r1, r2, d):
    return math.pi * (r1 + r2 - d) ** 2 * (d * d + 2 * d * (r1 + r2) - 3 * (r1 - r2) ** 2) / (12 * d)


def check_nested_sections():
    """Volume of three overlapping spheres in a row, whatever their tilt: from 1 degree on sections of
    one lie wholly inside those of another."""
    radii, places = (0.5, 1.0, 0.6), (-0.8, 0.0, 0.9)
    volume = sum(4 / 3 * math.pi * r ** 3 for r in radii) - lens(0.5, 1.0, 0.8) - lens(1.0, 0.6, 0.9)
    for tilt in 0, 1, 20, 60, 89, 90:
        s, c = math.sin(math.radians(tilt)), math.cos(math.radians(tilt))
        rows = [(k + 1, 1, s * x, 0.0, c * x, r) for k, (x, r) in enumerate(zip(places, radii))]
        name = dump("row.dump", "id id_multisphere x y z radius", rows)
        (bed,) = json_of("bed", name, "--box", -3, 3, -3, 3, -3, 3, "--planes", 2000)
        assert abs(bed["solid_volume_m3"] / volume - 1) < 1e-5, (tilt, bed, volume)
    # random nested, touching and crossing discs in the plane against Monte Carlo
    random = np.random.default_rng(4)
    centres, sizes = random.uniform(0.2, 0.8, (40, 2)), random.uniform(0.01, 0.2, 40)
    rows = [(k + 1, *map(float, c), 0.0, float(r)) for k, (c, r) in enumerate(zip(centres, sizes))]
    name = dump("discs.dump", "id x y z radius", rows)
    points = random.uniform(0, 1, (400000, 2))
    inside = np.zeros(len(points), bool)
    for c, r in zip(centres, sizes):
        inside |= ((points - c) ** 2).sum(axis=1) < r * r
    # a slab so thin that every section is that of the middle
    (bed,) = json_of("bed", name, "--box", 0, 1, 0, 1, -1e-7, 1e-7, "--planes", 8)
    share, error = inside.mean(), 4 * math.sqrt(0.25 / len(points))
    assert abs(bed["solid_volume_m3"] / 2e-7 - share) < error, (bed, share)


def check_bodies_of_spheres():
    """Mass, velocity and spin of the host's rigid bodies."""
    spin, mass, columns = 50.0, 2e-5, "id id_multisphere mass radius x y z vx vy vz omegax omegay omegaz"
    rows = []
    for body in 1, 2:
        for k, (place, radius) in enumerate(((-1.5e-3, 5e-4), (0.0, 1e-3), (1.5e-3, 5e-4))):
            x, y = body * 0.01 + 0.6 * place, 0.8 * place
            rows.append((3 * body + k, body, mass, radius, x, y, 0.0, 0.1 - spin * 0.8 * place,
                         0.2 + spin * 0.6 * place, 0.0, 0.0, 0.0, spin))
    (found,) = json_of("energy", dump("bodies.dump", columns, rows), "--inertia", 1e-11, 2e-11, 3e-11)
    assert abs(found["translation_J"] / (2 * 0.5 * mass * (0.1 ** 2 + 0.2 ** 2)) - 1) < 1e-9, found
    # about z, one of the two equal axes across the row
    across = found["rotation_J"] / (2 * 0.5 * spin ** 2)
    assert 2e-11 - 1e-20 < across < 3e-11 + 1e-20, found
    other = [list(row) for row in rows]
    other[1][2] = 1e-5
    refused("energy", dump("masses.dump", columns, other), words=("masses.dump:11", "whole body"))
    clump = rows[:2] + [(5, 1, mass, 7e-4, 0.0115, 1e-3, 0.0, 0.1, 0.2, 0.0, 0.0, 0.0, spin)]
    refused("energy", dump("clump.dump", columns, clump), words=("mass centres",))


def check_meanings_of_columns():
    one = [(1, 1, 0, 0.00115, 0, 1, 0, 0, 0, 0.0027, 0.00115, 0.00115, 8, 8)]
    refused("orientation", dump("block.dump", ELLIPSOIDS + " blockiness1 blockiness2", one),
            words=("block.dump:10", "blockiness1 2"))
    one[0] = one[0][:-2] + (2, 2)
    post("orientation", dump("round.dump", ELLIPSOIDS + " blockiness1 blockiness2", one))
    one[0] = one[0][:-2] + (2, 4)
    for names in ("block1 block2", "blockx blocky", "roundness1 roundness2", "c_block[1] c_block[2]", "f_blockiness[1] f_blockiness[2]"):
        refused("orientation", dump("block.dump", ELLIPSOIDS + " " + names, one), words=("block.dump:10", names.split()[1] + " 2, an ellipsoid"))
    post("orientation", dump("number.dump", ELLIPSOIDS + " c_block_number blocks", one))
    two = [(k, 1, 0, y, 0, 1, 0, 0, 0, 0.0027, 0.00115, 0.00115, k) for k, y in ((1, 0), (2, 0.0025))]
    assert contacts(dump("mol.dump", ELLIPSOIDS + " mol", two)) == 0
    balls = [(k, 7, 0.0, y, 0.0, 1.0) for k, y in ((1, 0.0), (2, 1.5), (3, 4.0))]
    name = dump("balls.dump", "id mol x y z radius", balls)
    refused("contacts", name, words=("--bodies mol", "--bodies none"))
    assert contacts(name, "--bodies", "none") == 1 and contacts(name, "--bodies", "mol") == 0
    # LAMMPS's names: whole axes
    lammps = [row[:-1] for row in two]
    lammps = [row[:9] + (0.0054, 0.0023, 0.0023) for row in lammps]
    name = dump("lammps.dump", ELLIPSOIDS.replace("quat1 quat2 quat3 quat4", "quatw quati quatj quatk"),
                lammps)
    assert "--size-scale" in post("contacts", name)[1]
    assert contacts(name) == contacts(name, "--size-scale", 0.5) == 0
    assert post("contacts", name, "--size-scale", 1)[1].count("--size-scale") == 0
    assert contacts(name, "--size-scale", 1) == 1
    turned = [(1, 0, 0, 0, 0, 0, math.sqrt(0.5), math.sqrt(0.5), 3, 1, 1)]
    orient = "id x y z c_orient[1] c_orient[2] c_orient[3] c_orient[4] "
    name = dump("ovito.dump", orient + "c_shape[1] c_shape[2] c_shape[3]", turned)
    refused("orientation", name, words=("c_shape[*]", "--size-scale 1", "--size-scale 0.5"))
    (row,) = json_of("orientation", name, "--size-scale", 1)
    assert abs(row["director_y"]) > 1 - 1e-12, row  # x turned by 90 degrees about z
    assert "--column quat1=c_orient[1]" in post("orientation", name, "--size-scale", 1)[1]
    scalar_first = [f"--column=quat{k}=c_orient[{k}]" for k in (1, 2, 3, 4)]
    turned = [(1, 0, 0, 0, math.sqrt(0.5), 0, 0, math.sqrt(0.5), 3, 1, 1)]
    name = dump("scalar_first.dump", orient + "c_shape[1] c_shape[2] c_shape[3]", turned)
    assert "c_orient" not in post("orientation", name, "--size-scale", 1, *scalar_first)[1]
    (row,) = json_of("orientation", name, "--size-scale", 1, *scalar_first)
    assert abs(row["director_y"]) > 1 - 1e-12, row
    # names of whole axes: two bodies of semi-axes 1.5 0.5 0.5 beside each other, 1.01 apart, do not touch
    apart = [(k, 0, y, 0, 0, 0, 0, 1, 3, 1, 1) for k, y in ((1, 0), (2, 1.01))]
    for columns in (orient + "c_diameter[1] c_diameter[2] c_diameter[3]", orient + "shapex shapey shapez",
                    "id x y z quatx quaty quatz quatw shapex shapey shapez", "id x y z quati quatj quatk quatw c_diameter[1] c_diameter[2] c_diameter[3]"):
        name = dump("whole.dump", columns, apart)
        assert contacts(name) == 0 and "halved" in post("contacts", name)[1], columns
        assert contacts(name, "--size-scale", 1) == 1
    name = dump("q.dump", "id x y z c_q[1] c_q[2] c_q[3] c_q[4] radius",
                [(1, 0, 0, 0, 1, 0, 0, 0, 1)])
    refused("orientation", name, words=("c_q", "--column quat1=c_q[1]"))
    mapped = [f"--column=quat{k}=c_q[{k}]" for k in (1, 2, 3, 4)]
    post("orientation", name, *mapped)
    name = dump("named.dump", "id px py pz size", [(1, 0, 0, 0, 1), (2, 0, 1.5, 0, 1)])
    names = ("--column", "x=px", "--column", "y=py", "--column", "z=pz", "--column", "radius=size")
    assert contacts(name, *names) == 1
    refused("contacts", name, *names[:-1], "radius=sizes", words=("sizes", "--column radius=sizes"))
    assert "NAME must be one of" in post("contacts", name, "--column", "colour=size", expect=2)[1]
    assert "NAME=COLUMN" in post("contacts", name, "--column", "size", expect=2)[1]


def check_long_axes():
    """Aligned bodies, whichever of their axes is the long one; the oblate ones about z."""
    random = np.random.default_rng(5)
    for axes, q in (("3 1 1", (0, 1, 0)), ("1 3 1", None), ("1 1 3", (0, 0, 1))):
        rows = []
        for k in range(50):
            spin = random.uniform(0, 2 * math.pi)  # about the body's long axis, which stays along space y
            half, h = spin / 2, math.sqrt(0.5)
            about = {"3 1 1": (math.cos(half), math.sin(half), 0, 0),
                     "1 3 1": (math.cos(half), 0, math.sin(half), 0),
                     "1 1 3": (math.cos(half), 0, 0, math.sin(half))}[axes]
            turn = {"3 1 1": (h, 0, 0, h), "1 3 1": (1, 0, 0, 0), "1 1 3": (h, -h, 0, 0)}[axes]
            w, x, y, z = turn
            W, X, Y, Z = about
            p = (w * W - x * X - y * Y - z * Z, w * X + x * W + y * Z - z * Y,
                 w * Y - x * Z + y * W + z * X, w * Z + x * Y - y * X + z * W)
            rows.append((k + 1, 1, 10 * k, 0, 0, *p, *axes.split()))
        (row,) = json_of("orientation", dump("long.dump", ELLIPSOIDS, rows))
        assert abs(row["nematic_order"] - 1) < 1e-12 and abs(row["director_y"]) > 1 - 1e-12, (axes, row)


def check_files():
    pile = wedge()
    text = frame_text(100, pile)
    reference = rows_of("pile", write("plain.dump", text))
    for row in reference:
        row.pop("run")
    packed = {"gz": gzip.compress, "bz2": bz2.compress, "xz": lzma.compress}
    for kind, pack in packed.items():
        halves = pack(text[:5000].encode()) + pack(text[5000:].encode())  # files may be joined
        with open(f"packed.dump.{kind}", "wb") as file:
            file.write(halves)
        for source in ("file", "pipe"):
            done = subprocess.run([POST, "pile", "-" if source == "pipe" else f"packed.dump.{kind}",
                                   "--csv", "-"], input=halves if source == "pipe" else None,
                                  capture_output=True, check=True)
            table = [line.split(",", 1)[1] for line in done.stdout.decode().splitlines()]
            plain = [line.split(",", 1)[1] for line in post("pile", "plain.dump", "--csv", "-")[0].splitlines()]
            assert table == plain, (kind, source)
        with open("cut.dump." + kind, "wb") as file:
            file.write(halves[:-20])
        _, error = post("pile", "cut.dump." + kind, expect=1)
        assert "broken or cut off" in error, error
    # a pipe whose name ends in a digit is read once
    os.mkfifo("pipe7")
    feeder = threading.Thread(target=lambda: write("pipe7", text))
    feeder.start()
    (row,) = rows_of("pile", "pipe7")
    feeder.join()
    row.pop("run")
    assert row == reference[0]
    # cut within the last number, or before the end of its line
    columns = "id mass vx vy vz omegax omegay omegaz radius x y z"
    whole = [(k, 1e-5, 0, 0, 0, 0, 0, 0, 1e-3, 0.0, 0.0, f"{k}.2575") for k in (1, 2)]
    with open(dump("cut.dump", columns, whole), encoding="ascii") as file:
        uncut = file.read()
    for length in range(len(uncut) - len("2.2575\n") + 1, len(uncut)):
        refused("energy", write("cut.dump", uncut[:length]), words=("cut.dump:11", "cut off"))
        with open("cut.dump.gz", "wb") as file:
            file.write(gzip.compress(uncut[:length].encode()))
        refused("energy", "cut.dump.gz", words=("cut.dump.gz:11", "cut off"))
    # twice the same id; the same frame twice; an empty last file
    twice = [dict(row) for row in pile]
    twice[3]["id"] = twice[8]["id"]
    refused("pile", write("twice.dump", frame_text(1, twice)), words=("ids that come once",))
    _, error = post("energy", write("again.dump", text + text))
    assert error.count("\n") == 1 and "time step 100, after one of 100" in error, error
    write("series.1.dump", frame_text(1, pile))
    write("series.2.dump", frame_text(2, pile))
    write("series.3.dump", "")
    out, error = post("pile", "series.*.dump", "--csv", "-", expect=1)
    assert "series.3.dump" in error and "the file is empty" in error, error
    assert out.splitlines()[1].startswith("series.*.dump,2,"), out
    os.remove("series.3.dump")
    (row,) = rows_of("pile", "--one-run", "series.1.dump", "series.2.dump")
    assert row["run"] == "series.*.dump" and row["timestep"] == "2", row
    (row,) = rows_of("pile", "--one-run", write("first.dump", frame_text(1, pile)), "series.2.dump")
    assert row["run"] == "first.dump to series.2.dump", row
    # one value that is no number: in a column that nobody needs, and in one that is needed
    columns = "id x y z radius c_extra"
    rows = [(1, 0, 0, 0, 1, 5.0), (2, 0, 1.5, 0, 1, "nan"), (3, 9, 9, 9, 1, "-")]
    name = dump("extra.dump", columns, rows)
    assert contacts(name) == 1
    refused("render3d", name, "-o", "x.png", "--colour", "c_extra", words=("extra.dump:11", '"nan"'))
    refused("contacts", dump("extra.dump", columns, [(1, "x", 0, 0, 1, 5.0)]), words=('"x"',))
    # options that would be ignored
    chains = dump("chains.dump", ELLIPSOIDS + " f_subspheres",
                  [(1, 1, 0, 0, 0, 1, 0, 0, 0, 2, 1, 1, 5)])
    refused("contacts", chains, "--subspheres", 7, words=("--subspheres", "f_subspheres"))
    refused("contacts", chains, "--semiaxes", 1, 1, 1, words=("--semiaxes",))
    post("contacts", "list.local", "--local", "--frame", 7, expect=2)
    post("contacts", "list.local", "--local", "--contact-gap", 0.1, expect=2)
    far = [(1, 1, 1e20, 1e20, 0, 1, 0, 0, 0, 0.0027, 0.00115, 0.00115),
           (2, 1, 0.0027, 0.00115, 0.001, 1, 0, 0, 0, 0.0027, 0.00115, 0.00115)]
    refused("heap", dump("far.dump", ELLIPSOIDS, far), words=("1e+20", "rounding"))
    (bed,) = json_of("bed", dump("ball.dump", "id x y z radius", [(1, 0, 0, 0, 1)]), "--box", "-.5",
                     ".5", "-.5", ".5", "-.5", ".5")
    assert bed["porosity"] == 0, bed  # wholly inside the ball


def check_contact_lists():
    """Contact lists are read forwards once, however many frames there are: they may come from a pipe."""
    count, frames, lists, expected = 12, [], [], []
    for step in range(0, 300, 10):
        balls = [(k + 1, 3.0 * k, 0.0, 0.0, 1.0) for k in range(count)]
        frames.append((step, balls))
        pairs = [(k, k + 1) for k in range(1, 2 + step // 30)]
        expected.append(2 * len(pairs) / count)
        for extra in range(2):  # and lists of steps that no frame has
            rows = pairs if extra == 0 else []
            lists.append("\n".join(["ITEM: TIMESTEP", str(step + 5 * extra), "ITEM: NUMBER OF ENTRIES",
                                    str(len(rows)), "ITEM: BOX BOUNDS ff ff ff", "0 1", "0 1", "0 1",
                                    "ITEM: ENTRIES c_p[1] c_p[2]"]
                                   + [f"{i} {j}" for i, j in rows]) + "\n")
    text = ""
    for step, balls in frames:
        dump("part.dump", "id x y z radius", balls, step=step)
        with open("part.dump", encoding="ascii") as file:
            text += file.read()
    name = write("frames.dump", text)
    os.mkfifo("lists")
    feeder = threading.Thread(target=lambda: write("lists", "".join(lists)))
    feeder.start()
    options = ("--no-wall", "--cluster-gap", 10, "--id-columns", "c_p[1]", "c_p[2]")
    rows = rows_of("coordination", name, "--frame", "all", "--contacts", "lists", *options)
    feeder.join()
    assert [float(row["zpp"]) for row in rows] == expected, rows
    write("some.local", "".join(lists[:20]))
    out, error = post("coordination", name, "--frame", "all", "--contacts", "some.local", *options,
                      "--csv", "-", expect=1)
    assert len(out.splitlines()) == 11 and "no contacts of time step 100" in error, (out, error)
    check_odd_lists()


def forces_text(step, rows):
    return "\n".join(["ITEM: TIMESTEP", str(step), "ITEM: NUMBER OF ENTRIES", str(len(rows)), "ITEM: BOX BOUNDS ff ff ff",
                      "0 1", "0 1", "0 1", "ITEM: ENTRIES i j nx ny nz fx fy fz", *rows]) + "\n"


def check_odd_lists():
    """Lists that come again, hold nothing or normals of no length: said or refused, never counted."""
    balls = [(k + 1, 1e-3 * k, 0.0, 0.0, 5e-4, 1e-6) for k in range(4)]
    name = dump("row.dump", "id x y z radius mass", balls)
    whole = ["1 2 2 0 0 -5 0 0", "2 3 1 0 0 -7 0 0"]
    local = ("contacts", "odd.local", "--local", "--normal-columns", "nx", "ny", "nz", "--force-columns", "fx", "fy", "fz")
    fields = ("fields", name, "--at", 0, 0, 0, "--contacts", "odd.local", "--id-columns", "i", "j", "--normal-columns", "nx", "ny", "nz",
              "--force-columns", "fx", "fy", "fz")
    write("odd.local", forces_text(0, whole))
    for command in local, fields:
        assert post(*command)[1] == "", command
    write("odd.local", forces_text(0, whole + ["3 4 0 0 0 -1 0 0"]))
    for command in local, fields:
        refused(*command, words=("odd.local:12", "of length 0"))
    write("odd.local", forces_text(10, whole) + forces_text(0, whole) + forces_text(0, whole))
    assert "frame 2 is of time step 0, after one of 10: lists are repeated" in post(*local)[1]
    write("odd.local", forces_text(0, whole) + forces_text(0, whole) + forces_text(10, whole))
    with open(name, encoding="ascii") as file:
        first = file.read()
    write("frames.dump", first + first.replace("TIMESTEP\n0", "TIMESTEP\n10"))
    assert "lists are repeated" in post(fields[0], "frames.dump", "--frame", "all", *fields[2:])[1]
    write("odd.local", forces_text(0, whole) + forces_text(10, []))
    out, error = post(*local)
    assert "the last list, of time step 10, holds no contacts" in error and "nan" not in out, (out, error)
    write("odd.local", forces_text(0, whole)[:-2])  # "-7 0 0" has become "-7 0 "
    for command in local, fields:
        refused(*command, words=("odd.local:11",))
    write("odd.local", forces_text(0, whole)[:-1])  # the last number may go on
    for command in local, fields:
        refused(*command, words=("odd.local:11", "cut off"))


def check_order_of_frames():
    """Measures of motion: a frame that comes twice counts once, one that comes too early is refused."""
    ball = lambda x: [(1, 1, x, 0.0, 0.0, 0.1, 2.0) + (0,) * 6, (2, 1, 0.5, 0.5, 0.5, 0.1, 2.0) + (0,) * 6]
    texts = []
    for step, x in ((0, 0.1), (10, 0.2), (10, 0.2), (20, 0.4)):
        with open(dump("step.dump", "id type x y z radius mass vx vy vz omegax omegay omegaz", ball(x), step=step), encoding="ascii") as file:
            texts.append(file.read())
    once = {}
    for name, order in (("once", (0, 1, 3)), ("twice", (0, 1, 2, 3)), ("early", (1, 0, 3))):
        with open("series.dump", "w", encoding="ascii") as file:
            file.write("".join(texts[k] for k in order))
        for command, more in (("trajectory", ()), ("flow", ("--through", 0.3, 0, 0, 1, 0, 0)), ("trajectory", ("--collisions", "--dt", 1))):
            if name == "early":
                assert "in the order of time" in post(command, "series.dump", *more, expect=1)[1], command
                continue
            rows = json_of(command, "series.dump", *more)
            assert once.setdefault((command, more), rows) == rows, (command, rows)


def check_gravity():
    """Where gravity points: the option, the log beside the dump, the plane; else no potential."""
    up = [particle(1, 0.0, 0.01), particle(2, 0.0, 0.05)]
    (row,) = json_of("energy", write("plane.dump", frame_text(1, up)))
    assert abs(row["potential_J"] - 2e-5 * 9.81 * 0.06) < 1e-15 and row["gravity_from"] == "assumed"
    for column in "vz", "omegax", "omegay":  # in one plane, but it moves or turns out of it: a single grain that falls along z
        alone = particle(1, 0.0, 0.01)
        alone[column] = -0.5
        (row,) = json_of("energy", write("falls.dump", frame_text(1, [alone])))
        assert row["potential_J"] is None and row["gravity_y_m_per_s2"] is None, (column, row)
    up[1]["z"] = 0.03
    name = write("space.dump", frame_text(1, up))
    (row,) = json_of("energy", name)
    assert row["potential_J"] is None and "--gravity" in post("energy", name)[1], row
    (row,) = json_of("energy", name, "--gravity", 0, 0, -10)
    assert abs(row["potential_J"] - 2e-5 * 10 * 0.03) < 1e-15 and row["gravity_from"] == "option"
    os.mkdir("logged")
    write("logged/log.run", "fix weight all gravity 5.0 vector 0.0 0.0 -2.0\nrun 1000\n"
          "Step Atoms\n 0 2\n 600 2\n")
    name = write("logged/space.dump", frame_text(600, up))
    (row,) = json_of("energy", name)
    assert abs(row["potential_J"] - 2e-5 * 5 * 0.03) < 1e-15 and row["gravity_from"] == "log", row
    box = ("--box", -1, 1, -1, 1, -1, 1)
    assert json_of("bed", name, *box)[0]["up_from"] == "log"
    assert json_of("bed", "space.dump", *box, "--up", "y")[0]["up"] == "y"
    out, error = post("pile", name, "--no-wall", "--section", 0.0, expect=None)
    assert "reached step 600 of 1000" in error, (out, error)


check_periodic_boxes()
check_nested_sections()
check_bodies_of_spheres()
check_meanings_of_columns()
check_long_axes()
check_files()
check_contact_lists()
check_order_of_frames()
check_gravity()
