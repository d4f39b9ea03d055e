"""Every style of the host, as its own lists in the build tree have them, stands in one of the tables of
src_liggghts/doc/what_works_with_what.md: it works, is refused, or is one of this package. What the page
says of refused ones is what the engine says, before it executes the command."""

import os
import re
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from _engine import LIGGGHTS, Particle, Setup, host_is_inl, run

PAGE = Path(os.environ["ELLIPSOID_SOURCE"]) / "src_liggghts" / "doc" / "what_works_with_what.md"
HOST = LIGGGHTS.parents[1] / "liggghts" / "patched" / "src"
#: the host's lists of styles; contact models have a page of their own (engine.contact_models)
KINDS = ("fix", "compute", "dump", "pair", "integrate", "command", "region", "mesh_module")


def host_styles(kind):
    """Names of the styles that the host has, from the headers that its list includes."""
    headers = re.findall(r'#include "([^"]+)"', (HOST / f"style_{kind}.h").read_text())
    word = "".join(part.capitalize() for part in kind.split("_"))
    found = []
    for header in headers:
        found += re.findall(rf"^\s*{word}Style\(([^,]+),", (HOST / header).read_text(errors="replace"),
                            re.M)
    return found


def own_styles(kind):
    """Those of this package, which have pages of their own."""
    found = []
    for path in PAGE.parents[1].rglob("*.h"):
        word = kind.capitalize()
        found += re.findall(rf"^{word}Style\(([^,]+),", path.read_text(), re.M)
    return found


def refused():
    """[(kind, style, why)] of the page's table of refused styles."""
    table = PAGE.read_text().split("\n## Refused styles")[1].split("\n## ")[0]
    found = []
    for line in table.splitlines():
        cells = [c.strip() for c in line.strip("|").split("|")]
        if len(cells) == 3 and cells[1].startswith("`"):
            found += [(cells[0], style, cells[2].replace("`", "'"))
                      for style in re.findall("`([^`]+)`", cells[1])]
    return found


def mentioned(kind, style):
    """Does a row that works, or the list of what every script uses, name the style?"""
    page = PAGE.read_text()
    before = {"fix": r"fix \w+ \w+ ", "compute": r"compute \w+ \w+ ", "dump": r"dump \w+ \w+ ",
              "pair": "pair_style ", "integrate": "run_style ", "region": r"region \w+ ", "command": "",
              "mesh_module": r"fix \w+ \w+ mesh/surface/(?:\w+/)?"}[kind]
    return re.search(f"`{before}{re.escape(style)}[ `]", page) is not None


