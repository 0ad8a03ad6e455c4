// An account of a match that shares no code with the page: its correspondences as JSON, its surfaces from PLY.

/** Vertices of a binary PLY of doubles, whose other columns are skipped. */
export function vertices(buffer) {
  const end = buffer.indexOf("end_header\n") + 11;
  const lines = buffer.toString("latin1", 0, end).split("\n");
  const sizes = { double: 8, float: 4, int: 4, uint: 4, uchar: 1, char: 1, short: 2, ushort: 2 };
  let [n, stride, inVertices] = [0, 0, false];
  const at = {};
  for (const line of lines) {
    const [word, kind, name] = line.split(" ");
    if (word === "element") inVertices = kind === "vertex";
    if (word === "element" && inVertices) n = Number(name);
    if (word === "property" && inVertices) {
      at[name] = stride;
      stride += sizes[kind];
    }
  }
  return Array.from({ length: n }, (_, v) => ["x", "y", "z"].map((axis) => buffer.readDoubleLE(end + v * stride + at[axis])));
}

/** The longest principal axis, by iteration, with the center and the extent along it. */
export function longestAxis(points) {
  const center = [0, 1, 2].map((k) => points.reduce((sum, p) => sum + p[k], 0) / points.length);
  let axis = [0.3, 0.5, 0.8];
  for (let step = 0; step < 400; step++) {
    const next = [0, 0, 0];
    for (const p of points) {
      const d = p.map((x, k) => x - center[k]);
      const along = d[0] * axis[0] + d[1] * axis[1] + d[2] * axis[2];
      for (let k = 0; k < 3; k++) next[k] += along * d[k];
    }
    const length = Math.hypot(...next);
    axis = next.map((x) => x / length);
  }
  const along = (p) => p.reduce((sum, x, k) => sum + (x - center[k]) * axis[k], 0);
  const all = points.map(along);
  const [low, high] = [Math.min(...all), Math.max(...all)];
  return (p) => (along(p) - low) / (high - low);
}

// viridis at equal steps, as matplotlib has it.
const VIRIDIS = [[68, 1, 84], [71, 45, 123], [59, 82, 139], [44, 114, 142], [33, 145, 140], [40, 174, 128], [94, 201, 98], [173, 220, 48], [253, 231, 37]];

export function viridis(share) {
  const at = Math.min(1, Math.max(0, share)) * (VIRIDIS.length - 1);
  const k = Math.min(VIRIDIS.length - 2, Math.floor(at));
  return VIRIDIS[k].map((low, c) => low + (at - k) * (VIRIDIS[k + 1][c] - low));
}

/** How far two colors are from each other apart from their brightness: the angle between them, in degrees. */
export function angle(a, b) {
  const dot = a.reduce((sum, x, k) => sum + x * b[k], 0);
  return (180 / Math.PI) * Math.acos(Math.min(1, dot / (Math.hypot(...a) * Math.hypot(...b) || 1)));
}
