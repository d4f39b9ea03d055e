"""The paper's study from the runs that are kept: tables, figures, statements."""

import argparse
import csv
import os
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import numpy  # noqa: F401
except ImportError:
    sys.exit("study.sh: python3 lacks numpy; install it (Debian: python3-numpy)")

import tables
from creep import creep_table
from fits import scan, surface_of
from heaps import heap_table, read_heaps
from kept_runs import add, read_list
from piles import read_pile
from porosities import porosities
from variants import aspect_table, sensitivity_table

ROOT = Path(__file__).resolve().parent.parent.parent


def targets():
    """{name below --out: file of the tree} that the study writes its tables to."""
    return {"study.md": ROOT / "src_liggghts" / "doc" / "study.md",
            "study_values.h": ROOT / "postprocess" / "measures" / "templates" / "study_values.h"}


def tool(tools, *words):
    subprocess.run([str(w) for w in (tools, *words)], check=True, stdin=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def measured(tools, results, tables_of_runs, row):
    """A kept run with its measures; one of the paper's matrix with the scan of its fit and the readings of its porosity."""
    file = results / row["file"]
    table = tables_of_runs / f"{row['run']}.csv"
    tool(tools, "pile", file, "--quiet", "--csv", table)
    with open(table, newline="") as stream:
        row |= {k: v for k, v in next(csv.DictReader(stream)).items() if k not in row}
    if row["variant"]:
        return row
    if row["kind"]:
        tool(tools, "pile", file, "--outline", "ellipse", "--quiet", "--csv",
             tables_of_runs / f"{row['run']}_ellipse.csv")
    pile = read_pile(tools, file)
    surface = surface_of(pile)
    return {**row, "scan": scan(surface), "porosities": porosities(pile, surface)}


def draw(tools, results, out, tables_of_runs, law, runs):
    """Figures 12, 13 and 15 of a law; of 10, 11 and 14 what there is."""
    names = [name for r in runs for name in (f"{r['run']}.csv", f"{r['run']}_ellipse.csv")]
    files = [tables_of_runs / name for name in names if (tables_of_runs / name).is_file()]
    numbers = [12, 13] + ([15] if any(r["kind"] == 0 for r in runs) else [])
    for number in numbers:
        tool(tools, "plot", number, *files, "-o", out / f"figure{number}_{law}.png")
    smooth = sorted((r for r in runs if r["kind"] == 0), key=lambda r: float(r["repose_angle_deg"]))
    wanted = {"figure10a": smooth[:1], "figure10b": smooth[-1:],
              "figure11a": [r for r in runs if r["kind"] == 5][:1],
              "figure11b": [r for r in runs if r["kind"] == 17][:1]}
    for name, chosen in wanted.items():
        for r in chosen:
            tool(tools, "render", results / r["file"], "-o", out / f"{name}_{law}.png", "--width", 900)
    for name, chosen in ("figure14a", smooth[:1]), ("figure14b", wanted["figure11a"]):
        for r in chosen:
            tool(tools, "render", results / r["file"], "-o", out / f"{name}_{law}.png", "--width", 600, "--no-fit",
                 "--discs", "--view", 0.02, 0.05, 0.0, 0.02)


def parts_of(runs, results):
    """{name of the marks: table}."""
    parts = {"runs": tables.run_table(runs), "creep": creep_table(runs, results),
             "sensitivity": sensitivity_table(runs), "aspects": aspect_table(runs), "heaps": heap_table(read_heaps(results))}
    for law in ("displacement", "velocity"):
        mine = [r for r in runs if r["law"] == law and not r["variant"]]
        for name, table in (("means", tables.mean_table), ("statements", tables.statement_table),
                            ("fit", tables.scan_part), ("porosity", tables.porosity_table)):
            parts[f"{name} {law}"] = table(mine) if mine else "No runs of this law are kept yet.\n"
    return parts


def arguments():
    p = argparse.ArgumentParser(prog="study.sh", allow_abbrev=False)
    p.add_argument("--out", help="folder of figures and tables; default: inputs/results/study, and "
                                 "the page and the tool's table are written too")
    p.add_argument("--results", default=ROOT / "inputs" / "results", type=Path, help="the runs that are kept")
    p.add_argument("--add", metavar="FOLDER", help="takes the finished runs of a campaign of piling.in first")
    p.add_argument("--commit", default="", help="of the engine of these runs")
    return p.parse_args()


def main():
    given = arguments()
    if given.add and not given.commit:
        sys.exit("study.sh: --add needs --commit, the commit of the engine that ran")
    tools = Path(os.environ.get("ELLIPSOID_BIN", ROOT / "build" / "bin")) / "ellipsoid-post"
    if not os.access(tools, os.X_OK):
        sys.exit(f"study.sh: there is no {tools}; build it (bash inputs/quickstart.sh)")
    if given.add:
        print("kept:", *add(given.results, given.add, given.commit, tools) or ["nothing new"])
    out = Path(given.out or given.results / "study").resolve()
    out.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        runs = [measured(tools, given.results, Path(folder), row) for row in read_list(given.results)]
        matrix = [r for r in runs if not r["variant"]]
        for law in sorted({r["law"] for r in matrix}):
            draw(tools, given.results, out, Path(folder), law, [r for r in matrix if r["law"] == law])
    at_rest = [r for r in matrix if r["law"] == "displacement"]
    written = {"study.md": tables.filled_page, "study_values.h": tables.filled_header}
    parts = {"study.md": parts_of(runs, given.results), "study_values.h": tables.difference_rows(at_rest)}
    for name, kept in targets().items():
        target = out / name if given.out else kept
        target.write_text(written[name](kept.read_text(), parts[name]))
    print(f"{len(runs)} runs, figures in {out}")


if __name__ == "__main__":
    main()
