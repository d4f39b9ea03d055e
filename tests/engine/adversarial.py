"""Random small scenes against brute force: forces, torques, contact lists, heat, stress and energies, every step.

A scene draws surface, shapes (each body its own: prolate, oblate, triaxial, or its own number of spheres), materials,
temperatures, walls (sheared, or a mesh that moves), boundaries, boxes so short that a body touches several images of
another, or its own, 1 to 4 ranks, an insertion, a deletion and a restart file on the way from its seed, which is
printed. The engine dumps each step;
_brute_force.py computes the forces of that step again from positions and orientations alone: all pairs, all
images, springs of its own. Velocities at the moment of the forces follow from the last step's velocities and
forces: v + f dt / 2 m, and the same for the angular momentum.

ELLIPSOID_ADVERSARIAL_SECONDS=3600 goes on with new seeds for that time; ELLIPSOID_ADVERSARIAL_SEED=N makes one
scene again.
"""

import math
import os
import time
import unittest
from pathlib import Path

import numpy as np

from _brute_force import BruteForce, Frame, Law, Plane, sphere_chain, turn
from _engine import run

SCENES = (1, 2, 3, 4, 5, 7, 8, 9, 37, 45, 52, 55)  # the last four have bodies that touch themselves
STEPS = 150  # of each of the two parts of a scene
RELATIVE = 2e-8  # forces and torques, of the largest in the step: Newton's normals, springs over all steps
LISTED = 1e-7  # contacts: overlap over the smallest semi-axis, point, normal
TOUCHING = 1e-12  # overlaps below this share of the smallest semi-axis may be found or not
COLUMNS = ("id type mass xu yu zu vx vy vz omegax omegay omegaz quat1 quat2 quat3 quat4 shapex shapey shapez "
           "fx fy fz tqx tqy tqz").split()
CAPACITY = 1e6  # J/(kg K): temperatures hardly change in a step
CONDUCTIVITY = (5.0, 12.0)  # W/(m K), of the types
HOT_WALL = 450.0  # K
LIST = [f"c_list[{k}]" for k in range(1, 13)]


