"""Stock behaviour stays: sphere inputs give the same numbers with the patched and the
unpatched engine, bit for bit, and no stock style is lost.

Oracle: LIGGGHTS itself, compiled with only those patches without which it does not compile.
"""

import os
import re
import subprocess
import unittest
from pathlib import Path

INPUTS = Path(__file__).parent / "stock_inputs"
PATCHED = Path(os.environ["ELLIPSOID_BIN"]) / "liggghts"
STOCK = Path(os.environ["ELLIPSOID_STOCK"])


def run(engine, name, ranks):
    """Run one input in a folder of its own; return (thermo lines, {dump name: content})."""
    folder = Path(f"{name}_{ranks}_{engine.name}").absolute()
    folder.mkdir()
    command = ["mpirun", "-np", str(ranks)] if ranks > 1 else []
    command += [str(engine), "-log", "log", "-var", "inputs", str(INPUTS)]
    command += ["-in", str(INPUTS / f"{name}.in")]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=600)
    if done.returncode != 0:
        raise AssertionError(f"{engine} failed on {name}.in:\n{done.stdout[-2000:]}{done.stderr}")
    log = (folder / "log").read_text()
    thermo = re.findall(r"^ +\d+ +\d+ +\S+ +\S+ *$", log, flags=re.MULTILINE)
    dumps = {file.name: file.read_text() for file in folder.glob("*.dump")}
    return thermo, dumps


def styles(engine):
    """The styles that -help lists, as a set of 'category: style'."""
    text = subprocess.run([engine, "-help"], capture_output=True, text=True).stdout
    found, category = set(), None
    for line in text.splitlines():
        if line.startswith("* "):
            category = line[2:]
        elif category:
            found.update(f"{category} {word}" for word in line.split())
    return found


class SameNumbers(unittest.TestCase):
    def compare(self, name, ranks=1):
        thermo, dumps = run(PATCHED, name, ranks)
        stock_thermo, stock_dumps = run(STOCK, name, ranks)
        self.assertGreaterEqual(len(stock_thermo), 30, "the run is shorter than the input says")
        self.assertEqual(thermo, stock_thermo)
        self.assertEqual(len(stock_dumps), 4)
        self.assertEqual(dumps.keys(), stock_dumps.keys())
        for file, content in stock_dumps.items():
            self.assertEqual(dumps[file], content, f"{name}: {file} differs")
        last = stock_dumps[f"{name}.30000.dump"].splitlines()
        self.assertGreater(len(last), 100, "hardly any particles in the last dump")
        in_contact = sum(float(line.split()[8]) != 0.0 for line in last[9:])
        self.assertGreater(in_contact, 50, "hardly any particle was in contact")

    def test_packing(self):
        self.compare("packing")

    def test_mesh_chute(self):
        self.compare("chute")

    def test_cohesion_and_rolling_friction(self):
        self.compare("cohesion")

    def test_packing_on_two_ranks(self):
        self.compare("packing", ranks=2)

    def test_two_engines_are_compared(self):
        self.assertNotEqual(PATCHED.read_bytes(), STOCK.read_bytes())

    def test_no_stock_style_is_lost(self):
        stock = styles(STOCK)
        self.assertGreater(len(stock), 200)
        self.assertEqual(stock - styles(PATCHED), set())


if __name__ == "__main__":
    unittest.main(verbosity=2)
