"""inputs/benchmark_silo.in, benchmark_drum.in and benchmark_penetration.in, in their short forms: what leaves the silo, what the drum carries, what stops the ball, against closed forms and counts of the frames; the host's spheres beside ours."""

import math
import os
import unittest
from pathlib import Path

import numpy as np

from _contact_rows import read_rows
from _engine import kinetic_energy, read_dump, run, run_example, thermo, vectors
from _examples import GRAVITY, frame, frames, potential_energy, surface_points, total_energy

INPUTS = Path(os.environ["ELLIPSOID_SOURCE"]) / "inputs"
MESHES = INPUTS / "meshes"
#: published materials by type (Dosta et al. 2024): Young's modulus (Pa), density (kg/m3)
MODULUS, DENSITY = {1: 1e9, 2: 0.5e9, 3: 210e9}, {1: 2500.0, 2: 2000.0, 3: 7200.0}
POISSON = 0.2
RESTITUTION, FRICTION = {(1, 1): 0.5, (1, 3): 0.4}, {(1, 1): 0.3, (1, 3): 0.2}
ASPECT = 1.5


def semiaxes(radius):
    """Of the spheroid of ASPECT with the volume of a sphere (m)."""
    return np.array([ASPECT ** (2 / 3), ASPECT ** (-1 / 3), ASPECT ** (-1 / 3)]) * radius


def mass(kind, radius):
    return DENSITY[kind] * 4.0 / 3.0 * math.pi * radius ** 3


def hertz_depth(kind, radius, speed, soften):
    """Largest overlap (m) of a sphere of this type that meets a rigid wall: (15 m v^2 / (16 E* sqrt(R)))^(2/5)."""
    modulus = MODULUS[kind] / soften / (1.0 - POISSON ** 2)
    return (15.0 * mass(kind, radius) * speed ** 2 / (16.0 * modulus * math.sqrt(radius))) ** 0.4


def frames_by_step(pattern):
    """{step: columns} of files that need not have the same particles."""
    return {int(steps[0]): columns for steps, columns in (read_dump(f) for f in sorted(Path().glob(pattern)))}


def last_run(rows):
    """Rows of the thermo tables since the clock, column 1, began anew."""
    return rows[np.flatnonzero(np.diff(rows[:, 1]) < 0.0)[-1] + 1:]


def row_of(rows, step):
    return rows[np.flatnonzero(rows[:, 0] == step)[0]]


