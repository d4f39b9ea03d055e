"""One run of a campaign, from wherever it stopped, and its measures."""

import csv
import glob
import hashlib
import json
import os
import shlex
import subprocess
import threading
import time
from dataclasses import dataclass, field
from pathlib import Path

from options import Misuse

END = "campaign: the script came to its end"


class Failed(Exception):
    """Why a run has no result; one line or two."""


@dataclass
class Campaign:
    """What all runs share."""

    engine: Path
    tools: Path
    input_file: Path
    out: Path
    common: dict  # variables of all runs
    known: list  # names of the input's variables
    measures: list  # [[word, ...], ...]
    ranks: int = 1
    picture: bool = False
    is_stopped: bool = False
    running: set = field(default_factory=set)  # processes that were started here
    lock: threading.Lock = field(default_factory=threading.Lock)

    def identity(self, run):
        """What a run's results depend on; another one needs another folder."""
        return {"input": self.input_file.name,
                "input_sha256": hashlib.sha256(self.input_file.read_bytes()).hexdigest(),
                "variables": {**self.common, **dict(run.variables)}}

    def folder(self, run):
        return self.out / run.name

    def can_resume(self):
        return {"go_on", "restart_from", "out"} <= set(self.known)

    def stop(self):
        """No further run; the engines that run are told to end."""
        with self.lock:
            self.is_stopped = True
            for process in self.running:
                process.terminate()

    def execute(self, words, **more):
        """Status of a program, which `stop` reaches."""
        with self.lock:
            if self.is_stopped:
                raise Failed("not run: the campaign was stopped")
            process = subprocess.Popen([str(w) for w in words], stdin=subprocess.DEVNULL, **more)
            self.running.add(process)
        try:
            return process.wait()
        finally:
            with self.lock:
                self.running.discard(process)


# --- what is known of a run --------------------------------------------------------------------


def read_record(folder):
    try:
        return json.loads((folder / "run.json").read_text())
    except FileNotFoundError:
        return {}
    except ValueError:
        raise Misuse(f"{folder / 'run.json'} cannot be read; remove the folder, or choose another --out") from None


def write_record(folder, record):
    part = folder / "run.json.part"
    part.write_text(json.dumps(record, indent=1) + "\n")
    part.replace(folder / "run.json")


def check_same(campaign, run):
    """A folder of results with other variables is never taken for this run's."""
    folder, wanted = campaign.folder(run), campaign.identity(run)
    record = read_record(folder)
    if not record:
        if folder.exists() and any(folder.iterdir()):
            raise Misuse(f"{folder} holds files that no such campaign made; remove the folder, or choose another --out")
        return
    before, now = record["variables"], wanted["variables"]
    differing = [n for n in sorted({*before, *now}) if before.get(n) != now.get(n)]
    if differing:
        n = differing[0]
        raise Misuse(f"{folder} was run with {n} = {before.get(n, 'its default')}, now it is "
                     f"{now.get(n, 'its default')}; choose another --out, or remove the folder")
    if record["input_sha256"] != wanted["input_sha256"]:
        raise Misuse(f"{folder} was run with another {record['input']}; choose another --out, or remove the folder")


def is_finished(campaign, run):
    record = read_record(campaign.folder(run))
    return bool(record.get("finished")) and record.get("measures") == campaign.measures


# --- running -----------------------------------------------------------------------------------


def starts_of(campaign, folder):
    """Restart files to go on from, the youngest first, then None. The youngest may be cut off when the run was
    killed: then the older one serves."""
    files = [f for f in (folder / "restart.1", folder / "restart.2") if f.is_file() and f.stat().st_size]
    return [*sorted(files, key=lambda f: -f.stat().st_mtime_ns), None] if campaign.can_resume() else [None]


def engine_words(campaign, run, start):
    folder = campaign.folder(run)
    variables = {**campaign.common, **dict(run.variables)}
    if "out" in campaign.known:
        variables["out"] = folder
    if start:
        variables |= {"go_on": "yes", "restart_from": start}
    words = ["mpirun", "-np", campaign.ranks] if campaign.ranks > 1 else []
    words += [campaign.engine, "-in", folder / "in.campaign", "-log", "none"]
    for name, value in variables.items():
        words += ["-var", name, value]
    return words


def last_error(folder):
    """The engine's last message, of its output or of a log file beside it."""
    for file in [folder / "output", *sorted(folder.glob("log.*"))]:
        lines = file.read_text(errors="replace").splitlines() if file.is_file() else []
        if errors := [line for line in lines if line.startswith("ERROR")]:
            return errors[-1]
    return f"see {folder / 'output'}"


