// The picture: one canvas of WebGL2.

class Drawing {
  constructor(canvas) {
    this.canvas = canvas;
    // no alpha: what is seen through walls must not be mixed with the page behind the canvas
    const gl = canvas.getContext("webgl2", { alpha: false, antialias: true, preserveDrawingBuffer: true });
    if (!gl) throw new Error("This browser offers no WebGL2: open the page in a browser of 2022 or later.");
    this.gl = gl;
    this.leaves_out_early = Boolean(gl.getExtension("EXT_conservative_depth"));
    this.bodies_program = this.program(body_vertex_shader, this.with_depths(body_fragment_shader));
    this.plain_program = this.program(plain_vertex_shader, plain_fragment_shader);
    this.chain_program = this.program(chain_vertex_shader, plain_fragment_shader.replace("in vec3 seen_at;", "const vec3 seen_at = vec3(0.0);"));
    this.bodies = this.data_texture();
    this.spheres = this.data_texture();
    this.colours = this.data_texture();
    this.groups = [];   // bodies of one template: {first sphere, spheres, members, their order from front to back, its buffer}
    this.rooms = new Map(); // what groups of a template take of the graphics processor's memory
    this.surfaces = []; // triangles of walls and meshes
    this.lines = null;
    this.chains = null;
    gl.enable(gl.DEPTH_TEST);
  }

  /// Where the browser can be told that depths are greater than those of the polygon, pixels behind
  /// others cost next to nothing.
  with_depths(fragment) {
    if (!this.leaves_out_early) return fragment.replace("DEPTH_GREATER", "");
    return fragment.replace("#version 300 es\n", "#version 300 es\n#extension GL_EXT_conservative_depth : require\n")
        .replace("DEPTH_GREATER", "layout(depth_greater) out highp float gl_FragDepth;");
  }

