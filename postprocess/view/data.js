// The data of the page: what the header says, and the frames, unpacked when they are asked for.

const header = JSON.parse(document.getElementById("header").textContent);

async function unpacked(element_id) {
  const text = atob(document.getElementById(element_id).textContent.trim());
  const packed = Uint8Array.from(text, (sign) => sign.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).arrayBuffer();
}

/// Reads numbers one after the other; every column begins at a multiple of four bytes.
class ColumnReader {
  constructor(buffer) { this.buffer = buffer; this.offset = 0; }
  read(Type, count) {
    const column = new Type(this.buffer, this.offset, count);
    this.offset += 4 * Math.ceil(count * Type.BYTES_PER_ELEMENT / 4);
    return column;
  }
}

/// What does not change in time: id, semi-axes and template of every body.
async function read_bodies() {
  const reader = new ColumnReader(await unpacked("bodies"));
  const n = header.bodies;
  return { low: reader.read(Uint32Array, n), high: reader.read(Uint32Array, n),
           a: reader.read(Float32Array, n), b: reader.read(Float32Array, n), c: reader.read(Float32Array, n),
           template: reader.read(Uint32Array, n) };
}

const quaternion_steps = 32767; // of each of the three smaller parts, and 2 bits that name the largest

/// Unit quaternion (w, x, y, z) from its three smaller parts; see view_data.h.
function unpack_quaternion(p, q, r, out, at) {
  const largest = (p >> 15) | ((q >> 15) << 1);
  const parts = [p & 32767, q & 32767, r & 32767];
  let squares = 0, next = 0;
  for (let k = 0; k < 4; ++k) {
    if (k === largest) continue;
    const value = (2 * parts[next++] / quaternion_steps - 1) * Math.SQRT1_2;
    out[at + k] = value;
    squares += value * value;
  }
  out[at + largest] = Math.sqrt(Math.max(0, 1 - squares));
}

/// One frame: columns of numbers, `count` each.
async function read_frame(number) {
  const about = header.frames[number], n = about.count;
  const reader = new ColumnReader(await unpacked("frame-" + number));
  const frame = { number, count: n, body: reader.read(Uint32Array, n), position: [], columns: [] };
  const Whole = header.position.bytes === 2 ? Uint16Array : Uint32Array;
  for (let k = 0; k < 3; ++k) frame.position.push(reader.read(Whole, n));
  frame.turn = [0, 1, 2].map(() => reader.read(Uint16Array, n));
  for (let k = 0; k < header.columns.length; ++k) frame.columns.push(reader.read(Uint16Array, n));
  const m = about.contacts;
  frame.contacts = { count: m, i: reader.read(Uint32Array, m), j: reader.read(Uint32Array, m),
                     force: reader.read(Float32Array, m), overlap: reader.read(Float32Array, m) };
  return frame;
}

/// A coordinate of a particle in the file's unit.
function coordinate(frame, axis, particle) {
  return header.position.origin[axis] + header.position.step[axis] * frame.position[axis][particle];
}

const missing_code = 65535, largest_code = 65534; // see view_columns.h

/// A value of a column in its unit; NaN where the particle has none.
function value_of(frame, column, particle) {
  const about = header.columns[column], code = frame.columns[column][particle];
  if (code === missing_code) return NaN;
  if (about.kinds) return about.kinds[code];
  return about.low + (about.high - about.low) * code / largest_code;
}

function id_of(bodies, body) { return bodies.high[body] * 4294967296 + bodies.low[body]; }