class Silo(unittest.TestCase):
    PARTICLES, SIZE, SOFTEN = 500, 2.5, 100
    RADIUS = 0.002 * SIZE
    HOLE, BOTTOM, TUBE = 0.03, -0.0554222, 0.1
    SHORT = {"particles": PARTICLES, "size": SIZE, "fill": 0.15, "flow": 0.2, "meshes": MESHES}

    def wall(self, height):
        """Radius of cone and tube; no wall below the orifice."""
        return np.where(height < self.BOTTOM, np.inf, np.minimum(self.HOLE + height - self.BOTTOM, self.TUBE))

    def check_walls(self, columns):
        points = surface_points(columns)
        height = points[..., 2]
        beyond = (np.hypot(points[..., 0], points[..., 1]) - self.wall(height)).max()
        # the mesh is a polygon inside the cone; a contact gives way as to a sphere that has fallen since the run began
        self.assertLess(beyond, hertz_depth(1, self.RADIUS, GRAVITY * self.SHORT["fill"], self.SOFTEN))

    def test_ellipsoids_leave_at_the_rate_of_beverloos_law(self):
        run_example("benchmark_silo", {**self.SHORT, "out": "silo"})
        one = mass(1, self.RADIUS)
        rows = thermo("silo/log.silo", columns=7)
        flow = last_run(rows)
        filled = rows[len(rows) - len(flow) - 1]
        self.assertEqual(filled[2], self.PARTICLES)
        self.assertAlmostEqual(filled[3] / (self.PARTICLES * one), 1.0, delta=1e-6)
        self.assertTrue((np.diff(flow[:, 2]) <= 0.0).all(), "particles come back")
        self.assertTrue((np.abs(flow[:, 3] / one - flow[:, 2]) < 1e-6 * self.PARTICLES).all())
        self.assertTrue((flow[:, 4] >= flow[:, 2]).all())
        seen = frames_by_step("silo/silo.*.dump")
        self.assertEqual(len(seen), 4)
        for step, columns in seen.items():
            row = row_of(flow, step)
            self.assertEqual((columns["z"][0] > self.BOTTOM).sum(), row[2])
            self.assertEqual(len(columns["id"][0]), row[4])
            self.assertTrue((np.abs(vectors(columns, "shapex", "shapey", "shapez")[0] / semiaxes(self.RADIUS) - 1)
                             < 1e-5).all())
            self.check_walls(columns)
        ids = [set(columns["id"][0]) for columns in seen.values()]
        self.assertTrue(all(b <= a for a, b in zip(ids, ids[1:])) and ids[-1] < ids[0], "none leave, or others come")
        steady = flow[(flow[:, 1] > 0.06)]
        found = -np.polyfit(steady[:, 1], steady[:, 3], 1)[0]
        # Beverloo's law with its usual constants (Nedderman 1992, eq. 10.2.7); hoppers of 45 degrees give up to a
        # third more (Rose and Tanaka's factor), a few hundred grains are no steady flow
        beverloo = (0.58 * 0.58 * DENSITY[1] * math.sqrt(GRAVITY)
                    * (2.0 * self.HOLE - 1.4 * 2.0 * self.RADIUS) ** 2.5)
        print(f"silo: {found:.3f} kg/s, Beverloo's law {beverloo:.3f} kg/s, {flow[-1, 2]:.0f} of "
              f"{self.PARTICLES} above the orifice at the end")
        self.assertTrue(0.7 < found / beverloo < 1.6)

    def test_spheres_of_the_host_and_ours_fall_alike(self):
        """The first collisions. Later they part: the host's spheres keep the spring of a pair that has come apart, and go on
        with it when the pair touches again (tangential_model_history.h is told of close pairs only)."""
        energies = []
        for shape in ("sphere_host", "sphere"):
            run_example("benchmark_silo", {**self.SHORT, "particles": 200, "part": "fill", "fill": 0.0405,
                                           "material": "M2", "orifice": "small", "shape": shape, "out": shape})
            rows = thermo(f"{shape}/log.silo", columns=7)
            rows = rows[rows[:, 1] > 0.005]
            energies.append(rows[:, 5])
            self.assertAlmostEqual(rows[-1, 3] / (200 * mass(2, self.RADIUS)), 1.0, delta=1e-6)
        free = 0.5 * 200 * mass(2, self.RADIUS) * (GRAVITY * rows[:, 1]) ** 2
        print(f"silo, kinetic energy over that of a free fall: host's spheres {energies[0] / free}, ours {energies[1] / free}")
        self.assertLess(energies[0][-1], 0.995 * free[-1])  # some have hit the cone
        self.assertLess(np.abs(energies[0] / energies[1] - 1.0).max(), 1e-6)  # 8 digits are printed


