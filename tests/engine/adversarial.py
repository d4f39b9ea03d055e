"""Random small scenes against brute force: forces, torques, contact lists, heat, stress, energies and motion, every step.

A scene (_random_scene.py) draws surface, shapes (each body its own: prolate, oblate, triaxial, its own number of
spheres, clumps), materials, laws (the paper's or the host's, rolling friction, cohesion), temperatures, walls (sheared,
or a mesh that moves or turns), boundaries, tilted boxes, boxes so short that a body touches several images of another,
or its own, 1 to 4 ranks, an insertion, a deletion with or without new numbers, a restart file and another time step on
the way from its seed, which is printed. The engine dumps each step; _brute_force.py computes the forces of that step
again from positions and orientations alone: all pairs, all images, springs of its own. Velocities at the moment of the
forces follow from the last step's velocities and forces: v + f dt / 2 m, and the same for the angular momentum. Each
step's motion is that of its forces as well; orientations are those of a rigid body, by Runge and Kutta's method.

ELLIPSOID_ADVERSARIAL_SECONDS=3600 goes on with new seeds for that time, from ELLIPSOID_ADVERSARIAL_FIRST (100000) on;
ELLIPSOID_ADVERSARIAL_SEED=N makes one scene again.
"""

import math
import os
import shutil
import time
import traceback
import unittest
from pathlib import Path

import numpy as np

from _random_scene import COLUMNS, CONDUCTIVITY, HOT_WALL, LIST, Scene

SCENES = (2, 3, 5, 6, 9, 17, 23, 24, 26, 52, 54, 55, 700049, 800000)
RELATIVE = 2e-8  # forces and torques, of the largest in the step: Newton's normals, springs over all steps
LISTED = 1e-7  # contacts: overlap over the smallest semi-axis, point, normal
TOUCHING = 1e-12  # overlaps below this share of the smallest semi-axis may be found or not
MOVED = 1e-11  # motion of a step: of the largest coordinate, speed and angular momentum


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


def free_turn(quaternion, spin, moments, time):
    """Orientations (N, 4) of free bodies after `time` (s), from their angular momenta in space (N, 3): Runge and Kutta,
    4 steps."""

    def rate(q):
        q = q / np.linalg.norm(q, axis=1)[:, None]
        w, v = q[:, :1], q[:, 1:]
        body = spin + 2.0 * np.cross(v, np.cross(v, spin) - w * spin)
        omega = body / moments
        return 0.5 * np.column_stack([-(v * omega).sum(1), w * omega + np.cross(v, omega)])

    for _ in range(4):
        h = 0.25 * time
        a = rate(quaternion)
        b = rate(quaternion + 0.5 * h * a)
        c = rate(quaternion + 0.5 * h * b)
        quaternion = quaternion + h / 6.0 * (a + 2.0 * b + 2.0 * c + rate(quaternion + h * c))
    return quaternion / np.linalg.norm(quaternion, axis=1)[:, None]


