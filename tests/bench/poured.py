"""Beds of other bodies than the paper's: long ones, and two sizes. The engine puts them into a column at random and
lets them settle. SI units."""

from pathlib import Path

import numpy as np

from scripts import SIDE, forces, gravity, header, timed
from start import A, B, VOLUME_RADIUS, Particle, data_file

STEP = 1e-5
SETTLING_TIME = 0.3  # after the fall
#: solid fraction of the column at the start: so thin that long bodies find room, too
LOOSE = 0.12
#: lists are made anew at fixed times, so that all shapes have the same number of new lists
REBUILDS = "neigh_modify delay 0 every 20 check no page 1000000 one 10000\n"
COLUMNS = "id type mass x y z vx vy vz omegax omegay omegaz"


def long_axes(aspect):
    """Semi-axes of spheroids with the volume of the paper's."""
    b = VOLUME_RADIUS / aspect ** (1.0 / 3.0)
    return aspect * b, b, b


def kinds(case, aspect):
    """[(semi-axes, share of the mass)] of the bodies of a bed."""
    if case == "sizes":
        return [((A, B, B), 0.5), ((10.0 * A, 10.0 * B, 10.0 * B), 0.5)]
    return [(long_axes(aspect), 1.0)]


def templates(shape, bodies):
    """Script lines of one template per kind, and their mixture."""
    lines, words = "", ""
    for k, (axes, share) in enumerate(bodies):
        radius = float(np.prod(axes)) ** (1.0 / 3.0)
        seed = (15485863, 15485867)[k]
        what = (f"particletemplate/sphere {seed} atom_type 1 density constant 1340 radius constant {radius!r}"
                if shape.kind == "sphere" else f"particletemplate/ellipsoid {seed} atom_type 1 density 1340 semiaxes "
                + " ".join(map(repr, axes)))
        lines += f"fix grain{k} all {what}\n"
        words += f" grain{k} {share}"
    return lines + f"fix mixture all particledistribution/discrete 32452843 {len(bodies)}{words}\n"


def column_height(bodies, count, side):
    """Height of the column (m) into which the bodies are put: thinner the longer they are."""
    volume = count * 4.0 / 3.0 * np.pi / sum(share / np.prod(axes) for axes, share in bodies)
    longest = max(max(axes) / min(axes) for axes, _ in bodies)
    return float(volume / (LOOSE * min(1.0, 2.5 / longest) * side ** 2))


def pour(shape, bodies, count, side):
    """Script that puts `count` bodies into a column and lets them settle; its last frame is settled.dump."""
    height = column_height(bodies, count, side)
    steps = round((np.sqrt(2.0 * height / 9.81) + SETTLING_TIME) / STEP)
    columns = COLUMNS + (" radius" if shape.kind == "sphere" else " quat1 quat2 quat3 quat4 shapex shapey shapez")
    form = " ".join("%d" if c in ("id", "type") else "%.17g" for c in columns.split())
    return header(shape, "p p f") + f"""region box block 0 {side!r} 0 {side!r} {-A!r} {height + 0.06!r} units box
create_box 2 box
""" + forces(shape, 2e3) + gravity("bed") + f"""fix floor all {shape.wall} primitive type 1 zplane 0.0
neigh_modify delay 0 page 1000000 one 10000
{templates(shape, bodies)}region column block 0 {side!r} 0 {side!r} 0.03 {height + 0.03!r} units box
group grains type 1
{shape.motion.replace(' grains ', ' all ')}
fix insert all insert/pack seed 32452867 distributiontemplate mixture maxattempt 1000 insert_every once &
    overlapcheck yes all_in no orientation random region column ntry_mc 10000 particles_in_region {count}
timestep {STEP}
thermo {steps // 10}
thermo_modify lost error norm no
run 1
unfix insert
dump end all custom {steps} settled.dump {columns}
dump_modify end sort id format "{form}"
run {steps} upto
"""


def data_of(dump, shape, side, wanted):
    """Data file of the last frame of a dump of pour(), in which all `wanted` particles must be."""
    lines = Path(dump).read_text().splitlines()
    count = int(lines[3])
    if count != wanted:
        raise SystemExit(f"{count} of {wanted} particles found room in the column: lower LOOSE in poured.py")
    rows = np.array([line.split() for line in lines[-count:]], float)
    particles = []
    for row in rows:
        axes = (row[12],) * 3 if shape.kind == "sphere" else tuple(row[16:19])
        quaternion = (1.0, 0.0, 0.0, 0.0) if shape.kind == "sphere" else tuple(row[12:16])
        particles.append(Particle(tuple(row[3:6]), axes, quaternion, tuple(row[6:9]), tuple(row[9:12]), mass=row[2]))
    box = (0.0, side, 0.0, side, -A, float(rows[:, 5].max()) + 0.05)
    return data_file(shape.start, particles, box, 2)


def bed(shape, start, steps, warm):
    """Script of the settled bed, whose lists are made anew every 20 steps."""
    return (header(shape, "p p f") + f"read_data {start}\n" + forces(shape) + shape.subsphere_fix + REBUILDS + gravity("bed")
            + f"group grains type 1\nfix floor all {shape.wall} primitive type 1 zplane 0.0\n{shape.motion}\n"
            + timed(steps, warm))


def side_of(case):
    return 2.0 * SIDE if case == "sizes" else SIDE
