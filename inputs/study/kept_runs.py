"""The runs that are kept in inputs/results: their list runs.csv, and how finished runs get there."""

import csv
import lzma
import re
from pathlib import Path

COLUMNS = ("run", "law", "time_step_s", "surface", "subspheres", "seed", "commit", "run_time_s", "file")


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
    rows = sorted(rows, key=lambda r: (r["law"], int(r["subspheres"] or 0), int(r["seed"]), r["run"]))
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


def run_time(text):
    """Seconds of all parts of a run: each `run` of the log ends with its own."""
    return sum(float(t) for t in re.findall(r"^Loop time of (\S+) on", text, re.MULTILINE))


def row_of(folder, text, commit):
    """What the log of a finished run tells of it."""
    surface = wanted(r"^pair_style\s+gran/ellipsoid .* surface (\w+)", text, "surface")
    row = {"law": wanted(r"^pair_style\s+gran/ellipsoid .* direction (\w+)", text, "direction"),
           "time_step_s": wanted(r"^timestep\s+([\d.e+-]+)\s*$", text, "time step"),
           "surface": surface,
           "subspheres": "" if surface == "smooth" else wanted(r" subspheres (\d+) ", text, "sub-spheres"),
           "seed": wanted(r"insert/drop seed (\d+) ", text, "seed"),
           "commit": commit, "run_time_s": f"{run_time(text):.0f}"}
    shape = "smooth" if surface == "smooth" else f"ms{row['subspheres']}"
    row["run"] = f"{row['law']}_{shape}_seed{row['seed']}"
    row["file"] = f"{row['run']}/pile.dump.xz"
    return row


def add(results, folder, commit):
    """Takes every finished run below `folder` that is not kept yet; returns their names."""
    rows = read_list(results)
    added = []
    for table in sorted(Path(folder).glob("*/pile.csv")):
        text = (table.parent / "log.piling").read_text()
        row = row_of(table.parent, text, commit)
        if any(r["run"] == row["run"] for r in rows):
            continue
        if "Loop time of" not in text.rpartition("restart.end")[0]:
            raise SystemExit(f"study.sh: {table.parent} did not come to its end")
        last = max(table.parent.glob("pile.*.dump"))
        file = results / row["file"]
        file.parent.mkdir(exist_ok=True)
        file.write_bytes(lzma.compress(last.read_bytes(), preset=9 | lzma.PRESET_EXTREME))
        rows.append(row)
        added.append(row["run"])
    write_list(results, rows)
    return added
