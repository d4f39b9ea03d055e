"""The manual: all Markdown pages of the repository as one HTML tree with a search.

    sphinx-build -W -c src_liggghts/doc/manual . OUTPUT     (from the root of the repository)
"""

import pathlib
import re

from pygments.lexers.special import TextLexer

repository = pathlib.Path(__file__).resolve().parents[3]
version_header = repository / "src_liggghts" / "kernel" / "math" / "package_version.h"

project = "liggghts-ellipsoid"
release = version = re.search(r'package_version\[\] = "(.+)"', version_header.read_text())[1]
extensions = ["myst_parser"]
myst_heading_anchors = 4
root_doc = "README"
include_patterns = ["README.md", "*/doc/*.md", "tests/bench/*.md", ".github/*.md", "inputs/README.md"]
exclude_patterns = ["build*", "out"]
suppress_warnings = ["misc.highlighting_failure", "myst.header"]
html_extra_path = ["index.html"]
html_static_path, html_css_files = ["static"], ["manual.css"]
html_theme = "sphinx_rtd_theme"
html_theme_options = {"navigation_depth": 3, "collapse_navigation": True}
html_show_sphinx = html_show_copyright = html_copy_source = False

# what stands in the menu below a page, by the name of the page
MENU = {
    "README": ["src_liggghts/doc/README", "postprocess/doc/README", "src_liggghts/doc/verification",
               "tests/bench/README", "inputs/README", ".github/CONTRIBUTING", "src_liggghts/doc/CHANGELOG"],
    "src_liggghts/doc/README": "src_liggghts/doc/*.md",
    "postprocess/doc/README": "postprocess/doc/*.md",
}


def pages_below(name):
    if isinstance(MENU[name], list):
        return MENU[name]
    pages = sorted(path.relative_to(repository).with_suffix("").as_posix()
                   for path in repository.glob(MENU[name]))
    return [page for page in pages if page != name and page not in MENU["README"]]


def without_links_to_sources(text):
    """Links to folders and to files that are no pages have no place in the manual: their words stay."""
    return re.sub(r"(?<!!)\[([^\]]*)\]\((?!https?:|#)([^)\s]*)\)",
                  lambda link: link[0] if re.search(r"\.md(#.*)?$", link[2]) else link[1], text)


def read_page(app, name, source):
    source[0] = without_links_to_sources(source[0])
    if name in MENU:
        source[0] += "\n\n```{toctree}\n:hidden:\n\n" + "".join(
            f"/{page}\n" for page in pages_below(name)) + "```\n"


def setup(app):
    app.add_lexer("liggghts", TextLexer)
    app.connect("source-read", read_page)
