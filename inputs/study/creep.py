"""How piles of smooth ellipsoids with friction along the velocity creep: their angle over time and time step, and what is
left of it where the time step goes to zero."""

import csv
import re

import numpy as np

from statistics_of_runs import DRAWS, drawn_means, interval
from tables import markdown

TIMES = (40, 45, 50, 55, 60)  # s
FROM = 45.0  # s: by then the last particle has come to rest on the pile


def creeping(runs):
    return [r for r in runs if r["law"] == "velocity" and r["kind"] == 0
            and re.fullmatch(r"(time step \S+ s)?", r["variant"])]


def angles(results, run):
    """(times in s, angles in degrees) of a run from its last drop on."""
    with open((results / run["file"]).parent / "series.csv", newline="") as stream:
        rows = list(csv.DictReader(stream))
    return (np.array([int(r["timestep"]) * float(run["time_step_s"]) for r in rows]),
            np.array([float(r["repose_angle_deg"]) for r in rows]))


def at(series, time):
    """Angle at a time; None: the run did not come so far."""
    times, found = series
    near = np.flatnonzero(np.abs(times - time) < 0.01)
    return found[near[0]] if len(near) else None


def rate(series):
    """Slope of the straight line through the angles after FROM, degrees per s."""
    times, found = series
    late = times > FROM - 0.01
    return np.polyfit(times[late], found[late], 1)[0]


def with_interval(values, draws, digits):
    text = f"{np.mean(values):.{digits}f}"
    return text if draws is None else text + " ({1:.{0}f} to {2:.{0}f})".format(digits, *interval(draws))


def limit(steps, values, seed=20100107):
    """The straight line through values over time steps where the step is 0, and draws of it: normal about the least squares,
    the scatter drawn by the chi-squared distribution of its degrees of freedom; (None, None) with less than two steps or
    less than three values."""
    steps, values = np.asarray(steps), np.asarray(values)
    if len(set(steps)) < 2 or len(values) < 3:
        return None, None
    design = np.stack([np.ones(len(steps)), steps / steps.max()], axis=1)
    (found, _), residual, *_ = np.linalg.lstsq(design, values, rcond=None)
    freedom = len(values) - 2
    error = np.sqrt(residual[0] / freedom * np.linalg.inv(design.T @ design)[0, 0])
    random = np.random.default_rng(seed)
    return found, found + error * random.standard_normal(DRAWS) * np.sqrt(freedom / random.chisquare(freedom, DRAWS))


def creep_table(runs, results):
    mine = creeping(runs)
    if not mine:
        return "No runs of this law are kept yet.\n"
    series = {r["run"]: angles(results, r) for r in mine}
    steps = sorted({float(r["time_step_s"]) for r in mine})
    groups = {step: [series[r["run"]] for r in mine if float(r["time_step_s"]) == step] for step in steps}
    rates = {step: [rate(s) for s in found] for step, found in groups.items()}
    draws = drawn_means(rates)
    rows = []
    for step, found in groups.items():
        means = [np.mean(v) if None not in v and v else None for v in ([at(s, t) for s in found] for t in TIMES)]
        rows.append([f"{step:g}", len(found), *("-" if m is None else f"{m:.1f}" for m in means),
                     with_interval(rates[step], draws.get(step), 3), f"{np.mean(rates[step]) / step:.3g}"])
    at_rest = [float(r["repose_angle_deg"]) for r in runs if r["law"] == "displacement" and r["kind"] == 0 and not r["variant"]]
    row = ["to 0", len(mine)]
    for time in TIMES:
        known = [(float(r["time_step_s"]), angle) for r in mine if (angle := at(series[r["run"]], time)) is not None]
        value, drawn = limit([step for step, _ in known], [angle for _, angle in known])
        row.append("-" if value is None else with_interval([value], drawn, 1))
    rows.append([*row, "", ""])
    if at_rest:
        drawn = drawn_means({0: at_rest})
        rows.append(["displacement", len(at_rest), "", "", with_interval(at_rest, drawn.get(0), 1), "", "", "", ""])
    return markdown(["time step, s", "runs", *(f"angle at {t} s" for t in TIMES), f"deg per s from {FROM:g} s on",
                     "that over the time step"], rows)
