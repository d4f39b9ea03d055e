"""A run that goes on from a file of `restart N` against the run that wrote it, digit by digit, in all sorts of
settings: surfaces, walls, meshes that move, boundaries, integrators, insertions, contact models, 1 and 2 ranks,
scripts of several runs.

What is compared are all columns of all frames from the file's step on, forces and torques included, and the
thermo tables. Particles fall on each other on a floor; every setting is interrupted at several steps, so that
some of them see particles in the air, in rich contact, and waiting for a place.
"""

import re
import signal
import subprocess
import time
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

from _engine import LAW, LIGGGHTS, Setup, dump, run
from _mesh import floor, mesh, mesh_wall, quad, write_stl
from contact_models import with_properties

END, EVERY, SAMPLE = 12000, 4000, 250
DROP = """
fix drop all insert/drop seed 4711 template grain particles 40 interval 1.4e-3 &
    box -0.0035 0.0035 -0.0035 0.0035 0.009 0.0125 velocity 0 0 -0.8
"""
INSERT = "distributiontemplate mix overlapcheck yes orientation random"
REGION = "region above block -0.0055 0.0055 -0.0055 0.0055 0.004 0.02 units box\n"
HORIZONTAL = [0, 2, 1]  # columns that turn the xz plane of a mesh into the xy plane


def script(start, surface, boundary="p p f", walls=None, motion="", insertion=DROP, law=LAW, head="",
           damping=20000.0):
    """Script of about 30 particles; `start` reads a restart file, or is None."""
    setup = Setup(box=(-0.007, 0.007, -0.007, 0.007, -0.001, 0.045), time_step=5e-6, skin=0.001,
                  boundary=boundary, pair=f"gran/ellipsoid {law} surface {surface}", damping_normal=damping,
                  damping_tangential=damping)
    shape = "2.7e-3 1.2e-3 1.2e-3 subspheres 5" if surface == "multisphere" else "2.7e-3 1.8e-3 1.2e-3"
    wall = f"wall/gran/ellipsoid {law} surface {surface} primitive type 1"
    if walls is None:
        walls = f"fix floor all {wall} zplane 0.0\n"
    text = setup.header() + head + (start or setup.create_box()) + setup.properties() + f"""
fix gravity all gravity 60 vector 0.1 0 -1
fix grain all particletemplate/ellipsoid 15485863 density 1340 semiaxes {shape}
fix mix all particledistribution/discrete 32452843 1 grain 1.0
{walls.replace('SURFACE', surface)}{insertion}
fix motion all nve/ellipsoid {motion}
compute search all contacts/ellipsoid
thermo_style custom step atoms ke c_search[1] c_search[2] c_search[3] c_search[4] c_search[5]
thermo_modify lost error norm no
thermo 500
"""
    return text if law == LAW else with_properties(
        text.replace("delay 0", "delay 0 page 1000000"), law)


def settings():
    """{name: keyword arguments of script()}."""
    wall = f"wall/gran/ellipsoid {LAW} surface SURFACE primitive type 1"
    tube = f"fix tube all {wall} zcylinder 0.0068 0.0 0.0\n"
    meshes = mesh("cad", "floor.stl") + mesh_wall("cad_wall", ["cad"], "SURFACE")
    turning = "fix turn all move/mesh mesh cad rotate origin 0 0 0 axis 0 0 1 period 0.5\n"
    stream = mesh("face", "face.stl", style="mesh/surface/planar") + (
        f"fix fill all insert/stream seed 32452867 {INSERT} nparticles 30 particlerate 900 vel constant 0 0 -0.8 "
        "insertion_face face extrude_length 0.012\n")
    pack = REGION + f"fix fill all insert/pack seed 32452867 {INSERT} "
    rate = REGION + (f"fix fill all insert/rate/region seed 32452867 {INSERT} nparticles 30 particlerate 900 "
                     "insert_every 700 vel uniform 0 0 0 0.1 0.1 0.1 region above\n")
    return {
        "floor": {}, "periodic": {"boundary": "p p p"}, "shrunk": {"boundary": "m m m"},
        "fixed": {"boundary": "f f f", "walls": f"{tube}fix floor all {wall} zplane 0.0\n"},
        "sliding": {"walls": f"fix belt all {wall} zplane 0.0 shear x 0.1\n"},
        "mesh": {"walls": meshes},
        "turning": {"boundary": "m m m", "walls": meshes + turning + tube},  # above the square at any angle
        "vibrating": {"walls": meshes + turning.replace("rotate origin 0 0 0 axis 0 0 1 period 0.5",
                                                        "wiggle amplitude 0 0 0.0005 period 0.02")},
        "conveying": {"walls": meshes + turning.replace("rotate origin 0 0 0 axis 0 0 1 period 0.5",
                                                        "linear 0.01 0 0")},
        "gear": {"motion": "integrator gear", "damping": 3000.0},
        "pack": {"insertion": pack + "insert_every 1300 region above particles_in_region 12\n"},
        "once": {"insertion": pack + "insert_every once region above particles_in_region 25\n"},
        "rate": {"insertion": rate}, "stream": {"insertion": stream},
        "sorted": {"head": "atom_modify sort 70 0.003\n"}, "unsorted": {"head": "atom_modify sort 0 0\n"},
        "rolling": {"law": "model hertz tangential history rolling_friction epsd"},
        "plastic": {"law": "model hooke/hysteresis tangential history"},
    }


