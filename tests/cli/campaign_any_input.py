# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""The driver of campaigns with an input of the user's own: one particle that flies, whose energy is known in closed
form; matrices, lists, a run that fails, runs that are killed, results that are not this run's, wrong options, and
the calibration against numpy and Monte Carlo."""

import csv
import math
import os
import pathlib
import re
import signal
import subprocess
import sys
import time

import numpy as np

SOURCE = pathlib.Path(os.environ["ELLIPSOID_SOURCE"])
sys.path.insert(0, str(SOURCE / "inputs" / "campaign"))
import calibration  # noqa: E402
import results  # noqa: E402
from options import Misuse  # noqa: E402

MASS = 2e-5
INPUT = """# flies through an empty box
variable seed   index 1
variable speed  index 1.0
variable steps  index 10
variable dt     index 1e-6
variable out    index out/flight

make_folder     ${out}
log             ${out}/log.flight
atom_style      granular/ellipsoid
atom_modify     map array
boundary        f f f
newton          off
communicate     single vel yes
units           si
region          box block -1 1 -1 1 -1 1 units box
create_box      1 box
neighbor        0.01 bin
fix m1 all property/global youngsModulus peratomtype 183e6
fix m2 all property/global poissonsRatio peratomtype 0.2
fix m3 all property/global coefficientFriction peratomtypepair 1 0.3
fix m4 all property/global viscousDampingNormal peratomtypepair 1 100.0
fix m5 all property/global viscousDampingTangential peratomtypepair 1 100.0
pair_style      gran/ellipsoid model hertz/viscous tangential history/viscous surface smooth
pair_coeff      * *
timestep        ${dt}
fix grain all particletemplate/ellipsoid 15485863 atom_type 1 semiaxes 2.7e-3 1.15e-3 1.15e-3 &
    mass 2e-5 inertia 1e-11 3e-11 3e-11
fix drop all insert/drop seed ${seed} template grain particles 1 interval ${dt} box 0 0 0 0 0 0
fix motion all nve/ellipsoid
run 2
variable vx equal ${speed}+0.1*(${seed}-2)*${speed}
velocity all set ${vx} 0 0
dump d all custom ${steps} ${out}/flight.*.dump id type mass x y z vx vy vz omegax omegay omegaz &
    quat1 quat2 quat3 quat4 shapex shapey shapez
dump_modify d format "%d %d %.16g %.16g %.16g %.16g %.16g %.16g %.16g %.16g %.16g %.16g %.16g %.16g %.16g %.16g %.16g %.16g %.16g"
run ${steps}
"""
MEASURE = ["--measure", "ellipsoid-post energy {out}/flight.*.dump --gravity 0 0 0", "--quantity", "translation_J"]


def campaign(*words, code=0):
    """Its output; the exit status is checked."""
    done = subprocess.run(["bash", SOURCE / "inputs" / "campaign.sh", *map(str, words)], text=True,
                          capture_output=True, timeout=300)
    assert done.returncode == code, (words, done.returncode, done.stdout, done.stderr)
    if code:
        assert len(done.stderr.splitlines()) == 1, done.stderr
        assert done.stderr.startswith("campaign.sh: "), done.stderr
    return done.stdout + done.stderr


def energy(speed, seed):
    return 0.5 * MASS * (speed * (1 + 0.1 * (seed - 2))) ** 2


def rows(file):
    with open(file, newline="") as stream:
        return list(csv.DictReader(stream))


def check_table(file, wanted):
    """Each run's energy is that of its own variables."""
    found = {row["run"]: float(row["translation_J"]) for row in rows(file)}
    assert sorted(found) == sorted(wanted), found
    for name, value in wanted.items():
        assert math.isclose(found[name], value, rel_tol=1e-9), (name, found[name], value)


def flight(*words, **more):
    return campaign("--input", "flight.in", *MEASURE, *words, **more)


