# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""Radial profiles of `fields`: stress, density and momentum over rings about an axis.

Oracle: the mean over a ring of what one segment or one particle leaves there, as a double sum over the ring's angle and along
the segment (numpy, Gauss-Legendre); along the axis, whose whole period counts, the function is integrated first. A hoop
under pressure from spokes outside has the closed forms r sigma_rr = N F / 2 pi L along the spokes and, at every radius inside their
ends, d(r sigma_rr)/dr = sigma_tt."""
import math

import numpy as np

from _synthetic import COLUMNS, json_of, post, write

SEED = 18280101
WIDTH, LENGTH, RADIUS = 1e-3, 6e-3, 8e-3
SLICES = 16
NAMES = "i j px py pz fx fy fz".split()
LISTS = ("--contacts", "pairs.local", "--id-columns", "i", "j", "--point-columns", "px", "py", "pz", "--force-columns", "fx", "fy", "fz")
AXES = {"z": (0, 1, 2), "x": (1, 2, 0), "y": (2, 0, 1)}  # of the section and of the cylinder


def lucy(r):
    """Scaled to integral 1: 105 / 16 pi (2 w)^3 of Lucy's function of q = r / 2 w."""
    q = np.minimum(r / (2 * WIDTH), 1.0)
    return 105 / (16 * math.pi * (2 * WIDTH) ** 3) * (1 + 3 * q) * (1 - q) ** 3


def gaussian(r):
    x, weights = np.polynomial.legendre.leggauss(400)
    shells = 1.5 * WIDTH * (x + 1)
    whole = 1.5 * WIDTH * np.sum(weights * 4 * math.pi * shells ** 2 * np.exp(-0.5 * (shells / WIDTH) ** 2))
    return np.where(r <= 3 * WIDTH, np.exp(-0.5 * (r / WIDTH) ** 2) / whole, 0.0)


class Line:
    """The function integrated along the axis, over the distance from it."""

    def __init__(self, function, reach):
        self.at = np.linspace(0, reach, 4001)
        x, weights = np.polynomial.legendre.leggauss(64)
        half = np.sqrt(np.maximum(reach ** 2 - self.at ** 2, 0))
        z = half[:, None] * 0.5 * (x + 1)
        self.value = 2 * np.sum(0.5 * half[:, None] * weights * function(np.hypot(self.at[:, None], z)), axis=1)

    def __call__(self, distance):
        return np.interp(distance, self.at, self.value, right=0.0)


def ring_mean(line, radius, points, weights, tensor):
    """Mean over the ring of sources at points (x, y) with weights, tensor in the ring's own axes r, t, a; per length of the axis."""
    angle = (np.arange(4000) + 0.5) * 2 * math.pi / 4000
    place = radius * np.column_stack([np.cos(angle), np.sin(angle)])
    share = np.zeros(len(angle))
    for point, weight in zip(points, weights):
        share += weight * line(np.linalg.norm(place - point, axis=1))
    c, s, zero = np.cos(angle), np.sin(angle), np.zeros_like(angle)
    turn = np.array([[c, s, zero], [-s, c, zero], [zero, zero, zero + 1]])  # rows: r, t, a
    if tensor.ndim == 1:
        return np.einsum("an,ijn,j->i", share[None, :] / len(angle), turn, tensor) / LENGTH
    return np.einsum("n,ikn,jln,kl->ij", share / len(angle), turn, turn, tensor) / LENGTH


def expected_stress(line, radius, contacts, places):
    x, weights = np.polynomial.legendre.leggauss(24)
    total = np.zeros((3, 3))
    for i, j, point, force in contacts:
        for body, f in ((i, force), (j, -force)):
            b = places[body] - point
            along = point + 0.5 * (x[:, None] + 1) * b
            total += ring_mean(line, radius, along[:, :2], 0.5 * weights, np.outer(f, b))
    return total


