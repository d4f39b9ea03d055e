"""Restart and data files that are cut, damaged or half written: refused with one line, and never in the
place of the last whole file; what is whole comes back, sub-spheres included.
"""

import os
import re
import subprocess
import time
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

from _engine import COLUMNS, LAW, LIGGGHTS, Setup, dump, read_dump, run

MORE = COLUMNS + ["f_subspheres", "f_spacing"]
SETUP = Setup(pair=f"gran/ellipsoid {LAW} surface multisphere", boundary="p p f", time_step=5e-6,
              box=(-0.015, 0.015, -0.015, 0.015, -0.001, 0.04))
MOTION = f"""
fix gravity all gravity 9.81 vector 0 0 -1
fix floor all wall/gran/ellipsoid {LAW} surface multisphere primitive type 1 zplane 0.0
fix motion all nve/ellipsoid
"""
TEMPLATES = """
fix five all particletemplate/ellipsoid 15485863 semiaxes 2.7e-3 1.15e-3 1.15e-3 density 1340 &
    subspheres 5
fix nine all particletemplate/ellipsoid 15485867 semiaxes 2e-3 1e-3 1e-3 density 1340 subspheres 9 &
    spacing minimax
"""
# some particles, tilted, that touch and slide on the floor
FILLING = SETUP.without_particles() + TEMPLATES + MOTION + """
fix mix all particledistribution/discrete 32452843 2 five 0.5 nine 0.5
region low block -0.015 0.015 -0.015 0.015 0.0 0.01 units box
fix fill all insert/pack seed 32452867 distributiontemplate mix vel constant 0.1 0 -0.3 &
    orientation random insert_every once overlapcheck yes all_in no region low particles_in_region 30
run 1
unfix fill
run 400
"""


PER_ATOM = "".join(f"fix {name} all property/atom {name} scalar yes yes no 0.\n"
                   for name in ("subspheres", "spacing"))


def reads(file, more="run 0\n"):
    """Script that goes on from a restart file."""
    return SETUP.header() + f"read_restart {file}\n" + SETUP.properties() + PER_ATOM + MOTION + more


def reads_data(file, more="run 0\n"):
    """Script that starts with a data file."""
    return SETUP.header() + f"read_data {file}\n" + SETUP.properties() + MOTION + more


def complaint(outcome, file):
    """What is wrong with the refusal of `file`, or an empty string."""
    lines = [line for line in outcome.text.splitlines() if line.startswith("ERROR")]
    if outcome.code != 1 or len(lines) != 1:
        return f"{file}: exit status {outcome.code}, lines of error: {lines}"
    return "" if file in lines[0] and len(lines[0]) < 300 else f"{file}: {lines[0]}"


def refusals(script_of, files, pattern=None):
    """Complaints about files that ought to be refused, for a reason that fits `pattern`."""
    def one(file):
        outcome = run(script_of(file), timeout=60, check=False, name=f"in.{file}")
        wrong = complaint(outcome, file)
        if not wrong and pattern and not re.search(pattern, outcome.text):
            wrong = f"{file}: another reason: {outcome.text[-300:]}"
        return wrong
    with ThreadPoolExecutor(2) as pool:
        return [wrong for wrong in pool.map(one, files) if wrong]


