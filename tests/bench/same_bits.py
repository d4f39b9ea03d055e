"""Whether two builds of the engine compute the same numbers, bit for bit.

    python3 tests/bench/same_bits.py BUILD_A/bin/liggghts BUILD_B/bin/liggghts [--cases REGEX] [--folder F]

Runs each case with both engines and compares everything that they write: dumps with all digits, lists of
contacts, restart files. Exit status 0: all the same. It is no test of the suite: it is for changes of structure,
which must not change a result.
"""

import argparse
import filecmp
import os
import re
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
INPUTS = HERE.parent.parent / "inputs"
sys.path.insert(0, str(HERE.parent / "engine"))
os.environ.setdefault("ELLIPSOID_BIN", "")  # _engine wants to know it
from _engine import COLUMNS, LAW, Setup, ellipsoids_data  # noqa: E402
import start  # noqa: E402

PROPERTIES = {
    "kn": 1e4, "kt": 8e3, "gamman": 400.0, "gammat": 200.0, "coefficientRollingFriction": 0.1,
    "coefficientRollingViscousDamping": 0.0, "cohesionEnergyDensity": 2e5}
SIDE = 0.02  # of the periodic base of the beds (m)


def ending(steps, pairs=True, every=100):
    """Script lines: a run of `steps` whose states and contacts are written with all digits."""
    form = " ".join("%d" if c in ("id", "type") else "%.17g" for c in COLUMNS)
    rows = " ".join(f"c_rows[{k}]" for k in range(1, 17))
    script = f"""
dump state all custom {every} state.dump {' '.join(COLUMNS)}
dump_modify state sort id format "{form}"
"""
    if pairs:
        script += f"""compute rows all pair/ellipsoid/local id contactPoint normal delta force reducedRadius contactArea spheres
dump rows all local {every} contacts.dump {rows}
dump_modify rows format "{' '.join(['%.17g'] * 16)}"
compute stress all stress/atom
dump stress all custom {every} stress.dump id c_stress[1] c_stress[2] c_stress[3] c_stress[4] c_stress[5] c_stress[6]
dump_modify stress sort id format "%d{' %.17g' * 6}"
"""
    return script + f"run {steps}\nwrite_restart end.restart\n"


def example(name, steps=200, **variables):
    lines = "".join(f"variable {n} index {v}\n" for n, v in {**variables, "out": "out"}.items())
    return lines + f"include {INPUTS / name}.in\n" + ending(steps)


def compaction(shape, **variables):
    return example("compaction", shape=shape, duration=0.04, start="start.data", **variables)


def bed(law=LAW, surface="smooth", settings="", head="", motion="", steps=2000):
    """200 ellipsoids that fall on a floor and on each other."""
    particles, height = start.lattice("smooth", 4, 200, 5e-3)
    for p in particles:
        p.velocity = (*p.velocity[:2], p.velocity[2] - 4.0 * p.position[2] / 0.03)
    box = (0.0, SIDE, 0.0, SIDE, 0.0, height + 0.01)
    setup = Setup(box=box, boundary="p p f", pair=f"gran/ellipsoid {law} surface {surface} {settings}", time_step=5e-6,
                  skin=1e-3)
    Path("start.data").write_text(ellipsoids_data(particles, box, 1))
    script = setup.header() + "read_data start.data\n" + setup.properties().replace(
        "delay 0", "delay 0 page 1000000")
    text = "fix velocity all property/global characteristicVelocity scalar 0.5\n"
    for k, (name, value) in enumerate(PROPERTIES.items()):
        text += f"fix model{k} all property/global {name} peratomtypepair 1 {value!r}\n"
    script = script.replace("pair_style", text + "pair_style", 1)
    if surface == "multisphere":
        script += "fix subspheres all property/atom subspheres scalar yes yes no 7\n"
    return script + head + f"""
fix gravity all gravity 9.81 vector 0 0 -1
fix floor all wall/gran/ellipsoid {law} surface {surface} primitive type 1 zplane 0.0 {settings}
fix motion all nve/ellipsoid {motion}
run {steps}
""" + ending(600)