class Drum(unittest.TestCase):
    SIZE, WIDTH = 4.0, 0.03
    COUNT = {1: 234, 2: 63}  # 15,000 and 4000 over SIZE cubed
    RADIUS = {1: 0.001 * SIZE, 2: 0.002 * SIZE}

    def test_carries_two_kinds_of_ellipsoids(self):
        run_example("benchmark_drum", {"size": self.SIZE, "width": self.WIDTH, "turn": 0.3, "fill": 0.2,
                                       "meshes": MESHES, "out": "drum"})
        seen = frames_by_step("drum/drum.*.dump")
        columns = frames("drum/drum.*.dump")
        self.assertEqual(columns["id"].shape, (3, sum(self.COUNT.values())))
        for kind, count in self.COUNT.items():
            these = columns["type"][0] == kind
            self.assertEqual(these.sum(), count)
            self.assertTrue((np.abs(columns["mass"][0][these] / mass(kind, self.RADIUS[kind]) - 1) < 1e-5).all())
        rows = thermo("drum/log.drum", columns=9)
        turning = last_run(rows)
        # some of the large ones are wedged between the covers since they have fallen, all the drum's height at most
        sink = hertz_depth(2, self.RADIUS[2], math.sqrt(2.0 * GRAVITY * 0.2), 100)
        for step, now in seen.items():
            points = surface_points(now)
            self.assertLess(np.hypot(points[..., 0], points[..., 2]).max(), 0.1 + sink)
            self.assertLess(np.abs(points[..., 1]).max(), 0.5 * self.WIDTH + sink)
            row = row_of(turning, step)
            for column, (side, kind) in enumerate(((1, 1), (1, 2), (-1, 1), (-1, 2)), start=3):
                inside = (side * now["x"] > 0) & (side * now["z"] > 0) & (now["type"] == kind)
                self.assertEqual(inside.sum(), row[column])
        first, last = frame(columns, 0), frame(columns, 2)
        lift = (last["mass"] * (last["z"] - first["z"])).sum() / last["mass"].sum()
        across = (last["mass"] * last["x"]).sum() / last["mass"].sum()
        rim = np.hypot(last["x"], last["z"])[0] > 0.085
        spin = (last["z"] * last["vx"] - last["x"] * last["vz"])[0][rim] / (last["x"] ** 2 + last["z"] ** 2)[0][rim]
        print(f"drum: centre of mass goes up by {lift:.4f} m to x = {across:.4f} m, "
              f"{rim.sum()} particles at the rim turn by {np.median(spin):.2f} rad/s")
        self.assertGreater(across, 0.01)
        self.assertGreater(lift, 0.001)
        self.assertLess(abs(np.median(spin) + 2.0), 0.6)  # those at the rim turn with the drum, and slip


