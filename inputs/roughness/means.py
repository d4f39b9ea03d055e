"""Effective friction of sheared beds: a row per run, means over seeds, the friction that a smooth ellipsoid needs to
resist as a multi-sphere does, and a picture."""

import csv
import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np

INPUTS = Path(__file__).resolve().parent.parent
KEPT = INPUTS / "results" / "roughness"
COLUMNS = "strain friction solid_fraction stress_yy_Pa pressure_Pa inertial_number contacts_per_particle".split()
MEASURES = ("friction", "solid_fraction", "contacts_per_particle")
PILE_MEASURES = ("triangle_angle_deg", "repose_angle_deg", "porosity", "zpp")
START, BLOCK = 1.5, 0.5  # strain that is left out, and that after which values are independent
DRAWS = 20000


def run_row(folder):
    """Means over the strain behind START, and standard errors from blocks of strain."""
    record = json.loads((folder / "run.json").read_text())
    values = {"subspheres": "", "multicontact": "", **record["variables"]}
    table = dict(zip(COLUMNS, np.loadtxt(folder / "shear.txt").T))
    late = table["strain"] > START
    block = ((table["strain"][late] - START) / BLOCK).astype(int)
    row = {name: values[name] for name in ("surface", "subspheres", "multicontact", "mu", "seed")}
    for name in MEASURES:
        means = [table[name][late][block == k].mean() for k in range(block.max())]
        row[name] = float(np.mean(means))
        row[name + "_error"] = float(np.std(means, ddof=1) / np.sqrt(len(means)))
    return row


def read_rows(folder):
    if folder == "--kept":
        with open(KEPT / "runs.csv", newline="") as stream:
            return [{k: float(v) if k.split("_error")[0] in MEASURES else v for k, v in row.items()}
                    for row in csv.DictReader(stream)]
    finished = [f.parent for f in sorted(Path(folder).glob("*/run.json")) if json.loads(f.read_text()).get("finished")]
    return [run_row(f) for f in finished]


def means_of(rows):
    """{(surface, subspheres, multicontact, mu): (means {measure: value}, errors, runs)}.

    The error of a mean over seeds is the larger one of that within the runs and that between them."""
    groups = {}
    for row in rows:
        key = (row["surface"], int(row["subspheres"] or 0), row["multicontact"], float(row["mu"]))
        groups.setdefault(key, []).append(row)
    found = {}
    for key, runs in groups.items():
        means, errors = {}, {}
        for name in MEASURES:
            values = [r[name] for r in runs]
            within = np.sqrt(sum(r[name + "_error"] ** 2 for r in runs)) / len(runs)
            between = np.std(values, ddof=1) / np.sqrt(len(runs)) if len(runs) > 1 else 0.0
            means[name], errors[name] = float(np.mean(values)), float(max(within, between))
        found[key] = (means, errors, len(runs))
    return found


def friction_of_smooth(means, wanted, error, random):
    """Friction coefficients (DRAWS,) at which smooth ellipsoids have the effective friction `wanted`: between the values
    that were run by straight lines; NaN where it is outside of them."""
    smooth = sorted((key[3], m["friction"], e["friction"]) for key, (m, e, _) in means.items() if key[0] == "smooth")
    mu, middle, spread = (np.array(column) for column in zip(*smooth))
    drawn = np.maximum.accumulate(middle + spread * random.standard_normal((DRAWS, len(mu))), axis=1)
    targets = wanted + error * random.standard_normal(DRAWS)
    return np.array([np.interp(t, curve, mu, left=np.nan, right=np.nan) for t, curve in zip(targets, drawn)])


def at_friction(means, name, friction):
    smooth = sorted((key[3], m[name]) for key, (m, e, _) in means.items() if key[0] == "smooth")
    return np.interp(friction, *zip(*smooth))


def triangle_angle(dump):
    """Angle (deg) of the triangle beside the wall that has the medians of height and distance of all grains: those of a
    triangle are its height and base times 1 - 1/sqrt(2). Few grains that rolled away do not change it."""
    head, rows = dump.read_text().rsplit("ITEM: ATOMS ", 1)[1].split("\n", 1)
    columns = dict(zip(head.split(), np.loadtxt(rows.splitlines()).T))
    return float(np.degrees(np.arctan2(np.median(columns["y"]), np.median(columns["x"]))))


def pile_row(folder):
    """Angles of repose (deg), porosity and contacts per particle of a pile of piling.in."""
    with open(folder / "pile.csv", newline="") as stream:
        measured = list(csv.DictReader(stream))[-1]
    values = {"subspheres": "", **json.loads((folder / "run.json").read_text())["variables"]}
    return {**{name: values[name] for name in ("surface", "subspheres", "mu", "seed")},
            "triangle_angle_deg": triangle_angle(max(folder.glob("pile.*.dump"))),
            **{name: measured[name] for name in ("repose_angle_deg", "porosity", "zpp")}}