def frames(file):
    """{step: lines} of a text dump."""
    found = {}
    for frame in Path(file).read_text().split("ITEM: TIMESTEP\n")[1:]:
        lines = frame.splitlines()
        found[int(lines[0])] = lines[8:]
    return found


def thermo_lines(name, begin):
    """{step: set of its lines} in the thermo tables of a log file, from step `begin` on."""
    found = {}
    for line in Path(f"log.in.{name}").read_text().splitlines():
        if re.fullmatch(r" *\d+( +\S+){7} *", line) and int(line.split()[0]) >= begin:
            found.setdefault(int(line.split()[0]), set()).add(line)
    return found


class Settings(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        write_stl("floor.stl", floor(0.0068, 5)[:, :, HORIZONTAL])
        h, z = 0.004, 0.016
        write_stl("face.stl", quad((-h, -h, z), (h, -h, z), (h, h, z), (-h, h, z)))

    def interrupt(self, name, ranks, runs, **options):
        """Complaints; `runs` are the steps at which the script's runs end."""
        def commands(begin, dump_file, restart):
            steps = "".join(f"run {step} upto\n" for step in runs if step > begin)
            return f"restart {EVERY} {restart}.*.restart\n" + dump(dump_file, SAMPLE) + steps
        run(script(None, **options) + commands(0, f"{name}.dump", name), ranks, name=f"in.{name}")
        whole, wrong = frames(f"{name}.dump"), []
        touching = sum(float(line.split()[15]) != 0.0 for line in whole[END][1:])
        if touching < 5 or len(whole[END]) < 15:
            wrong.append(f"{name}: only {touching} of {len(whole[END]) - 1} particles touch others at the end")
        for step in range(EVERY, END, EVERY):
            again = f"{name}.{step}"
            run(script(f"read_restart {name}.{step}.restart\n", **options)
                + commands(step, f"{again}.dump", again), ranks, name=f"in.{again}")
            expected = {s: lines for s, lines in whole.items() if s >= step}
            found = frames(f"{again}.dump")
            first = [s for s in sorted(expected) if expected[s] != found.get(s)]
            if first or expected.keys() != found.keys():
                wrong.append(f"{again}: differs at step {first[:1]}, {len(first)} of {len(expected)} frames")
            tables = [thermo_lines(n, step) for n in (name, again)]
            differ = sorted(s for s in tables[1] if not tables[1][s] <= tables[0].get(s, set()))
            if differ or len(tables[1]) < (END - step) // 500:
                wrong.append(f"{again}: thermo differs at {differ[:3]}")
        return wrong

    def interrupt_all(self, jobs, at_a_time=2):
        with ThreadPoolExecutor(at_a_time) as pool:
            found = pool.map(lambda job: self.interrupt(job[0], job[1], job[2], **job[3]), jobs)
            wrong = [complaint for complaints in found for complaint in complaints]
        self.assertFalse(wrong, "\n".join(wrong))

    def test_one_rank(self):
        self.interrupt_all([(f"{surface}.{name}", 1, [END], {"surface": surface, **options})
                            for surface in ("smooth", "multisphere")
                            for name, options in settings().items()])

    def test_more_ranks(self):
        few = {"smooth": ("floor", "shrunk", "turning", "stream"), "multisphere": ("periodic", "gear", "pack")}
        self.interrupt_all([(f"{surface}.{name}.2", 2, [END], {"surface": surface, **settings()[name]})
                            for surface, names in few.items() for name in names]
                           + [("smooth.floor.4", 4, [END], {"surface": "smooth"})], at_a_time=1)

    def test_a_script_of_several_runs(self):
        self.interrupt_all([(f"{surface}.{name}.runs", 1, [2500, EVERY, 7000, END], {"surface": surface, **settings()[name]})
                            for surface, name in (("smooth", "floor"), ("multisphere", "floor"), ("smooth", "turning"))])

    def test_a_file_that_a_signal_asked_for(self):
        """SIGUSR1: the file is written at whatever step the run has reached, and the run goes on."""
        steps = 4 * END
        end = f"run {steps} upto\n"
        for former in [Path("signal.dump"), *Path().glob("restart_forced_liggghts_*.data")]:
            former.unlink(missing_ok=True)
        Path("in.signal").write_text(script(None, "smooth") + dump("signal.dump", SAMPLE) + end)
        with subprocess.Popen([str(LIGGGHTS), "-in", "in.signal", "-log", "none"],
                              stdout=subprocess.DEVNULL) as process:
            while not (Path("signal.dump").exists() and f"\n{END}\n" in Path("signal.dump").read_text()):
                self.assertIsNone(process.poll(), "the run was over before the signal")
                time.sleep(0.01)
            process.send_signal(signal.SIGUSR1)
            self.assertEqual(process.wait(), 0)
        (file,) = Path().glob("restart_forced_liggghts_*.data")
        step = int(re.search(r"\d+", file.name)[0])
        self.assertTrue(END <= step < steps, f"the file is of step {step}")
        run(script(f"read_restart {file}\n", "smooth") + dump("signal.again", SAMPLE) + end, name="in.signal.again")
        found, whole = frames("signal.again"), frames("signal.dump")
        self.assertEqual(max(found), steps)
        self.assertEqual(found, {s: lines for s, lines in whole.items() if s >= step})


if __name__ == "__main__":
    unittest.main(verbosity=2)