def renamed(memory, number):
    """Springs or couples of contacts by new ids: {old id: new id}; a pair is known by the smaller one first."""
    found = {}
    for key, value in memory.items():
        if len(key) == 3:
            found[number[key[0]], key[1], key[2]] = value
            continue
        i, j = number[key[0]], number[key[1]]
        if i <= j:
            found[(i, j) + key[2:]] = value
        else:
            found[j, i, tuple(-n for n in key[2]), key[4], key[3]] = -value
    return found


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
        columns = len(COLUMNS) + len(scene.extra_columns())
        logs = ["log.in.first"] + (["log.in.second"] if scene.restarts else [])
        tables, before = thermo_rows(*logs), None
        for part in (1, 2):
            frames = dump_frames(f"part{part}.dump", columns)
            lists = dict(dump_frames(f"part{part}.local", len(LIST)))
            self.begin(part, frames[0][1], before)
            before = None
            for k, (step, values) in enumerate(frames):
                before = self.step(step, values, lists[step], before, is_start=k == 0)
                row = tables[step][-1 if part == 2 else 0]
                self.energies(step, before[0], row)
        return self.complaints

    def begin(self, part, values, before):
        """The time step of a part; contacts of those that are left, by their new numbers."""
        brute, self.part = self.brute, part
        brute.law.dt = self.time_step = self.scene.time_steps[part - 1]
        if part == 1:
            return
        old = before[0]
        number = {}
        for i, x in zip(values[:, 0].astype(int), values[:, 3:6]):
            way = np.linalg.norm(old.x - x, axis=1)
            if not way.min() <= 1e-15:
                self.complain("between the runs", f"particle {i} at {x} was not there before")
            number[old.ids[way.argmin()]] = i
        kept = [{key: v for key, v in memory.items() if key[0] in number and (len(key) == 3 or key[1] in number)}
                for memory in (brute.springs, brute.couples)]
        brute.springs, brute.couples = (renamed(memory, number) for memory in kept)

    def step(self, step, values, listed, before, is_start):
        scene, brute = self.scene, self.brute
        is_first = is_start and (self.part == 1 or scene.restarts)  # of a script: meshes are not in motion yet
        frame, now = scene.frame(values), scene.time(step)
        half, v, omega = 0.5 * self.time_step, frame.v, frame.omega
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
            self.compare_motion(step, old, frame, known, v, spin, values)
        f, t, rows, virial = brute.step(frame, now, v, omega, advance=not is_start,
                                        wall_moves=not (is_first and scene.wall in ("mesh", "turning")))
        if scene.gravity:
            down = 9.81 * np.array([0.2, 0.0, -1.0]) / math.sqrt(1.04)
            f = f + frame.mass[:, None] * down
        if scene.heats and not is_start:  # at set-up the host makes no fluxes
            self.compare_heat(step, frame, values[:, 25], values[:, 26], now)
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

    def compare_motion(self, step, old, frame, known, velocity, spin, values):
        """Of those that were there: leapfrog; `velocity`, `spin` (of the old ones): in the middle of the step."""
        there = known >= 0
        k, half = known[there], 0.5 * self.time_step
        for name, found, expected, scale in (
                ("place", frame.x[there], old.x[k] + 2.0 * half * velocity[there], np.abs(frame.x).max()),
                ("velocity", frame.v[there], (velocity + half * values[:, 19:22] / frame.mass[:, None])[there],
                 np.abs(frame.v).max()),
                ("angular momentum", frame.spin()[there], spin[k] + half * values[there, 22:25],
                 np.abs(spin).max()),
                ("orientation", frame.quaternion[there],
                 free_turn(old.quaternion[k], spin[k], old.moments[k], 2.0 * half), 1.0)):
            if name == "orientation":
                found = found * np.sign((found * expected).sum(1))[:, None]
                rate = np.abs(np.linalg.norm(spin[k], axis=1) / old.moments[k].min(1)).max()
                allowed = MOVED + (2.0 * half * rate) ** 3  # of the splitting
            else:
                allowed = MOVED * scale
            error = np.abs(found - expected).max(1) if len(found) else np.zeros(1)
            if not error.max() <= allowed:
                worst = int(error.argmax())
                self.complain(step, f"{name} of {frame.ids[there][worst]} is {found[worst]}, expected {expected[worst]}")

    def compare_heat(self, step, frame, temperature, found, time):
        """4 k1 k2 / (k1 + k2) sqrt(2 pi R h) of each contact, its share where they are averaged."""
        flux = np.zeros(len(frame.ids))

        def conductance(first, second, area):
            k, m = CONDUCTIVITY[first], CONDUCTIVITY[second]
            return 4.0 * k * m / (k + m) * math.sqrt(area)

        for i, j, _, h, _, _, radius, weight, _ in self.brute.contacts(frame).values():
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
                off = off - self.brute.nearest(off) @ self.brute.cell
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
    def scene(self, seed):
        """Complaints and number of contacts; an engine or a file that fails is a complaint."""
        folder, here = Path(f"seed{seed}"), os.getcwd()
        folder.mkdir(exist_ok=True)
        os.chdir(folder)
        try:
            scene = Scene(seed)
            scene.run()
            comparison = Comparison(scene)
            found, contacts = comparison.run(), comparison.contacts
            print(f"seed {seed}: {scene}, {comparison.compared} steps, {contacts} contacts, "
                  f"{'wrong' if found else 'right'}", flush=True)
        except Exception:  # goes on with the others
            found, contacts = [f"seed {seed}: {traceback.format_exc()}"], 0
            print(found[0], flush=True)
        finally:
            os.chdir(here)
        if not found:
            shutil.rmtree(folder)
        return found, contacts

    def scenes(self, seeds, until=math.inf):
        wrong, contacts = [], 0
        for seed in seeds:
            if time.monotonic() > until:
                break
            found, touched = self.scene(seed)
            contacts += touched
            wrong += found
        self.assertFalse(wrong, "\n".join(wrong))
        return contacts

    def test_scenes(self):
        if "ELLIPSOID_ADVERSARIAL_SEED" in os.environ:
            self.scenes([int(os.environ["ELLIPSOID_ADVERSARIAL_SEED"])])
        elif "ELLIPSOID_ADVERSARIAL_SECONDS" in os.environ:
            seconds = float(os.environ["ELLIPSOID_ADVERSARIAL_SECONDS"])
            self.scenes(range(int(os.environ.get("ELLIPSOID_ADVERSARIAL_FIRST", "100000")), 10 ** 9), time.monotonic() + seconds)
        else:
            contacts = self.scenes(SCENES)
            self.assertGreater(contacts, 3000)


if __name__ == "__main__":
    unittest.main(verbosity=2)
