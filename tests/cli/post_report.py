# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""The report page: what it says of piles, of other runs and of plain tables; its size; how it looks in a
browser on wide and narrow screens, light and dark, and on paper; the comparison with the paper.
"""
import base64
import html.parser
import os
import re
import shutil
import subprocess

from _synthetic import frame_text, particle, post, rows_of, wedge, write

#: the paper's piling problem (Markauskas et al. 2010, table 1 and section 4), as inputs/piling.in names it
PAPER = {"particles": "1000", "a": "2.7e-3", "b": "1.15e-3", "mass": "2e-5", "Imax": "3.445e-11",
         "Imin": "1.058e-11", "E": "183e6", "nu": "0.20", "mu": "0.3", "eta_n": "100.0", "eta_t": "100.0",
         "y0": "0.150", "interval": "0.04", "settle": "10.0", "g": "9.81", "direction": "displacement",
         "spacing": "paper"}


def log_text(seed, **changed):
    """A log as LIGGGHTS writes it: each line before and after a variable's value is put in."""
    lines = ["LIGGGHTS (Version LIGGGHTS-PUBLIC 3.8.0)"]
    for name, value in {**PAPER, **changed, "seed": str(seed)}.items():
        lines += [f"print some ${{{name}}}", f"print some {value}"]
    lines += ["fix grain all particletemplate/ellipsoid 15485863 atom_type 1 semiaxes 1 1 1 density 1",
              f"fix drop all insert/drop seed {seed} template grain particles 3 interval 1 box 0 1 0 1 0 1"]
    return "\n".join(lines) + "\n"


def run(folder, rows, log=""):
    """A run's folder; gives its dump."""
    os.makedirs(folder, exist_ok=True)
    if log:
        write(os.path.join(folder, "log.piling"), log)
    return write(os.path.join(folder, "pile.dump"), frame_text(7, rows))


def page_of(*arguments):
    post("report", *arguments, "-o", "report.html")
    with open("report.html", encoding="utf8") as file:
        return file.read()


class Page(html.parser.HTMLParser):
    """Tags with their attributes, texts of the tables' cells, and whether every tag is closed."""

    def __init__(self, text):
        super().__init__()
        self.tags, self.open, self.cells = [], [], []
        self.feed(text)
        self.close()
        assert not self.open, self.open

    def handle_starttag(self, tag, attributes):
        self.tags.append((tag, dict(attributes)))
        if tag not in ("meta", "img", "br"):
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag, tag

    def handle_data(self, data):
        if self.open and self.open[-1] in ("td", "th"):
            self.cells.append(data)

    def all(self, tag):
        return [attributes for name, attributes in self.tags if name == tag]


def check_form(text):
    page = Page(text)
    assert {"name": "viewport", "content": "width=device-width, initial-scale=1"} in page.all("meta")
    tables = page.all("table")
    assert tables and len(page.all("caption")) == len(tables)
    assert all(th.get("scope") in ("col", "row") for th in page.all("th"))
    links = [a["href"] for a in page.all("a")]
    sections = [s["id"] for s in page.all("section")]
    assert [link[1:] for link in links if link.startswith("#")] == sections and len(set(sections)) == len(sections)
    assert all(not re.match(r"https?:", value or "") for _, a in page.tags for value in a.values()), "from elsewhere"
    assert all(image["alt"] for image in page.all("img"))
    return page


def pictures_of(text, section):
    """Bytes of the pictures of a section."""
    found = re.search(rf'<section id="{section}">(.*?)</section>', text, re.S).group(1)
    return [base64.b64decode(data) for data in re.findall(r"base64,([^\"]+)", found)]


