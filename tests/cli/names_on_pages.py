"""Files, folders, functions and types that the pages for developers name are there."""

import os
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(os.environ["ELLIPSOID_SOURCE"])

PAGES = [".github/CONTRIBUTING.md", "src_liggghts/doc/method.md", "src_liggghts/doc/one_time_step.md",
         "src_liggghts/doc/add_a_contact_law.md", "tests/bench/README.md", "src_liggghts/README.md",
         "src_liggghts/kernel/README.md", "postprocess/README.md", "postprocess/measures/README.md",
         "postprocess/commands/README.md",
         "tests/README.md", "patches/README.md"]

# what is the host's, and names that stand for many: NAME_command.cpp, NNNN-name.HOST.patch
OTHERS = re.compile(r"Make\.sh|\*|\.\.\.|\bNAME|NAME\b|NNNN|HOST|RUN|COMMAND|FOLDER|TREE|SUITE")
FILE = re.compile(r"[\w./-]+\.(?:h|cpp|py|sh|cmake|in|patch|whitelist)")
PATH = re.compile(r"[a-z_]+(?:/[\w.]+)+")
SYMBOL = re.compile(r"(?:\w+::)*(\w+)(?:\(\)|<.*>)?")


def tracked_files():
    """Without git: all files but those of builds."""
    if shutil.which("git"):
        listed = subprocess.run(["git", "-C", ROOT, "ls-files"], capture_output=True, text=True)
        if listed.returncode == 0 and listed.stdout:
            return listed.stdout.split("\n")[:-1]
    files = (file.relative_to(ROOT) for file in ROOT.rglob("*") if file.is_file())
    return [str(file) for file in files if not file.parts[0].startswith("build")]


def inline_code(page):
    prose = re.sub(r"^```.*?^```|^    .*?$", "", page, flags=re.MULTILINE | re.DOTALL)
    return re.findall(r"`([^`\n]+)`", prose)


def is_symbol(word):
    """Whether a word of code can only be a name of the sources: f(), TwoWords, two_words."""
    match = SYMBOL.fullmatch(word)
    if not match:
        return False
    name = match.group(1)
    return bool(word.endswith("()") or re.fullmatch(r"[A-Z]\w*[a-z]\w*[A-Z]\w*", name)
                or re.fullmatch(r"[a-z]+(_[a-z0-9]+)+", name) and "." not in word)


class Tree:
    def __init__(self, files):
        self.files = files
        self.paths = set(files)
        for file in files:
            self.paths.update(str(parent) for parent in pathlib.PurePath(file).parents)
        self.ends = {}
        for path in self.paths:
            parts = path.split("/")
            for k in range(len(parts)):
                end = "/".join(parts[k:])
                self.ends.setdefault(end, path)
                self.ends.setdefault(re.sub(r"\.\w+$", "", end), path)
        text = "\n".join((ROOT / file).read_text(errors="replace") for file in files
                         if not file.endswith((".md", pathlib.Path(__file__).name))
                         and (ROOT / file).stat().st_size < 1000000)
        self.words = set(re.findall(r"\w+", text))

    def has_path(self, path):
        return path.rstrip("/") in self.ends

    def has_symbol(self, word):
        return SYMBOL.fullmatch(word).group(1) in self.words


def unknown_names(page, tree):
    unknown = []
    for code in inline_code(page):
        word = code.strip()
        if OTHERS.search(word) or word.startswith(("build", "out/", "-", "../")):
            continue
        if FILE.fullmatch(word):
            known = tree.has_path(word)
        elif PATH.fullmatch(word) and tree.has_path(word.split("/")[0]):
            known = tree.has_path(word)
        elif is_symbol(word):
            known = tree.has_symbol(word) or tree.has_path(word)
        else:
            continue
        if not known:
            unknown.append(word)
    return unknown


def main():
    tree = Tree(tracked_files())
    complaints = [f"{name}: `{word}` is nowhere in the tree"
                  for name in PAGES for word in unknown_names((ROOT / name).read_text(), tree)]
    for fault in ("`motion_of_ghosts()`", "`GhostMotions`", "`kernel/ghosts`", "`kernel/law/ghost_laws.h`",
                  "`ghost_motion`"):
        if not unknown_names(fault, tree):
            complaints.append(f"this test does not notice {fault}")
    for name in ("`find_contact()`", "`kernel/law`", "`pairs/smooth_contacts`", "`law/contact_laws.cpp`"):
        if unknown_names(name, tree):
            complaints.append(f"this test does not find {name}")
    print("\n".join(complaints) if complaints else f"{len(PAGES)} pages name what is there")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