def check_matrix():
    text = flight("--out", "matrix", "--vary", "speed=1,2,4", "--seeds", "1 2 3", "--jobs", 2,
                  "--calibrate", "speed:translation_J=1e-4")
    wanted = {f"speed_{v}_seed{s}": energy(v, s) for v in (1, 2, 4) for s in (1, 2, 3)}
    check_table("matrix/table.csv", wanted)
    means = {row["speed"]: float(row["translation_mean_J"]) for row in rows("matrix/summary.csv")}
    for v in (1, 2, 4):
        assert math.isclose(means[str(v)], np.mean([energy(v, s) for s in (1, 2, 3)]), rel_tol=1e-9), means
    assert "9 of 9 runs finished" in text and " s left" in text, text
    # the energy is a parabola of the speed: the calibrated speed is exact
    exact = math.sqrt(1e-4 / np.mean([energy(1, s) for s in (1, 2, 3)]))
    assert f"speed = {exact:.4g} +-" in text, (exact, text)
    assert pathlib.Path("matrix/calibration.png").stat().st_size > 2000
    again = flight("--out", "matrix", "--vary", "speed=1,2,4", "--seeds", "1 2 3", "--jobs", 2)
    assert again.count("was finished before") == 9, again


def check_list_and_failure():
    pathlib.Path("runs.txt").write_text("# three runs\nspeed=1 steps=10\n\nspeed=2 steps=20 # one more\n"
                                        "speed=3 dt=-1\n")
    text = flight("--out", "list", "--list", "runs.txt", "--jobs", 2, code=2)
    assert text.rstrip().endswith("campaign.sh: 1 of the 3 runs did not finish"), text
    assert text.count("    ERROR") == 1 and "speed_3_dt_-1: stopped" in text, text
    check_table("list/table.csv", {"speed_1_steps_10": energy(1, 1), "speed_2_steps_20": energy(2, 1)})
    for number, name in (0, "speed_1_steps_10"), (1, "speed_2_steps_20"):
        flight("--out", "array", "--list", "runs.txt", "--only", number)
        assert pathlib.Path("array", name, "energy.csv").is_file()
    assert not pathlib.Path("array/table.csv").exists()
    assert campaign("--input", "flight.in", "--list", "runs.txt", "--seeds", "1 2", "--count") == "6\n"


def start_in_group(out, words):
    """A campaign in a process group of its own, when its engine writes."""
    process = subprocess.Popen(["bash", SOURCE / "inputs" / "campaign.sh", "--out", out, *words],
                               stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                               start_new_session=True)
    log = pathlib.Path(out, "speed_1", "log.flight")
    for _ in range(3000):
        if log.is_file() and "Setting up run" in log.read_text():
            return process
        assert process.poll() is None, "the run was over before it could be stopped"
        time.sleep(0.02)
    raise AssertionError("the run does not begin")


def check_stopped():
    """An input that cannot go on begins anew, and has the same result."""
    words = ["--input", "flight.in", *MEASURE, "--vary", "speed=1", "--jobs", "1", "--", "-var", "steps", "400000"]
    for out, sign in ("killed", signal.SIGKILL), ("ended", signal.SIGTERM):
        process = start_in_group(out, words)
        os.killpg(process.pid, sign)
        message = process.communicate(timeout=60)[1]
        assert process.returncode != 0
        if sign == signal.SIGTERM:
            assert message == "campaign.sh: stopped; the same line goes on with what is left\n", message
        assert not pathlib.Path(out, "speed_1", "energy.csv").exists()
        campaign("--out", out, *words)
        check_table(f"{out}/table.csv", {"speed_1": energy(1, 1)})


