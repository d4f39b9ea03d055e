# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""Every option of every command shows in what the command gives, and is refused in one line where it cannot show.

The options are those that --help names: one that no example here shows fails the test, and so does an example of an
option that is gone. An example is run twice, without the option and with it; words, files and exit code are compared.
An example that needs other options beside it is tried without those as well: there the option shows too, or is refused.
"""
import os
import re
import shutil
import subprocess
import sys
import time

from _option_scenes import write_scenes
from _synthetic import POST, SLOWNESS

SCENES = "../scenes"  # from the folder of a run
PLANE_VIEW = ("0", "0.03", "0", "0.02")
PART = ("0", "0.006", "0", "0.006", "0", "0.004")


class Example:
    """How an option shows: `given` behind it, on `files`, with `beside` and without `drop` of the usual options."""

    def __init__(self, *given, files=None, beside=(), drop=(), usual=None, refused=None):
        self.given, self.beside, self.drop, self.usual = [str(g) for g in given], [str(b) for b in beside], drop, usual
        self.refused = refused  # words: what the file holds does not count for this measure, but what cannot be is refused
        self.files = files


def at(*names):
    return tuple(f"{SCENES}/{name}" for name in names)


def reading(scene, other_rows=None):
    """Options that say which files, which frames and what the columns mean. @param other_rows: where sizes show"""
    sizes = ("2.7e-3", "1.15e-3", "1.15e-3") if scene == "plane" else ("1.3e-3", "1.1e-3", "1e-3")
    bare, more = at(f"{scene}/bare.dump"), dict(other_rows or {})
    return {
        "--one-run": Example(files=at(f"{scene}/one.100.dump", f"{scene}/two.dump")),
        "--each-file": Example(files=at(f"{scene}/one.100.dump", f"{scene}/one.200.dump")),
        "--frame": Example("200"),
        "--semiaxes": Example(*sizes, files=bare, **more),
        "--subspheres": Example(3, files=bare, beside=("--semiaxes", sizes[0], sizes[1], sizes[1], *more.get("beside", ())),
                                drop=more.get("drop", ())),
        "--spacing": Example("minimax_area", **more),
        "--clump": Example(f"3={SCENES}/clump.txt", files=at(f"{scene}/clumps.dump")),
        "--size-scale": Example(1.03, **more),
        "--column": Example("shapex=s1", files=at(f"{scene}/foreign.dump")),
        "--bodies": Example("mol", files=at(f"{scene}/spheres.dump")),
        "--periodic": Example("x", files=at(f"{scene}/split.dump")) if scene == "space" else Example("none", files=at(f"{scene}/wrapped.dump")),
    }


READING = set(reading("space"))
TABLE = {"--csv": Example("t.csv"), "--json": Example("t.json"), "--quiet": Example()}
THREADS = {"--threads": None}  # see check_threads()
PILE = {"--wall": Example(-0.004), "--no-wall": Example(files=at("mound.dump")), "--floor": Example(-0.004), "--section": Example(0.0004),
        "--cluster-gap": Example(3), "--outline": Example("ellipse")}
FIT = {"--cut-bottom": Example(0.4), "--cut-top": Example(0.4), "--columns": Example(0.2)}
POROSITY = {"--region": Example("core"), "--margin": Example(1, beside=("--region", "core"))}
COORDINATION = {"--with-walls": Example(), "--contact-gap": Example(0.2)}
GRAVITY = {"--gravity": Example(1, 2, 3)}
TIME = {"--dt": Example(1e-5)}
UP = {"--up": Example("y")}
CONTACT_LIST = ("--contacts", at("{}/pairs.local")[0], "--id-columns", "i", "j")
FORCES = ("--force-columns", "fx", "fy", "fz")


def lists(scene, usual=(), forces=True, normals=("nx", "ny", "nz")):
    """Contact lists with forces."""
    file = at(f"{scene}/pairs.local")[0]
    given = ("--contacts", file, "--id-columns", "i", "j", *(FORCES if forces else ()))
    found = {"--contacts": Example(file, beside=("--id-columns", "i", "j", *(FORCES if forces else ()), *usual)),
             "--id-columns": Example("i", "j", beside=("--contacts", file, *(FORCES if forces else ()), *usual))}
    if forces:
        found["--force-columns"] = Example("fx", "fy", "fz", beside=("--contacts", file, "--id-columns", "i", "j", *usual))
    if normals:
        found["--normal-columns"] = Example(*normals, beside=(*given, *usual))
    return found


def without(options, *names):
    return {name: example for name, example in options.items() if name not in names}


def plane(command, *usual, **more):
    return command, {"files": at("plane/all.dump"), "usual": list(usual), **more}


def space(command, *usual, **more):
    return command, {"files": at("space/all.dump"), "usual": list(usual), **more}


# the usual options of each command: (command, files and options that an example begins with)
USUAL = dict([
    plane("pile"), plane("repose"), plane("porosity"), plane("render", "--output", "p.svg"), plane("report", "--output", "r.html"),
    plane("film", "--output", "f_*.svg"), space("coordination"), ("heap", {"files": at("heap/all.dump"), "usual": ["--sectors", "4"]}), space("bed", "--box", *PART),
    space("orientation"), space("contacts"), space("energy"), space("fields", "--at", 0.002, 0.002, 0.002), space("voronoi", "--box", -0.002, 0.011, -0.002, 0.011, -0.002, 0.011),
    space("mixing", "--type", 1), space("pairs", "--bins", 7), space("trajectory"),
    space("flow", "--through", 0, 0, 0.0038, 0, 0, 1), space("paraview", "--output", "p"), space("view", "--output", "v.html"),
    space("render3d", "--output", "p.png", "--width", 160, "--height", 120),
    ("summary", {"files": at("runs.csv"), "usual": []}),
    ("plot", {"files": ("curve", *at("runs.csv")), "usual": ["--x", "zpp", "--y", "zss", "--output", "p.svg"]}),
    ("template", {"files": (), "usual": ["--subspheres", 5]})])

GRID = {"beside": ("--grid", 3, 3, 3), "drop": ("--at",)}
RADIUS = {"beside": ("--profile", "radius", "--cylinder", 0.004, 0.004, 0.004, 0, 0.008), "drop": ("--at",)}
WALL_LIST = ("--wall-contacts", at("space/walls.local")[0], "--wall-id-column", "i", "--wall-force-columns", "fx", "fy", "fz",
             "--wall-point-columns", "px", "py", "pz")
FIELD_LIST = ("--contacts", at("space/pairs.local")[0], "--id-columns", "i", "j", *FORCES)
COLLISIONS = {"beside": ("--collisions", "--dt", 1e-5)}
IN_SPACE = ("--output", "f_*.png", "--width", 160)
ON_SET = ("--semiaxes", 1.5e-3, 1.2e-3, 1e-3)
LOG = at("walls.txt")[0]

def each_file(scene, name):
    """Pictures of several runs: by their time steps."""
    return {"--each-file": Example(files=at(f"{scene}/one.100.dump", f"{scene}/one.200.dump"), usual=("--output", name, "--width", 160))}


EXAMPLES = {
    "pile": {**reading("plane"), **PILE, **FIT, **POROSITY, **COORDINATION, **GRAVITY, **TABLE, **THREADS, "--picture": Example("p.svg")},
    "repose": {**reading("plane", {"beside": ("--cluster-gap", 1)}), "--bodies": Example("mol", files=at("plane/spheres.dump"), beside=("--cluster-gap", 1)),
               **PILE, **FIT, **TABLE, **THREADS},
    "porosity": {**reading("plane"), **PILE, **POROSITY, **TABLE, **THREADS,
                 **{o: Example(*e.given, beside=("--region", "middle")) for o, e in FIT.items()}},
    "coordination": {
        **reading("space"), **TABLE, **THREADS,
        **{o: Example(*e.given, files=at("plane/all.dump")) for o, e in PILE.items()},
        "--with-walls": Example(beside=("--box-wall", *PART)), "--contact-gap": Example(0.2),
        **lists("space", forces=False, normals=()), "--overlap-column": Example("h", beside=[c.format("space") for c in CONTACT_LIST]),
        "--plane-wall": Example(0, 0, 0.0006, 0, 0, 1), "--cylinder-wall": Example(0.004, 0.004, 0, 0, 0, 1, 0.004),
        "--box-wall": Example(*PART), "--mesh-wall": Example(*at("face.stl")),
        "--mesh-scale": Example(0.3, beside=("--mesh-wall", *at("face.stl"))),
        "--run-walls": Example(beside=(), files=at("logged/one.dump")), "--log": Example(LOG, beside=("--run-walls",)),
        "--space": Example(files=at("plane/all.dump")), "--per-particle": Example("z.csv")},
    "heap": {**reading("heap"), "--up": Example("y", refused="rings"),
            "--bodies": Example("mol", files=at("heap/spheres.dump"), beside=("--cluster-gap", 1)), **TABLE, **THREADS, "--floor": Example(-0.001), "--sectors": Example(3), "--cut-bottom": Example(0.3),
             "--cut-top": Example(0.4), "--columns": Example(0.4), "--cluster-gap": Example(0.3), "--planes": Example(20)},
    "bed": {**reading("space"), **UP, **TABLE, **THREADS, "--box": Example(0.001, *PART[1:]), "--planes": Example(20),
            "--cylinder": Example(0.003, 0.003, 0.002, 0.001, 0.005, drop=("--box",)), "--profile": Example("height"),
            "--slices": Example(3, beside=("--profile", "height")), "--below-surface": Example(),
            "--columns": Example(1, beside=("--below-surface",))},
    "orientation": {**reading("space"), "--spacing": Example("paper_touching", refused="N = 5"),
                    "--size-scale": Example(1e40, refused="semi-axes"), **TIME, **TABLE, **THREADS, "--bins": Example(5), "--plane": Example("zx")},
    "contacts": {**reading("space"), **TABLE, **THREADS, "--contact-gap": Example(0.2), "--list": Example("l.csv"), "--bins": Example(5),
                 "--local": Example(files=at("space/pairs.local"), beside=("--normal-columns", "nx", "ny", "nz")),
                 "--normal-columns": Example("nx", "ny", "nz", files=at("space/pairs.local"), beside=("--local", *FORCES)),
                 "--force-columns": Example("fx", "fy", "fz", files=at("space/pairs.local"),
                                            beside=("--local", "--normal-columns", "nx", "ny", "nz"))},
    "energy": {**reading("space"), "--spacing": Example("paper_touching", refused="N = 5"),
               "--subspheres": Example(4, files=at("space/bare.dump"), beside=("--semiaxes", "1.3e-3", "1.1e-3", "1.1e-3"), refused="odd"), **GRAVITY, **TABLE, **THREADS, "--inertia": Example(1e-11, 2e-11, 3e-11)},
    "fields": {
        **reading("space"), **TIME, **TABLE, "--grid": Example(2, 2, 2, drop=("--at",)), "--profile": Example("z", drop=("--at",)),
        "--at": Example(0.001, 0.002, 0.003), "--slices": Example(3, beside=("--profile", "z"), drop=("--at",)),
        "--box": Example(*PART, **GRID), "--cylinder": Example(0.004, 0.004, 0.003, 0, 0.006, **RADIUS),
        "--axis": Example("x", **RADIUS), "--kernel": Example("lucy"), "--width": Example(0.003), "--density": Example(900.0),
        "--average": Example(beside=("--frame", "all")), "--standard-errors": Example(beside=("--average", "--frame", "all")),
        **lists("space"), "--point-columns": Example("px", "py", "pz", beside=FIELD_LIST),
        "--force-on-second": Example(beside=(*FIELD_LIST[:5], "--force-columns", "gx", "gy", "gz")),
        "--wall-contacts": Example(WALL_LIST[1], beside=WALL_LIST[2:]), "--wall-id-column": Example("i", beside=WALL_LIST[:2] + WALL_LIST[4:]),
        "--wall-force-columns": Example("fx", "fy", "fz", beside=WALL_LIST[:4] + WALL_LIST[8:]),
        "--wall-point-columns": Example("px", "py", "pz", beside=WALL_LIST[:8]),
        "--wall-normal-columns": Example("nx", "ny", "nz", beside=WALL_LIST), "--vti": Example("f.vti", **GRID)},
    "voronoi": {**reading("space"), **TIME, **TABLE, **THREADS, "--spacing-on-surface": Example(0.6), "--per-particle": Example("z.dump"),
                "--box": Example(-0.002, 0.012, -0.002, 0.011, -0.002, 0.011)},
    "mixing": {**reading("space"), **TIME, **TABLE, **THREADS, "--type": Example(2), "--size": Example(drop=("--type",)),
               "--aspect": Example(drop=("--type",)), "--value": Example("heat", drop=("--type",)),
               "--region": Example(*PART, drop=("--type",)), "--cell": Example(0.004), "--scan": Example(0.002, 0.004, 3),
               "--by-volume": Example(), "--neighbours": Example(3)},
    "pairs": {**reading("space", {"beside": ("--gap", 0.0005)}), **TIME, **TABLE, **THREADS, "--farthest": Example(0.003), "--gap": Example(0.0005),
              "--lowest-gap": Example(-0.0001, beside=("--gap", 0.0005)), "--structure": Example(4000, files=at("space/wrapped.dump")), "--bins": Example(9)},
    "trajectory": {**reading("space", COLLISIONS), **TIME, **TABLE, "--origins": Example(2), "--apart": Example(2, beside=("--origins", 2)),
                   "--per-particle": Example("w_*.csv"), "--collisions": Example(beside=("--dt", 1e-5)),
                   **lists("space", COLLISIONS["beside"], forces=False),
                   "--point-columns": Example("px", "py", "pz", beside=(*[c.format("space") for c in CONTACT_LIST], *COLLISIONS["beside"])),
                   "--overlap-column": Example("h", beside=(*[c.format("space") for c in CONTACT_LIST], *COLLISIONS["beside"]))},
    "flow": {**reading("space"), "--frame": Example("200", refused="at least two frames"), "--each-file": Example(
                 files=at("space/one.100.dump", "space/one.200.dump"), refused="at least two frames"), **TIME, **TABLE, "--through": Example(0, 0, 0.002, 0, 0, 1), "--density": Example(900.0),
             "--disc": Example(0, 0, 0.0038, 0, 0, 1, 0.003, drop=("--through",)), "--face": Example(*at("face.stl"), drop=("--through",)),
             "--scale": Example(0.5, beside=("--face", *at("face.stl")), drop=("--through",)), "--total": Example(),
             "--inlet": Example(0, 0, 0.0037, 0, 0, 1, beside=("--dt", 1e-5)),
             "--profile": Example(2, beside=("--dt", 1e-5, "--disc", 0.004, 0.004, 0.0038, 0, 0, 1, 0.004), drop=("--through",)),
             "--strips": Example(1, 0, 0, 0, 0.008, beside=("--profile", 2, "--dt", 1e-5)),
             "--passages": Example("p.csv", beside=("--dt", 1e-5))},
    "paraview": {**without(reading("space"), "--each-file"), **TIME, "--output": Example("other")},
    "view": {**without(reading("space"), "--each-file"), **UP, **lists("space"), "--output": Example("other.html"), "--title": Example("Words"),
             "--colour": Example("heat"), "--log": Example(LOG), "--mesh": Example(*at("face.stl")),
             "--no-walls": Example(files=at("logged/one.dump")), "--no-contacts": Example()},
    "render3d": {**reading("space"), **each_file("space", "p_*.png"), **UP, "--output": Example("p.svg"), "--width": Example(200), "--height": Example(90),
                 "--azimuth": Example(10), "--elevation": Example(60), "--zoom": Example(2), "--colour": Example("heat"),
                 "--colour-range": Example(1, 4, beside=("--colour", "heat")), "--view": Example(*PART), "--title": Example("Words"),
                 "--show-box": Example(), "--show-walls": Example(files=at("logged/one.dump")),
                 "--log": Example(LOG, beside=("--show-walls",)), "--mesh": Example(*at("body.stl")), "--no-axes": Example(),
                 "--bare": Example()},
    "render": {**reading("plane"), **each_file("plane", "p_*.svg"), **PILE, **FIT, **lists("plane"), "--output": Example("other.svg"), "--width": Example(700),
               "--colour": Example("heat"), "--colour-range": Example(1, 4, beside=("--colour", "heat")), "--view": Example(*PLANE_VIEW),
               "--title": Example("Words"), "--no-fit": Example(), "--surface": Example(), "--discs": Example()},
    "film": {**without(reading("plane"), "--each-file"), **PILE, **FIT, "--output": Example("g_*.svg"), "--width": Example(700), "--colour": Example("heat"),
             "--rate": Example(5, usual=("--output", "f.mp4", "--width", 200)), "--title": Example("Words"),
             "--colour-range": Example(1, 4, beside=("--colour", "heat")), "--view": Example(*PLANE_VIEW), "--no-fit": Example(),
             "--space": Example(usual=("--output", "f_*.png", "--width", 160)),
             **{option: Example(*given, beside=("--space",), usual=IN_SPACE)
                for option, given in (("--azimuth", (10,)), ("--elevation", (60,)), ("--up", ("y",)), ("--part", PART), ("--height", (90,)))}},
    "report": {**reading("plane"), **PILE, **FIT, **POROSITY, **COORDINATION, **GRAVITY, **without(TABLE, "--quiet"),
               "--output": Example("other.html"), "--title": Example("Words"), "--table": Example(*at("runs.csv")),
               "--curve": Example(*at("runs.csv"), "zpp", "zss"), "--map": Example(*at("runs.csv"), "x_m", "z_m", "speed_m_per_s"),
               "--view": Example(*at("view.html"))},
    "summary": {**TABLE, "--group": Example("kind"), "--quantity": Example("zpp")},
    "plot": {"--x": Example("porosity"), "--y": Example("zss,zpp"), "--margin": Example("porosity"), "--group": Example("kind"),
             "--value": Example("speed_m_per_s", files=("map", *at("runs.csv")), usual=("--x", "x_m", "--y", "z_m", "--output", "p.svg")),
             "--title": Example("Words"), "--output": Example("other.svg"), "--width": Example(500), "--height": Example(400),
             "--aspect": Example(2.1, files=("15", *at("runs.csv")), usual=("--output", "p.svg"))},
    "template": {**TABLE, "--b": Example(2e-3), "--aspect": Example(2), "--subspheres": Example(7), "--spacing": Example("minimax_area"),
                 "--semiaxes": Example(*ON_SET[1:]), "--clump": Example(*at("clump.txt"), drop=("--subspheres",)),
                 "--from": Example(*at("body.stl")), "--picture": Example("p.svg", beside=ON_SET),
                 "--needed": Example(0.3, drop=("--subspheres",)), "--ratios": Example(0.9, beside=("--needed", 0.3), drop=("--subspheres",)),
                 "--map": Example("m.svg", beside=("--needed", 0.3, "--ratios", 0.8, 0.9), drop=("--subspheres",)),
                 "--tolerance": Example(0.1, drop=("--subspheres",)),
                 "--measure": Example("outline", beside=("--tolerance", 0.1), drop=("--subspheres",)),
                 "--mass": Example(2e-5, beside=("--molecule", "b.mol")), "--multisphere": Example("m.txt"), "--molecule": Example("b.mol"),
                 "--spheres": Example("s.csv"), "--vtp": Example("s.vtp"), "--stl": Example("s.stl"),
                 "--compare-spacings": Example(0.1, drop=("--subspheres",)), "--recommend": Example(2.0, drop=("--subspheres",))},
}


def helped(command):
    """Options that --help names, but --help itself."""
    text = subprocess.run([POST, command, "--help"], capture_output=True, text=True, check=True).stdout
    return [o for o in re.findall(r"^ {2,4}(?:-\w,)?(--[a-z0-9-]+)", text, re.MULTILINE) if o != "--help"]


def commands():
    text = subprocess.run([POST, "--help"], capture_output=True, text=True, check=True).stdout
    return re.findall(r"^  ([a-z0-9]+)[, ]", text.split("Subcommands:")[1], re.MULTILINE)


def outcome(command, words):
    """Exit code, words and files of a run in a new folder."""
    shutil.rmtree("work", ignore_errors=True)
    os.makedirs("work")
    done = subprocess.run([POST, command, *map(str, words)], capture_output=True, text=True, cwd="work", timeout=300 * SLOWNESS)
    files = {}
    for name in os.listdir("work"):
        with open(os.path.join("work", name), "rb") as file:
            files[name] = re.sub(rb"<p>Command line:</p>\n<pre>.*?</pre>", b"", file.read(), flags=re.S)
    return done.returncode, done.stdout, done.stderr, files


def split(options):
    """[--name, values ...] by option."""
    found, name = {}, None
    for word in map(str, options):
        if word.startswith("--"):
            name = word
            found[name] = []
        else:
            found[name].append(word)
    return found


def words_of(command, example, option=None, is_beside=True):
    """The arguments of an example, with an option of its or without."""
    usual = USUAL[command]
    options = split(usual["usual"] if example.usual is None else example.usual)
    if is_beside:
        for name in example.drop:
            options.pop(name, None)
        options.update(split(example.beside))
    if option:
        options[option] = example.given
    files = example.files or usual["files"]
    return [*files, *(word for name, values in options.items() for word in (name, *values))]


def is_refusal(run, option):
    """One line that names the option."""
    lines = [line for line in run[2].splitlines() if line
             and not re.search(": the same in [0-9]+ more frames?$", line)]
    return run[0] != 0 and len(lines) == 1 and option in lines[0] and not run[3]


def check_option(command, option, example):
    before = outcome(command, words_of(command, example))
    words = words_of(command, example, option)
    after = outcome(command, words)
    faults = []
    if example.refused:
        if before[0] != 0 or after[0] == 0 or example.refused not in after[2] or after[3]:
            faults.append(f"{command} {' '.join(words)}: expected '{example.refused}', found {after[:3]}")
    elif after[0] != 0:
        faults.append(f"{command} {' '.join(words)}: exit code {after[0]}: {after[2]}")
    elif after == before:
        faults.append(f"{command} {' '.join(words)}: {option} has no effect")
    if example.beside and not example.refused and option not in READING:
        before = outcome(command, words_of(command, example, is_beside=False))
        words = words_of(command, example, option, is_beside=False)
        after = outcome(command, words)
        is_told = before[0] != 0 and after[0] != 0  # without what is beside nothing works, with and without the option
        if not is_told and (after == before or (after[0] != 0 and not is_refusal(after, option))):
            faults.append(f"{command} {' '.join(words)}: {option} has no effect and is not refused in one line: {after[:3]}")
    return faults


def threads_of(command, count):
    """Threads of a run that waits for its first frame."""
    os.makedirs("work", exist_ok=True)
    if not os.path.exists("work/pipe"):
        os.mkfifo("work/pipe")
    example = Example(files=("pipe",))
    words = [*words_of(command, example), "--frame", "all", "--threads", str(count)]
    with subprocess.Popen([POST, command, *words], cwd="work", stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as run:
        end = None
        while end is None and run.poll() is None:
            try:
                end = os.open("work/pipe", os.O_WRONLY | os.O_NONBLOCK)  # as soon as it is read: threads that are wanted are there
            except OSError:
                time.sleep(0.005)
        found = len(os.listdir(f"/proc/{run.pid}/task")) if run.poll() is None else 0
        if end is not None:
            os.close(end)
        run.wait(60 * SLOWNESS)
    return found


def check_threads(command):
    """--threads: so many threads beside the one that reads; without --frame all it is refused."""
    counts = [threads_of(command, count) for count in (1, 3, 5)]
    faults = [] if counts[0] == 1 and counts[2] - counts[1] == 2 else [f"{command} --threads 1, 3, 5: {counts} threads"]
    run = outcome(command, [*words_of(command, Example()), "--frame", "last", "--threads", "2"])
    return faults + ([] if is_refusal(run, "--threads") else [f"{command} --frame last --threads 2: {run[:3]}"])


def check_command(command):
    faults, options, examples = [], helped(command), EXAMPLES[command]
    assert options, command
    faults += [f"{command}: no example of {o}" for o in options if o not in examples]
    faults += [f"{command}: an example of {o}, which is gone" for o in examples if o not in options]
    for option in options:
        if option == "--threads":
            faults += check_threads(command)
        elif option in examples:
            faults += check_option(command, option, examples[option])
    return faults


def main():
    os.makedirs("scenes")
    os.chdir("scenes")
    write_scenes()
    os.chdir("..")
    assert set(commands()) == set(EXAMPLES) == set(USUAL), set(commands()) ^ set(EXAMPLES)
    wanted = sys.argv[1:] or commands()
    faults = [fault for command in wanted for fault in check_command(command)]
    assert not faults, "\n" + "\n".join(faults)


if __name__ == "__main__":
    main()
