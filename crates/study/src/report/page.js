"use strict";
// Draws two views of the mean surface with WebGL 2 in one canvas: maps of statistics on the left, modes and subjects on the
// right, with one rotation for both; the pictures of the table of quality control; and those of all maps and modes for print.
(() => {
  const data = JSON.parse(document.getElementById("data").textContent);
  const by = (id) => document.getElementById(id);
  const canvas = by("view");
  const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const floats = (text) => new Float32Array(bytes(text).buffer);
  const gl = canvas.getContext("webgl2", { antialias: true, preserveDrawingBuffer: true });

  // Figures to save: a plot, or the view with its colors, as SVG, or drawn from it at twice its size as PNG.
  const keep = (name, blob) => {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(blob);
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
  };
  const asText = (svg) => {
    const { width, height } = svg.viewBox.baseVal, whole = svg.cloneNode(true);
    const set = { width, height, "font-family": "sans-serif", "font-size": 12, fill: "#5b6675" };
    for (const [name, value] of Object.entries(set)) whole.setAttribute(name, value);
    const ground = document.createElementNS(svg.namespaceURI, "rect");
    for (const [name, value] of Object.entries({ width, height, fill: "#fff" })) ground.setAttribute(name, value);
    whole.prepend(ground);
    return [new XMLSerializer().serializeToString(whole), width, height];
  };
  const savers = (place, name, make) => {
    for (const kind of ["SVG", "PNG"]) {
      const button = document.createElement("button");
      button.type = "button";
      button.textContent = `Save as ${kind}`;
      button.addEventListener("click", () => {
        const [text, width, height] = asText(make());
        if (kind === "SVG") return keep(`${name()}.svg`, new Blob([text], { type: "image/svg+xml" }));
        const picture = new Image(), paper = document.createElement("canvas");
        picture.addEventListener("load", () => {
          [paper.width, paper.height] = [2 * width, 2 * height];
          paper.getContext("2d").drawImage(picture, 0, 0, paper.width, paper.height);
          paper.toBlob((blob) => keep(`${name()}.png`, blob), "image/png");
        });
        picture.src = `data:image/svg+xml,${encodeURIComponent(text)}`;
      });
      place.append(button);
    }
  };
  const plain = (text) => text.toLowerCase().replace(/[^a-z0-9]+/g, "-").replace(/^-|-$/g, "");
  for (const plot of document.querySelectorAll("svg.plot")) {
    const row = document.createElement("p");
    row.className = "save";
    plot.after(row);
    savers(row, () => plain(plot.getAttribute("aria-label")), () => plot);
  }
  if (!gl) {
    const said = document.createElement("p");
    said.className = "warning";
    said.textContent = "This browser has no WebGL 2, so the pictures of surfaces, maps and modes are missing here.";
    canvas.parentElement.before(said);
    return;
  }

  const vertexShader = `#version 300 es
    in vec3 place; in vec3 move; in float value; in float mark;
    uniform mat3 turn; uniform vec3 scale; uniform float amount;
    out vec3 at; out float shade; out float shown;
    void main() {
      vec3 p = turn * (place + amount * move);
      at = p; shade = value; shown = mark;
      gl_Position = vec4(p * scale, 1.0);
    }`;
  const fragmentShader = `#version 300 es
    precision highp float;
    in vec3 at; in float shade; in float shown; out vec4 pixel;
    void main() {
      vec3 normal = normalize(cross(dFdx(at), dFdy(at)));
      float light = 0.4 + 0.6 * abs(dot(normal, normalize(vec3(0.3, 0.5, 1.0))));
      vec3 gray = vec3(0.80, 0.81, 0.83);
      float s = clamp(shade, -1.0, 1.0);
      vec3 cold = vec3(0.13, 0.35, 0.68), warm = vec3(0.70, 0.11, 0.14);
      vec3 color = s < 0.0 ? mix(gray, cold, -s) : mix(gray, warm, s);
      pixel = vec4(mix(gray, color, step(0.5, shown)) * light, 1.0);
    }`;
  const program = gl.createProgram();
  for (const [kind, text] of [[gl.VERTEX_SHADER, vertexShader], [gl.FRAGMENT_SHADER, fragmentShader]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) { by("legend").textContent = "The surfaces cannot be drawn on this machine."; return; }
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
  const points = floats(data.points), n = points.length / 3;
  const array = gl.createVertexArray();
  gl.bindVertexArray(array);
  const triangles = new Uint32Array(bytes(data.triangles).buffer);
  buffer(gl.ELEMENT_ARRAY_BUFFER, triangles);
  const place = buffer(gl.ARRAY_BUFFER, points);
  const none = buffer(gl.ARRAY_BUFFER, new Float32Array(3 * n));
  const all = buffer(gl.ARRAY_BUFFER, new Float32Array(n).fill(1));
  const signed = (text) => buffer(gl.ARRAY_BUFFER, Float32Array.from(new Int8Array(bytes(text).buffer), (x) => x / 127));
  const flags = (text) => buffer(gl.ARRAY_BUFFER, Float32Array.from(bytes(text), (x) => x));
  const maps = data.maps.map((map) => ({ values: signed(map.values), marks: flags(map.significant) }));
  const shapes = data.shapes.map((shape) => ({
    place: shape.points ? buffer(gl.ARRAY_BUFFER, floats(shape.points)) : place,
    move: shape.move ? buffer(gl.ARRAY_BUFFER, floats(shape.move)) : none,
    values: signed(shape.values),
  }));
  const attribute = (name, from, size) => {
    gl.bindBuffer(gl.ARRAY_BUFFER, from);
    gl.enableVertexAttribArray(at(name));
    gl.vertexAttribPointer(at(name), size, gl.FLOAT, false, 0, 0);
  };

  let turn = data.turn, zoom = 1, waiting = false;
  const times = (a, b) => a.map((_, k) => {
    const row = Math.floor(k / 3), column = k % 3;
    return a[3 * row] * b[column] + a[3 * row + 1] * b[3 + column] + a[3 * row + 2] * b[6 + column];
  });
  const about = (x, y) => {
    const [cx, sx, cy, sy] = [Math.cos(x), Math.sin(x), Math.cos(y), Math.sin(y)];
    return times([1, 0, 0, 0, cx, -sx, 0, sx, cx], [cy, 0, sy, 0, 1, 0, -sy, 0, cy]);
  };
  const one = (what, amount, [x, y, width, height], turned, zoomed) => {
    gl.viewport(x, y, width, height);
    gl.bindVertexArray(array);
    attribute("place", what.place || place, 3);
    attribute("move", what.move || none, 3);
    attribute("value", what.values || none, 1);
    attribute("mark", what.marks || all, 1);
    gl.uniformMatrix3fv(uniform("turn"), true, turned);
    gl.uniform1f(uniform("amount"), amount);
    // What is long and lies across fills the width.
    const scale = 0.92 * zoomed / data.radius, size = Math.min(width, 1.6 * height);
    gl.uniform3f(uniform("scale"), scale * size / width, scale * size / height, -0.4 / data.radius);
    gl.drawElements(gl.TRIANGLES, triangles.length, gl.UNSIGNED_INT, 0);
  };
  const clear = () => {
    gl.clearColor(0.965, 0.97, 0.976, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  };

  const map = by("map"), only = by("only"), shape = by("shape"), along = by("along");
  const draw = () => {
    waiting = false;
    const ratio = window.devicePixelRatio || 1;
    const [width, height] = [Math.round(canvas.clientWidth * ratio), Math.round(canvas.clientHeight * ratio)];
    if (canvas.width !== width || canvas.height !== height) { canvas.width = width; canvas.height = height; }
    clear();
    const half = Math.floor(width / 2), chosen = maps[map.value] || {};
    one(only.checked ? chosen : { values: chosen.values }, 0, [0, 0, half, height], turn, zoom);
    const right = shapes[shape.value];
    if (right) one(right, data.shapes[shape.value].move ? Number(along.value) / 50 : 0, [half, 0, half, height], turn, zoom);
  };
  const redraw = () => { if (!waiting) { waiting = true; requestAnimationFrame(draw); } };
  const ends = (of) => [`−${of.largest.toPrecision(3)}`, of.largest.toPrecision(3)];
  const say = () => {
    const right = data.shapes[shape.value];
    for (const [place, of] of [["", data.maps[map.value]], ["right-", right]]) {
      [by(`${place}low`).textContent, by(`${place}high`).textContent] = of ? ends(of) : ["", ""];
      by(`${place}legend`).textContent = of ? of.legend : "";
      by(`${place}bar`).hidden = !of;
    }
    by("right").textContent = right ? right.title : "";
    along.disabled = !(right && right.move);
    redraw();
  };

  // The view with its names, color bar and units, as SVG around the picture.
  const figure = () => {
    draw();
    const like = document.querySelector("svg.plot"), space = like.namespaceURI;
    const width = 960, high = Math.round((width * canvas.height) / canvas.width), height = high + 66;
    const made = (name, members, text = "") => {
      const element = document.createElementNS(space, name);
      for (const [member, value] of Object.entries(members)) element.setAttribute(member, value);
      element.textContent = text;
      return element;
    };
    const svg = made("svg", { viewBox: `0 0 ${width} ${height}` });
    svg.append(made("image", { href: canvas.toDataURL("image/png"), width, height: high }));
    svg.append(made("text", { x: 12, y: 20 }, "mean"), made("text", { x: width / 2 + 12, y: 20 }, by("right").textContent));
    const ramp = made("linearGradient", { id: "ramp" });
    [["0", "rgb(33,89,173)"], ["0.5", "rgb(204,207,212)"], ["1", "rgb(179,28,36)"]].forEach(([offset, color]) => ramp.append(made("stop", { offset, "stop-color": color })));
    svg.append(ramp);
    ["", "right-"].filter((place) => !by(`${place}bar`).hidden).forEach((place, k) => {
      const y = high + 16 + 22 * k, of = (name) => by(place + name).textContent;
      svg.append(made("text", { x: 92, y: y + 11, "text-anchor": "end" }, of("low")), made("rect", { x: 100, y, width: 200, height: 12, fill: `url${"("}#ramp)` }));
      svg.append(made("text", { x: 308, y: y + 11 }, `${of("high")}   ${of("legend")}${k === 0 && only.checked ? ", significant vertices" : ""}`));
    });
    return svg;
  };
  savers(by("save"), () => plain(`${by("legend").textContent} ${by("right").textContent}`), figure);

  // Maps and modes for print, each from both sides, with its color bar: drawn in the same canvas, then copied.
  [canvas.width, canvas.height] = [880, 256];
  const behind = times(about(0, Math.PI), data.turn);
  const printed = [...data.maps.map((of, k) => [of, maps[k], 0]), ...data.shapes.map((of, k) => [of, shapes[k], 1]).filter(([of]) => of.move)];
  for (const [of, what, amount] of printed.slice(0, data.printed)) {
    clear();
    one({ ...what, marks: undefined }, amount, [0, 0, 440, 256], data.turn, 1);
    one({ ...what, marks: undefined }, amount, [440, 0, 440, 256], behind, 1);
    const [figure, picture, scale, bar, caption] = ["figure", "canvas", "div", "span", "figcaption"].map((name) => document.createElement(name));
    [picture.width, picture.height, scale.className, bar.className] = [880, 256, "colors", "bar"];
    picture.getContext("2d").drawImage(canvas, 0, 0);
    const [low, high] = ends(of);
    scale.append(low, bar, high);
    caption.textContent = of.legend;
    figure.append(picture, scale, caption);
    by("figures").append(figure);
  }

  // Pictures of quality control.
  canvas.width = 220; canvas.height = 128;
  for (const picture of document.querySelectorAll("canvas[data-shape]")) {
    clear();
    one(shapes[Number(picture.dataset.shape)], 0, [0, 0, 220, 128], data.turn, 1.1);
    picture.width = 220; picture.height = 128;
    picture.getContext("2d").drawImage(canvas, 0, 0);
  }

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
  for (const input of [map, shape, only]) input.addEventListener("change", say);
  along.addEventListener("input", redraw);
  new ResizeObserver(redraw).observe(canvas);
  say();
})();
