"""Every registered style has a page, with every keyword and every section, listed in the index.

Styles are found in src_liggghts/*.h; their keywords in these headers, in the sources of the same
name, and in what both include from src_liggghts/. Complete scripts on the pages are run.
"""

import os
import pathlib
import re
import subprocess
import sys

SECTIONS = ["Syntax", "Examples", "Description", "Output and restart", "Restrictions",
            "Related commands", "Default", "References"]

PAGES = pathlib.Path(os.environ.get("ELLIPSOID_SOURCE", ".")) / "src_liggghts" / "doc"

# macro of the registration -> first part of the page's name
KINDS = {
    "AtomStyle": "atom_style", "PairStyle": "pair_style", "FixStyle": "fix",
    "ComputeStyle": "compute", "RegionStyle": "region", "CommandStyle": "command",
    "DumpStyle": "dump", "NORMAL_MODEL": "model", "TANGENTIAL_MODEL": "tangential",
    "COHESION_MODEL": "cohesion", "ROLLING_MODEL": "rolling_friction", "SURFACE_MODEL": "surface",
}
STYLE = re.compile(r"^([A-Z]\w*Style)\(\s*([^,\s]+)\s*,", re.MULTILINE)
MODEL = re.compile(r"^(\w+_MODEL)\(\s*\w+\s*,\s*([^,\s]+)\s*,", re.MULTILINE)
WORD = r'"([\w/]+)"'


def styles(sources):
    """{page name: file that registers it}"""
    found = {}
    for name, text in sources.items():
        if not name.endswith(".h"):
            continue
        for kind, style in STYLE.findall(text) + MODEL.findall(text):
            if kind not in KINDS:
                raise SystemExit(f"{name}: registration by the unknown macro {kind}; add it to "
                                 f"KINDS of this test")
            found[f"{KINDS[kind]}_{style.replace('/', '_')}.md"] = name
    return found


def sources_of(header, sources):
    """The text that makes up a style: its files and what they include of their room, but no other style."""
    other_styles = set(styles(sources).values()) - {header}
    todo, done = [header], set()
    while todo:
        name = todo.pop()
        if name in done or name in other_styles or name not in sources:
            continue
        done.add(name)
        todo.append(name[:-2] + ".cpp" if name.endswith(".h") else name[:-4] + ".h")
        room = name.rpartition("/")[0]
        todo += [f"{room}/{included}" if room else included
                 for included in re.findall(r'^#include "([\w.]+)"', sources[name], re.MULTILINE)]
    return "\n".join(sources[name] for name in sorted(done))


def choices(text):
    """Words of choice lists: reader.choice(keyword, {"a", "b"}) or a list that has a name."""
    words = set()
    for arguments in re.findall(r"\.choice\(\s*[^,]+,\s*(\{[^{}]*\}|\w+)", text):
        if not arguments.startswith("{"):
            definition = re.search(rf"\b{arguments}\b[^;{{]*(\{{[^{{}}]*\}})", text)
            if not definition:
                raise SystemExit(f"the words of the list '{arguments}' were not found; define it as "
                                 f"a list of literals")
            arguments = definition.group(1)
        words |= set(re.findall(WORD, arguments))
    if re.search(r"\.yes_no\(", text):
        words |= {"yes", "no"}
    return words


def words_of_parsers(text, sources):
    """Words that functions NAME_from_word() of the kernel read."""
    words = set()
    for function in set(re.findall(r"\b(\w+_from_word)\(", text)):
        for source in sources.values():
            for body in re.findall(rf"\b{function}\([^)]*\) \{{\n(.*?)^\}}", source, re.MULTILINE | re.DOTALL):
                words |= set(re.findall(rf"== {WORD}", body))
                if "row.word" in body:
                    table = re.search(r"\brows\[\] = \{\n(.*?)^\};", source, re.MULTILINE | re.DOTALL)
                    words |= set(re.findall(WORD, table.group(1)))
        if not words:
            raise SystemExit(f"the words that {function}() reads were not found; compare with == in its body, or "
                             f"with row.word of a table rows[]")
    return words


def keywords(header, sources):
    """Every word that the style of this header accepts, as far as the sources show."""
    text = sources_of(header, sources)
    words = choices(text) | words_of_parsers(text, sources)
    for pattern in (rf"\bkeyword == {WORD}", rf"{WORD} == keyword\b",
                    rf"strcmp\(\s*\w*arg\w*\[[^\]]*\]\s*,\s*{WORD}\s*\)",
                    rf"\.register\w*Setting(?:<[^>]*>)?\(\s*{WORD}",
                    rf"\baddOption\(\s*{WORD}",
                    rf"registerProperty\(\s*{WORD}\s*,\s*&ellipsoid_host::"):
        words |= set(re.findall(pattern, text))
    for call, values in (("registerOnOff", {"on", "off"}), ("registerYesNo", {"yes", "no"})):
        names = re.findall(rf"\.{call}\(\s*{WORD}", text)
        words |= set(names) | (values if names else set())
    return words


def code_of(page):
    """What is set as code on a page."""
    blocks = re.findall(r"^```\w*\n(.*?)^```", page, re.MULTILINE | re.DOTALL)
    rest = re.sub(r"^```.*?^```", "", page, flags=re.MULTILINE | re.DOTALL)
    return "\n".join(blocks + re.findall(r"`([^`]+)`", rest))