class HostStyles(unittest.TestCase):
    def test_every_style_of_the_host_is_in_a_table(self):
        missing = []
        total = 0
        no_more = {(kind, style) for kind, style, _ in refused()}
        for kind in KINDS:
            for style in host_styles(kind):
                total += 1
                name = f"mesh/surface/{style}" if kind == "mesh_module" else style
                shown = {"pair": "pair_style", "integrate": "run_style", "mesh_module": "fix"}.get(kind, kind)
                if (shown, name) not in no_more and not mentioned(kind, style) and style not in own_styles(kind):
                    missing.append(f"{kind} {style}")
        print(f"{total} styles")
        self.assertGreater(total, 200)
        self.assertEqual(missing, [])

    def test_every_command_of_the_input_is_on_the_page(self):
        """Those that are no styles: what Input::execute_command() compares a command with."""
        commands = set(re.findall(r'strcmp\(command, *"(\w+)"\)', (HOST / "input.cpp").read_text(errors="replace")))
        page = PAGE.read_text()
        self.assertGreater(len(commands), 50)
        self.assertEqual([c for c in sorted(commands) if not re.search(f"`{c}[ `|]", page)], [])

    def test_refused_styles_are_refused_as_the_page_says(self):
        setup = Setup()
        start = setup.with_particles([Particle((0, 0, 0), (3e-3, 2e-3, 1e-3))], "refused.data")
        commands = {"fix": "fix f1 all {}", "compute": "compute c1 all {}", "dump": "dump d1 all {} 10 file",
                    "pair_style": "pair_style {}", "run_style": "run_style {}", "command": "{}",
                    "region": "region r1 {}"}

        def complaint(number_row):
            number, (kind, style, why) = number_row
            command = commands[kind].format(style)
            outcome = run(start + command + "\n", check=False, name=f"in.refused{number}")
            lines = [line for line in outcome.text.splitlines() if line.startswith("ERROR")]
            if outcome.code == 1 and len(lines) == 1 and style in lines[0] and why in lines[0]:
                return ""
            return f"{command}: exit status {outcome.code}, {lines}, expected '{why}'"

        table = refused()
        self.assertGreater(len(table), 80)
        with ThreadPoolExecutor(2) as pool:
            wrong = [text for text in pool.map(complaint, enumerate(table)) if text]
        self.assertEqual(wrong, [], "\n" + "\n".join(wrong))

    def test_lines_to_write_instead(self):
        start = Setup().with_particles([Particle((0, 0, 0), (3e-3, 2e-3, 1e-3))], "converted.data")
        for command, line in (
                ("pair_style gran model hertz tangential history rolling_friction cdt",
                 "pair_style gran/ellipsoid model hertz tangential history rolling_friction cdt surface smooth"),
                ("pair_style gran model hooke surface superquadric tangential_damping off",
                 "pair_style gran/ellipsoid model hooke surface smooth tangential_damping off"),
                ("fix f1 all wall/gran model hertz tangential history primitive type 1 zplane 0.0",
                 "fix f1 all wall/gran/ellipsoid model hertz tangential history surface smooth primitive type 1 "
                 "zplane 0.0")):
            outcome = run(start + command + "\n", check=False)
            self.assertEqual(outcome.code, 1)
            self.assertIn(f"write '{line}'", re.search("ERROR[^\n]*", outcome.text).group(0))

    def test_a_pair_style_of_an_earlier_atom_style(self):
        """Given before the atom style, or in a restart file: refused where the run begins."""
        text = Setup().with_particles([Particle((0, 0, 0), (3e-3, 2e-3, 1e-3))], "earlier.data")
        text = "pair_style gran model hertz\n" + text.replace("pair_style      gran/ellipsoid", "#")
        outcome = run(text.replace("pair_coeff      * *", "") + "run 1\n", check=False)
        self.assertEqual(outcome.code, 1, outcome.text[-400:])
        self.assertRegex(outcome.text, "ERROR: pair_style gran does not work with atom_style granular/ellipsoid")

    def test_sub_domains_that_are_no_bricks(self):
        """LIGGGHTS-INL has them; asked for before the atom style, they are refused where the run begins."""
        text = Setup().with_particles([Particle((0, 0, 0), (3e-3, 2e-3, 1e-3))], "tiled.data")
        outcome = run("comm_style tiled\n" + text + "run 1\n", check=False)
        self.assertEqual(outcome.code, 1, outcome.text[-400:])
        self.assertRegex(outcome.text, "ERROR: command comm_style does not work with atom_style granular/ellipsoid"
                         if host_is_inl() else "ERROR: Unknown command: comm_style")

    def test_the_atom_style_of_the_host(self):
        """Superquadrics of blockiness 8 are no ellipsoids."""
        text = Setup(atom_style="superquadric").without_particles()
        text += ("create_atoms 1 single 0 0 0 units box\nset group all shape 0.003 0.002 0.001\n"
                 "set group all blockiness 8 8\nset group all density 2000\nfix move all nve/superquadric "
                 "integration_scheme 1\nrun 1\n")
        outcome = run(text, check=False)
        self.assertEqual(outcome.code, 1)
        self.assertRegex(outcome.text, "ERROR: pair_style gran/ellipsoid needs particles with shape: use atom_style "
                         "granular/ellipsoid")


if __name__ == "__main__":
    unittest.main(verbosity=2)
