"""Includes go down only: the rooms of the kernel, the rooms of the adapters, the floors of ellipsoid-post and the rooms
of its measures and commands may include themselves and those before them in the numbered list of their README; the kernel includes nothing but
itself and the standard library; the adapters and ellipsoid-post may include the kernel. Headers have unique names.
"""

import os
import re
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(os.environ["ELLIPSOID_SOURCE"])
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)
#: what the kernel takes from outside: the C++ standard library, as <name> without ending
STANDARD = re.compile(r"^[a-z_]+$")


def rooms_of(folder):
    """The rooms in the order of the README's numbered list; raises unless they are the folders with code."""
    text = (folder / "README.md").read_text()
    rooms = re.findall(r"^\d+\. `(\w+)`:", text, re.MULTILINE)
    found = {f.relative_to(folder).parts[0] for f in code(folder) if f.parent != folder} - {"fuzz", "kernel"}
    if set(rooms) != found:
        raise AssertionError(f"{folder}/README.md lists {sorted(rooms)}, the folders are {sorted(found)}")
    return rooms


def code(folder):
    return sorted(f for f in folder.rglob("*") if f.suffix in (".h", ".cpp"))


def includes(file):
    return INCLUDE.findall(file.read_text())


def kernel_offences(kernel):
    rooms = rooms_of(kernel)
    for file in code(kernel):
        own = rooms.index(file.parent.name)
        for kind, name in includes(file):
            room = name.split("/")[0]
            if kind == "<":
                if not STANDARD.match(name):
                    yield f"{file}: <{name}> is not of the standard library"
            elif room not in rooms or not (kernel / name).exists():
                yield f"{file}: \"{name}\" is no file of the kernel, which includes nothing else"
            elif rooms.index(room) > own:
                yield f"{file}: \"{name}\" is in a room above"


def floor_offences(folder, kernel, forbidden):
    """Of the adapters or of ellipsoid-post. `forbidden`: names of headers that they do not include."""
    rooms = rooms_of(folder)
    home = {f.name: rooms.index(room) for room in rooms for f in (folder / room).rglob("*.h")}
    for room in rooms:
        for file in code(folder / room):
            for kind, name in includes(file):
                if kind == "<":
                    continue
                if name in forbidden:
                    yield f"{file}: \"{name}\" belongs to another part"
                elif home.get(name, 0) > rooms.index(room):
                    yield f"{file}: \"{name}\" is in a room above"
                elif "/" in name and not (kernel / name).exists():
                    yield f"{file}: \"{name}\" is not in the kernel"


class IncludeOrder(unittest.TestCase):
    def setUp(self):
        self.adapters, self.post = SOURCE / "src_liggghts", SOURCE / "postprocess"
        self.kernel = self.adapters / "kernel"

    def test_kernel(self):
        self.assertGreater(len(code(self.kernel)), 40)
        self.assertEqual(list(kernel_offences(self.kernel)), [])

    def test_adapters(self):
        post = {f.name for f in code(self.post)}
        self.assertEqual(list(floor_offences(self.adapters, self.kernel, post)), [])

    def test_ellipsoid_post(self):
        adapters = {f.name for f in code(self.adapters) if self.kernel not in f.parents}
        self.assertEqual(list(floor_offences(self.post, self.kernel, adapters)), [])

    def test_rooms_of_floors(self):
        for floor in (self.post / "measures", self.post / "commands"):
            self.assertEqual(list(floor_offences(floor, self.kernel, {f.name for f in floor.glob("*.h")})), [])

    def test_headers_have_unique_names(self):
        names = [f.name for part in ("src_liggghts", "postprocess", "tests") for f in code(SOURCE / part)
                 if f.suffix == ".h"]
        self.assertEqual(sorted(n for n in set(names) if names.count(n) > 1), [])

    def test_offences_are_found(self):
        """The same check on a kernel and adapters that break each rule once."""
        with tempfile.TemporaryDirectory() as folder:
            adapters = Path(folder)
            kernel = adapters / "kernel"
            files = {
                "kernel/README.md": "1. `low`: a\n2. `high`: b\n", "README.md": "1. `host`: a\n2. `pairs`: b\n",
                "kernel/low/a.h": '#include "high/b.h"\n#include "atom.h"\n#include <mpi.h>\n#include <cmath>\n',
                "kernel/high/b.h": '#include "low/a.h"\n',
                "host/c.h": '#include "d.h"\n#include "atom.h"\n#include "low/missing.h"\n',
                "pairs/d.h": '#include "c.h"\n#include "low/a.h"\n#include "chart.h"\n'}
            for name, text in files.items():
                (adapters / name).parent.mkdir(parents=True, exist_ok=True)
                (adapters / name).write_text(text)
            found = [re.search(r'["<](\S+?)[">]', o).group(1) for o in kernel_offences(kernel)]
            self.assertEqual(sorted(found), ["atom.h", "high/b.h", "mpi.h"])
            found = [re.search(r'"(\S+?)"', o).group(1) for o in floor_offences(adapters, kernel, {"chart.h"})]
            self.assertEqual(sorted(found), ["chart.h", "d.h", "low/missing.h"])
            (kernel / "README.md").write_text("1. `low`: a\n")
            with self.assertRaises(AssertionError):
                rooms_of(kernel)


if __name__ == "__main__":
    unittest.main(verbosity=2)
