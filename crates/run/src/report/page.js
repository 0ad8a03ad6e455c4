"use strict";
// Draws both surfaces with WebGL 2 in one canvas, the source on the left, with one rotation for both.
(() => {
  const data = JSON.parse(document.getElementById("data").textContent);
  const canvas = document.getElementById("view");
  const say = (text) => { document.getElementById("legend").textContent = text; };
  const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer;
  const gl = canvas.getContext("webgl2", { antialias: true, preserveDrawingBuffer: true });
  if (!gl) { say("This browser has no WebGL 2, which the view of the surfaces needs."); return; }

  const vertexShader = `#version 300 es
    in vec3 rigid; in vec3 bent; in vec3 color;
    uniform mat3 turn; uniform vec3 scale; uniform float bending;
    out vec3 shade; out vec3 place;
    void main() {
      vec3 p = turn * mix(rigid, bent, bending);
      shade = color; place = p;
      gl_Position = vec4(p * scale, 1.0);
    }`;
  const fragmentShader = `#version 300 es
    precision highp float;
    in vec3 shade; in vec3 place; out vec4 pixel;
    void main() {
      vec3 normal = normalize(cross(dFdx(place), dFdy(place)));
      float light = 0.35 + 0.65 * abs(dot(normal, normalize(vec3(0.3, 0.5, 1.0))));
      pixel = vec4(shade * light, 1.0);
    }`;
  const program = gl.createProgram();
  for (const [kind, text] of [[gl.VERTEX_SHADER, vertexShader], [gl.FRAGMENT_SHADER, fragmentShader]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) { say("The surfaces cannot be drawn on this machine."); return; }
  gl.useProgram(program);
  gl.enable(gl.DEPTH_TEST);
  const at = (name) => gl.getAttribLocation(program, name);
  const uniform = (name) => gl.getUniformLocation(program, name);

  const buffer = (target, content) => {
    const made = gl.createBuffer();
    gl.bindBuffer(target, made);
    gl.bufferData(target, content, gl.STATIC_DRAW);
    return made;
  };
  const surfaces = data.surfaces.map((surface) => {
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    for (const [name, text] of [["rigid", surface.points], ["bent", surface.bent || surface.points]]) {
      buffer(gl.ARRAY_BUFFER, bytes(text));
      gl.enableVertexAttribArray(at(name));
      gl.vertexAttribPointer(at(name), 3, gl.FLOAT, false, 0, 0);
    }
    const triangles = new Uint32Array(bytes(surface.triangles));
    buffer(gl.ELEMENT_ARRAY_BUFFER, triangles);
    const colors = surface.colors.map((text) => buffer(gl.ARRAY_BUFFER, bytes(text)));
    gl.enableVertexAttribArray(at("color"));
    return { array, colors, count: triangles.length };
  });

  let turn = data.turn, zoom = 1, mode = 0, bending = 0, waiting = false;
  const times = (a, b) => a.map((_, k) => {
    const row = Math.floor(k / 3), column = k % 3;
    return a[3 * row] * b[column] + a[3 * row + 1] * b[3 + column] + a[3 * row + 2] * b[6 + column];
  });
  const about = (x, y) => {
    const [cx, sx, cy, sy] = [Math.cos(x), Math.sin(x), Math.cos(y), Math.sin(y)];
    return times([1, 0, 0, 0, cx, -sx, 0, sx, cx], [cy, 0, sy, 0, 1, 0, -sy, 0, cy]);
  };

  const draw = () => {
    waiting = false;
    const ratio = window.devicePixelRatio || 1;
    const [width, height] = [Math.round(canvas.clientWidth * ratio), Math.round(canvas.clientHeight * ratio)];
    if (canvas.width !== width || canvas.height !== height) { canvas.width = width; canvas.height = height; }
    gl.viewport(0, 0, width, height);
    gl.clearColor(0.965, 0.97, 0.976, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const half = width / 2, size = Math.min(half, height);
    gl.uniformMatrix3fv(uniform("turn"), true, turn);
    gl.uniform1f(uniform("bending"), bending);
    const scale = 0.92 * zoom / data.radius;
    // Depth shrinks with the zoom, so that nothing is cut off.
    gl.uniform3f(uniform("scale"), scale * size / half, scale * size / height, -0.4 / data.radius);
    surfaces.forEach((surface, k) => {
      gl.viewport(k * half, 0, half, height);
      gl.bindVertexArray(surface.array);
      gl.bindBuffer(gl.ARRAY_BUFFER, surface.colors[mode]);
      gl.vertexAttribPointer(at("color"), 3, gl.UNSIGNED_BYTE, true, 0, 0);
      gl.drawElements(gl.TRIANGLES, surface.count, gl.UNSIGNED_INT, 0);
    });
  };
  const redraw = () => { if (!waiting) { waiting = true; requestAnimationFrame(draw); } };

  let last = null;
  canvas.addEventListener("pointerdown", (e) => { last = [e.clientX, e.clientY]; canvas.setPointerCapture(e.pointerId); });
  canvas.addEventListener("pointermove", (e) => {
    if (!last) return;
    turn = times(about((e.clientY - last[1]) * 0.01, (e.clientX - last[0]) * 0.01), turn);
    last = [e.clientX, e.clientY];
    redraw();
  });
  for (const name of ["pointerup", "pointercancel"]) canvas.addEventListener(name, () => { last = null; });
  canvas.addEventListener("wheel", (e) => {
    e.preventDefault();
    zoom = Math.min(20, Math.max(0.3, zoom * Math.exp(-e.deltaY * 0.001)));
    redraw();
  }, { passive: false });
  canvas.addEventListener("keydown", (e) => {
    const steps = { ArrowLeft: [0, -0.1], ArrowRight: [0, 0.1], ArrowUp: [-0.1, 0], ArrowDown: [0.1, 0] };
    if (!steps[e.key]) return;
    e.preventDefault();
    turn = times(about(...steps[e.key]), turn);
    redraw();
  });
  const legends = document.querySelectorAll("#legend > span");
  const show = (k) => { mode = k; legends.forEach((legend, i) => { legend.hidden = i !== k; }); redraw(); };
  document.querySelectorAll("input[name=color]").forEach((input, k) => {
    input.addEventListener("change", () => show(k));
    if (input.checked) mode = k;
  });
  document.getElementById("bending").addEventListener("input", (e) => { bending = Number(e.target.value) / 100; redraw(); });
  new ResizeObserver(redraw).observe(canvas);
  show(mode);
})();
