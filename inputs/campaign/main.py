"""Driver of campaigns: a matrix of runs of an input script, their measures, tables. Standard library only."""

import os
import signal
import sys
import time
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path

import calibration
import options as command_line
import results
from matrix import check_names, runs_of, variables_in
from options import PILE_QUANTITIES, PILING, Misuse
from runs import Campaign, Failed, check_same, is_finished, run_one, split_measure

PILE_MEASURE = ["pile", "--one-run", "{out}/pile.*.dump"]


def read_input(path):
    """(file, its variables)."""
    file = command_line.usable_path(path)
    if not file.is_file():
        raise Misuse(f"there is no input script {path}; correct --input")
    return file, variables_in(file.read_text(errors="replace"))


def set_up(given, variables):
    """(campaign, its runs), checked before anything runs."""
    file, known = read_input(given.input)
    check_names(variables, given.input, known)
    runs = runs_of(given, known, variables)
    if given.only is not None:
        runs = [runs[at_most(given.only, len(runs) - 1)]]
    if given.count:
        return None, runs
    if given.out is None:
        raise Misuse("option --out is missing; say where the results go")
    out = command_line.usable_path(given.out)
    is_pile = file == PILING and not given.measure
    measures = [split_measure(m) for m in given.measure] or ([PILE_MEASURE] if is_pile else [])
    engine, tools = command_line.programs()
    ranks = command_line.whole_number(given.ranks, "--ranks", 1)
    campaign = Campaign(engine, tools, file, out, variables, known, measures, ranks, is_pile)
    for run in runs:
        check_same(campaign, run)
    return campaign, runs


def at_most(word, largest):
    if not word.isdigit() or int(word) > largest:
        raise Misuse(f"--only is '{word}', allowed is 0 to {largest}")
    return int(word)


def check_calibration(given, runs):
    """(name, column, value) of --calibrate, or None; raises Misuse before the runs rather than after them."""
    if given.calibrate is None:
        return None
    asked = calibration.parse(given.calibrate)
    values = {}
    for run in runs:
        for name, value in run.varied:
            values.setdefault(name, set()).add(value)
    names = {name for name, found in values.items() if len(found) > 1 and name != "seed"}
    if names != {asked[0]}:
        raise Misuse(f"--calibrate takes {asked[0]}, what varies is {', '.join(sorted(names)) or 'nothing'}; vary "
                     "this variable alone, and seeds")
    return asked


def run_all(campaign, runs, jobs):
    """Runs them, `jobs` at a time, and says how far it is; returns those that are finished."""
    begin = time.time()
    before = sum(is_finished(campaign, run) for run in runs)
    signal.signal(signal.SIGTERM, lambda *_: (_ for _ in ()).throw(KeyboardInterrupt()))

    def say(text):
        print(f"  {text}", flush=True)

    with ThreadPoolExecutor(jobs) as pool:
        try:
            for done in as_completed([pool.submit(run_one, campaign, run, say) for run in runs]):
                done.result()
                finished, seconds = sum(is_finished(campaign, run) for run in runs), time.time() - begin
                fresh = finished - before
                left = f", about {seconds * (len(runs) - finished) / fresh:.0f} s left" if fresh else ""
                say(f"{finished} of {len(runs)} runs finished, {seconds:.0f} s{left}")
        except KeyboardInterrupt:
            campaign.stop()
            pool.shutdown(wait=True, cancel_futures=True)
            raise Misuse("stopped; the same line goes on with what is left") from None
    return [run for run in runs if is_finished(campaign, run)]


def tables(campaign, runs, given, asked):
    """What comes at the end of a whole campaign."""
    if not campaign.measures:
        return
    rows = results.table(campaign, runs)
    quantities = given.quantity or (PILE_QUANTITIES if campaign.picture else asked[1] if asked else None)
    if quantities:
        results.require_columns(rows, quantities.split(","))
        results.summary(campaign, runs, quantities)
    if campaign.picture:
        results.report(campaign, runs)
    if asked:
        results.require_columns(rows, [asked[1]])
        calibration.report(campaign, rows, asked)


def main(words):
    before, behind = command_line.words_behind_dashes(words)
    given = command_line.parser().parse_args(before)
    campaign, runs = set_up(given, command_line.variables_of(behind))
    if given.count:
        print(len(runs))
        return
    jobs = command_line.whole_number(given.jobs, "--jobs", 1) if given.jobs else len(os.sched_getaffinity(0))
    asked = check_calibration(given, runs)
    campaign.out.mkdir(parents=True, exist_ok=True)
    print(f"=== {len(runs)} runs, {jobs} at a time, in {campaign.out}", flush=True)
    finished = run_all(campaign, runs, jobs)
    missing = len(runs) - len(finished)
    if missing and finished and campaign.measures:
        results.table(campaign, finished)
    if missing:
        raise Misuse(f"{missing} of the {len(runs)} runs did not finish")
    if given.only is None:
        tables(campaign, runs, given, asked)


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except (Misuse, Failed) as error:
        print(f"campaign.sh: {error}", file=sys.stderr)
        sys.exit(2)
