"""Heaps in space: the table of a campaign of hopper.in that is kept in inputs/results/heaps.csv."""

import csv

from tables import kind_name, markdown
from variants import compared, grouped, header


def read_heaps(results):
    """Rows of heaps.csv, a table.csv of campaign.sh; kind: number of sub-spheres, 0 for smooth. [] where there is none."""
    file = results / "heaps.csv"
    if not file.is_file():
        return []
    with open(file, newline="") as stream:
        return [row | {"kind": int(row["subspheres"]) if row["surface"] == "multisphere" else 0} for row in csv.DictReader(stream)]


def heap_table(heaps):
    """How far heaps of N sub-spheres lie from those of smooth ellipsoids."""
    if not heaps:
        return "No heaps are kept yet.\n"
    groups = grouped(sorted(heaps, key=lambda r: r["kind"] or 1000), lambda r: r["kind"])
    return markdown(header("particles", "from smooth, %"),
                    [[kind_name(kind), *row] for kind, row in compared(groups, 0, in_percent=True)])