class Scene:
    """Everything that is drawn from the seed."""

    def __init__(self, seed):
        self.seed, self.random = seed, np.random.default_rng(seed)
        r = self.random
        self.multisphere = bool(r.integers(2))
        self.periodic = [bool(r.integers(2)) for _ in range(3)]
        self.ranks = int(r.integers(1, 5))
        self.time_step = float(r.choice([1.5e-6, 3e-6]))
        self.types = int(r.integers(1, 3))
        self.material = [(float(10 ** r.uniform(6.7, 7.7)), float(r.uniform(0.1, 0.4))) for _ in range(self.types)]
        self.friction, self.eta_n, self.eta_t = (self.table(*b) for b in ((0, 0.8), (0, 800), (0, 800)))
        self.direction = "velocity" if r.random() < 0.25 else "displacement"
        self.limit = bool(r.random() < 0.3)
        self.average = self.multisphere and bool(r.random() < 0.3)
        self.restarts, self.inserts, self.deletes = (bool(r.random() < p) for p in (0.5, 0.4, 0.4))
        self.wall = str(r.choice(["none", "sheared", "mesh"])) if not self.periodic[2] else "none"
        if self.wall == "mesh" and any(self.periodic):  # meshes have no images
            self.wall = "sheared"
        self.gravity = bool(r.integers(2))
        self.rebuilds = str(r.choice(["check yes", "check no"]))
        self.short, self.heats = bool(r.random() < 0.4), bool(r.integers(2))
        self.bodies()

    def table(self, low, high):
        half = self.random.uniform(low, high, (self.types, self.types))
        return 0.5 * (half + half.T)

    def bodies(self):
        r, least = self.random, 1 if self.short else 3
        counts = [int(self.random.integers(least, 4)) if p else int(self.random.integers(2, 4)) for p in self.periodic]
        rows, largest = [], 0.0
        for cell in np.ndindex(*counts):
            size = 1e-3 * 2.0 ** r.uniform(-0.5, 0.5)
            axes = size * 2.2 ** r.uniform(-0.5, 0.5, 3)
            spheres = 0
            if self.multisphere:
                aspect, spheres = float(r.choice([1.3, 1.7, 2.35])), int(r.choice([1, 3, 5, 9]))
                axes = size * np.array([aspect, 1.0, 1.0]) * aspect ** (-1.0 / 3.0)
            quaternion = r.normal(size=4)
            rows.append((np.array(cell), int(r.integers(self.types)), axes,
                         quaternion / np.linalg.norm(quaternion), spheres))
            largest = max(largest, axes.max())
        # at 1.34 no pair touches by two images where there are 3 cells
        rows[0] = (rows[0][0], 0, *rows[0][2:])  # the host wants a particle of the first type
        self.rows, self.cell = rows, (1.1 if self.short else 1.34) * largest
        self.temperatures = r.uniform(280.0, 420.0, len(rows))
        self.length = self.cell * np.array(counts)
        room = [0.0 if p else 2.5 * self.cell for p in self.periodic]
        self.low, self.high = 0.0 - np.array(room), self.length + np.array(room)
        self.floor = 0.5 * self.cell - 0.8 * largest if self.wall != "none" else None
        self.separate()

    def separate(self):
        """Widens the cells until no overlap is deeper than 4 % of the smaller semi-axis."""
        jitter = self.random.uniform(-0.1, 0.1, (len(self.rows), 3))
        self.velocity = self.random.uniform(-1.0, 1.0, (len(self.rows), 3)) * 2.0
        self.omega = self.random.uniform(-1.0, 1.0, (len(self.rows), 3)) * 300.0
        for _ in range(200):
            self.x = (np.array([row[0] for row in self.rows]) + 0.5 + jitter) * self.cell
            frame = self.first_frame()
            brute = self.brute_force()
            deepest = max((c[3] / min(frame.axes[c[0]].min(), frame.axes[c[1]].min())
                           for c in brute.contacts(frame).values()), default=0.0)
            deepest = max(deepest, max((c[2] / frame.axes[c[0]].min()
                                        for c in brute.wall_contacts(frame, 0.0).values()), default=0.0))
            if deepest < 0.04:
                return
            grown = 1.02
            self.cell *= grown
            self.length = self.length * grown
            self.low, self.high = self.low * grown, self.high * grown
            if self.floor is not None:
                self.floor -= 0.01 * self.cell

    def first_frame(self):
        axes = np.array([row[2] for row in self.rows])
        mass = 2500.0 * 4.0 / 3.0 * math.pi * axes.prod(1)
        square = axes ** 2
        return Frame(np.arange(1, len(axes) + 1), np.array([row[1] for row in self.rows]), mass,
                     0.2 * mass[:, None] * (square.sum(1)[:, None] - square), axes, self.x, self.velocity,
                     self.omega, np.array([row[3] for row in self.rows]), np.array([row[4] for row in self.rows]))

    def brute_force(self):
        law = Law(self.material, self.friction, self.eta_n, self.eta_t, self.time_step, self.direction, self.limit)
        periods = np.where(self.periodic, self.length, np.inf)
        walls = []
        if self.wall == "sheared":
            walls = [Plane((0, 0, -1), lambda t: (0, 0, self.floor), (0.7, 0, 0))]
        elif self.wall == "mesh":
            walls = [Plane((0, 0, -1), lambda t: (0, 0, self.floor + 0.4 * t), (0, 0, 0.4))]
        return BruteForce(law, periods, walls, self.average)

    # --- the engine's side -----------------------------------------------------------------------

    def data(self):
        frame, rows, speeds = self.first_frame(), [], []
        for k, i in enumerate(frame.ids):
            tail = [int(frame.chains[k]), 0] if self.multisphere else []
            values = [*frame.x[k], *frame.axes[k], *frame.quaternion[k], frame.mass[k], *frame.moments[k]]
            rows.append(f"{i} {frame.types[k] + 1} " + " ".join(repr(float(v)) for v in values)
                        + "".join(f" {t}" for t in tail))
            speeds.append(f"{i} " + " ".join(repr(float(v)) for v in (*frame.v[k], *frame.omega[k])))
        box = "\n".join(f"{float(self.low[k])!r} {float(self.high[k])!r} {n}lo {n}hi" for k, n in enumerate("xyz"))
        return (f"scene\n\n{len(rows)} atoms\n{self.types} atom types\n\n{box}\n\nAtoms\n\n" + "\n".join(rows)
                + "\n\nVelocities\n\n" + "\n".join(speeds) + "\n")

    def pair_table(self, table):
        return f"peratomtypepair {self.types} " + " ".join(repr(float(v)) for v in table.ravel())

    def head(self, start):
        law = "model hertz/viscous tangential history/viscous"
        surface = "surface " + ("multisphere" if self.multisphere else "smooth")
        hot = f" temperature {HOT_WALL}" if self.heats else ""
        settings = (f"direction {self.direction} limitForce {'on' if self.limit else 'off'} contacts 40"
                    + (" multicontact average" if self.average else ""))
        pair = settings if self.multisphere else settings.replace(" contacts 40", "")
        spheres = ("fix subspheres all property/atom subspheres scalar yes yes no 0\n"
                   "fix spacing all property/atom spacing scalar yes yes no 0\n") if (
                       self.multisphere and "restart" in start) else ""
        wall = f"fix floor all wall/gran/ellipsoid {law} {surface}"
        walls = {"none": "", "sheared": f"{wall} primitive type 1 zplane {self.floor!r} shear x 0.7{hot} "
                              f"{settings}\n",
                 "mesh": f"fix cad all mesh/surface file floor.stl type 1{hot}\n"
                         f"{wall} mesh n_meshes 1 meshes cad {settings}\n"
                         f"fix lift all move/mesh mesh cad linear 0. 0. 0.4\n"}[self.wall]
        moduli = " ".join(repr(m[0]) for m in self.material)
        ratios = " ".join(repr(m[1]) for m in self.material)
        insertion = ""
        if self.inserts:
            shape = "1.1e-3 6e-4 6e-4 subspheres 5" if self.multisphere else "1.1e-3 8e-4 6e-4"
            corners = " ".join(f"{v!r}" for pair in zip(self.low * 0.9, self.high * 0.9)
                               for v in sorted(map(float, pair)))
            insertion = (f"fix grain all particletemplate/ellipsoid 15485863 density 2500 semiaxes {shape}\n"
                         f"fix drop all insert/drop seed {self.seed + 1} template grain particles 5 "
                         f"interval {self.time_step * 37!r} box {corners} velocity 0.3 -0.5 0.2\n")
        heat = ("fix k all property/global thermalConductivity peratomtype "
                + " ".join(repr(k) for k in CONDUCTIVITY[:self.types])
                + f"\nfix c all property/global thermalCapacity peratomtype {f'{CAPACITY} ' * self.types}\n"
                "fix heat all heat/gran/conduction initial_temperature 300 contact_area overlap\n"
                + ("run 0\n" + "".join(f"set atom {k + 1} property/atom Temp {t!r}\n"
                                       for k, t in enumerate(map(float, self.temperatures)))
                   if "restart" not in start else "")) if self.heats else ""
        return f"""
atom_style granular/ellipsoid
atom_modify map array
boundary {' '.join('p' if p else 'f' for p in self.periodic)}
newton off
communicate single vel yes
units si
{start}
neighbor 2e-4 bin
neigh_modify delay 0 every 1 {self.rebuilds} page 2000000
fix m1 all property/global youngsModulus peratomtype {moduli}
fix m2 all property/global poissonsRatio peratomtype {ratios}
fix m3 all property/global coefficientFriction {self.pair_table(self.friction)}
fix m4 all property/global viscousDampingNormal {self.pair_table(self.eta_n)}
fix m5 all property/global viscousDampingTangential {self.pair_table(self.eta_t)}
pair_style gran/ellipsoid {law} {surface} {pair}
pair_coeff * *
timestep {self.time_step!r}
{spheres}{walls}{'fix down all gravity 9.81 vector 0.2 0 -1' if self.gravity else ''}
{insertion}fix motion all nve/ellipsoid
{heat}compute list all pair/ellipsoid/local id contactPoint normal delta force
compute turning all erotate/ellipsoid
compute stress all pressure thermo_temp virial
thermo_style custom step ke c_turning c_stress[1] c_stress[2] c_stress[3] c_stress[4] c_stress[5] c_stress[6] vol
thermo_modify norm no lost ignore format float %.15e
thermo 1
"""

    def output(self, part):
        form = " ".join("%d" if c in ("id", "type") else "%.17g" for c in COLUMNS)
        extra = (" f_Temp f_heatFlux" if self.heats else "") + (" f_subspheres" if self.multisphere else "")
        return (f"dump d all custom 1 part{part}.dump {' '.join(COLUMNS)}{extra}\n"
                f'dump_modify d sort id format "{form}{" %.17g" * len(extra.split())}"\n'
                f"dump l all local 1 part{part}.local {' '.join(LIST)}\n"
                f'dump_modify l format "{" ".join(["%.0f"] * 2 + ["%.17g"] * 10)}"\n')

    def run(self):
        Path("scene.data").write_text(self.data())
        if self.wall == "mesh":
            self.write_mesh()
        delete = "group gone id 2 5\ndelete_atoms group gone compress no\n" if self.deletes else ""
        close = "undump d\nundump l\n"
        first = self.head("read_data scene.data") + self.output(1) + f"run {STEPS}\n" + close
        if self.restarts:
            run(first + delete + "write_restart half.restart\n", self.ranks, name="in.first")
            run(self.head("read_restart half.restart") + self.output(2) + f"run {STEPS}\n", self.ranks,
                name="in.second")
        else:
            run(first + delete + self.output(2) + f"run {STEPS}\n", self.ranks, name="in.first")

    def write_mesh(self):
        (x, y), (u, v) = self.low[:2] * 0.99, self.high[:2] * 0.99
        corners = [(x, y), (u, y), (u, v), (x, v)]
        lines = ["solid floor"]
        for k in ((0, 1, 2), (0, 2, 3)):
            lines += ["facet normal 0 0 1", "outer loop"]
            lines += [f"vertex {corners[c][0]!r} {corners[c][1]!r} {self.floor!r}" for c in k]
            lines += ["endloop", "endfacet"]
        Path("floor.stl").write_text("\n".join(lines + ["endsolid floor", ""]).replace("np.float64(", "")
                                     .replace(")", ""))


