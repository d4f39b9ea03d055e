# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""What the benchmark writes for figures 17 and 18 is what `ellipsoid-post plot` draws; the page's costs of clumps are those
that are kept; benchmarks begin outside the tests as well."""
import csv
import os
import subprocess
import sys
from types import SimpleNamespace

from _synthetic import post, rows_of

sys.path.insert(0, os.path.join(os.environ["ELLIPSOID_SOURCE"], "tests", "bench"))
from figures import figure_rows, write_figures  # noqa: E402


def sample(**figures):
    return SimpleNamespace(figures=figures)


def check_costs_of_clumps():
    source = os.environ["ELLIPSOID_SOURCE"]
    with open(os.path.join(source, "tests", "bench", "kept", "clumps.csv"), newline="", encoding="utf8") as file:
        kept = {(row["case"], row["spheres"]): row for row in csv.DictReader(file)}
    with open(os.path.join(source, "src_liggghts", "doc", "clumps.md"), encoding="utf8") as file:
        page = file.read()
    for spheres in ("17", "55", "200"):
        cells = [spheres]
        for case in ("falling", "dense"):
            row = kept.pop((case, spheres))
            ratio = float(row["ratio"])
            assert abs(ratio - float(row["fix_multisphere_ns"]) / float(row["clump_ns"])) < 0.01 * ratio, row
            cells += [row["fix_multisphere_ns"], row["clump_ns"], f"{ratio:.2g}"]
        assert f"| {' | '.join(cells)} |" in page, cells
    assert not kept, kept


def check_help():
    """By a shell that knows nothing of the tests."""
    folder = os.path.join(os.environ["ELLIPSOID_SOURCE"], "tests", "bench")
    bare = {name: value for name, value in os.environ.items() if not name.startswith(("ELLIPSOID_", "PYTHONPATH"))}
    for name in "bench", "common_benchmark", "ranks", "same_bits", "start":
        text = subprocess.run([sys.executable, os.path.join(folder, name + ".py"), "--help"], env=bare, check=True,
                              capture_output=True, text=True).stdout
        assert text.startswith("usage: "), (name, text)


def main():
    check_help()
    check_costs_of_clumps()
    results = {"sphere": ([40.0], [1.0], sample()),
               "smooth": ([170.0, 190.0], [4.25, 4.75], sample(potential=1.5)),
               "multisphere 3": ([150.0], [3.5], sample(potential=4.0)),
               "multisphere 17": ([250.0, 260.0], [6.0, 6.5], sample(potential=28.0)),
               "superquadric": ([1000.0], [25.0], sample())}
    write_figures("figures.csv", figure_rows(results))
    rows = rows_of("summary", "figures.csv", "--quantity",
                   "relative_cpu_time,potential_contacts_per_particle")
    means = {(row["surface"], row["subspheres"]): (float(row["relative_cpu_time_mean"]),
                                                   float(row["potential_contacts_per_particle_mean"]))
             for row in rows}
    assert means == {("smooth", "-"): (4.5, 1.5), ("multisphere", "3"): (3.5, 4.0),
                     ("multisphere", "17"): (6.25, 28.0)}, means
    for number, ours in (17, 2), (18, 2):
        post("plot", number, "figures.csv", "-o", f"figure{number}.svg")
        with open(f"figure{number}.svg", encoding="utf8") as file:
            text = file.read()
        # filled circles: our points and the one of the legend
        assert text.count("<circle") == ours + 1, (number, text.count("<circle"))
        assert "ellipse (this work)" in text and "ellipse (paper)" in text


main()
