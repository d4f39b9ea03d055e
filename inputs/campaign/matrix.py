"""The runs of a campaign: which variables each has, and its name."""

import itertools
import re
from dataclasses import dataclass
from pathlib import Path

from options import PILING, Misuse

VALUE_SIGNS = re.compile(r"[A-Za-z0-9._+-]+")


@dataclass(frozen=True)
class Run:
    """One run: its name, which is that of its folder, and what tells it from the others."""

    name: str
    varied: tuple  # ((name, value), ...), words, for the table; an empty value: none
    variables: tuple  # the same as the engine gets it, without empty ones


def variables_in(text):
    """Names of the variables of an input script that the command line can set."""
    return list(dict.fromkeys(re.findall(r"^\s*variable\s+(\w+)\s+index\b", text, re.MULTILINE)))


def check_names(names, input_file, known):
    """Refuses a name that the script does not have: the engine would take it, and nothing would change."""
    for name in names:
        if name not in known:
            raise Misuse(f"{input_file} has no line 'variable {name} index ...'; it has {', '.join(known) or 'none'}")
    if "out" in names:
        raise Misuse("the variable 'out' is the driver's: give --out, each run gets its own folder in it")


def check_value(name, value):
    if not VALUE_SIGNS.fullmatch(value):
        raise Misuse(f"the value '{value}' of {name} is no name for a folder; choose letters, digits and . _ + - only")


def pair_of(word, where):
    name, sign, value = word.partition("=")
    if not sign or not name or not value:
        raise Misuse(f"'{word}' in {where} is no NAME=VALUE")
    return name, value


def varied_axes(words):
    """[[((name, value),), ...], ...]: for each --vary the choices."""
    axes = []
    for word in words:
        name, values = pair_of(word, "--vary")
        choices = values.split(",")
        for value in choices:
            check_value(name, value)
        if len(set(choices)) < len(choices):
            raise Misuse(f"--vary {word} has a value twice")
        axes.append([((name, value),) for value in choices])
    return axes


def listed_rows(file):
    """Rows of a file of runs; empty lines and what stands behind # do not count."""
    try:
        lines = Path(file).read_text().splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise Misuse(f"--list {file}: {error}") from None
    rows = []
    for number, line in enumerate(lines, 1):
        words = line.partition("#")[0].split()
        if words:
            rows.append(tuple(pair_of(w, f"line {number} of {file}") for w in words))
            for name, value in rows[-1]:
                check_value(name, value)
    if not rows:
        raise Misuse(f"--list {file} has no run; write lines NAME=VALUE NAME=VALUE ...")
    return rows


def surface_choices(words):
    """The choices of --surfaces; N stands for multi-sphere particles of N sub-spheres."""
    choices = []
    for word in words.split():
        if word != "smooth" and not re.fullmatch(r"[0-9]*[13579]", word):
            raise Misuse(f"surface '{word}' is neither 'smooth' nor an odd number of sub-spheres; correct --surfaces")
        choices.append((("surface", word),))
    return choices


def seed_choices(given, known, is_piling):
    words = given.split() if given else ["1", "2"] if is_piling and "seed" in known else []
    for word in words:
        if not re.fullmatch(r"[1-9][0-9]*", word):
            raise Misuse(f"seed '{word}' is no integer > 0; correct --seeds")
    return [(("seed", word),) for word in words]


def table_columns(pairs, by_surface):
    """--surfaces' words as piling.in and its measures have them; everything else as it is."""
    result = []
    for name, value in pairs:
        if by_surface and name == "surface":
            is_smooth = value == "smooth"
            result += [(name, value if is_smooth else "multisphere"), ("subspheres", "" if is_smooth else value)]
        else:
            result.append((name, value))
    return tuple(result)


def name_of(pairs, by_surface):
    """"mu_0.3_seed1"; of --surfaces "smooth_seed1", "ms5_seed1"."""
    words = []
    for name, value in pairs:
        if by_surface and name == "surface":
            words.append(value if value == "smooth" else f"ms{value}")
        else:
            words.append(f"{name}{value}" if name == "seed" else f"{name}_{value}")
    return "_".join(words) or "run"


def runs_of(options, known, common):
    """All runs of the options; `common`: names of the variables that all runs share."""
    is_piling = Path(options.input).resolve() == PILING
    axes = varied_axes(options.vary)
    if options.list:
        axes.insert(0, listed_rows(options.list))
    by_surface = options.surfaces is not None or (not axes and is_piling and "surface" not in common)
    if by_surface:
        axes.insert(0, surface_choices(options.surfaces or "smooth 5"))
    has_seed = "seed" in common or any(name == "seed" for axis in axes for row in axis for name, _ in row)
    if seeds := seed_choices(options.seeds, known, is_piling and not has_seed):
        axes.append(seeds)
    runs, names = [], set()
    for combination in itertools.product(*axes):
        pairs = tuple(itertools.chain.from_iterable(combination))
        columns = table_columns(pairs, by_surface)
        variables = tuple((name, value) for name, value in columns if value)
        given = [name for name, _ in variables]
        twice = [n for n in given if given.count(n) > 1 or n in common]
        if twice:
            raise Misuse(f"the variable '{twice[0]}' is given twice; it may stand in one place only")
        check_names(given, options.input, known)
        run = Run(name_of(pairs, by_surface), columns, variables)
        if run.name in names:
            raise Misuse(f"the run {run.name} is there twice; correct --list, --surfaces or --seeds")
        names.add(run.name)
        runs.append(run)
    return runs
