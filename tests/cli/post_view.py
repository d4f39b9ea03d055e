# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""The page of `ellipsoid-post view` in a headless browser.

Oracle: rays through pixels against ellipsoids and spheres, written again with numpy: which body is at a
pixel, and how it is lit; the dump's own numbers for what the page says of a particle.
"""
import csv
import io
import json
import pathlib
import struct
import sys

import numpy as np

from _browser import ask
from _oracles import rotation
from _png import pixels_of
from _synthetic import frame_text, post

COLUMNS = ("id type mass x y z vx vy vz omegax omegay omegaz quat1 quat2 quat3 quat4 "
           "shapex shapey shapez f_subspheres heat").split()
SEED = 20100213
SIZE = (640, 480)
PALETTE = [(0, 114, 178), (230, 159, 0), (0, 158, 115)]


def scene(rng, count=24):
    """Triaxial, oblate (longest axis not the first), spheres and chains of five spheres, overlapping in the picture."""
    rows = []
    for k in range(count):
        q = rng.normal(size=4)
        q /= np.linalg.norm(q)
        axes = [(3e-3, 2e-3, 1e-3), (1e-3, 2.5e-3, 2.5e-3), (1.5e-3,) * 3, (2.7e-3, 1.15e-3, 1.15e-3)][k % 4]
        chain = 5 if k % 4 == 3 else 0
        place = rng.uniform((-6e-3, 1e-2, 5.0), (6e-3, 2e-2, 5.012))
        rows.append(dict(zip(COLUMNS, (1000000 + 7 * k, 1 + k % 3, 2e-5, *place, 0.1 * k, 0, 0, 0, 0, 50 - k, *q, *axes,
                                       chain, 1e-3 * k * k))))
    return rows


def bodies_of(row, spheres_of_chain):
    """Ellipsoids of a particle: (centre, rotation, semi-axes)."""
    centre, turn = np.array([row[c] for c in "xyz"]), rotation([row[f"quat{k}"] for k in (1, 2, 3, 4)])
    axes = np.array([row["shapex"], row["shapey"], row["shapez"]])
    if not row["f_subspheres"]:
        return [(centre, turn, axes)]
    return [(centre + turn @ [x, 0, 0], np.eye(3), np.full(3, r)) for x, r in spheres_of_chain]


def hit(bodies, start, ray, low=-np.inf, high=np.inf):
    """Nearest point along rays that all run along `ray`, where low < x < high: (distance, normal) of the union, inf where none."""
    best = np.full(len(start), np.inf)
    normal = np.zeros((len(start), 3))
    for centre, turn, axes in bodies:
        o, d = ((start - centre) @ turn) / axes, (turn.T @ ray) / axes
        a, b, c = d @ d, o @ d, np.einsum("ij,ij->i", o, o) - 1.0
        root = b * b - a * c
        enter = (-b - np.sqrt(np.maximum(root, 0.0))) / a
        leave = (-b + np.sqrt(np.maximum(root, 0.0))) / a
        inside = (root > 0.0) & (start[:, 0] > low) & (start[:, 0] < high) & (leave > 0)
        closer = inside & (enter < best)
        best = np.where(closer, enter, best)
        n = ((o + enter[:, None] * d) / axes) @ turn.T
        normal = np.where(closer[:, None], n / np.linalg.norm(n, axis=1)[:, None], normal)
    return best, normal


def expected(rows, chain, places, about, low=-np.inf, high=np.inf):
    """What the camera, looking down z with parallel rays, sees at places of the page: row index (-1: nothing), normal."""
    places = np.asarray(places)
    aspect = about["width"] / about["height"]
    x = (2.0 * places[:, 0] / about["width"] - 1.0) * about["half_height"] * aspect * about["radius"] + about["centre"][0]
    y = (1.0 - 2.0 * places[:, 1] / about["height"]) * about["half_height"] * about["radius"] + about["centre"][1]
    start = np.column_stack([x, y, np.full(len(x), about["centre"][2] + 1.0)])
    best, which, normals = np.full(len(x), np.inf), np.full(len(x), -1), np.zeros((len(x), 3))
    for k, row in enumerate(rows):
        far, normal = hit(bodies_of(row, chain), start, np.array([0.0, 0.0, -1.0]), low, high)
        closer = far < best
        best, which = np.where(closer, far, best), np.where(closer, k, which)
        normals = np.where(closer[:, None], normal, normals)
    return which, normals


def robust(rows, chain, places, about, **cut):
    """Places whose neighbourhood of two thirds of a pixel shows one body: (index into places, which, normals)."""
    middle, normals = expected(rows, chain, places, about, **cut)
    sure = np.ones(len(places), bool)
    for dx, dy in ((0.7, 0.0), (-0.7, 0.0), (0.0, 0.7), (0.0, -0.7)):
        sure &= expected(rows, chain, np.asarray(places) + (dx, dy), about, **cut)[0] == middle
    return np.flatnonzero(sure), middle, normals


QUESTIONS = """
const { camera, drawing, scene, shown } = page, places = %(places)s;
const number = (name) => header.columns.findIndex((column) => column.name === name);
camera.turn = [1, 0, 0, 0]; camera.height = 0.5; shown.box = false; shown.walls = false; shown.chains = false;
document.documentElement.dataset.theme = "light"; page.set_theme("light");
page.set_colour(number("type"));
page.draw_now();
answer.about = { width: drawing.canvas.clientWidth, height: drawing.canvas.clientHeight, half_height: camera.height,
                 centre: scene.centre, radius: scene.radius };
