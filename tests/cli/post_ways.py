# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""Ways of particles in boxes that repeat, upright and tilted, by whatever columns a dump has: plain, scaled and unwrapped
coordinates, image flags, both beside each other; bodies of the host's fix multisphere, whose flags tell no ways.

Oracles: the made ways themselves; of the engine's runs free flight."""
import json
import os
import sys

import numpy as np

from _synthetic import json_of, post, write

sys.path.insert(0, os.path.join(os.environ["ELLIPSOID_SOURCE"], "tests", "engine"))
from _engine import LAW, Particle, Setup, rigid_bodies, run  # noqa: E402

SEED = 20
BOXES = {  # bounds of the box and its edges, as rows
    "upright": ("pp pp pp\n-0.1 0.3\n0 0.5\n1 1.7\n", np.diag([0.4, 0.5, 0.7]), np.array([-0.1, 0, 1])),
    "tilted": ("xy xz yz pp pp pp\n-0.1 0.5 0.2\n0 0.6 0\n1 1.7 0.1\n",
               np.array([[0.4, 0, 0], [0.2, 0.5, 0], [0.0, 0.1, 0.7]]), np.array([-0.1, 0, 1])),
}
PLAIN, UNWRAPPED, SCALED, TURNS = "x y z", "xu yu zu", "xs ys zs", "ix iy iz"
KNOWN = (f"{PLAIN} {TURNS}", f"{PLAIN} {UNWRAPPED}", f"{SCALED} {TURNS}", f"{SCALED} xsu ysu zsu", UNWRAPPED, "xsu ysu zsu",
         f"{UNWRAPPED} {TURNS}")


def made_run(box, places, columns):
    """Frames of places (frame, particle, 3), which go on through the box, as a dump with these columns."""
    bounds, edges, low = BOXES[box]
    shares = (places - low) @ np.linalg.inv(edges)
    turns = np.floor(shares)
    known = {}
    for k, axis in enumerate("xyz"):
        known.update({axis: (low + (shares - turns) @ edges)[..., k], axis + "u": places[..., k], axis + "s": (shares - turns)[..., k],
                      axis + "su": shares[..., k], "i" + axis: turns[..., k]})
    text = ""
    for n in range(len(places)):
        text += (f"ITEM: TIMESTEP\n{n}\nITEM: NUMBER OF ATOMS\n{places.shape[1]}\nITEM: BOX BOUNDS {bounds}"
                 f"ITEM: ATOMS id mass radius {columns}\n")
        for p in range(places.shape[1]):
            words = [int(known[c][n, p]) if c[0] == "i" else repr(float(known[c][n, p])) for c in columns.split()]
            text += " ".join(map(str, (p + 1, 1.0, 0.01, *words))) + "\n"
    return write("ways.dump", text)


def check_ways(rng, box):
    """Steps up to 1.7 edges."""
    _, edges, low = BOXES[box]
    steps = rng.uniform(-1.7, 1.7, (5, 30, 3)) @ edges
    places = low + rng.uniform(0, 1, (1, 30, 3)) @ edges + np.concatenate([np.zeros((1, 30, 3)), np.cumsum(steps, axis=0)])
    gate = low + np.array([0.37, 0.2, 0.1]) @ edges
    normal = np.cross(edges[1], edges[2])  # of the plane of the other two edges: it repeats with the first one
    along = (places - gate) @ np.linalg.inv(edges)[:, 0]  # in edges
    passed = np.floor(along[1:]) - np.floor(along[:-1])  # planes, forward
    for columns in KNOWN:
        name = made_run(box, places, columns)
        out, error = post("trajectory", name, "--json", "-")
        assert error.count("warning") == 2 and "30 of 30 particles turn" in error and "longer than half of an edge that repeats, by image flags" in error, (columns, error)
        for row in json.loads(out):
            d = places[row["lag_frames"]] - places[0]
            assert abs(row["msd_m2"] - (d ** 2).sum(axis=1).mean()) < 1e-9, (box, columns, row)
            assert abs(row["displacement_y_m"] - d[:, 1].mean()) < 1e-9, (box, columns, row)
        rows = json_of("flow", name, "--through", *gate, *normal)
        for row, net in zip(rows, passed):
            assert (row["forward"], row["backward"]) == ((net > 0).sum(), (net < 0).sum()), (box, columns, row, net)


def check_short_steps(rng, box):
    """Plain coordinates alone are enough for short ways."""
    _, edges, low = BOXES[box]
    steps = rng.uniform(-0.2, 0.2, (20, 10, 3)) @ edges
    places = low + 0.5 * edges.sum(axis=0) + np.cumsum(steps, axis=0)
    for columns in (PLAIN, SCALED):
        for row in json_of("trajectory", made_run(box, places, columns)):
            d = places[row["lag_frames"]] - places[0]
            assert abs(row["msd_m2"] - (d ** 2).sum(axis=1).mean()) < 1e-9, (box, columns, row)


def check_bad_flags():
    """Flags that are no whole numbers stop who needs them, and nobody else."""
    name = made_run("upright", np.arange(18.0).reshape(2, 3, 3) * 0.02, f"{PLAIN} {TURNS}")
    with open(name, encoding="ascii") as file:
        text = file.read()
    for bad in ("0.5", "none"):
        write("bad.dump", text[:-2] + bad + "\n")
        for command in (("trajectory", "bad.dump"), ("flow", "bad.dump", "--through", 0, 0, 0, 1, 0, 0)):
            _, error = post(*command, expect=1)
            assert "bad.dump:" in error and bad in error, error
        post("coordination", "bad.dump", "--space", "--frame", "all")


