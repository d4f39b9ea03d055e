# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""The commands on piles: figures, invariances, output formats, bad input, exit codes."""
import gzip
import math
import os
import random
import re
import resource

from _synthetic import (B, COLUMNS, frame_text, json_of, particle, post, rows_of, wedge, write)

MEASURES = ("repose_angle_deg", "porosity", "zpp", "zss", "total_area_m2", "solid_area_m2",
            "mean_overlap_b", "rattlers")


def figures(*arguments, **options):
    (row,) = rows_of("pile", *arguments, **options)
    return {key: row[key] for key in MEASURES}


def check_invariances(pile):
    text = frame_text(100, pile)
    reference = figures(write("one.dump", text))
    assert abs(float(reference["repose_angle_deg"]) - 25.0) < 0.7, reference

    shuffled = pile[:]
    random.Random(5).shuffle(shuffled)
    assert figures(write("shuffled.dump", frame_text(100, shuffled))) == reference
    columns = COLUMNS[:]
    random.Random(6).shuffle(columns)
    assert figures(write("columns.dump", frame_text(100, pile, columns))) == reference
    with gzip.open("packed.dump.gz", "wt") as file:
        file.write(text)
    assert figures("packed.dump.gz") == reference
    assert figures("-", stdin=text) == reference

    half = frame_text(99, pile[: len(pile) // 2])
    assert figures(write("many.dump", half + text)) == reference
    write("pile.0000000099.dump", half)
    write("pile.0000000100.dump", text)
    write("pile.0000000009.dump", frame_text(9, pile[:1]))
    names = ["pile.%010d.dump" % step for step in (100, 9, 99)]
    assert figures(*names) == reference
    assert figures("pile.*.dump") == reference
    assert figures("many.dump", "--frame", 100) == reference
    strays = [particle(10000 + k, 0.3 + 0.01 * k, 1.15e-3) for k in range(5)]
    with_strays = figures(write("strays.dump", frame_text(100, pile + strays)))
    assert with_strays == reference, (with_strays, reference)
    return reference


def check_two_sided():
    """A heap without a wall, 25 degrees on its right and 20 on its left flank."""
    right = [{**row, "x": 0.2 + row["x"]} for row in wedge(25.0)]
    left = [{**row, "x": 0.2 - row["x"], "id": 5000 + row["id"]} for row in wedge(20.0)]
    # in every second row the two lattices leave room for one particle in the middle
    seam = [particle(9000 + j, 0.2, B + 0.9999 * j * B * math.sqrt(3.0)) for j in range(1, 29, 2)]
    name = write("two_sided.dump", frame_text(1, right + left + seam))
    (pile,) = rows_of("pile", name, "--no-wall")
    (repose,) = rows_of("repose", name, "--no-wall")
    angles = {}
    for side in "", "_left", "_right":
        key = f"repose_angle{side}_deg"
        assert repose[key] == pile[key], side
        angles[side] = float(pile[key])
    assert abs(angles["_left"] - 20.0) < 0.7 and abs(angles["_right"] - 25.0) < 0.7, angles
    assert abs(angles[""] - (angles["_left"] + angles["_right"]) / 2) < 1e-12, angles
    error = math.hypot(*(float(pile[f"repose_angle_standard_error_{s}_deg"]) for s in ("left", "right")))
    assert abs(float(pile["repose_angle_standard_error_deg"]) - error / 2) < 1e-12
    ends = [float(pile[f"point_b_x_{side}_m"]) for side in ("left", "right")]
    assert ends[0] < 0.1 and ends[1] > 0.3, ends
    (whole,), (middle,), (core,) = (rows_of("porosity", name, "--no-wall", "--region", region)
                                    for region in ("whole", "middle", "core"))
    assert float(core["porosity"]) < float(middle["porosity"]) < float(whole["porosity"])
    # away from the surface the lattice of touching ellipses; the region's rim cuts through its cells
    lattice = 1 - math.pi / (2 * math.sqrt(3))
    assert abs(float(core["porosity"]) / lattice - 1) < 0.02, (core, lattice)
    post("render", name, "--no-wall", "-o", "two_sided.svg")
    with open("two_sided.svg", encoding="utf8") as file:
        text = file.read()
    assert text.count(">A<") == text.count(">B<") == 2 and text.count("°") == 4, "both flanks are drawn"


def check_formats(reference):
    (object_,) = json_of("pile", "one.dump")
    assert object_["repose_angle_deg"] == float(reference["repose_angle_deg"])
    assert object_["surface"] == "smooth" and object_["subspheres"] is None
    text, _ = post("pile", "one.dump", "--csv", "t.csv", "--json", "t.json")
    assert "angle of repose" in text and "deg" in text and os.path.getsize("t.json") > 100
    for command, key in (("repose", "repose_angle_deg"), ("porosity", "porosity"),
                         ("coordination", "zpp")):
        (row,) = rows_of(command, "one.dump")
        assert row[key] == reference[key]
    for picture in ("pile.svg", "pile.png"):
        post("pile", "one.dump", "--picture", picture)
    with open("pile.svg", encoding="utf8") as file:
        assert file.read().count("<ellipse") == 2 * len(wedge())
    with open("pile.png", "rb") as file:
        assert file.read(8) == b"\x89PNG\r\n\x1a\n"
    for view, count in ((0, 0.2, 0, 0.1), 1), ((0, 0.03, 0, 0.02), 0):  # A and B are in the first
        post("render", "one.dump", "-o", "view.svg", "--view", *view)
        with open("view.svg", encoding="utf8") as file:
            assert file.read().count(">A<") == count, view
    post("render", "many.dump", "--frame", "all", "-o", "film_*.svg", "--colour", "angle")
    assert os.path.exists("film_0000000099.svg") and os.path.exists("film_0000000100.svg")


def check_fine_chains(reference):
    """With 55 sub-spheres all areas and the surface are the ellipse's within the chain's error."""
    (shape,) = rows_of("template", "--subspheres", 55)
    missing_area = 1 - float(shape["area_ratio"])
    fine = figures(write("fine.dump", frame_text(100, wedge(subspheres=55))))
    solid = float(fine["solid_area_m2"]) / float(reference["solid_area_m2"])
    assert abs(1 - solid - missing_area) < 0.1 * missing_area, (solid, missing_area)
    total = float(fine["total_area_m2"]) / float(reference["total_area_m2"])
    assert 0 < 1 - total < missing_area, (total, missing_area)
    assert abs(float(fine["repose_angle_deg"]) - float(reference["repose_angle_deg"])) < 0.01
    assert abs(float(fine["porosity"]) - float(reference["porosity"])) < missing_area
    # chains are thinner than the ellipse by up to the outline's deviation: so much closer they touch
    gap = 2 * float(shape["outline_deviation_b"])
    (near,) = rows_of("coordination", "fine.dump", "--contact-gap", gap)
    (smooth,) = rows_of("coordination", "one.dump", "--contact-gap", gap)
    assert (near["zpp"], near["rattlers"]) == (smooth["zpp"], smooth["rattlers"]), (near, smooth)
    for command, key in (("orientation", "nematic_order"), ("energy", "potential_J")):
        values = [rows_of(command, name)[0][key] for name in ("fine.dump", "one.dump")]
        assert values[0] == values[1], (command, values)


def check_summary():
    write("other.dump", frame_text(3, wedge(22.0)))
    write("coarse.dump", frame_text(3, wedge(25.0, subspheres=5)))
    text, _ = post("pile", "one.dump", "other.dump", "coarse.dump", "--csv", "runs.csv")
    assert "Mean and margin" in text
    rows = rows_of("summary", "runs.csv")
    smooth = next(row for row in rows if row["surface"] == "smooth")
    runs = rows_of("pile", "one.dump", "other.dump")
    angles = [float(row["repose_angle_deg"]) for row in runs]
    assert smooth["runs"] == "2"
    assert abs(float(smooth["repose_angle_mean_deg"]) - sum(angles) / 2) < 1e-12
    assert abs(float(smooth["repose_angle_half_range_deg"]) - abs(angles[0] - angles[1]) / 2) < 1e-12
    post("plot", 12, "runs.csv", "-o", "figure12.svg")
    post("plot", 13, "runs.csv", "-o", "figure13.png")
    post("plot", 5, "-o", "figure5.svg")
    post("plot", 15, "runs.csv", "-o", "figure15.svg")
    _, error = post("plot", 17, "runs.csv", "-o", "figure17.svg", expect=1)
    assert '"relative_cpu_time"' in error and "found only: run, timestep, surface" in error
    _, error = post("plot", 12, "runs.csv", "-o", "figure12.jpg", expect=2)
    assert ".svg or .png" in error
    _, error = post("summary", "runs.csv", "--quantity", "porosity,angle", expect=1)
    assert 'runs.csv: expected a column "angle"' in error and "repose_angle_deg" in error
    _, error = post("summary", write("x.csv", "x,y\n1,2\n"), expect=1)
    assert 'x.csv: expected a column "repose_angle_deg"' in error
    post("pile", "coarse.dump", "--outline", "ellipse", "--quiet", "--csv", "ellipse.csv")
    rows = rows_of("summary", "runs.csv", "ellipse.csv")
    assert [(row["subspheres"], row["outline"], row["runs"]) for row in rows] == [
        ("5", "ellipse", "1"), ("5", "true", "1"), ("-", "true", "2")], rows
    rows = rows_of("summary", "runs.csv", "ellipse.csv", "--group", "surface")
    assert [(row["surface"], row["runs"]) for row in rows] == [("multisphere", "2"), ("smooth", "2")]
    for command in ("summary", write("words.csv", "surface,porosity\nsmooth,0.1\nsmooth,much\n")), \
            ("plot", 13, "words.csv", "-o", "figure13.svg"):
        _, error = post(*command, expect=1)
        assert 'words.csv:3: expected a number in column "porosity", found "much"' in error, error
    post("report", "one.dump", "other.dump", "coarse.dump", "-o", "report.html")
    with open("report.html", encoding="utf8") as file:
        page = file.read()
    assert re.search('<th scope="col">run</th>' + "".join(
        f'<th scope="col">{name}.dump</th>' for name in ("coarse", "one", "other")), page)  # natural order
    assert re.search("coarse.dump: [^<]*, multisphere, N = 5", page) and "No log file" in page
    assert page.count("<figure>") >= 5 and "http" not in page.replace("http-equiv", "")


def check_bad_input(pile):
    whole = frame_text(1, pile)
    cut = whole + frame_text(2, pile)[:-2000]
    out, error = post("pile", write("cut.dump", cut), expect=1)
    assert "angle of repose" in out and "cut.dump:" in error and "frame 2" in error, error
    assert len(error.strip().splitlines()) == 1
    cases = {
        "missing.dump": (frame_text(1, pile, [c for c in COLUMNS if c != "quat3"]), "quat3"),
        "nan.dump": (whole.replace(f"\n1 1 2e-05 {pile[0]['x']!r} ", "\n1 1 2e-05 nan ", 1), "finite number"),
        "count.dump": (whole.replace(f"\n{len(pile)}\n", f"\n{len(pile) + 1}\n", 1), "row"),
        "empty.dump": ("", "expected at least one frame, found none: the file is empty"),
        "none.dump": (frame_text(1, []), "at least one particle"),
    }
    for name, (text, message) in cases.items():
        out, error = post("pile", write(name, text), expect=1)
        assert out == "" and message in error and name in error, (name, out, error)
    with open("rubbish.dump", "wb") as file:
        file.write(bytes(random.Random(1).randrange(256) for _ in range(5000)))
    _, error = post("pile", "rubbish.dump", expect=1)
    assert "rubbish.dump:1" in error, error
    _, error = post("pile", write("binary_7.dump", "\0\1\2"), "one.dump", "--csv", "kept.csv", expect=1)
    assert "binary_7.dump:1: frame 1: expected text, found a NUL byte" in error, error
    assert len(rows_of("summary", "kept.csv")) == 1  # the other run is measured all the same
    _, error = post("pile", "many.dump", "--frame", 7, expect=1)
    assert "many.dump: expected a frame of time step 7, found 2 frames: time steps 99 to 100" in error
    _, error = post("energy", write("cgs.dump", "ITEM: UNITS\ncgs\n" + whole))
    assert error.count("\n") == 1 and "cgs.dump" in error and "'cgs'" in error, error
    assert post("energy", write("si.dump", "ITEM: UNITS\nsi\n" + whole))[1] == ""
    _, error = post("pile", "no_such_file.dump", expect=1)
    assert "no_such_file.dump" in error
    _, error = post("pile", "one.dump", "no_such_file.dump", "--quiet", "--csv", "kept.csv", expect=1)
    with open("kept.csv", encoding="ascii") as file:
        assert len(file.readlines()) == 2
    post("pile", expect=2)
    post("pile", "one.dump", "--cut-top", "2", expect=2)
    post("pile", "one.dump", "--frame", "middle", expect=2)
    _, error = post("nonsense", expect=2)
    assert error.count("\n") == 1 and "'nonsense'" in error and "render3d" in error, error
    _, error = post("render", "one.dump", "-o", "pile.jpg", expect=2)
    assert ".svg or .png" in error
    _, error = post("render", "one.dump", "-o", "pile.svg", "--colour", "nothing", expect=1)
    assert "nothing" in error


def check_threads(pile):
    """Frames measured in threads: the rows in order, the same digits, errors in their place."""
    other = wedge(22.0)
    frames = [frame_text(k, other if k % 3 == 0 else pile[k:]) for k in range(24)]
    write("frames.dump", "".join(frames))
    one = rows_of("pile", "frames.dump", "--frame", "all", "--threads", 1)
    assert [row["timestep"] for row in one] == [str(k) for k in range(24)]
    for threads in (2, 5):
        assert rows_of("pile", "frames.dump", "--frame", "all", "--threads", threads) == one
    frames[5] = frame_text(5, [])  # cannot be measured
    frames[9] = frames[9][:-100]  # cannot be read
    write("frames.dump", "".join(frames))
    for threads in (1, 4):
        out, error = post("repose", "frames.dump", "--frame", "all", "--threads", threads, "--csv",
                          "-", expect=1)
        steps = [line.split(",")[1] for line in out.splitlines()[1:]]
        assert steps == ["0", "1", "2", "3", "4", "6", "7", "8"], steps
        first, second = error.splitlines()
        assert "time step 5" in first and "frame 10" in second, error
    post("pile", "one.dump", "--threads", "-1", expect=2)


def check_digits_warning(pile):
    rounded = [{k: float(f"{v:.6g}") if isinstance(v, float) else v for k, v in row.items()}
               for row in pile]
    _, error = post("coordination", write("rounded.dump", frame_text(1, rounded)))
    assert "six digits" in error
    _, error = post("coordination", "one.dump")
    assert error == ""


def processor_time(*arguments):
    """Processor time of one run of ellipsoid-post (s)."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    post(*arguments)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def check_speed(pile):
    """The reader's speed is printed, not judged: machines differ."""
    rows = [{**row, "id": k + 1} for k, row in enumerate(pile * 5)]
    text = frame_text(123456, rows)
    with open("large.dump", "w", encoding="ascii") as file:
        for step in range(100):
            file.write(text.replace("123456", str(step), 1))
    size = os.path.getsize("large.dump") / 1e6
    seconds = processor_time("energy", "large.dump", "--frame", "last")
    print(f"reading: {size:.0f} MB in {seconds:.2f} s of processor time, "
          f"{size / max(seconds, 1e-3):.0f} MB/s")
    os.remove("large.dump")


def main():
    pile = wedge()
    reference = check_invariances(pile)
    check_two_sided()
    check_formats(reference)
    check_fine_chains(reference)
    check_summary()
    check_bad_input(pile)
    check_threads(pile)
    check_digits_warning(pile)
    check_speed(pile)


main()
