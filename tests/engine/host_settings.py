"""Settings and commands of the host that must not change a force, or change it as they say: each step of a crowd of
touching bodies against brute force, from positions and orientations alone (_brute_force.py). What cannot work stops in
one line."""

import re
import unittest
from pathlib import Path

import numpy as np

import _crowd
from _brute_force import REPLAYED, replay
from _crowd import LENGTHS, TIME_STEP
from _engine import host_is_inl, read_dump, run, vectors

STEPS = 40
FORM = " ".join("%d" if c in ("id", "type") else "%.17g" for c in REPLAYED)
LEFT = "region left block 0 2.9e-3 INF INF INF INF units box\n"


def script(commands="", change=("", ""), boundary="p p p"):
    """`change`: a line of the head and what it becomes."""
    text = _crowd.script(boundary)
    if change[0] not in text:
        raise AssertionError(f"no '{change[0]}' in the script")
    return (text.replace(*change, 1) if change[0] else text) + (
        "fix motion all nve/ellipsoid\nthermo_modify lost error\n" + commands)


class HostSettings(unittest.TestCase):
    def check(self, text, ranks=1, boundary="p p p", runs=f"run {STEPS}\n", least=10 * STEPS):
        """`runs` must not set up a run while contacts have springs: that evaluates forces once more."""
        Path("d.dump").unlink(missing_ok=True)
        run(text + f"dump d all custom 1 d.dump {' '.join(REPLAYED)}\ndump_modify d sort id format \"{FORM}\"\n" + runs,
            ranks)
        frames = vectors(read_dump("d.dump")[1], *REPLAYED)
        periods = [length if letter == "p" else np.inf for length, letter in zip(LENGTHS, boundary.split())]
        brute = _crowd.brute_force(periods)
        contacts = 0
        for values, (force, torque, rows) in zip(frames, replay(brute, frames, TIME_STEP)):
            contacts += len(rows)
            for found, expected in ((values[:, 19:22], force), (values[:, 22:25], torque)):
                np.testing.assert_allclose(found, expected, rtol=0, atol=1e-10 * np.abs(expected).max())
        self.assertGreater(contacts, least)
        return frames

    def refused(self, text, pattern, runs="run 1\n"):
        outcome = run(text + runs, check=False)
        self.assertNotEqual(outcome.code, 0, pattern)
        (line,) = [line for line in outcome.text.splitlines() if line.startswith("ERROR")]
        self.assertRegex(line, pattern)

    def test_heads(self):
        communicate, newton, modify = (
            re.search(f"^{word} .*", script(), re.M).group(0) for word in ("communicate", "newton", "atom_modify"))
        changes = [(communicate, "communicate multi vel yes"), (communicate, "communicate single cutoff 1e-4 vel yes"),
                   (modify, "atom_modify map array sort 1 1e-3"), (modify, "atom_modify map hash sort 0 0"),
                   (modify, "atom_modify map array first all"), (newton, newton + "\nprocessors 1 * 1"),
                   (" bin", " nsq"), ("units           si", "units micro")]
        for number, change in enumerate(changes):
            self.check(script(change=change), ranks=1 + number % 2)
        for unit in ("cgs", "lj", "nano"):
            self.check(script(change=("units           si", f"units {unit}")))
        for change, pattern in (((newton, "newton on"), "requires newton pair off"),
                                ((communicate, "communicate single vel no"), "requires ghost atoms store velocity"),
                                ((modify, modify + "\ndimension 2"), "2D are not implemented"),
                                *((("units           si", f"units {u}"), f"units {u}.*use 'units si'")
                                  for u in ("electron", "real", "metal"))):
            self.refused(script(change=change), pattern)

    def test_lists_and_runs(self):
        for commands in ("neigh_modify every 20 delay 20 check no\n", "neigh_modify binsize 1e-3\n",
                         "neigh_modify once yes\n", "force_dt_reset yes\n", "thermo 0\n"):
            self.check(script(commands))
        self.check(script(), runs="run 20 pre yes post no\nrun 20 pre no post no\n")
        self.check(script(), runs="run 40 start 0 stop 200\n")
        for boundary in ("s s s", "m p f", "p p fm"):
            self.check(script(boundary=boundary), 2 if boundary == "s s s" else 1, boundary, least=5 * STEPS)

    def test_a_run_that_is_not_set_up(self):
        """After commands that act where a run is set up, and between the parts of such a run."""
        text, wanted = script(), "acts where a run is set up, and this one would not be; leave 'pre no' out"
        for command in ("set group all shape 3e-3 2e-3 2e-3", "set group all type 1", "displace_atoms all move 0 0 1e-3 units box",
                        "group one id 1\ndelete_atoms group one compress no", "fix push all addforce 1 0 0",
                        "compute c all ke", "neigh_modify delay 0", "change_box all boundary m m m"):
            outcome = run(text + f"run 2\n{command}\nrun 2 pre no\n", check=False, name="in.pre")
            self.assertNotEqual(outcome.code, 0, command)
            self.assertIn(f"run ... pre no: '{command.splitlines()[-1].split()[0]}' {wanted}", outcome.text)
            run(text + f"run 2\n{command}\nrun 2\nrun 2 pre no\n", name="in.pre")
        outcome = run(text + "run 2\nrun 4 pre no every 2 \"set group all shape 3e-3 2e-3 2e-3\"\n", check=False, name="in.pre")
        self.assertNotEqual(outcome.code, 0)
        self.assertIn(f"'set' {wanted}", outcome.text)
        run(text + "run 4 every 2 \"set group all shape 3e-3 2e-3 2e-3\"\nrun 2\nvelocity all set 0 0 0 units box\nthermo 1\n"
            "print done\nrun 2 pre no\n", name="in.pre")

    def test_commands_that_know_nothing_of_shapes(self):
        """All in one script, after a scene that `clear` has left; a loop, a file that is included. LIGGGHTS-INL has no
        settings of `thermo_temp`, and says so."""
        temperature = "compute warm all temp\ncompute_modify warm dynamic yes\n"
        Path("more.in").write_text("thermo_log thermo.log\nmodify_timing on\nsoft_particles yes\nlattice sc 0.001\n"
                                   + (temperature if host_is_inl() else "compute_modify thermo_temp dynamic yes\n")
                                   + "fix_modify motion energy no\ntimestep 1e-6\n")
        more = ("label again\nvariable k loop 3\ninclude more.in\nshell mkdir -p folder\nnext k\njump SELF again\n"
                f'if "3 > 2" then "print three" else "quit"\ntimestep {TIME_STEP!r}\nwrite_restart_on_signal yes\n'
                "restart 1000 signal.*\necho log\nlog other.log append\npartition yes 1 thermo 5\n")
        before = script("run 3\n").replace("crowd.data", "before.data")
        Path("before.data").write_text(Path("crowd.data").read_text())
        self.check(before + "clear\n" + script(more.replace("next k\njump SELF again\n", "").replace(
            "label again\nvariable k loop 3\n", "")))
        self.check(script(more.replace("include more.in\n", "")), 2)

    def test_frozen_bodies(self):
        """They bear no force, and count as infinitely heavy in the dashpots of those that they touch."""
        text = script("group cold id 1 2 3 7\nvelocity cold set 0 0 0\nset group cold omegax 0 omegay 0 omegaz 0\n"
                      "fix hold cold freeze\n")
        Path("d.dump").unlink(missing_ok=True)
        run(text + f"dump d all custom 1 d.dump {' '.join(REPLAYED)}\ndump_modify d sort id format \"{FORM}\"\n"
            f"run {STEPS}\n", 2)
        frames = vectors(read_dump("d.dump")[1], *REPLAYED)
        cold = np.isin(frames[0][:, 0], (1, 2, 3, 7))
        self.assertEqual(np.abs(frames[:, cold, 19:25]).max(), 0.0)
        heavy = frames.copy()
        heavy[:, cold, 2] = 1e20
        brute = _crowd.brute_force()
        for values, (force, torque, _) in zip(frames, replay(brute, heavy, TIME_STEP)):
            for found, expected in ((values[:, 19:22], force), (values[:, 22:25], torque)):
                np.testing.assert_allclose(found[~cold], expected[~cold], rtol=0, atol=1e-10 * np.abs(expected).max())

    def test_materials_and_time_steps_that_cannot_be(self):
        modulus, friction, step = (re.search(f"{word} .*", script(), re.M).group(0) for word in
                                   ("youngsModulus", "coefficientFriction", "timestep"))
        for change, pattern in (
                ((friction, "coefficientFriction peratomtypepair 1 -0.5"),
                 r"coefficientFriction has the value -0.5, allowed is >= 0; correct the fix \(id m3\)"),
                ((modulus, "youngsModulus peratomtype -5e7\nsoft_particles yes"), "youngsModulus has the value -5e.07"),
                ((modulus, "youngsModulus peratomtype 0\nsoft_particles yes"), "youngsModulus has the value 0, allowed is > 0"),
                *(((step, f"timestep {value}"), f"time step is {value}, allowed is > 0") for value in ("0", "-1e-06"))):
            self.refused(script(change=change), pattern)
        cold = "fix k all property/global thermalConductivity peratomtype -1\n"
        self.refused(script(cold), "thermalConductivity has the value -1")

    def test_changes_of_particles(self):
        by_place = "variable speed atom 200*x\nrun 0\n"
        for commands in (LEFT + "run 0\ndelete_atoms region left\n",
                         LEFT + "run 0\nset region left vx 0.3 omegay 20\n", "run 0\nset atom 2 x 1.5e-3\n",
                         by_place + "set group all vx v_speed\nset group all omegaz v_speed\n",
                         "variable a atom 0.0014+0.00001*id\nrun 0\nset group all shape v_a 0.0014 0.0015\n",
                         "variable angle atom id*10\nset group all quat 0 1 1 v_angle\n",
                         "set group all quat/random 49999\n", "set group all image 1 0 -1\n",
                         "run 0\nset atom 3 shape 0.0013 0.0016 0.0014 density 2000 quat 1 2 3 40 omegax 30 vx 0.1\n",
                         "run 0\nset atom 3 mass 2e-5 omegay 3\n"):
            self.check(script(commands))
        self.check(script("region whole block INF INF INF INF INF INF units box\nrun 0\n"
                          "delete_atoms porosity whole 0.3 48611\n"), least=3 * STEPS)
        for commands, pattern in (("set atom 3 shape 0 0 0\n", "semi-axes 0 0 0"),
                                  ("lattice sc 0.001\ncreate_atoms 1 random 3 48611 NULL\n", "add 'set ... shape a b c'"),
                                  ("set atom 2 x 0.1\n", "Lost atoms"),
                                  ("rotate 1 2 3\n", "does nothing in this host"),
                                  ("replicate 2 1 1\n", "use 'fix insert/pack'")):
            self.refused(script("run 0\n" + commands), pattern)


if __name__ == "__main__":
    unittest.main(verbosity=2)
