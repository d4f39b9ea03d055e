// The camera: what it looks at, how it is turned, how far it sees. Lengths in units of the scene, whose
// bodies fit into a ball of radius 1 about the origin.

function quaternion_product(p, q) {
  return [p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
          p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
          p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1],
          p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0]];
}

/// The rotation as a matrix, column by column.
function matrix_of([w, x, y, z]) {
  return [1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y),
          2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x),
          2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)];
}

function turn_about(axis, angle) {
  const s = Math.sin(angle / 2);
  return [Math.cos(angle / 2), axis[0] * s, axis[1] * s, axis[2] * s];
}

class Camera {
  constructor(up, flat, whole_view) {
    this.up = up;
    this.whole_view = whole_view;
    this.flat = flat; // everything moves in the plane of x and y: seen from the front
    this.perspective = false;
    this.reset();
  }

  reset() {
    this.target = [...this.whole_view.target];
    // half of what is seen at the target; on a tall screen the width counts
    this.height = this.whole_view.height * Math.max(1, innerHeight / innerWidth);
    const stand = this.up === "z" ? turn_about([1, 0, 0], -Math.PI / 2) : [1, 0, 0, 0];
    this.turn = this.flat ? [1, 0, 0, 0] : quaternion_product(
        quaternion_product(turn_about([1, 0, 0], 0.42), turn_about([0, 1, 0], -0.55)), stand);
  }

  /// Looks along an axis (0, 1, 2).
  look_along(axis) {
    const stand = this.up === "z" ? turn_about([1, 0, 0], -Math.PI / 2) : [1, 0, 0, 0];
    const along_up = (this.up === "z" ? 2 : 1) === axis;
    if (along_up) this.turn = this.up === "z" ? [1, 0, 0, 0] : turn_about([1, 0, 0], Math.PI / 2);
    else if (axis === 0) this.turn = quaternion_product(turn_about([0, 1, 0], -Math.PI / 2), stand);
    else this.turn = stand;
  }

  rotate(right, down) {
    const turned = quaternion_product(
        quaternion_product(turn_about([1, 0, 0], down), turn_about([0, 1, 0], right)), this.turn);
    const length = Math.hypot(...turned);
    this.turn = turned.map((part) => part / length);
  }

  /// Moves the scene by shares of half the picture's height.
  pan(right, up) {
    const m = matrix_of(this.turn);
    for (let k = 0; k < 3; ++k)
      this.target[k] -= this.height * (right * m[3 * k] + up * m[3 * k + 1]);
  }

  zoom(factor) { this.height = Math.min(20, Math.max(1e-5, this.height / factor)); }

  get distance() { return this.perspective ? this.height / Math.tan(Math.PI / 12) : 4 + this.height; }

  /// Projection, column by column; aspect = width / height.
  projection(aspect) {
    const far = this.distance + 3.5;
    if (!this.perspective) {
      const near = this.distance - 3.5, deep = far - near;
      return [1 / (this.height * aspect), 0, 0, 0, 0, 1 / this.height, 0, 0, 0, 0, -2 / deep, 0,
              0, 0, -(far + near) / deep, 1];
    }
    const near = Math.max(1e-3 * this.height, this.distance - 3.5), f = 1 / Math.tan(Math.PI / 12);
    return [f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, -(far + near) / (far - near), -1,
            0, 0, -2 * far * near / (far - near), 0];
  }
}