class Penetration(unittest.TestCase):
    PARTICLES, LENGTH, BALL, SOFTEN, SKIP, TIME = 500, 0.020, 0.004, 100, 0.022, 0.031
    SHORT = {"particles": PARTICLES, "length": LENGTH, "breadth": LENGTH, "ball": BALL, "soften": SOFTEN,
             "fill": 0.08, "skip": SKIP, "time": TIME}
    DT = 5e-7 * math.sqrt(SOFTEN)

    def ball_rows(self, out):
        return thermo(f"{out}/log.penetration", columns=8)

    def test_ball_falls_and_is_stopped_by_ellipsoids(self):
        for part in ("both", "fill", "impact"):
            run_example("benchmark_penetration", {**self.SHORT, "part": part,
                                                  "out": "once" if part == "both" else "twice"})
        ends = [sorted(Path(out).glob("impact.*.dump"))[-1].read_bytes() for out in ("once", "twice")]
        self.assertEqual(ends[0], ends[1], "the run in two parts ends elsewhere")
        rows = self.ball_rows("once")
        time, height, speed, force = rows[:, 1:5].T
        falling = np.flatnonzero(np.cumsum(np.abs(force)) == 0.0)
        self.assertGreater(falling.size, 3)
        # 0.15 m above the floor with 5 m/s at time 0, as if it had fallen all the way; 8 digits are printed
        self.assertLess(np.abs(height - (0.15 - 5.0 * time - 0.5 * GRAVITY * time ** 2))[falling].max(), 1e-8)
        self.assertLess(np.abs(speed + 5.0 + GRAVITY * time)[falling].max(), 1e-6)
        # as if there were no bed; the floor is steel as well, half as stiff together
        self.assertGreater(height.min(), self.BALL - hertz_depth(3, self.BALL, speed[0], 2 * self.SOFTEN))
        self.assertGreater(speed[-1], 0.2 * speed[0], "the ball goes on")  # both are negative
        columns = frames("once/impact.*.dump")
        energy = total_energy(columns)
        self.assertLess(np.diff(energy).max(), 1e-5 * energy[0])
        points = surface_points(frame(columns, -1))
        self.assertLess(np.abs(points[..., :2]).max(), 0.5 * self.LENGTH + 2e-5)
        print(f"penetration: {falling.size} rows of free fall; the ball comes to {height.min():.4f} m; "
              f"{kinetic_energy(columns)[-1] / kinetic_energy(columns)[0]:.1e} of the kinetic energy is left, "
              f"{(potential_energy(columns)[-1] - potential_energy(columns)[0]) / energy[0]:.1e} went into height")

    def test_forces_on_the_ball_are_those_of_the_published_law(self):
        """Every contact of the ball in mid-impact: overlap of two spheres, Hertz's force with Tsuji's damping for the
        restitution of M1 on steel, Coulomb's friction where it slides; and what they sum up to."""
        variables = {**self.SHORT, "shape": "sphere", "time": 0.0275, "out": "law"}
        lines = "".join(f"variable {n} index {v}\n" for n, v in variables.items())
        run(lines + f"""include {INPUTS}/benchmark_penetration.in
compute rows all pair/ellipsoid/local id normal delta fn ft force
dump rows all local 1 rows.local {' '.join(f'c_rows[{k}]' for k in range(1, 12))}
dump state all custom 1 state.dump id type mass x y z vx vy vz fx fy fz shapex
dump_modify state sort id format "%d %d {' '.join(['%.17g'] * 11)}"
run 0
""", name="in.law")
        columns = {name: values[0] for name, values in read_dump("state.dump")[1].items()}
        place, velocity, total = (vectors(columns, *names) for names in
                                  (("x", "y", "z"), ("vx", "vy", "vz"), ("fx", "fy", "fz")))
        index = {int(i): k for k, i in enumerate(columns["id"])}
        steel = int(np.flatnonzero(columns["type"] == 3)[0])
        rows = next(iter(read_rows("rows.local").values()))
        contacts = [row for row in rows if index[int(row[0])] == steel or index[int(row[1])] == steel]
        self.assertGreater(len(contacts), 3)
        sum_of_forces, worst = np.zeros(3), 0.0
        for row in contacts:
            i, j = index[int(row[0])], index[int(row[1])]
            line = place[j] - place[i]
            normal = line / np.linalg.norm(line)
            overlap = columns["shapex"][i] + columns["shapex"][j] - np.linalg.norm(line)
            self.assertAlmostEqual(row[5] / overlap, 1.0, delta=1e-4)  # of a few micrometres, with 6 digits
            fn = self.normal_force(overlap, self.BALL, columns["mass"][i], columns["mass"][j],
                                   (velocity[i] - velocity[j]) @ normal)
            worst = max(worst, abs(row[6] - fn) / abs(fn))
            sum_of_forces += row[8:11] if i == steel else -row[8:11]
        # contacts that slide have the friction of their materials, to the 6 digits that are printed
        ratio, of_ball = rows[:, 7] / rows[:, 6], [steel in (index[int(r[0])], index[int(r[1])]) for r in rows]
        for kinds, some in (((1, 3), ratio[of_ball]), ((1, 1), ratio[np.logical_not(of_ball)])):
            self.assertGreater((np.abs(some / FRICTION[kinds] - 1.0) < 1e-5).sum(), 1, f"friction of {kinds}: {some}")
        weight = columns["mass"][steel] * GRAVITY
        deviation = np.abs(sum_of_forces - weight * np.array([0, 0, 1]) - total[steel]).max()
        print(f"penetration: {len(contacts)} contacts of the ball, normal forces off the law by {worst:.1e}, their sum "
              f"off the force on it by {deviation:.1e} N of {np.linalg.norm(total[steel]):.3f} N")
        self.assertLess(worst, 3e-5)  # 6 digits are printed
        self.assertLess(deviation, 1e-5 * np.linalg.norm(total[steel]))

    def normal_force(self, overlap, ball, mass_1, mass_2, approach):
        """Hertz's force and Tsuji et al. 1992's damping, as Dosta et al. 2024 give them (N)."""
        share = (1 - POISSON ** 2) * self.SOFTEN
        modulus = 1.0 / (share / MODULUS[1] + share / MODULUS[3])
        radius = 1.0 / (1.0 / 0.001 + 1.0 / ball)
        reduced = mass_1 * mass_2 / (mass_1 + mass_2)
        log = math.log(RESTITUTION[1, 3])
        beta = -log / math.sqrt(log ** 2 + math.pi ** 2)
        stiffness = 2.0 * modulus * math.sqrt(radius * overlap)
        return (4.0 / 3.0 * modulus * math.sqrt(radius) * overlap ** 1.5
                + 2.0 * math.sqrt(5.0 / 6.0) * beta * math.sqrt(stiffness * reduced) * approach)


if __name__ == "__main__":
    unittest.main(verbosity=2)
