# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""Every command and every option of ellipsoid-post stands in its page, and in its --help."""
import os
import re

from _synthetic import post

PAGES = os.path.join(os.environ["ELLIPSOID_SOURCE"], "postprocess", "doc")


def page(name):
    with open(os.path.join(PAGES, name + ".md"), encoding="utf8") as file:
        return file.read()


def commands():
    text = post("--help")[0]
    return re.findall(r"^  ([a-z0-9]+)[, ]", text.split("Subcommands:")[1], re.MULTILINE)


def main():
    shared = page("README")
    names = commands()
    assert len(names) >= 16, names
    for name in names:
        assert f"[{name}]({name}.md)" in shared, name
        text = page(name)
        for heading in ("Syntax", "Examples", "Description", "Related commands", "References"):
            assert f"## {heading}\n" in text, (name, heading)
        options = re.findall(r"^ {2,4}(?:-\w,)?(--[a-z0-9-]+)", post(name, "--help")[0], re.MULTILINE)
        assert options, name
        for option in options:
            assert option == "--help" or option in text or option in shared, (name, option)
    pages = {file[:-3] for file in os.listdir(PAGES) if file.endswith(".md")} - {"README", "comparison", "python"}
    assert pages == set(names), pages ^ set(names)
    for name in names:
        assert f"[{name}]({name}.md)" in page("comparison"), name


main()