class WholeFiles(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        run(FILLING + dump("good.dump", columns=MORE) + "run 0\nwrite_data good.data\n"
            "write_restart good.restart\nwrite_restart good.%.restart\n", name="in.good")
        cls.restart = Path("good.restart").read_bytes()
        cls.data = Path("good.data").read_text()

    def compare(self, file, last=-1):
        _, good = read_dump("good.dump")
        _, found = read_dump(file)
        self.assertGreater(good["id"].shape[1], 25)
        self.assertEqual(set(good["f_subspheres"][-1]), {5.0, 9.0})
        for name in MORE:
            np.testing.assert_array_equal(good[name][-1], found[name][last], err_msg=name)

    def test_what_is_whole_comes_back(self):
        for k, file in enumerate(("good.restart", "good.%.restart")):
            run(reads(file, dump(f"again{k}.dump", columns=MORE) + "run 0\n"), name=f"in.again{k}")
            self.compare(f"again{k}.dump")

    def test_data_file_with_sub_spheres(self):
        # the first file with all values, the second as read from it, on other numbers of ranks
        for ranks, file, copy in ((1, "good.data", "two.data"), (4, "two.data", "three.data")):
            run(reads_data(file, dump(f"{copy}.dump", columns=MORE) + f"run 0\nwrite_data {copy}\n"),
                ranks, name=f"in.{copy}")
            self.compare(f"{copy}.dump", 0)
        def rows(text):
            return sorted(text.split("Atoms\n")[1].split("Velocities")[0].splitlines())
        self.assertEqual(rows(self.data), rows(Path("three.data").read_text()))

    def test_wrong_sub_spheres_in_a_data_file(self):
        head, rest = self.data.split("Atoms\n\n")
        atom, tail = rest.split("\n", 1)
        for k, (column, value) in enumerate([(16, "-1"), (16, "1.5"), (16, "1001"), (16, "x"),
                                             (17, "-1"), (17, "nan")]):
            words = atom.split()
            words[column] = value
            Path(f"wrong{k}.data").write_text(f"{head}Atoms\n\n{' '.join(words)}\n{tail}")
            outcome = run(reads_data(f"wrong{k}.data"), check=False)
            self.assertEqual(outcome.code, 1)
            self.assertRegex(outcome.text, rf"ERROR.*column {('N', 'spacing')[column - 16]} has the value "
                                           rf"'{value}', allowed")

    def test_a_cut_restart_file_is_refused(self):
        size = len(self.restart)
        random = np.random.default_rng(4)
        places = {0, 1, 4, 7, 8, 40, 100, 500, size - 1, size - 31, size - 32, size - 33, size - 100,
                  *random.integers(0, size, 25).tolist()}
        for place in places:
            Path(f"cut{place}.restart").write_bytes(self.restart[:place])
        wrong = refusals(reads, [f"cut{place}.restart" for place in places], "is cut|does not begin")
        self.assertFalse(wrong, "\n".join(wrong))

    def test_a_damaged_restart_file_is_refused(self):
        size = len(self.restart)
        random = np.random.default_rng(5)
        places = {0, 4, 9, 30, 60, size - 1, size - 10, size - 20, size - 32, size // 2,
                  *random.integers(0, 400, 8).tolist(), *random.integers(400, size, 15).tolist()}
        for place in places:
            content = bytearray(self.restart)
            content[place] ^= 1 << int(random.integers(8))
            Path(f"flip{place}.restart").write_bytes(content)
        Path("longer.restart").write_bytes(self.restart + b"x")
        wrong = refusals(reads, [*(f"flip{place}.restart" for place in places), "longer.restart"])
        self.assertFalse(wrong, "\n".join(wrong))

    def test_files_of_ranks_are_checked(self):
        script = FILLING + "write_restart {0}.%.r\nrun 1\nwrite_restart other.%.r\n"
        for name in "cut", "damaged", "mixed":
            run(script.format(name), 2, name=f"in.{name}")
            file, content = Path(f"{name}.1.r"), Path(f"{name}.1.r").read_bytes()
            changed = {"cut": content[:-200], "damaged": content[:100] + b"\1" + content[101:],
                       "mixed": Path("other.1.r").read_bytes()}[name]
            self.assertNotEqual(content, changed)
            file.write_bytes(changed)
            for ranks in 1, 2:
                outcome = run(reads(f"{name}.%.r"), ranks, check=False)
                self.assertEqual(outcome.code, 1)
                self.assertRegex(outcome.text, rf"ERROR.*'{name}.1.r' is (cut|damaged|of time step)")

    def test_a_file_of_another_liggghts_gives_a_warning(self):
        foreign = self.restart[:-32].replace(b"liggghts-ellipsoid", b"something-else-abc", 1)
        Path("foreign.restart").write_bytes(foreign)
        outcome = run(reads("foreign.restart", dump("foreign.dump", columns=MORE) + "run 0\n"))
        self.assertRegex(outcome.text, "WARNING.*'foreign.restart' has no checksum")
        self.compare("foreign.dump")

    def test_a_cut_data_file_is_refused(self):
        size = len(self.data)
        sections = [self.data.index(word) for word in ("Atoms", "Velocities", "# end")]
        lines = [k + 1 for k, letter in enumerate(self.data) if letter == "\n"]
        random = np.random.default_rng(6)
        places = {0, 1, 30, size - 1, *sections, *(s - 1 for s in sections), *lines[:9:2], *lines[-3:-1],
                  *random.integers(0, size, 12).tolist()}
        for place in places:
            Path(f"cut{place}.data").write_text(self.data[:place])
        wrong = refusals(reads_data, [f"cut{place}.data" for place in places], "is cut|no complete")
        self.assertFalse(wrong, "\n".join(wrong))

    def test_a_full_disk_leaves_the_last_file(self):
        script = reads("good.restart", "run 1\nwrite_restart keep.restart\nrun 1\n")
        run(script, name="in.keep")
        before = Path("keep.restart").read_bytes()
        Path(".keep.restart.partial").symlink_to("/dev/full")
        done = run(script, check=False, name="in.keep")
        self.assertEqual(done.code, 1)
        self.assertRegex(done.text, "ERROR.*Restart file 'keep.restart' could not be written .*make room")
        self.assertEqual(Path("keep.restart").read_bytes(), before)
        self.assertFalse(Path(".keep.restart.partial").is_symlink())


class Killed(unittest.TestCase):
    STEPS, EVERY, KILLS = 2000, 1, 6

    def test_killed_at_any_moment_it_goes_on(self):
        """And ends, digit by digit, as the run that was left alone."""
        def script(restart):
            return FILLING + f"reset_timestep 0\nrestart {self.EVERY} {restart}\n"
        end = f"run {self.STEPS} upto\nwrite_dump all custom {{0}}.dump {' '.join(MORE)} modify sort id &\n"
        end += f'    format "%d %d{" %.17g" * (len(MORE) - 2)}"\n'
        run(script("whole.a whole.b") + end.format("whole"), name="in.whole")
        whole = Path("whole.dump").read_text()
        random = np.random.default_rng(8)
        writing = 0
        for k in range(self.KILLS):
            writing += self.kill(script("a.restart b.restart") + f"run {self.STEPS}\n", k, random)
            steps = {}
            for file in "a.restart", "b.restart":  # both are whole
                text = run(reads(file, "run 0\n"), name=f"in.{file}{k}").text
                steps[int(re.search(r"^ *Step .*\n *(\d+) ", text, re.MULTILINE)[1])] = file
            last = max(steps)
            self.assertGreater(last, 0)
            self.assertLess(last, self.STEPS)
            self.assertEqual(last - min(steps), self.EVERY)
            run(reads(steps[last], f"restart {self.EVERY} c.restart d.restart\n" + end.format(f"resumed{k}")),
                name=f"in.resumed{k}")
            self.assertEqual(whole, Path(f"resumed{k}.dump").read_text(), f"went on from step {last}")
        print(f"killed while writing: {writing} of {self.KILLS} times")

    @staticmethod
    def kill(script, number, random):
        """Starts the run and kills it, every second time while a file is written."""
        for file in Path().glob("*[ab].restart*"):
            file.unlink()
        Path("in.killed").write_text(script)
        with subprocess.Popen([str(LIGGGHTS), "-in", "in.killed", "-log", "none"],
                              stdout=subprocess.DEVNULL) as process:
            while not Path("b.restart").exists():
                time.sleep(0.001)
            time.sleep(random.uniform(0.0, 0.2))
            while number % 2 and not any(os.path.exists(f".{n}.restart.partial") for n in "ab"):
                pass
            process.kill()
        return any(os.path.exists(f".{n}.restart.partial") for n in "ab")


if __name__ == "__main__":
    unittest.main(verbosity=2)
