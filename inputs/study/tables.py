"""Tables of the study in Markdown, and the page that holds them."""

import re

import numpy as np

from fits import CUTS, SEGMENTS, THROUGH
from porosities import READINGS
from statements import statements, test
from statistics_of_runs import drawn_means, interval

QUANTITIES = {"repose_angle_deg": ("angle, deg", 1), "porosity": ("porosity", 3), "zpp": ("Zpp", 2), "zss": ("Zss", 2)}
PAPER = {"repose_angle_deg": {0: "22.7 ± 1.8", 3: "29.1", 5: "26.6", 13: "23.5", 17: "23.3"},
         "porosity": {0: "0.13 ± 4 %", 3: "0.25", 17: "0.14"}, "zpp": {0: "3.90 ± 2.5 %", 17: "3.90"}, "zss": {}}


def kind_name(kind):
    return f"N = {kind}" if kind else "smooth"


def markdown(header, rows):
    lines = [header, ["---"] * len(header), *rows]
    return "\n".join("| " + " | ".join(str(v) for v in line) + " |" for line in lines) + "\n"


def kinds_of(runs):
    """Kinds that have runs, smooth last as in the paper's figures."""
    found = sorted({r["kind"] for r in runs})
    return [k for k in found if k] + [k for k in found if not k]


def values(runs, key):
    """{kind: [value, ...]} of the runs."""
    return {kind: [float(r[key]) for r in runs if r["kind"] == kind] for kind in kinds_of(runs)}


def run_table(runs):
    rows = [[r["law"], r["variant"] or "-", kind_name(r["kind"]), r["seed"], r["time_step_s"], r["commit"], r["run_time_s"] or "-",
             f"{float(r['repose_angle_deg']):.1f} ± {float(r['repose_angle_standard_error_deg']):.1f}",
             f"{float(r['porosity']):.3f}", f"{float(r['zpp']):.2f}", f"{float(r['zss']):.2f}",
             f"{100.0 * float(r['mean_overlap_b']):.3f} %"] for r in runs]
    return markdown(["law", "changed", "particles", "seed", "time step, s", "commit", "run time, s",
                     "angle ± error of the fit, deg", "porosity", "Zpp", "Zss", "mean overlap, of b"], rows)


def mean_table(runs):
    rows = []
    for kind in kinds_of(runs):
        row = [kind_name(kind), len(values(runs, "zpp")[kind])]
        for key, (_, digits) in QUANTITIES.items():
            groups = values(runs, key)
            draws = drawn_means(groups)
            text = f"{np.mean(groups[kind]):.{digits}f}"
            if draws:
                low, high = interval(draws[kind])
                text += f" ({low:.{digits}f} to {high:.{digits}f})"
            row += [text, PAPER[key].get(kind, "-")] if key != "zss" else [text]
        rows.append(row)
    header = ["particles", "runs"]
    for key, (name, _) in QUANTITIES.items():
        header += [name, "paper"] if key != "zss" else [name]
    return markdown(header, rows)


def scan_table(runs):
    """Mean angle over the runs of each kind for each reading of A-B."""
    rows = []
    for kind in kinds_of(runs):
        mine = [r for r in runs if r["kind"] == kind]
        for segment in SEGMENTS:
            for through in THROUGH:
                rows.append([kind_name(kind), len(mine), f"by {segment}", through, *(
                    f"{np.mean([r['scan'][segment, through, cut] for r in mine]):.1f}" for cut in CUTS)])
    return markdown(["particles", "runs", "A-B", "through", *(f"{100 * c:g} %" for c in CUTS)], rows)


def paper_angles():
    """{kind: degrees} of the paper's means."""
    return {kind: float(words.split()[0]) for kind, words in PAPER["repose_angle_deg"].items()}


def closest_way(runs):
    """((segment, through, cut), root mean square of the means' distances from the paper's, deg) of the way that comes closest."""
    paper = {kind: angle for kind, angle in paper_angles().items() if any(r["kind"] == kind for r in runs)}

    def distance(way):
        means = [np.mean([r["scan"][way] for r in runs if r["kind"] == kind]) - angle for kind, angle in paper.items()]
        return np.sqrt(np.mean(np.square(means)))

    ways = [(s, t, c) for s in SEGMENTS for t in THROUGH for c in CUTS]
    return min(((way, distance(way)) for way in ways), key=lambda pair: pair[1])


def scan_part(runs):
    """The table of the scan, and which way comes closest, where the paper gives a mean of one of these kinds."""
    if not any(r["kind"] in PAPER["repose_angle_deg"] for r in runs):
        return scan_table(runs)
    (segment, through, cut), distance = closest_way(runs)
    return (scan_table(runs) + f"\nClosest to the paper's means: A-B by {segment}, {100 * cut:g} % left out, through the {through}; root mean "
            f"square of the distances {distance:.1f} degrees. That the paper did so is a guess.\n")


def porosity_table(runs):
    kinds = kinds_of(runs)
    rows = [[reading, *(f"{np.mean([r['porosities'][reading] for r in runs if r['kind'] == k]):.3f}" for k in kinds)]
            for reading in READINGS]
    rows.append(["**paper**", *(PAPER["porosity"].get(k, "-") for k in kinds)])
    return markdown(["total area of the pile", *(kind_name(k) for k in kinds)], rows)


def number(value):
    return "-" if value is None else f"{value:.3g}"


def statement_table(runs):
    groups = {key: values(runs, key) for key in QUANTITIES}
    rows = []
    for statement in statements():
        value, low, high, verdict = test(statement, groups)
        span = "-" if low is None else f"{number(low)} to {number(high)}"
        rows.append([statement.words, statement.measured, number(value), span, verdict])
    return markdown(["the paper says", "measured", "here", "95 %", "verdict"], rows)


def difference_rows(runs):
    """{key: rows of postprocess/measures/templates/study_values.h}: difference of N from smooth in percent, with 95 %."""
    parts = {}
    for key in ("repose_angle_deg", "porosity", "zpp"):
        groups = values(runs, key)
        draws, rows = drawn_means(groups), ""
        for kind in groups if 0 in groups and draws else ():
            if kind:
                low, high = interval(100.0 * (draws[kind] / draws[0] - 1.0))
                mean = 100.0 * (np.mean(groups[kind]) / np.mean(groups[0]) - 1.0)
                rows += f"    {{{kind}, {len(groups[kind])}, {len(groups[0])}, {mean:.2f}, {low:.2f}, {high:.2f}}},\n"
        parts[key] = rows
    return parts


def filled(text, parts, begin, end):
    """The text with each part between its marks; stops when a mark is missing."""
    for name, part in parts.items():
        marks = re.compile(rf"({re.escape(begin.format(name))}\n).*?({re.escape(end)})", re.DOTALL)
        if not marks.search(text):
            raise SystemExit(f"study.sh: there are no marks for the table '{name}'")
        text = marks.sub(lambda m: m.group(1) + part + m.group(2), text)
    return text


def filled_page(text, parts):
    return filled(text, {name: f"\n{part}\n" for name, part in parts.items()}, "<!-- study: {} -->",
                  "<!-- study: end -->")


def filled_header(text, parts):
    return filled(text, parts, "// study: {}", "// study: end")
