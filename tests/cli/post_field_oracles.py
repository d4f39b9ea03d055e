# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""All columns of `fields` at random points of random scenes against their definitions, written again with numpy: triaxial bodies,
discs, chains of spheres and balls of two densities; straight and tilted boxes that repeat, and walls; three functions; made forces.

Images are counted one by one, integrals along the ways are Gauss-Legendre sums between the ends of the function. The balance of
momentum, with the walls' term, is that of finite differences of the printed stress."""
import itertools
import math

import numpy as np

from _oracles import rotation
from _synthetic import COLUMNS, json_of, post, rows_of, write

SEED = 19670412
WIDTH = 0.9e-3
FORCE_NAMES = "i j px py pz nx ny nz fx fy fz".split()
LISTS = ("--contacts", "pairs.local", "--id-columns", "i", "j", "--point-columns", "px", "py", "pz", "--force-columns", "fx", "fy", "fz",
         "--normal-columns", "nx", "ny", "nz", "--wall-contacts", "walls.local", "--wall-id-column", "i", "--wall-point-columns", "px", "py",
         "pz", "--wall-force-columns", "fx", "fy", "fz", "--wall-normal-columns", "nx", "ny", "nz")
SHAPES = [(1.3e-3, 1e-3, 0.8e-3), (0.7e-3, 1.2e-3, 1.2e-3), (1e-3,) * 3, (2.7e-3, 1.15e-3, 1.15e-3)]


class Function:
    """phi of the page, scaled to integral 1 by a sum over shells."""

    def __init__(self, name, width):
        self.name, self.width = name, width
        self.reach = {"gaussian": 3, "lucy": 2, "heaviside": 1}[name] * width
        x, weights = np.polynomial.legendre.leggauss(200)
        r = 0.5 * self.reach * (x + 1)
        self.factor = 1.0 / (0.5 * self.reach * np.sum(weights * 4 * math.pi * r ** 2 * self.plain(r)))

    def plain(self, r):
        if self.name == "gaussian":
            return np.exp(-0.5 * (r / self.width) ** 2)
        q = r / (2 * self.width)
        return 1 - 6 * q ** 2 + 8 * q ** 3 - 3 * q ** 4 if self.name == "lucy" else np.ones_like(r)

    def __call__(self, r):
        return np.where(r <= self.reach, self.factor * self.plain(np.asarray(r, float)), 0.0)

    def along(self, start, way):
        """Mean over the way from `start`, as seen from the middle of the function."""
        a, b, c = way @ way, start @ way, start @ start - self.reach ** 2
        root = b * b - a * c
        if root <= 0:
            return 0.0
        low, high = max(0.0, (-b - math.sqrt(root)) / a), min(1.0, (-b + math.sqrt(root)) / a)
        if low >= high:
            return 0.0
        total = 0.0
        for begin, end in zip(np.linspace(low, high, 9)[:-1], np.linspace(low, high, 9)[1:]):
            x, weights = np.polynomial.legendre.leggauss(12)
            t = begin + 0.5 * (end - begin) * (x + 1)
            r = np.linalg.norm(start + t[:, None] * way, axis=1)
            total += 0.5 * (end - begin) * np.sum(weights * self.factor * self.plain(r))
        return total


def volumes():
    """Of the shapes: ellipsoids, and a chain whose volume `template` tells (its own tests have others for it)."""
    found = [4 / 3 * math.pi * np.prod(s) for s in SHAPES]
    (row,) = json_of("template", "--b", 1.15e-3, "--aspect", 2.7 / 1.15, "--subspheres", 5)
    found[3] = row["volume_m3"]
    return found