answer.columns = header.columns.map((column) => column.name);
answer.picked = places.map(([x, y]) => page.pick(x, y));
page.select(-1);
page.draw_now();
answer.pixels = places.map(([x, y]) => page.pixel(x, y));
page.cuts[0][1] = 0.5;
answer.cut = places.map(([x, y]) => page.pick(x, y));
page.cuts[0][1] = 1;
await page.set_frame(0);
answer.first_frame = places.slice(0, 40).map(([x, y]) => page.pick(x, y));
await page.set_frame(1);
const lines = {};
for (const id of %(ids)s) {
  page.select(page.frame.body.findIndex((body) => id_of(scene.bodies, body) === id));
  lines[id] = [...document.querySelectorAll("#picked tr")].map((row) => [...row.children].map((cell) => cell.textContent));
}
answer.lines = lines;
page.set_colour(number("heat"));
answer.legend = document.getElementById("legend").textContent;
answer.range = shown.colour_range;
answer.projected = page.project(%(first)s);
camera.perspective = true;
answer.projected_through_eye = page.project(%(first)s);
answer.picked_through_eye = page.pick(...answer.projected_through_eye);
camera.perspective = false;
answer.time = document.getElementById("time").textContent;
answer.message_hidden = document.getElementById("message").hidden;
"""


def check_page(folder, rng):
    rows, moved = scene(rng), scene(np.random.default_rng(SEED + 1))
    dump = folder / "made.dump"
    dump.write_text(frame_text(0, moved, COLUMNS) + frame_text(500, rows, COLUMNS))
    post("view", dump, "-o", folder / "view.html", "--no-walls")
    page = (folder / "view.html").read_text()
    assert "src=" not in page and "url(" not in page and "@import" not in page, "the page loads something from elsewhere"
    chain = chain_spheres(2.7e-3, 1.15e-3)
    places = [[float(x) + 0.5, float(y) + 0.5] for x, y in zip(rng.integers(120, 520, 200), rng.integers(5, 325, 200))]
    ids = [rows[k]["id"] for k in (0, 3, 9)]
    answer = ask(folder / "view.html", QUESTIONS % {"places": json.dumps(places), "ids": json.dumps(ids), "first": ids[0]},
                 folder, SIZE)
    assert answer["complaints"] == [], answer["complaints"]
    assert answer["message_hidden"]
    about = answer["about"]

    sure, which, normals = robust(rows, chain, places, about)
    assert len(sure) > 150 and (which[sure] >= 0).sum() > 40, (len(sure), (which[sure] >= 0).sum())
    wrong = [k for k in sure if (answer["picked"][k] or -1) != (rows[which[k]]["id"] if which[k] >= 0 else -1)]
    assert not wrong, [(places[k], answer["picked"][k], which[k]) for k in wrong[:5]]

    light = np.array([-0.35, 0.55, 0.76])
    light /= np.linalg.norm(light)
    for k in sure:
        paint = (255, 255, 255)
        if which[k] >= 0:
            brightness = 0.42 + 0.58 * max(0.0, normals[k] @ light)
            paint = np.array(PALETTE[(rows[which[k]]["type"] - 1) % 3]) * brightness
        assert np.abs(np.array(answer["pixels"][k]) - paint).max() <= 12, (places[k], answer["pixels"][k], paint)

    half = about["centre"][0]
    sure, which, _ = robust(rows, chain, places, about, high=half)
    wrong = [k for k in sure if (answer["cut"][k] or -1) != (rows[which[k]]["id"] if which[k] >= 0 else -1)]
    assert not wrong, ("cut", [(places[k], answer["cut"][k], which[k]) for k in wrong[:5]])

    sure, which, _ = robust(moved, chain, places[:40], about)
    wrong = [k for k in sure if (answer["first_frame"][k] or -1) != (moved[which[k]]["id"] if which[k] >= 0 else -1)]
    assert not wrong, ("first frame", wrong)

    check_words(answer, rows, about)
    return len(sure)


def chain_spheres(a, b):
    """(abscissa, radius) of the N = 5 chain as `template` lists it; its geometry is tested in unit.multisphere_template."""
    out = post("template", "--b", b, "--aspect", a / b, "--subspheres", 5, "--spheres", "-")[0]
    return [(float(s["x_m"]), float(s["radius_m"])) for s in csv.DictReader(io.StringIO(out))]


def check_words(answer, rows, about):
    by_id = {row["id"]: row for row in rows}
    bounds = 2.0 * about["radius"]
    for number, lines in answer["lines"].items():
        row, told = by_id[int(number)], {line[0]: line[1:] for line in lines}
        for axis, text in zip("xyz", told["centre"]):
            assert abs(float(text) - row[axis]) < 1e-4 * bounds + 1e-5 * abs(row[axis]), (axis, text, row[axis])
        assert [float(t) for t in told["semi-axes"][:3]] == [row["shapex"], row["shapey"], row["shapez"]], told["semi-axes"]
        assert abs(float(told["speed"][0].split()[0]) - row["vx"]) < 1e-4, told["speed"]
        assert abs(float(told["heat"][0]) - row["heat"]) < 2e-5, told["heat"]
        assert float(told["type"][0]) == row["type"], told["type"]
    assert answer["legend"].startswith("heat"), answer["legend"]
    assert abs(answer["range"][1] - max(row["heat"] for row in rows)) < 1e-9, answer["range"]
    assert answer["picked_through_eye"] == rows[0]["id"] or answer["picked_through_eye"] in by_id, answer["picked_through_eye"]
    assert "24 particles" in answer["time"], answer["time"]


def seen_through_eye(rows, chain, places, about, turn):
    """Row at each place of the page (-1: nothing), by rays from the eye of a camera that is turned; None where two are near."""
    eye = about["target"] + turn.T @ [0, 0, about["distance"]]  # turn: from the scene to the camera
    best, which = np.full((5, len(places)), np.inf), np.full((5, len(places)), -1)
    for n, (dx, dy) in enumerate(((0, 0), (0.7, 0), (-0.7, 0), (0, 0.7), (0, -0.7))):
        x = (2.0 * (places[:, 0] + dx) / about["width"] - 1.0) * about["width"] / about["height"]
        y = 1.0 - 2.0 * (places[:, 1] + dy) / about["height"]
        rays = np.column_stack([x, y, np.full(len(x), -1.0 / np.tan(np.pi / 12))]) @ turn
        for k, row in enumerate(rows):
            for centre, body, axes in bodies_of(row, chain):
                o, d = ((eye - centre) @ body) / axes, (rays @ body) / axes
                a, b, c = (d * d).sum(axis=1), d @ o, o @ o - 1.0
                root = b * b - a * c
                enter = (-b - np.sqrt(np.maximum(root, 0.0))) / a
                closer = (root > 0.0) & (enter > 0.0) & (enter < best[n])
                best[n], which[n] = np.where(closer, enter, best[n]), np.where(closer, k, which[n])
    return [int(w[0]) if (w == w[0]).all() else None for w in which.T]


FROM_INSIDE = """
const { camera, drawing, scene } = page, places = %(places)s;
page.set_theme("light");
page.shown.box = false;
camera.perspective = true;
camera.turn = %(turn)s;
answer.views = %(views)s.map(([height, target]) => {
  camera.height = height;
  camera.target = scene.scaled(target);
  return { width: drawing.canvas.clientWidth, height: drawing.canvas.clientHeight, target, distance: camera.distance * scene.radius,
           picked: places.map(([x, y]) => page.pick(x, y)) };
});
// without the extension that leaves pixels out early the picture is the same
const whole = () => { page.draw_now(); const { gl, canvas } = page.drawing, bytes = new Uint8Array(4 * canvas.width * canvas.height);
  gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, bytes); return bytes; };
