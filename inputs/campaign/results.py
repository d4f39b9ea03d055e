"""Tables of a campaign: a row per run, means and margins, a report of piles."""

import csv
import subprocess

from options import Misuse
from runs import Failed, last_row, measure_files, read_record


def run_row(campaign, run):
    """What tells the run from the others, its run time (s), and the last row of each measure."""
    folder = campaign.folder(run)
    row = {"run": run.name, **dict(run.varied), "run_time_s": f"{read_record(folder)['seconds']:.0f}"}
    for name in measure_files(campaign.measures):
        for key, value in last_row(folder / name).items():
            if row.get(key) != value:
                row[key if key not in row else f"{name[:-4]}_{key}"] = value
    return row


def write_rows(file, rows):
    keys = list(dict.fromkeys(key for row in rows for key in row))
    with open(file, "w", newline="") as stream:
        writer = csv.DictWriter(stream, keys, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def table(campaign, runs):
    """Rows of all finished runs, written to table.csv."""
    rows = [run_row(campaign, run) for run in runs]
    write_rows(campaign.out / "table.csv", rows)
    print(f"=== Table of the runs\n{campaign.out / 'table.csv'}", flush=True)
    return rows


def tool(campaign, *words):
    if subprocess.run([str(w) for w in (campaign.tools, *words)], stdin=subprocess.DEVNULL).returncode:
        raise Failed(f"ellipsoid-post {words[0]} failed")


def summary(campaign, runs, quantities):
    """Means and margins over seeds."""
    groups = [name for name, _ in runs[0].varied if name != "seed"]
    print("=== Means and margins", flush=True)
    tool(campaign, "summary", campaign.out / "table.csv", "--group", ",".join(groups) or "surface",
         "--quantity", quantities, "--csv", campaign.out / "summary.csv")


def report(campaign, runs):
    """The page of the piles."""
    print("=== Report", flush=True)
    page = campaign.out / "report.html"
    finals = [max(str(f) for f in campaign.folder(run).glob("pile.*.dump")) for run in runs]
    tool(campaign, "report", "--each-file", *finals, "--output", page)
    print(page)


def require_columns(rows, columns):
    """A run that has no such measure, a pile too small for an angle, is left out of the means; one of them has it."""
    for column in columns:
        if not any(column in row for row in rows):
            raise Misuse(f"no column '{column}' in the measures; there are {', '.join(dict.fromkeys(k for row in rows for k in row))}")