def check_piles():
    paper = [run(f"paper/seed{k}", wedge(25.0 - k), log_text(k)) for k in (1, 2)]
    other = run("other/mu", wedge(22.0, 0.04, 5), log_text(3, mu="0.5", particles="100"))
    alone = run("alone/run", wedge(24.0))
    shutil.copy(write("view_1.html", '<!DOCTYPE html><meta name="generator" content="ellipsoid-post view">'),
                "paper/seed1/turn.html")
    text = page_of(*paper, other, alone, "--view", "view_1.html")
    check_form(text)
    rows = rows_of("pile", *paper)
    compared = re.search(r'<section id="compared-with-the-paper">(.*?)</section>', text, re.S).group(1)
    line = re.search(r'<tr><th scope="row">porosity</th>(.*?)</tr>', compared).group(1)
    mean = sum(float(row["porosity"]) for row in rows) / 2  # of the two with the paper's parameters, not of all
    assert f"<td>{mean:.4g} ± " in line and "<td>2</td>" in line and "<td>0.13 ± 0.0052</td>" in line, line
    assert f"<td>{100 * (mean / 0.13 - 1):+.1f}</td>" in line, line
    assert "other/mu: particles 100 (paper: 1000), coefficient of friction 0.5 (paper: 0.3)" in compared, compared
    assert "alone/run: no log beside the dump" in compared, compared
    assert "without its values" in text and not any(b"paper" in figure for figure in pictures_of(text, "figures"))
    assert "seed of fix grain (particletemplate/ellipsoid) = 15485863" in text  # all have it
    assert '<th scope="col">seed of fix drop (insert/drop)</th><th scope="col">mu</th>' in text
    assert '<tr><th scope="row">other/mu</th><td>3</td><td>0.5</td><td>100</td><td>3</td></tr>' in text
    assert 'href="paper/seed1/turn.html"' in text and 'href="view_1.html"' in text
    command = re.search(r"<pre>(.*?)</pre>", text, re.S).group(1)
    assert " report paper/seed1/pile.dump " in command and command.endswith("-o report.html"), command
    sizes = []  # of b in each picture: the ellipses' second semi-axis, the radius of a chain's middle sphere
    for picture in pictures_of(text, "piles"):
        found = re.findall(r'<ellipse rx="[\d.]+" ry="([\d.]+)"', picture.decode()) or \
            [max(re.findall(r' r="([\d.]+)"', picture.decode()), key=float)]
        sizes.append(float(found[0]))
    assert len(sizes) == 4 and max(sizes) - min(sizes) < 2e-3, sizes

    text = page_of(*paper)
    assert "As figure 12 of the paper, with its values" in text and "Not compared" not in text
    assert all(b"(paper)" in figure for figure in pictures_of(text, "figures")[:2])
    for variable in PAPER:
        changed = "velocity" if variable == "direction" else "minimax" if variable == "spacing" else "1.5"
        text = page_of(run("one/changed", wedge(), log_text(1, **{variable: changed})))
        assert "Not compared" in text and f"{changed} (paper: " in text and "difference" not in \
            re.search(r'<section id="compared.*?</section>', text, re.S).group(0), variable
    text = page_of(run("one/changed", wedge(), "\n".join(log_text(1).splitlines()[:9]) + "\n"))
    assert "another problem" in text


def check_other_runs():
    rows = [particle(k + 1, 0.01 * k, 0.01, 0.3 * k) for k in range(5)]
    for k, row in enumerate(rows):
        row["z"] = 0.004 * k
    os.makedirs("space", exist_ok=True)
    dump = write("space/bed.dump", frame_text(3, rows))
    write("mixing.csv", "time_s,lacey_index,case,neighbour_index\n0,0.1,a,0.2\n1,0.5,a,\n2,0.8,a,0.7\n")
    text = page_of(dump, "--table", "mixing.csv", "--curve", "mixing.csv", "time_s", "lacey_index")
    page = check_form(text)
    sections = [s["id"] for s in page.all("section")]
    assert sections == ["measures", "particles", "runs", "parameters", "how-this-page-was-made"], sections
    assert "0.8" in page.cells and "angle of repose" not in text
    text = page_of("--curve", "mixing.csv", "time_s", "lacey_index,neighbour_index")
    assert "lacey index, neighbour index over time (s): mixing.csv (1 of 3 rows have no number in" in text, text[-3000:]
    (picture,) = [base64.b64decode(data) for data in re.findall(r"svg\+xml;base64,([^\"]+)", text)]
    assert picture.count(b"<circle") == 3 + 2 + 2, "points of two curves and their marks in the legend"
    text = page_of("--table", "mixing.csv", "--title", "A <mixture>")
    assert [s["id"] for s in check_form(text).all("section")] == ["measures", "how-this-page-was-made"]
    assert "<h1>A &lt;mixture&gt;</h1>" in text and "--title 'A &lt;mixture&gt;'" in text
    _, error = post("report", "-o", "none.html", expect=1)
    assert "nothing to report" in error and not os.path.exists("none.html")


