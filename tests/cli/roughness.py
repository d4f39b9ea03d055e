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


def check_few_runs():
    make_run(Path("few/smooth"), {"surface": "smooth", "mu": "0.1", "seed": "1"}, 0.3, 1)
    text = means("few", expect=1)
    assert "fewer than two runs" in text and text.count("\n") == 1, text


def check_list():
    done = subprocess.run(["bash", SOURCE / "inputs" / "campaign.sh", "--count", "--input", SOURCE / "inputs" / "shear.in",
                           "--list", SOURCE / "inputs" / "roughness" / "runs.txt"], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "57", done.stdout


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
check_few_runs()
check_list()
check_page()