def check_page(name, page, wanted):
    complaints = []
    parts = re.split(r"^## (.+)$", page, flags=re.MULTILINE)
    headings, bodies = parts[1::2], parts[2::2]
    if headings != SECTIONS:
        complaints.append(f"{name}: the sections are {headings}, wanted in this order: {SECTIONS}")
    complaints += [f"{name}: section '{heading}' is empty"
                   for heading, body in zip(headings, bodies) if not body.strip()]
    code = code_of(page)
    complaints += [f"{name}: keyword '{word}' is accepted by the sources, but not on the page (as code)"
                   for word in sorted(wanted)
                   if not re.search(rf"(?<![\w/]){re.escape(word)}(?![\w/])", code)]
    return complaints


def check_links(pages):
    complaints = []
    for name, page in pages.items():
        prose = re.sub(r"^```.*?^```", "", page, flags=re.MULTILINE | re.DOTALL)
        complaints += [f"{name}: link to '{target}', which does not exist"
                       for target in re.findall(r"\]\(([^)#:]+)\)", prose)
                       if target not in pages and not (PAGES / target).exists()]
        if name != "README.md" and f"]({name})" not in pages.get("README.md", ""):
            complaints.append(f"README.md: does not list {name}")
    return complaints


def check(sources, pages):
    """All complaints about the pages, one line each."""
    complaints = check_links(pages)
    registered = styles(sources)
    for name, header in sorted(registered.items()):
        if name not in pages:
            complaints.append(f"{name}: missing; the style is registered in {header}")
        else:
            complaints += check_page(name, pages[name], keywords(header, sources))
    prefixes = tuple(kind + "_" for kind in KINDS.values())
    complaints += [f"{name}: no such style is registered" for name in sorted(pages)
                   if name.startswith(prefixes) and name not in registered]
    return complaints


def check_the_check(sources, pages):
    """Each kind of fault, put in on purpose, must be found."""
    fix, model = "fix_nve_ellipsoid.md", "tangential_history_viscous.md"

    def edited(page, old, new):
        return sources, {**pages, page: pages[page].replace(old, new)}

    faults = {
        "page removed": (sources, {k: v for k, v in pages.items() if k != fix}),
        "style added": ({**sources, "fix_new.h": "FixStyle(new/style,FixNewStyle)\n"}, pages),
        "model added": ({**sources, "normal_model_new.h": "NORMAL_MODEL(NEW,new/law,63)\n"}, pages),
        "keyword of a fix": edited(fix, "planar", "plane"),
        "word read by the kernel": edited("fix_particletemplate_ellipsoid.md", "minimax_area", "x"),
        "choice of a fix": edited(fix, "yes", "y"),
        "setting of a model": edited(model, "direction", "x"),
        "option of a setting": edited(model, "velocity", "x"),
        "property of a model": edited(model, "viscousDampingTangential", "x"),
        "section removed": edited(fix, "## Default", ""),
        "section empty": (sources, {**pages, fix: re.sub(
            r"(## Default\n).*?(?=\n## )", r"\1", pages[fix], flags=re.DOTALL)}),
        "index": edited("README.md", f"({fix})", ""),
        "dead link": edited(fix, "](", "](not_"),
        "page without style": (sources, {**pages, "fix_old.md": pages[fix]}),
    }
    return [f"this test does not notice: {what}" for what, (s, p) in faults.items()
            if not check(s, p)]


def run_scripts(pages, liggghts):
    """Complete scripts (code blocks of language liggghts with a run command) must run."""
    complaints, count = [], 0
    for name, page in sorted(pages.items()):
        for script in re.findall(r"^```liggghts\n(.*?)^```", page, re.MULTILINE | re.DOTALL):
            if not re.search(r"^run\s", script, re.MULTILINE):
                continue
            count += 1
            file = pathlib.Path(f"{name}.{count}.in")
            file.write_text(script)
            result = subprocess.run([liggghts, "-in", file], capture_output=True, text=True,
                                    timeout=300 * int(os.environ.get("ELLIPSOID_SLOWNESS", "1")))
            if result.returncode != 0 or "ERROR" in result.stdout:
                complaints.append(f"{name}: script {file} fails: {result.stdout[-300:]}")
    print(f"{count} scripts of the pages run")
    return complaints


def main():
    if "ELLIPSOID_SOURCE" not in os.environ:
        raise SystemExit("ELLIPSOID_SOURCE is not set; set it to the root of the repository")
    folder = pathlib.Path(os.environ["ELLIPSOID_SOURCE"]) / "src_liggghts"
    sources = {str(f.relative_to(folder)): f.read_text() for f in sorted(folder.rglob("*"))
               if f.suffix in (".h", ".cpp") and "doc" not in f.parts}
    pages = {f.name: f.read_text() for f in (folder / "doc").glob("*.md")}
    complaints = check(sources, pages)
    if not complaints:
        complaints = check_the_check(sources, pages)
    if "ELLIPSOID_BIN" in os.environ:
        complaints += run_scripts(pages, pathlib.Path(os.environ["ELLIPSOID_BIN"]) / "liggghts")
    else:
        print("ELLIPSOID_BIN is not set: the scripts of the pages are not run")
    registered = styles(sources)
    count = sum(len(keywords(header, sources)) for header in registered.values())
    print(f"{len(registered)} styles, {count} keywords, {len(pages)} pages")
    for complaint in complaints:
        print(complaint, file=sys.stderr)
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