def run_engine(campaign, run, say):
    """The engine, until the script's end; raises Failed."""
    folder = campaign.folder(run)
    (folder / "in.campaign").write_text(f'include {campaign.input_file}\nprint "{END}"\n')
    # where relative paths of the input lead somewhere; a stopped engine leaves a file there
    where = Path.cwd() if "out" in campaign.known and not campaign.can_resume() else folder
    for start in starts_of(campaign, folder):
        with open(folder / "output", "w") as output:
            status = campaign.execute(engine_words(campaign, run, start), cwd=where, stdout=output,
                                      stderr=subprocess.STDOUT)
        # the engine ends with status 0 after SIGTERM and Ctrl-C too
        if status == 0 and END in (folder / "output").read_text(errors="replace").splitlines():
            return
        if status == 0 or campaign.is_stopped:
            raise Failed("interrupted before its end; the same line goes on with it")
        going_on = f" when going on from {start.name}" if start else ""
        say(f"{run.name}: stopped{going_on}; see {folder / 'output'}\n    {last_error(folder)}")
    raise Failed("")


def seconds_before(folder, record):
    """Wall time of the parts that ran before; of a part that was killed until its last sign of life."""
    if "started" not in record:
        return record.get("seconds", 0.0)
    last = max((f.stat().st_mtime for f in folder.iterdir() if f.name != "run.json"), default=record["started"])
    return record.get("seconds", 0.0) + max(0.0, last - record["started"])


def version_of(engine):
    text = subprocess.run([engine, "--version"], capture_output=True, text=True, stdin=subprocess.DEVNULL).stdout
    return text.strip().splitlines()


def name_engine(campaign, folder):
    """Begins the log of an input that appends to it with the engine's version, which the report shows."""
    log = folder / f"log.{campaign.input_file.stem}"
    if campaign.can_resume() and not log.exists():
        text = subprocess.run([campaign.engine, "-help", "-log", "none"], capture_output=True, text=True,
                              stdin=subprocess.DEVNULL, cwd=folder).stdout
        log.write_text((text.splitlines() or [""])[0] + "\n")


def simulate(campaign, run, say):
    folder = campaign.folder(run)
    folder.mkdir(parents=True, exist_ok=True)
    record = read_record(folder)
    record = {**campaign.identity(run), "engine": version_of(campaign.engine), "ranks": campaign.ranks,
              "seconds": seconds_before(folder, record), "started": time.time()}
    write_record(folder, record)
    name_engine(campaign, folder)
    try:
        run_engine(campaign, run, say)
    finally:
        record["seconds"] += time.time() - record.pop("started")
        write_record(folder, record)
    record["finished"] = True
    write_record(folder, record)


# --- measuring ---------------------------------------------------------------------------------


def measure_files(measures):
    """Names of the CSV files of the measures: pile.csv, pile_2.csv, ..."""
    commands = [words[0] for words in measures]
    numbers = [commands[:k + 1].count(c) for k, c in enumerate(commands)]
    return [f"{c}.csv" if n == 1 else f"{c}_{n}.csv" for c, n in zip(commands, numbers)]


def measure(campaign, run):
    folder = campaign.folder(run)
    for words, name in zip(campaign.measures, measure_files(campaign.measures)):
        filled = []
        for word in words:
            word = word.replace("{out}", str(folder))
            filled += sorted(glob.glob(word)) or [word] if "*" in word else [word]
        part = folder / f"{name}.part"
        filled += ["--quiet", "--csv", part] + (["--picture", folder / "pile.svg"] if campaign.picture else [])
        with open(folder / "messages", "w") as messages:
            status = campaign.execute([campaign.tools, *filled], stdout=subprocess.DEVNULL, stderr=messages)
        if status != 0 or not part.is_file():
            lines = (folder / "messages").read_text(errors="replace").splitlines()
            raise Failed(f"ellipsoid-post {words[0]} failed: {lines[-1] if lines else f'status {status}'}")
        os.replace(part, folder / name)
    write_record(folder, {**read_record(folder), "measures": campaign.measures})


def last_row(file):
    with open(file, newline="") as stream:
        rows = list(csv.DictReader(stream))
    if not rows:
        raise Failed(f"{file} has no row")
    return rows[-1]


def split_measure(text):
    """Words of a --measure; the name of the program may stand first."""
    try:
        words = shlex.split(text)
    except ValueError as error:
        raise Misuse(f"--measure '{text}': {error}") from None
    words = words[1:] if words[:1] == ["ellipsoid-post"] else words
    if not words:
        raise Misuse("--measure is empty; give an ellipsoid-post command with its arguments")
    if "--csv" in words or "--quiet" in words:
        raise Misuse(f"--measure '{text}': --csv and --quiet are the driver's, leave them out")
    return words


def run_one(campaign, run, say):
    """One run and its measures; says what became of it."""
    begin = time.time()
    try:
        if is_finished(campaign, run):
            say(f"{run.name}: was finished before")
            return
        if not read_record(campaign.folder(run)).get("finished"):
            simulate(campaign, run, say)
        measure(campaign, run)
        say(f"{run.name}: finished after {time.time() - begin:.0f} s")
    except Failed as failure:
        if str(failure):
            say(f"{run.name}: {failure}")
