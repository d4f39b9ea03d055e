"""Time of a step of the common benchmark (inputs/benchmark_*.in): spheres of the host, the same spheres as ellipsoids, and
ellipsoids of the same volume, in turns, each from its own packing. Prints ns of processor time per particle and step and
the ratio to the host's spheres: the median over the turns, the lowest and the highest.

    python3 tests/bench/common_benchmark.py --engine build/bin/liggghts --out out/common [--cases silo] [--turns 5]

The packings are made first where OUT has none, which takes most of the time.
"""

import argparse
import os
import statistics
import subprocess
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
CLOCK = ROOT / "tests" / "bench" / "clock.sh"
SHAPES = ("sphere_host", "sphere", "ellipsoid")


@dataclass(frozen=True)
class Case:
    """How an input is run for a time of its process: variables, the name of the process and of its time."""

    part: str
    duration: str  # variable
    start: float  # s of the process before steps are timed
    variables: dict


CASES = {
    "silo": Case("flow", "flow", 0.02, {"particles": 10000}),
    "drum": Case("turn", "turn", 0.05, {"width": 0.03, "size": 2.0}),
    "penetration": Case("impact", "time", 0.0235, {"particles": 10000, "length": 0.062, "breadth": 0.038,
                                                  "soften": 25, "skip": 0.0225}),
}


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
    settings = {**case.variables, "shape": shape, "aspect": aspect, "out": folder}
    if "length" not in settings:
        settings["meshes"] = ROOT / "inputs" / "meshes"
    return settings


def timed(engine, name, case, shape, folder, aspect, steps):
    """ns per particle and step from the packing in `folder`, and the number of particles."""
    clock = folder / "clock.txt"
    clock.unlink(missing_ok=True)
    settings = {**variables_of(case, shape, folder, aspect), "part": case.part, case.duration: case.start}
    text = run(engine, settings, name, folder, f"""undump frames
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
    case, folders = CASES[name], {}
    for shape in SHAPES:
        folders[shape] = (out / f"{name}_{shape}").resolve()
        folders[shape].mkdir(parents=True, exist_ok=True)
        if not (folders[shape] / "filled.restart").exists():
            run(engine, {**variables_of(case, shape, folders[shape], aspect), "part": "fill"}, name, folders[shape])
    costs, counts = {shape: [] for shape in SHAPES}, {}
    for _ in range(turns):
        for shape in SHAPES:
            cost, counts[shape] = timed(engine, name, case, shape, folders[shape], aspect, steps)
            costs[shape].append(cost)
    for shape in SHAPES:
        ratios = [cost / host for cost, host in zip(costs[shape], costs["sphere_host"])]
        print(f"| {name} | {shape} | {counts[shape]:.0f} | {statistics.median(costs[shape]):.0f} | "
              f"{statistics.median(ratios):.2f} ({min(ratios):.2f} to {max(ratios):.2f}) |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--engine", type=Path, required=True)
    parser.add_argument("--out", type=Path, required=True, help="folder of the packings")
    parser.add_argument("--cases", nargs="+", choices=sorted(CASES), default=list(CASES))
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
