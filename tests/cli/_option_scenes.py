# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""Small files of every kind that commands of ellipsoid-post read, for tests of their options."""
import math
import os
import struct

import numpy as np

from _synthetic import B, COLUMNS, frame_text, particle, post, wedge, write

SEED = 20260704
BALL = 1.0e-3  # radius of a ball of the volume of a body in space


def box_of(text, low, high, bounds):
    """A frame's text with another box."""
    head, rest = text.split("ITEM: BOX BOUNDS", 1)
    box = "".join(f"{a} {b}\n" for a, b in zip(low, high))
    return f"{head}ITEM: BOX BOUNDS {bounds}\n{box}{rest[rest.index('ITEM: ATOMS'):]}"


def frames(rows_of_steps, box=None, columns=COLUMNS):
    texts = [frame_text(step, rows, columns) for step, rows in rows_of_steps]
    return "".join(box_of(text, *box) if box else text for text in texts)


def plane_rows(step):
    """A slope of smooth ellipses and chains of five of two types, a body that nearly touches it, one far away."""
    rows = wedge(25.0, 0.03)
    top = max(rows, key=lambda row: row["y"] - 0.2 * row["x"])
    rows.append(particle(len(rows) + 1, top["x"], top["y"] + 2.6 * B))
    rows.append(particle(len(rows) + 1, 0.2, 0.02))
    for k, row in enumerate(rows):
        # chains that are turned have their spheres out of line; a little off the plane sections differ
        row.update(type=1 + k % 2, f_subspheres=5 if k % 3 == 0 else 0, vx=0.001 * k, vy=0.002 * step, omegaz=0.1 * k,
                   y=row["y"] + 1e-6 * step, heat=float((7 * k) % 11))
    return rows


def heap_rows(step):
    """A cone of bodies."""
    rows = space_rows(step, 10)
    middle = 0.5 * 1.9 * 10 * BALL
    return [r for r in rows if math.hypot(r["x"] - middle, r["y"] - middle) < 0.95 * middle - 1.4 * r["z"]]


