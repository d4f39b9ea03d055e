"""Time of a step of the common benchmark (inputs/benchmark_*.in): spheres of the host, the same spheres as ellipsoids, and
ellipsoids of the same volume, in turns, each from its own packing. Prints ns of processor time per particle and step and
the ratio to the host's spheres: the median over the turns, the lowest and the highest.

    python3 tests/bench/common_benchmark.py --engine build/bin/liggghts --out out/common [--cases silo] [--turns 5]

The packings are made first where OUT has none, which takes most of the time: a quarter of an hour for each of those in full.
drum_fine has the packings of drum_full, and walls of 87,000 triangles instead of 400.
"""

import argparse
import os
import statistics
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
CLOCK = ROOT / "tests" / "bench" / "clock.sh"
SHAPES = ("sphere_host", "sphere", "ellipsoid")


@dataclass(frozen=True)
class Case:
    """How an input is run for a time of its process: its name and that of its packings, variables, the name of the process
    and of its time."""

    name: str
    packing: str
    part: str
    duration: str  # variable
    start: float  # s of the process before steps are timed
    variables: dict
    edge: float = 0.0  # m, of a fine mesh's triangles; 0: the meshes of the input


CASES = {
    "silo": Case("silo", "silo", "flow", "flow", 0.02, {"particles": 10000}),
    "silo_full": Case("silo", "silo_full", "flow", "flow", 0.02, {"particles": 100000, "soften": 200, "fill": 0.6}),
    "drum": Case("drum", "drum", "turn", "turn", 0.05, {"width": 0.03, "size": 2.0}),
    "drum_full": Case("drum", "drum_full", "turn", "turn", 0.01, {"width": 0.06}),
    "drum_fine": Case("drum", "drum_full", "turn", "turn", 0.002, {"width": 0.06}, edge=1.5e-3),
    "penetration": Case("penetration", "penetration", "impact", "time", 0.0235,
                        {"particles": 10000, "length": 0.062, "breadth": 0.038, "soften": 25, "skip": 0.0225}),
}
SHORT = ("silo", "drum", "penetration")


def run(engine, variables, name, folder, more=""):
    """Runs an input of the benchmark, and lines behind it, in `folder`; the engine's output."""
    lines = "".join(f"variable {key} index {value}\n" for key, value in variables.items())
    script = folder / "in.run"
    script.write_text(f"{lines}include {ROOT}/inputs/benchmark_{name}.in\n{more}")
    done = subprocess.run([engine, "-in", script, "-log", "none"], capture_output=True, text=True, cwd=folder)
    if done.returncode != 0:
        raise SystemExit(f"{script} failed:\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
    return done.stdout


def variables_of(case, shape, folder, aspect):
    return {**case.variables, "shape": shape, "aspect": aspect, "out": folder, "meshes": ROOT / "inputs" / "meshes"}


def fine_meshes(out, edge):
    """The folder of the drum's walls with short edges, made where it is missing."""
    folder = out.resolve() / f"meshes_{edge:g}"
    if not folder.exists():
        folder.mkdir(parents=True)
        subprocess.run([sys.executable, ROOT / "inputs" / "meshes" / "make_meshes.py", "--edge", str(edge)],
                       check=True, cwd=folder)
    return folder


def timed(engine, case, shape, folder, settings, steps):
    """ns per particle and step from the packing in `folder`, and the number of particles."""
    clock = folder / "clock.txt"
    clock.unlink(missing_ok=True)
    settings = {**settings, "part": case.part, case.duration: case.start}
    text = run(engine, settings, case.name, folder, f"""undump frames
thermo 1000000
run 20
shell sh {CLOCK} {clock}
run {steps} pre no
shell sh {CLOCK} {clock}
variable number equal atoms
print "number of particles: ${{number}}"
""")
    begin, end = map(float, clock.read_text().split())
    count = float(text.rsplit("number of particles: ", 1)[1].split()[0])
    return (end - begin) / (steps * count), count


def measure(engine, name, out, aspect, turns, steps):
    case = CASES[name]
    folders = {shape: (out / f"{case.packing}_{shape}").resolve() for shape in SHAPES}
    settings = {shape: variables_of(case, shape, folders[shape], aspect) for shape in SHAPES}
    for shape in SHAPES:
        folders[shape].mkdir(parents=True, exist_ok=True)
        if not (folders[shape] / "filled.restart").exists():
            run(engine, {**settings[shape], "part": "fill"}, case.name, folders[shape])
        if case.edge:
            settings[shape] |= {"meshes": fine_meshes(out, case.edge), "walls": "fine"}
    costs, counts = {shape: [] for shape in SHAPES}, {}
    for _ in range(turns):
        for shape in SHAPES:
            cost, counts[shape] = timed(engine, case, shape, folders[shape], settings[shape], steps)
            costs[shape].append(cost)
    for shape in SHAPES:
        ratios = [cost / host for cost, host in zip(costs[shape], costs["sphere_host"])]
        print(f"| {name} | {shape} | {counts[shape]:.0f} | {statistics.median(costs[shape]):.0f} | "
              f"{statistics.median(ratios):.2f} ({min(ratios):.2f} to {max(ratios):.2f}) |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--engine", type=Path, required=True)
    parser.add_argument("--out", type=Path, required=True, help="folder of the packings")
    parser.add_argument("--cases", nargs="+", choices=sorted(CASES), default=SHORT)
    parser.add_argument("--aspect", type=float, default=1.5)
    parser.add_argument("--turns", type=int, default=5)
    parser.add_argument("--steps", type=int, default=300, help="that are timed")
    options = parser.parse_args()
    for name in ("OMPI_MCA_hwloc_base_binding_policy", "PRTE_MCA_hwloc_default_binding_policy"):
        os.environ.setdefault(name, "none")
    print("| case | shape | particles | ns per particle and step | ratio to the host's spheres |\n|---|---|---|---|---|")
    for name in options.cases:
        measure(options.engine.resolve(), name, options.out, options.aspect, options.turns, options.steps)


if __name__ == "__main__":
    main()
