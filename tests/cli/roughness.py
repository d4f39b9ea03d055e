# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""inputs/roughness.sh on runs that are made up: beds whose friction is known, with noise that forgets itself after a
strain of 0.1; the list of its runs; the tables of the page roughness.md."""
import csv
import json
import os
import subprocess
from pathlib import Path

import numpy as np

from _synthetic import rows_of

SOURCE = Path(os.environ["ELLIPSOID_SOURCE"])
SCRIPT = SOURCE / "inputs" / "roughness.sh"
MORE, NOISE = 0.12, 0.03


def friction(mu):
    return 0.2 + 0.8 * mu  # straight, as between the values that are run


def make_run(folder, variables, level, seed):
    """A run of shear.in: the first strain is on its way to the level."""
    random = np.random.default_rng(seed)
    strain = np.arange(0.0, 5.0, 0.01)
    noise, value = [], 0.0
    for _ in strain:
        value = 0.9 * value + NOISE * np.sqrt(1.0 - 0.9 ** 2) * random.standard_normal()
        noise.append(value)
    rows = np.zeros((len(strain), 7))
    rows[:, 0], rows[:, 1] = strain, level * np.minimum(1.0, strain / 1.2) + noise
    rows[:, 2], rows[:, 6] = 0.7 - 0.2 * float(variables["mu"]), 5.0
    folder.mkdir(parents=True)
    np.savetxt(folder / "shear.txt", rows, header="strain friction ...")
    (folder / "run.json").write_text(json.dumps({"finished": True, "variables": variables}))


def means(folder, expect=0):
    done = subprocess.run(["bash", SCRIPT, folder, "--means"], capture_output=True, text=True)
    assert done.returncode == expect, done.stdout + done.stderr
    return done.stdout + done.stderr


def check_known_beds():
    for k, mu in enumerate((0.1, 0.3, 0.5, 0.7)):
        for seed in (1, 2):
            make_run(Path(f"beds/smooth_{mu}_{seed}"), {"surface": "smooth", "mu": str(mu), "seed": str(seed)}, friction(mu),
                     10 * k + seed)
    for n, level in ((5, friction(0.3 + MORE)), (3, friction(0.9))):
        for seed in (1, 2):
            make_run(Path(f"beds/ms_{n}_{seed}"), {"surface": "multisphere", "subspheres": str(n), "multicontact": "sum",
                                                  "mu": "0.3", "seed": str(seed)}, level, 100 * n + seed)
    text = means("beds")
    assert "outside of what was run" in text, text
    rows = {row["subspheres"]: row for row in csv.DictReader(open("beds/equivalent.csv"))}
    found, low, high = (float(rows["5"][key]) for key in ("more_friction", "more_friction_low", "more_friction_high"))
    # 14 blocks of strain 0.5 a mean; noise of a block: 0.03 sqrt(2 * 0.1 / 0.5)
    deviation = NOISE * np.sqrt(0.4 / 14.0) * np.sqrt(1.5) / 0.8
    assert abs(found - MORE) < 4.0 * deviation, (found, deviation)
    assert low < MORE < high and 1.5 * deviation < high - low < 9.0 * deviation, (low, high, deviation)
    assert rows["3"]["more_friction"] == ""
    (outline,) = rows_of("template", "--aspect", 2.35, "--subspheres", 5)
    own_volume = (0.7 - 0.2 * 0.3) * float(outline["volume_ratio"])
    assert abs(float(rows["5"]["solid_fraction"]) - own_volume) < 1e-5
    assert abs(float(rows["5"]["solid_fraction_smooth"]) - (0.7 - 0.2 * (0.3 + found))) < 1e-5
    assert Path("beds/roughness.svg").stat().st_size > 1000


def make_pile(folder, variables, slope, porosity, seed):
    """A triangle of grains beside the wall, one in twenty of them far away, and a fit that has the same angle."""
    random = np.random.default_rng(seed)
    folder.mkdir(parents=True)
    x, y = random.random((2, 10000))
    inside = x + y < 1.0
    x, y = x[inside][:4000], y[inside][:4000] * slope
    x[::20] += 3.0
    rows = "".join(f"{k + 1} {a!r} {b!r}\n" for k, (a, b) in enumerate(zip(x.tolist(), y.tolist())))
    for step, text in ((10, "1 1 1\n2 1 1\n"), (200, rows)):  # the last one counts
        (folder / f"pile.{step:010}.dump").write_text("ITEM: ATOMS id x y\n" + text)
    (folder / "pile.csv").write_text(f"repose_angle_deg,porosity,zpp\n0,0,0\n{np.degrees(np.arctan(slope))},{porosity},3.0\n")
    (folder / "run.json").write_text(json.dumps({"finished": True, "variables": variables}))


def check_known_piles():
    """Angles of triangles that are known; Δμ between two smooth ones."""
    for mu, slope in (("0.3", 0.3), ("0.5", 0.5)):
        for seed in range(4):
            make_pile(Path(f"heaps/smooth_{mu}_{seed}"), {"surface": "smooth", "mu": mu, "seed": str(seed)}, slope + 0.01 * seed, 0.15,
                      seed)
    for seed in range(4):
        make_pile(Path(f"heaps/ms_{seed}"), {"surface": "multisphere", "subspheres": "5", "mu": "0.3", "seed": str(seed)},
                  0.4 + 0.01 * seed, 0.2, 10 + seed)
    done = subprocess.run(["/usr/bin/python3", "-B", SOURCE / "inputs" / "roughness" / "means.py", "heaps", "--piles"],
                          capture_output=True, text=True, check=True)
    rows = {row[0].strip() + row[1].strip(): row for row in (line.split("|")[1:-1] for line in done.stdout.splitlines()[2:])}
    multisphere, smooth = rows["N = 50.3"], rows["smooth0.3"]
    # one grain in twenty beyond all others moves the median of distances from its half to 0.5 / 0.95 of the rest
    wanted = 0.315 * (1.0 - np.sqrt(0.5)) / (1.0 - np.sqrt(1.0 - 0.5 / 0.95))
    assert abs(float(smooth[3].split()[0]) - np.degrees(np.arctan(wanted))) < 0.6, smooth  # 0.2 by 16,000 random grains
    assert abs(float(smooth[4].split()[0]) - np.degrees(np.arctan(0.315))) < 0.1, smooth
    for column in (7, 8):
        assert abs(float(multisphere[column].split()[0]) - 0.1) < 0.03, multisphere


def check_few_runs():
    make_run(Path("few/smooth"), {"surface": "smooth", "mu": "0.1", "seed": "1"}, 0.3, 1)
    text = means("few", expect=1)
    assert "fewer than two runs" in text and text.count("\n") == 1, text


def check_list():
    done = subprocess.run(["bash", SOURCE / "inputs" / "campaign.sh", "--count", "--input", SOURCE / "inputs" / "shear.in",
                           "--list", SOURCE / "inputs" / "roughness" / "runs.txt"], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "75", done.stdout


def check_page():
    """The table of the template is the tool's, rounded; that of the runs is what the kept runs give."""
    page = (SOURCE / "src_liggghts" / "doc" / "roughness.md").read_text()
    rows = rows_of("template", "--aspect", 2.35, "--subspheres", "3,5,7,9,11,13,17")
    for row in rows:
        cells = [f"{float(row[key]):.4f}" for key in
                 ("area_shape_factor", "perimeter_shape_factor", "outline_rms_b", "outline_rq_b")]
        assert f"| {row['subspheres']} | " + " | ".join(cells) + " |" in page, row
    kept = subprocess.run(["bash", SOURCE / "inputs" / "roughness.sh", "--kept"], capture_output=True, text=True, check=True)
    for line in kept.stdout.splitlines():
        assert line in page, line


check_known_beds()
check_known_piles()
check_few_runs()
check_list()
check_page()
