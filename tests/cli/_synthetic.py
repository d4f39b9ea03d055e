# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""Synthetic piles as dump files, and ways to run ellipsoid-post on them."""
import csv
import io
import json
import math
import os
import subprocess

import _plain_numbers  # noqa: F401

POST = os.path.join(os.environ["ELLIPSOID_BIN"], "ellipsoid-post")
SLOWNESS = int(os.environ.get("ELLIPSOID_SLOWNESS", "1"))  # of this build; 1: optimised
COLUMNS = ("id type mass x y z vx vy vz omegax omegay omegaz quat1 quat2 quat3 quat4 "
           "shapex shapey shapez f_subspheres").split()
A, B = 2.7e-3, 1.15e-3


def post(*arguments, expect=0, stdin=None):
    """Runs ellipsoid-post; checks its exit code (None: any); gives (stdout, stderr)."""
    done = subprocess.run([POST, *map(str, arguments)], capture_output=True, text=True,
                          input=stdin, timeout=300 * SLOWNESS)
    assert expect in (done.returncode, None), (arguments, done.returncode, done.stdout, done.stderr)
    return done.stdout, done.stderr


def rows_of(*arguments, expect=0, stdin=None):
    """Runs a command with --csv - and gives its rows as dictionaries."""
    out, _ = post(*arguments, "--csv", "-", expect=expect, stdin=stdin)
    return list(csv.DictReader(io.StringIO(out)))


def json_of(*arguments):
    """Runs a command with --json - and gives its objects."""
    return json.loads(post(*arguments, "--json", "-")[0])


def particle(number, x, y, angle=0.0, subspheres=0, a=A, b=B, speed=0.0):
    """One row as a dictionary; angle (rad) in the plane."""
    return dict(zip(COLUMNS, (number, 1, 2e-5, x, y, 0.0, speed, 0.0, 0.0, 0.0, 0.0, 0.0,
                              math.cos(angle / 2), 0.0, 0.0, math.sin(angle / 2), a, b, b,
                              subspheres)))


def wedge(degrees=25.0, height=0.06, subspheres=0, squeeze=0.9999):
    """A stretched hexagonal lattice under a slope, its ellipses just overlapping."""
    rows, j = [], 0
    while True:
        y = B + squeeze * j * B * math.sqrt(3.0)
        if y > height:
            return rows
        x = A + (A if j % 2 else 0.0)
        while y < height - math.tan(math.radians(degrees)) * x:
            rows.append(particle(len(rows) + 1, A + squeeze * (x - A), y, 0.0, subspheres))
            x += 2.0 * A
        j += 1


def frame_text(step, rows, columns=COLUMNS):
    """One frame of a text dump; numbers with all digits."""
    lines = ["ITEM: TIMESTEP", str(step), "ITEM: NUMBER OF ATOMS", str(len(rows)),
             "ITEM: BOX BOUNDS mm mm ff", "0 0.5", "-0.005 0.2", "-0.01 0.01",
             "ITEM: ATOMS " + " ".join(columns)]
    lines += [" ".join(repr(row[c]) for c in columns) for row in rows]
    return "\n".join(lines) + "\n"


def write(name, text):
    """Writes a file and gives its name."""
    with open(name, "w", encoding="ascii") as file:
        file.write(text)
    return name
