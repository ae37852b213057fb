// SPDX-License-Identifier: LGPL-2.1-or-later
// The live view of a report: a GLB of ours, drawn by WebGL 2, turned by the pointer, opened by a slider.
// Reads what exporters/glb.py writes: a root, below it nodes that move, below each the node of its mesh.
"use strict";

const VERTEX = `#version 300 es
in vec3 position;
uniform mat4 model, view;
out vec3 place;
void main() { vec4 p = model * vec4(position, 1.0); place = p.xyz; gl_Position = view * p; }`;
const FRAGMENT = `#version 300 es
precision highp float;
in vec3 place;
uniform vec3 colour, eye;
out vec4 shown;
void main() {
  vec3 n = normalize(cross(dFdx(place), dFdy(place)));
  vec3 toEye = normalize(eye - place);
  if (dot(n, toEye) < 0.0) n = -n;
  float sky = 0.5 + 0.5 * n.y;
  float lamp = max(dot(n, normalize(toEye + vec3(0.35, 0.8, 0.15))), 0.0);
  vec3 light = colour * (0.34 + 0.22 * sky + 0.55 * lamp);
  shown = vec4(pow(light, vec3(1.0 / 2.2)), 1.0);
}`;

// 4 × 4 matrices, column by column
const times = (a, b) => {
  const c = new Float32Array(16);
  for (let i = 0; i < 4; i++) for (let j = 0; j < 4; j++) {
    let sum = 0;
    for (let k = 0; k < 4; k++) sum += a[k * 4 + j] * b[i * 4 + k];
    c[i * 4 + j] = sum;
  }
  return c;
};
const placed = (node) => {
  if (node.matrix) return Float32Array.from(node.matrix);
  const [x, y, z, w] = node.rotation || [0, 0, 0, 1], [a, b, c] = node.scale || [1, 1, 1];
  const t = node.translation || [0, 0, 0];
  return Float32Array.of(
    a * (1 - 2 * (y * y + z * z)), a * 2 * (x * y + z * w), a * 2 * (x * z - y * w), 0,
    b * 2 * (x * y - z * w), b * (1 - 2 * (x * x + z * z)), b * 2 * (y * z + x * w), 0,
    c * 2 * (x * z + y * w), c * 2 * (y * z - x * w), c * (1 - 2 * (x * x + y * y)), 0,
    t[0], t[1], t[2], 1);
};
const carried = (m, p) => [0, 1, 2].map((i) => m[i] * p[0] + m[4 + i] * p[1] + m[8 + i] * p[2] + m[12 + i]);

class Model {
  constructor(bytes) {
    const head = new DataView(bytes), length = head.getUint32(12, true);
    this.json = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 20, length)));
    this.start = 20 + length + 8;
    this.bytes = bytes;
    const { nodes, animations } = this.json;
    this.root = placed(nodes[0]);
    this.tracks = new Map();
    for (const { sampler, target } of animations[0].channels) {
      const { input, output, interpolation } = animations[0].samplers[sampler];
      const track = { times: this.array(input), values: this.array(output), step: interpolation === "STEP" };
      this.tracks.set(`${target.node} ${target.path}`, track);
    }
    this.end = Math.max(...[...this.tracks.values()].map((t) => t.times[t.times.length - 1]));
    this.bodies = (nodes[0].children || []).map((k) => {
      const holder = nodes[nodes[k].children[0]];
      return { node: k, still: nodes[k], place: placed(holder), mesh: holder.mesh };
    });
  }
  array(number) {
    const { bufferView, componentType, count, type } = this.json.accessors[number];
    const kinds = { 5126: Float32Array, 5123: Uint16Array, 5125: Uint32Array };
    const wide = { SCALAR: 1, VEC3: 3, VEC4: 4 }[type];
    return new kinds[componentType](this.bytes, this.start + this.json.bufferViews[bufferView].byteOffset, count * wide);
  }
  sampled(node, path, seconds) {
    const track = this.tracks.get(`${node} ${path}`);
    if (!track) return null;
    const { times: t, values: v, step } = track, wide = v.length / t.length;
    let k = 0;
    while (k < t.length - 1 && t[k + 1] <= seconds) k++;
    if (step || k === t.length - 1) return [...v.subarray(k * wide, (k + 1) * wide)];
    const part = Math.max((seconds - t[k]) / (t[k + 1] - t[k]), 0);
    const found = [];
    for (let i = 0; i < wide; i++) found.push(v[k * wide + i] * (1 - part) + v[(k + 1) * wide + i] * part);
    if (path !== "rotation") return found;
    const length = Math.hypot(...found);
    return found.map((x) => x / length);
  }
  matrices(opening) {
    const seconds = opening * this.end;
    return this.bodies.map(({ node, still, place }) => {
      const now = { ...still };
      for (const path of ["rotation", "translation", "scale"]) {
        const value = this.sampled(node, path, seconds);
        if (value) now[path] = value;
      }
      return times(this.root, times(placed(now), place));
    });
  }
  // corners of the boxes of all bodies, and their middle: what has to be seen
  extent(opening) {
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity], corners = [];
    this.matrices(opening).forEach((matrix, k) => {
      const primitive = this.json.meshes[this.bodies[k].mesh].primitives[0];
      const { min, max } = this.json.accessors[primitive.attributes.POSITION];
      for (let corner = 0; corner < 8; corner++) {
        const p = carried(matrix, [0, 1, 2].map((i) => (corner >> i & 1 ? max[i] : min[i])));
        p.forEach((x, i) => { low[i] = Math.min(low[i], x); high[i] = Math.max(high[i], x); });
        corners.push(p);
      }
    });
    return { corners, middle: low.map((x, i) => (x + high[i]) / 2) };
  }
}