def dump_frames(file, columns):
    """[(step, array (N, columns))] of a text dump."""
    lines, at, found = Path(file).read_text().splitlines(), 0, []
    while at < len(lines):
        step, count = int(lines[at + 1]), int(lines[at + 3])
        rows = [line.split() for line in lines[at + 9:at + 9 + count]]
        found.append((step, np.array(rows, float).reshape(count, columns)))
        at += 9 + count
    return found


def thermo_rows(*logs):
    """{step: numbers} of the thermo tables; the last one of a step counts."""
    found = {}
    for log in logs:
        for line in Path(log).read_text().splitlines():
            words = line.split()
            if len(words) == 10 and words[0].isdigit():
                found.setdefault(int(words[0]), []).append([float(w) for w in words])
    return found


def frame_of(values, multisphere):
    axes, mass = values[:, 16:19], values[:, 2]
    square = axes ** 2
    chains = values[:, -1].astype(int) if multisphere else np.zeros(len(values), int)
    return Frame(values[:, 0].astype(int), values[:, 1].astype(int) - 1, mass,
                 0.2 * mass[:, None] * (square.sum(1)[:, None] - square), axes, values[:, 3:6], values[:, 6:9],
                 values[:, 9:12], values[:, 12:16], chains)


class Comparison:
    """One scene, step by step."""

    def __init__(self, scene):
        self.scene, self.brute = scene, scene.brute_force()
        self.complaints, self.contacts, self.compared = [], 0, 0

    def complain(self, step, text):
        if len(self.complaints) < 6:
            self.complaints.append(f"seed {self.scene.seed}, step {step}: {text}")

    def run(self):
        scene = self.scene
        columns = len(COLUMNS) + scene.multisphere + 2 * scene.heats
        logs = ["log.in.first"] + (["log.in.second"] if scene.restarts else [])
        tables = thermo_rows(*logs)
        for part in (1, 2):
            frames = dump_frames(f"part{part}.dump", columns)
            lists = dict(dump_frames(f"part{part}.local", len(LIST)))
            before = None
            for k, (step, values) in enumerate(frames):
                before = self.step(step, values, lists[step], before, is_start=k == 0)
                row = tables[step][-1 if part == 2 else 0]
                self.energies(step, before[0], row)
        return self.complaints

    def step(self, step, values, listed, before, is_start):
        scene, brute = self.scene, self.brute
        frame = frame_of(values, scene.multisphere)
        present = set(frame.ids)
        brute.springs = {key: s for key, s in brute.springs.items()
                         if key[0] in present and (len(key) == 3 or key[1] in present)}
        half, v, omega = 0.5 * scene.time_step, frame.v, frame.omega
        if not is_start:
            old, force, torque = before
            place = {i: k for k, i in enumerate(old.ids)}
            known = np.array([place.get(i, -1) for i in frame.ids])
            spin = old.spin() + half * torque
            is_known = known[:, None] >= 0  # a body that came in this step has had half of its first kick
            v = np.where(is_known, old.v[known] + half * force[known] / old.mass[known][:, None],
                         frame.v - half * values[:, 19:22] / frame.mass[:, None])
            omega = np.where(is_known, frame.omega_of(spin[known]),
                             frame.omega_of(frame.spin() - half * values[:, 22:25]))
        f, t, rows, virial = brute.step(frame, step * scene.time_step, v, omega, advance=not is_start,
                                        wall_moves=not (is_start and scene.wall == "mesh"))
        if scene.gravity:
            down = 9.81 * np.array([0.2, 0.0, -1.0]) / math.sqrt(1.04)
            f = f + frame.mass[:, None] * down
        if scene.heats and not is_start:  # at set-up the host makes no fluxes
            self.compare_heat(step, frame, values[:, 25], values[:, 26], step * scene.time_step)
        self.contacts += len(rows)
        push = max((np.linalg.norm(row[3]) for row in rows.values()), default=0.0)
        self.compare(step, frame, values, f, t, push)
        self.compare_list(step, frame, listed, rows)
        self.virial = virial
        return frame, values[:, 19:22], values[:, 22:25]

    def compare(self, step, frame, values, force, torque, push):
        """`push`: largest force of a contact; those of a body with its own image cancel."""
        for name, found, expected, least in (("force", values[:, 19:22], force, push),
                                             ("torque", values[:, 22:25], torque, push * frame.axes.min())):
            scale = max(np.abs(expected).max(), least)
            error = np.abs(found - expected).max()
            if not error <= RELATIVE * scale:
                worst = int(np.abs(found - expected).max(1).argmax())
                self.complain(step, f"{name} on {frame.ids[worst]} is {found[worst]}, expected {expected[worst]}")
        self.compared += 1

    def compare_heat(self, step, frame, temperature, found, time):
        """4 k1 k2 / (k1 + k2) sqrt(2 pi R h) of each contact, its share where they are averaged."""
        flux = np.zeros(len(frame.ids))

        def conductance(first, second, area):
            k, m = CONDUCTIVITY[first], CONDUCTIVITY[second]
            return 4.0 * k * m / (k + m) * math.sqrt(area)

        for i, j, _, h, _, _, radius, weight in self.brute.contacts(frame).values():
            q = weight * conductance(frame.types[i], frame.types[j], 2.0 * math.pi * radius * h)
            flux[i] += q * (temperature[j] - temperature[i])
            flux[j] -= q * (temperature[j] - temperature[i])
        for k, wall, h, _, radius, weight in self.brute.wall_contacts(frame, time).values():
            q = weight * conductance(frame.types[k], wall.type, math.pi * h * (2.0 * radius - h))
            flux[k] += q * (HOT_WALL - temperature[k])
        error = np.abs(found - flux)
        if not error.max() <= 1e-6 * max(np.abs(flux).max(), 1e-300):
            worst = int(error.argmax())
            self.complain(step, f"heat into {frame.ids[worst]} is {found[worst]}, expected {flux[worst]}")

    def compare_list(self, step, frame, listed, rows):
        smallest = frame.axes.min()
        expected = {}
        for (i, j, *_), row in rows.items():
            if row[0] > TOUCHING * smallest:
                expected.setdefault((i, j), []).append(row)
        found = {}
        for row in listed:
            if row[8] > TOUCHING * smallest:
                found.setdefault((int(row[0]), int(row[1])), []).append(row)
        if {k: len(v) for k, v in expected.items()} != {k: len(v) for k, v in found.items()}:
            self.complain(step, f"listed are {sorted((k, len(v)) for k, v in found.items())}, touching are "
                                f"{sorted((k, len(v)) for k, v in expected.items())}")
            return
        largest = max((np.linalg.norm(r[3]) for v in expected.values() for r in v), default=0.0)
        for pair, wanted in expected.items():
            left = list(found[pair])
            for h, n, point, f in wanted:
                k = min(range(len(left)), key=lambda m: abs(left[m][8] - h) + np.abs(left[m][5:8] - n).max())
                row = left.pop(k)
                off = row[2:5] - point  # the point may be that of another image
                finite = np.isfinite(self.brute.periods)
                period = np.where(finite, self.brute.periods, 1.0)
                off = off - np.where(finite, np.round(off / period) * period, 0.0)
                sign = 1.0 if pair[0] < pair[1] or row[5:8] @ n > 0 else -1.0
                errors = (np.abs(off).max() / smallest, np.abs(sign * row[5:8] - n).max(),
                          abs(row[8] - h) / smallest, np.abs(sign * row[9:12] - f).max() / max(largest, 1e-300))
                if not max(errors) <= LISTED:
                    self.complain(step, f"contact of {pair}: point, normal, overlap, force are off by {errors}")

    def energies(self, step, frame, row):
        expected = [frame.kinetic_energy(), frame.rotational_energy()]
        for name, value, found in zip(("translation", "rotation"), expected, row[1:3]):
            if not abs(value - found) <= 1e-10 * abs(value):
                self.complain(step, f"energy of {name} is {found}, expected {value}")
        w, volume = self.virial, row[9]
        wanted = np.array([w[0, 0], w[1, 1], w[2, 2], w[0, 1], w[0, 2], w[1, 2]]) / volume
        if not np.abs(np.array(row[3:9]) - wanted).max() <= 1e-7 * max(np.abs(wanted).max(), 1e-300):
            self.complain(step, f"stress is {row[3:9]}, expected {wanted}")