def space_rows(step, count=4):
    """Bodies on a lattice, so close that some overlap: smooth ones with three axes, discs, spheres and chains of five."""
    rng, rows = np.random.default_rng(SEED), []
    for k in range(count ** 3):
        q = rng.normal(size=4)
        q /= np.linalg.norm(q)
        place = 1.9 * BALL * (np.array([k % count, k // count % count, k // count ** 2]) + 0.5) + rng.uniform(-2e-4, 2e-4, 3)
        velocity = rng.normal(size=3) * 0.2
        axes = [(1.3e-3, 1e-3, 0.8e-3), (0.7e-3, 1.2e-3, 1.2e-3), (1e-3,) * 3, (1.6e-3, 0.8e-3, 0.8e-3)][k % 4]
        rows.append(dict(zip(COLUMNS, (k + 1, 1 + k % 2, 2e-5, *(place + velocity * 1e-5 * step), *velocity, *rng.normal(size=3),
                                       *q, *axes, 5 if k % 4 == 3 else 0)), heat=float(k % 7)))
    return rows


def spheres_of(rows, across=0.0):
    """Chains of three balls for rows, as a rigid body's spheres with a column mol; `across` turns them."""
    spheres = []
    for row in rows:
        for shift in (-0.5, 0.0, 0.5):
            ball = dict(row, id=len(spheres) + 1, mol=row["id"], radius=0.6 * row["shapey"], heat=row["heat"])
            ball["x"] = row["x"] + shift * row["shapex"]
            ball["y"] = row["y"] + across * shift * row["shapex"]
            spheres.append(ball)
    return spheres


SPHERE_COLUMNS = "id mol type mass radius x y z vx vy vz omegax omegay omegaz heat".split()
BARE = [c for c in COLUMNS if not c.startswith("shape") and c != "f_subspheres"] + ["heat"]


def write_variants(name, rows, box, columns=(*COLUMNS, "heat")):
    """One scene in all the ways in which it may be told."""
    os.makedirs(name, exist_ok=True)
    at = lambda file: os.path.join(name, file)
    steps = [(step, rows(step)) for step in (100, 200, 300)]
    text = frames(steps, box, columns)
    write(at("all.dump"), text)
    for step, of_step in steps:
        write(at(f"one.{step}.dump"), frames([(step, of_step)], box, columns))
    write(at("two.dump"), frames([(400, rows(400))], box, columns))
    write(at("foreign.dump"), text.replace(" shapex ", " s1 "))
    write(at("bare.dump"), frames([(s, r) for s, r in steps], box, BARE))
    clumps = [(s, [dict(row, f_spacing=1003, f_subspheres=3, shapex=2 * row["shapey"], shapez=row["shapey"]) for row in r])
              for s, r in steps]
    write(at("clumps.dump"), frames(clumps, box, [*columns, "f_spacing"]))
    write(at("spheres.dump"), frames([(s, spheres_of(r)) for s, r in steps], box, SPHERE_COLUMNS))
    split = [(s, [dict(b, id_multisphere=b["mol"], x=b["x"] % box[1][0]) for b in spheres_of(r, 0.5)]) for s, r in steps]
    write(at("split.dump"), frames(split, (box[0], box[1], "ff ff ff"), [*SPHERE_COLUMNS, "id_multisphere"]))
    wrapped = (box[0], box[1], "pp pp pp")
    write(at("wrapped.dump"), frames(steps, wrapped, columns))


def write_clump():
    """Three spheres about their centre of mass, along x."""
    write("clump.txt", "".join(f"{x} 0 0 0.5\n" for x in (-0.5, 0.0, 0.5)))


def write_lists(name, rows):
    """Contacts between a few particles and with the floor, a line each; forces press."""
    pairs, walls = [], []
    for p, q in zip(rows[::2], rows[1::2]):
        a, b = (np.array([r[c] for c in "xyz"]) for r in (p, q))
        n = (a - b) / np.linalg.norm(a - b)
        force = 3.0 * n + 0.2 * np.cross(n, (0, 0, 1))
        point = 0.5 * (a + b) + 1e-4 * np.array((1, 2, 3))
        tilted = n + 0.2 * np.array((1, 0, 2))
        pairs.append((p["id"], q["id"], *point, *(tilted / np.linalg.norm(tilted)), *force, *-force, 1e-5 * (1 + len(pairs))))
    for row in rows[:9]:
        walls.append((row["id"], row["x"], row["y"], row["z"] - 1e-3, 0.0, 0.0, 1.0, 0.1, 0.0, 2.0))
    for file, names, entries in (("pairs.local", "i j px py pz nx ny nz fx fy fz gx gy gz h", pairs),
                                 ("walls.local", "i px py pz nx ny nz fx fy fz", walls)):
        text, listed = "", entries
        for step in (100, 200, 300):
            entries = listed if step == 200 else listed[::2]  # some contacts begin and end
            text += (f"ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ENTRIES\n{len(entries)}\nITEM: BOX BOUNDS ff ff ff\n"
                     f"0 1\n0 1\n0 1\nITEM: ENTRIES {names}\n" + "".join(" ".join(map(str, e)) + "\n" for e in entries))
        write(os.path.join(name, file), text)


def write_mesh(file, corners):
    normal = np.cross(np.subtract(corners[1], corners[0]), np.subtract(corners[2], corners[0]))
    normal = normal / np.linalg.norm(normal)
    with open(file, "wb") as out:
        out.write(b"\0" * 80 + struct.pack("<I", 1) + struct.pack("<12f", *normal, *np.ravel(corners)) + b"\0\0")


def write_tables():
    """CSV files as `pile` and measures over places write them."""
    rows = ["run,timestep,surface,subspheres,outline,repose_angle_deg,porosity,zpp,zss,x_m,z_m,speed_m_per_s,kind,relative_cpu_time,"
            "potential_contacts_per_particle"]
    for k in range(12):
        surface, count = ("smooth", "") if k % 3 == 0 else ("multisphere", 3 + 2 * (k % 3))
        rows.append(f"run{k},9,{surface},{count},true,{25 + k % 5},{0.2 + 0.01 * k},{3 + 0.1 * k},{3.5 + 0.1 * k},{0.01 * (k % 4)},"
                    f"{0.02 * (k // 4)},{0.3 * math.sin(k)},{'ab'[k % 2]},{1 + k},{5 + k}")
    write("runs.csv", "\n".join(rows) + "\n")


def write_scenes():
    print("seed", SEED)
    write_variants("plane", plane_rows, ((0, -0.005, -0.01), (0.5, 0.2, 0.01), "ff ff ff"))
    edge = 1.9 * 4 * BALL
    write_variants("space", space_rows, ((0, 0, 0), (edge, edge, edge), "ff ff ff"))
    wide = 1.9 * 10 * BALL
    write_variants("heap", heap_rows, ((0, 0, 0), (wide, wide, wide), "ff ff ff"))
    os.makedirs("logged")
    write("logged/one.dump", frames([(100, space_rows(100))], ((0, 0, 0), (edge,) * 3, "ff ff ff")))
    log = ("fix g all gravity 9.81 vector 0 0 -1\nfix w all wall/gran/ellipsoid model hertz primitive type 1 zplane 0.0006\n"
                       "fix v all wall/gran/ellipsoid model hertz primitive type 1 xplane 0.0\n")
    mound = plane_rows(100)
    mound += [dict(row, id=row["id"] + len(mound), x=-row["x"]) for row in mound if row["x"] > B]
    write("mound.dump", frames([(100, mound)], columns=(*COLUMNS, "heat")))
    write("walls.txt", log)
    write("logged/log.run", log)
    for name, rows in (("plane", plane_rows(100)), ("space", space_rows(100))):
        write_lists(name, rows)
    write_clump()
    write_mesh("face.stl", [(-0.03, -0.03, 0.0038), (0.06, -0.03, 0.0038), (0.0, 0.06, 0.0038)])
    write_tables()
    post("template", "--subspheres", 7, "--stl", "body.stl", "--quiet")
    post("view", "logged/one.dump", "-o", "view.html")
