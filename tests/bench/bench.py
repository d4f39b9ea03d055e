"""Side by side: what a particle and a time step cost, for all shapes, as a ratio to spheres.

Run by run.sh, which says how. Every group of shapes is run in turn, spheres before and after each few
of them; a ratio is that of a run to the two runs of spheres around it, so that whatever else the
machine does disturbs both. Times on one rank are processor times of the engine, on more ranks
elapsed times of its run.
"""

import argparse
import csv
import os
import re
import statistics
import subprocess
import sys
import time
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

import poured
import two_engines
import where
from figures import CASE, figure_rows, write_figures
from machine import description
from scripts import (BOX, LAW, SIDE, SMOOTH, SPHERE, SUPERQUADRIC, damped, moving_bodies, multisphere,
                     rigid, rigid_bodies, settle, timed, with_law)
from start import (A, B, VOLUME_RADIUS, bodies, box_mesh, compaction, data_file, lattice, tile,
                   write_superquadrics)

HERE = Path(__file__).parent
SOURCE = HERE.parent.parent
COUNT = 1000  # particles of one tile
SETTLING_STEPS = 45000
FLOWING_STEPS = 15000
RIGID_SETTLING_STEPS = 30000
#: particles times steps of one measurement in space
WORK = {"sphere": 5e6, "smooth": 5e6, "multisphere": 5e6, "superquadric": 1e6, "rigid": 4e5}
SPHERES_EVERY = 3  # shapes between two runs of spheres
MEASURED_ONCE = ("superquadric", "rigid")  # too dear to repeat, and too dear for it to matter

#: N = 3 is for the compaction only: it sticks out of the ellipsoid and cannot start from a settled bed of smooth ones
COMPACTION_SHAPES = ([SMOOTH] + [multisphere(n) for n in (1, 3, 5, 7, 9, 13, 17, 33, 55)]
                     + [SUPERQUADRIC])
BED_SHAPES = [SMOOTH, multisphere(5), multisphere(17), multisphere(55), SUPERQUADRIC]
FEW_SHAPES = [SMOOTH, multisphere(5), multisphere(17)]


#: contact laws of common scripts, beside the paper's
OTHER_LAWS = {
    "hertz": "model hertz tangential history",
    "hertz, cdt": "model hertz tangential history rolling_friction cdt",
    "hertz, epsd2": "model hertz tangential history rolling_friction epsd2",
    "hertz, sjkr2, cdt": "model hertz tangential history cohesion sjkr2 rolling_friction cdt",
    "hooke": "model hooke tangential history",
    "velocity": f"{LAW} direction velocity",
}


@dataclass
class Group:
    """Shapes that are compared with each other and with spheres."""

    name: str
    case: str  # compaction, bed, flow, cloud, box, mesh, long or sizes
    shapes: list
    tiles: tuple = (1, 1)
    ranks: int = 1
    most_repeats: int = 99
    law: str = LAW
    cells: int = 0  # of each side of a box of triangles, along an edge
    aspect: float = A / B  # of long bodies

    @property
    def particles(self):
        return COUNT * self.tiles[0] * self.tiles[1]


@dataclass
class Sample:
    """One run: ns per particle and step, and the largest memory of the process beyond an empty engine's (bytes)."""

    cost: float
    memory: float
    figures: dict = field(default_factory=dict)


def groups():
    """All groups by name, in the order in which they are run."""
    all_groups = [
        Group("compaction", "compaction", COMPACTION_SHAPES),
        Group("bed 1000", "bed", BED_SHAPES + [rigid(17)]),
        Group("bed 30000", "bed", [SMOOTH, multisphere(5), multisphere(17), SUPERQUADRIC], (5, 6), 1, 3),
        Group("bed 30000, 2 ranks", "bed", FEW_SHAPES, (5, 6), 2, 3),
        Group("compaction, 2 ranks", "compaction", FEW_SHAPES, ranks=2, most_repeats=2),
        Group("flow", "flow", FEW_SHAPES),
        Group("cloud", "cloud", FEW_SHAPES),
        *(Group(f"bed 1000, {name}", "bed", FEW_SHAPES[:2], law=law) for name, law in OTHER_LAWS.items()),
        Group("box of planes", "box", [SMOOTH], (2, 2), 1, 3),
        Group("mesh 10240", "mesh", [SMOOTH, multisphere(5)], (2, 2), 1, 3, cells=32),
        Group("mesh 100000", "mesh", [SMOOTH], (2, 2), 1, 3, cells=100),
        Group("aspect 10", "long", [SMOOTH, multisphere(27)], (2, 2), 1, 3, aspect=10.0),
        Group("aspect 20", "long", [SMOOTH], (2, 2), 1, 3, aspect=20.0),
        Group("two sizes", "sizes", [SMOOTH], (2, 2), 1, 3),
        Group("size 10000", "bed", FEW_SHAPES[:2], (5, 2), 1, 2),
        Group("size 100000", "bed", FEW_SHAPES[:2], (10, 10), 1, 2),
        Group("size 1000000", "bed", [SMOOTH], (40, 25), 1, 1),
    ]
    return {group.name: group for group in all_groups}


