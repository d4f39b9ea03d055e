# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""A clone in a folder with blanks or quotes is refused in one line before anything is installed, configured or built;
every command of ellipsoid-post reads from such folders and writes to them."""
import os
import shutil
import subprocess

from _option_scenes import write_scenes
from _synthetic import post
from post_options import USUAL, Example, commands, words_of

ODD = "it's a \"bed\" $(touch hit) of; [1] & 2"  # what a shell would take apart, and a pattern that is none


def check_tools():
    """All files of a call lie in a folder with an odd name, and all that it writes goes to another."""
    os.rename("scenes", ODD)
    results = ODD + " out"
    os.makedirs(results)
    environment = dict(os.environ)
    os.environ["TMPDIR"] = os.path.abspath(results)  # of the pictures that ffmpeg joins
    calls = {command: words_of(command, Example()) for command in USUAL}
    calls["film of ffmpeg"] = ["../scenes/plane/all.dump", "--output", "film.mp4", "--width", "200"]
    calls["view with all"] = ["../scenes/space/all.dump", "--output", "all.html", "--mesh", "../scenes/body.stl", "--contacts",
                              "../scenes/space/pairs.local", "--id-columns", "i", "j", "--force-columns", "fx", "fy", "fz"]
    calls["coordination with walls"] = ["../scenes/logged/one.dump", "--run-walls", "--log", "../scenes/walls.txt", "--per-particle", "z.csv"]
    calls["fields of lists"] = ["../scenes/space/all.dump", "--at", "0.002", "0.002", "0.002", "--contacts", "../scenes/space/pairs.local",
                                "--id-columns", "i", "j", "--force-columns", "fx", "fy", "fz"]
    calls["flow through"] = ["../scenes/space/all.dump", "--face", "../scenes/face.stl", "--dt", "1e-5", "--passages", "p.csv"]
    calls["report of all"] = ["../scenes/logged", "--output", "r.html", "--view", "../scenes/view.html", "--table", "../scenes/runs.csv"]
    calls["template from"] = ["--from", "../scenes/body.stl", "--subspheres", "5", "--picture", "p.svg", "--multisphere", "m.txt"]
    for name, words in calls.items():
        command = name.split(" ")[0]
        outputs = {"--output", "--per-particle", "--passages", "--picture", "--multisphere"}
        words = [os.path.join(results, name + w) if before in outputs else w.replace("../scenes", ODD) for before, w in zip([""] + words, words)]
        tables = ["--csv", os.path.join(results, name + ".csv")] if command not in ("render", "render3d", "film", "paraview", "view", "plot") else []
        before = set(os.listdir(results))
        post(command, *words, *tables)
        assert set(os.listdir(results)) > before, (name, words)
        assert not os.path.exists("hit"), name
    assert set(commands()) == {name.split(" ")[0] for name in calls}
    os.environ.clear()
    os.environ.update(environment)


def check_clones():
    source = os.environ["ELLIPSOID_SOURCE"]
    for name in ("a clone", "quote's", "tab\tbed"):
        os.makedirs(os.path.join(name, "inputs"))
        os.makedirs(os.path.join(name, "tests"))
        for script in ("inputs/setup.sh", "inputs/quickstart.sh", "tests/run.sh"):
            shutil.copy(os.path.join(source, script), os.path.join(name, script))
        for script in ("inputs/quickstart.sh", "tests/run.sh"):
            done = subprocess.run(["bash", os.path.join(name, script)], capture_output=True, text=True, timeout=60,
                                  env={**os.environ, "PATH": os.path.abspath("no_apt") + ":" + os.environ["PATH"]})
            assert done.returncode != 0 and done.stdout == "" and done.stderr.count("\n") == 1, (script, done)
            assert name in done.stderr and "move it" in done.stderr, done.stderr
            assert not os.path.exists(os.path.join(name, "build"))


os.mkdir("no_apt")
with open("no_apt/apt-get", "w", encoding="ascii") as stub:
    stub.write("#!/bin/bash\nexit 99\n")
os.chmod("no_apt/apt-get", 0o755)
check_clones()
os.makedirs("scenes")
os.chdir("scenes")
write_scenes()
os.chdir("..")
check_tools()
