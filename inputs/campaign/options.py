"""Options of a campaign, checked."""

import argparse
import os
import re
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parent.parent.parent
PILING = REPOSITORY / "inputs" / "piling.in"
PATH_SIGNS = re.compile(r"[A-Za-z0-9._/+,:=@%~^-]+")
PILE_QUANTITIES = "repose_angle_deg,porosity,zpp,zss"

EPILOG = """
examples:
  the paper's piles    --out out/piles --surfaces "smooth 5 17" --seeds "1 2 3" -- -var particles 200 -var dt 5e-6
  any input            --out out/drum --input inputs/drum.in --vary mu=0.2,0.5 --vary period=1,2
                       --measure 'energy {out}/drum.*.dump' --quantity translation_J
  friction for 25 deg  --out out/mu --vary mu=0.1,0.2,0.3,0.4 --seeds "1 2 3" --calibrate mu:repose_angle_deg=25
                       -- -var particles 200 -var dt 5e-6
"""


class Misuse(Exception):
    """What the user has to correct; one line."""


class _Parser(argparse.ArgumentParser):
    def error(self, message):
        raise Misuse(f"{message}; see --help")


def parser():
    """The command line, without the variables behind `--`."""
    p = _Parser(prog="campaign.sh", allow_abbrev=False, epilog=EPILOG,
                formatter_class=argparse.RawDescriptionHelpFormatter,
                description="Runs an input script for a matrix of values and seeds, measures each run, ends in "
                            "tables; goes on where it was killed. Behind -- stand variables for all runs: "
                            "-var NAME VALUE ...")
    p.add_argument("--out", help="folder of the results; each run has a folder of its own in it")
    p.add_argument("--input", default=str(PILING), help="input script; default: inputs/piling.in")
    p.add_argument("--vary", action="append", default=[], metavar="NAME=V1,V2,...",
                   help="a variable of the input and its values; several: every combination")
    p.add_argument("--list", metavar="FILE", help="runs one by one: a line NAME=VALUE NAME=VALUE ... each")
    p.add_argument("--surfaces", help="of piling.in: 'smooth' or odd numbers of sub-spheres; default without "
                                      "--vary and --list: smooth 5")
    p.add_argument("--seeds", help="seeds; default for inputs with a variable seed: 1 2 for piling.in, else its own")
    p.add_argument("--jobs", help="runs at a time; default: the number of processors")
    p.add_argument("--ranks", default="1", help="MPI ranks of each run; default: 1")
    p.add_argument("--measure", action="append", default=[], metavar="COMMAND",
                   help="an ellipsoid-post command with its arguments, {out} is the run's folder; its last row "
                        "is the run's; default for piling.in: pile --one-run {out}/pile.*.dump")
    p.add_argument("--quantity", help="columns of the measures to average, with commas; default for piling.in: "
                   + PILE_QUANTITIES)
    p.add_argument("--calibrate", metavar="NAME:COLUMN=VALUE",
                   help="the value of the variable NAME at which the column has this value, with its uncertainty")
    p.add_argument("--only", metavar="K", help="only run number K (from 0), without tables: for job arrays")
    p.add_argument("--count", action="store_true", help="print the number of runs, nothing else")
    return p


def words_behind_dashes(words):
    """(options, variables): what stands before and behind the first `--`."""
    if "--" not in words:
        return words, []
    at = words.index("--")
    return words[:at], words[at + 1:]


def variables_of(words):
    """{name: value} of `-var NAME VALUE ...`."""
    found = {}
    for k in range(0, len(words), 3):
        if words[k] != "-var" or len(words) < k + 3:
            raise Misuse(f"behind -- stands '{' '.join(words[k:k + 3])}', allowed is -var NAME VALUE, again and again")
        if words[k + 1] in found:
            raise Misuse(f"-var {words[k + 1]} is given twice")
        found[words[k + 1]] = words[k + 2]
    return found


def whole_number(word, name, least):
    if not re.fullmatch(r"[0-9]+", word) or int(word) < least:
        raise Misuse(f"{name} is '{word}', allowed is an integer >= {least}")
    return int(word)


def usable_path(path):
    """The path, if the engine's scripts can use it as a name."""
    for one in (path, os.path.abspath(path)):
        if not PATH_SIGNS.fullmatch(one):
            raise Misuse(f"the path '{one}' has blanks or signs that the engine's scripts cannot use; choose letters, "
                         "digits and . _ / + , : = @ % ~ ^ - only".encode("unicode_escape").decode())
    return Path(os.path.abspath(path))


def programs():
    """(engine, tools): of ELLIPSOID_BIN, a build here, or the prefix of an installation."""
    places = [os.environ.get("ELLIPSOID_BIN"), REPOSITORY / "build" / "bin", REPOSITORY.parent.parent / "bin"]
    for place in places:
        if place and os.access(Path(place) / "liggghts", os.X_OK):
            return Path(place) / "liggghts", Path(place) / "ellipsoid-post"
        if place and place is places[0]:
            break
    raise Misuse(f"there is no engine at {Path(places[0] or places[1]) / 'liggghts'}; build it "
                 "(bash inputs/quickstart.sh) or name its folder by ELLIPSOID_BIN")