class Scene:
    def __init__(self, rng, kind):
        edge = 9e-3
        self.edges = np.diag([edge, 1.1 * edge, 0.9 * edge])
        if kind == "tilted":
            self.edges[1, 0], self.edges[2, 0], self.edges[2, 1] = 0.3 * edge, -0.2 * edge, 0.25 * edge
        self.repeats = kind != "walls"
        self.rows = []
        for k in range(40):
            q = rng.normal(size=4)
            q /= np.linalg.norm(q)
            place = rng.uniform(0, 1, 3) @ self.edges
            density = 1000.0 if k % 2 else 2500.0
            self.rows.append(dict(zip(COLUMNS, (3 * k + 1, 1 + k % 2, density * VOLUMES[k % 4], *place, *rng.normal(size=3),
                                                *(300 * rng.normal(size=3)), *q, *SHAPES[k % 4], 5 if k % 4 == 3 else 0))))
        self.shifts = [np.array(s) @ self.edges for s in itertools.product((-1, 0, 1), repeat=3)] if self.repeats else [np.zeros(3)]
        self.contacts = self.pairs(rng) + self.walls(rng)

    def pairs(self, rng):
        """(body, body or None, way from the first centre to the contact, from the second, force on the first, normal)."""
        found = []
        for _ in range(150):
            i, j = rng.choice(40, 2, replace=False)
            between = self.place(j) - self.place(i)
            between = min((between + s for s in self.shifts), key=np.linalg.norm)
            if np.linalg.norm(between) > 3.5e-3:
                continue
            way = 0.4 * between + rng.normal(size=3) * 2e-4
            n = rng.normal(size=3)
            found.append((i, j, way, way - between, -between * 800 + rng.normal(size=3) * 0.3, n / np.linalg.norm(n)))
        assert len(found) > 8
        return found

    def walls(self, rng):
        found = []
        for i in rng.choice(40, 12, replace=False):
            way = np.array((0, 0, -1e-3)) + rng.normal(size=3) * 2e-4
            found.append((i, None, way, None, -2000 * way + rng.normal(size=3) * 0.3, np.array((0.0, 0.0, 1.0))))
        return found

    def place(self, i):
        return np.array([self.rows[i][c] for c in "xyz"])

    def write(self):
        e = self.edges
        corners = np.array([np.array(s) @ e for s in itertools.product((0, 1), repeat=3)])
        low, high = corners.min(axis=0), corners.max(axis=0)
        tilt = (e[1, 0], e[2, 0], e[2, 1])
        bounds = "".join(f"{float(low[k])!r} {float(high[k])!r} {float(tilt[k])!r}\n" for k in range(3))
        head = lambda what, n, box: f"ITEM: TIMESTEP\n0\nITEM: NUMBER OF {what}\n{n}\nITEM: BOX BOUNDS {box}"
        sides = "xy xz yz " + ("pp pp pp" if self.repeats else "ff ff ff") + "\n" + bounds
        rows = "".join(" ".join(repr(float(r[c])) if c not in ("id", "type", "f_subspheres") else str(r[c]) for c in COLUMNS) + "\n" for r in self.rows)
        write("scene.dump", head("ATOMS", len(self.rows), sides) + "ITEM: ATOMS " + " ".join(COLUMNS) + "\n" + rows)
        for name, chosen in (("pairs.local", [c for c in self.contacts if c[1] is not None]), ("walls.local", [c for c in self.contacts if c[1] is None])):
            lines = ""
            for i, j, way, _, force, normal in chosen:
                point = self.place(i) + way
                if self.repeats:  # lists name points of the box, wherever the body is
                    point = (np.linalg.solve(e.T, point) % 1.0) @ e
                lines += " ".join([str(self.rows[i]["id"]), str(self.rows[j]["id"] if j is not None else 0),
                                   *(repr(float(x)) for x in (*point, *normal, *force))]) + "\n"
            write(name, head("ENTRIES", len(chosen), "ff ff ff\n0 1\n0 1\n0 1\n") + "ITEM: ENTRIES " + " ".join(FORCE_NAMES) + "\n" + lines)


def inertia_of(row, axes):
    """Of the solid ellipsoid, in space."""
    a, b, c = axes
    turn = rotation([row[f"quat{k}"] for k in (1, 2, 3, 4)])
    return turn @ np.diag([b * b + c * c, a * a + c * c, a * a + b * b]) @ turn.T * row["mass"] / 5