class Bench:
    """Makes the initial states once and runs the engine."""

    def __init__(self, engine, folder, compaction_time):
        self.engine, self.folder, self.compaction_time = engine, folder, compaction_time
        self.start_folder = folder / "start"
        self.start_folder.mkdir(parents=True, exist_ok=True)
        self.run_folder = folder / "run"
        self.run_folder.mkdir(exist_ok=True)
        self.empty_memory = 1024.0 * self.run("units si\n")[1].ru_maxrss

    # --- initial states --------------------------------------------------------------------
    def state(self, name, make):
        """The file `name` of the initial states, made by make(file) if it is not there."""
        file = self.start_folder / name
        if not file.exists():
            print(f"  (making {name})", flush=True)
            make(file)
        return file

    def compaction_start(self, shape):
        kind = "sphere" if shape.kind == "sphere" else "smooth"
        file = self.state(f"compaction.{kind}.data", lambda file: file.write_text(compaction(kind)))
        if shape.kind == "superquadric":
            write_superquadrics(file)
        return file

    def cloud(self, shape):
        per_side = round(COUNT ** (1.0 / 3.0))

        def make(file):
            particles, height = lattice(shape.start, per_side, COUNT, 3.2 * A)
            box = (0.0, per_side * 3.2 * A, 0.0, per_side * 3.2 * A, 0.0, height)
            file.write_text(data_file(shape.start, particles, box, 2))
        return self.state(f"cloud.{shape.start}.data", make)

    def bed(self, shape):
        if shape.kind == "rigid":
            return self.state(f"bed.{shape.start}.restart", lambda file: self.settle_rigid(shape, file))
        if shape.kind == "multisphere":  # in the places of settled ellipsoids they hardly touch: they settle again
            return self.state(f"bed.chain{shape.subspheres}.data", lambda file: self.finish(
                shape, settle(shape, "bed", self.bed(SMOOTH), SETTLING_STEPS // 2), file))
        return self.state(f"bed.{shape.start}.data", lambda file: self.settle_bed(shape, file))

    def settle_bed(self, shape, file):
        diameter = 2.0 * (VOLUME_RADIUS if shape.kind == "sphere" else A)
        per_side = int(SIDE / (1.02 * diameter))
        particles, height = lattice(shape.start, per_side, COUNT, SIDE / per_side)
        box = (0.0, SIDE, 0.0, SIDE, -A, height + 4.0 * A)
        loose = file.with_suffix(".loose")
        loose.write_text(data_file(shape.start, particles, box, 2))
        self.finish(start_shape(shape), settle(start_shape(shape), "bed", loose, SETTLING_STEPS), file)

    def flow(self, shape):
        """The settled bed, its lowest particles held, after it has flown down an incline."""
        def make(file):
            base = file.with_suffix(".base")
            at_rest(self.bed(start_shape(shape)), base, hold_below=2.0 * A)
            self.finish(start_shape(shape), settle(start_shape(shape), "flow", base, FLOWING_STEPS), file)
        return self.state(f"flow.{shape.start}.data", make)

    def box(self, shape):
        """Four times as many particles, at rest in a box with walls."""
        def make(file):
            per_side = int(BOX / (2.04 * A)) - 1
            particles, height = lattice(shape.start, per_side, 4 * COUNT, BOX / per_side)
            loose = file.with_suffix(".loose")
            loose.write_text(data_file(shape.start, particles, (0.0, BOX, 0.0, BOX, -A, height + 4.0 * A), 2))
            self.finish(start_shape(shape), settle(start_shape(shape), "box", loose, SETTLING_STEPS), file, BOX,
                        BOX + A)
        return self.state(f"box.{shape.start}.data", make)

    def mesh(self, cells):
        return self.state(f"box{cells}.stl", lambda file: file.write_text(box_mesh(BOX, BOX, cells)))

    def finish(self, shape, script, file, side=SIDE, height=0.0):
        """Runs `script` and writes its last frame as a data file, whose box has that height at least."""
        self.run(script)
        lines = (self.run_folder / "settled.dump").read_text().splitlines()
        count = int(lines[3])
        values = np.array([line.split() for line in lines[-count:]], float)
        quaternions = values[:, 11:15] if shape.kind != "sphere" else np.tile([1.0, 0, 0, 0], (count, 1))
        particles = bodies(shape.start, values[:, 2:5], quaternions, values[:, 5:8], values[:, 8:11],
                           values[:, 1])
        box = (0.0, side, 0.0, side, -A, max(height, values[:, 4].max() + 4.0 * A))
        file.write_text(data_file(shape.start, particles, box, 2))

    def settle_rigid(self, shape, file):
        chain = f"chain{shape.subspheres}"
        subprocess.run([str(self.engine.parent / "ellipsoid-post"), "template", "--aspect", repr(A / B),
                        "--b", repr(B), "--subspheres", str(shape.subspheres), "--multisphere", chain],
                       cwd=self.run_folder, check=True, capture_output=True)
        script = rigid_bodies(shape, COUNT, chain, 0.08)
        self.run(damped(script) + f"timestep 1e-5\nthermo 1000000\nrun {RIGID_SETTLING_STEPS}\n"
                 f"write_restart {file}\n")

    def poured(self, group, shape):
        """A settled bed of long bodies, or of two sizes; spheres of the same volumes."""
        sphere, side = shape.kind == "sphere", poured.side_of(group.case)
        name = "sizes" if group.case == "sizes" else "long" if sphere else f"aspect{group.aspect:g}"

        def make(file):
            count = group.particles if group.case == "sizes" else COUNT
            self.run(poured.pour(shape, poured.kinds(group.case, group.aspect), count, side))
            file.write_text(poured.data_of(self.run_folder / "settled.dump", shape, side, count))
        file = self.state(f"{name}.{shape.start}.data", make)
        if group.case == "sizes":
            return file
        return self.state(f"tiles{group.particles}.{file.name}", lambda target: tile(file, target, group.tiles, side))

    # --- runs ------------------------------------------------------------------------------
    def run(self, script, ranks=1):
        (self.run_folder / "in.run").write_text(script)
        return self.call(["-in", "in.run"], ranks)

    def call(self, arguments, ranks=1):
        """Runs the engine; returns its output and its use of resources."""
        command = ["mpirun", "-np", str(ranks)] if ranks > 1 else []
        with open(self.run_folder / "output", "w+") as output:
            process = subprocess.Popen(command + [str(self.engine)] + arguments, stdout=output,
                                       stderr=subprocess.STDOUT, cwd=self.run_folder)
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            output.seek(0)
            text = output.read()
        if process.returncode != 0:
            raise SystemExit(f"The engine failed in {self.run_folder}:\n{text[-2000:]}")
        return text, usage

    def sample(self, group, shape):
        if group.case == "compaction":
            return self.sample_compaction(group, shape)
        script, steps = self.script(group, shape)
        (self.run_folder / "clock.txt").unlink(missing_ok=True)
        text, usage = self.run(script, group.ranks)
        if group.ranks == 1:
            begin, end = map(float, (self.run_folder / "clock.txt").read_text().split())
            spent = end - begin
        else:
            spent = 1e9 * loop_times(text)[-1]
        return Sample(spent / (steps * group.particles), 1024.0 * usage.ru_maxrss - self.empty_memory)

    def script(self, group, shape):
        """Input script of a case in space, and the number of steps that it times."""
        steps = max(20, round(WORK[shape.kind] / group.particles))
        if group.particles > 200000:
            steps = 20
        warm = max(10, min(steps // 5, 200))
        if group.case in ("long", "sizes"):
            return poured.bed(shape, self.poured(group, shape), steps, warm), steps
        if group.case in ("box", "mesh"):
            mesh = self.mesh(group.cells) if group.cells else None
            return moving_bodies(shape, group.case, self.box(shape), mesh) + timed(steps, warm), steps
        start = {"bed": self.bed, "flow": self.flow, "cloud": self.cloud}[group.case](shape)
        if shape.kind == "rigid":
            return self.rigid_script(shape, start) + timed(steps, warm), steps
        if group.tiles != (1, 1):
            start = self.state(f"tiles{group.particles}.{start.name}",
                               lambda file: tile(start, file, group.tiles, SIDE))
        return with_law(moving_bodies(shape, group.case, start), group.law) + timed(steps, warm), steps

    def rigid_script(self, shape, start):
        """The host's rigid bodies, read from their restart file."""
        lines = rigid_bodies(shape, COUNT, "", 0.08).split("\n")
        head = lines[:next(k for k, line in enumerate(lines) if line.startswith("fix grain"))]
        head = [f"read_restart {start}" if line.startswith("region box") else line for line in head
                if not line.startswith("create_box")]
        return "\n".join(head) + "\nfix motion all multisphere\n"

    def compaction_arguments(self, shape, duration):
        arguments = ["-in", str(SOURCE / "inputs" / "compaction.in"), "-var", "shape", shape.kind,
                     "-var", "start", str(self.compaction_start(shape)),
                     "-var", "duration", repr(duration)]
        if shape.kind == "multisphere":
            arguments += ["-var", "subspheres", str(shape.subspheres),
                          "-var", "contacts", str(shape.contacts)]
        return arguments

    def sample_compaction(self, group, shape):
        text, usage = self.call(self.compaction_arguments(shape, self.compaction_time), group.ranks)
        steps = round(self.compaction_time / 5e-6)
        spent = usage.ru_utime + usage.ru_stime if group.ranks == 1 else loop_times(text)[-1]
        sample = Sample(1e9 * spent / (steps * COUNT), 1024.0 * usage.ru_maxrss)
        sample.figures = thermo_means(text)
        return sample


def start_shape(shape):
    return SPHERE if shape.kind == "sphere" else SMOOTH


def at_rest(source, target, hold_below):
    """Copies a data file; particles below a height (m) get type 2."""
    lines, section = [], ""
    for line in source.read_text().split("\n"):
        section = line if line in ("Atoms", "Velocities") else section
        words = line.split()
        if section == "Atoms" and len(words) > 5:
            z = float(words[6] if len(words) == 7 else words[4])
            line = " ".join([words[0], "2" if z < hold_below else "1"] + words[2:])
        lines.append(line)
    target.write_text("\n".join(lines))


def loop_times(text):
    return [float(t) for t in re.findall(r"Loop time of (\S+) on", text)]


def thermo_means(text):
    """Means over time of the compaction's thermo columns: touching pairs and tests per particle."""
    text = "\n".join(line for line in text.splitlines() if not line.startswith("WARNING")) + "\n"
    tables = re.findall(r"Step\s+time\s+KinEng\s+touching\s+potentia\S*\s+CPU[^\n]*\n((?:[ \t]*[-\d].*\n)+)",
                        text)
    if not tables:
        return {}
    rows = np.array([[float(v) for v in line.split()] for line in tables[-1].strip().split("\n")])
    return {"touching": rows[1:, 3].mean(), "potential": rows[1:, 4].mean()}


# --- measuring and telling ---------------------------------------------------------------------
def measure(bench, group, repeats):
    """{shape name: ([ns per particle and step], [ratio to spheres], last Sample)}."""
    results = {}

    def note(shape, sample, ratio):
        costs, ratios, _ = results.setdefault(shape.name, ([], [], None))
        costs.append(sample.cost)
        ratios.append(ratio)
        results[shape.name] = (costs, ratios, sample)

    for repeat in range(min(repeats, group.most_repeats)):
        shapes = [s for s in group.shapes if repeat == 0 or s.kind not in MEASURED_ONCE]
        before = bench.sample(group, SPHERE)
        note(SPHERE, before, 1.0)
        for first in range(0, len(shapes), SPHERES_EVERY):
            some = shapes[first:first + SPHERES_EVERY]
            samples = [bench.sample(group, shape) for shape in some]
            after = bench.sample(group, SPHERE)
            note(SPHERE, after, 1.0)
            reference = 0.5 * (before.cost + after.cost)
            for shape, sample in zip(some, samples):
                note(shape, sample, sample.cost / reference)
            before = after
    return results


COLUMNS = ("case", "shape", "ranks", "particles", "ns per particle and step", "spread %",
           "ratio to spheres", "lowest", "highest", "potential contacts", "kB per particle")


def rows_of(group, results):
    """Table rows, in the order of COLUMNS; memory is that beyond what an empty engine needs."""
    for name, (costs, ratios, sample) in results.items():
        median = statistics.median(costs)
        spread = 50.0 * (max(costs) - min(costs)) / median
        potential = sample.figures.get("potential")
        yield (group.name, name, group.ranks, group.particles, f"{median:.0f}", f"{spread:.0f}",
               f"{statistics.median(ratios):.2f}", f"{min(ratios):.2f}", f"{max(ratios):.2f}",
               "" if potential is None else f"{potential:.1f}",
               f"{sample.memory / group.particles / 1000.0:.2f}" if group.particles >= 4000 else "")


#: what is wanted: (name, (case, shape) of the cost, (case, shape) that it is divided by, bound, aim)
TARGETS = (
    ("smooth, settled bed, to spheres", ("bed 30000", "smooth"), ("bed 30000", "sphere"), "<= 2.0", 1.0),
    ("smooth, compaction, to spheres", ("compaction", "smooth"), ("compaction", "sphere"), "<= 1.8", 1.0),
    ("N = 3, compaction, to spheres", ("compaction", "multisphere 3"), ("compaction", "sphere"),
     "<= 1.8", 1.2),
    ("N = 17, compaction, to spheres", ("compaction", "multisphere 17"), ("compaction", "sphere"),
     "<= 4.0", 2.5),
    ("rigid bodies of 17 to N = 17, bed of 1000", ("bed 1000", "rigid 17"),
     ("bed 1000", "multisphere 17"), ">= 10", 20.0),
    ("N = 55 to N = 5, compaction", ("compaction", "multisphere 55"), ("compaction", "multisphere 5"),
     "< 11", 1.0),
    ("aspect 10, lists every 20 steps, to spheres", ("aspect 10", "smooth"), ("aspect 10", "sphere"), "<= 2.5", 1.5),
    ("aspect 20, lists every 20 steps, to spheres", ("aspect 20", "smooth"), ("aspect 20", "sphere"), "<= 3.5", 2.0),
    ("two sizes 1:10, lists every 20 steps, to spheres", ("two sizes", "smooth"), ("two sizes", "sphere"), "<= 1.3",
     1.0),
    ("smooth, box of 10,240 triangles, to spheres", ("mesh 10240", "smooth"), ("mesh 10240", "sphere"),
     "<= 1.5", 1.0),
    ("smooth, box of 100,000 triangles, to spheres", ("mesh 100000", "smooth"), ("mesh 100000", "sphere"),
     "<= 1.0", 0.5),
    ("one rank to two, smooth, 30,000", ("bed 30000", "smooth"), ("bed 30000, 2 ranks", "smooth"),
     ">= 1.7", 1.9),
    *((f"smooth, {law}, bed of 1000, to spheres", (f"bed 1000, {law}", "smooth"), (f"bed 1000, {law}", "sphere"),
       bound, aim) for law, bound, aim in (("hertz", "<= 1.25", 1.0), ("hertz, cdt", "<= 1.4", 1.1),
                                           ("hertz, epsd2", "<= 1.4", 1.1), ("hertz, sjkr2, cdt", "<= 1.5", 1.1))),
)


def targets(rows):
    """Table of those targets whose runs are there."""
    costs = {(row[0], row[1]): float(row[4]) for row in rows}
    memory = {(row[0], row[1]): row[10] for row in rows}
    lines = ["| target | at least | aim | measured |", "|---|---|---|---|"]
    for name, of, to, bound, aim in TARGETS:
        if of in costs and to in costs:
            lines.append(f"| {name} | {bound} | {aim} | {costs[of] / costs[to]:.2f} |")
    for case, name, bound, aim in (("aspect 10", "4000 of aspect 10", 6, 4), ("aspect 20", "4000 of aspect 20", 8, 5),
                                   ("size 1000000", "10^6 smooth", 2.2, 1.5)):
        if (case, "smooth") in memory:
            lines.append(f"| memory per particle, {name} (kB) | <= {bound} | {aim} | {memory[case, 'smooth']} |")
    return "\n".join(lines)


def markdown(rows):
    table = [COLUMNS, ["---"] * len(COLUMNS)] + list(rows)
    return "\n".join("| " + " | ".join(map(str, row)) + " |" for row in table)


def arguments_of(all_groups):
    parser = argparse.ArgumentParser(
        prog="bash tests/bench/run.sh", description="Costs of all shapes, side by side.",
        epilog="Cases: " + "; ".join(all_groups))
    parser.add_argument("--short", action="store_true",
                        help="a minute or two: smooth, N = 3 and 17; compaction and bed of 1000")
    parser.add_argument("--cases", help="some of the cases, as a regular expression")
    parser.add_argument("--shapes", help="some of the shapes, as a regular expression")
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--compaction-time", type=float, default=0.5,
                        help="duration of the wall's way (s): the paper's; a shorter one is a faster wall")
    parser.add_argument("--where", action="store_true",
                        help="where time goes, by sampling (perf), instead of the table")
    parser.add_argument("--instructions", action="store_true",
                        help="instructions per particle and step (valgrind), instead of the table")
    parser.add_argument("--against", type=Path, metavar="ENGINE",
                        help="costs over those of another engine, run in turns, instead of the table")
    parser.add_argument("--engine", type=Path, required=True)
    parser.add_argument("--out", type=Path, required=True)
    return parser.parse_args()


def choose(arguments, all_groups):
    """The groups to run, with the shapes to run."""
    cases, shapes = arguments.cases, arguments.shapes
    if arguments.short:
        cases, shapes = cases or "^compaction$|^bed 1000$", shapes or "^smooth$|^multisphere (3|17)$"
    chosen = []
    for group in all_groups.values():
        if cases and not re.search(cases, group.name):
            continue
        group.shapes = [s for s in group.shapes if not shapes or re.search(shapes, s.name)]
        chosen.append(group)
    if not chosen:
        raise SystemExit(f"No case matches '{cases}'; the cases are: {'; '.join(all_groups)}")
    return chosen


def main():
    all_groups = groups()
    arguments = arguments_of(all_groups)
    chosen = choose(arguments, all_groups)
    bench = Bench(arguments.engine.resolve(), arguments.out.resolve(), arguments.compaction_time)
    print(description(arguments.engine), flush=True)
    if arguments.where or arguments.instructions:
        report = where.report(bench, chosen, arguments.instructions)
        print(report)
        (arguments.out / "where.md").write_text(report + "\n")
        return
    if arguments.against:
        table = two_engines.report(bench, chosen, arguments.against.resolve(), arguments.repeats)
        (arguments.out / "against.md").write_text(f"{description(arguments.engine)}\nThe other engine: "
                                                  f"{arguments.against}\n\n{table}\n")
        return
    rows, begin = [], time.time()
    repeats = 1 if arguments.short else arguments.repeats
    for group in chosen:
        print(f"\n{group.name}", flush=True)
        results = measure(bench, group, repeats)
        if group.name == CASE:
            write_figures(arguments.out / "figures.csv", figure_rows(results))
        new = list(rows_of(group, results))
        for row in new:
            print(f"  {row[1]:16s} {row[4]:>8s} ns  {row[6]:>6s} ({row[7]} to {row[8]})  {row[9]}", flush=True)
        rows += new
        write(arguments, rows, time.time() - begin)
    print(f"\nTable in {arguments.out}/table.md and table.csv")


def write(arguments, rows, seconds):
    text = (description(arguments.engine) + f"\nRepeats: {arguments.repeats}; compaction in "
            f"{arguments.compaction_time} s; measured in {seconds / 60.0:.0f} min\n\n" + markdown(rows)
            + "\n\n" + targets(rows))
    (arguments.out / "table.md").write_text(text + "\n")
    with open(arguments.out / "table.csv", "w", newline="") as file:
        csv.writer(file).writerows([COLUMNS] + rows)


if __name__ == "__main__":
    main()
