"""A random small scene: everything about it is drawn from its seed; the engine's input, and the same by brute force."""

import math
from pathlib import Path

import numpy as np

from _brute_force import BruteForce, Cohesion, Frame, HostLaw, Law, Plane, Rolling
from _engine import run

STEPS = 150  # of each of the two parts of a scene
COLUMNS = ("id type mass xu yu zu vx vy vz omegax omegay omegaz quat1 quat2 quat3 quat4 shapex shapey shapez "
           "fx fy fz tqx tqy tqz").split()
CAPACITY = 1e6  # J/(kg K): temperatures hardly change in a step
CONDUCTIVITY = (5.0, 12.0)  # W/(m K), of the types
HOT_WALL = 450.0  # K
LIST = [f"c_list[{k}]" for k in range(1, 13)]
DENSITY = 2500.0
LIFT, TURN = 0.4, 20.0  # m/s, rad/s: of meshes
PRIMES = (15485863, 32452867, 49979687)


def ellipsoid_moments(mass, axes):
    square = axes ** 2
    return 0.2 * mass[:, None] * (square.sum(1)[:, None] - square)


class Clump:
    """Spheres in the body's frame, with a mass and moments of their own."""

    def __init__(self, random):
        radii = [1e-3 * random.uniform(0.5, 0.8)]
        centres = [np.zeros(3)]
        for _ in range(int(random.integers(2, 6))):
            k, r = int(random.integers(len(radii))), 1e-3 * random.uniform(0.3, 0.6)
            way = random.normal(size=3)
            centres.append(centres[k] + 0.75 * (radii[k] + r) * way / np.linalg.norm(way))
            radii.append(r)
        self.centres, self.radii = np.array(centres), np.array(radii)
        masses = DENSITY * 4.0 / 3.0 * math.pi * self.radii ** 3
        self.centres -= masses @ self.centres / masses.sum()
        self.mass = masses.sum()
        square = self.centres ** 2
        self.moments = (masses[:, None] * (square.sum(1)[:, None] - square)).sum(0) + 0.4 * masses @ self.radii ** 2
        self.axes = (np.abs(self.centres) + self.radii[:, None]).max(0)

    def write(self, file):
        np.savetxt(file, np.column_stack([self.centres, self.radii]), fmt="%.17g", header="frame: body")

    def template(self, number):
        moments = " ".join(repr(float(m)) for m in self.moments)
        return (f"fix clump{number} all particletemplate/ellipsoid {PRIMES[number]} clump clump{number}.csv "
                f"mass {float(self.mass)!r} inertia {moments}\n")


