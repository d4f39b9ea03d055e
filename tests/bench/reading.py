#!/usr/bin/env python3
# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""How fast ellipsoid-post analyses dumps, against a plain Python script that only reads them.

    python3 tests/bench/reading.py [--frames 1000] [--frames-measured 1000] [COMMAND ...]

Makes a dump of 1000 frames of 1000 particles (the settled pile of inputs/results, each particle
moved by up to 1e-9 m, all digits), reads it as people do in Python (split each line, float() each
word), and then with ellipsoid-post, every frame measured (--frame all). Prints wall-clock and
processor times, MB/s, and the ratio to Python's time.
"""
import argparse
import gzip
import os
import random
import resource
import subprocess
import tempfile
import time

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
POST = os.path.join(os.environ.get("ELLIPSOID_BIN", os.path.join(ROOT, "build", "bin")),
                    "ellipsoid-post")
PILE = os.path.join(ROOT, "inputs", "results", "smooth_seed1", "pile.0010000000.dump.gz")
DISTINCT = 20  # frames with digits of their own; they are repeated


def write_dump(name, frames):
    """1000 particles a frame; gives the size in bytes."""
    with gzip.open(PILE, "rt") as file:
        lines = file.read().splitlines()
    header, rows = lines[2:9], [line.split() for line in lines[9:]]
    generator, bodies = random.Random(1), []
    for _ in range(DISTINCT):
        body = []
        for row in rows:
            x, y = (repr(float(row[k]) + 1e-9 * generator.random()) for k in (3, 4))
            body.append(" ".join(row[:3] + [x, y] + row[5:]))
        bodies.append("\n".join(header + body) + "\n")
    with open(name, "w", encoding="ascii") as file:
        for k in range(frames):
            file.write(f"ITEM: TIMESTEP\n{k}\n{bodies[k % DISTINCT]}")
    return os.path.getsize(name)


def read_in_python(name):
    """What home-made scripts do; gives the number of values."""
    values = 0
    with open(name, encoding="ascii") as file:
        for line in file:
            if line.startswith("ITEM: NUMBER OF ATOMS"):
                count = int(next(file))
            elif line.startswith("ITEM: ATOMS"):
                rows = [[float(word) for word in next(file).split()] for _ in range(count)]
                values += len(rows) * len(rows[0])
    return values


def timed(action):
    """Wall-clock and processor time (s) of an action, its children included."""
    def processor():
        return sum(u.ru_utime + u.ru_stime for u in map(
            resource.getrusage, (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)))
    wall, used = time.perf_counter(), processor()
    action()
    return time.perf_counter() - wall, processor() - used


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--frames", type=int, default=1000)
    parser.add_argument("commands", nargs="*",
                        default=["energy", "orientation", "repose", "porosity", "coordination", "pile"])
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        name = os.path.join(folder, "pile.dump")
        size = write_dump(name, options.frames) / 1e6
        python = timed(lambda: read_in_python(name))
        print(f"{options.frames} frames of 1000 particles, {size:.0f} MB, {os.cpu_count()} processors")
        print(f"{'':14}{'wall clock':>12}{'processor':>12}{'':>12}{'times as fast as Python (wall, processor)':>44}")
        print(f"{'plain Python':14}{python[0]:10.2f} s{python[1]:10.2f} s{size / python[0]:7.0f} MB/s")
        for command in options.commands:
            took = timed(lambda: subprocess.run(
                [POST, command, name, "--frame", "all", "--quiet", "--csv", name + ".csv"], check=True))
            print(f"{command:14}{took[0]:10.2f} s{took[1]:10.2f} s{size / took[0]:7.0f} MB/s"
                  f"{python[0] / took[0]:32.1f}{python[1] / took[1]:12.1f}")


main()
