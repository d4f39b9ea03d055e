// From the data to what is drawn: points in units of the scene, colours, force chains, walls.

const no_value = -1e30; // in place of a colour's value

class Scene {
  constructor(bodies) {
    this.bodies = bodies;
    const { lower, upper } = header.bounds;
    this.centre = lower.map((low, k) => (low + upper[k]) / 2);
    this.radius = Math.hypot(...lower.map((low, k) => upper[k] - low)) / 2 || 1;
    const bulk = header.bulk, middle = bulk.lower.map((low, k) => (low + bulk.upper[k]) / 2);
    const reach = Math.hypot(...bulk.lower.map((low, k) => bulk.upper[k] - low)) / 2 || this.radius;
    this.whole_view = { target: this.scaled(middle), height: 1.08 * reach / this.radius }; // strays left out
  }

  /// A point in the file's unit, in units of the scene.
  scaled(point) { return point.map((x, k) => (x - this.centre[k]) / this.radius); }

  sphere_texels() {
    const texels = [];
    for (const template of header.templates) texels.push(...template.spheres);
    return new Float32Array(texels.length ? texels : 4);
  }

  /// 12 numbers a body: centre and value, quaternion, semi-axes and scale.
  texels(frame, column) {
    const n = frame.count, out = new Float32Array(12 * n), bodies = this.bodies;
    const values = column < 0 ? null : frame.columns[column], about = header.columns[column];
    const factor = about && !about.kinds ? (about.high - about.low) / largest_code : 1, low = about && !about.kinds ? about.low : 0;
    for (let p = 0; p < n; ++p) {
      const at = 12 * p, body = frame.body[p];
      for (let k = 0; k < 3; ++k)
        out[at + k] = (coordinate(frame, k, p) - this.centre[k]) / this.radius;
      out[at + 3] = values ? (values[p] === missing_code ? no_value : low + factor * values[p]) : 0;
      unpack_quaternion(frame.turn[0][p], frame.turn[1][p], frame.turn[2][p], out, at + 4);
      const a = bodies.a[body] / this.radius, b = bodies.b[body] / this.radius, c = bodies.c[body] / this.radius;
      out[at + 8] = a; out[at + 9] = b; out[at + 10] = c;
      out[at + 11] = Math.max(a, b, c);
    }
    return out;
  }

  /// Particles of a frame by template; template 0 is the smooth ellipsoid.
  groups(frame) {
    const counts = new Array(header.templates.length + 1).fill(0);
    for (let p = 0; p < frame.count; ++p) ++counts[this.bodies.template[frame.body[p]]];
    const groups = counts.map((count, k) => ({ members: new Uint32Array(count), sphere_first: k ? header.templates[k - 1].first : 0,
                                               sphere_count: k ? header.templates[k - 1].spheres.length / 4 : 0 }));
    const filled = counts.map(() => 0);
    for (let p = 0; p < frame.count; ++p) {
      const template = this.bodies.template[frame.body[p]];
      groups[template].members[filled[template]++] = p;
    }
    return groups;
  }

  /// From the box to itself and its images next to it along the edges that repeat, in units of the scene.
  image_shifts(frame) {
    const box = header.frames[frame.number].box, steps = (k) => box && box.repeats[k] ? [0, -1, 1] : [0], shifts = [];
    for (const i of steps(0)) for (const j of steps(1)) for (const k of steps(2))
      shifts.push([0, 1, 2].map((axis) => box ? (i * box.edges[0][axis] + j * box.edges[1][axis] + k * box.edges[2][axis]) / this.radius : 0));
    return shifts;
  }

  /// A ribbon from centre to centre for each pair, its width by the root of the force. Across a face that repeats there
  /// are two: from each of the particles to the image of the other one.
  chains(frame) {
    const { contacts } = frame, out = [], largest = header.largest_force || 1, shifts = this.image_shifts(frame);
    const centre = (p) => this.scaled([0, 1, 2].map((k) => coordinate(frame, k, p)));
    const length = (from, to, shift) => Math.hypot(...from.map((x, k) => to[k] + shift[k] - x));
    for (let c = 0; c < contacts.count; ++c) {
      const from = centre(contacts.i[c]), to = centre(contacts.j[c]);
      const shift = shifts.reduce((best, next) => length(from, to, next) < 0.999999 * length(from, to, best) ? next : best);
      const width = 0.5 * this.bodies.c[frame.body[contacts.i[c]]] / this.radius * Math.sqrt(contacts.force[c] / largest);
      out.push(...from, ...to.map((x, k) => x + shift[k]), width);
      if (shift !== shifts[0]) out.push(...from.map((x, k) => x - shift[k]), ...to, width);
    }
    return new Float32Array(out);
  }

  /// The box of a frame as lines; with tilts a prism.
  box_lines(frame) {
    const box = header.frames[frame.number].box, out = [];
    const corner = (x, y, z) => this.scaled([0, 1, 2].map((k) =>
        box.origin[k] + x * box.edges[0][k] + y * box.edges[1][k] + z * box.edges[2][k]));
    if (box)
      for (const [u, v] of [[0, 0], [0, 1], [1, 0], [1, 1]])
        out.push(...corner(0, u, v), ...corner(1, u, v), ...corner(u, 0, v), ...corner(u, 1, v), ...corner(u, v, 0), ...corner(u, v, 1));
    return new Float32Array(out);
  }

  /// A plane as a square that covers the scene's shadow on it.
  plane_triangles(wall) {
    const n = wall.normal, other = Math.abs(n[0]) < 0.6 ? [1, 0, 0] : [0, 1, 0];
    const cross = (p, q) => [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
    let u = cross(n, other);
    const length = Math.hypot(...u);
    u = u.map((x) => x / length);
    const v = cross(n, u), point = this.scaled(wall.point), height = n.reduce((sum, x, k) => sum + x * point[k], 0);
    const at = (s, t) => n.map((x, k) => height * x + 1.05 * (s * u[k] + t * v[k]));
    return new Float32Array([...at(-1, -1), ...at(1, -1), ...at(1, 1), ...at(-1, -1), ...at(1, 1), ...at(-1, 1)]);
  }

  /// A tube as long as the scene's shadow on its axis.
  cylinder_triangles(wall) {
    const sides = 96, n = wall.axis, other = Math.abs(n[0]) < 0.6 ? [1, 0, 0] : [0, 1, 0];
    const cross = (p, q) => [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
    const u = cross(n, other).map((x, k, all) => x / Math.hypot(...all)), v = cross(n, u);
    const point = this.scaled(wall.point), height = n.reduce((sum, x, k) => sum + x * point[k], 0), radius = wall.radius / this.radius;
    const at = (side, end) => {
      const angle = 2 * Math.PI * side / sides, c = radius * Math.cos(angle), s = radius * Math.sin(angle);
      return n.map((x, k) => point[k] + (1.05 * end - height) * x + c * u[k] + s * v[k]);
    };
    const out = [];
    for (let k = 0; k < sides; ++k)
      out.push(...at(k, -1), ...at(k + 1, -1), ...at(k + 1, 1), ...at(k, -1), ...at(k + 1, 1), ...at(k, 1));
    return new Float32Array(out);
  }

  async mesh_triangles(number) {
    const values = new Float32Array(await unpacked("mesh-" + number));
    for (let k = 0; k < values.length; ++k) values[k] = (values[k] - this.centre[k % 3]) / this.radius;
    return values;
  }
}
