"""On what the benchmark ran: processor, load, compiler and its flags, revision of the source."""

import json
import os
import platform
import re
import subprocess
from pathlib import Path

SOURCE = Path(__file__).parent.parent.parent


def output_of(*command):
    try:
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()
    except (OSError, subprocess.CalledProcessError):
        return "unknown"


def processor():
    found = re.search(r"model name\s*:\s*(.+)", Path("/proc/cpuinfo").read_text())
    return found.group(1) if found else platform.processor()


def compile_command(build, file):
    """Compiler and flags with which one source file was compiled."""
    database = build / "compile_commands.json"
    if not database.exists():
        return "unknown"
    for entry in json.loads(database.read_text()):
        if entry["file"].endswith(file):
            words = entry["command"].split()
            compiler = next(w for w in words if re.search(r"(\+\+|cc|clang)(-[\d.]+)?$", w)
                            and "ccache" not in w)
            flags = [w for w in words if re.match(r"-(O|f|m|std)", w) and "prefix-map" not in w]
            return f"{output_of(compiler, '--version').splitlines()[0]}; {' '.join(flags)}"
    return "unknown"


def description(engine):
    """Lines of text."""
    build = engine.parent.parent
    return "\n".join([
        f"Machine: {processor()}, {os.cpu_count()} cores; load {os.getloadavg()[0]:.1f} at the start",
        f"Compiler of the kernel: {compile_command(build, 'kernel/multisphere/multisphere_contact.cpp')}",
        f"Compiler of the engine: {compile_command(build, 'pair_gran_ellipsoid.cpp')}",
        f"Source: {output_of('git', '-C', str(SOURCE), 'describe', '--always', '--dirty')}; all shapes run "
        "in the same engine: spheres, superquadrics and rigid bodies are the host's unchanged styles in it"])
