// The controls, and the page as a whole.

const part = (id) => document.getElementById(id);

function number_text(value) {
  if (typeof value !== "number") return String(value);
  if (Number.isNaN(value)) return "none";
  if (Number.isInteger(value) && Math.abs(value) < 1e15) return String(value);
  return Number(value.toPrecision(5)).toString();
}
const with_unit = (value, unit) => number_text(value) + (unit ? " " + unit : "");

function round_ticks(low, high, wanted) {
  if (!(high > low)) return [low];
  const raw = (high - low) / wanted, power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 2.5, 5, 10].map((m) => m * power).find((s) => s >= raw * 0.999);
  const ticks = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) ticks.push(Number((k * step).toPrecision(12)));
  return ticks;
}

class Page {
  constructor(scene, drawing) {
    this.scene = scene;
    this.drawing = drawing;
    this.camera = new Camera(header.up, header.planar, scene.whole_view);
    this.column = header.columns.findIndex((column) => column.name === header.colour_by);
    this.cuts = [[0, 1], [0, 1], [0, 1]]; // shares of the bounds along x, y, z
    this.shown = { particles: true, chains: header.has_forces, images: false, walls: true, box: true, selected: -1, colour_range: [0, 1] };
    this.playing = false;
    this.waiting = null;
  }

