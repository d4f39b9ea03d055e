# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""The study's page is what its command writes from the runs that are kept; its own measures, which share no code with
ellipsoid-post, agree with it; confidence intervals cover the truth as often as they say; verdicts are right."""

import csv
import os
import pathlib
import re
import subprocess
import sys

import numpy as np

ROOT = pathlib.Path(os.environ["ELLIPSOID_SOURCE"])
TOOLS = pathlib.Path(os.environ["ELLIPSOID_BIN"]) / "ellipsoid-post"
sys.path.insert(0, str(ROOT / "inputs" / "study"))
import main as study  # noqa: E402
import tables  # noqa: E402
from creep import creep_table, limit  # noqa: E402
from fits import CUTS, SEGMENTS, THROUGH, line, scan, surface_of  # noqa: E402
from heaps import heap_table, read_heaps  # noqa: E402
from kept_runs import read_list  # noqa: E402
from piles import A, B, Pile  # noqa: E402
from porosities import porosities  # noqa: E402
from statements import Statement, test  # noqa: E402
from statistics_of_runs import drawn_means, interval, verdict  # noqa: E402
from variants import aspect_table, sensitivity_table  # noqa: E402

RESULTS = ROOT / "inputs" / "results"


def check_page():
    """The committed page and table of the tools are up to date."""
    subprocess.run(["bash", ROOT / "inputs" / "study.sh", "--out", "written"], check=True, text=True,
                   stdout=subprocess.DEVNULL)
    for name, kept in study.targets().items():
        assert pathlib.Path("written", name).read_text() == kept.read_text(), f"run inputs/study.sh: {kept} is old"
    drawn = {file.name for file in pathlib.Path("written").glob("figure*.png")}
    assert {"figure12_displacement.png", "figure13_displacement.png"} <= drawn, drawn


def check_against_the_tools():
    """Angle and porosity of a smooth and of a multi-sphere pile."""
    chosen = {}
    for row in read_list(RESULTS):
        chosen.setdefault(row["kind"] > 0, row)
    for row in chosen.values():
        run = study.measured(TOOLS, RESULTS, pathlib.Path("."), dict(row))
        mine, tool = run["scan"]["height", "envelope", 0.2], float(run["repose_angle_deg"])
        assert abs(mine - tool) < 0.02, (row["run"], mine, tool)
        mine, tool = run["porosities"]["outline, union"], float(run["porosity"])
        assert abs(mine - tool) < 2e-3, (row["run"], mine, tool)  # counted in cells of b / 16


def check_wedge():
    """Long particles laid along a straight slope: every reading has its angle; a solid wedge has no pores."""
    slope = np.tan(np.radians(25.0))
    x = np.arange(A, 0.12, 0.1 * A)
    centres = [(u, v) for u in x for v in np.arange(0.0, 0.13 * slope, 0.6 * B) if v <= slope * (0.12 - u) - B]
    centres += [(u, max(slope * (0.12 - u) - B, 0.0)) for u in x]
    direction = np.array([np.cos(np.radians(-25.0)), np.sin(np.radians(-25.0))])
    pile = Pile(np.array(centres), np.tile(direction, (len(centres), 1)), 0, np.zeros((0, 2)))
    surface = surface_of(pile)
    angles = scan(surface)
    assert set(angles) == {(s, t, c) for s in SEGMENTS for t in THROUGH for c in CUTS}
    for key, angle in angles.items():
        if key[2] >= 0.1:
            assert abs(angle - 25.0) < 0.3, (key, angle)
    assert abs(line(surface)[0] - 25.0) < 0.1
    found = porosities(pile, surface)
    for reading in "outline, union", "below the line A-B by height", "inner region, 2 a inside", "below the centres":
        assert abs(found[reading]) < 0.02, (reading, found[reading])


def check_intervals():
    """95 % intervals of a difference of two means of two runs, among four kinds, cover it in 95 % of the cases, and the
    interval of a mean is that of Student's t."""
    random = np.random.default_rng(5)
    truth, covered, cases = {3: 30.0, 9: 27.0, 17: 26.0, 0: 25.0}, 0, 400
    for _ in range(cases):
        draws = drawn_means({k: list(m + random.standard_normal(2)) for k, m in truth.items()})
        low, high = interval(draws[3] - draws[17])
        covered += low <= 4.0 <= high
    print(f"95 % intervals cover the truth in {100.0 * covered / cases:.1f} % of the cases")
    assert abs(covered / cases - 0.95) < 3.0 * np.sqrt(0.95 * 0.05 / cases), covered / cases
    low, high = interval(drawn_means({0: [1.0, 3.0], 3: [7.0]})[3])  # scatter sqrt(2), one degree of freedom
    assert abs(0.5 * (high - low) / (12.706 * np.sqrt(2.0)) - 1.0) < 0.05 and abs(0.5 * (low + high) - 7.0) < 1.0
    low, high = interval(drawn_means({0: [1.0, 2.0, 3.0], 3: [4.0, 5.0, 6.0]})[0])  # four degrees
    assert abs(0.5 * (high - low) / (2.776 / np.sqrt(3.0)) - 1.0) < 0.02, (low, high)
    assert drawn_means({0: [1.0], 3: [2.0]}) == {}


