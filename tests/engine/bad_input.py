"""Every parameter of every style of this package given wrongly: wrong count, wrong word, not a number,
zero, negative, NaN, infinite, missing. Each must end the run, by itself and at once, with one line

    ERROR...: style, parameter, given value, what is allowed or what to do

never by a signal, a time limit or going on with a silent default.
"""

import re
import unittest
from concurrent.futures import ThreadPoolExecutor

from _engine import LAW, Particle, Setup, ellipsoids_data, run

GOOD = {
    "pair": f"pair_style gran/ellipsoid {LAW} surface smooth direction displacement",
    "damping n": "fix m4 all property/global viscousDampingNormal peratomtypepair 1 100.0",
    "damping t": "fix m5 all property/global viscousDampingTangential peratomtypepair 1 100.0",
    "wall": f"fix floor all wall/gran/ellipsoid {LAW} surface smooth primitive type 1 yplane 0.0 "
            "direction displacement",
    "template": "fix grain all particletemplate/ellipsoid 15485863 atom_type 1 semiaxes 3e-3 2e-3 1e-3 "
                "mass 2e-5 inertia 2e-11 3e-11 4e-11 orientation planar volume_limit 1e-15",
    "drop": "fix drop all insert/drop seed 1 template grain particles 3 interval 1e-3 "
            "box 0 0 0.02 0.02 0 0 velocity 0 0 0",
    "motion": "fix motion all nve/ellipsoid planar yes",
    "compute": "compute search all contacts/ellipsoid",
}
STYLE = {"pair": "gran/ellipsoid", "damping n": "viscousDampingNormal",
         "damping t": "viscousDampingTangential", "wall": "wall/gran/ellipsoid",
         "template": "particletemplate/ellipsoid", "drop": "insert/drop", "motion": "nve/ellipsoid",
         "compute": "contacts/ellipsoid"}
NOT_A_NUMBER = ["abc", "1e-3x", "1,5", "nan", "inf", "--1"]
NOT_POSITIVE = ["0", "-1e-3", "-0.0"]
NOT_AN_INTEGER = ["abc", "1.5", "1e1", "nan", "99999999999999"]
REMEDY = re.compile(r"allowed|add |add$|give |use |correct|remove|needs|make |keep |define|normalise|"
                    r"insert ")


def script(commands, data=None):
    """A whole small run, with the given commands instead of the good ones."""
    c = {**GOOD, **commands}
    setup = Setup(box=(-0.03, 0.03, -0.01, 0.05, -0.01, 0.01), time_step=5e-6)
    box = setup.create_box() if data is None else f"read_data {data}\n"
    lines = [c["damping n"] if "viscousDampingNormal" in line else
             c["damping t"] if "viscousDampingTangential" in line else
             c["pair"] if line.startswith("pair_style") else line
             for line in setup.properties().splitlines()]
    return (setup.header() + box + "\n".join(lines) + "\n"
            + "\n".join(c[k] for k in ("wall", "template", "drop", "motion", "compute"))
            + "\nthermo_style custom step atoms c_search[1]\nrun 3\n")


def replaced(command, keyword, values, count=1, position=0):
    """Rows (command, keyword, value): value number `position` of `keyword` replaced by each."""
    words = GOOD[command].split()
    at = words.index(keyword) + 1 + position
    return [(command, " ".join([*words[:at], v, *words[at + 1:]]), keyword, v) for v in values]


def ended(command, keyword, kept):
    """Row: the command ends after `kept` values of `keyword`."""
    words = GOOD[command].split()
    return [(command, " ".join(words[:words.index(keyword) + 1 + kept]), keyword, "")]


def without(command, keyword, count, parameter=None):
    """Row: `keyword` and its `count` values left out."""
    words = GOOD[command].split()
    at = words.index(keyword)
    return [(command, " ".join(words[:at] + words[at + 1 + count:]), parameter or keyword, "")]


def more(command, text, parameter, value):
    return [(command, f"{GOOD[command]} {text}", parameter, value)]


def template_rows():
    c = "template"
    rows = replaced(c, "atom_type", [*NOT_AN_INTEGER, "0", "-1", "2"])
    for keyword, count in (("semiaxes", 3), ("mass", 1), ("inertia", 3), ("volume_limit", 1)):
        for k in range(count):
            rows += replaced(c, keyword, NOT_A_NUMBER + NOT_POSITIVE, position=k)
            rows += ended(c, keyword, k)
    dense = GOOD[c].replace("mass 2e-5", "density {}")
    rows += [(c, dense.format(v), "density", v) for v in NOT_A_NUMBER + NOT_POSITIVE]
    rows += replaced(c, "orientation", ["plane", "1", "0", "nan"]) + ended(c, "orientation", 0)
    rows += ended(c, "atom_type", 0)
    rows += without(c, "semiaxes", 3) + without(c, "mass", 1) + more(c, "density 1e3", "density", "")
    rows += more(c, "shininess 3", "shininess", "") + more(c, "7", "7", "")
    rows += [(c, GOOD[c].replace("2e-11 3e-11 4e-11", "1e-11 1e-11 4e-11"), "inertia", "")]
    return rows


