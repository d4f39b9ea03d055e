"""Links between the Markdown pages lead somewhere; the manual is made of all of them, without a
warning, and its search finds what stands on them."""

import html
import os
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(os.environ["ELLIPSOID_SOURCE"])
SKIPPED = 77  # as CTest is told
FOLDERS = [".", ".github", "inputs", "src_liggghts/doc", "postprocess/doc", "tests/bench"]


def pages():
    found = [page for folder in FOLDERS for page in sorted((ROOT / folder).glob("*.md"))]
    assert len(found) > 40, found
    return found


def prose(page):
    return re.sub(r"^```.*?^```|`[^`\n]*`", "", page.read_text(), flags=re.MULTILINE | re.DOTALL)


def anchors(page):
    """The anchors of a page's headings, as code forges and MyST make them."""
    headings = re.findall(r"^#+ +(.+)$", re.sub(r"^```.*?^```", "", page.read_text(),
                                                flags=re.MULTILINE | re.DOTALL), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).strip().replace(" ", "-")
            for heading in headings}


def dead_links(page, text):
    """Targets of relative links in `text`, as if it stood on `page`, that are not there."""
    dead = []
    for target in re.findall(r"\]\(([^)\s]+)\)", text):
        if re.match(r"https?://", target):
            continue
        path, _, anchor = target.partition("#")
        file = (page.parent / path).resolve() if path else page
        if not file.exists() or ROOT.resolve() not in [file, *file.resolve().parents]:
            dead.append(target)
        elif anchor and anchor not in anchors(file):
            dead.append(target)
    return dead


def check_links():
    dead = [f"{page.relative_to(ROOT)}: {target}"
            for page in pages() for target in dead_links(page, prose(page))]
    assert not dead, "links that lead nowhere: " + "; ".join(dead)
    readme = ROOT / "README.md"
    for fault in ("[x](no_such_file.md)", "[x](#no-such-heading)", "[x](../outside)"):
        assert dead_links(readme, fault), f"the check does not notice {fault}"


def make_manual():
    made = subprocess.run(["sphinx-build", "-q", "-W", "--keep-going", "-d", "doctrees", "-c",
                           ROOT / "src_liggghts" / "doc" / "manual", ROOT, "html"],
                          capture_output=True, text=True)
    assert made.returncode == 0, made.stderr
    return pathlib.Path("html")


def check_manual(folder):
    made = {file.relative_to(folder).with_suffix("").as_posix() for file in folder.rglob("*.html")}
    for page in pages():
        name = page.relative_to(ROOT).with_suffix("").as_posix()
        assert name in made, f"the manual lacks {name}"
    for file in folder.rglob("*.html"):
        for target in re.findall(r'(?:href|src)="([^"#?]+)', file.read_text()):
            if not re.match(r"[a-z]+:", target):
                assert (file.parent / html.unescape(target)).exists(), f"{file}: {target}"
    index = (folder / "searchindex.js").read_text()
    for word in ("superquadr", "restitut", "porosity"):  # stems, as the search makes them
        assert re.search(rf'\b{word}', index), f"the search does not know {word}"
    print(f"manual of {len(made)} pages")


check_links()
if not shutil.which("sphinx-build"):
    print("links checked; the manual is not made: sphinx-build is missing")
    sys.exit(SKIPPED)
check_manual(make_manual())