def check_verdicts():
    assert verdict(1.0, 2.0, 0.0, 3.0) == "confirmed"
    assert verdict(-1.0, 2.0, 0.0, 3.0) == verdict(2.0, 4.0, 0.0, 3.0) == verdict(-1.0, 4.0, 0.0, 3.0) == "undecided"
    assert verdict(3.5, 4.0, 0.0, 3.0) == verdict(-2.0, -1.0, 0.0, 3.0) == "not confirmed"
    falls = Statement("falls", "17 less 3", "q", (3, 17), lambda m: m[17] - m[3], -np.inf, 0.0)
    for runs, wanted in [({3: [5.0, 5.1], 17: [4.0, 4.1]}, "confirmed"),
                         ({3: [4.0, 4.1], 17: [5.0, 5.1]}, "not confirmed"),
                         ({3: [5.0, 5.1], 17: [4.0]}, "undecided"), ({3: [4.0, 6.0], 17: [4.1, 5.9]}, "undecided"),
                         ({3: [5.0], 17: [4.0]}, "undecided (one run each)"), ({3: [5.0]}, "no runs of N = 17")]:
        assert test(falls, {"q": runs})[3] == wanted, (runs, wanted)


def check_limit():
    """The straight line where the time step is 0: its interval covers the truth in 95 % of the cases; one of known values."""
    random = np.random.default_rng(8)
    steps, covered, cases = np.repeat([1e-6, 2e-6, 4e-6, 8e-6], 3), 0, 400
    for _ in range(cases):
        low, high = interval(limit(steps, 28.0 - 1e6 * steps + 1.5 * random.standard_normal(len(steps)))[1])
        covered += low <= 28.0 <= high
    assert abs(covered / cases - 0.95) < 3.0 * np.sqrt(0.95 * 0.05 / cases), covered / cases
    value, draws = limit([1.0, 2.0, 3.0], [9.0, 8.0, 8.5])
    assert abs(value - 9.0) < 1e-9, value  # y = 9 - x / 4
    # Student's t of one degree of freedom times the scatter sqrt(0.375) and sqrt(7 / 3)
    low, high = interval(draws)
    assert abs(0.5 * (high - low) / (12.706 * np.sqrt(0.375 * 7.0 / 3.0)) - 1.0) < 0.05, (low, high)
    assert limit([1.0, 1.0, 1.0], [1.0, 2.0, 3.0]) == limit([1.0, 2.0], [1.0, 2.0]) == (None, None)


