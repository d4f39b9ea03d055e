"""The runs that are kept in inputs/results: their list runs.csv, and how finished runs get there."""

import csv
import lzma
import re
import subprocess
from pathlib import Path

COLUMNS = ("run", "law", "time_step_s", "variant", "surface", "subspheres", "seed", "commit", "run_time_s", "file")
NUMBER = r"([\d.e+-]+)"
LAST_DROP, END = 40.0, 50.0  # s: of the paper, and when it measures
SERIES = ("timestep", "repose_angle_deg", "repose_angle_standard_error_deg", "porosity", "zpp", "largest_speed_m_per_s")
# what a run of the paper's matrix has; a run with other values is a variant of it
PAPER_VALUES = {"friction": (rf"coefficientFriction peratomtypepair 1 {NUMBER}\s*$", 0.3),
                "normal damping": (rf"viscousDampingNormal peratomtypepair 1 {NUMBER}\s*$", 100.0),
                "tangential damping": (rf"viscousDampingTangential peratomtypepair 1 {NUMBER}\s*$", 100.0),
                "modulus": (rf"youngsModulus peratomtype {NUMBER}\s*$", 183e6),
                "particles": (rf"insert/drop .* particles {NUMBER} ", 1000.0),
                "interval": (rf"insert/drop .* interval {NUMBER} ", 0.04)}
PAPER_STEPS = {"displacement": 5e-6, "velocity": 2e-6}
PAPER_ASPECT = 2.7 / 1.15


def read_list(results):
    """Rows of runs.csv; kind: number of sub-spheres, 0 for smooth."""
    if not (results / "runs.csv").is_file():
        raise SystemExit(f"study.sh: there is no list of runs {results / 'runs.csv'}; correct --results")
    with open(results / "runs.csv", newline="") as stream:
        rows = list(csv.DictReader(stream))
    for row in rows:
        row["kind"] = int(row["subspheres"] or 0)
    return rows


def write_list(results, rows):
    rows = sorted(rows, key=lambda r: (r["law"], r["variant"], int(r["subspheres"] or 0), int(r["seed"]), r["run"]))
    with open(results / "runs.csv", "w", newline="") as stream:
        writer = csv.DictWriter(stream, COLUMNS, lineterminator="\n", extrasaction="ignore")
        writer.writeheader()
        writer.writerows(rows)


def wanted(pattern, text, what):
    """The last match in a log, where a run that was resumed has several."""
    found = re.findall(pattern, text, re.MULTILINE)
    if not found:
        raise SystemExit(f"study.sh: the log has no {what}; the run was not one of piling.in")
    return found[-1]


def value(text, name):
    """Of one of PAPER_VALUES."""
    return float(wanted(PAPER_VALUES[name][0], text, name))


def run_time(text):
    """Seconds of all parts of a run: each `run` of the log ends with its own."""
    return sum(float(t) for t in re.findall(r"^Loop time of (\S+) on", text, re.MULTILINE))


def variant_of(text, law, time_step):
    """What a run has otherwise than those of the paper's matrix, in words; '' for one of them."""
    words = []
    if float(time_step) != PAPER_STEPS[law]:
        words.append(f"time step {time_step} s")
    a, b = map(float, wanted(rf"semiaxes {NUMBER} {NUMBER} {NUMBER} mass", text, "semi-axes")[:2])
    if abs(a / b / PAPER_ASPECT - 1.0) > 1e-3:
        words.append(f"a/b {a / b:.4g}")
    for name, (_, of_paper) in PAPER_VALUES.items():
        if value(text, name) != of_paper:
            words.append(f"{name} {value(text, name):g}")
    if not re.search(r"^fix\s+wall .* tangential ", text, re.MULTILINE):
        words.append("smooth side wall")
    if re.search(r"^fix\s+glue ", text, re.MULTILINE):
        words.append("glued ground")
    return ", ".join(words)


def row_of(text, commit):
    """What the log of a finished run tells of it."""
    surface = wanted(r"^pair_style\s+gran/ellipsoid .* surface (\w+)", text, "surface")
    law = wanted(r"^pair_style\s+gran/ellipsoid .* direction (displacement|velocity)", text, "direction")
    time_step = wanted(rf"^timestep\s+{NUMBER}\s*$", text, "time step")
    row = {"law": law, "time_step_s": time_step, "variant": variant_of(text, law, time_step), "surface": surface,
           "subspheres": "" if surface == "smooth" else wanted(r" subspheres (\d+) ", text, "sub-spheres"),
           "seed": wanted(r"insert/drop seed (\d+) ", text, "seed"),
           "commit": commit, "run_time_s": f"{run_time(text):.0f}"}
    row["kind"] = int(row["subspheres"] or 0)
    shape = "smooth" if surface == "smooth" else f"ms{row['subspheres']}"
    changed = re.sub(r"[^\w.+-]+", "_", row["variant"])
    row["run"] = "_".join(filter(None, (law, changed, shape, f"seed{row['seed']}")))
    row["file"] = f"{row['run']}/pile.dump.xz"
    return row


def frames_of(folder, time_step):
    """{time in s: dump} of a run."""
    return {int(dump.name.split(".")[1]) * float(time_step): dump for dump in sorted(folder.glob("pile.*.dump"))}


def keep_series(tools, frames, file):
    """The pile's measures in each of the frames, as a table."""
    table = file.with_suffix(".all")
    subprocess.run([tools, "pile", *frames, "--one-run", "--frame", "all", "--quiet", "--csv", table], check=True,
                   stdin=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    with open(table, newline="") as stream:
        rows = list(csv.DictReader(stream))
    table.unlink()
    with open(file, "w", newline="") as stream:
        writer = csv.DictWriter(stream, SERIES, lineterminator="\n", extrasaction="ignore")
        writer.writeheader()
        writer.writerows(rows)


def add(results, folder, commit, tools):
    """Takes every finished run below `folder` that is not kept yet; returns their names. Kept are the pile as it was when
    the paper measures, or at the end of a shorter run, and its measures from the last drop on."""
    rows = read_list(results)
    added = []
    for table in sorted(Path(folder).glob("*/pile.csv")):
        text = (table.parent / "log.piling").read_text()
        row = row_of(text, commit)
        if any(r["run"] == row["run"] for r in rows):
            continue
        if "Loop time of" not in text.rpartition("restart.end")[0]:
            raise SystemExit(f"study.sh: {table.parent} did not come to its end")
        frames = frames_of(table.parent, row["time_step_s"])
        half = 0.5 * float(row["time_step_s"])
        last_drop = value(text, "particles") * value(text, "interval")
        if abs(last_drop - LAST_DROP) < half and max(frames) < END - half:
            raise SystemExit(f"study.sh: {table.parent} ends at {max(frames):g} s, the paper measures at {END:g} s; "
                             "let it go on, or take it away")
        file = results / row["file"]
        file.parent.mkdir(exist_ok=True)
        pile = frames[max(t for t in frames if t < END + half)]
        file.write_bytes(lzma.compress(pile.read_bytes(), preset=9 | lzma.PRESET_EXTREME))
        keep_series(tools, [frames[t] for t in sorted(frames) if t > last_drop - half], file.parent / "series.csv")
        rows.append(row)
        added.append(row["run"])
    write_list(results, rows)
    return added
