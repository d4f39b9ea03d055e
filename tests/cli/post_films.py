# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""Films: one size, one view and one colour range for all pictures, none written over another, frames
without particles left out with a remark; ffmpeg is handed the pictures in the order of time."""
import glob
import os
import re

import numpy as np

from _png import pixels_of
from _synthetic import B, frame_text, particle, post, wedge, write


def png_size(name):
    with open(name, "rb") as file:
        head = file.read(24)
    return int.from_bytes(head[16:20], "big"), int.from_bytes(head[20:24], "big")


def falling(count, height):
    """A pile that grows, and a particle above it."""
    pile = [dict(row) for row in wedge()][:count]
    return pile + [dict(particle(9999, 5 * B, height, speed=0.1 * count))]


def series():
    write("pile.0000000000.dump", frame_text(0, []))  # as the first frame of inputs/piling.in
    for step, count, height in ((50, 3, 0.05), (100, 40, 0.08), (1000, 300, 0.1)):
        write(f"pile.{step:010d}.dump", frame_text(step, falling(count, height)))


def ticks(svg):
    """Numbers below the colour bar and the ends of the scale bar's words."""
    with open(svg, encoding="utf8") as file:
        text = file.read()
    return text, re.findall(r'text-anchor="middle"[^>]*>(-?[0-9.e+-]+)</text>', text)


def check_render():
    _, error = post("render", "pile.*.dump", "--frame", "all", "-o", "film_*.png", "--colour", "angle")
    names = sorted(glob.glob("film_*.png"))
    assert names == [f"film_{step:010d}.png" for step in (50, 100, 1000)], names
    sizes = {png_size(name) for name in names}
    assert len(sizes) == 1 and all(side % 2 == 0 for side in sizes.pop()), sizes
    assert error.count("warning: ") == 1 and "time step 0 holds no particles" in error, error
    post("render", "pile.*.dump", "--frame", "all", "-o", "speed_*.svg", "--colour", "speed")
    pages = [ticks(name) for name in sorted(glob.glob("speed_*.svg"))]
    assert len({tuple(numbers) for _, numbers in pages}) == 1, [p[1] for p in pages]  # one scale
    numbers = [float(n) for n in pages[0][1]]
    assert len(numbers) >= 4 and numbers == sorted(numbers) and numbers[-1] <= 30.0, numbers
    bars = {re.search(r">([0-9.]+ mm)<", page).group(1) for page, _ in pages}
    assert len(bars) == 1, bars
    post("render3d", "pile.*.dump", "--frame", "all", "-o", "space_*.png", "--width", 320, "--height", 240)
    assert {png_size(name) for name in glob.glob("space_*.png")} == {(320, 240)}
    assert len(glob.glob("space_*.png")) == 3


def check_nothing_is_overwritten():
    for command in (("render", "-o"), ("render3d", "-o"), ("pile", "--picture")):
        _, error = post(command[0], "pile.*.dump", "--frame", "all", command[1], "one.png", expect=2)
        assert "asterisk" in error and not os.path.exists("one.png"), error
    one = write("one.dump", frame_text(5, wedge()))
    two = write("two.dump", frame_text(5, wedge(22.0)))
    _, error = post("render", one, two, "-o", "same_*.svg", expect=1)
    assert "same_0000000005.svg is there already" in error and "two.dump" in error, error
    with open("same_0000000005.svg", "rb") as file:
        first = file.read()
    post("render", one, "-o", "alone.svg")
    with open("alone.svg", "rb") as file:
        assert file.read() == first
    with open(one, encoding="ascii") as file:
        _, error = post("render", "-", "--frame", "all", "-o", "pipe_*.svg", expect=1, stdin=file.read())
    assert "pipe" in error and "--view" in error, error


def check_kinds_and_times():
    rows = [dict(row) for row in wedge()]
    for k, row in enumerate(rows):
        row["type"] = 1 + k % 3
    os.makedirs("timed", exist_ok=True)
    write("timed/log.run", "timestep 2e-5\n")
    name = write("timed/pile.dump", frame_text(5000, rows))
    post("render", name, "-o", "types.svg", "--colour", "type")
    page, numbers = ticks("types.svg")
    assert numbers == ["1", "2", "3"] and "t = 0.1 s" in page, (numbers, page[:400])
    # one stray does not stretch the scale
    rows[0]["mass"] = 1e6
    post("render", write("stray.dump", frame_text(1, rows)), "-o", "stray.svg", "--colour", "mass")
    _, numbers = ticks("stray.svg")
    assert all(float(n) < 1 for n in numbers), numbers
    post("plot", 5, "-o", "figure5.svg")
    with open("figure5.svg", encoding="utf8") as file:
        figure = file.read()
    assert "A_MS" not in figure and re.search(r"A<tspan[^>]*>MS</tspan>", figure), figure[:300]
    post("plot", 5, "-o", "figure5.png")


