# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""Results of which there is nothing: tables without rows, frames that cannot be read, runs that belong to no figure.

A file is written with the names of its columns where there is rightly nothing to list, and not at all where nothing could be
measured; what is left out is said."""
import csv
import json
import os

from _synthetic import COLUMNS, frame_text, json_of, particle, post, rows_of, wedge, write

BOX = ("-1", "1", "-1", "1", "-1", "1")
MEASURES = {"pile": (), "repose": (), "porosity": (), "coordination": (), "heap": (), "bed": ("--box", *BOX), "orientation": (),
            "fields": ("--at", 0, 0, 0), "voronoi": ("--box", *BOX), "mixing": ("--type", 1), "pairs": (), "trajectory": (),
            "flow": ("--through", 0, 0, 0, 0, 0, 1), "contacts": (), "energy": ()}


def header_of(name):
    with open(name, encoding="ascii") as file:
        rows = list(csv.reader(file))
    assert len(rows) == 1, rows
    return rows[0]


def check_broken_frames():
    """One frame, which is cut off, or lacks a column, or has ids twice."""
    text = frame_text(100, wedge())
    twice = text.replace("\n2 1 ", "\n1 1 ", 1)
    for name, words in ((write("cut.dump", text[:3000]), "expected 20 values"), (write("bare.dump", text.replace(" y ", " why ", 1)), '"y"'),
                        (write("twice.dump", twice), "ids that come once")):
        for command, more in MEASURES.items():
            out, error = post(command, name, *more, "--csv", "t.csv", "--json", "t.json", expect=1)
            assert out == "" and words in error, (command, name, error)
            assert "--csv t.csv: not written" in error and "--json t.json: not written" in error, (command, error)
            assert not os.path.exists("t.csv") and not os.path.exists("t.json"), command
            out, _ = post(command, name, *more, "--csv", "-", expect=1)
            assert out == "", (command, out)
    post("contacts", "cut.dump", "--list", "list.csv", "--quiet", expect=1)
    post("flow", "cut.dump", *MEASURES["flow"], "--passages", "passages.csv", "--quiet", expect=1)
    assert not os.path.exists("list.csv") and not os.path.exists("passages.csv")


def check_nothing_to_list():
    """Two bodies far from each other, at rest."""
    apart = [particle(1, 0.0, 0.0), particle(2, 0.1, 0.0)]
    name = write("apart.dump", frame_text(0, apart) + frame_text(10, apart))
    post("contacts", name, "--list", "list.csv", "--quiet")
    assert header_of("list.csv") == ("run,timestep,id_1,id_2,point_x_m,point_y_m,point_z_m,normal_x,normal_y,normal_z,overlap_m").split(",")
    post("flow", name, *MEASURES["flow"], "--dt", 1e-5, "--passages", "passages.csv", "--quiet")
    assert header_of("passages.csv")[:3] == ["run", "id", "time_s"]
    post("trajectory", name, "--collisions", "--dt", 1e-5, "--csv", "collisions.csv", "--json", "collisions.json")
    assert "duration_s" in header_of("collisions.csv")
    with open("collisions.json", encoding="ascii") as file:
        assert json.load(file) == []
    # and the same columns where there is something
    close = [particle(1, 0.0, 0.0), particle(2, 0.0, 2.2e-3)]
    post("contacts", write("close.dump", frame_text(0, close)), "--list", "some.csv", "--quiet")
    with open("some.csv", encoding="ascii") as file:
        assert next(csv.reader(file)) == header_of("list.csv")
    out, error = post("flow", write("one.dump", frame_text(0, apart)), *MEASURES["flow"], "--csv", "f.csv", expect=1)
    assert out == "" and "at least two frames" in error and not os.path.exists("f.csv"), error
    out, error = post("report", "--table", "list.csv", "-o", "r.html", "--csv", "r.csv", expect=None)
    assert "--csv" in error and not os.path.exists("r.csv"), (out, error)


def check_uneven_frames():
    """Lags of several origins are one time only if frames are evenly spaced."""
    frames = lambda steps: "".join(frame_text(s, [particle(1, 1e-3 * s, 0.0), particle(2, 0.1, 1e-3 * s)]) for s in steps)
    even, uneven = write("even.dump", frames((0, 10, 20, 30))), write("uneven.dump", frames((0, 10, 20, 35)))
    rows = rows_of("trajectory", even, "--origins", 2)
    assert abs(float(rows[1]["msd_m2"]) - 1e-4) < 1e-15, rows[1]
    assert len(rows_of("trajectory", uneven)) == 4
    out, error = post("trajectory", uneven, "--origins", 2, "--csv", "u.csv", expect=1)
    assert out == "" and "evenly spaced" in error and "20 and 35" in error and "--origins 1" in error, error


def surfaces(columns, rows, name, *more):
    (row,) = json_of("orientation", write(name, frame_text(1, rows, columns)), *more)[:1]
    return row["surface"], row["subspheres"]


def check_figures():
    """Mixtures and clumps are not on a curve over N."""
    smooth, chains = wedge(), wedge(subspheres=5)
    mixed = [dict(row, f_subspheres=5 if k % 2 else 0) for k, row in enumerate(smooth)]
    several = [dict(row, f_subspheres=5 if k % 2 else 7) for k, row in enumerate(smooth)]
    write("clump.txt", "".join(f"{x} 0 0 0.5\n" for x in (-0.5, 0.0, 0.5)))
    clumps = [dict(row, f_spacing=1003, f_subspheres=3, shapex=2 * row["shapey"]) for row in smooth]
    with_spacing = [*COLUMNS, "f_spacing"]
    assert surfaces(COLUMNS, smooth, "smooth.dump") == ("smooth", None)
    assert surfaces(COLUMNS, chains, "chains.dump") == ("multisphere", 5)
    assert surfaces(COLUMNS, mixed, "mixed.dump") == ("mixed", 5)
    assert surfaces(COLUMNS, several, "several.dump") == ("multisphere", "5 to 7")
    clump = ("--clump", "3=clump.txt")
    assert surfaces(with_spacing, clumps, "clumps.dump", *clump) == ("clump", 3)
    both = [dict(row, f_spacing=0) for row in chains[::2]] + clumps[1::2]
    assert surfaces(with_spacing, both, "both.dump", *clump)[0] == "mixed"
    balls = [dict(row, radius=1e-3, mol=1 + k // 2) for k, row in enumerate(smooth[:200])]
    assert surfaces("id mol x y z radius".split(), balls, "bodies.dump", "--bodies", "mol") == ("clump", 2)
    names = ("smooth", "chains", "mixed", "several")
    post("pile", *(f"{n}.dump" for n in names), "--csv", "runs.csv", "--quiet")
    post("pile", "smooth.dump", "chains.dump", "--csv", "pure.csv", "--quiet")
    for figure in (12, 13, 15):
        _, error = post("plot", figure, "runs.csv", "-o", f"all_{figure}.svg")
        assert "2 of 4 runs are not in the figures" in error and "mixed.dump, several.dump" in error, error
        _, error = post("plot", figure, "pure.csv", "-o", f"pure_{figure}.svg")
        assert "not in the figures" not in error
        with open(f"all_{figure}.svg", encoding="utf8") as one, open(f"pure_{figure}.svg", encoding="utf8") as other:
            assert one.read() == other.read(), figure
    post("report", *(f"{n}.dump" for n in names), "-o", "report.html")
    with open("report.html", encoding="utf8") as file:
        assert "2 of 4 runs are not in the figures" in file.read()


def main():
    check_broken_frames()
    check_nothing_to_list()
    check_uneven_frames()
    check_figures()


main()