def check_many():
    """45 runs, most with more ellipses than fit into a page as outlines."""
    dumps = [run(f"many/n{k}_seed{s}", wedge(20.0 + s, 0.09, k), log_text(s, subspheres=str(k)))
             for k in (0, 5, 17) for s in range(1, 16)]
    text = page_of("many")
    assert len(dumps) == 45 and len(text.encode()) < 2e6, len(text.encode())
    check_form(text)
    header = post("pile", dumps[0], "--csv", "-")[0].splitlines()[0].split(",")
    runs = re.search(r'<section id="runs">(.*?)</section>', text, re.S).group(1)
    columns = re.findall(r'<th scope="col">', runs)
    assert len(columns) >= len(header) and runs.count("n17_seed15") >= 4, (len(columns), len(header))
    return text


PROBE = """<script>addEventListener("load", () => {
  const wide = [...document.querySelectorAll("table, img, pre")].map((e) => e.getBoundingClientRect().right);
  const colour = (e) => getComputedStyle(e).backgroundColor;
  const answer = {width: innerWidth, page: document.documentElement.scrollWidth, widest: Math.max(...wide),
                  ground: colour(document.body), ink: getComputedStyle(document.body).color,
                  broken: [...document.images].filter((i) => !i.naturalWidth).length};
  const element = document.createElement("pre");
  element.id = "answer";
  element.textContent = Object.entries(answer).map(([k, v]) => k + "=" + v).join(";");
  document.body.append(element);
});</script></body>"""


def look(text, width, *options):
    """What a browser says of the page in a window of this width."""
    browser = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
    if not browser:
        raise SystemExit("this test needs Chromium: install it (Debian: apt-get install chromium)")
    # headless windows are not narrower than 500 pixels: a frame is
    with open("framed.html", "w", encoding="utf8") as file:
        file.write(text.replace("</body>", PROBE))
    with open("frame.html", "w", encoding="utf8") as file:
        file.write(f'<!DOCTYPE html><meta charset="utf-8"><iframe id="f" src="framed.html" width="{width}" height="900" '
                   'style="border:0"></iframe><pre id="said"></pre><script>document.getElementById("f").onload = () => '
                   'setTimeout(() => { document.getElementById("said").textContent = document.getElementById("f")'
                   '.contentDocument.getElementById("answer").textContent; }, 500);</script>')
    command = [browser, "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run",
               "--allow-file-access-from-files", "--user-data-dir=profile", "--window-size=1400,1000",
               "--virtual-time-budget=60000", *options, "--dump-dom"]
    done = subprocess.run([*command, "file://" + os.path.abspath("frame.html")], capture_output=True, text=True,
                          timeout=200)
    said = re.search(r'<pre id="said">([^<]+)</pre>', done.stdout)
    assert said, done.stdout[-500:] + done.stderr[-500:]
    return dict(part.split("=") for part in said.group(1).split(";"))


def brightness(colour):
    return sum(int(x) for x in re.findall(r"\d+", colour)[:3]) / 765


def check_look(text):
    for width in (1200, 400):
        seen = look(text, width)
        assert int(seen["width"]) == width and int(seen["page"]) <= width and seen["broken"] == "0", seen
        assert brightness(seen["ground"]) > 0.9 and brightness(seen["ink"]) < 0.3, seen
    dark = look(text, 1200, "--blink-settings=preferredColorScheme=0")
    assert brightness(dark["ground"]) < 0.2 and brightness(dark["ink"]) > 0.7, dark
    # on paper: A4 across, less its margins, is 1032 pixels wide; nothing scrolls there
    printed = look(text.replace("@media print", "@media all"), 1032)
    assert float(printed["widest"]) <= 1032, printed


check_piles()
check_other_runs()
check_look(check_many())