def check_other_results():
    """What another campaign left is never taken for this one's."""
    before = ["--out", "matrix", "--vary", "speed=1"]
    text = flight(*before, "--seeds", "1", "--", "-var", "steps", 20, code=2)
    assert "was run with steps = its default, now it is 20" in text, text
    text = pathlib.Path("flight.in").read_text()
    pathlib.Path("flight.in").write_text(text + "# changed\n")
    assert "was run with another flight.in" in flight(*before, "--seeds", "1", code=2)
    pathlib.Path("flight.in").write_text(text)
    pathlib.Path("foreign/speed_1").mkdir(parents=True)
    pathlib.Path("foreign/speed_1/flight.000.dump").write_text("")
    assert "no such campaign made" in flight("--out", "foreign", "--vary", "speed=1", code=2)
    # another measure of the same runs needs no new run
    log = pathlib.Path("matrix/speed_1_seed1/log.flight")
    changed = log.stat().st_mtime_ns
    campaign("--input", "flight.in", *before, "--seeds", "1", "--measure", "orientation {out}/flight.*.dump")
    assert pathlib.Path("matrix/speed_1_seed1/orientation.csv").is_file() and log.stat().st_mtime_ns == changed


def check_messages():
    vary = ["--out", "x", "--vary", "speed=1,2"]
    for words, message in [
            (["--out", "x", "--vary", "sped=1"], "has no line 'variable sped index ...'; it has seed, speed"),
            ([*vary, "--", "-var", "sped", "1"], "has no line 'variable sped index"),
            ([*vary, "--", "-var", "speed", "1"], "the variable 'speed' is given twice"),
            ([*vary, "--", "-var", "steps"], "allowed is -var NAME VALUE"),
            (["--out", "x", "--vary", "speed"], "'speed' in --vary is no NAME=VALUE"),
            (["--out", "x", "--vary", "speed=1,a b"], "the value 'a b' of speed is no name for a folder"),
            (["--out", "x", "--vary", "speed=1,1"], "has a value twice"),
            (["--out", "x", "--vary", "out=a"], "the variable 'out' is the driver's"),
            ([*vary, "--seeds", "0"], "seed '0' is no integer > 0"),
            ([*vary, "--jobs", "0"], "--jobs is '0', allowed is an integer >= 1"),
            ([*vary, "--ranks", "x"], "--ranks is 'x', allowed is an integer >= 1"),
            ([*vary, "--only", "2"], "--only is '2', allowed is 0 to 1"),
            ([*vary, "--bogus"], "unrecognized arguments: --bogus"),
            (["--out"], "expected one argument"),
            (["--vary", "speed=1,2"], "option --out is missing"),
            (["--out", "x", "--list", "none.txt"], "No such file"),
            ([*vary, "--measure", "energy {out}/a --csv b"], "--csv and --quiet are the driver's"),
            ([*vary, "--calibrate", "speed"], "allowed is NAME:COLUMN=VALUE"),
            ([*vary, "--calibrate", "dt:translation_J=1"], "--calibrate takes dt, what varies is speed")]:
        text = flight(*words, code=2)
        assert message in text, (words, text)
    assert "no input script absent.in" in campaign("--input", "absent.in", "--out", "x", code=2)
    assert not pathlib.Path("x").exists()
    text = campaign("--input", "flight.in", "--out", "matrix", "--vary", "speed=1", "--seeds", "1",
                    "--measure", "energy {out}/absent.*.dump", code=2)
    assert "ellipsoid-post energy failed: " in text, text
    text = flight("--out", "matrix", "--vary", "speed=1,2,4", "--seeds", "1 2 3", "--quantity", "bogus", code=2)
    assert "no column 'bogus' in the measures" in text, text
    for wanted, what in ("1", "not reached"), ("1e-9", "not reached"):
        text = flight("--out", "matrix", "--vary", "speed=1,2,4", "--seeds", "1 2 3", "--calibrate",
                      f"speed:translation_J={wanted}", code=2)
        assert what in text and "choose other values of --vary" in text, text


def refused(call, message):
    try:
        call()
    except Misuse as misuse:
        assert message in str(misuse), misuse
    else:
        raise AssertionError("accepted: " + message)


def plot(*words):
    return subprocess.run([pathlib.Path(os.environ["ELLIPSOID_BIN"]) / "ellipsoid-post", "plot", *words],
                          capture_output=True, text=True)