  program(vertex, fragment) {
    const gl = this.gl, program = gl.createProgram();
    for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    const uniforms = {};
    for (let k = 0; k < gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS); ++k) {
      const name = gl.getActiveUniform(program, k).name;
      uniforms[name] = gl.getUniformLocation(program, name);
    }
    return { program, uniforms };
  }

  data_texture() {
    const gl = this.gl, texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    for (const side of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, side, gl.NEAREST);
    for (const side of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, side, gl.CLAMP_TO_EDGE);
    return texture;
  }

  /// Four numbers a texel, row by row.
  fill_texture(texture, texels) {
    const gl = this.gl, width = 2048, height = Math.max(1, Math.ceil(texels.length / 4 / width));
    const whole = Math.floor(texels.length / 4 / width), rest = texels.length / 4 - whole * width;
    gl.bindTexture(gl.TEXTURE_2D, texture);
    if (texture.height !== height) // else the memory of the frame before is taken
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, width, height, 0, gl.RGBA, gl.FLOAT, null);
    texture.height = height;
    if (whole > 0) gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, whole, gl.RGBA, gl.FLOAT, texels);
    if (rest > 0) gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, whole, rest, 1, gl.RGBA, gl.FLOAT, texels, 4 * whole * width);
  }

  set_colours(colours) { // [[r, g, b], ...] from 0 to 255
    const gl = this.gl, bytes = new Uint8Array(4 * colours.length);
    colours.forEach((colour, k) => bytes.set([...colour, 255], 4 * k));
    gl.bindTexture(gl.TEXTURE_2D, this.colours);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, colours.length, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
  }

  buffer(values) {
    const gl = this.gl, buffer = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, values, gl.STATIC_DRAW);
    return buffer;
  }

  set_spheres(texels) { this.fill_texture(this.spheres, texels); }

  /// @param texels 12 numbers a body; @param groups [{sphere_first, sphere_count, members: Uint32Array}]
  set_bodies(texels, groups) {
    const gl = this.gl;
    this.fill_texture(this.bodies, texels);
    this.texels = texels;
    this.sorted_along = null;
    this.mean_size = 0; // largest semi-axis
    for (let at = 11; at < texels.length; at += 12) this.mean_size += 12 * texels[at] / texels.length;
    this.groups = groups.filter((group) => group.members.length).map((group) => ({ ...group, ...this.room(group) }));
  }

  /// Memory for the order of a group's bodies: that of the frame before where it is large enough.
  room({ sphere_first, sphere_count, members }) {
    const gl = this.gl, key = sphere_count ? sphere_first : -1, known = this.rooms.get(key), size = members.length;
    if (known && known.steps.length >= size) return known;
    if (known) { gl.deleteBuffer(known.buffer); gl.deleteVertexArray(known.array); }
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    const sorted = new Uint32Array(size), buffer = this.buffer(sorted);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribIPointer(0, 1, gl.UNSIGNED_INT, 0, 0);
    gl.vertexAttribDivisor(0, Math.max(1, sphere_count));
    gl.bindVertexArray(null);
    this.rooms.set(key, { array, buffer, sorted, steps: new Uint16Array(size) });
    return this.rooms.get(key);
  }

  /// Orders the bodies from front to back, so that those behind are left out early. Small turns keep an order.
  sort(camera) {
    const m = matrix_of(camera.turn), along = [m[2], m[5], m[8]]; // towards the camera
    const before = this.sorted_along, little = 0.99; // cosine
    if (before && along[0] * before[0] + along[1] * before[1] + along[2] * before[2] > little) return;
    this.sorted_along = along;
    const gl = this.gl;
    for (const group of this.groups) {
      gl.bindBuffer(gl.ARRAY_BUFFER, group.buffer);
      gl.bufferSubData(gl.ARRAY_BUFFER, 0, this.front_to_back(group, along));
    }
  }

  /// Members by their distance along a direction, in steps of a thousandth of the scene.
  front_to_back(group, along) {
    const members = group.members, n = members.length, texels = this.texels, steps = 2048;
    const begins = new Uint32Array(steps + 1);
    for (let k = 0; k < n; ++k) {
      const at = 12 * members[k];
      const near = texels[at] * along[0] + texels[at + 1] * along[1] + texels[at + 2] * along[2]; // -1 to 1
      const step = Math.max(0, Math.min(steps - 1, Math.floor((1 - near) * 0.5 * steps)));
      group.steps[k] = step;
      ++begins[step + 1];
    }
    for (let k = 0; k < steps; ++k) begins[k + 1] += begins[k];
    for (let k = 0; k < n; ++k) group.sorted[begins[group.steps[k]]++] = members[k];
    return group.sorted.subarray(0, n);
  }

  /// Corners of the polygons about bodies: eight leave a twentieth of the pixels empty, four a quarter; few
  /// do for bodies of a few pixels, whose corners cost more than their pixels.
  corners(camera) {
    const pixels = this.mean_size / camera.height * this.canvas.height / 2, few = 4;
    return pixels < few ? 4 : 8;
  }

  vertices(values, attributes, divisor) {
    const gl = this.gl, array = gl.createVertexArray();
    gl.bindVertexArray(array);
    const buffer = this.buffer(values), stride = 4 * attributes.reduce((sum, size) => sum + size, 0);
    let offset = 0;
    attributes.forEach((size, k) => {
      gl.enableVertexAttribArray(k);
      gl.vertexAttribPointer(k, size, gl.FLOAT, false, stride, offset);
      gl.vertexAttribDivisor(k, divisor);
      offset += 4 * size;
    });
    gl.bindVertexArray(null);
    return { array, buffer, count: 4 * values.length / stride };
  }

  release(vertices) {
    if (!vertices) return;
    this.gl.deleteBuffer(vertices.buffer);
    this.gl.deleteVertexArray(vertices.array);
  }

  set_lines(points) { this.release(this.lines); this.lines = this.vertices(points, [3], 0); }
  add_surface(points, paint) { this.surfaces.push({ ...this.vertices(points, [3], 0), paint }); }
  set_chains(values) { this.release(this.chains); this.chains = values.length ? this.vertices(values, [3, 3, 1], 1) : null; }

  resize() {
    const ratio = window.devicePixelRatio || 1;
    const width = Math.max(1, Math.round(this.canvas.clientWidth * ratio));
    const height = Math.max(1, Math.round(this.canvas.clientHeight * ratio));
    if (this.canvas.width !== width || this.canvas.height !== height) {
      this.canvas.width = width;
      this.canvas.height = height;
    }
  }

  use({ program, uniforms }, camera) {
    const gl = this.gl;
    gl.useProgram(program);
    gl.uniformMatrix4fv(uniforms.projection, false, camera.projection(this.canvas.width / this.canvas.height));
    gl.uniformMatrix3fv(uniforms.turn, false, matrix_of(camera.turn));
    gl.uniform3fv(uniforms.target, camera.target);
    gl.uniform1f(uniforms.distance_, camera.distance);
    return uniforms;
  }

  draw_bodies(camera, shown, picking) {
    const gl = this.gl, uniforms = this.use(this.bodies_program, camera);
    [[this.bodies, uniforms.bodies], [this.spheres, uniforms.spheres], [this.colours, uniforms.colours]].forEach(
        ([texture, uniform], unit) => {
          gl.activeTexture(gl.TEXTURE0 + unit);
          gl.bindTexture(gl.TEXTURE_2D, texture);
          gl.uniform1i(uniform, unit);
        });
    const corners = this.corners(camera);
    this.sort(camera);
    gl.uniform1i(uniforms.corners, corners);
    gl.uniform2f(uniforms.pixels, this.canvas.width, this.canvas.height);
    gl.uniform1i(uniforms.cutting, Math.max(...shown.cut_low) > -1e6 || Math.min(...shown.cut_high) < 1e6 ? 1 : 0);
    gl.uniform3fv(uniforms.cut_low, shown.cut_low);
    gl.uniform3fv(uniforms.cut_high, shown.cut_high);
    gl.uniform2fv(uniforms.colour_range, shown.colour_range);
    gl.uniform1i(uniforms.by_kind, shown.by_kind ? 1 : 0);
    gl.uniform1i(uniforms.picking, picking ? 1 : 0);
    gl.uniform1ui(uniforms.selected, shown.selected + 1);
    for (const group of this.groups) {
      gl.uniform1i(uniforms.sphere_first, group.sphere_first);
      gl.uniform1i(uniforms.sphere_count, group.sphere_count);
      gl.bindVertexArray(group.array);
      for (const shift of shown.shifts) {
        gl.uniform3fv(uniforms.shift, shift);
        gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, corners, group.members.length * Math.max(1, group.sphere_count));
      }
    }
    gl.bindVertexArray(null);
  }

  draw(camera, shown) {
    const gl = this.gl;
    this.resize();
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, this.canvas.width, this.canvas.height);
    gl.clearColor(...shown.back, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    if (shown.particles) this.draw_bodies(camera, shown, false);
    if (shown.box && this.lines) {
      const uniforms = this.use(this.plain_program, camera);
      gl.uniform4fv(uniforms.paint, [...shown.ink, 1]);
      gl.uniform1i(uniforms.shaded, 0);
      gl.bindVertexArray(this.lines.array);
      gl.drawArrays(gl.LINES, 0, this.lines.count);
    }
    if (shown.chains && this.chains) {
      const uniforms = this.use(this.chain_program, camera);
      gl.uniform4fv(uniforms.paint, shown.chain_paint);
      gl.uniform1i(uniforms.shaded, 0);
      gl.bindVertexArray(this.chains.array);
      gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, this.chains.count);
    }
    if (shown.walls) this.draw_surfaces(camera);
    gl.bindVertexArray(null);
  }

  draw_surfaces(camera) {
    const gl = this.gl, uniforms = this.use(this.plain_program, camera);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    gl.depthMask(false);
    gl.uniform1i(uniforms.shaded, 1);
    for (const surface of this.surfaces) {
      gl.uniform4fv(uniforms.paint, surface.paint);
      gl.bindVertexArray(surface.array);
      gl.drawArrays(gl.TRIANGLES, 0, surface.count);
    }
    gl.depthMask(true);
    gl.disable(gl.BLEND);
  }

  /// The particle of the frame at a point of the page, or -1.
  pick(x, y, camera, shown) {
    const gl = this.gl, width = this.canvas.width, height = this.canvas.height;
    if (!this.picture || this.picture.width !== width || this.picture.height !== height) {
      const frame = gl.createFramebuffer(), colour = gl.createRenderbuffer(), depth = gl.createRenderbuffer();
      gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
      for (const [buffer, format, attachment] of [[colour, gl.RGBA8, gl.COLOR_ATTACHMENT0], [depth, gl.DEPTH_COMPONENT24, gl.DEPTH_ATTACHMENT]]) {
        gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
        gl.renderbufferStorage(gl.RENDERBUFFER, format, width, height);
        gl.framebufferRenderbuffer(gl.FRAMEBUFFER, attachment, gl.RENDERBUFFER, buffer);
      }
      if (this.picture) {
        gl.deleteFramebuffer(this.picture.frame);
        this.picture.buffers.forEach((buffer) => gl.deleteRenderbuffer(buffer));
      }
      this.picture = { width, height, frame, buffers: [colour, depth] };
    }
    const column = Math.floor(x * width / this.canvas.clientWidth), row = height - 1 - Math.floor(y * height / this.canvas.clientHeight);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.picture.frame);
    gl.viewport(0, 0, width, height);
    gl.enable(gl.SCISSOR_TEST);
    gl.scissor(column, row, 1, 1);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    this.draw_bodies(camera, shown, true);
    gl.disable(gl.SCISSOR_TEST);
    const bytes = new Uint8Array(4);
    gl.readPixels(column, row, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    return bytes[0] + 256 * bytes[1] + 65536 * bytes[2] + 16777216 * bytes[3] - 1;
  }
}