page.select(-1);
const first = whole(), canvas = document.body.appendChild(document.createElement("canvas"));
canvas.style = "position: fixed; inset: 0; width: 100%%; height: 100%%; z-index: -1";
const prototype = WebGL2RenderingContext.prototype, extension = prototype.getExtension;
answer.has_extension = drawing.leaves_out_early;
prototype.getExtension = () => null;
page.drawing = new Drawing(canvas);
answer.has_none = !page.drawing.leaves_out_early;
page.drawing.set_spheres(scene.sphere_texels());
page.set_colour(page.column);
const second = whole();
answer.different = first.length === second.length ? first.reduce((sum, byte, k) => sum + (byte !== second[k]), 0) : -1;
answer.drawn = first.reduce((sum, byte) => sum + (byte !== 255), 0);
prototype.getExtension = extension;
page.drawing = drawing;
// what a picture costs
const { gl } = drawing, cost = {}, clear = () => Object.assign(cost, { draws: 0, instances: 0, bytes: 0 });
for (const name of ["drawArrays", "drawArraysInstanced"]) {
  const call = gl[name].bind(gl);
  gl[name] = (...all) => { ++cost.draws; cost.instances += all[3] || 0; return call(...all); };
}
for (const name of ["bufferData", "bufferSubData", "texImage2D", "texSubImage2D"]) {
  const call = gl[name].bind(gl);
  gl[name] = (...all) => { for (const part of all) if (ArrayBuffer.isView(part)) cost.bytes += part.byteLength; return call(...all); };
}
const costs_of = (change) => { clear(); change(); page.draw_now(); return { ...cost }; };
answer.costs = { turned: costs_of(() => camera.rotate(0.05, 0)), again: costs_of(() => camera.zoom(1.1)),
                 around: costs_of(() => camera.rotate(3.0, 0)) };
