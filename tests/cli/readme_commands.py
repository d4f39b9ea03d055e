"""Every command that the README prints is run from the root of a clean tree, in its order, with
smaller numbers; the files that it names are there afterwards. The tests that the README and the
page of verification name exist."""

import os
import pathlib
import re
import shlex
import subprocess

ROOT = pathlib.Path(os.environ["ELLIPSOID_SOURCE"])
BUILD = pathlib.Path(os.environ["ELLIPSOID_BUILD"])

# what makes the runs short: (text of the README, text in its place)
SHORTER = [(r"-var particles 100", "-var particles 20"), (r"-var settle 3", "-var settle 0.2"),
           (r"-var dump_time 0\.5", "-var dump_time 0.2"), (r'--seeds "1 2 3"', '--seeds "1 2"'),
           (r"-in inputs/hopper\.in", "-in inputs/hopper.in -var particles 40 -var dt 2e-5 "
            "-var fill 0.04 -var flow 0.06")]
if os.environ["ELLIPSOID_VTK"] == "0":
    SHORTER.append((r"-in inputs/piling\.in", "-in inputs/piling.in -var vtk no"))
# beginnings of commands that set up what this test runs in, and what runs them
SET_UP = {"bash inputs/quickstart.sh": "tests/clean_machine.sh",
          "bash tests/run.sh": "tests/clean_machine.sh",
          "CC=gcc CXX=g++ cmake --preset release": "tests/patches/configure.sh",
          "cmake --build build -j": "tests/patches/configure.sh",
          "cmake --install build": "tests/cli/install_prefix.sh"}


def commands():
    """Of all blocks for the shell, one per line, without comments."""
    blocks = re.findall(r"^```sh\n(.*?)^```", (ROOT / "README.md").read_text(),
                        re.MULTILINE | re.DOTALL)
    lines = "".join(blocks).replace("\\\n", " ").splitlines()
    found = [re.sub(r"\s+#.*", "", line).strip() for line in lines]
    return [command for command in found if command]


def clean_tree():
    """The tracked files without the results of anything, and the programs that were built."""
    tree = pathlib.Path("tree")
    tree.mkdir()
    for entry in ROOT.iterdir():
        if not entry.name.startswith(("build", "out", ".git")) and not entry.name.endswith(".png"):
            (tree / entry.name).symlink_to(entry)
    (tree / "build").symlink_to(BUILD)
    return tree


def named_outputs(command):
    words = shlex.split(command)
    return [value for option, value in zip(words, words[1:])
            if option in ("-o", "--picture", "--csv", "--out")]


def run(command, tree):
    short = command
    for text, replacement in SHORTER:
        short = re.sub(text, replacement, short)
    result = subprocess.run(["bash", "-euo", "pipefail", "-c", short], cwd=tree, text=True,
                            capture_output=True, stdin=subprocess.DEVNULL,
                            timeout=300 * int(os.environ.get("ELLIPSOID_SLOWNESS", "1")))
    assert result.returncode == 0, (f"exit status {result.returncode}: {short}\n"
                                    f"{result.stdout[-1500:]}\n{result.stderr[-1500:]}")
    for output in named_outputs(command):
        assert list(tree.glob(output)), f"no {output} after: {short}"


def check_named_tests():
    listed = subprocess.run(["ctest", "--test-dir", BUILD, "-N"], check=True, text=True,
                            capture_output=True).stdout
    tests = re.findall(r"Test +#\d+: (\S+)", listed)
    count = 0
    for page in (ROOT / "README.md", ROOT / "src_liggghts" / "doc" / "verification.md"):
        for named in re.findall(r"`(?:\w+=\S+ )*T ([^`]+)`", page.read_text()):
            expression = named.strip('"')
            for part in expression.split("|"):
                assert any(re.search(part, test) for test in tests), f"{page.name}: no test {part}"
                count += 1
    assert count > 30, count
    return count


def main():
    printed = commands()
    for beginning, runner in SET_UP.items():
        assert any(command.startswith(beginning) for command in printed), (
            f"the README no longer prints '{beginning}': take it out of this test")
        assert (ROOT / runner).exists(), runner
    tree = clean_tree()
    to_run = [c for c in printed if not c.startswith(tuple(SET_UP))]
    assert len(to_run) >= 8, to_run
    for command in to_run:
        run(command, tree)
    print(f"{len(to_run)} commands run; {check_named_tests()} named tests exist")


main()