class Adversarial(unittest.TestCase):
    def scenes(self, seeds, until=math.inf):
        wrong, contacts = [], 0
        for seed in seeds:
            if time.monotonic() > until:
                break
            folder = Path(f"seed{seed}")
            folder.mkdir(exist_ok=True)
            here = os.getcwd()
            os.chdir(folder)
            try:
                scene = Scene(seed)
                scene.run()
                comparison = Comparison(scene)
                found = comparison.run()
            finally:
                os.chdir(here)
            contacts += comparison.contacts
            kind = "multisphere" if scene.multisphere else "smooth"
            print(f"seed {seed}: {kind}, {len(scene.rows)} bodies, {scene.ranks} ranks, wall {scene.wall}, periodic "
                  f"{scene.periodic}, {comparison.compared} steps, {comparison.contacts} contacts, "
                  f"{'wrong' if found else 'right'}", flush=True)
            wrong += found
        self.assertFalse(wrong, "\n".join(wrong))
        return contacts

    def test_scenes(self):
        if "ELLIPSOID_ADVERSARIAL_SEED" in os.environ:
            self.scenes([int(os.environ["ELLIPSOID_ADVERSARIAL_SEED"])])
        elif "ELLIPSOID_ADVERSARIAL_SECONDS" in os.environ:
            seconds = float(os.environ["ELLIPSOID_ADVERSARIAL_SECONDS"])
            self.scenes(range(100000, 10 ** 9), time.monotonic() + seconds)
        else:
            contacts = self.scenes(SCENES)
            self.assertGreater(contacts, 3000)


if __name__ == "__main__":
    unittest.main(verbosity=2)
