"""Time of a step with clumps of 17, 55 and 200 spheres, beside the host's fix multisphere with the same spheres,
law and bodies: stones that fall, most of them alone, or a dense bed of several layers. Prints ns of processor time per body and step, and the
ratio, measured in one run, one after the other, twice; the faster of each counts. Adds a row for each to clumps.csv.

    python3 tests/bench/clumps.py [--dense] [FOLDER [SPHERES ...]]

SPHERES: of a body, 17 55 200 where none are given. ELLIPSOID_BIN: folder of the engine, build/bin of this tree where it is
not given. Needs numpy.
"""

import csv
import os
import sys
from pathlib import Path

import numpy as np

os.environ.setdefault("ELLIPSOID_BIN", str(Path(__file__).resolve().parent.parent.parent / "build" / "bin"))
sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "engine"))
from _engine import LAW, Particle, Setup, dump, ellipsoids_data, read_dump, rigid_bodies, run  # noqa: E402
from _multisphere import multisphere_setup, wall  # noqa: E402
from clump_host import Cloud, quaternion, words  # noqa: E402

BODIES, STEPS, TIME_STEP = 60, 1000, 2e-6
DENSE = "--dense" in sys.argv
SIDE, HEIGHT, FALL = (0.014, 0.08, 60000) if DENSE else (0.03, 0.018, 4000)
MASS, MOMENTS = 1.2e-5, (8e-12, 1.7e-11, 2.0e-11)
GOLDEN_ANGLE = np.pi * (3.0 - np.sqrt(5.0))
BOX = (0.0, SIDE, 0.0, SIDE, 0.0, HEIGHT + 0.04)


def stone(count):
    """A rough stone of some 2 x 1.5 x 1 mm, 17 to 200 spheres over its surface and one in its middle (N, 4)."""
    k = np.arange(count - 1) + 0.5
    height, angle = 1.0 - 2.0 * k / (count - 1), GOLDEN_ANGLE * k
    across = np.sqrt(1.0 - height ** 2)
    direction = np.stack([across * np.cos(angle), across * np.sin(angle), height], axis=1)
    radius = 0.6e-3 * (17.0 / count) ** 0.25
    axes = np.array([2.0e-3, 1.5e-3, 1.0e-3])
    places = np.vstack([np.zeros(3), direction * (axes - radius)])
    return np.column_stack([places, np.concatenate([[0.9e-3], np.full(count - 1, radius)])])


def head(**options):
    return Setup(box=BOX, boundary="p p f", time_step=TIME_STEP, skin=0.0005, **options)


def host_script(body):
    np.savetxt("stone.host", body, fmt="%.17g")
    i_x, i_y, i_z = MOMENTS
    return head(atom_style="sphere", pair=f"gran {LAW}").without_particles() + f"""
fix gravity all gravity 9.81 vector 0 0 -1
fix floor all wall/gran {LAW} primitive type 1 zplane 0.0
fix grain all particletemplate/multisphere 10037 atom_type 1 density constant 1340 &
    nspheres {len(body)} ntry 1000 spheres file stone.host scale 1.0 type 1 &
    mass {MASS} inertia_tensor {i_x} 0 0 {i_y} 0 {i_z} use_density
fix mixture all particledistribution/discrete 10039 1 grain 1.0
region cloud block 0 {SIDE} 0 {SIDE} 0 {HEIGHT} units box
{rigid_bodies()}fix insert all insert/pack seed 15485863 distributiontemplate mixture maxattempt 500 insert_every once &
    overlapcheck yes all_in no vel constant 0 0 -0.8 orientation random region cloud ntry_mc 1000 &
    particles_in_region {BODIES}
run {FALL}
"""