def drop_rows():
    c = "drop"
    rows = []
    for keyword in "seed", "particles":
        rows += replaced(c, keyword, [*NOT_AN_INTEGER, "0", "-1"]) + ended(c, keyword, 0)
    rows += replaced(c, "template", ["nothing", "m1", "0"]) + ended(c, "template", 0)
    rows += replaced(c, "interval", NOT_A_NUMBER + NOT_POSITIVE) + ended(c, "interval", 0)
    rows += [(c, GOOD[c].replace("interval 1e-3", "interval 1e-9"), "interval", "")]
    for k in range(6):
        rows += replaced(c, "box", NOT_A_NUMBER, position=k) + ended(c, "box", k)
    for k, low in ((1, "-1e-3"), (3, "0.01"), (5, "-1e-3")):
        rows += replaced(c, "box", [low], position=k)  # below the lower bound
    rows += [(c, GOOD[c].replace("box 0 0", f"box {x}"), "box", "") for x in ("-1 0", "0 1")]
    for k in range(3):
        rows += replaced(c, "velocity", NOT_A_NUMBER, position=k) + ended(c, "velocity", k)
    for keyword, count in (("seed", 1), ("template", 1), ("particles", 1), ("interval", 1), ("box", 6)):
        rows += without(c, keyword, count)
    return rows + more(c, "rate 3", "rate", "")


def motion_and_compute_rows():
    return (replaced("motion", "planar", ["true", "1", "0", "nan", "on"]) + ended("motion", "planar", 0)
            + more("motion", "integrator euler", "integrator", "euler")
            + more("motion", "integrator", "integrator", "")
            + more("motion", "spin no", "spin", "") + more("compute", "all", "arguments", ""))


def pair_rows():
    c = "pair"
    return (replaced(c, "direction", ["sideways", "0", "nan"]) + ended(c, "direction", 0)
            + [(c, GOOD[c].replace(" surface smooth direction displacement", ""), "surface", ""),
               (c, GOOD[c].replace("surface smooth", "surface default"), "surface", ""),
               (c, GOOD[c].replace("model hertz/viscous", "model hertz/nothing"), "model", ""),
               (c, GOOD[c].replace("tangential history/viscous", "tangential nothing"), "tangential", ""),
               (c, "pair_style gran/ellipsoid", "model", "")]
            + more(c, "limitForce maybe", "limitForce", "maybe") + more(c, "limitForce", "limitForce", "")
            + more(c, "colour red", "colour", "") + more(c, "direction", "direction", ""))


def wall_rows():
    c = "wall"
    return (replaced(c, "direction", ["sideways", "0", "nan"])
            + replaced(c, "type", [*NOT_AN_INTEGER, "0", "-1", "2"]) + ended(c, "type", 0)
            + replaced(c, "yplane", NOT_A_NUMBER) + ended(c, "yplane", 0)
            + replaced(c, "primitive", ["kind"]) + ended(c, "primitive", 0)
            + [(c, GOOD[c].replace("yplane 0.0", "qplane 0.0"), "qplane", ""),
               *[(c, GOOD[c].replace("yplane 0.0", f"ycylinder {v} 0 0"), "ycylinder", v)
                 for v in NOT_A_NUMBER + NOT_POSITIVE],
               *[(c, GOOD[c].replace("yplane 0.0", f"zcylinder 0.01 {v} 0"), "zcylinder", v)
                 for v in NOT_A_NUMBER],
               *[(c, GOOD[c].replace("primitive type 1 yplane 0.0", f"mesh n_meshes {v} meshes cad"),
                  "n_meshes", v) for v in [*NOT_AN_INTEGER, "0", "-1", "1001"]],
               (c, GOOD[c].replace("primitive type 1 yplane 0.0", "mesh n_meshes 1 meshes cad"),
                "meshes", "cad"),
               (c, GOOD[c].replace("primitive type 1 yplane 0.0", "mesh n_meshes 1 meshes grain"),
                "meshes", "grain"),
               (c, GOOD[c].split("primitive")[0] + "mesh n_meshes", "n_meshes", ""),
               (c, GOOD[c].split("primitive")[0] + "mesh n_meshes 1 meshes", "meshes", ""),
               (c, GOOD[c].split("primitive")[0], "primitive", ""),
               (c, GOOD[c].split("primitive")[0] + "mesh", "n_meshes", ""),
               (c, GOOD[c].split("primitive")[0] + "mesh n_meshes 1", "meshes", ""),
               (c, GOOD[c] + " contacts 0", "contacts", "0"),
               (c, GOOD[c] + " contacts 32768", "contacts", "32768"),
               (c, GOOD[c].replace("surface smooth ", ""), "surface", ""),
               (c, GOOD[c].replace("surface smooth", "surface default"), "surface", "")])