def piles_of(folder):
    if folder != "--kept":
        return [pile_row(f.parent) for f in sorted(Path(folder).glob("*/run.json"))
                if json.loads(f.read_text()).get("finished") and (f.parent / "pile.csv").exists()]
    with open(KEPT / "piles.csv", newline="") as stream:
        return list(csv.DictReader(stream))


def pile_groups(rows):
    """{(surface, subspheres, "", mu): values (runs, 4)} of both angles, porosity and contacts."""
    groups = {}
    for row in rows:
        key = (row["surface"], int(row["subspheres"] or 0), "", float(row["mu"]))
        groups.setdefault(key, []).append([float(row[n]) for n in PILE_MEASURES])
    return {key: np.array(values) for key, values in sorted(groups.items()) if len(values) > 1}


def errors_of(groups):
    return {key: v.std(axis=0, ddof=1) / np.sqrt(len(v)) for key, v in groups.items()}


def more_friction_of_pile(groups, key, measure, random):
    """How much more friction a smooth ellipsoid needs for the same angle, (DRAWS,): infinite beyond those that were run."""
    errors = errors_of(groups)
    angles = {k: ({"friction": v[:, measure].mean()}, {"friction": errors[k][measure]}, len(v)) for k, v in groups.items()}
    drawn = friction_of_smooth(angles, groups[key][:, measure].mean(), errors[key][measure], random)
    return np.where(np.isnan(drawn), np.inf, drawn) - key[3]


def interval(drawn, highest):
    """Middle, lower and upper end of 95 % of the draws, as text."""
    low, middle, high = (f"more than {highest:+.2f}" if np.isinf(value) else f"{value:+.2f}"
                         for value in np.sort(drawn)[[int(share * DRAWS) for share in (0.025, 0.5, 0.975)]])
    return f"{middle} ({low} to {high})"


def print_differences(means, rows):
    """By how much the friction that a pile's triangle asks for differs from what a sheared bed asks for; of a bed beyond
    the smooth ones that were run at least as much."""
    groups = pile_groups(rows)
    highest = max(key[3] for key in means if key[0] == "smooth")
    print("\n| N | mu | of the pile less that of the sheared bed |\n|---|---|---|")
    for key in groups:
        bed = means.get((key[0], key[1], "sum", key[3]))
        if key[0] == "smooth" or bed is None:
            continue
        random = np.random.default_rng(20100107)
        sheared = friction_of_smooth(means, bed[0]["friction"], bed[1]["friction"], random)
        pile = more_friction_of_pile(groups, key, 0, random) + key[3]
        print(f"| {key[1]} | {key[3]:g} | {interval(pile - np.where(np.isnan(sheared), highest, sheared), highest)} |")


def print_piles(rows):
    """Means with twice their standard errors, and by both angles how much more friction a smooth ellipsoid needs."""
    groups = pile_groups(rows)
    spread = errors_of(groups)
    highest = max(key[3] for key in groups if key[0] == "smooth")
    print("| grains | mu | runs | angle of the triangle, deg | fitted angle, deg | porosity | contacts | smooth, mu + more: more, "
          "by the triangle | by the fit |\n|---|---|---|---|---|---|---|---|---|")
    for key, v in groups.items():
        more = "- | -"
        if key[0] != "smooth":
            more = " | ".join(interval(more_friction_of_pile(groups, key, measure, np.random.default_rng(20100107)),
                                       highest - key[3]) for measure in (0, 1))
        name = "smooth" if key[0] == "smooth" else f"N = {key[1]}"
        print(f"| {name} | {key[3]:g} | {len(v)} | " + " | ".join(f"{m:.{d}f} +- {2 * e:.{d}f}" for m, e, d in zip(
            v.mean(axis=0), spread[key], (1, 1, 3, 2))) + f" | {more} |")


def outline_of(tools, subspheres):
    """Measures of the template's outline, a/b = 2.35."""
    text = subprocess.run([tools, "template", "--aspect", "2.35", "--subspheres", str(subspheres), "--csv", "-"],
                          check=True, capture_output=True, text=True).stdout
    return next(csv.DictReader(text.splitlines()))