def clump_script(body, start):
    """Ours, from the first frame of the host's bodies."""
    np.savetxt("stone.csv", body, fmt="%.17g", header="frame: body")
    reach = (np.abs(body[:, :3]) + body[:, 3:]).max(axis=0)
    particles = [Particle(tuple(x), tuple(reach), tuple(quaternion(r)), tuple(v), tuple(w), MASS, MOMENTS)
                 for x, r, v, w in zip(start["x"][0], start["turn"][0], start["v"][0], start["spin"][0])]
    before, rest = ellipsoids_data(particles, BOX, 1).split("Atoms\n\n")
    rows, after = rest.split("\n\nVelocities")
    rows = "\n".join(f"{row} {len(body)} 1001" for row in rows.split("\n"))
    Path("start.data").write_text(f"{before}Atoms\n\n{rows}\n\nVelocities{after}")
    setup = head(pair=multisphere_setup("contacts 100").pair)
    moments = " ".join(map(repr, MOMENTS))
    return (setup.header() + "read_data start.data\n" + setup.properties() + "neigh_modify page 2000000\n"
            + f"fix grain all particletemplate/ellipsoid 15485863 mass {MASS} inertia {moments} clump stone.csv\n"
            + "fix gravity all gravity 9.81 vector 0 0 -1\n" + wall("floor", "zplane", 0.0, "contacts 100")
            + "fix motion all nve/ellipsoid\n")


def timed(script, name):
    """Processor time (s) of STEPS steps some steps after the script, by two readings of the engine's clock."""
    clock = Path(f"clock.{name}")
    clock.unlink(missing_ok=True)
    read = f"shell sh {Path(__file__).resolve().parent / 'clock.sh'} {clock}\n"
    run(f"{script}run 10\n{read}run {STEPS} pre no\n{read}", name=f"in.{name}", timeout=3600)
    before, after = map(int, clock.read_text().split())
    return 1e-9 * (after - before)


def put_together(columns, count):
    """Spheres of a body that a periodic side has taken apart, in the image nearest to its first one."""
    for name in "xy":
        of_bodies = columns[name].reshape(len(columns[name]), -1, count)
        apart = np.round((of_bodies - of_bodies[:, :, :1]) / SIDE)
        columns[name] = (of_bodies - SIDE * apart).reshape(columns[name].shape)
    return columns


def keep(case, count, bodies, host, clump):
    """Adds a row to clumps.csv, below the names of its columns if it is new."""
    is_new = not Path("clumps.csv").exists()
    with open("clumps.csv", "a", newline="") as file:
        rows = csv.writer(file, lineterminator="\n")
        if is_new:
            rows.writerow(["case", "spheres", "bodies", "fix_multisphere_ns", "clump_ns", "ratio"])
        rows.writerow([case, count, bodies, f"{host:.0f}", f"{clump:.0f}", f"{host / clump:.2f}"])


def measure(count):
    body = stone(count)
    columns = "id x y z vx vy vz omegax omegay omegaz fx fy fz tqx tqy tqz".split()
    script = host_script(body) + dump("start.dump", 1, columns) + "run 0\nundump d\n"
    times = {"host": [], "clump": []}
    for _ in range(2):
        times["host"].append(timed(script, "host"))
        start = Cloud(BODIES, "", 0.0, body).bodies(put_together(read_dump("start.dump")[1], count))
        times["clump"].append(timed(clump_script(body, start), "clump"))
    bodies = start["x"].shape[1]
    height = start["x"][0][:, 2]
    host, clump = (1e9 * min(times[k]) / (STEPS * bodies) for k in ("host", "clump"))
    keep("dense" if DENSE else "falling", count, bodies, host, clump)
    print(f"{count} spheres, {bodies} bodies: fix multisphere {host:.0f} ns, clump {clump:.0f} ns per body and "
          f"step, ratio {host / clump:.1f}; centres at {1e3 * height.min():.1f} to {1e3 * height.max():.1f} mm, speed "
          f"{np.linalg.norm(start['v'][0], axis=1).mean():.3f} m/s", flush=True)


if __name__ == "__main__":
    words = [word for word in sys.argv[1:] if word != "--dense"]
    for folder in words[:1]:
        os.makedirs(folder, exist_ok=True)
        os.chdir(folder)
    for spheres in map(int, words[1:] or (17, 55, 200)):
        measure(spheres)