def check_creep():
    """Angles that fall from 28 degrees by 0.2 degrees per second and 1e-6 s of time step: those rates, and 28 degrees at 0."""
    runs = []
    for step in 1e-6, 2e-6, 4e-6:
        for k in range(2):
            pathlib.Path(f"series/{step}_{k}").mkdir(parents=True)
            rows = [f"{round(t / step)},{28.0 - 2e5 * step * (t - 40.0) + 0.01 * (-1) ** (t + k)}" for t in range(40, 56)]
            pathlib.Path(f"series/{step}_{k}/series.csv").write_text("timestep,repose_angle_deg\n" + "\n".join(rows) + "\n")
            runs.append({"run": f"{step}_{k}", "law": "velocity", "kind": 0, "time_step_s": str(step),
                         "variant": f"time step {step} s", "file": f"{step}_{k}/pile"})
    lines = [line.split(" | ") for line in creep_table(runs, pathlib.Path("series")).splitlines()[2:]]
    for line, step in zip(lines, (1.0, 2.0, 4.0)):
        assert line[2:5] == [f"{28.0 - 0.2 * step * s:.1f}" for s in (0, 5, 10)] and line[6] == "-", line
        assert abs(float(line[7].split()[0]) + 0.2 * step) < 0.001 and line[8].startswith("-2e+05"), line
    assert [cell.split()[0] for cell in lines[3][2:6]] == ["28.0"] * 4 and lines[3][6] == "-", lines[3]


def check_variants():
    """Each changed run is compared with those that it belongs to."""
    def run(variant, kind, angle, law="displacement"):
        return {"law": law, "variant": variant, "kind": kind, "repose_angle_deg": angle, "porosity": 0.15, "zpp": 4.0}

    runs = [run("", 0, 28.0), run("", 0, 30.0), run("smooth side wall", 0, 25.0), run("smooth side wall", 0, 27.0),
            run("a/b 5", 0, 40.0), run("a/b 5", 0, 40.0), run("a/b 5", 9, 50.0), run("a/b 5", 9, 46.0),
            run("a/b 10", 0, 60.0), run("smooth side wall", 0, 1.0, "velocity"), run("time step 1e-6 s", 0, 1.0),
            run("a/b 5, smooth side wall", 0, 1.0)]
    lines = sensitivity_table(runs).splitlines()[2:]
    assert [line.split(" | ")[:4] for line in lines] == [
        ["| nothing", "2", "29.0", "-"], ["| smooth side wall", "2", "26.0", lines[1].split(" | ")[3]]], lines
    value, low, high = (float(v) for v in re.findall(r"[+-][\d.]+", lines[1].split(" | ")[3]))
    assert value == -3.0 and abs(low + 9.09) < 0.15 and abs(high - 3.09) < 0.15, lines  # Student's t 4.303, scatter sqrt(2)
    lines = [line.split(" | ") for line in aspect_table(runs).splitlines()[2:]]
    assert [line[:4] for line in lines] == [["| 5", "N = 9", "2", "48.0"], ["| 5", "smooth", "2", "40.0"],
                                            ["| 10", "smooth", "1", "60.0"]], lines
    assert lines[0][4].startswith("+20.0 ("), lines
    assert "No such runs" in sensitivity_table(runs[:2]) and "No such runs" in aspect_table(runs[:4])


def check_closest_way():
    """The one way whose means are those of the paper, but for one that is 1 degree off."""
    paper = {0: 22.7, 3: 29.1, 5: 26.6, 13: 23.5, 17: 23.3}
    assert tables.paper_angles() == paper
    ways = [(s, t, c) for s in SEGMENTS for t in THROUGH for c in CUTS]
    right = ways[7]
    runs = [{"kind": kind, "scan": {way: angle + side + (1.0 if way != right or kind == 3 else 0.0) for way in ways}}
            for kind, angle in paper.items() for side in (-2.0, 2.0)]
    runs.append({"kind": 9, "scan": dict.fromkeys(ways, 90.0)})  # the paper gives no number
    way, distance = tables.closest_way(runs)
    assert way == right and abs(distance - np.sqrt(1.0 / 5.0)) < 1e-9, (way, distance)
    assert "Closest" in tables.scan_part(runs) and "Closest" not in tables.scan_part(runs[-1:])


