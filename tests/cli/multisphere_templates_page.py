"""The tables of src_liggghts/doc/multisphere_templates.md are what the commands on the page print.

Every cell is compared with the tool's output, rounded to the digits of the cell; a table that has
lost rows, and a value that was changed by one in its last digit, must be noticed.
"""

import math
import os
import pathlib
import re
import shlex

from _synthetic import rows_of

PAGE = (pathlib.Path(os.environ["ELLIPSOID_SOURCE"]) / "src_liggghts" / "doc" /
        "multisphere_templates.md")
RATIOS = {"Relative area": "area_ratio", "Relative perimeter": "perimeter_ratio",
          "Relative volume": "volume_ratio"}


def tables(text):
    """[[cells of a row]] of each table, without the line below the heads."""
    found = re.findall(r"(?:^\|.*\n)+", text, re.MULTILINE)
    return [[[cell.strip() for cell in line.strip("|\n").split("|")]
             for k, line in enumerate(table.splitlines()) if k != 1] for table in found]


def commands(text):
    """Arguments of the commands in the code blocks."""
    return [shlex.split(line)[1:] for block in re.findall(r"```bash\n(.*?)```", text, re.DOTALL)
            for line in block.splitlines()]


def wanted_comparison(rows):
    """Cells of the first table from the rows of the tool."""
    keys = list(rows[0])
    return [[f"{float(row['aspect_ratio']):g}"] + [row[key] for key in keys[1:]] for row in rows]


def wanted_ratios(rows, key):
    """Cells of a table of figure 5: a row for each N, a column for each aspect ratio."""
    aspects = sorted({float(row["aspect_ratio"]) for row in rows})
    counts = sorted({int(row["subspheres"]) for row in rows})
    values = {(float(r["aspect_ratio"]), int(r["subspheres"])): float(r[key]) for r in rows}
    return [[str(n)] + [f"{values[s, n]:.4f}" if (s, n) in values else "-" for s in aspects]
            for n in counts]


def complaints(text, comparison, geometry):
    """Differences between the page and the tool, one line each."""
    comparison_table, *ratio_tables = tables(text)
    pairs = [("spheres needed", comparison_table[1:], wanted_comparison(comparison))]
    titles = re.findall(r"^(Relative \w+)[^\n]*:$", text, re.MULTILINE)
    if titles != list(RATIOS) or len(ratio_tables) != len(RATIOS):
        return [f"the tables of figure 5 are {titles}, wanted {list(RATIOS)}"]
    pairs += [(title, table[1:], wanted_ratios(geometry, RATIOS[title]))
              for title, table in zip(titles, ratio_tables)]
    return [f"{title}: the page has {found}, the tool {expected}"
            for title, found_rows, expected_rows in pairs
            for found, expected in zip(found_rows + [None] * len(expected_rows),
                                       expected_rows + [None] * len(found_rows))
            if found != expected]


def needed_cells(text, spacing):
    """{(b/a, c/a): N} of a table of numbers needed."""
    table = next(t for t in tables(text) if t[0][0] == f"b/a, {spacing}")
    ratios = [float(re.sub("c/a = ", "", head)) for head in table[0][1:]]
    return {(float(row[0]), c): cell for row in table[1:] for c, cell in zip(ratios, row[1:])}


def number(cell):
    return math.inf if cell == "> 999" else int(cell)


def check_needed(text):
    """The cells that are cheap to find again, and the order of the others."""
    (row,) = rows_of("template", "--needed", "0.01", "--ratios", "0.8")
    for spacing in ("medial", "minimax_volume"):
        cells = needed_cells(text, spacing)
        assert cells[0.8, 0.8] == row[spacing], (spacing, cells[0.8, 0.8], row)
        for (b, c), cell in cells.items():
            assert (cell == "-") == (c > b), (b, c, cell)
            if c < b < 1.0:  # rounder in the plane: more spheres
                assert number(cell) < number(cells[1.0, c]), (b, c)
            if c < b and spacing == "minimax_volume" and cell != "> 999":
                assert number(cell) < number(needed_cells(text, "medial")[b, c]), (b, c)


def check_ratios(text):
    """Rows of the tables of 65 spheres, as the command prints them."""
    keys = ("volume_ratio", "surface_ratio", "largest_to_spheres_c", "mean_to_spheres_c", "largest_to_body_c",
            "mean_to_body_c", "inertia_xx_ratio", "inertia_yy_ratio", "inertia_zz_ratio")
    for spacing in ("medial", "minimax_volume"):
        table = next(t for t in tables(text) if t[0][0] == f"a : b : c, {spacing}")
        rows = {row["shape"]: row for row in rows_of("template", "--ratios", "0.2,0.4,0.6,0.8,1", "--subspheres", 65,
                                                     "--spacing", spacing)}
        assert len(table) == 15 and len(rows) >= 11, (spacing, len(table), len(rows))
        for shape, *cells in table[1:]:
            expected = ["-"] * 10
            if shape in rows:
                expected = [f"{100 * float(rows[shape]['in_exactly_one']):.2f}"]
                expected += [f"{float(rows[shape][key]):.4f}" for key in keys]
            assert cells == expected, (shape, cells, expected)


def main():
    text, sets = PAGE.read_text().split("## Sets of spheres", 1)
    check_needed(sets)
    check_ratios(sets)
    comparison, geometry = (rows_of(*command) for command in commands(text))
    found = complaints(text, comparison, geometry)
    assert not found, "\n".join(found)
    for old, new in (("| 13 | 13 | 0 |", "| 13 | 11 | 2 |"), ("0.9908", "0.9909"),
                     ("| 10 | outline |", "| 10 | volume |"), ("| 55 |", "| 57 |")):
        assert old in text, old
        assert complaints(text.replace(old, new, 1), comparison, geometry), (old, new)
    spared = [int(row["minimax_outline_saved"]) for row in comparison]
    print(f"{len(comparison)} comparisons, {len(geometry)} templates; {max(spared)} spheres spared at most")


main()