def damping_rows():
    rows = []
    for c in "damping n", "damping t":
        start = GOOD[c].rsplit(" ", 1)[0]
        rows += [(c, f"{start} {v}", STYLE[c], v) for v in ("-1", "-1e+06")]
    return rows


#: what the host's `set` takes, although no particle can be like that: (words, parameter, value)
SET = [("quat_direct 0 0 0 0", "quaternion", "nan"), ("inertiax 0", "principal moments", "0 "),
       ("inertiay -1", "principal moments", "-1"), ("inertiaz 1e400", "principal moments", "inf"),
       ("mass 1e400", "mass", "inf"), ("shape 1e400 1 1", "semi-axes", "inf"),
       ("density 1e400", "mass", "inf"), ("vx 1e400", "velocity", "inf"),
       ("omegaz 1e400", "angular momentum", "nan"), ("z 1e400", "position", "inf")]

COLUMNS = "id type x y z a b c q0 q1 q2 q3 mass I1 I2 I3".split()


def data_rows():
    """(column, value) of the data file's only atom."""
    rows = [("type", v) for v in ("0", "-1", "2", "1.5", "abc", "nan")]
    rows += [("id", v) for v in ("0", "-1", "abc", "nan", "1.5")]
    rows += [(n, v) for n in ("a", "b", "c", "mass", "I1", "I2", "I3")
             for v in ("0", "-1e-3", "abc", "1e-3x", "nan", "inf")]
    rows += [(n, v) for n in ("q0", "q1", "q2", "q3") for v in ("abc", "0.1x", "nan", "inf")]
    return rows + [(n, v) for n in "xyz" for v in ("abc", "1e-3x")]


def tabled_runs():
    """All runs: (title, script, style, parameter, value)."""
    rows = (template_rows() + drop_rows() + motion_and_compute_rows() + pair_rows() + wall_rows()
            + damping_rows())
    runs = [(command, script({c: command}), STYLE[c], parameter, value)
            for c, command, parameter, value in rows]
    good = ellipsoids_data([Particle((0, 0.01, 0), (3e-3, 2e-3, 1e-3))], Setup().box, 1)
    head, rest = good.split("Atoms\n\n")
    atom, tail = rest.split("\n", 1)

    def with_atom(name, words, column, value):
        with open(name, "w", encoding="ascii") as file:
            file.write(f"{head}Atoms\n\n{' '.join(words)}\n{tail}")
        runs.append((f"data file: {' '.join(words)}", script({}, name), "tom", column, value))

    with open("set.data", "w", encoding="ascii") as file:
        file.write(good)
    for words, parameter, value in SET:
        text = script({}, "set.data").replace("run 3\n", f"set group all {words}\nrun 3\n")
        runs.append((f"set group all {words}", text, "gran/ellipsoid: atom 1", parameter, value))
    for k, (column, value) in enumerate(data_rows()):
        words = atom.split()
        words[COLUMNS.index(column)] = value
        with_atom(f"bad{k}.data", words, column, value)
    words = atom.split()
    with_atom("unit.data", [*words[:8], "1", "0.1", "0", "0", *words[12:]], "q0", "")
    with_atom("short.data", words[:-1], "format", "")
    with_atom("long.data", [*words, "1"], "format", "")
    return runs


def complaint(run_row):
    """What is wrong with the engine's answer to a row, or an empty string."""
    number, (title, text, style, parameter, value) = run_row
    try:
        outcome = run(text, timeout=60, check=False, name=f"in.{number}")
    except Exception as error:  # the time limit
        return f"{title}\n    -> {error}"
    lines = [line for line in outcome.text.splitlines() if line.startswith("ERROR")]
    wrong = []
    if outcome.code == 0:
        wrong.append("it ran")
    elif outcome.code != 1 or "signal" in outcome.text.lower():
        wrong.append(f"exit status {outcome.code}")
    if len(lines) != 1:
        wrong.append(f"{len(lines)} lines of error")
    line = lines[0] if lines else ""
    for what, word in (("style", style), ("parameter", parameter), ("value", value)):
        if word not in line:
            wrong.append(f"no {what} '{word}'")
    if not REMEDY.search(line):
        wrong.append("no remedy")
    return f"{title}\n    -> {', '.join(wrong)}: {line}" if wrong else ""


class BadInput(unittest.TestCase):
    def test_the_good_input_runs(self):
        self.assertEqual(run(script({})).code, 0)

    def test_every_wrong_value_is_refused(self):
        runs = tabled_runs()
        with ThreadPoolExecutor(2) as pool:
            failures = [c for c in pool.map(complaint, enumerate(runs)) if c]
        print(f"{len(runs)} rows, {len(failures)} wrongly answered")
        self.assertGreater(len(runs), 300)
        self.assertFalse(failures, "\n" + "\n".join(failures))


if __name__ == "__main__":
    unittest.main(verbosity=2)
