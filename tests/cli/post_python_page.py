# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""The examples of the page on Python are run as they are printed, their ellipsoid-post commands first.

Those that need pandas, matplotlib or freud are run where these are installed, and named where not; numpy is always there.
Oracle: a row of balls whose overlaps, energies and directions are known.
"""
import importlib.util
import os
import re
import subprocess
import sys

from _option_scenes import box_of
from _synthetic import COLUMNS, frame_text, write

PAGE = os.path.join(os.environ["ELLIPSOID_SOURCE"], "postprocess", "doc", "python.md")
DEBIAN = {"pandas": "python3-pandas", "matplotlib": "python3-matplotlib", "freud": "pip install freud-analysis"}
RADIUS, APART, COUNT = 1e-3, 1.98e-3, 5
MASS, SPEED = 2e-5, 0.1


def bed(step):
    """Layers of balls that touch along x only, moving faster in each frame, in a box that repeats."""
    rows = []
    for k in range(COUNT ** 3):
        i, j, l = k % COUNT, k // COUNT % COUNT, k // COUNT ** 2
        rows.append(dict(zip(COLUMNS, (k + 1, 1, MASS, APART * (i + 0.5), 2.5e-3 * (j + 0.5), 2.5e-3 * (l + 0.5), SPEED * step, 0.0, 0.0,
                                       0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, RADIUS, RADIUS, RADIUS, 0))))
    edges = (COUNT * APART, COUNT * 2.5e-3, COUNT * 2.5e-3)
    return box_of(frame_text(step, rows), (0, 0, 0), edges, "pp pp pp")


def examples():
    with open(PAGE, encoding="utf8") as file:
        text = file.read()
    found = re.findall(r"^## ([^\n]*)\n(?:(?!## )[^\n]*\n)*?```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
    assert len(found) == text.count("```python"), "an example without a heading of its own"
    return found


def run_commands(code):
    """The ellipsoid-post lines of an example, in a shell as one types them."""
    commands = re.findall(r"^# (ellipsoid-post .*)$", code, re.MULTILINE)
    assert commands, code
    for command in commands:
        subprocess.run(["bash", "-euc", command], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                       env={**os.environ, "PATH": os.environ["ELLIPSOID_BIN"] + ":" + os.environ["PATH"]})


def missing_of(code):
    names = re.findall(r"^(?:import|from) (\w+)", code, re.MULTILINE)
    assert set(names) <= {"numpy", *DEBIAN}, names
    return [name for name in dict.fromkeys(names) if importlib.util.find_spec(name) is None]


def check_words(heading, out):
    numbers = [float(n) for n in re.findall(r"-?\d+\.?\d*(?:e-?\d+)?", out)]
    if heading == "With numpy alone":
        energy = [0.5 * MASS * COUNT ** 3 * (SPEED * step) ** 2 for step in (0, 1, 2)]
        assert numbers[0] == 3 and abs(numbers[1] / energy[2] - 1) < 1e-9, out
    if heading == "Contacts, one row each":
        assert abs(numbers[0] - (2 * RADIUS - APART)) < 1e-12 and numbers[1] == 2, out
        assert abs(sorted(numbers[2:])[-1] - 1) < 1e-9 and abs(sum(numbers[2:]) - 1) < 1e-9, out
    if "freud" in heading:
        assert 0 < numbers[1] < 1, out


def main():
    write("bed.dump", bed(2))
    for step in range(3):
        write(f"bed.{step}.dump", bed(step))
    ran = []
    for heading, code in examples():
        run_commands(code)
        missing = missing_of(code)
        if missing:
            print(f"python.md: '{heading}' is not run: {missing[0]} is not installed ({DEBIAN[missing[0]]})")
            continue
        done = subprocess.run([sys.executable, "-W", "error::DeprecationWarning:__main__", "-c", code], capture_output=True, text=True)
        assert done.returncode == 0, (heading, done.stderr)
        check_words(heading, done.stdout)
        for picture in re.findall(r'savefig\("([^"]+)"\)', code):
            with open(picture, "rb") as file:
                assert file.read(8) == b"\x89PNG\r\n\x1a\n", picture
        ran.append(heading)
    print("python.md: run:", "; ".join(ran))
    assert "With numpy alone" in ran


main()
