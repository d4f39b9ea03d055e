"""Where time goes: samples of the engine's functions (perf), or its instructions (valgrind)."""

import re
import subprocess
import tempfile
from pathlib import Path

from scripts import SPHERE

#: part of the work: what the names of its functions look like; the first match counts
PARTS = (
    ("contact law", r"tangential_force|advance_spring|add_contact_force|TangentialModel|NormalModel|"
                    r"surfacesIntersectNonSpherical|\blaw_|ContactLawBatch|PairForces|HostModelsOf"),
    ("contact geometry", r"ellipsoid::(?!.*(?:rotat|turn|angular|inertia|Rotation))|SurfaceMotions|"
                         r"EllipsoidShapes|"
                         r"MathExtraLiggghtsNonspherical|SurfaceModel<|MultisphereParticles|"
                         r"update_shapes|\bSuperquadric::"),
    ("walls", r"[Ww]all|Primitive"),
    ("pair loop", r"SmoothContacts|MultisphereContacts|NeighbourPairs|PairStyles::Granular|PairGran|compute_force"),
    ("pair search", r"[Nn]eigh|FixContactHistory|pbc"),
    ("integration", r"FixNVE|FixMultisphere|[Mm]ultisphere|FixGravity|ellipsoid::"),
    ("communication", r"Comm\w*::|pack_|unpack_|MPI|AtomVec|mca_|opal_|ompi_"),
)
FEW, MANY = 100, 300  # steps of the two runs whose instructions are subtracted


def part_of(symbol):
    return next((name for name, pattern in PARTS if re.search(pattern, symbol)), "other")


def sampled(bench, group, shape):
    """{part: ns per particle and step}, and {function: the same}."""
    script, steps = bench.script(group, shape)
    (bench.run_folder / "in.where").write_text(script)
    (bench.run_folder / "clock.txt").unlink(missing_ok=True)
    data = bench.run_folder / "perf.data"
    subprocess.run(["perf", "record", "-q", "-e", "cpu-clock:u", "-F", "1999", "-o", str(data),
                    str(bench.engine), "-in", "in.where"], cwd=bench.run_folder, check=True,
                   stdout=subprocess.DEVNULL)
    begin, end = map(float, (bench.run_folder / "clock.txt").read_text().split())
    cost = (end - begin) / (steps * group.particles)
    text = subprocess.run(["perf", "report", "-i", str(data), "--stdio", "-g", "none", "--sort", "symbol",
                           "-q"], capture_output=True, text=True, check=True).stdout
    functions = {}
    for share, symbol in re.findall(r"^\s*([\d.]+)%\s+\[.\]\s+(.+?)(?:\s+-)*\s*$", text, re.M):
        functions[symbol] = functions.get(symbol, 0.0) + 0.01 * cost * float(share)
    parts = {}
    for symbol, value in functions.items():
        parts[part_of(symbol)] = parts.get(part_of(symbol), 0.0) + value
    return parts, functions


def instructions(bench, group, shape):
    """Instructions per particle and step, of the whole engine."""
    counts = []
    for steps in (FEW, MANY):
        script, planned = bench.script(group, shape)
        script = re.sub(rf"run {planned} pre no", f"run {steps} pre no", script)
        (bench.run_folder / "in.where").write_text(script.replace("shell sh", "# shell sh"))
        with tempfile.NamedTemporaryFile(dir=bench.run_folder) as out:
            text = subprocess.run(
                ["valgrind", "--tool=callgrind", f"--callgrind-out-file={out.name}", str(bench.engine),
                 "-in", "in.where"], cwd=bench.run_folder, capture_output=True, text=True).stderr
        counts.append(int(re.search(r"Collected : (\d+)", text).group(1)))
    return (counts[1] - counts[0]) / ((MANY - FEW) * group.particles)


def report(bench, groups, count_instructions):
    lines = []
    names = [name for name, _ in PARTS] + ["other"]
    for group in (g for g in groups if g.case != "compaction" and g.ranks == 1):
        if count_instructions:
            lines += [f"\n{group.name}: instructions per particle and step", "", "| shape | instructions |",
                      "|---|---|"]
            lines += [f"| {s.name} | {instructions(bench, group, s):.0f} |" for s in [SPHERE] + group.shapes]
            continue
        lines += [f"\n{group.name}: ns per particle and step", "", "| shape | " + " | ".join(names) + " |",
                  "|" + "---|" * (len(names) + 1)]
        for shape in [SPHERE] + group.shapes:
            parts, functions = sampled(bench, group, shape)
            lines.append(f"| {shape.name} | " + " | ".join(f"{parts.get(n, 0.0):.0f}" for n in names) + " |")
            first = sorted(functions.items(), key=lambda item: -item[1])[:12]
            (Path(bench.folder) / f"functions.{group.name}.{shape.name}.txt".replace(" ", "_")).write_text(
                "\n".join(f"{value:8.1f} ns  {part_of(name):18s} {name}" for name, value in first) + "\n")
    return "\n".join(lines)