class Scene:
    """Everything that is drawn from the seed."""

    def __init__(self, seed):
        self.seed, self.random = seed, np.random.default_rng(seed)
        r = self.random
        self.multisphere = bool(r.integers(2))
        self.periodic = [bool(r.integers(2)) for _ in range(3)]
        self.ranks = int(r.integers(1, 5))
        self.time_steps = [float(r.choice([1.5e-6, 3e-6]))] * 2
        if r.random() < 0.4:
            self.time_steps[1] = float(r.choice([1e-6, 2e-6]))
        self.draw_law()
        self.average = self.multisphere and bool(r.random() < 0.3)
        self.restarts, self.inserts, self.deletes, self.compresses = (
            bool(r.random() < p) for p in (0.5, 0.4, 0.4, 0.5))
        self.wall = str(r.choice(["none", "sheared", "mesh", "turning"])) if not self.periodic[2] else "none"
        if self.wall in ("mesh", "turning") and any(self.periodic):  # meshes have no images
            self.wall = "sheared"
        self.gravity = bool(r.integers(2))
        self.rebuilds = str(r.choice(["check yes", "check no"]))
        self.short, self.heats = bool(r.random() < 0.4), bool(r.integers(2))
        self.clumps = [Clump(r) for _ in range(2)] if self.multisphere and r.random() < 0.5 else []
        # the host tilts along y and z only where these are periodic
        self.is_tilted = (self.periodic[1] or self.periodic[2]) and bool(r.random() < 0.35)
        self.skew = np.array([r.uniform(-0.35, 0.35) if self.is_tilted and self.periodic[k] else 0.0
                              for k in (1, 2, 2)])  # xy, xz, yz as shares of the first of each two lengths
        self.bodies()

    def draw_law(self):
        r = self.random
        self.types = int(r.integers(1, 3))
        self.material = [(float(10 ** r.uniform(6.7, 7.7)), float(r.uniform(0.1, 0.4))) for _ in range(self.types)]
        self.friction, self.eta_n, self.eta_t = (self.table(*b) for b in ((0, 0.8), (0, 800), (0, 800)))
        self.restitution, self.rolls, self.density = (self.table(*b) for b in ((0.3, 0.9), (0, 0.4), (0, 1e5)))
        self.direction = "velocity" if r.random() < 0.25 else "displacement"
        self.limit = bool(r.random() < 0.3)
        self.host_law, self.coheres = bool(r.random() < 0.3), bool(r.random() < 0.25)
        self.rolling = str(r.choice(["", "", "cdt", "epsd2"]))

    def table(self, low, high):
        half = self.random.uniform(low, high, (self.types, self.types))
        return 0.5 * (half + half.T)

    def bodies(self):
        r, least = self.random, 1 if self.short else 3
        counts = [int(self.random.integers(least, 4)) if p else int(self.random.integers(2, 4)) for p in self.periodic]
        rows, largest = [], 0.0
        for cell in np.ndindex(*counts):
            axes, spheres, clump = self.shape()
            quaternion = r.normal(size=4)
            rows.append((np.array(cell), int(r.integers(self.types)), axes,
                         quaternion / np.linalg.norm(quaternion), spheres, clump))
            largest = max(largest, axes.max())
        rows[0] = (rows[0][0], 0, *rows[0][2:])  # the host wants a particle of the first type
        self.rows, self.counts = rows, np.array(counts)
        self.size = 0.65 * largest  # of a cell, before separate()
        self.temperatures = r.uniform(280.0, 420.0, len(rows))
        self.separate()

    def shape(self):
        """Semi-axes, number of spheres, number of the clump or 0."""
        r = self.random
        size = 1e-3 * 2.0 ** r.uniform(-0.5, 0.5)
        if self.clumps and r.random() < 0.6:
            number = int(r.integers(len(self.clumps)))
            clump, scale = self.clumps[number], 2.0 ** r.uniform(-0.3, 0.3)
            return scale * clump.axes, len(clump.radii), number + 1
        if self.multisphere:
            aspect, spheres = float(r.choice([1.3, 1.7, 2.35])), int(r.choice([1, 3, 5, 9]))
            return size * np.array([aspect, 1.0, 1.0]) * aspect ** (-1.0 / 3.0), spheres, 0
        return size * 2.2 ** r.uniform(-0.5, 0.5, 3), 0, 0

    def separate(self):
        """Widens the cells until no overlap is deeper than 4 % of the smaller semi-axis; then bodies shrink in narrower
        cells, so that many touch; a wall touches the lowest one."""
        jitter = self.random.uniform(-0.1, 0.1, (len(self.rows), 3))
        self.velocity = self.random.uniform(-1.0, 1.0, (len(self.rows), 3)) * 2.0
        self.omega = self.random.uniform(-1.0, 1.0, (len(self.rows), 3)) * 300.0
        shares = (np.array([row[0] for row in self.rows]) + 0.5 + jitter) / self.counts
        self.floor = None
        while self.place(shares) > 0.04:
            self.size *= 1.03
        self.size *= 0.7
        while self.place(shares) > 0.04:
            frame = self.first_frame()
            for k in {max(c[:2], key=lambda k: frame.axes[k].max()) for c in self.deep(frame)}:
                self.rows[k] = (*self.rows[k][:2], 0.98 * self.rows[k][2], *self.rows[k][3:])
        if self.wall != "none":
            self.floor = self.lowest(self.first_frame(), self.brute_force())

    def place(self, shares):
        """Puts the bodies, at `shares` of the box's edges, into a box of cells of the present size; returns the deepest
        overlap over the smaller semi-axis."""
        self.length = self.size * self.counts
        room = np.where(self.periodic, 0.0, 2.5 * self.size)
        self.low, self.high = -room, self.length + room
        self.tilt = self.skew * self.length[[0, 0, 1]]
        xy, xz, yz = self.tilt
        self.x = shares @ (np.diag(self.length) + [[0, 0, 0], [xy, 0, 0], [xz, yz, 0]])
        return max((c[2] for c in self.deep(self.first_frame(), 0.0)), default=0.0)

    def deep(self, frame, limit=0.04):
        """[(body, body, overlap over the smaller semi-axis)] of contacts beyond the limit."""
        found = [(c[0], c[1], c[3] / min(frame.axes[c[0]].min(), frame.axes[c[1]].min()))
                 for c in self.brute_force().contacts(frame).values()]
        return [c for c in found if c[2] > limit]

    @staticmethod
    def lowest(frame, brute):
        """Height of a floor into which the lowest body reaches by 2 % of its smallest semi-axis."""
        heights = []
        for k, axes in enumerate(frame.axes):
            if frame.chains[k]:
                centres, radii = brute.spheres(frame, k)
                below = (radii - centres[:, 2]).max()
            else:
                below = np.linalg.norm(axes * frame.turn[k][2])
            heights.append(frame.x[k, 2] - below + 0.02 * axes.min())
        return float(min(heights))

    def first_frame(self):
        axes, clumps = np.array([row[2] for row in self.rows]), np.array([row[5] for row in self.rows])
        mass, moments = self.masses(axes, clumps)
        return Frame(np.arange(1, len(axes) + 1), np.array([row[1] for row in self.rows]), mass, moments, axes, self.x,
                     self.velocity, self.omega, np.array([row[3] for row in self.rows]),
                     np.array([row[4] for row in self.rows]), clumps)

    def masses(self, axes, clumps):
        """Masses (N,) and principal moments (N, 3)."""
        mass = DENSITY * 4.0 / 3.0 * math.pi * axes.prod(1)
        moments = ellipsoid_moments(mass, axes)
        for k, number in enumerate(clumps):
            if number:
                clump = self.clumps[number - 1]
                scale = axes[k, 1] / clump.axes[1]
                mass[k], moments[k] = clump.mass * scale ** 3, clump.moments * scale ** 5
        return mass, moments

    def frame(self, values):
        """Of a row of the dump, columns as in COLUMNS and output()."""
        mass, axes = values[:, 2], values[:, 16:19]
        chains, clumps = np.zeros((2, len(values)), int)
        if self.multisphere:
            chains, clumps = values[:, -2].astype(int), np.maximum(values[:, -1].astype(int) - 1000, 0)
        moments = self.masses(axes, clumps)[1]
        return Frame(values[:, 0].astype(int), values[:, 1].astype(int) - 1, mass, moments, axes, values[:, 3:6],
                     values[:, 6:9], values[:, 9:12], values[:, 12:16], chains, clumps)

    def time(self, step):
        return self.time_steps[0] * min(step, STEPS) + self.time_steps[1] * max(0, step - STEPS)

    def brute_force(self):
        if self.host_law:
            law = HostLaw(self.material, self.friction, self.restitution, self.time_steps[0], self.limit)
        else:
            law = Law(self.material, self.friction, self.eta_n, self.eta_t, self.time_steps[0], self.direction,
                      self.limit)
        return BruteForce(law, np.where(self.periodic, self.length, np.inf), self.walls(), self.average, self.tilt,
                          Rolling(self.rolling, self.rolls) if self.rolling else None,
                          Cohesion(self.density) if self.coheres else None,
                          {k + 1: (c.centres, c.radii) for k, c in enumerate(self.clumps)})

    def walls(self):
        if self.floor is None:  # while the bodies are put apart
            return []
        if self.wall == "sheared":
            return [Plane((0, 0, -1), lambda t: (0, 0, self.floor), (0.7, 0, 0))]
        if self.wall == "mesh":
            return [Plane((0, 0, -1), lambda t: (0, 0, self.floor + LIFT * t), (0, 0, LIFT))]
        if self.wall == "turning":
            hinge = self.hinge()
            return [Plane(lambda t: (-math.sin(TURN * t), 0.0, -math.cos(TURN * t)), lambda t: hinge,
                          lambda point, t: np.cross((0, TURN, 0), point - hinge))]
        return []

    def hinge(self):
        """A point of the axis of the mesh that turns about y."""
        return np.array([0.5 * self.length[0], 0.0, self.floor])

    # --- the engine's side -----------------------------------------------------------------------

    def data(self):
        frame, rows, speeds = self.first_frame(), [], []
        for k, i in enumerate(frame.ids):
            spacing = 1000 + frame.clumps[k] if frame.clumps[k] else 0
            tail = [int(frame.chains[k]), spacing] if self.multisphere else []
            values = [*frame.x[k], *frame.axes[k], *frame.quaternion[k], frame.mass[k], *frame.moments[k]]
            rows.append(f"{i} {frame.types[k] + 1} " + " ".join(repr(float(v)) for v in values)
                        + "".join(f" {t}" for t in tail))
            speeds.append(f"{i} " + " ".join(repr(float(v)) for v in (*frame.v[k], *frame.omega[k])))
        box = "\n".join(f"{float(self.low[k])!r} {float(self.high[k])!r} {n}lo {n}hi" for k, n in enumerate("xyz"))
        tilt = " ".join(repr(float(t)) for t in self.tilt) + " xy xz yz\n" if self.is_tilted else ""
        return (f"scene\n\n{len(rows)} atoms\n{self.types} atom types\n\n{box}\n{tilt}\nAtoms\n\n" + "\n".join(rows)
                + "\n\nVelocities\n\n" + "\n".join(speeds) + "\n")

    def properties(self):
        def table(name, values):
            return (f"fix {name} all property/global {name} peratomtypepair {self.types} "
                    + " ".join(repr(float(v)) for v in values.ravel()) + "\n")

        moduli, ratios = (" ".join(repr(m[k]) for m in self.material) for k in (0, 1))
        return (f"fix m1 all property/global youngsModulus peratomtype {moduli}\n"
                f"fix m2 all property/global poissonsRatio peratomtype {ratios}\n"
                + table("coefficientFriction", self.friction) + table("viscousDampingNormal", self.eta_n)
                + table("viscousDampingTangential", self.eta_t) + table("coefficientRestitution", self.restitution)
                + table("coefficientRollingFriction", self.rolls) + table("cohesionEnergyDensity", self.density))

    def law(self):
        return (("model hertz tangential history" if self.host_law else
                 "model hertz/viscous tangential history/viscous") + (" cohesion sjkr" if self.coheres else "")
                + (f" rolling_friction {self.rolling}" if self.rolling else "")
                + " surface " + ("multisphere" if self.multisphere else "smooth"))

    def settings(self, at_wall):
        direction = "" if self.host_law else f" direction {self.direction}"
        return (f"limitForce {'on' if self.limit else 'off'}{direction}"
                + (" tangential_damping on" if self.host_law else "")
                + (" contacts 40" if self.multisphere or at_wall and self.wall in ("mesh", "turning") else "")
                + (" multicontact average" if self.average else ""))

    def wall_commands(self):
        hot = f" temperature {HOT_WALL}" if self.heats else ""
        wall = f"fix floor all wall/gran/ellipsoid {self.law()}"
        if self.wall == "none":
            return ""
        if self.wall == "sheared":
            tilted = " allow_special_domain_periodic yes" if self.is_tilted else ""
            return f"{wall} primitive type 1 zplane {self.floor!r} shear x 0.7{hot}{tilted} {self.settings(True)}\n"
        x, y, z = map(float, self.hinge())
        move = {"mesh": f"linear 0. 0. {LIFT}",
                "turning": f"rotate origin {x!r} {y!r} {z!r} axis 0. 1. 0. period {2.0 * math.pi / TURN!r}"}[self.wall]
        return (f"fix cad all mesh/surface file floor.stl type 1{hot}\n"
                f"{wall} mesh n_meshes 1 meshes cad {self.settings(True)}\n"
                f"fix lift all move/mesh mesh cad {move}\n")

    def insertion(self):
        """The first clump of clump scenes, else one kind of ellipsoid; above the floor, wholly in the box."""
        if not self.inserts:
            return ""
        low, high = self.low * 0.9, self.high * 0.9
        if self.is_tilted:
            xy, xz, yz = self.tilt
            middle = 0.5 * (self.low + self.high + np.array([xy + xz, yz, 0.0]))
            low, high = middle - 0.1 * self.length, middle + 0.1 * self.length
        if self.floor is not None:
            low[2] = max(low[2], self.floor + 3e-3)
        corners = " ".join(repr(v) for pair in zip(low, high) for v in sorted(map(float, pair)))
        shape = "1.1e-3 6e-4 6e-4 subspheres 5" if self.multisphere else "6e-4 8e-4 1.1e-3"
        grain = "" if self.clumps else f"fix grain all particletemplate/ellipsoid {PRIMES[2]} density {DENSITY} semiaxes {shape}\n"
        return grain + (f"fix drop all insert/drop seed {self.seed + 1} template {'clump0' if self.clumps else 'grain'} "
                        f"particles 5 interval {self.time_steps[0] * 37!r} box {corners} velocity 0.3 -0.5 0.2\n")

    def heat(self, start):
        if not self.heats:
            return ""
        given = "run 0\n" + "".join(f"set atom {k + 1} property/atom Temp {t!r}\n"
                                    for k, t in enumerate(map(float, self.temperatures)))
        return ("fix k all property/global thermalConductivity peratomtype "
                + " ".join(repr(k) for k in CONDUCTIVITY[:self.types])
                + f"\nfix c all property/global thermalCapacity peratomtype {f'{CAPACITY} ' * self.types}\n"
                "fix heat all heat/gran/conduction initial_temperature 300 contact_area overlap\n"
                + ("" if "restart" in start else given))

    def head(self, start, part):
        spheres = "".join(f"fix {name} all property/atom {name} scalar yes yes no 0\n" for name in
                          ("subspheres", "spacing")) if self.multisphere and "restart" in start and not self.clumps else ""
        templates = "".join(c.template(k) for k, c in enumerate(self.clumps))
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
{self.properties()}
pair_style gran/ellipsoid {self.law()} {self.settings(False)}
pair_coeff * *
timestep {self.time_steps[part]!r}
{spheres}{templates}{self.wall_commands()}{'fix down all gravity 9.81 vector 0.2 0 -1' if self.gravity else ''}
{self.insertion()}fix motion all nve/ellipsoid
{self.heat(start)}compute list all pair/ellipsoid/local id contactPoint normal delta force
compute turning all erotate/ellipsoid
compute stress all pressure thermo_temp virial
thermo_style custom step ke c_turning c_stress[1] c_stress[2] c_stress[3] c_stress[4] c_stress[5] c_stress[6] vol
thermo_modify norm no lost ignore format float %.15e
thermo 1
"""

    def extra_columns(self):
        return (["f_Temp", "f_heatFlux"] if self.heats else []) + (
            ["f_subspheres", "f_spacing"] if self.multisphere else [])

    def output(self, part):
        form, extra = " ".join("%d" if c in ("id", "type") else "%.17g" for c in COLUMNS), self.extra_columns()
        return (f"dump d all custom 1 part{part}.dump {' '.join(COLUMNS + extra)}\n"
                f'dump_modify d sort id format "{form}{" %.17g" * len(extra)}"\n'
                f"dump l all local 1 part{part}.local {' '.join(LIST)}\n"
                f'dump_modify l format "{" ".join(["%.0f"] * 2 + ["%.17g"] * 10)}"\n')

    def run(self):
        Path("scene.data").write_text(self.data())
        for k, clump in enumerate(self.clumps):
            clump.write(f"clump{k}.csv")
        if self.wall in ("mesh", "turning"):
            self.write_mesh()
        delete = "group gone id 2 5\ndelete_atoms group gone " + ("\n" if self.compresses else "compress no\n")
        first = self.head("read_data scene.data", 0) + self.output(1) + f"run {STEPS}\nundump d\nundump l\n"
        first += delete if self.deletes else ""
        if self.restarts:
            run(first + "write_restart half.restart\n", self.ranks, name="in.first")
            run(self.head("read_restart half.restart", 1) + self.output(2) + f"run {STEPS}\n", self.ranks,
                name="in.second")
        else:
            run(first + f"timestep {self.time_steps[1]!r}\n" + self.output(2) + f"run {STEPS}\n", self.ranks,
                name="in.first")

    def write_mesh(self):
        (x, y), (u, v) = (self.low[:2] * 0.99).tolist(), (self.high[:2] * 0.99).tolist()
        corners, lines = [(x, y), (u, y), (u, v), (x, v)], ["solid floor"]
        for k in ((0, 1, 2), (0, 2, 3)):
            lines += ["facet normal 0 0 1", "outer loop"]
            lines += [f"vertex {corners[c][0]!r} {corners[c][1]!r} {float(self.floor)!r}" for c in k]
            lines += ["endloop", "endfacet"]
        Path("floor.stl").write_text("\n".join(lines + ["endsolid floor", ""]))

    def __str__(self):
        parts = ["multisphere" if self.multisphere else "smooth", f"{len(self.rows)} bodies", f"{self.ranks} ranks",
                 f"wall {self.wall}", "periodic " + "".join("xyz"[k] for k in range(3) if self.periodic[k])]
        parts += [word for word, drawn in (("clumps", self.clumps), ("tilted", self.is_tilted), ("short", self.short),
                                           ("restart", self.restarts), ("insertion", self.inserts), ("heat", self.heats),
                                           ("deletion", self.deletes), ("host's law", self.host_law),
                                           ("cohesion", self.coheres), (self.rolling, self.rolling),
                                           ("two time steps", self.time_steps[0] != self.time_steps[1])) if drawn]
        return ", ".join(parts)
