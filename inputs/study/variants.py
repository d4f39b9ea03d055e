"""Runs that differ from the paper's in one thing: side wall, ground, damping (sensitivity), or aspect ratio."""

import re

import numpy as np

from statistics_of_runs import drawn_means, interval
from tables import QUANTITIES, kind_name, markdown

COMPARED = ("repose_angle_deg", "porosity", "zpp")
ASPECT = r"a/b ([\d.e+-]+)"


def grouped(runs, name):
    """{name(run): runs}, in the order in which the names come."""
    groups = {}
    for r in runs:
        groups.setdefault(name(r), []).append(r)
    return groups


def compared(groups, base, in_percent):
    """A row for each group: number of runs, and for each quantity the mean and how far it lies from the base, with 95 %."""
    draws = {key: drawn_means({name: [float(r[key]) for r in mine] for name, mine in groups.items()}) for key in COMPARED}
    for name, mine in groups.items():
        row = [len(mine)]
        for key in COMPARED:
            _, digits = QUANTITIES[key]
            mean = np.mean([float(r[key]) for r in mine])
            difference = "-"
            if name != base and base in groups and draws[key]:
                zero = np.mean([float(r[key]) for r in groups[base]])
                of = (lambda a, b: 100.0 * (a / b - 1.0)) if in_percent else (lambda a, b: a - b)
                low, high = interval(of(draws[key][name], draws[key][base]))
                places = 1 if in_percent else digits
                difference = f"{of(mean, zero):+.{places}f} ({low:+.{places}f} to {high:+.{places}f})"
            row += [f"{mean:.{digits}f}", difference]
        yield name, row


def header(first, difference):
    words = [first, "runs"]
    for key in COMPARED:
        words += [QUANTITIES[key][0], difference]
    return words


def sensitivity_table(runs):
    """Smooth piles at rest, each changed in one thing, beside those that are not."""
    mine = [r for r in runs if r["law"] == "displacement" and r["kind"] == 0
            and not re.match(rf"{ASPECT}|time step", r["variant"])]
    groups = grouped(sorted(mine, key=lambda r: r["variant"]), lambda r: r["variant"])
    if set(groups) <= {""}:
        return "No such runs are kept yet.\n"
    return markdown(header("changed", "less unchanged"),
                    [[name or "nothing", *row] for name, row in compared(groups, "", in_percent=False)])


def aspect_table(runs):
    """Piles of other aspect ratios: how far those of N sub-spheres lie from the smooth ones of the same aspect ratio."""
    mine = [r for r in runs if r["law"] == "displacement" and re.fullmatch(ASPECT, r["variant"])]
    rows = []
    for aspect, of_aspect in grouped(sorted(mine, key=lambda r: (float(r["variant"].split()[1]), r["kind"] or 1000)),
                                     lambda r: r["variant"].split()[1]).items():
        groups = grouped(of_aspect, lambda r: r["kind"])
        rows += [[aspect, kind_name(kind), *row] for kind, row in compared(groups, 0, in_percent=True)]
    if not rows:
        return "No such runs are kept yet.\n"
    first, *others = header("a/b", "from smooth, %")
    return markdown([first, "particles", *others], rows)
