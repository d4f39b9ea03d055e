# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""Every table that a command writes as CSV is read on by summary, plot and report, and by JSON's keys.

Oracle: means of the columns by Python's csv module and numpy; numbers of points in the pictures.
"""
import csv
import json
import os
import re
import shutil

import numpy as np

from _option_scenes import write_scenes
from _synthetic import post
from post_options import EXAMPLES, USUAL, Example, commands, helped, words_of

# options that write a table of their own: (command, option) to further options
OTHER_TABLES = {("contacts", "--list"): (), ("coordination", "--per-particle"): (), ("voronoi", "--per-particle"): (),
                ("trajectory", "--per-particle"): (), ("flow", "--passages"): ("--dt", "1e-5"), ("template", "--spheres"): ()}


def number(text):
    try:
        return float(text)
    except ValueError:
        return None


def table_at(name):
    """Keys, and columns of numbers (None where a field is no number)."""
    with open(name, encoding="utf8", newline="") as file:
        lines = list(csv.reader(file))
    assert len({len(line) for line in lines}) == 1, (name, {len(line) for line in lines})
    assert len(set(lines[0])) == len(lines[0]), (name, "keys that come twice")
    return lines[0], {key: [number(line[k]) for line in lines[1:]] for k, key in enumerate(lines[0])}, len(lines) - 1


def numeric_keys(columns):
    return [k for k, values in columns.items() if values and all(v is not None for v in values)]


def check_summary(name, columns, keys):
    """Means and half ranges of all numeric columns, all rows in one group (a column that none has)."""
    out, _ = post("summary", name, "--group", "no_such_column", "--quantity", ",".join(keys), "--json", "-")
    (row,) = json.loads(out)
    assert row["runs"] == len(columns[keys[0]]), row
    for key in keys:
        values = np.array(columns[key])
        means = [v for k, v in row.items() if re.sub("_mean(?=_|$)", "", k, count=1) == key and "_mean" in k]
        scale = 1e-12 * np.abs(values).max() + 1e-300
        assert any(abs(m - values.mean()) <= scale for m in means), (name, key, means, values.mean())
    for key in row:  # units stay last
        assert not re.search(r"_(per|kg)_(mean|half_range|lowest|highest|standard_deviation)_(?!percent)", key), key


def check_plot(name, columns, keys, rows):
    x, y = keys[0], keys[-1]
    post("plot", "curve", name, "--x", x, "--y", y, "-o", "curve.svg")
    with open("curve.svg", encoding="utf8") as file:
        text = file.read()
    marks = text.count("<circle") + max((len(p.split()) for p in re.findall(r'points="([^"]*)"', text)), default=0)
    places = {(a, b) for a, b in zip(columns[x], columns[y])}
    assert marks >= min(len(places), rows) or "<path" in text, (name, x, y, marks, rows)


def check_report(name, columns, keys):
    post("report", "--table", name, "--curve", name, keys[0], keys[-1], "-o", "page.html")
    with open("page.html", encoding="utf8") as file:
        page = file.read()
    assert os.path.basename(name) in page and page.count("<tr") >= min(20, len(columns[keys[0]])), name


def check_table(name):
    keys, columns, rows = table_at(name)
    numeric = numeric_keys(columns)
    assert rows > 0 and len(numeric) >= 2, (name, keys)
    check_summary(name, columns, numeric)
    check_plot(name, columns, numeric, rows)
    check_report(name, columns, numeric)


def check_command(command):
    options = helped(command)
    if "--csv" in options:
        usual = words_of(command, Example())
        more = ["--frame", "all"] if "--frame" in options else []
        if command == "report":
            usual = [w for w in usual if not w.startswith("--output") and w != "r.html"]
        post(command, *usual, *more, "--csv", "table.csv", "--json", "table.json", *(["--quiet"] if "--quiet" in options else []))
        check_table("table.csv")
        with open("table.json", encoding="utf8") as file:
            objects = json.load(file)
        keys, _, rows = table_at("table.csv")
        assert len(objects) == rows and set().union(*objects) <= set(keys), command
    for (owner, option), more in OTHER_TABLES.items():
        if owner == command:
            post(command, *words_of(command, Example()), *more, option, "other_*.csv" if command == "trajectory" else "other.csv")
            names = [f for f in os.listdir(".") if f.startswith("other")]
            check_table(max(names))
            for file in names:
                os.remove(file)


def check_natural_order():
    """Groups and runs are in natural order: run2 before run10."""
    rows = json.loads(post("summary", "../scenes/runs.csv", "--group", "run", "--quantity", "zpp", "--json", "-")[0])
    assert [row["run"] for row in rows] == [f"run{k}" for k in range(12)], rows
    for number in (1, 2, 10):
        os.makedirs(f"seeds/seed{number}")
        shutil.copy("../scenes/plane/one.100.dump", f"seeds/seed{number}/pile.dump")
    post("report", "seeds", "-o", "seeds.html", "--csv", "seeds.csv")
    with open("seeds.csv", encoding="utf8") as file:
        assert [row["run"] for row in csv.DictReader(file)] == [f"seeds/seed{n}/pile.dump" for n in (1, 2, 10)]
    post("report", *(f"seeds/seed{n}/pile.dump" for n in (1, 10, 2)), "-o", "seeds.html", "--csv", "seeds.csv")  # as a shell opens seed*
    with open("seeds.csv", encoding="utf8") as file:
        assert [row["run"] for row in csv.DictReader(file)] == [f"seeds/seed{n}/pile.dump" for n in (1, 2, 10)]


def main():
    os.makedirs("scenes")
    os.makedirs("tables")
    os.chdir("scenes")
    write_scenes()
    os.chdir("../tables")
    assert set(EXAMPLES) == set(USUAL) == set(commands())
    for command in commands():
        for option in helped(command):  # every option that writes a table is here
            if option in ("--list", "--per-particle", "--passages"):
                assert (command, option) in OTHER_TABLES, (command, option)
        if command not in ("summary",):
            check_command(command)
    check_natural_order()


if __name__ == "__main__":
    main()