  async start() {
    this.drawing.set_spheres(this.scene.sphere_texels());
    for (const wall of header.walls) this.drawing.add_surface(this.scene.plane_triangles(wall), [0.5, 0.56, 0.62, 0.22]);
    for (const wall of header.cylinders) this.drawing.add_surface(this.scene.cylinder_triangles(wall), [0.5, 0.56, 0.62, 0.22]);
    for (let k = 0; k < header.meshes.length; ++k)
      this.drawing.add_surface(await this.scene.mesh_triangles(k), [0.5, 0.56, 0.62, 0.3]);
    this.fill_panel();
    this.listen();
    if (innerWidth <= 640) this.toggle_panel(); // on a phone the picture comes first
    this.set_theme(matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light");
    this.set_colour(this.column);
    await this.set_frame(header.frames.length - 1);
  }

  fill_panel() {
    part("title").append(header.title, Object.assign(document.createElement("small"), { id: "subtitle" }));
    for (const name of ["x", "y", "z"]) part("axes").append(Object.assign(document.createElement("span"), { textContent: name }));
    const colours = part("colour");
    colours.append(new Option("one colour", "-1"));
    header.columns.forEach((column, k) => colours.append(new Option(column.name + (column.unit ? " (" + column.unit + ")" : ""), k)));
    part("frame").max = header.frames.length - 1;
    part("time-box").hidden = header.frames.length < 2;
    part("chains-label").hidden = !header.has_forces;
    part("show-chains").checked = header.has_forces;
    part("images-label").hidden = !header.frames.some(({ box }) => box && box.repeats.includes(true));
    part("walls-label").hidden = header.walls.length + header.cylinders.length + header.meshes.length === 0;
    for (const [axis, name] of ["x", "y", "z"].entries()) {
      const label = document.createElement("label");
      label.append(name);
      for (const [end, word] of ["from", "to"].entries()) {
        const slider = Object.assign(document.createElement("input"), { type: "range", min: 0, max: 1, step: 0.002, value: end, id: "cut-" + name + "-" + word });
        slider.setAttribute("aria-label", name + " " + word);
        slider.addEventListener("input", () => { this.cuts[axis][end] = Number(slider.value); this.redraw(); });
        label.append(slider);
      }
      part("clips").append(label);
    }
  }

  listen() {
    const on = (id, event, call) => part(id).addEventListener(event, call);
    on("colour", "change", () => this.set_colour(Number(part("colour").value)));
    on("frame", "input", () => this.set_frame(Number(part("frame").value)));
    on("play", "click", () => this.play(!this.playing));
    for (const end of ["low", "high"]) on(end, "change", () => this.read_range());
    on("range-reset", "click", () => this.set_colour(this.column));
    for (const what of ["particles", "images", "chains", "walls", "box"])
      on("show-" + what, "change", (event) => { this.shown[what] = event.target.checked; this.redraw(); });
    on("perspective", "change", (event) => { this.camera.perspective = event.target.checked; this.redraw(); });
    on("reset", "click", () => { this.camera.reset(); this.redraw(); });
    on("screenshot", "click", () => this.screenshot());
    on("theme", "click", () => this.set_theme(document.documentElement.dataset.theme === "dark" ? "light" : "dark"));
    on("panel-toggle", "click", () => this.toggle_panel());
    addEventListener("resize", () => this.redraw());
    this.listen_to_pointer();
    addEventListener("keydown", (event) => this.key(event));
  }

  listen_to_pointer() {
    const canvas = this.drawing.canvas, fingers = new Map();
    let moved = 0;
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    canvas.addEventListener("pointerdown", (event) => {
      canvas.setPointerCapture(event.pointerId);
      fingers.set(event.pointerId, [event.clientX, event.clientY]);
      if (fingers.size === 1) moved = 0;
    });
    canvas.addEventListener("pointermove", (event) => {
      const before = fingers.get(event.pointerId);
      if (!before) return;
      const now = [event.clientX, event.clientY], height = canvas.clientHeight;
      const dx = now[0] - before[0], dy = now[1] - before[1];
      moved += Math.abs(dx) + Math.abs(dy);
      const shift = event.shiftKey || event.buttons === 2 || event.buttons === 4;
      if (fingers.size === 2) this.pinch(fingers, event.pointerId, now, height);
      else if (shift) this.camera.pan(2 * dx / height, -2 * dy / height);
      else this.camera.rotate(5 * dx / height, 5 * dy / height);
      fingers.set(event.pointerId, now);
      this.redraw();
    });
    const lift = (event) => {
      const at = fingers.get(event.pointerId), last = fingers.size === 1;
      fingers.delete(event.pointerId);
      if (event.type === "pointerup" && at && last && moved < 4 && event.button === 0) this.pick(event.clientX, event.clientY);
    };
    canvas.addEventListener("pointerup", lift);
    canvas.addEventListener("pointercancel", lift);
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.camera.zoom(Math.exp(-event.deltaY * (event.deltaMode ? 0.05 : 0.0015)));
      this.redraw();
    }, { passive: false });
  }

  pinch(fingers, moving, now, height) {
    const [other] = [...fingers].filter(([id]) => id !== moving).map(([, at]) => at), before = fingers.get(moving);
    const old_gap = Math.hypot(before[0] - other[0], before[1] - other[1]);
    const gap = Math.hypot(now[0] - other[0], now[1] - other[1]);
    if (old_gap > 0 && gap > 0) this.camera.zoom(gap / old_gap);
    this.camera.pan((now[0] - before[0]) / height, -(now[1] - before[1]) / height);
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || /^(INPUT|SELECT|BUTTON)$/.test(event.target.tagName) && !["Escape"].includes(event.key)) return;
    const camera = this.camera, actions = {
      ArrowLeft: () => camera.rotate(-0.1, 0), ArrowRight: () => camera.rotate(0.1, 0),
      ArrowUp: () => camera.rotate(0, -0.1), ArrowDown: () => camera.rotate(0, 0.1),
      "+": () => camera.zoom(1.15), "=": () => camera.zoom(1.15), "-": () => camera.zoom(1 / 1.15),
      x: () => camera.look_along(0), y: () => camera.look_along(1), z: () => camera.look_along(2), r: () => camera.reset(),
      p: () => { camera.perspective = !camera.perspective; part("perspective").checked = camera.perspective; },
      " ": () => this.play(!this.playing), ",": () => this.set_frame(this.frame.number - 1), ".": () => this.set_frame(this.frame.number + 1),
      s: () => this.screenshot(), d: () => part("theme").click(), h: () => this.toggle_panel(),
      Escape: () => this.select(-1),
    };
    if (!actions[event.key]) return;
    event.preventDefault();
    actions[event.key]();
    this.redraw();
  }

  toggle_panel() {
    const body = part("panel-body");
    body.hidden = !body.hidden;
    part("panel-toggle").setAttribute("aria-expanded", String(!body.hidden));
  }

  set_theme(theme) {
    document.documentElement.dataset.theme = theme;
    const dark = theme === "dark";
    this.shown.back = dark ? [0.078, 0.09, 0.106] : [1, 1, 1];
    this.shown.ink = dark ? [0.62, 0.66, 0.7] : [0.42, 0.46, 0.5];
    this.shown.chain_paint = dark ? [1, 0.55, 0.35, 1] : [0.7, 0.1, 0.05, 1];
    this.redraw();
  }

  set_colour(column) {
    this.column = column;
    part("colour").value = column;
    const about = header.columns[column];
    this.shown.by_kind = !about || Boolean(about.kinds);
    if (!about) this.drawing.set_colours([header.maps.kinds[0]]);
    else this.drawing.set_colours(about.kinds ? header.maps.kinds : header.maps[about.map]);
    this.shown.colour_range = about && !about.kinds ? [...about.shown] : [0, 1];
    part("range").hidden = this.shown.by_kind;
    this.write_range();
    if (this.frame) this.upload();
  }

  write_range() {
    [part("low").value, part("high").value] = this.shown.colour_range.map(number_text);
    this.draw_legend();
  }

  read_range() {
    const range = [Number(part("low").value), Number(part("high").value)];
    if (range.every(Number.isFinite) && range[0] < range[1]) this.shown.colour_range = range;
    this.write_range();
    this.redraw();
  }

  draw_legend() {
    const about = header.columns[this.column], legend = part("legend");
    legend.replaceChildren();
    legend.hidden = !about;
    if (!about) return;
    const add = (parent, tag, text, name) => parent.appendChild(Object.assign(document.createElement(tag), { textContent: text, className: name || "" }));
    add(legend, "div", about.name + (about.unit ? " (" + about.unit + ")" : ""));
    if (about.kinds) {
      about.kinds.forEach((kind, k) => {
        const entry = add(legend, "span", "", "kind");
        add(entry, "i", "").style.background = "rgb(" + header.maps.kinds[k % header.maps.kinds.length].join() + ")";
        entry.append(number_text(kind));
      });
      return;
    }
    const map = header.maps[about.map], stops = map.filter((colour, k) => k % 15 === 0 || k === map.length - 1);
    add(legend, "div", "", "bar").style.background = "linear-gradient(to right," + stops.map((c) => "rgb(" + c.join() + ")").join() + ")";
    const [low, high] = this.shown.colour_range, ticks = add(legend, "div", "", "ticks");
    for (const tick of round_ticks(low, high, 4)) add(ticks, "span", number_text(tick)).style.left = 100 * (tick - low) / (high - low || 1) + "%";
  }

  async set_frame(number) {
    number = Math.min(header.frames.length - 1, Math.max(0, number));
    if (this.reading) { this.waiting = number; return this.reading; }
    this.reading = (async () => {
      this.frame = await read_frame(number);
      this.reading = null;
      const about = header.frames[number];
      part("frame").value = number;
      part("time").textContent = about.time_text + ", " + about.count + " particles";
      part("subtitle").textContent = part("time").textContent;
      this.drawing.set_lines(this.scene.box_lines(this.frame));
      if (header.has_forces) this.drawing.set_chains(this.scene.chains(this.frame));
      this.upload();
      this.select(this.picked_body === undefined ? -1 : this.frame.body.indexOf(this.picked_body));
    })();
    await this.reading;
    if (this.waiting !== null) {
      const next = this.waiting;
      this.waiting = null;
      await this.set_frame(next);
    }
  }

  upload() {
    this.drawing.set_bodies(this.scene.texels(this.frame, this.column), this.scene.groups(this.frame));
    this.redraw();
  }

  play(on) {
    this.playing = on && header.frames.length > 1;
    part("play").textContent = this.playing ? "Stop" : "Play";
    const step = async () => {
      if (!this.playing) return;
      const begun = performance.now();
      await this.set_frame((this.frame.number + 1) % header.frames.length);
      setTimeout(step, Math.max(0, 80 - (performance.now() - begun)));
    };
    if (this.playing) step();
  }

  redraw() {
    if (this.asked || !this.frame) return;
    this.asked = true;
    requestAnimationFrame(() => this.draw_now());
  }

  /// Ends of what is not cut off, in units of the scene.
  set_cuts() {
    const { lower, upper } = header.bounds;
    const at = (end) => this.scene.scaled(lower.map((low, k) => {
      const share = this.cuts[k][end];
      return share === end ? (end ? Infinity : -Infinity) : low + share * (upper[k] - low);
    })).map((x) => Math.max(-1e6, Math.min(1e6, x)));
    this.shown.cut_low = at(0);
    this.shown.cut_high = at(1);
  }

  set_images() {
    const shifts = this.scene.image_shifts(this.frame);
    this.shown.shifts = this.shown.images ? shifts : shifts.slice(0, 1);
  }

  draw_now() {
    this.asked = false;
    this.set_cuts();
    this.set_images();
    this.drawing.draw(this.camera, this.shown);
    this.name_axes();
  }

  /// The letters of the axes beside the ends of the box.
  name_axes() {
    const { lower, upper } = header.bounds, box = header.frames[this.frame.number].box;
    part("axes").hidden = !this.shown.box;
    [...part("axes").children].forEach((letter, axis) => {
      const end = lower.map((low, k) => box ? box.origin[k] + 1.03 * box.edges[axis][k] : k === axis ? upper[k] : low);
      [letter.style.left, letter.style.top] = this.page_place(end).map((x) => x + "px");
    });
  }

  pick(x, y) {
    this.set_cuts();
    this.set_images();
    this.drawing.resize();
    const particle = this.drawing.pick(x, y, this.camera, this.shown);
    this.select(particle < this.frame.count ? particle : -1);
    return this.shown.selected < 0 ? null : id_of(this.scene.bodies, this.frame.body[this.shown.selected]);
  }

  select(particle) {
    this.shown.selected = particle;
    this.picked_body = particle < 0 ? undefined : this.frame.body[particle];
    this.show_picked();
    this.redraw();
  }

  show_picked() {
    const box = part("picked"), p = this.shown.selected, bodies = this.scene.bodies;
    box.hidden = p < 0;
    box.replaceChildren();
    if (p < 0) return;
    const table = box.appendChild(document.createElement("table")), body = this.frame.body[p];
    const line = (row, ...cells) => {
      const tr = table.appendChild(document.createElement("tr"));
      tr.append(Object.assign(document.createElement("th"), { textContent: row, scope: "row" }));
      for (const text of cells) tr.append(Object.assign(document.createElement("td"), { textContent: text }));
    };
    table.append(Object.assign(document.createElement("caption"), { textContent: "Particle " + id_of(bodies, body) }));
    line("centre", ...[0, 1, 2].map((k) => number_text(coordinate(this.frame, k, p))), header.length_unit);
    line("semi-axes", ...[bodies.a[body], bodies.b[body], bodies.c[body]].map(number_text), header.length_unit);
    header.columns.forEach((column, k) => line(column.name, with_unit(value_of(this.frame, k, p), column.unit)));
    this.show_contacts(line, p);
  }

  show_contacts(line, p) {
    const { contacts } = this.frame, bodies = this.scene.bodies;
    if (!header.has_contacts) return;
    const mine = [];
    for (let c = 0; c < contacts.count; ++c)
      if (contacts.i[c] === p || contacts.j[c] === p) mine.push(c);
    line("contacts", String(mine.length));
    for (const c of mine) {
      const other = contacts.i[c] === p ? contacts.j[c] : contacts.i[c];
      line("with " + id_of(bodies, this.frame.body[other]),
           header.has_forces ? with_unit(contacts.force[c], header.force_unit) : "overlap " + with_unit(contacts.overlap[c], header.length_unit));
    }
  }

  screenshot() {
    this.draw_now();
    this.drawing.canvas.toBlob((blob) => {
      const link = document.createElement("a");
      link.href = URL.createObjectURL(blob);
      link.download = "view.png";
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 1000);
    });
  }

  /// Where the centre of a particle is on the page.
  project(id) {
    const p = this.frame.body.findIndex((body) => id_of(this.scene.bodies, body) === id);
    return this.page_place([0, 1, 2].map((k) => coordinate(this.frame, k, p)));
  }

  /// Where a point of space (in the file's unit) is on the page.
  page_place(point) {
    const camera = this.camera, at = this.scene.scaled(point).map((x, k) => x - camera.target[k]);
    const m = matrix_of(camera.turn), v = [0, 1, 2].map((k) => m[k] * at[0] + m[3 + k] * at[1] + m[6 + k] * at[2]);
    v[2] -= camera.distance;
    const canvas = this.drawing.canvas, P = camera.projection(canvas.width / canvas.height), w = camera.perspective ? -v[2] : 1;
    return [canvas.clientWidth * (0.5 + 0.5 * P[0] * v[0] / w), canvas.clientHeight * (0.5 - 0.5 * P[5] * v[1] / w)];
  }

  /// Red, green, blue of a pixel of the picture that was drawn last.
  pixel(x, y) {
    const gl = this.drawing.gl, canvas = this.drawing.canvas, bytes = new Uint8Array(4);
    gl.readPixels(Math.floor(x * canvas.width / canvas.clientWidth), canvas.height - 1 - Math.floor(y * canvas.height / canvas.clientHeight),
                  1, 1, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    return [...bytes.slice(0, 3)];
  }
}

window.view = { ready: (async () => {
  try {
    if (typeof DecompressionStream === "undefined") throw new Error("This browser cannot unpack the data: open the page in a browser of 2023 or later.");
    const scene = new Scene(await read_bodies());
    const page = new Page(scene, new Drawing(part("scene")));
    await page.start();
    window.view.page = page;
  } catch (error) {
    part("message").hidden = false;
    part("message").textContent = error.message;
    throw error;
  }
})() };