def check_no_box():
    """VTK files have no box: flags that count it are refused, others say nothing."""
    for turns, code in ((0, 0), (1, 1)):
        for n in range(2):
            numbers = {"id": ("int", 1), "radius": ("float", 1e-3), **{f"i{axis}": ("int", turns) for axis in "xyz"}}
            write(f"flags_{n}.vtk", "# vtk DataFile Version 2.0\nflags\nASCII\nDATASET POLYDATA\nPOINTS 1 float\n"
                  f"{0.01 + 0.002 * n} 0 0\nVERTICES 1 2\n1 0\nPOINT_DATA 1\n"
                  + "".join(f"SCALARS {name} {kind} 1\nLOOKUP_TABLE default\n{value}\n" for name, (kind, value) in numbers.items()))
        out, error = post("trajectory", "flags_*.vtk", "--json", "-", expect=code)
        if code:
            assert "a box beside the image flags" in error and "take text dumps" in error, error
        else:
            assert abs(json.loads(out)[1]["displacement_x_m"] - 0.002) < 1e-6, out


def check_engine_flights():
    """Ellipsoids that fly 0.8 of the box between two frames."""
    edge, step, speed = 0.1, 1e-5, (2.0, -1.6, 0.8)
    particles = [Particle((0.02 + 0.02 * k, 0.03, 0.05), (2.7e-3, 1.5e-3, 1.15e-3), velocity=speed) for k in range(3)]
    columns = f"id type mass {PLAIN} {TURNS} quat1 quat2 quat3 quat4 shapex shapey shapez"
    places = "%.16g " * 3
    run(Setup(box=(0.0, edge) * 3, boundary="p p p", time_step=step).with_particles(particles)
        + f"fix motion all nve/ellipsoid\ndump d all custom 4000 flight.dump {columns}\n"
        f'dump_modify d sort id format "%d %d %.16g {places}%d %d %d {"%.16g " * 7}"\nrun 24000\n', name="in.flight")
    out, error = post("trajectory", "flight.dump", "--dt", step, "--json", "-")
    rows = json.loads(out)
    assert "18 steps of particles" in error and error.count("warning") == 1 and len(rows) == 7, (error, rows)
    for row in rows:
        for axis, v in zip("xyz", speed):
            assert abs(row[f"displacement_{axis}_m"] - v * row["lag_s"]) < 1e-9, (axis, row)


def check_host_bodies():
    """Rigid bodies of the host that cross the box five times: its flags keep them within, whatever columns are dumped."""
    edge, step, speed = 0.1, 1e-4, (1.0, 0.3, 0.0)
    setup = Setup(box=(0.0, edge) * 3, boundary="p p p", pair=f"gran {LAW}", atom_style="sphere", time_step=step)
    columns = f"id type id_multisphere radius mass {PLAIN} {UNWRAPPED} {TURNS}"
    run(setup.without_particles()
        + "fix grain all particletemplate/multisphere 15485863 atom_type 1 density constant 2500 nspheres 2 ntry 100000 "
        "spheres 0.0 0.0 0.0 0.002 0.002 0.0 0.0 0.002 type 1\n"
        "fix mixture all particledistribution/discrete 32452843 1 grain 1.0\n"
        "region all block 0.04 0.06 0.04 0.06 0.04 0.06 units box\n" + rigid_bodies()
        + f"fix fill all insert/pack seed 49979687 distributiontemplate mixture vel constant {speed[0]} {speed[1]} {speed[2]} "
        "insert_every once overlapcheck yes region all particles_in_region 3\nrun 1\n"
        f"dump d all custom 200 bodies.dump {columns}\n"
        f'dump_modify d format "%d %d %d {"%.16g " * 8}%d %d %d"\nrun 5000\n', name="in.bodies")
    with open("bodies.dump", encoding="ascii") as file:
        text = file.read()
    dumps = {"both": text}
    names = columns.split()
    for dropped in (PLAIN, f"{UNWRAPPED} {TURNS}", TURNS, UNWRAPPED):
        kept = [k for k, n in enumerate(names) if n not in dropped.split()]
        lines = []
        for line in text.splitlines():
            words = line.split()
            if line.startswith("ITEM: ATOMS"):
                line = "ITEM: ATOMS " + " ".join(names[k] for k in kept)
            elif len(words) == len(names):
                line = " ".join(words[k] for k in kept)
            lines.append(line)
        dumps[f"without {dropped}"] = "\n".join(lines) + "\n"
    spheres = text.replace("id_multisphere", "unknown")
    assert "these do not tell ways of spheres of the host's rigid bodies" in post("trajectory", write("spheres.dump", spheres))[1]
    for kind, dump in dumps.items():
        rows = json_of("trajectory", write("kind.dump", dump), "--dt", step)
        assert len(rows) == 25 and rows[-1]["pairs"] == 3, (kind, rows)
        for row in rows:
            for axis, v in zip("xyz", speed):
                assert abs(row[f"displacement_{axis}_m"] - v * row["lag_s"]) < 1e-6, (kind, axis, row)
            assert abs(row["msd_m2"] - (1.09 * row["lag_s"] ** 2)) < 1e-6, (kind, row)


def main():
    print(f"seed {SEED}")
    rng = np.random.default_rng(SEED)
    for box in BOXES:
        check_ways(rng, box)
        check_short_steps(rng, box)
    check_bad_flags()
    if os.environ["ELLIPSOID_VTK"] == "1":
        check_no_box()
    check_engine_flights()
    check_host_bodies()


main()