def write_scene(places, contacts, axis, masses, velocities):
    """In a box that repeats along the axis; the section's axes are those that follow it."""
    order = np.argsort(AXES[axis])
    put = lambda v: [float(x) for x in np.asarray(v)[order]]
    words = " ".join("pp" if k == AXES[axis][2] else "ff" for k in range(3))
    box = "".join(f"0 {LENGTH!r}\n" if k == AXES[axis][2] else "-0.05 0.05\n" for k in range(3))
    head = lambda what, n: f"ITEM: TIMESTEP\n0\nITEM: NUMBER OF {what}\n{n}\nITEM: BOX BOUNDS {words}\n{box}"
    rows = ""
    for k, place in enumerate(places):
        values = (k + 1, 1, float(masses[k]), *put(place), *put(velocities[k]), 0, 0, 0, 1, 0, 0, 0, 5e-4, 5e-4, 5e-4, 0)
        rows += " ".join(map(repr, values)) + "\n"
    write("scene.dump", head("ATOMS", len(places)) + "ITEM: ATOMS " + " ".join(COLUMNS) + "\n" + rows)
    lines = "".join(" ".join(map(repr, (i + 1, j + 1, *put(point), *put(force)))) + "\n" for i, j, point, force in contacts)
    write("pairs.local", head("ENTRIES", len(contacts)) + "ITEM: ENTRIES " + " ".join(NAMES) + "\n" + lines)


def profile(kernel, axis, slices=SLICES, radius=RADIUS):
    return json_of("fields", "scene.dump", "--kernel", kernel, "--width", WIDTH, *LISTS, "--profile", "radius", "--axis", axis,
                   "--slices", slices, "--cylinder", 0, 0, radius, 0, LENGTH)


def stress(row, axis):
    names = ("r", "t", axis)
    return np.array([[row[f"contact_stress_{a}{b}_Pa"] for b in names] for a in names])


def random_network(rng):
    places = np.column_stack([rng.uniform(-6e-3, 6e-3, (30, 2)), rng.uniform(0, LENGTH, 30)])
    contacts = []
    for _ in range(30):
        i, j = rng.choice(30, 2, replace=False)
        between = places[j] - places[i]
        if abs(between[2]) > 0.45 * LENGTH or np.linalg.norm(between) > 5e-3:
            continue
        point = places[i] + 0.4 * between + rng.normal(size=3) * 2e-4
        contacts.append((i, j, point, -between * 700 + rng.normal(size=3) * 0.3))
    assert len(contacts) > 4
    return places, contacts


def check_random(rng):
    places, contacts = random_network(rng)
    masses, velocities = rng.uniform(1e-5, 3e-5, 30), rng.normal(size=(30, 3))
    # a ring's mean is a sum over points w/2 apart: lucy's third derivative jumps in its middle and at its end (1.3e-4 is found), the
    # cut of the gaussian is 0.011 of its middle
    for kernel, line, off in (("lucy", Line(lucy, 2 * WIDTH), 4e-4), ("gaussian", Line(gaussian, 3 * WIDTH), 4e-3)):
        for axis in AXES:
            write_scene(places, contacts, axis, masses, velocities)
            rows = profile(kernel, axis)
            assert len(rows) == SLICES
            if axis == "z":
                picked = rows[::3]
                truths = [expected_stress(line, row["radius_m"], contacts, places) for row in picked]
                densities = [sum(ring_mean(line, row["radius_m"], p[None, :2], [m], np.eye(3))[2, 2] for p, m in zip(places, masses))
                             for row in picked]
                momenta = [sum(ring_mean(line, row["radius_m"], p[None, :2], [m], v) for p, m, v in zip(places, masses, velocities))
                           for row in picked]
            scale = max(np.abs(t).max() for t in truths)
            flow = max(np.abs(p).max() for p in momenta)
            for row, truth, density, momentum in zip(rows[::3], truths, densities, momenta):
                assert np.abs(stress(row, axis) - truth).max() <= off * scale, (kernel, axis, row["radius_m"], stress(row, axis), truth)
                assert abs(row["density_kg_per_m3"] - density) <= off * max(densities), (kernel, axis, row["radius_m"])
                found = np.array([row[f"momentum_{a}_kg_per_m2_s"] for a in ("r", "t", axis)])
                assert np.abs(found - momentum).max() <= off * flow, (kernel, axis, found, momentum)


