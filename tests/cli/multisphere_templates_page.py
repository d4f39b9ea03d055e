"""The tables of src_liggghts/doc/multisphere_templates.md are what the commands on the page print.

Every cell is compared with the tool's output, rounded to the digits of the cell; a table that has
lost rows, and a value that was changed by one in its last digit, must be noticed.
"""

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


def main():
    text = PAGE.read_text()
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