clear();
await page.set_frame(0);
page.draw_now();
answer.new_frame = cost.bytes / page.frame.count;
answer.order = drawing.groups.map((group) => {
  const m = matrix_of(camera.turn);
  return Array.from(group.sorted.subarray(0, group.members.length), (p) => [0, 1, 2].reduce((sum, k) => sum + m[3 * k + 2] * drawing.texels[12 * p + k], 0));
});
camera.height = 20;
answer.corners = [drawing.corners(camera)];
camera.height = 0.2;
answer.corners.push(drawing.corners(camera));
"""


def check_eye_and_costs(folder):
    """Through the eye of a turned camera, from outside and among the bodies; what a picture costs."""
    rng = np.random.default_rng(SEED + 2)
    rows = scene(rng, 60)
    (folder / "eye.dump").write_text(frame_text(0, rows, COLUMNS))
    post("view", folder / "eye.dump", "-o", folder / "eye.html", "--no-walls")
    q = np.array([0.6, 0.3, -0.64, 0.2])
    q /= np.linalg.norm(q)
    places = np.column_stack([rng.integers(5, SIZE[0] - 5, 150), rng.integers(5, 330, 150)]) + 0.5
    middle = np.mean([[row[c] for c in "xyz"] for row in rows], axis=0)
    views = [[0.6, list(middle)], [0.05, list(middle)], [0.004, [rows[5][c] for c in "xyz"]]]
    answer = ask(folder / "eye.html", FROM_INSIDE % {"places": json.dumps(places.tolist()), "turn": json.dumps(q.tolist()),
                                                     "views": json.dumps(views)}, folder, SIZE)
    assert answer["complaints"] == [], answer["complaints"]
    chain = chain_spheres(2.7e-3, 1.15e-3)
    for view in answer["views"]:
        expected_rows = seen_through_eye(rows, chain, places, view, rotation(q))
        sure = [k for k, row in enumerate(expected_rows) if row is not None]
        wrong = [(places[k].tolist(), view["picked"][k], expected_rows[k]) for k in sure
                 if (view["picked"][k] or -1) != (rows[expected_rows[k]]["id"] if expected_rows[k] >= 0 else -1)]
        assert len(sure) > 75 and not wrong, (view["distance"], len(sure), wrong[:5])
    assert answer["has_none"] and answer["different"] == 0 and answer["drawn"] > 1000, {k: answer[k] for k in ("has_none", "different", "drawn")}
    spheres = sum(5 if row["f_subspheres"] else 1 for row in rows)
    for kind, costs in answer["costs"].items():
        assert costs["draws"] == 2 and costs["instances"] == spheres, (kind, costs)  # smooth bodies, chains
        assert costs["bytes"] == (4 * len(rows) if kind == "around" else 0), (kind, costs)  # a new order, from front to back
    assert answer["new_frame"] == 52 + 288 / len(rows), answer["new_frame"]  # twelve numbers and a place in the order; the box
    for depths in answer["order"]:
        assert all(d >= e - 2 / 2048 - 1e-6 for d, e in zip(depths, depths[1:])), depths
    assert answer["corners"] == [4, 8], answer["corners"]
    print(f"early depth: {answer['has_extension']}")


CONTROLS = """
const { camera, drawing, shown } = page, canvas = drawing.canvas;
canvas.setPointerCapture = () => {}; // the events are made, no finger is there
const key = (name, target) => (target || document.body).dispatchEvent(new KeyboardEvent("keydown", { key: name, bubbles: true, cancelable: true }));
const pointer = (kind, id, x, y, more) => canvas.dispatchEvent(new PointerEvent(kind, { pointerId: id, clientX: x, clientY: y, button: 0, buttons: 1, bubbles: true, ...more }));
const state = () => ({ turn: [...camera.turn], target: [...camera.target], height: camera.height });
const after = (change) => { camera.reset(); change(); return state(); };
answer.first = after(() => {});
answer.arrow = after(() => key("ArrowLeft"));
answer.plus = after(() => key("+"));
answer.in_field = after(() => { key("+", document.getElementById("low")); });
answer.axes = ["x", "y", "z"].map((name) => after(() => key(name)).turn);
answer.dragged = after(() => { pointer("pointerdown", 1, 100, 100); pointer("pointermove", 1, 160, 100); pointer("pointerup", 1, 160, 100); });
answer.moved = after(() => { pointer("pointerdown", 1, 100, 100); pointer("pointermove", 1, 160, 130, { shiftKey: true }); pointer("pointerup", 1, 160, 130); });
answer.pinched = after(() => { for (const [id, x] of [[1, 200], [2, 300]]) pointer("pointerdown", id, x, 100);
                               pointer("pointermove", 2, 400, 100); for (const id of [1, 2]) pointer("pointerup", id, 0, 0); });
