# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""Tables of many rows: the same as of each frame alone, in memory that does not grow with the frames.

Oracle: the tables of single frames, which are short; the memory of a run with a tenth of the frames."""
import csv
import io
import json
import os
import subprocess

import numpy as np

from _synthetic import COLUMNS, POST, SLOWNESS, post

SEED = 8
FRAMES, POINTS = 400, (4, 4, 4)


def made_run(name, frames, rng, count=30):
    box = 0.02
    with open(name, "w", encoding="ascii") as file:
        for n in range(frames):
            file.write(f"ITEM: TIMESTEP\n{n}\nITEM: NUMBER OF ATOMS\n{count}\nITEM: BOX BOUNDS pp pp pp\n"
                       + f"0 {box}\n" * 3 + "ITEM: ATOMS " + " ".join(COLUMNS) + "\n")
            for k, (place, speed, q) in enumerate(zip(rng.uniform(0, box, (count, 3)), rng.normal(size=(count, 3)), rng.normal(size=(count, 4)))):
                q /= np.linalg.norm(q)
                file.write(" ".join(map(str, (k + 1, 1 + k % 2, 1e-5, *place, *speed, 0, 0, 0, *q, 1.5e-3, 1e-3, 0.7e-3, 0))) + "\n")
    return name


def memory(*arguments):
    """Largest memory of one run of ellipsoid-post, or of this program before it (MB)."""
    process = subprocess.Popen([POST, *map(str, arguments)], stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    assert status == 0, (arguments, status)
    return usage.ru_maxrss / 1024


def check_same_tables(run):
    """Of 25 600 rows, and of each frame's 64: the same lines of CSV, the same objects, the same numbers for people."""
    command = ("fields", run, "--grid", *POINTS, "--kernel", "lucy", "--width", 2e-3)
    post(*command, "--frame", "all", "--csv", "all.csv", "--json", "all.json", "--quiet")
    out, _ = post(*command, "--frame", "all")
    with open("all.csv", encoding="ascii") as file:
        lines = file.read().splitlines()
    with open("all.json", encoding="ascii") as file:
        objects = json.load(file)
    people, many = out.splitlines(), 64 * FRAMES
    assert len(lines) == 1 + many and len(objects) == many and len(people) == 2 + many, (len(lines), len(objects), len(people))
    assert len(set(map(len, people[1:]))) == 1, "columns are not below each other"
    for step in (0, 1, FRAMES // 2, FRAMES - 1):
        part = slice(64 * step, 64 * step + 64)
        text, _ = post(*command, "--frame", step, "--csv", "-")
        head, *rows = text.splitlines()
        assert head == lines[0] and rows == lines[1:][part], step
        assert json.loads(post(*command, "--frame", step, "--json", "-")[0]) == objects[part], step
        words = [line.split() for line in post(*command, "--frame", step)[0].splitlines()[2:]]
        assert words == [line.split() for line in people[2:][part]], step
    assert objects == json.loads(post(*command, "--frame", "all", "--json", "-")[0])
    rows = list(csv.DictReader(io.StringIO("\n".join(lines))))
    assert all(row[k] == ("" if v is None else row[k]) for row, o in zip(rows, objects) for k, v in o.items())
    assert all(abs(float(row["density_kg_per_m3"]) - o["density_kg_per_m3"]) == 0 for row, o in zip(rows, objects))


def check_refusals(run):
    """As of short tables: inputs are not written over, two results have two names."""
    for arguments, word in ((("--csv", run), "is not written over"), (("--csv", "x", "--json", "x"), "two names"),
                            (("--csv", "absent/x.csv"), "cannot be written")):
        _, error = post("fields", run, "--grid", *POINTS, "--frame", "all", "--quiet", *arguments, expect=None)
        assert word in error and error.count("\n") == 1, (arguments, error)


def check_memory(run, short):
    """A row of fields took 11 kB: of ten times the frames 250 MB more."""
    for command in (("fields", "--grid", *POINTS), ("orientation",), ("pairs", "--bins", 50), ("coordination", "--space"), ("mixing", "--type", 1)):
        few, many = (memory(command[0], name, *command[1:], "--frame", "all", "--csv", "m.csv", "--quiet") for name in (short, run))
        print(f"{command[0]}: {few:.0f} MB for {FRAMES // 10} frames, {many:.0f} MB for {FRAMES}")
        assert SLOWNESS > 1 or many < few + 20, (command, few, many)  # checked memory is given back late


def main():
    print(f"seed {SEED}")
    rng = np.random.default_rng(SEED)
    run, short = made_run("long.dump", FRAMES, rng), made_run("short.dump", FRAMES // 10, rng)
    check_memory(run, short)  # first, while this program is small
    check_same_tables(run)
    check_refusals(run)


main()
