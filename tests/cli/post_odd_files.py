# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""Files that are odd but legal, and such as cannot be: each gives the values of the plain file, or one line that says what is wrong.

Dumps that go on after a restart, particles that are away for a while, columns that come twice, boxes that cannot be, logs that do not
tell gravity or lie beside each other, pictures of nothing."""
import csv
import io
import json
import math
import os

from _synthetic import COLUMNS, frame_text, json_of, particle, post, rows_of, write


def refused(*arguments, words):
    out, error = post(*arguments, expect=1)
    assert out == "" and error.count("\n") == 1 and all(w in error for w in words), (arguments, out, error)


def values(text):
    rows = list(csv.DictReader(io.StringIO(text)))
    for row in rows:
        row.pop("run")
    return rows


def check_line_ends():
    """Windows line ends, blanks and tabs: the same values. No last line end: the last number may be cut, unless a blank is behind it."""
    text = frame_text(100, [particle(k + 1, 3e-3 * k, 0.01, speed=0.1) for k in range(5)])
    plain = values(post("energy", write("plain.dump", text), "--csv", "-")[0])
    for name, other in (("ends", text.replace("\n", "\r\n")), ("blanks", text.replace("\n", "  \n")), ("none", text[:-1] + " "),
                        ("tabs", "\n".join(line if line.startswith("ITEM") else line.replace(" ", "\t") for line in text.splitlines()) + "\n")):
        with open(name + ".dump", "w", newline="", encoding="ascii") as file:
            file.write(other)
        assert values(post("energy", name + ".dump", "--csv", "-")[0]) == plain, name
    refused("energy", write("open.dump", text[:-1]), words=("open.dump:14", "add a line end"))


def check_restarts():
    """A run that was resumed from step 100 wrote 100 and 200 twice, the second time elsewhere."""
    frame = lambda step, speed: frame_text(step, [particle(1, 0.0, 0.01, speed=speed), particle(2, 0.01, 0.01)])
    name = write("resumed.dump", "".join(frame(*s) for s in ((0, 0.1), (100, 0.2), (200, 0.3), (100, 0.2), (200, 0.4), (300, 0.5))))
    _, error = post("energy", name, "--frame", 200)
    assert "several frames are of time step 200: the first one is taken" in error, error
    (row,) = json_of("energy", name, "--frame", 200)
    assert abs(row["translation_J"] - 0.5 * 2e-5 * 0.3 ** 2) < 1e-18
    assert "frames are" not in post("energy", name, "--frame", 0)[1].replace("frames are repeated", "")
    assert "in the order of time" in post("trajectory", name, expect=1)[1]
    # what is broken behind the frame that was asked for does not matter
    assert "several" not in post("energy", write("cut.dump", frame(0, 0.1) + frame(100, 0.2) + frame(200, 0.3)[:-30]), "--frame", 100)[1]
    post("energy", "cut.dump", "--frame", 200, expect=1)


def check_empty_last_frame():
    """A last frame without particles is said by the commands that go through all frames, once."""
    name = write("gone.dump", frame_text(0, [particle(1, 0.0, 0.01)]) + frame_text(100, [particle(1, 1e-3, 0.01)]) + frame_text(200, []))
    for command in (("energy",), ("energy", "--frame", "all"), ("trajectory",), ("paraview", "-o", "all"), ("view", "-o", "gone.html")):
        _, error = post(command[0], name, *command[1:])
        assert error.count("gone.dump: the last frame, of time step 200, holds no particles") == 1, (command, error)
    assert "holds no particles" not in post("energy", name, "--frame", 100)[1]


def check_sides_not_said():
    """Dumps of older programs do not say whether the box repeats: said, unless the user does."""
    name = write("sides.dump", frame_text(0, [particle(1, 0.0, 0.01), particle(2, 0.01, 0.01)]))
    text = open(name, encoding="ascii").read()
    head = next(line for line in text.splitlines() if line.startswith("ITEM: BOX BOUNDS"))
    write(name, text.replace(head, "ITEM: BOX BOUNDS"))
    said = "sides.dump: the file does not say whether its box repeats"
    for command in ("energy", "orientation", "contacts"):
        assert post(command, name)[1].count(said) == 1
        assert said not in post(command, name, "--periodic", "none")[1]
        assert said not in post(command, write("said.dump", text))[1]


def check_absence():
    """A particle that is away in one frame: its ways before and after are not joined."""
    place = lambda k, step: particle(k, 3e-3 * k + 1e-5 * step * k, 0.01)
    frames = ((0, (1, 2, 3)), (100, (1, 2, 3)), (200, (1, 2)), (300, (1, 2, 3)), (400, (1, 2, 3)))
    name = write("away.dump", "".join(frame_text(s, [place(k, s) for k in ids]) for s, ids in frames))
    for origins in (1, 2, 5):
        rows = json_of("trajectory", name, "--origins", origins)
        for row in rows:
            lag, squares = row["lag_frames"], []
            for begin in range(min(origins, len(frames) - lag)):
                for k in (1, 2, 3):
                    if all(k in frames[n][1] for n in range(begin, begin + lag + 1)):
                        squares.append((1e-5 * 100 * lag * k) ** 2)
            assert row["pairs"] == len(squares), (origins, row, len(squares))
            mean = sum(squares) / len(squares)
            assert abs(row["msd_m2"] - mean) <= 1e-9 * mean, (origins, row, mean)


def check_no_particle_stays():
    """Lags that no particle has a way for: no means, not zeros."""
    name = write("change.dump", frame_text(0, [particle(1, 0.0, 0.01)]) + frame_text(100, [particle(2, 0.0, 0.01)]) + frame_text(200, []))
    rows = json_of("trajectory", name, "--dt", 1e-5)
    assert [row["pairs"] for row in rows] == [1, 0, 0] and rows[0]["msd_m2"] == 0, rows
    assert all(row[key] is None for row in rows[1:] for key in row if key.startswith(("displacement", "msd", "diff", "rot", "dir"))), rows


def check_unknown_errors():
    """Standard errors that two cells, or cells of one particle each, do not tell: no value, neither 0 nor nan."""
    rows = [dict(particle(k + 1, 2.5e-3 + 5e-3 * min(k, 4) + 1e-4 * (k == 5), 1e-3), type=1 + (k % 2 if k < 5 else 0)) for k in range(6)]
    name = write("cells.dump", frame_text(0, rows))
    for size, cells in ((5e-3, 5), (1.5e-2, 2)):
        command = ("mixing", name, "--type", 2, "--cell", size, "--neighbours", 3)
        (row,) = json_of(*command)
        assert row["cells"] == cells and row["lacey_index_standard_error"] is None, row
        assert (row["neighbour_index_standard_error"] is None) == (cells == 2), row
        (line,) = rows_of(*command)
        assert line["lacey_index_standard_error"] == "" and "nan" not in post(*command)[0], line


def check_long_steps():
    """Ways that may be longer than half of the box: this is said; others are not."""
    for share, is_said in ((0.3, False), (0.45, True), (0.8, False)):  # 0.8 looks like 0.2 backwards: nobody can know
        frames = ""
        for n in range(4):
            text = frame_text(n, [particle(1, (0.1 + share * 0.5 * n) % 0.5, 0.1)])
            frames += text.replace("mm mm ff", "pp ff ff")
        name = write("steps.dump", frames)
        for command in (("trajectory", name), ("flow", name, "--through", 0, 0, 0, 0, 1, 0)):
            assert ("3 steps of particles" in post(*command)[1]) == is_said, (share, command)


def unwrapped_run(column, places):
    """One particle in a box of 0.5 that repeats along x; `column` is xu or xsu."""
    names = [c + column[1:] if c in ("x", "y", "z") else c for c in COLUMNS]
    frames = ""
    for n, x in enumerate(places):
        row = particle(1, 2.0 * x if column == "xsu" else x, 0.5 if column == "xsu" else 0.1)
        frames += frame_text(n, [{name: row[c] for name, c in zip(names, COLUMNS)}], names).replace("mm mm ff", "pp ff ff")
    return write("unwrapped.dump", frames)


def check_unwrapped_steps():
    """Unwrapped positions tell each way, however long: exact means and crossings; beyond half an edge this is said."""
    for share, forward, backward in ((0.45, 2, 0), (0.8, 3, 0), (-0.8, 0, 2), (1.7, 3, 0)):  # of the edge, in each step
        for column in ("xu", "xsu"):
            name = unwrapped_run(column, [0.05 + 0.5 * share * n for n in range(4)])
            out, error = post("trajectory", name, "--json", "-")
            assert ("3 steps of particles" in error and "half of an edge" in error) if abs(share) > 0.5 else error == "", (share, column, error)
            for row in json.loads(out):
                way = 0.5 * share * row["lag_frames"]
                assert abs(row["displacement_x_m"] - way) < 1e-9 and abs(row["msd_m2"] - way ** 2) < 1e-9, (share, column, row)
            out, error = post("flow", name, "--through", 0.11, 0, 0, 1, 0, 0, "--total", "--json", "-")
            (row,) = json.loads(out)
            assert (row["forward"], row["backward"]) == (forward, backward), (share, column, row)
            assert ("count once" in error) == (share > 1.0) and ("3 steps of particles" in error) == (abs(share) > 0.5), (share, column, error)


def check_columns():
    """Which of two columns of one name is meant is not known; others may come twice."""
    rows = [dict(particle(k + 1, 3e-3 * k, 0.01), extra=1.0) for k in range(3)]
    twice = lambda column: write("twice.dump", frame_text(1, rows, [*COLUMNS, "extra", column]))
    for column, command in (("mass", "energy"), ("x", "contacts"), ("shapey", "contacts"), ("quat2", "orientation"), ("id", "energy"),
                            ("f_subspheres", "contacts"), ("vx", "energy")):
        refused(command, twice(column), words=(f'one column "{column}"',))
    post("energy", twice("extra"))
    refused("render3d", "twice.dump", "-o", "x.png", "--colour", "extra", words=('one column "extra"',))
    refused("energy", "twice.dump", "--column", "mass=extra", words=('one column "extra"',))


def check_boxes():
    text = frame_text(1, [particle(k + 1, 3e-3 * k, 0.01) for k in range(3)])
    bounds = "mm mm ff\n0 0.5\n-0.005 0.2\n-0.01 0.01"
    box = lambda new: write("box.dump", text.replace(bounds, new))
    for words in ("pf ff ff", "xx ff ff", "pp pp", "p f f", "pp pp pp pp"):
        refused("contacts", box(bounds.replace("mm mm ff", words)), words=("sides",))
    refused("contacts", box(bounds.replace("0 0.5", "0.5 0")), words=("lower bound", "for x"))
    refused("contacts", box("xy xz yz pp pp pp\n0 0.5 0.6\n-1 1 0\n-1 1 0"), words=("tilts", "for x"))
    post("contacts", box(bounds.replace("mm mm ff", "").replace(" \n", "\n", 1)))  # old files do not say it
    tilted = "xy xz yz pp pp ff\n-0.4 1.4 0.4\n-1 1 0\n-1 1 -0.4"
    post("contacts", box(tilted.replace("-0.4 1.4 0.4", "0 1.4 0.4").replace("-1 1 -0.4", "-1 1 0")))


def logged(folder, *logs):
    os.makedirs(folder, exist_ok=True)
    for k, text in enumerate(logs):
        write(f"{folder}/log.{k}", text)
    return write(f"{folder}/one.dump", frame_text(600, [particle(1, 0.0, 0.01), dict(particle(2, 0.0, 0.05), z=0.03)]))


def check_logs():
    head, tail = "timestep 1e-5\n", "run 600\nStep Atoms\n0 2\n600 2\n"
    fix = "fix g all gravity 9.81 "
    s = math.sin(math.radians(26))
    for words, expected in (("vector 0.0 0.0 -2.0", (0, 0, -9.81)), ("chute 26.0", (9.81 * s, 0, -9.81 * math.cos(math.radians(26)))),
                            ("spherical 90.0 180.0", (0, 0, -9.81)), ("spherical 90.0 90.0", (0, 9.81, 0))):
        (row,) = json_of("energy", logged("told", head + fix + words + "\n" + tail))
        assert row["gravity_from"] == "log"
        assert all(abs(row[f"gravity_{a}_m_per_s2"] - e) < 1e-9 for a, e in zip("xyz", expected)), (words, row)
    name = logged("varied", head + "fix g all gravity v_pull vector 0.0 0.0 -1.0\n" + tail)
    refused("energy", name, words=("v_pull", "--gravity"))
    refused("bed", name, "--box", "-1", 1, "-1", 1, "-1", 1, words=("v_pull", "--up"))
    post("bed", name, "--up", "z", "--box", "-1", 1, "-1", 1, "-1", 1)
    (row,) = json_of("energy", name, "--gravity", 0, 0, -1)
    assert row["gravity_from"] == "option"
    # a variable's name comes first, its value in the next line
    (row,) = json_of("energy", logged("named", head + "fix g all gravity ${g} vector 0.0 0.0 -1.0\n" + fix.replace("9.81", "5.0")
                                      + "vector 0.0 0.0 -1.0\n" + tail))
    assert row["gravity_z_m_per_s2"] == -5.0
    (row,) = json_of("energy", logged("lifted", head + fix + "vector 0.0 0.0 -1.0\nunfix g\n" + fix.replace("9.81", "1.0").replace(" g ", " h ")
                                      + "vector 0.0 -1.0 0.0\n" + tail))
    assert (row["gravity_y_m_per_s2"], row["gravity_z_m_per_s2"]) == (-1.0, 0.0)
    # several logs: the first one, and this is said
    _, error = post("energy", logged("several", head + fix + "vector 0.0 0.0 -1.0\n" + tail, head + fix + "vector 0.0 -1.0 0.0\n" + tail))
    assert error.count("several logs") == 1 and "several/log.0 is taken" in error and "several/log.1" in error, error


def check_forced_ends():
    """A run that was killed at step 300 of 1000, and its log as the resumed run goes on with it."""
    killed = "timestep 1e-5\nrun 1000\nStep Atoms\n0 2\n300 2\n"
    resumed = "LIGGGHTS (Version LIGGGHTS-PUBLIC)\nread_restart a.restart\nrun 300\nStep Atoms\n300 2\n600 2\nLoop time of 1 on 1 procs\n"
    for folder, log, is_complete in (("killed", killed, False), ("resumed", killed + resumed, True),
                                     ("killed_again", killed + resumed.replace("run 300", "run 900"), False)):
        _, error = post("pile", logged(folder, log), "--no-wall", "--section", 0.0, expect=None)
        assert ("the run is not complete" in error) != is_complete, (folder, error)


def title(folder, log):
    post("render3d", logged(folder, log), "-o", "title.svg", "--width", 300, "--height", 200)
    with open("title.svg", encoding="utf8") as file:
        text = file.read()
    return "t = 0.006 s" in text, "time step 600" in text


def check_times():
    """Seconds above a picture only where all steps had one length."""
    run = "run 600\nStep Atoms\n0 2\n600 2\nLoop time of 1 on 1 procs\n"
    assert title("even", "timestep 1e-5\n" + run) == (True, False)
    assert title("again", "timestep 1e-5\n" + run + "timestep 1e-5\n" + run) == (True, False)
    for words in ("timestep 2e-5\n" + run + "timestep 1e-5\n", "timestep 1e-5\nreset_timestep 0\n", "read_restart a.restart\ntimestep 1e-5\n",
                  "timestep 1e-5\nfix t all dt/reset 10 1e-6 1e-5 0.01\n"):
        assert title("uneven", words + run) == (False, True), words


def check_pictures():
    name = write("row.dump", frame_text(1, [particle(k + 1, 2e-3 * k, 2e-3) for k in range(3)]))
    nothing = write("nothing.dump", frame_text(1, []) + frame_text(2, []))
    for command, more in (("film", ()), ("film", ("--space",)), ("render", ("--frame", "all")), ("render3d", ("--frame", "all"))):
        _, error = post(command, nothing, *more, "-o", f"{command}_*.png", expect=1)
        assert "there is no picture" in error, (command, error)
    assert "no particle lies in --view" in post("render", name, "--view", 1, 2, 1, 2, "-o", "away.svg")[1]
    assert "--view" not in post("render", name, "--view", 0, 0.01, 0, 0.01, "-o", "there.svg")[1]
    assert "no particle lies in --view" in post("render3d", name, "--view", 1, 2, 1, 2, 1, 2, "-o", "away.png")[1]
    assert "--view" not in post("render3d", name, "--view", -0.01, 0.01, -0.01, 0.01, -0.01, 0.01, "-o", "there.png")[1]


def check_ranges():
    """The lower one of two bounds comes first; else nothing is drawn or measured."""
    name = write("range.dump", frame_text(1, [particle(k + 1, 2e-3 * k, 2e-3) for k in range(3)]))
    for command in (("render", name, "-o", "n.svg"), ("render3d", name, "-o", "n.png"), ("film", name, "-o", "n_*.png"),
                    ("film", name, "--space", "-o", "n_*.png")):
        for bounds in ((5, 2), (3, 3)):
            refused(*command, "--colour", "id", "--colour-range", *bounds, words=("--colour-range", "lower bound first", "{} {}".format(*bounds)))
        post(*[word.replace("n", "good", 1) if word.startswith("n") else word for word in command], "--colour", "id", "--colour-range", 2, 5)
    for command, option, bounds in ((("render", name, "-o", "n.svg"), "--view", (0, 1, 1, 0)), (("film", name, "-o", "n_*.png"), "--view", (1, 0, 0, 1)),
                                    (("film", name, "--space", "-o", "n_*.png"), "--part", (0, 1, 0, 1, 1, 0)),
                                    (("render3d", name, "-o", "n.png"), "--view", (0, 1, 2, 1, 0, 1)), (("mixing", name), "--region", (0, 1, 0, 1, 1, 0))):
        refused(*command, option, *bounds, words=(option, "lower bound first"))
    assert not [file for file in os.listdir(".") if file.startswith("n_") or file in ("n.svg", "n.png")]
    assert json_of("mixing", name, "--region", 0, 1e-3, 0, 1, 0, 0, "--neighbours", 1, "--cell", 3e-3)  # all in one plane


def check_gaps_of_tables():
    """Curves and maps say what has no number; of two columns of one name none is taken."""
    curve = lambda text, *more: post("plot", "curve", write("gaps.csv", text), "--x", "t", "--y", "v", *more, "-o", "gaps.svg")[1]
    assert "warning" not in curve("t,v\n0,1\n1,2\n2,3\n")
    for gap in ("1,nan", "1,inf", "1,", "nan,2", ",2"):
        assert '1 of 3 rows have no number in "t" or "v" and are left out of the curve' in curve(f"t,v\n0,1\n{gap}\n2,3\n"), gap
        with open("gaps.svg", encoding="utf8") as file:
            assert "nan" not in file.read()
    assert '2 of 3 rows have no number in "m" and no error bar' in curve("t,v,m\n0,1,nan\n1,2,\n2,3,1\n", "--margin", "m")
    refused("plot", "curve", write("gaps.csv", "t,v\n0,nan\n1,nan\n"), "--x", "t", "--y", "v", "-o", "none.svg", words=('no row has a number in both "t" and "v"',))
    for command in (("plot", "curve", "twice.csv", "--x", "t", "--y", "v", "-o", "none.svg"), ("summary", "twice.csv", "--quantity", "v"),
                    ("report", "range.dump", "--table", "twice.csv", "-o", "none.html")):
        write("twice.csv", "t,v,v\n0,1,2\n1,2,3\n")
        out, error = post(*command, expect=1)
        assert 'twice.csv:1: expected one column "v", found several: give each a name' in error, (command, out, error)
    grid = [(x, y, x + y) for x in range(4) for y in range(3)]
    plot_map = lambda rows: post("plot", "map", write("map.csv", "x,y,v\n" + "".join(f"{x},{y},{v}\n" for x, y, v in rows)), "--x", "x", "--y", "y",
                                 "--value", "v", "-o", "map.svg")[1]
    assert "warning" not in plot_map(grid)
    assert '1 of 12 cells have no value in "v" and stay blank' in plot_map([r for r in grid if r[:2] != (1, 1)])
    for gap in ("nan", "-inf", ""):
        error = plot_map([(x, y, gap if x == 3 or (x, y) == (0, 0) else v) for x, y, v in grid])
        assert '4 of 12 cells have no value in "v" and stay blank' in error, (gap, error)
    assert "2 rows lie over rows before them" in plot_map(grid + grid[:2])
    assert '1 of 13 rows have no number in "x" or "y"' in plot_map(grid + [("nan", 1, 2)])
    post("report", "range.dump", "--map", "map.csv", "x", "y", "v", "-o", "gaps.html", expect=None)
    with open("gaps.html", encoding="utf8") as file:
        assert "1 of 13 rows have no number" in file.read()


def check_runs_without_values():
    """Means and figures of the paper name the runs that have no value of a quantity."""
    keys = ("surface,subspheres,repose_angle_deg,porosity,zpp,zss,relative_cpu_time,potential_contacts_per_particle,run\n")
    rows = ["smooth,,25,0.15,3,3,4,1.5,a", "smooth,,{},0.13,{},3.2,{},1.6,b", "multisphere,5,29,{},3.5,4,5,{},c", "multisphere,5,30,0.2,3.6,4.1,6,8,d"]
    for gap in ("nan", "inf", "-inf", ""):
        name = write("runs.csv", keys + "\n".join(rows).replace("{}", gap) + "\n")
        out, error = post("summary", name, "--json", "-")
        for key, run in (("repose_angle_deg", "b"), ("porosity", "c"), ("zpp", "b")):
            assert f'1 of 4 runs has no number in "{key}" ({run}): not in its mean' in error, (gap, key, error)
        assert error.count("warning") == 3 and "nan" not in out and "inf" not in out, (gap, out, error)
        smooth = next(row for row in json.loads(out) if row["surface"] == "smooth")
        assert smooth["repose_angle_mean_deg"] == 25 and smooth["porosity_mean"] == 0.14, smooth
        for number, missing in ((12, ("repose_angle_deg",)), (13, ("porosity", "zpp")), (15, ("repose_angle_deg", "porosity")),
                                (17, ("relative_cpu_time",)), (18, ("potential_contacts_per_particle",))):
            _, error = post("plot", number, name, "-o", "figure.svg")
            assert error.count("has no number in") == len(missing), (gap, number, error)
            assert all(f'1 of 4 runs has no number in "{key}"' in error for key in missing), (gap, number, error)
            with open("figure.svg", encoding="utf8") as file:
                text = file.read()
            assert "nan" not in text and "inf" not in text, (gap, number)
    whole = write("runs.csv", keys + "\n".join(rows).replace("{}", "2") + "\n")
    assert "warning" not in post("summary", whole)[1] + post("plot", 13, whole, "-o", "figure.svg")[1]


def check_numbers_of_options():
    """Neither nan nor inf is a number for any option that takes numbers."""
    name = write("numbers.dump", frame_text(1, [particle(k + 1, 2e-3 * k, 2e-3) for k in range(3)]))
    for command in (("trajectory", name, "--dt"), ("coordination", name, "--contact-gap"), ("pile", name, "--wall"), ("pile", name, "--columns"),
                    ("fields", name, "--at", 0, 0), ("flow", name, "--through", 0, 0, 0, 0, 0), ("energy", name, "--gravity", 0, 0),
                    ("render3d", name, "-o", "n.png", "--zoom"), ("mixing", name, "--value", "x", "--cell"), ("bed", name, "--box", 0, 1, 0, 1, 0)):
        for word in ("nan", "inf", "NaN", "1e999"):
            out, error = post(*command, word, expect=2)
            assert out == "" and ("finite" in error or "range" in error), (command, word, error)


def check_sizes():
    """Bodies far larger than a box that repeats."""
    small = [particle(k + 1, 2e-3 * k, 2e-3) for k in range(3)]
    small[1]["shapex"] = 5.0
    boxed = frame_text(1, small).replace("mm mm ff", "pp pp pp").replace("\n0 0.5\n-0.005 0.2\n", "\n0 0.02\n0 0.02\n")
    name = write("giant.dump", boxed)
    for command in (("coordination", "--space"), ("pairs", "--gap", 1e-3), ("fields", "--grid", 2, 2, 2), ("contacts",), ("view", "-o", "giant.html")):
        _, error = post(command[0], name, *command[1:], expect=1)
        assert "images of the box" in error and error.count("error: ") == 1, (command, error)
    assert json_of("coordination", name, "--space", "--periodic", "none")[0]["particles"] == 3


def check_results_over_inputs():
    """What a command has read it does not write over; two results do not share a file; a run does not count twice."""
    text = frame_text(1, [particle(k + 1, 2e-3 * k, 2e-3) for k in range(3)])
    name = write("kept.dump", text)
    os.symlink("kept.dump", "link.dump")
    post("energy", name, "--csv", "kept.csv", "--quiet")
    for command in (("energy", name, "--csv", name), ("energy", name, "--json", "./kept.dump"), ("energy", name, "--csv", "link.dump"),
                    ("coordination", name, "--space", "--per-particle", name), ("contacts", name, "--list", name),
                    ("summary", "kept.csv", "--group", "run", "--quantity", "translation_J", "--csv", "kept.csv")):
        before = {file: os.path.getsize(file) for file in ("kept.dump", "kept.csv")}
        _, error = post(*command, "--quiet", expect=1)
        assert "has been read and is not written over" in error, (command, error)
        assert before == {file: os.path.getsize(file) for file in before}, command
    for where in ("-", "both.txt"):
        assert "both name" in post("energy", name, "--csv", where, "--json", where, expect=1)[1]
    for command in (("energy", name, name), ("pile", "kept.dump", "kept.d*p"), ("energy", "--one-run", name, name)):
        refused(*command, words=("kept.dump is named twice",))
    for other in "./kept.dump", "link.dump", os.path.abspath("kept.dump"):
        refused("energy", name, other, words=("kept.dump and " + other + " are one file",))


def main():
    check_line_ends()
    check_restarts()
    check_empty_last_frame()
    check_sides_not_said()
    check_absence()
    check_no_particle_stays()
    check_unknown_errors()
    check_long_steps()
    check_unwrapped_steps()
    check_columns()
    check_boxes()
    check_logs()
    check_forced_ends()
    check_times()
    check_pictures()
    check_sizes()
    check_results_over_inputs()
    check_numbers_of_options()
    check_ranges()
    check_gaps_of_tables()
    check_runs_without_values()
    assert len(rows_of("energy", "plain.dump")) == 1


main()
