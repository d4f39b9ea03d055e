"""Energy drift and cost of both integrators of fix nve/ellipsoid, with the paper's particles and material.

    python3 tests/bench/integrators.py [LIGGGHTS]     (default: build/bin/liggghts)

Prints a table. Not a test: it takes minutes and has nothing to fail. 64 bodies (2.7, 1.15, 1.15 mm) fly at
0.3 m/s and 60 rad/s in a periodic box, without friction and damping: their energy at moments without
contact should stay. The same bodies, with the paper's damping and friction, in a dense box, for the cost.
"""

import os
import resource
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
os.environ.setdefault("ELLIPSOID_BIN", str(Path(sys.argv[1]).parent if len(sys.argv) > 1
                                           else ROOT / "build/bin"))
sys.path.insert(0, str(ROOT / "tests/engine"))

import numpy as np  # noqa: E402
from _engine import Particle, Setup, quaternion_of, run, thermo  # noqa: E402

AXES, MASS, MOMENTS = (2.7e-3, 1.15e-3, 1.15e-3), 2e-5, (1.058e-11, 3.445e-11, 3.445e-11)
TIME = 0.1  # s


def box(spacing, seed, **setup):
    random = np.random.default_rng(seed)
    places = np.array(list(np.ndindex(4, 4, 4))) * np.array(spacing)
    particles = [Particle(tuple(p), AXES, quaternion_of(random.normal(size=3), random.uniform(0, 6))
                          if min(spacing) > 5e-3 else (1.0, 0.0, 0.0, 0.0),
                          tuple(random.normal(0.0, 0.3 / 3 ** 0.5, 3)),
                          tuple(random.normal(0.0, 60.0 / 3 ** 0.5, 3)), mass=MASS, moments=MOMENTS)
                 for p in places]
    sides = [bound for s in spacing for bound in (0.0, 4.0 * s)]
    return Setup(box=tuple(sides), boundary="p p p", skin=5e-4, **setup), particles


def energies(integrator, time_step, seed):
    """Largest relative change of the energy at moments without contact, and the number of steps."""
    setup, particles = box((6e-3,) * 3, seed, time_step=time_step, friction=0.0, damping_normal=0.0,
                           damping_tangential=0.0)
    steps = round(TIME / time_step)
    script = setup.with_particles(particles) + f"""
fix motion all nve/ellipsoid integrator {integrator}
compute search all contacts/ellipsoid
compute turning all erotate/ellipsoid
thermo_style custom step ke c_turning c_search[1]
thermo {max(1, steps // 4000)}
thermo_modify norm no lost error format float %.16g
run {steps}
"""
    run(script, timeout=3000)
    rows = thermo("log.in.run")
    free = rows[rows[:, 3] == 0.0]
    change = (free[:, 1] + free[:, 2]) / (free[0, 1] + free[0, 2]) - 1.0
    return change[-1]


def cost(integrator):
    """Processor time of a dense box with friction and damping, ns per particle and step, the best of three
    runs."""
    setup, particles = box((5.5e-3, 2.25e-3, 2.25e-3), 3, time_step=2e-6, damping_normal=20000.0,
                           damping_tangential=20000.0)
    script = setup.with_particles(particles) + f"fix motion all nve/ellipsoid integrator {integrator}\n"
    seconds = []
    for _ in range(3):
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        run(script + "run 10000\n")
        seconds.append(resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before)
    return min(seconds) / 10000 / len(particles) * 1e9


def main():
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        print("time step   integrator   change of the energy in 0.1 s, 3 seeds")
        for time_step in 2e-6, 5e-6, 1e-5:
            for integrator in "verlet", "gear":
                changes = [energies(integrator, time_step, seed) for seed in (1, 2, 3)]
                print(f"{time_step:.0e} s     {integrator:12s} " + "  ".join(f"{c:+.1e}" for c in changes),
                      flush=True)
        for integrator in "verlet", "gear":
            print(f"cost of {integrator}: {cost(integrator):.0f} ns per particle and step")


if __name__ == "__main__":
    main()