def cases():
    """{name: (ranks, maker of the script)}; a maker may write start.data."""
    pile = {"particles": 8, "y0": 0.008, "interval": 0.008, "settle": 0.06, "dt": 5e-6, "vtk": "no"}
    host = "model hertz tangential history"
    return {
        "pile": (1, lambda: example("piling", **pile)),
        "pile_multisphere": (1, lambda: example("piling", surface="multisphere", **pile)),
        "pile_velocity": (1, lambda: example("piling", direction="velocity", **pile)),
        "compaction": (1, lambda: compaction("smooth")),
        "compaction_multisphere": (1, lambda: compaction("multisphere", subspheres=3)),
        "bed": (1, bed),
        "bed_two_ranks": (2, bed),
        "bed_multisphere": (1, lambda: bed(surface="multisphere", settings="contacts 16")),
        "bed_multisphere_average": (2, lambda: bed(surface="multisphere", settings="contacts 16 multicontact average")),
        "bed_gear": (1, lambda: bed(motion="integrator gear")),
        "bed_frozen": (1, lambda: bed(head="group low id < 17\nfix hold low freeze\n")),
        "bed_limited": (1, lambda: bed(settings="limitForce on")),
        "bed_elliptical": (1, lambda: bed(settings="ellipticalContact on")),
        "drum": (1, lambda: example("drum", particles=100, fill=0.03, turn=0.02, meshes=INPUTS / "meshes")),
        "mixture": (2, lambda: example("mixture", particles=100, time=0.05)),
        "host": (1, lambda: bed(host)),
        "host_multisphere": (2, lambda: bed(host, "multisphere", "contacts 16")),
        "host_rolling_cohesion": (1, lambda: bed(host + " cohesion sjkr2 rolling_friction epsd2")),
        "host_hooke": (1, lambda: bed("model hooke tangential history rolling_friction cdt")),
    }


def run(engine, ranks, make, folder):
    folder.mkdir(parents=True)
    before = Path.cwd()
    os.chdir(folder)
    try:
        script = make()
        if "start=" in script or "compaction.in" in script:
            Path("start.data").write_text(start.compaction(
                "multisphere" if "index multisphere" in script else "smooth"))
        Path("in.run").write_text(script)
        command = ["mpirun", "-np", str(ranks), "--oversubscribe", "--allow-run-as-root"] if ranks > 1 else []
        done = subprocess.run(command + [str(engine), "-in", "in.run"], capture_output=True, text=True,
                              errors="replace")
        if done.returncode != 0:
            sys.exit(f"{engine} fails in {folder}:\n{(done.stdout + done.stderr)[-2000:]}")
    finally:
        os.chdir(before)


def differing(a, b):
    """Files (but logs and scripts) that are not the same in both folders."""
    files = [sorted(f.relative_to(folder) for folder_, _, names in os.walk(folder)
                    for f in (Path(folder_) / n for n in names)) for folder in (a, b)]
    if files[0] != files[1]:
        return ["other files"]
    return [str(f) for f in files[0] if not f.name.startswith(("log.", "in.", "tmp."))
            and not filecmp.cmp(a / f, b / f, shallow=False)]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("engines", nargs=2, type=lambda name: Path(name).resolve())
    parser.add_argument("--cases", default="", help="regular expression")
    parser.add_argument("--folder", type=lambda name: Path(name).resolve(), default="same_bits")
    arguments = parser.parse_args()
    if Path(arguments.folder).exists():
        sys.exit(f"{arguments.folder} is there already; remove it, or give another --folder")
    differs = False
    for name, (ranks, make) in cases().items():
        if not re.search(arguments.cases, name):
            continue
        folders = [Path(arguments.folder) / name / side for side in "ab"]
        for engine, folder in zip(arguments.engines, folders):
            run(engine, ranks, make, folder)
        files = differing(*folders)
        contacts = folders[0] / "contacts.dump"
        rows = sum(len(line.split()) == 16 for line in contacts.read_text().splitlines())
        print(f"{name:26s} {'differs: ' + ', '.join(files) if files else 'same bits'} ({rows} contacts listed)",
              flush=True)
        differs = differs or bool(files)
    sys.exit(1 if differs else 0)


if __name__ == "__main__":
    main()