def check_heaps():
    """Smooth heaps come last, also where the table of the campaign says 5 sub-spheres of them."""
    pathlib.Path("heaps").mkdir()
    assert "No heaps" in heap_table(read_heaps(pathlib.Path("heaps")))
    rows = [("smooth", 5, 28.0), ("smooth", "", 30.0), ("multisphere", 17, 29.0), ("multisphere", 3, 35.0), ("multisphere", 3, 37.0)]
    pathlib.Path("heaps/heaps.csv").write_text("surface,subspheres,repose_angle_deg,porosity,zpp\n" + "".join(
        f"{surface},{n},{angle},0.4,5.5\n" for surface, n, angle in rows))
    lines = [line.split(" | ") for line in heap_table(read_heaps(pathlib.Path("heaps"))).splitlines()[2:]]
    assert [line[:3] for line in lines] == [["| N = 3", "2", "36.0"], ["| N = 17", "1", "29.0"], ["| smooth", "2", "29.0"]], lines
    assert lines[0][3].startswith("+24.1 (") and lines[2][3] == "-", lines


def check_keeping():
    """What a run has otherwise than the paper's is seen in its log; its piles over time are kept."""
    pathlib.Path("kept").mkdir()
    pathlib.Path("kept/runs.csv").write_text((RESULTS / "runs.csv").read_text().splitlines()[0] + "\n")
    small = {"particles": 30, "settle": 0.4, "y0": 0.04, "dump_time": 0.2, "vtk": "no", "interval": 0.02}
    for name, changes in [("plain", {"dt": 5e-6}), ("wall", {"dt": 5e-6, "side_wall": "smooth", "ground": "glued"}),
                          ("creep", {"dt": 1e-5, "direction": "velocity", "eta_n": 1000, "surface": "multisphere"})]:
        out = pathlib.Path("runs", name)
        subprocess.run([TOOLS.parent / "liggghts", "-in", ROOT / "inputs" / "piling.in", "-log", "none",
                        *(w for k, v in {**small, **changes, "out": out}.items() for w in ("-var", k, str(v)))], check=True,
                       stdout=subprocess.DEVNULL)
        subprocess.run([TOOLS, "pile", max(out.glob("pile.*.dump")), "--quiet", "--csv", out / "pile.csv"], check=True,
                       stderr=subprocess.DEVNULL)
    for _ in range(2):  # the second time there is nothing new
        subprocess.run(["bash", ROOT / "inputs" / "study.sh", "--results", "kept", "--out", "drawn", "--add", "runs", "--commit",
                        "abc"], check=True, stdout=subprocess.DEVNULL)
    rows = {row["variant"]: row for row in read_list(pathlib.Path("kept"))}
    assert set(rows) == {"particles 30, interval 0.02", "particles 30, interval 0.02, smooth side wall, glued ground",
                         "time step 1e-05 s, normal damping 1000, particles 30, interval 0.02"}, rows
    for row in rows.values():
        with open(pathlib.Path("kept", row["file"]).parent / "series.csv", newline="") as stream:
            times = [int(r["timestep"]) * float(row["time_step_s"]) for r in csv.DictReader(stream)]
        assert np.allclose(times, [0.6, 0.8, 1.0]), times
    assert {(r["law"], r["kind"], r["seed"], r["commit"]) for r in rows.values()} == {
        ("displacement", 0, "1", "abc"), ("velocity", 5, "1", "abc")}
    glued = rows["particles 30, interval 0.02, smooth side wall, glued ground"]
    pile = study.measured(TOOLS, pathlib.Path("kept"), pathlib.Path("."), glued)
    assert int(pile["particles"]) + int(pile["strays"]) == 30, "the glued grains are not measured"


def check_messages():
    for words, message in [(["--add", "."], "--add needs --commit"),
                           (["--results", "absent"], "no list of runs")]:
        done = subprocess.run(["bash", ROOT / "inputs" / "study.sh", "--out", "x", *words], text=True,
                              capture_output=True)
        assert done.returncode and message in done.stderr and len(done.stderr.splitlines()) == 1, done.stderr


def main():
    check_verdicts()
    check_limit()
    check_creep()
    check_variants()
    check_closest_way()
    check_heaps()
    check_keeping()
    check_intervals()
    check_wedge()
    check_against_the_tools()
    check_page()
    check_messages()
    print("passed")


if __name__ == "__main__":
    main()