def check_margins():
    """`plot curve --margin` draws bars as long as twice the margins, on the scale of the ordinates."""
    pathlib.Path("margins.csv").write_text("x,y,m\n1,10,1\n2,12,3\n3,11,\n")
    words = ["curve", "margins.csv", "--x", "x", "--y", "y", "-o", "margins.svg"]
    assert plot(*words, "--margin", "m").returncode == 0
    lines = [[tuple(map(float, p.split(","))) for p in points.split()]
             for points in re.findall('<polyline points="([^"]*)" fill="none" stroke="#0073b3"',
                                      pathlib.Path("margins.svg").read_text())]
    curve = lines[0]
    unit = (curve[0][1] - curve[1][1]) / (12.0 - 10.0)  # pixels
    bars = {x: abs(y - end) for (x, y), (across, end), *more in lines[1:] if x == across and not more}
    assert len(curve) == 3 and len(bars) == 2, lines
    for (x, _), margin in zip(curve, (1.0, 3.0)):
        assert abs(bars[x] / (2.0 * margin * unit) - 1.0) < 1e-3, (x, bars)
    for more, message in (["--margin", "m,m"], "2 columns of margins for 1 of curves"), (
            ["--margin", "bogus"], 'expected a column "bogus"'):
        done = plot(*words, *more)
        assert done.returncode == 1 and message in done.stderr, done.stderr
    done = plot("map", *words[1:], "--value", "m", "--margin", "m")
    assert done.returncode != 0 and "--margin: has no effect on a map" in done.stderr, done.stderr


def check_calibration():
    """Coefficients against numpy.polyfit; the uncertainty against runs drawn anew, 4000 times."""
    random = np.random.default_rng(3)
    xs, scatter, wanted = np.array([0.1, 0.2, 0.3, 0.5]), 1.5, 26.0
    truth = np.polynomial.Polynomial([12.0, 70.0, -50.0])

    def draw():
        return {x: list(truth(x) + scatter * random.standard_normal(5)) for x in xs}

    groups = draw()
    curve, x, error = calibration.solve(groups, wanted, "mu", "angle")
    all_x = np.repeat(xs, 5)
    expected = np.polyfit(all_x, np.concatenate([groups[k] for k in xs]), 2)
    roots = np.roots(expected - [0, 0, wanted])
    assert np.min(np.abs(roots - x)) < 1e-9, (roots, x)
    found = []
    for _ in range(4000):
        values = np.concatenate([g for g in draw().values()])
        roots = np.roots(np.polyfit(all_x, values, 2) - [0, 0, wanted])
        found.append(roots[np.argmin(np.abs(roots - x))].real)
    # pooled from 16 degrees of freedom, the estimate itself scatters by 1 / sqrt(32)
    assert abs(error / np.std(found) - 1.0) < 3.0 / math.sqrt(32.0), (error, np.std(found))
    rows = [{"run": "a", "mu": "0.1", "angle": "20"}, {"run": "b", "mu": "0.1"}]  # too small a pile
    results.require_columns(rows, ["angle"])
    refused(lambda: results.require_columns(rows, ["bogus"]), "no column 'bogus'")
    refused(lambda: calibration.grouped(rows, "mu", "angle"), "run b has mu = '0.1' and angle = '', numbers")
    for groups, message in [({1.0: [2.0, 3.0]}, "two values of mu"), ({1.0: [2.0], 2.0: [3.0]}, "two seeds"),
                            ({0.0: [0.0, 0.0], 1.0: [3.0, 3.0], 2.0: [0.0, 0.0]}, "reached 2 times")]:
        refused(lambda: calibration.solve(groups, 1.5, "mu", "angle"), message)


def main():
    pathlib.Path("flight.in").write_text(INPUT)
    check_calibration()
    check_margins()
    check_matrix()
    check_list_and_failure()
    check_stopped()
    check_other_results()
    check_messages()
    print("passed")


if __name__ == "__main__":
    main()
