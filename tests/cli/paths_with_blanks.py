# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""A clone in a folder with blanks or quotes is refused in one line before anything is installed, configured or built."""
import os
import shutil
import subprocess

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