def expected(scene, phi, r):
    """All columns at a place, from the table of the page."""
    sums = {k: 0.0 for k in ("n", "rho", "solid", "p", "pp", "I", "L", "Lw", "Lv", "fabric", "sigma", "couple", "boundary", "force")}
    dyads = [np.zeros((3, 3)) for _ in scene.rows]
    forces = [np.zeros(3) for _ in scene.rows]
    for i, j, _, _, f, n in scene.contacts:
        for body, sign in ((i, 1), (j, -1)):
            if body is not None:
                dyads[body] += np.outer(n, n)
                forces[body] += sign * f
    for k, row in enumerate(scene.rows):
        v, w = np.array([row[c] for c in ("vx", "vy", "vz")]), np.array([row[c] for c in ("omegax", "omegay", "omegaz")])
        inertia = inertia_of(row, [row[c] for c in ("shapex", "shapey", "shapez")])
        for shift in scene.shifts:
            weight = float(phi(np.linalg.norm(r - scene.place(k) - shift)))
            if weight == 0.0:
                continue
            m = row["mass"]
            for name, value in (("n", 1.0), ("rho", m), ("solid", VOLUMES[k % 4]), ("p", m * v), ("pp", m * np.outer(v, v)), ("I", inertia),
                                ("L", inertia @ w), ("Lw", w @ inertia @ w), ("Lv", np.outer(inertia @ w, v)),
                                ("fabric", VOLUMES[k % 4] * dyads[k]), ("force", forces[k])):
                sums[name] = sums[name] + weight * value
    for i, j, way_i, way_j, f, _ in scene.contacts:
        for body, way, force in ((i, way_i, f), (j, way_j, -f)):
            if body is None:
                continue
            for shift in scene.shifts:
                share = phi.along(r - scene.place(body) - shift, -way)
                sums["sigma"] = sums["sigma"] + share * np.outer(force, -way)
                sums["couple"] = sums["couple"] + share * np.outer(np.cross(way, force), -way)
                if j is None:
                    sums["boundary"] = sums["boundary"] - float(phi(np.linalg.norm(r - scene.place(body) - way - shift))) * force
    u = sums["p"] / sums["rho"]
    omega = np.linalg.solve(sums["I"], sums["L"])
    kinetic = sums["pp"] - sums["rho"] * np.outer(u, u)
    return {"number_density": sums["n"], "density": sums["rho"], "solid_fraction": sums["solid"], "momentum": sums["p"], "velocity": u,
            "angular_velocity": omega, "temperature": np.trace(kinetic) / (3 * sums["rho"]), "kinetic_stress": kinetic,
            "rotational_temperature": (sums["Lw"] - omega @ sums["L"]) / (3 * sums["rho"]), "contact_stress": sums["sigma"],
            "stress": sums["sigma"] + kinetic, "pressure": np.trace(sums["sigma"] + kinetic) / 3,
            "couple_stress": sums["couple"] + sums["Lv"] - np.outer(sums["L"], u), "boundary_force": sums["boundary"],
            "fabric": sums["fabric"], "spin": sums["L"], "spin_energy": sums["Lw"], "force": sums["force"]}


UNITS = {"number_density": "_per_m3", "density": "_kg_per_m3", "solid_fraction": "", "momentum": "_kg_per_m2_s", "velocity": "_m_per_s",
         "angular_velocity": "_rad_per_s", "temperature": "_m2_per_s2", "kinetic_stress": "_Pa", "rotational_temperature": "_m2_per_s2",
         "contact_stress": "_Pa", "stress": "_Pa", "pressure": "_Pa", "couple_stress": "_N_per_m", "boundary_force": "_N_per_m3", "fabric": ""}


SQUARES = {"temperature": lambda t: t["velocity"] @ t["velocity"], "kinetic_stress": lambda t: t["density"] * t["velocity"] @ t["velocity"],
           "rotational_temperature": lambda t: t["spin_energy"] / t["density"], "stress": lambda t: t["density"] * t["velocity"] @ t["velocity"],
           "pressure": lambda t: t["density"] * t["velocity"] @ t["velocity"], "couple_stress": lambda t: np.outer(t["spin"], t["velocity"])}


def printed(row, name):
    if f"{name}_xx{UNITS[name]}" in row:
        return np.array([[row[f"{name}_{a}{b}{UNITS[name]}"] for b in "xyz"] for a in "xyz"])
    if f"{name}_x{UNITS[name]}" in row:
        return np.array([row[f"{name}_{a}{UNITS[name]}"] for a in "xyz"])
    return np.array(row[name + UNITS[name]])


def check_points(scene, name, rng):
    phi = Function(name, WIDTH)
    points = np.array([scene.place(k) + rng.uniform(-0.5, 0.5, 3) * WIDTH for k in range(0, 40, 5)])
    rows = json_of("fields", "scene.dump", "--kernel", name, "--width", WIDTH, *LISTS, "--at", *points.ravel())
    assert len(rows) == len(points)
    truths = [expected(scene, phi, r) for r in points]
    keys = {key for row in rows for key in row} - {"run", "timestep", "width_m", "x_m", "y_m", "z_m"}
    known = {k for n in UNITS for k in keys if k == n + UNITS[n] or (k.startswith(n + "_") and k.endswith(UNITS[n]))}
    assert keys == known, keys - known  # no column without an oracle
    for field in UNITS:
        scale = max(np.abs(t[field]).max() for t in truths)
        if field in SQUARES:  # small differences of squares: of one particle alone there is nothing but rounding
            scale = max([scale] + [np.abs(SQUARES[field](t)).max() for t in truths])
        for row, truth in zip(rows, truths):
            off = np.abs(printed(row, field) - truth[field]).max()
            assert off <= 2e-9 * scale, (name, field, printed(row, field), truth[field])


