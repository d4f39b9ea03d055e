# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""inputs/generators.sh: its table is the page's, and its measures are those of points, in numpy."""
import os
import pathlib
import subprocess

import numpy as np

from _synthetic import post

SOURCE = pathlib.Path(os.environ["ELLIPSOID_SOURCE"])
PAGE = SOURCE / "src_liggghts" / "doc" / "multisphere_templates.md"
LISTS = SOURCE / "inputs" / "generators"
COLUMNS = ("shape", "N", "generator", "in_exactly_one", "volume", "surface", "to_spheres", "mean_to_spheres", "to_body",
           "mean_to_body", "I_xx", "I_yy", "I_zz")


def cells_of(line):
    return [cell.strip() for cell in line.strip().strip("|").split("|")]


def sphere_points(count):
    """Even over the unit sphere, (count, 3)."""
    k = np.arange(count)
    z, angle = 1.0 - (2.0 * k + 1.0) / count, 2.399963229728653 * k
    return np.stack([np.sqrt(1.0 - z * z) * np.cos(angle), np.sqrt(1.0 - z * z) * np.sin(angle), z], 1)


def in_union(points, centres, radii):
    inside = np.zeros(len(points), bool)
    for centre, radius in zip(centres, radii):
        inside |= ((points - centre) ** 2).sum(1) < radius * radius
    return inside


def check_volumes(row, axes, centres, radii):
    """Random points: volume in exactly one, volume, moments, within five standard deviations and the last digit."""
    low = np.minimum(-axes, (centres - radii[:, None]).min(0))
    high = np.maximum(axes, (centres + radii[:, None]).max(0))
    points = np.random.default_rng(5).uniform(low, high, (300000, 3))
    spheres, body = in_union(points, centres, radii), ((points / axes) ** 2).sum(1) < 1.0
    scale = np.prod(high - low) / (4.0 / 3.0 * np.pi * np.prod(axes))
    for name, values in (("in_exactly_one", spheres != body), ("volume", spheres.astype(float) - body)):
        deviation = scale * np.std(values) / np.sqrt(len(points))
        assert abs(float(row[name]) / 100.0 - scale * values.mean()) < 5.0 * deviation + 1e-4, (row, name)
    apart = points - points[spheres].mean(0)
    for k, name in enumerate(("I_xx", "I_yy", "I_zz")):
        others = [m for m in range(3) if m != k]
        distances = (apart[:, others] ** 2).sum(1) * spheres
        exact = (axes[others] ** 2).sum() / 5.0
        deviation = scale * np.std(distances) / exact / np.sqrt(len(points))
        found = scale * distances.mean() / exact
        assert abs(1.0 + float(row[name]) / 100.0 - found) < 5.0 * deviation + 1e-3, (row, name)


def check_surfaces(row, axes, centres, radii):
    """Uncovered points of the spheres: surface; points of the ellipsoid outside of all spheres: distances."""
    area = 0.0
    for k, (centre, radius) in enumerate(zip(centres, radii)):
        others = np.arange(len(radii)) != k
        points = centre + radius * sphere_points(40000)
        area += 4.0 * np.pi * radius ** 2 * (~in_union(points, centres[others], radii[others])).mean()
    sphere = sphere_points(40000)
    stretch = np.prod(axes) * np.linalg.norm(sphere / axes, axis=1)
    assert abs(1.0 + float(row["surface"]) / 100.0 - area / (4.0 * np.pi * stretch.mean())) < 2e-3, (row, area)
    points = sphere * axes
    gaps = np.min([np.linalg.norm(points - c, axis=1) - r for c, r in zip(centres, radii)], axis=0)
    largest = float(row["to_spheres"])
    assert largest > gaps.max() - 1e-4, (row, gaps.max())  # spheres that stick out may be farther
    if gaps.min() > -1e-3:  # inscribed
        assert largest < 1.02 * gaps.max() + 2e-3, (row, gaps.max())
        assert abs(float(row["mean_to_spheres"]) - np.average(np.abs(gaps), weights=stretch)) < 1e-3, row


def spheres_of(row, axes):
    """Centres (N, 3), radii (N,) of a row of the table."""
    if row["generator"].startswith("`"):
        text = post("template", "--semiaxes", *axes, "--subspheres", row["N"], "--spacing", row["generator"].strip("`"),
                    "--spheres", "-")[0]
        values = np.array([line.split(",")[1:] for line in text.splitlines()[1:]], float)
    else:
        shape = {"2.35 : 1 : 1": "prolate_2.35", "5 : 1 : 1": "prolate_5", "2.5 : 2.5 : 1": "oblate",
                 "2.5 : 1.75 : 1": "triaxial"}[row["shape"]]
        name = f"{row['generator'].split(' (')[0].replace(', ', '_')}_{shape}_{row['N']}.csv"
        values = np.loadtxt(LISTS / name, delimiter=",", skiprows=2)
    assert len(values) == int(row["N"]), row
    values = np.unique(values, axis=0)
    return values[:, :3], values[:, 3]


def check_best(rows):
    """Ours have the smallest volume in exactly one, as the page says."""
    for key in {(row["shape"], row["N"]) for row in rows}:
        group = [row for row in rows if (row["shape"], row["N"]) == key]
        ours = min(float(row["in_exactly_one"]) for row in group if row["generator"].startswith("`"))
        others = min(float(row["in_exactly_one"]) for row in group if not row["generator"].startswith("`"))
        assert ours < (0.76 if key[0].startswith("2.5") else 1.0) * others, (key, ours, others)


def main():
    done = subprocess.run(["bash", SOURCE / "inputs" / "generators.sh"], capture_output=True, text=True, check=True)
    lines = done.stdout.splitlines()
    page = set(PAGE.read_text().splitlines())
    old = [line for line in lines if line not in page]
    assert not old, "the page's table is old, run inputs/generators.sh: " + "\n".join(old)
    rows = [dict(zip(COLUMNS, cells_of(line))) for line in lines[2:]]
    measured = [row for row in rows if not row["in_exactly_one"].startswith("refused")]
    assert len(rows) >= 80 and len(measured) >= len(rows) - 5, (len(rows), len(measured))
    assert {row["generator"] for row in measured} >= {"Favier", "Ferellec, McDowell", "Euclid3D", "MSS"}
    check_best(measured)
    for row in measured[::7]:
        axes = np.array([float(axis) for axis in row["shape"].split(" : ")])
        centres, radii = spheres_of(row, axes)
        check_volumes(row, axes, centres, radii)
        check_surfaces(row, axes, centres, radii)
    print(f"{len(rows)} sets, {len(measured[::7])} of them against points")


main()