class View {
  constructor(place) {
    this.place = place;
    this.canvas = place.querySelector("canvas");
    this.gl = this.canvas.getContext("webgl2", { antialias: true, preserveDrawingBuffer: true });
    if (!this.gl) { place.classList.add("no-webgl"); return; }
    const text = atob(place.querySelector("script").textContent.trim());
    this.model = new Model(Uint8Array.from(text, (c) => c.charCodeAt(0)).buffer);
    this.turn = Number(place.dataset.turn || 0.7);
    this.tilt = 0.65;
    this.near = 1;
    this.compile();
    this.listen();
    const wanted = /opening=([\d.]+)/.exec(location.hash);
    this.open(wanted ? Number(wanted[1]) : 1);
  }
  compile() {
    const { gl } = this;
    const program = gl.createProgram();
    for (const [kind, source] of [[gl.VERTEX_SHADER, VERTEX], [gl.FRAGMENT_SHADER, FRAGMENT]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.bindAttribLocation(program, 0, "position");
    gl.linkProgram(program);
    gl.useProgram(program);
    gl.enable(gl.DEPTH_TEST);
    this.at = {};
    for (const name of ["model", "view", "colour", "eye"]) this.at[name] = gl.getUniformLocation(program, name);
    this.meshes = this.model.json.meshes.map(({ primitives: [primitive] }) => {
      const form = gl.createVertexArray(), numbers = this.model.array(primitive.indices);
      gl.bindVertexArray(form);
      gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
      gl.bufferData(gl.ARRAY_BUFFER, this.model.array(primitive.attributes.POSITION), gl.STATIC_DRAW);
      gl.enableVertexAttribArray(0);
      gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
      gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, numbers, gl.STATIC_DRAW);
      const kind = numbers.BYTES_PER_ELEMENT === 2 ? gl.UNSIGNED_SHORT : gl.UNSIGNED_INT;
      const colour = this.model.json.materials[primitive.material].pbrMetallicRoughness.baseColorFactor;
      return { form, count: numbers.length, kind, colour: colour.slice(0, 3) };
    });
  }
  listen() {
    const slider = this.place.querySelector("input"), play = this.place.querySelector("button");
    slider.addEventListener("input", () => { this.playing = 0; this.open(Number(slider.value)); });
    play.addEventListener("click", () => this.play());
    const fingers = new Map();
    let apart = 0;
    this.canvas.addEventListener("pointerdown", (e) => {
      fingers.set(e.pointerId, e);
      this.canvas.setPointerCapture(e.pointerId);
      apart = 0;
    });
    this.canvas.addEventListener("pointermove", (e) => {
      const before = fingers.get(e.pointerId);
      if (!before) return;
      fingers.set(e.pointerId, e);
      if (fingers.size === 1) {
        this.turn -= (e.clientX - before.clientX) * 0.008;
        this.tilt = Math.max(-1.5, Math.min(1.5, this.tilt + (e.clientY - before.clientY) * 0.008));
      } else {
        const [a, b] = [...fingers.values()], now = Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
        if (apart) this.near *= apart / now;
        apart = now;
      }
      this.draw();
    });
    for (const end of ["pointerup", "pointercancel"]) this.canvas.addEventListener(end, (e) => fingers.delete(e.pointerId));
    this.canvas.addEventListener("wheel", (e) => {
      e.preventDefault();
      this.near = Math.max(0.2, Math.min(4, this.near * Math.exp(e.deltaY * 0.001)));
      this.draw();
    }, { passive: false });
    new ResizeObserver(() => this.draw()).observe(this.canvas);
  }
  play() {
    const from = this.opening > 0.999 ? 0 : this.opening, began = performance.now();
    const run = this.playing = (this.playing || 0) + 1;
    const step = (now) => {
      if (this.playing !== run) return;
      const at = Math.min(from + (now - began) / 4000, 1);
      this.open(at);
      if (at < 1) requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }
  open(opening) {
    this.opening = Math.max(0, Math.min(1, opening));
    this.extent = this.model.extent(this.opening);
    this.place.querySelector("input").value = this.opening;
    this.place.querySelector("output").textContent = `${Math.round(this.opening * 100)} %`;
    this.draw();
  }
  camera() {
    const { corners, middle } = this.extent, angle = 0.5, wide = this.canvas.width / this.canvas.height;
    const [c, s, u, v] = [Math.cos(this.tilt), Math.sin(this.tilt), Math.cos(this.turn), Math.sin(this.turn)];
    const z = [c * v, s, c * u], x = [u, 0, -v], y = [-s * v, c, -s * u];
    const along = (axis, p) => axis[0] * (p[0] - middle[0]) + axis[1] * (p[1] - middle[1]) + axis[2] * (p[2] - middle[2]);
    const up = Math.tan(angle / 2) * 0.94;
    let far = 0, radius = 0;
    for (const p of corners) {
      const [right, high, deep] = [x, y, z].map((axis) => along(axis, p));
      far = Math.max(far, deep + Math.abs(high) / up, deep + Math.abs(right) / (up * wide));
      radius = Math.max(radius, Math.hypot(right, high, deep));
    }
    far *= this.near;
    const eye = middle.map((m, i) => m + far * z[i]);
    const dot = (p) => p[0] * eye[0] + p[1] * eye[1] + p[2] * eye[2];
    const look = Float32Array.of(x[0], y[0], z[0], 0, x[1], y[1], z[1], 0, x[2], y[2], z[2], 0, -dot(x), -dot(y), -dot(z), 1);
    const f = 1 / Math.tan(angle / 2), near = Math.max(far - 2 * radius, far * 0.02), end = far + 2 * radius;
    const lens = Float32Array.of(f / wide, 0, 0, 0, 0, f, 0, 0, 0, 0, (end + near) / (near - end), -1, 0, 0, 2 * end * near / (near - end), 0);
    return { view: times(lens, look), eye };
  }
  draw() {
    const { gl, canvas, at } = this, dots = window.devicePixelRatio || 1;
    canvas.width = Math.max(1, Math.round(canvas.clientWidth * dots));
    canvas.height = Math.max(1, Math.round(canvas.clientHeight * dots));
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clearColor(0.96, 0.972, 0.98, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const { view, eye } = this.camera();
    gl.uniformMatrix4fv(at.view, false, view);
    gl.uniform3fv(at.eye, eye);
    this.model.matrices(this.opening).forEach((matrix, k) => {
      const mesh = this.meshes[this.model.bodies[k].mesh];
      gl.uniformMatrix4fv(at.model, false, matrix);
      gl.uniform3fv(at.colour, mesh.colour);
      gl.bindVertexArray(mesh.form);
      gl.drawElements(gl.TRIANGLES, mesh.count, mesh.kind, 0);
    });
  }
}

for (const place of document.querySelectorAll(".live")) new View(place);