def equivalent_rows(means, tools):
    """A row per multi-sphere: what a smooth ellipsoid needs, and what it is like then. Solid fractions are those of the
    bodies' own volumes; the runs count the ellipsoid's, by which masses are set."""
    random, rows = np.random.default_rng(20100107), []
    for key in sorted(means):
        surface, n, rule, mu = key
        if surface == "smooth":
            continue
        m, e, runs = means[key]
        friction = friction_of_smooth(means, m["friction"], e["friction"], random)
        outside = float(np.isnan(friction).mean())
        outline = outline_of(tools, n)
        row = {"subspheres": n, "multicontact": rule, "mu": mu, "forces": f"{rule}, mu = {mu:g}", "runs": runs,
               "outline_rq_b": float(outline["outline_rq_b"]), "area_shape_factor": float(outline["area_shape_factor"]),
               "perimeter_shape_factor": float(outline["perimeter_shape_factor"]),
               "friction": m["friction"], "friction_error": e["friction"],
               "solid_fraction": m["solid_fraction"] * float(outline["volume_ratio"]),
               "contacts_per_particle": m["contacts_per_particle"]}
        if outside < 0.025:
            low, middle, high = np.nanquantile(friction, [0.025, 0.5, 0.975]) - mu
            row |= {"more_friction": middle, "more_friction_low": low, "more_friction_high": high,
                    "more_friction_margin": 0.5 * (high - low),
                    "solid_fraction_smooth": at_friction(means, "solid_fraction", mu + middle),
                    "contacts_smooth": at_friction(means, "contacts_per_particle", mu + middle)}
        rows.append(row)
    return rows


def write_rows(file, rows):
    keys = list(dict.fromkeys(k for row in rows for k in row))
    with open(file, "w", newline="") as stream:
        writer = csv.DictWriter(stream, keys, lineterminator="\n")
        writer.writeheader()
        writer.writerows({k: f"{v:.6g}" if isinstance(v, float) else v for k, v in row.items()} for row in rows)


def print_tables(means, rows):
    print("| smooth, mu | runs | effective friction | solid fraction | contacts |\n|---|---|---|---|---|")
    for key in sorted(means):
        if key[0] == "smooth":
            m, e, runs = means[key]
            print(f"| {key[3]:g} | {runs} | {m['friction']:.3f} +- {2 * e['friction']:.3f} | {m['solid_fraction']:.3f} | "
                  f"{m['contacts_per_particle']:.2f} |")
    print("\n| N | forces | mu | runs | Rq / b | effective friction | solid fraction | smooth, mu + more: more | solid fraction |"
          "\n|---|---|---|---|---|---|---|---|---|")
    for r in rows:
        more = (f"{r['more_friction']:+.3f} ({r['more_friction_low']:+.3f} to {r['more_friction_high']:+.3f}) | "
                f"{r['solid_fraction_smooth']:.3f}" if "more_friction" in r else "outside of what was run | -")
        print(f"| {r['subspheres']} | {r['multicontact']} | {r['mu']:g} | {r['runs']} | {r['outline_rq_b']:.4f} | {r['friction']:.3f} +- "
              f"{2 * r['friction_error']:.3f} | {r['solid_fraction']:.3f} | {more} |")


def main(folder, pictures=None):
    """Tables of a folder of runs, with picture there, or of the runs that are kept, with picture in a folder if one is
    named."""
    tools = Path(os.environ.get("ELLIPSOID_BIN", INPUTS.parent / "build" / "bin")) / "ellipsoid-post"
    rows = read_rows(folder)
    means = means_of(rows)
    if len([key for key in means if key[0] == "smooth"]) < 2:
        sys.exit("roughness.sh: fewer than two runs of smooth ellipsoids are finished; nothing to compare with")
    found = equivalent_rows(means, tools)
    print_tables(means, found)
    if folder == "--kept":
        print()
        print_piles(piles_of(folder))
        print_differences(means, piles_of(folder))
        if not pictures:
            return
    out = Path(pictures or folder)
    out.mkdir(parents=True, exist_ok=True)
    write_rows(out / "runs.csv", rows)
    write_rows(out / "equivalent.csv", found)
    if any("more_friction" in r for r in found):
        subprocess.run([tools, "plot", "curve", out / "equivalent.csv", "--x", "outline_rq_b", "--y", "more_friction",
                        "--margin", "more_friction_margin", "--group", "forces", "-o", out / "roughness.svg",
                        "--title", "Friction that a smooth ellipsoid needs more (a/b = 2.35)"], check=True)


if __name__ == "__main__":
    if sys.argv[2:] == ["--piles"]:
        write_rows(Path(sys.argv[1]) / "piles.csv", piles_of(sys.argv[1]))
        print_piles(piles_of(sys.argv[1]))
    else:
        main(sys.argv[1], sys.argv[2] if sys.argv[1] == "--kept" and len(sys.argv) > 2 else None)
