"""Every script of inputs/ is listed in the index of the pages, and its head says how to run it, what one should see, and which lines to change; the tests run each of them."""

import os
import pathlib
import re

ROOT = pathlib.Path(os.environ["ELLIPSOID_SOURCE"])


def main():
    index = (ROOT / "src_liggghts" / "doc" / "README.md").read_text()
    tests = "\n".join(file.read_text() for file in (ROOT / "tests").rglob("*.py"))
    scripts = sorted((ROOT / "inputs").glob("*.in"))
    assert len(scripts) >= 8, scripts
    for script in scripts:
        assert f"`{script.name}`" in index, f"{script.name} is not in the index of the pages"
        text = script.read_text()
        head = re.match(r"(#.*\n)+", text).group(0)
        for pattern in (r"-in (\S*/)?" + script.name, r"What to (see|look at):", "change"):
            assert re.search(pattern, head), f"{script.name}: its head lacks '{pattern}'"
        assert re.search(r"^variable +\w+ +index ", text, re.MULTILINE), script.name
        assert "check/timestep/ellipsoid" in text, f"{script.name} does not check its time step"
        lost = set(re.findall(r"^thermo_modify .*\blost (\S+)", text, re.MULTILINE))
        if script.name == "hopper.in":  # grains that miss a dish leave the box; on the floor none is lost
            kinds = dict(re.findall(r"^label +ground_(\w+)\n(?:(?!label).*\n)*?variable +lost string (\w+)", text, re.MULTILINE))
            assert lost == {"${lost}"} and kinds == {"floor": "error", "none": "ignore", "dish": "ignore"}, (lost, kinds)
        else:
            grains_leave = script.name == "benchmark_silo.in"  # they flow out of the box, and are counted
            assert lost == {"ignore" if grains_leave else "error"}, f"{script.name}: lost {lost}"
        assert re.search(rf'"{script.stem}"|{script.name}', tests), f"no test runs {script.name}"
    print(f"{len(scripts)} scripts")


main()