def check_balance(scene, rng):
    """- div(contact stress) - boundary force = sum of the forces on the particles, smeared out."""
    phi, step = Function("lucy", WIDTH), 1e-3 * WIDTH
    for k in range(3, 40, 12):
        r = scene.place(k) + rng.normal(size=3) * 0.3 * WIDTH
        around = [r] + [r + s * step * np.eye(3)[axis] for axis in range(3) for s in (-2, -1, 1, 2)]
        rows = json_of("fields", "scene.dump", "--kernel", "lucy", "--width", WIDTH, *LISTS, "--at", *np.ravel(around))
        s = [printed(row, "contact_stress") for row in rows]
        slopes = [(s[1 + 4 * a] - 8 * s[2 + 4 * a] + 8 * s[3 + 4 * a] - s[4 + 4 * a]) / (12 * step) for a in range(3)]
        divergence = sum(slopes[a][:, a] for a in range(3))
        truth = expected(scene, phi, r)
        found = -divergence - printed(rows[0], "boundary_force")
        scale = np.abs(truth["force"]).max() + max(np.abs(one).max() for one in s) / WIDTH
        # lucy's third derivative jumps at its end: fourth-order differences leave the step's cube times it, and 1e-16 / step of rounding
        assert np.abs(found - truth["force"]).max() <= 1e-7 * scale, (found, truth["force"])


def check_integrals(scene):
    """Over the whole of a repeating box: masses, momenta, and sums of f b over both sides of all contacts, from profile and grid."""
    volume = abs(np.linalg.det(scene.edges))
    mass = sum(r["mass"] for r in scene.rows)
    sigma = np.zeros((3, 3))
    for i, j, way_i, way_j, f, _ in scene.contacts:
        sigma += np.outer(f, -way_i) + (np.outer(-f, -way_j) if j is not None else 0)
    # sums over 64 planes, 0.14 w apart, of means over planes: smooth (lucy), cut off at 0.0044 of the middle's value, parabolas
    for kernel, off in (("gaussian", 2e-3), ("lucy", 2e-6), ("heaviside", 1e-2)):
        rows = json_of("fields", "scene.dump", "--kernel", kernel, "--width", WIDTH, *LISTS, "--profile", "z", "--slices", 64)
        assert abs(np.mean([r["density_kg_per_m3"] for r in rows]) * volume / mass - 1) < off, (kernel, off)
        total = np.mean([printed(r, "contact_stress") for r in rows], axis=0) * volume
        assert np.abs(total - sigma).max() < off * np.abs(sigma).max(), (kernel, total, sigma)


def check_radius():
    """One ball on the axis between the ends, smeared out: the mean over a ring is the integral along a line, in closed form by sums.
    One contact straight outwards: the stress has the component rr alone where it is not smeared over the axis."""
    row = dict(zip(COLUMNS, (1, 1, 2e-5, 1e-3, 2e-3, 5e-3, 0.0, 0.0, 0.5, 0, 0, 0, 1, 0, 0, 0, 1e-3, 1e-3, 1e-3, 0)))
    write("axis.dump", "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff ff\n-1 1\n-1 1\n-1 1\nITEM: ATOMS "
          + " ".join(COLUMNS) + "\n" + " ".join(str(row[c]) for c in COLUMNS) + "\n")
    phi, length = Function("lucy", WIDTH), 1e-2
    rows = json_of("fields", "axis.dump", "--kernel", "lucy", "--width", WIDTH, "--profile", "radius", "--slices", 8,
                   "--cylinder", 1e-3, 2e-3, 2 * WIDTH, 0, length)
    z = (np.arange(200000) + 0.5) / 200000 * length - 5e-3
    for found in rows:
        truth = 2e-5 * np.mean(phi(np.hypot(found["radius_m"], z)))
        assert abs(found["density_kg_per_m3"] - truth) <= 2e-3 * 2e-5 * np.mean(phi(np.abs(z))), (found["radius_m"], truth)
        assert found["velocity_z_m_per_s"] is None or abs(found["velocity_z_m_per_s"] - 0.5) < 1e-9
    ring = [found["radius_m"] * found["density_kg_per_m3"] for found in rows]
    assert abs(sum(ring) * 2 * math.pi * (2 * WIDTH / 8) * length / 2e-5 - 1) < 2e-2, sum(ring)


VOLUMES = []


def main():
    print("seed", SEED)
    VOLUMES.extend(volumes())
    rng = np.random.default_rng(SEED)
    for kind in ("straight", "tilted", "walls"):
        scene = Scene(rng, kind)
        scene.write()
        for name in ("gaussian", "lucy", "heaviside"):
            check_points(scene, name, rng)
        check_balance(scene, rng)
        if kind != "walls":
            check_integrals(scene)
    check_radius()
    assert post("fields", "scene.dump", "--at", 0, 0, 0)[0] and rows_of("fields", "scene.dump", "--at", 0, 0, 0)


main()
