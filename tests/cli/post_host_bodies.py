# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""How bodies of the host's fix multisphere lie and turn, from the places of their spheres alone, and
what is not known of spheres. Expected values are the made rotations; nothing is of the program's code."""
import csv

import numpy as np

from _synthetic import json_of, post, write

CHAIN = [((k * 5e-4, 0.0, 0.0), 6e-4) for k in range(-2, 3)]
CROSS = [((8e-4, 0, 0), 7e-4), ((-8e-4, 0, 0), 7e-4), ((0, 8e-4, 0), 7e-4), ((0, -8e-4, 0), 7e-4)]
RING = [((1.2e-3 * np.cos(a), 1.2e-3 * np.sin(a), z), 5e-4)
        for a in np.arange(6) * np.pi / 3 for z in (-3e-4, 3e-4)]
BAR = [((x * 9e-4, y * 4e-4, z * 4e-4), 5e-4) for x in (-2, 0, 2) for y in (-1, 1) for z in (-1, 1)]
BRICK = [((x * 6e-4, y * 1.2e-3, 0.0), 7e-4) for x in (-1, 1) for y in (-1, 0, 1)]
PEAR = [((0.0, 0.0, 0.0), 1e-3), ((1e-3, 0.0, 0.0), 6e-4)]
TETRAHEDRON = [((7e-4 * x, 7e-4 * y, 7e-4 * z), 7e-4)
               for x, y, z in ((1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1))]
CROOKED = [((0, 0, 0), 1e-3), ((1.8e-3, 0, 0), 1e-3), ((3.6e-3, 0, 0), 1e-3), ((0, 1.3e-3, 4e-4), 8e-4)]


def turned(vector):
    """Rotation matrix of an angle vector (rad), Rodrigues' formula."""
    angle = np.linalg.norm(vector)
    x, y, z = vector / angle if angle > 0 else np.array([1.0, 0.0, 0.0])
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def frames_of(name, spheres, turns, starts, digits=17, edge=0.05):
    """A dump of bodies at random places in a box that repeats; rows come in another order in each frame.
    turns: of each frame, the angle vector in the body's own axes. Gives the rotations of each frame."""
    random = np.random.default_rng(len(spheres))
    places = random.uniform(0, edge, (len(starts), 3))
    text, rotations = "", []
    for step, vector in enumerate(turns):
        rotations.append([start @ turned(np.array(vector)) for start in starts])
        rows = []
        for body, rotation in enumerate(rotations[-1]):
            for place, radius in spheres:
                centre = (places[body] + rotation @ np.array(place)) % edge
                rows.append((len(rows) + 1, 1, body + 1, radius, *centre))
        random.shuffle(rows)
        text += (f"ITEM: TIMESTEP\n{100 * step}\nITEM: NUMBER OF ATOMS\n{len(rows)}\nITEM: BOX BOUNDS pp pp pp\n" +
                 3 * f"0 {edge}\n" + "ITEM: ATOMS id type id_multisphere radius x y z\n")
        for row in rows:
            text += " ".join(f"{value:.{digits}g}" for value in row) + "\n"
    write(name, text)
    return np.array(rotations)


def any_starts(count, seed):
    random = np.random.default_rng(seed)
    return [turned(random.normal(size=3)) for _ in range(count)]


def check_turns():
    """Mean square rotation of bodies that all turn alike about an axis of their own, a full turn and more."""
    starts = any_starts(8, 1)
    for spheres in CROSS, RING, BAR, BRICK, TETRAHEDRON, CROOKED:
        for digits, allowed in ((17, 1e-9), (7, 2e-3)):
            for axis in np.eye(3).tolist() + [[0.6, 0.0, 0.8]]:
                turns = [0.9 * k * np.array(axis) for k in range(9)]
                frames_of("turns.dump", spheres, turns, starts, digits)
                rows = json_of("trajectory", "turns.dump")
                for k, row in enumerate(rows):
                    assert abs(row["rotation_squared_rad2"] - (0.9 * k) ** 2) <= allowed * (1 + k * k), (len(spheres), axis, digits, row)
    # chains: only their axis is known
    turns = [0.9 * k * np.array([0.0, 0.6, 0.8]) for k in range(5)]
    for spheres in CHAIN, PEAR:
        frames_of("turns.dump", spheres, turns, starts)
        rows = json_of("trajectory", "turns.dump")
        for k, row in enumerate(rows):
            assert row["rotation_squared_rad2"] is None and abs(row["direction_correlation"] - np.cos(0.9 * k)) < 1e-9, row
        assert "8 of 8 particles turn" in post("trajectory", "turns.dump")[1]
    post("trajectory", "turns.dump", "--per-particle", "ways_*.csv", "--quiet")
    with open("ways_0000000400.csv", encoding="ascii") as file:
        assert "rotation_x_rad" not in file.readline()


