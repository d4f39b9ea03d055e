"""Contact lists of the engine (dump local), and a crowd of particles that has many contacts."""

import math
from pathlib import Path

import numpy as np

from _engine import LAW, Particle, Setup, quaternion_of, run

WIDTH = 0.0168  # of the periodic box in x and y (m)
HEIGHT = 0.0082
PAIR_COLUMNS = ("id_1 id_2 x_1 y_1 z_1 x_2 y_2 z_2 px py pz nx ny nz overlap fx fy fz fnx fny fnz "
                "ftx fty ftz fn ft radius area sphere_1 sphere_2").split()
WALL_COLUMNS = ("id wall triangle x_1 y_1 z_1 " + " ".join(PAIR_COLUMNS[8:])).split()
PROPERTIES = ("id pos contactPoint normal delta force force_normal force_tangential fn ft "
              "reducedRadius contactArea spheres")


def read_rows(file):
    """The frames of a dump local: {step: rows (n, columns)}."""
    lines, frames, at = Path(file).read_text().splitlines(), {}, 0
    while at < len(lines):
        step, count = int(lines[at + 1]), int(lines[at + 3])
        width = len(lines[at + 8].split()) - 2
        rows = [[float(t) for t in line.split()] for line in lines[at + 9:at + 9 + count]]
        frames[step] = np.array(rows).reshape(count, width)
        at += 9 + count
    return frames


def named(rows, columns):
    """{column: (n,)} of rows with these columns."""
    if rows.shape[1] != len(columns):
        raise AssertionError(f"{rows.shape[1]} columns, not {len(columns)}")
    return {name: rows[:, k] for k, name in enumerate(columns)}


def vector(row, *names):
    return np.array([row[n] for n in names])


def crowd(semiaxes, spacing=4.2e-3, seed=5):
    """4 x 4 x 2 turned particles that touch their neighbours, in motion."""
    random = np.random.default_rng(seed)
    particles = []
    for k in range(32):
        place = np.array([k % 4, k // 4 % 4, k // 16]) * spacing
        place += random.uniform(-1, 1, 3) * 2e-4
        particles.append(Particle(
            tuple(place + (-0.5 * WIDTH + 0.3 * spacing, -0.5 * WIDTH + 0.3 * spacing, 2e-3)),
            semiaxes, quaternion_of(random.normal(size=3), random.uniform(0, math.pi)),
            tuple(random.uniform(-0.1, 0.1, 3)), tuple(random.uniform(-20, 20, 3))))
    return particles


def crowd_setup(surface):
    half = 0.5 * WIDTH
    return Setup(box=(-half, half, -half, half, -0.001, HEIGHT + 0.001), boundary="p p f",
                 pair=f"gran/ellipsoid {LAW} surface {surface}", time_step=1e-7, skin=0.001)


def floor_and_lid(surface, law=LAW):
    """Script lines; `surface` has its settings after its name."""
    name, *settings = surface.split(" ", 1)
    return "".join(
        f"fix {wall} all wall/gran/ellipsoid {law} surface {name} primitive type 1 zplane {height!r} "
        + " ".join(settings) + "\n" for wall, height in (("lid", HEIGHT), ("floor", 0.0)))


def lists(name, every=1):
    """Script lines that write all properties of all contacts to name.pairs and name.walls."""
    text = ""
    for kind, columns in ("pair", PAIR_COLUMNS), ("wall", WALL_COLUMNS):
        places = " ".join(f"c_{kind}[{k + 1}]" for k in range(len(columns)))
        form = " ".join(["%.17g"] * len(columns))
        text += (f"compute {kind} all {kind}/ellipsoid/local {PROPERTIES}\n"
                 f"dump {kind} all local {every} {name}.{kind}s {places}\n"
                 f'dump_modify {kind} format "{form}"\n')
    return text


def refusal(commands, setup=None, particles=2):
    """The one line with which the engine refuses `commands`; raises where it does not."""
    setup = setup or crowd_setup("smooth")
    script = setup.with_particles(crowd((2e-3, 2e-3, 2e-3))[:particles], "few.data")
    outcome = run(script + commands + "run 1\n", check=False)
    lines = [line for line in outcome.text.splitlines() if line.startswith("ERROR")]
    if outcome.code != 1 or len(lines) != 1:
        raise AssertionError(f"exit status {outcome.code}, {len(lines)} errors for {commands!r}:\n"
                             + outcome.text[-800:])
    return lines[0]