answer.wheel = after(() => canvas.dispatchEvent(new WheelEvent("wheel", { deltaY: -100, cancelable: true })));
answer.canvas_height = canvas.clientHeight;
key("p"); answer.perspective = camera.perspective; key("p");
camera.reset(); page.draw_now();
const place = page.project(1000000);
answer.tapped = (pointer("pointerdown", 1, ...place), pointer("pointerup", 1, ...place), page.shown.selected >= 0 ? id_of(page.scene.bodies, page.frame.body[page.shown.selected]) : null);
key("Escape"); answer.escaped = page.shown.selected;
await page.set_frame(1); key(","); await page.reading; answer.back = page.frame.number; key("."); await page.reading; answer.forth = page.frame.number;
key(" "); answer.plays = page.playing; key(" "); answer.stopped = page.playing; await page.reading;
shown.box = shown.particles = false;
answer.corner = ["light", "dark", "light"].map((theme) => { if (document.documentElement.dataset.theme !== theme) key("d"); page.draw_now(); return page.pixel(20, 200); });
shown.box = shown.particles = true;
let saved = null;
HTMLAnchorElement.prototype.click = function() { saved = { name: this.download, url: this.href }; };
key("s");
for (let k = 0; k < 50 && !saved; ++k) await new Promise((done) => setTimeout(done, 20));
const picture = new Image();
await new Promise((done, failed) => { picture.onload = done; picture.onerror = failed; picture.src = saved.url; });
answer.saved = [saved.name, picture.width, picture.height, canvas.width, canvas.height];
"""


def check_controls(folder):
    """Keys, mouse, fingers, dark and light, the screenshot, of the page of check_page."""
    answer = ask(folder / "view.html", CONTROLS, folder, SIZE)
    assert answer["complaints"] == [], answer["complaints"]
    first, height = answer["first"], answer["canvas_height"]
    angle = lambda state: 2 * np.arccos(min(1.0, abs(np.dot(first["turn"], state["turn"]))))
    assert abs(angle(answer["arrow"]) - 0.1) < 1e-6 and abs(angle(answer["dragged"]) - 5 * 60 / height) < 1e-6, answer["arrow"]
    assert abs(answer["plus"]["height"] * 1.15 / first["height"] - 1) < 1e-9 and answer["in_field"] == first, answer["in_field"]
    assert abs(answer["pinched"]["height"] * 2 / first["height"] - 1) < 1e-9, answer["pinched"]  # from 100 to 200 pixels apart
    assert abs(answer["wheel"]["height"] * np.exp(0.15) / first["height"] - 1) < 1e-9, answer["wheel"]
    turn = rotation(first["turn"])  # from the scene to the camera
    moved = turn @ (np.array(answer["moved"]["target"]) - first["target"])
    assert np.abs(moved - np.array([-60, 30, 0]) * 2 / height * first["height"]).max() < 1e-9, moved
    up = {"x": [1, 0, 0], "y": [0, 1, 0], "z": [0, 0, 1]}
    for name, q in zip("xyz", answer["axes"]):
        seen = rotation(q) @ up[name]
        assert np.abs(np.abs(seen) - [0, 0, 1]).max() < 1e-9, (name, seen)  # that axis runs to or from the eye
    assert answer["perspective"] and answer["tapped"] is not None and answer["escaped"] == -1, answer["tapped"]
    assert (answer["back"], answer["forth"], answer["plays"], answer["stopped"]) == (0, 1, True, False), answer
    assert answer["corner"] == [[255, 255, 255], [20, 23, 27], [255, 255, 255]], answer["corner"]
    name, *sizes = answer["saved"]
    assert name.endswith(".png") and sizes[:2] == sizes[2:], answer["saved"]


def check_chains_and_walls(folder):
    """Two spheres that press each other before a wall: the chain between their centres is seen, and as wide as it should be."""
    rows = [dict(zip(COLUMNS, (k, 1, 1e-5, x, 0.0, 0.0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1e-3, 1e-3, 1e-3, 0, 0.0)))
            for k, x in ((1, -0.99e-3), (2, 0.99e-3), (3, 5e-3))]
    (folder / "three.dump").write_text(frame_text(7, rows, COLUMNS))
    (folder / "three.contacts").write_text(
        "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ENTRIES\n1\nITEM: BOX BOUNDS mm mm ff\n0 0.5\n-0.005 0.2\n-0.01 0.01\n"
        "ITEM: ENTRIES c_p[1] c_p[2] c_p[3] c_p[4] c_p[5]\n1 2 3.0 4.0 0.0\n")
    mesh = folder / "one.stl"
    corners = [(-6e-3, -1e-3, -2e-3), (6e-3, -1e-3, -2e-3), (0.0, 6e-3, -2e-3)]
    mesh.write_bytes(b"\0" * 80 + struct.pack("<I", 1) + struct.pack("<12f", 0, 0, 1, *sum(corners, ())) + b"\0\0")
    post("view", folder / "three.dump", "-o", folder / "three.html", "--contacts", folder / "three.contacts",
         "--id-columns", "c_p[1]", "c_p[2]", "--force-columns", "c_p[3]", "c_p[4]", "c_p[5]", "--mesh", mesh)
    answer = ask(folder / "three.html", """
        const { camera, shown } = page;
        camera.turn = [1, 0, 0, 0]; shown.particles = false; shown.box = false; shown.walls = false; page.set_theme("light");
        page.draw_now();
        const [a, b, c] = [1, 2, 3].map((id) => page.project(id)), middle = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
        answer.chain = page.pixel(...middle);
        answer.beside = page.pixel((b[0] + c[0]) / 2, c[1]);
        let width = 0;
        while (page.pixel(middle[0], middle[1] + width)[1] < 200) ++width;
        answer.width = 2 * width / (b[0] - a[0]);
        shown.chains = false; shown.walls = true;
        page.draw_now();
        answer.mesh = page.pixel(...middle);
        answer.place = middle;
        page.select(page.frame.body.findIndex((body) => id_of(page.scene.bodies, body) === 2));
        answer.lines = [...document.querySelectorAll("#picked tr")].map((row) => row.textContent);
        """, folder, SIZE, shot=folder / "shot.png")
    assert answer["complaints"] == [], answer["complaints"]
    assert answer["chain"][0] > 150 and answer["chain"][2] < 60, answer["chain"]
    assert answer["beside"] == [255, 255, 255], answer["beside"]
    assert abs(answer["width"] - 1e-3 / 1.98e-3) < 0.06, answer["width"]  # the largest force: half the radius to each side
    assert 150 < answer["mesh"][0] < 250, answer["mesh"]
    shown = pixels_of(folder / "shot.png")[round(answer["place"][1]), round(answer["place"][0])]  # what people see
    assert np.abs(shown.astype(int) - answer["mesh"]).max() <= 3, (shown, answer["mesh"])
    assert "with 15" in answer["lines"], answer["lines"]  # with particle 1: a force of 5


def periodic_scene(folder):
    """A bulk of balls that repeats along a tilted edge, two of them touching through the face, two strays far away, and a
    cylinder wall in the log."""
    rows, edge, tilt = [], 1e-2, 3e-3  # edges (edge, 0, 0) and (tilt, edge, 0), which does not repeat
    places = [(0.4e-3, 5e-3), (9.6e-3, 5e-3)] + [(1.5e-3 + 1e-3 * (k % 7), 1e-3 + 4e-5 * k) for k in range(200)]
    for k, (x, y) in enumerate(places + [(0.0, 3.0), (0.0, -3.0)]):
        z = 0.0 if k < 2 else 5e-3
        rows.append(dict(zip(COLUMNS, (k + 1, 1, 1e-5, x, y, z, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, *(0.5e-3,) * 3, 0, 0.0))))
    text = frame_text(7, rows, COLUMNS)
    head, rest = text.split("ITEM: BOX BOUNDS", 1)
    rest = rest[rest.index("ITEM: ATOMS"):]
    box = f"ITEM: BOX BOUNDS xy xz yz pp ff ff\n0 {edge + tilt} {tilt}\n0 {edge} 0\n-0.001 0.006 0\n"
    (folder / "wrapped").mkdir()
    (folder / "wrapped" / "bed.dump").write_text(head + box + rest)
    (folder / "wrapped" / "log.run").write_text("timestep 2e-3\nfix c all wall/gran/ellipsoid model hertz primitive type 1 ycylinder 0.002 0.0 0.005\n")
    (folder / "wrapped" / "bed.local").write_text(
        "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ENTRIES\n1\nITEM: BOX BOUNDS pp ff ff\n0 1\n0 1\n0 1\nITEM: ENTRIES i j fx fy fz\n1 2 1.0 0 0\n")
    return folder / "wrapped" / "bed.dump", edge, tilt


def check_images_and_first_view(folder):
    dump, edge, tilt = periodic_scene(folder)
    page = folder / "periodic.html"
    post("view", dump, "-o", page, "--contacts", dump.with_suffix(".local"), "--id-columns", "i", "j", "--force-columns", "fx", "fy", "fz")
    answer = ask(page, """
        const { camera, shown, drawing } = page, places = (points) => points.map((point) => page.page_place(point));
        answer.size = [drawing.canvas.clientWidth, drawing.canvas.clientHeight];
        answer.first = [...Array(204).keys()].map((k) => page.project(k + 1));
        answer.box = header.frames[0].box;
        camera.turn = [1, 0, 0, 0]; shown.box = false; shown.walls = false; shown.chains = false; page.set_theme("light");
        const [image, beyond] = places([[%(edge)s + 0.4e-3, 5e-3, 0], [9.4e-3 - %(edge)s, 5e-3, 0]]);
        page.draw_now();
        answer.without = [page.pixel(...image), page.pick(...image)];
        shown.images = true;
        page.draw_now();
        answer.with_images = [page.pick(...image), page.pick(...beyond)];
        shown.images = false; shown.particles = false; shown.chains = true;
        page.select(-1);
        page.draw_now();
        answer.chain = places([[%(edge)s, 5e-3, 0], [0, 5e-3, 0], [5e-3, 5e-3, 0]]).map((place) => page.pixel(...place));
        shown.chains = false; shown.walls = true;
        page.draw_now(); // the cylinder along y, about x = 0.005, z = 0: from x = 0.003 to 0.007
        answer.tube = places([[3.2e-3, 5e-3, 0], [6.8e-3, 5e-3, 0], [2.8e-3, 5e-3, 0], [7.2e-3, 5e-3, 0]]).map((place) => page.pixel(...place));
        answer.shown = !document.getElementById("images-label").hidden;
        answer.time = document.getElementById("time").textContent;
        """ % {"edge": edge}, folder, SIZE)
    assert answer["complaints"] == [], answer["complaints"]
    width, height = answer["size"]
    bulk = np.array(answer["first"][:202])
    assert (bulk > 0).all() and (bulk < (width, height)).all(), bulk
    assert np.ptp(bulk, axis=0).max() > 0.3 * height, np.ptp(bulk, axis=0)  # strays do not make it small
    assert all(not 0 < y < height for _, y in answer["first"][202:]), answer["first"][202:]
    assert answer["box"]["repeats"] == [True, False, False]
    assert np.allclose(answer["box"]["edges"], [[edge, 0, 0], [tilt, edge, 0], [0, 0, 7e-3]], atol=1e-12), answer["box"]
    assert answer["without"] == [[255, 255, 255], None], answer["without"]
    assert answer["with_images"] == [1, 2], answer["with_images"]
    for place in answer["chain"][:2]:
        assert place[0] > 150 and place[2] < 60, answer["chain"]
    assert answer["chain"][2] == [255, 255, 255], answer["chain"]
    for place in answer["tube"][:2]:
        assert max(place) < 250, answer["tube"]
    assert answer["tube"][2:] == [[255, 255, 255]] * 2, answer["tube"]
    assert answer["shown"] and answer["time"] == "t = 0.014 s, 204 particles", answer["time"]  # step 7 of 2 ms


def check_refusals(folder):
    made = folder / "made.dump"
    for arguments, words in (((made, "-o", folder / "x.txt"), ".html"),
                             ((made, "-o", folder / "x.html", "--mesh", made), "STL"),
                             ((made, "-o", folder / "x.html", "--colour", "warmth"), "warmth"),
                             ((folder / "absent.dump", "-o", folder / "x.html"), "absent.dump")):
        _, error = post("view", *arguments, expect=None)
        assert words in error and error.count("\n") <= 3, (arguments, error)
        assert not (folder / "x.html").exists()


def main():
    folder = pathlib.Path.cwd()
    print(f"seed {SEED}")
    check_page(folder, np.random.default_rng(SEED))
    check_controls(folder)
    check_eye_and_costs(folder)
    check_chains_and_walls(folder)
    check_images_and_first_view(folder)
    check_refusals(folder)


if __name__ == "__main__":
    sys.exit(main())