def check_axes():
    """Order of bodies that lie alike, by the axis that counts for their shape, and biaxial order."""
    start = any_starts(1, 2)[0]
    alike = [start @ np.diag(signs) for signs in ((1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1))] * 3
    for spheres, kind, axis, is_triaxial in ((CHAIN, "longest", 0, False), (BAR, "longest", 0, False), (BRICK, "shortest", 2, True),
                                             (CROSS, "shortest", 2, False), (RING, "shortest", 2, False), (TETRAHEDRON, None, 0, False)):
        frames_of("alike.dump", spheres, [[0.0, 0.0, 0.0]], alike)
        (row,) = json_of("orientation", "alike.dump")
        assert row["axis"] == kind, (len(spheres), row)
        if kind is None:
            assert row["particles"] == 0 and row["spheres"] == 12, row
            continue
        director = np.array([row["director_" + c] for c in "xyz"])
        assert abs(row["nematic_order"] - 1) < 1e-9 and abs(abs(director @ start[:, axis]) - 1) < 1e-9, (len(spheres), row)
        assert (row["biaxial_order"] is not None) == is_triaxial and (not is_triaxial or abs(row["biaxial_order"] - 1) < 1e-9), row
    # a mixture by aspect: bricks 1.9 : 0.7, crosses 1.5 : 0.7
    frames_of("alike.dump", BRICK, [[0.0, 0.0, 0.0]], alike)
    error = post("mixing", "alike.dump", "--aspect", "--neighbours", 3, "--cell", 0.02, expect=1)[1]
    assert "alike in what is to be mixed" in error, error


def check_spheres_without_quaternions():
    """Their rotation is not in the file: no value, and a warning; with quaternions it is."""
    def text(with_quaternions):
        frames = ""
        for step in range(4):
            frames += (f"ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ATOMS\n3\nITEM: BOX BOUNDS ff ff ff\n" + 3 * "0 1\n" +
                       "ITEM: ATOMS id x y z radius omegaz" + (" quat1 quat2 quat3 quat4" if with_quaternions else "") + "\n")
            for k in range(3):
                turn = f" {np.cos(0.2 * step)!r} 0 0 {np.sin(0.2 * step)!r}" if with_quaternions else ""
                frames += f"{k + 1} {0.1 + 0.04 * step!r} {0.3 * k + 0.1!r} 0.5 0.1 0.4{turn}\n"
        return frames
    write("rolling.dump", text(False))
    rows = json_of("trajectory", "rolling.dump")
    assert all(row[key] is None for row in rows for key in ("rotation_squared_rad2", "direction_correlation", "direction_correlation_p2"))
    assert abs(rows[3]["msd_m2"] - 0.12 ** 2) < 1e-12 and "3 of 3 particles turn" in post("trajectory", "rolling.dump")[1]
    write("rolling.dump", text(True))
    rows = json_of("trajectory", "rolling.dump")
    assert all(abs(row["rotation_squared_rad2"] - (0.4 * k) ** 2) < 1e-9 for k, row in enumerate(rows)), rows
    assert "particles turn" not in post("trajectory", "rolling.dump")[1]
    post("trajectory", "rolling.dump", "--per-particle", "ways_*.csv", "--quiet")
    with open("ways_0000000003.csv", encoding="ascii") as file:
        assert abs(float(list(csv.DictReader(file))[0]["rotation_z_rad"]) - 1.2) < 1e-9


check_turns()
check_axes()
check_spheres_without_quaternions()
