"""Makes a small source tree that the patch series fits, without any code of a host: of each file that
is patched only the lines that the patches stand on, at their places, the rest filled up.

    python3 _made_tree.py FOLDER BRANCH VERSION [VARIANT...]
"""
import os
import pathlib
import re
import sys

PATCHES = pathlib.Path(os.environ["ELLIPSOID_SOURCE"]) / "patches"
EXPECTED = ("Make.sh lammps.cpp contact_models.h pair_gran_proxy.h fix_wall_gran.h "
            "fix_contact_history.h atom_vec_superquadric.h").split()


def series(variants):
    """The patches, in the form of one of the variants where there is one."""
    for base in sorted(PATCHES.glob("[0-9]*.patch")):
        if base.name.count(".") == 1:
            own = [base.with_suffix(f".{variant}.patch") for variant in variants]
            yield next((file for file in own if file.exists()), base)


def hunks(patch):
    """File, line and old lines of each hunk; a line is None where the file has to end."""
    file, found = None, []
    for line in patch.read_text().split("\n"):
        place = re.match(r"@@ -(\d+)", line)
        if line.startswith("+++ "):
            file = line.split()[1][2:]
        elif place:
            found.append((file, int(place[1]), []))
        elif found and line[:1] in (" ", "-") and not line.startswith("--- "):
            found[-1][2].append(line[1:])
        elif found and line[:1] == "+":
            found[-1][2].append(None)
    return [(file, first, [line for line in old if line is not None] + old[-1:].count(None) * [None])
            for file, first, old in found]


def write_tree(folder, branch, version, *variants):
    places = {}
    for patch in series(variants):
        for file, first, old in hunks(patch):
            places.setdefault(file, []).append((first, old))
    for file, of_file in places.items():
        lines = []
        for first, old in sorted(of_file):
            while len(lines) + 1 < first:
                lines.append(f"// line {len(lines) + 1}")
            lines += old
        text = "\n".join(line for line in lines if line is not None)
        (folder / file).parent.mkdir(parents=True, exist_ok=True)
        (folder / file).write_text(text + ("\n" if lines[-1] is None else "\n// the end\n"))
    for name in EXPECTED:
        if not (folder / "src" / name).exists():
            (folder / "src" / name).write_text("// empty\n")
    (folder / "src/version_liggghts.txt").write_text(version + "\n")
    (folder / "src/version_liggghts_branch.txt").write_text(branch + "\n")


write_tree(pathlib.Path(sys.argv[1]), *sys.argv[2:])