def check_film():
    """With a program in the path that stands for ffmpeg and keeps what it is given."""
    os.mkdir("programs")
    with open("programs/ffmpeg", "w", encoding="ascii") as file:
        file.write("#!/bin/bash\n[[ $* != *-version* ]] || exit 0\nprintf '%s\\n' \"$@\" >arguments\n"
                   "pattern=\nwhile [[ $# -gt 1 ]]; do [[ $1 != -i ]] || pattern=$2; shift; done\n"
                   "ls $pattern >pictures\ncp $(head -n 1 pictures) first.png\necho film >\"$1\"\n")
    os.chmod("programs/ffmpeg", 0o755)
    before, os.environ["PATH"] = os.environ["PATH"], os.path.abspath("programs") + ":" + os.environ["PATH"]
    _, error = post("film", "pile.*.dump", "-o", "a film.mp4", "--width", 801, "--rate", 10)
    assert "film: a film.mp4" in error and "holds no particles" in error, error
    with open("pictures", encoding="ascii") as file:
        names = [os.path.basename(line.strip()) for line in file]
    assert names == [f"film_{step:010d}.png" for step in (50, 100, 1000)], names
    with open("arguments", encoding="ascii") as file:
        words = file.read().splitlines()
    assert words[words.index("-framerate") + 1] == "10" and words[-1] == "a film.mp4", words
    assert not os.path.exists(os.path.dirname(words[words.index("-i") + 1]))  # tidied up
    assert png_size("first.png")[0] == 801
    post("film", "pile.*.dump", "--space", "-o", "space.mp4", "--width", 200, "--height", 100)
    assert png_size("first.png") == (200, 100)
    with open("programs/ffmpeg", "w", encoding="ascii") as file:
        file.write("#!/bin/bash\n[[ $* == *-version* ]]\n")
    _, error = post("film", "pile.*.dump", "-o", "broken.mp4", expect=1)
    assert "ffmpeg ended with status 1" in error, error
    os.environ["PATH"] = before
    os.environ["PATH"] = os.path.abspath(".")  # no ffmpeg here
    _, error = post("film", "pile.*.dump", "-o", "none.mp4", expect=1)
    assert "ffmpeg" in error and "'film_*.png'" in error and not os.path.exists("none.mp4"), error
    os.environ["PATH"] = before
    post("film", "pile.*.dump", "-o", "numbered_*.svg")
    assert len(glob.glob("numbered_*.svg")) == 3


def stl(triangles):
    facets = ("facet normal 0 0 0\nouter loop\n" + "".join(f"vertex {x} {y} {z}\n" for x, y, z in t) +
              "endloop\nendfacet\n" for t in triangles)
    return "solid s\n" + "".join(facets) + "endsolid s\n"


def dark_places(line):
    """Middles of the groups of pixels that are not white."""
    dark = np.flatnonzero(line.min(axis=1) < 230)
    return [group.mean() for group in np.split(dark, np.flatnonzero(np.diff(dark) > 2) + 1) if len(group)]


def check_walls_and_meshes():
    """Seen along y, upright: x and z are pixels times one scale, known from the mesh's own sides."""
    os.makedirs("walled", exist_ok=True)
    write("walled/plate.stl", stl([[(0, 0, 0), (30, 0, 0), (30, 0, 40)], [(0, 0, 0), (30, 0, 40), (0, 0, 40)]]))
    write("walled/log.run", "fix floor all wall/gran/ellipsoid model hertz surface smooth primitive type 1 zplane 0.005\n"
          "fix far all wall/gran/ellipsoid model hertz surface smooth primitive type 1 zplane 7.0\n"
          "fix plate all mesh/surface file plate.stl type 1 scale 0.001 move 0.01 0. 0.02\n"
          "fix belt all mesh/surface file plate.stl type 1\nfix m all move/mesh mesh belt linear 1. 0. 0.\n")
    rows = [particle(1, 0.02, 0.0), particle(2, 0.03, 0.0)]
    for row in rows:
        row["z"] = 0.03
    name = write("walled/bed.dump", frame_text(3, rows))
    camera = ("--azimuth", -90, "--elevation", 0, "--view", 0, 0.06, -0.01, 0.01, 0, 0.08, "--width", 600, "--height", 450, "--no-axes")
    _, error = post("render3d", name, "-o", "walls.png", "--show-walls", *camera)
    assert "mesh belt (plate.stl) is not shown: it moves" in error, error
    picture = pixels_of("walls.png")[26:418]  # without heading and scale bar
    sides = dark_places(picture[len(picture) // 4])  # at z = 0.06 or so, above the particles
    across = [line for line in (dark_places(picture[k]) for k in range(len(picture))) if len(line) == 2]
    left, right = np.median(np.array(across), axis=0)  # x = 0.01 and 0.04: the rim, without the seam of the two triangles
    assert len(across) > 50 and len(sides) <= 2, (len(across), sides)
    scale = (right - left) / 0.03
    middle = round(0.5 * (left + right))  # x = 0.025, between the particles
    top, bottom, floor = dark_places(picture[:, middle])  # z = 0.06, 0.02 and 0.005: not the wall far away
    assert abs((bottom - top) / scale - 0.04) < 2 / scale and abs((floor - bottom) / scale - 0.015) < 2 / scale, (top, bottom, floor)
    post("render3d", name, "-o", "mesh.png", "--mesh", "walled/plate.stl", *camera)
    post("render3d", name, "-o", "plain.png", *camera)
    plain, mesh = pixels_of("plain.png")[26:418], pixels_of("mesh.png")[26:418]
    assert dark_places(plain[:, middle]) == []
    (edge,) = dark_places(mesh[:, middle])  # the mesh as it lies in its file, 30 m wide: of its edges one is seen here, at z = 0
    assert abs((edge - bottom) / scale - 0.02) < 2 / scale, (edge, bottom)


series()
check_render()
check_nothing_is_overwritten()
check_kinds_and_times()
check_film()
check_walls_and_meshes()