def check_pressurised_cylinder():
    """Spokes between radii of 3 and 7 mm press with F on each of M places of a hoop at 3 mm, in layers; the hoop holds them."""
    spokes, layers, force, inner, outer = 18, 4, 2.0, 3e-3, 7e-3
    chord = 2 * inner * math.sin(math.pi / spokes)
    hoop = force * inner / chord  # balance of a place: 2 H sin(pi / M) = F
    places, contacts = [], []
    for layer in range(layers):
        z = (layer + 0.5) * LENGTH / layers
        for k in range(spokes):
            out = np.array((math.cos(2 * math.pi * k / spokes), math.sin(2 * math.pi * k / spokes), 0.0))
            places += [inner * out + (0, 0, z), outer * out + (0, 0, z)]
            contacts.append((len(places) - 2, len(places) - 1, 0.5 * (places[-2] + places[-1]), -force * out))
    for layer in range(layers):
        for k in range(spokes):
            i, j = 2 * (layer * spokes + k), 2 * (layer * spokes + (k + 1) % spokes)
            contacts.append((i, j, 0.5 * (places[i] + places[j]), -hoop * (places[j] - places[i]) / chord))
    count, number, slices, radius = len(places), spokes * layers, 400, 1e-2
    write_scene(np.array(places), contacts, "z", np.full(count, 1e-5), np.zeros((count, 3)))
    rows = profile("lucy", "z", slices, radius)
    r = np.array([row["radius_m"] for row in rows])
    rr, tt, rt = (np.array([row[f"contact_stress_{k}_Pa"] for row in rows]) for k in ("rr", "tt", "rt"))
    load, step = number * force / (2 * math.pi * LENGTH), radius / slices  # load: r sigma_rr along the spokes (N/m)
    # integrals over the section are sums of f b, whatever the function
    whole = load * (outer - inner) + number * hoop * chord / (2 * math.pi * LENGTH)
    assert abs(np.sum(r * (rr + tt)) * step / whole - 1) < 1e-3, (np.sum(r * (rr + tt)) * step, whole)
    line = Line(lucy, 2 * WIDTH)
    for place in (80, 120, 200, 260):
        truth = number * expected_stress(line, r[place], [contacts[0], contacts[-1]], places)
        for found, component in ((rr, (0, 0)), (tt, (1, 1))):
            assert abs(found[place] - truth[component]) < 4e-4 * np.abs(truth).max(), (r[place], found[place], truth)
    # smeared over w, 1 / r changes in the order of w^2 / r^2: 2.3 % at 5 mm
    assert abs(rr[200] * r[200] / load - 1) < 0.03 and np.abs(rt).max() < 4e-4 * rr.max()
    # only the spokes' outer ends are not in balance: as far as they do not reach, d(r sigma_rr)/dr = sigma_tt
    balanced = r < outer - 2 * WIDTH - step
    off = np.abs(np.gradient(r * rr, step) - tt)[balanced][2:-2]
    assert off.max() < 4e-3 * np.abs(tt).max(), (off.max(), np.abs(tt).max())
    # and summed up over the hoop: its tension's moment is the pressure outside times the radius, int sigma_tt dr = r sigma_rr
    assert abs(np.sum(tt[balanced]) * step / (r * rr)[balanced][-1] - 1) < 2e-3


def main():
    print("seed", SEED)
    check_random(np.random.default_rng(SEED))
    check_pressurised_cylinder()
    # planes across x of a tilted box that does not repeat have no common area
    box = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS xy xz yz ff ff ff\n0 1.5 0.5\n0 1 0\n0 1 0\nITEM: ATOMS id mass x y z radius\n1 1 0.7 0.5 0.5 0.1\n"
    out, error = post("fields", write("tilted.dump", box), "--profile", "x", expect=1)
    assert not out and "tilted" in error and "--box" in error, (out, error)
    (low, *_, high) = json_of("fields", "tilted.dump", "--profile", "y", "--slices", 5, "--width", 0.1)
    assert low["density_kg_per_m3"] == high["density_kg_per_m3"]


main()
