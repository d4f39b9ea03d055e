"""Costs of the compaction as CSV for `ellipsoid-post plot 17` and `plot 18`."""

import csv

FIGURE_COLUMNS = ("surface", "subspheres", "relative_cpu_time", "potential_contacts_per_particle")
CASE = "compaction"  # the paper's measure of computing time, on one rank


def figure_rows(results):
    """A row per run of smooth and multi-sphere particles, in the order of FIGURE_COLUMNS.

    results: {shape's name: (costs, ratios to spheres, last sample)}; the number of potential contacts
    is the same in all repeats.
    """
    for name, (_, ratios, sample) in results.items():
        surface, _, count = name.partition(" ")
        if surface not in ("smooth", "multisphere"):
            continue
        potential = sample.figures.get("potential")
        for ratio in ratios:
            yield (surface, count, repr(ratio), "" if potential is None else repr(float(potential)))


def write_figures(file, rows):
    with open(file, "w", newline="", encoding="ascii") as text:
        csv.writer(text).writerows([FIGURE_COLUMNS, *rows])
