// A matched pair as arrays: both surfaces, the correspondence between them, and what is measured at each vertex.

import { BufferAttribute, BufferGeometry, Matrix3, Matrix4, Vector3 } from "three";
import { PLYLoader } from "three/examples/jsm/loaders/PLYLoader.js";
import { call, get, type Job, type Result } from "./api";
import { ofCategory } from "./colors";
import { answered } from "./live";

export interface Pair {
  source: BufferGeometry;
  target: BufferGeometry;
  targetFromSource: Matrix4;
  /** For each source vertex its corresponding point on the target, mm. */
  images: Float32Array;
  /** For each source vertex the nearest target vertex; -1 without counterpart. */
  nearest: Int32Array;
  inlier: Uint8Array;
  columns: Columns;
  /** The same on the target, carried over by the correspondence; NaN where nothing corresponds. */
  onTarget: Columns;
  /** Source vertices that correspond to each target vertex: those of vertex `v` are `sources[starts[v]..starts[v + 1]]`. */
  starts: Uint32Array;
  sources: Uint32Array;
  frame: Frame;
}

export type ColumnName = "confidence" | "residual" | "displacement" | "spread" | "outlier";
export type Columns = Record<ColumnName, Float32Array>;

/** The principal axes of the target, longest first. */
export interface Frame {
  center: Vector3;
  axes: [Vector3, Vector3, Vector3];
  /** Least and greatest coordinate along each axis, from the center, mm. */
  low: Vector3;
  high: Vector3;
}

type Rows = Record<string, Float32Array>;

/** Reads a PLY file with these columns; those that it does not have are absent. */
export function readPly(bytes: ArrayBuffer, columns: string[] = []): { geometry: BufferGeometry; rows: Rows } {
  const loader = new PLYLoader();
  const header = new TextDecoder().decode(bytes.slice(0, 4096)).split("end_header")[0] ?? "";
  const present = columns.filter((name) => new RegExp(`^property \\w+ ${name}\\s*$`, "m").test(header));
  loader.setCustomPropertyNameMapping(Object.fromEntries(present.map((name) => [name, [name]])));
  const geometry = loader.parse(bytes);
  const rows: Rows = {};
  for (const name of present) {
    rows[name] = Float32Array.from(geometry.getAttribute(name).array);
    geometry.deleteAttribute(name);
  }
  // Files have doubles, which graphics processors do not take.
  geometry.setAttribute("position", new BufferAttribute(Float32Array.from(geometry.getAttribute("position").array), 3));
  geometry.computeVertexNormals();
  geometry.computeBoundingSphere();
  return { geometry, rows };
}

const MATCH = ["target", "confidence", "inlier", "spread_mm", "outlier", "triangle_0", "triangle_1", "triangle_2", "barycentric_0", "barycentric_1", "barycentric_2"];
export async function loadPair(job: Job, signal: AbortSignal): Promise<{ pair: Pair; result: Result }> {
  const base = `v1/jobs/${job.id}`;
  const bytes = async (path: string) => (await call(`${base}/${path}`, { signal })).arrayBuffer();
  const [result, matched, target] = await Promise.all([
    answered(() => get<Result>(`${base}/result?correspondences=false`, signal), signal),
    answered(() => bytes("correspondences?format=ply"), signal),
    answered(() => bytes("surfaces/target?format=ply"), signal),
  ]);
  return { pair: makePair(result, matched, target), result };
}

export function makePair(result: Result, matched: ArrayBuffer, targetBytes: ArrayBuffer): Pair {
  const { geometry: source, rows } = readPly(matched, MATCH);
  const { geometry: target } = readPly(targetBytes);
  const n = source.getAttribute("position").count;
  const none = new Float32Array(n);
  const row = (name: string) => rows[name] ?? none;
  const [from, to] = [source.getAttribute("position"), target.getAttribute("position")];
  const m = result.transform.matrix.flat() as [number];
  const targetFromSource = new Matrix4().set(...(m as unknown as Parameters<Matrix4["set"]>));

  const corners = [row("triangle_0"), row("triangle_1"), row("triangle_2")];
  const weights = [row("barycentric_0"), row("barycentric_1"), row("barycentric_2")];
  const images = new Float32Array(3 * n);
  const nearest = new Int32Array(n);
  const outlier = row("outlier");
  const columns: Columns = {
    confidence: new Float32Array(n),
    residual: new Float32Array(n),
    displacement: new Float32Array(n),
    spread: new Float32Array(n),
    outlier: new Float32Array(n),
  };
  const [moved, normal, normals] = [new Vector3(), new Vector3(), source.getAttribute("normal")];
  for (let v = 0; v < n; v++) {
    const isLost = outlier[v] === 4;
    for (let axis = 0; axis < 3; axis++) {
      let sum = 0;
      for (let k = 0; k < 3; k++) sum += (weights[k]?.[v] ?? 0) * to.getComponent(corners[k]?.[v] ?? 0, axis);
      images[3 * v + axis] = sum;
    }
    nearest[v] = isLost ? -1 : (row("target")[v] ?? -1);
    moved.fromBufferAttribute(from, v).applyMatrix4(targetFromSource);
    normal.fromBufferAttribute(normals, v).transformDirection(targetFromSource);
    moved.set(images[3 * v]! - moved.x, images[3 * v + 1]! - moved.y, images[3 * v + 2]! - moved.z);
    columns.confidence[v] = isLost ? NaN : (row("confidence")[v] ?? NaN);
    columns.spread[v] = isLost ? NaN : (row("spread_mm")[v] ?? NaN);
    columns.residual[v] = isLost ? NaN : moved.length();
    columns.displacement[v] = isLost ? NaN : moved.dot(normal);
    columns.outlier[v] = ofCategory(outlier[v] ?? 0);
  }

  const onTarget = Object.fromEntries(
    (Object.keys(columns) as ColumnName[]).map((name) => [name, carried(columns[name], name === "outlier", corners, weights, nearest, target)]),
  ) as Columns;

  const nTarget = to.count;
  const starts = new Uint32Array(nTarget + 1);
  nearest.forEach((v) => v >= 0 && starts[v + 1]!++);
  for (let v = 0; v < nTarget; v++) starts[v + 1]! += starts[v]!;
  const next = starts.slice(0, nTarget);
  const sources = new Uint32Array(starts[nTarget]!);
  nearest.forEach((v, s) => v >= 0 && (sources[next[v]!++] = s));

  const inlier = Uint8Array.from(row("inlier"));
  return { source, target, targetFromSource, images, nearest, inlier, columns, onTarget, starts, sources, frame: frameOf(target) };
}

/** Values of source vertices on the target: the mean, by barycentric weight, of those whose points are on a vertex's triangles. */
function carried(
  values: Float32Array,
  isCategory: boolean,
  corners: Float32Array[],
  weights: Float32Array[],
  nearest: Int32Array,
  target: BufferGeometry,
): Float32Array {
  const n = target.getAttribute("position").count;
  const out = new Float32Array(n).fill(NaN);
  if (isCategory) {
    // The worst of those that correspond.
    nearest.forEach((v, s) => v >= 0 && (out[v] = Math.max(Number.isNaN(out[v]!) ? 0 : out[v]!, values[s]!)));
  } else {
    const [sum, weight] = [new Float64Array(n), new Float64Array(n)];
    for (let s = 0; s < values.length; s++) {
      if (Number.isNaN(values[s]!)) continue;
      for (let k = 0; k < 3; k++) {
        const [v, w] = [corners[k]![s]!, weights[k]![s]!];
        sum[v]! += w * values[s]!;
        weight[v]! += w;
      }
    }
    for (let v = 0; v < n; v++) if (weight[v]! > 1e-9) out[v] = sum[v]! / weight[v]!;
  }
  const index = target.getIndex()!;
  for (let ring = 0; ring < 2; ring++) {
    const [sum, count] = [new Float64Array(n), new Uint16Array(n)];
    for (let k = 0; k < index.count; k += 3) {
      for (let a = 0; a < 3; a++) {
        const value = out[index.getX(k + a)]!;
        if (Number.isNaN(value)) continue;
        for (let b = 0; b < 3; b++) {
          const v = index.getX(k + b);
          sum[v] = isCategory ? Math.max(sum[v]!, value) : sum[v]! + value;
          count[v]!++;
        }
      }
    }
    for (let v = 0; v < n; v++) if (Number.isNaN(out[v]!) && count[v]! > 0) out[v] = isCategory ? sum[v]! : sum[v]! / count[v]!;
  }
  return out;
}

/** The principal axes of a surface's vertices, by Jacobi rotations of their covariance. */
export function frameOf(geometry: BufferGeometry): Frame {
  const positions = geometry.getAttribute("position");
  const center = new Vector3();
  const p = new Vector3();
  for (let v = 0; v < positions.count; v++) center.add(p.fromBufferAttribute(positions, v));
  center.divideScalar(Math.max(1, positions.count));
  const c = [0, 0, 0, 0, 0, 0, 0, 0, 0];
  for (let v = 0; v < positions.count; v++) {
    const d = p.fromBufferAttribute(positions, v).sub(center).toArray();
    for (let i = 0; i < 3; i++) for (let j = 0; j < 3; j++) c[3 * i + j]! += d[i]! * d[j]!;
  }
  const u = [1, 0, 0, 0, 1, 0, 0, 0, 1];
  for (let sweep = 0; sweep < 12; sweep++) {
    for (const [i, j] of [[0, 1], [0, 2], [1, 2]] as const) {
      const off = c[3 * i + j]!;
      if (Math.abs(off) < 1e-12) continue;
      const angle = 0.5 * Math.atan2(2 * off, c[3 * j + j]! - c[3 * i + i]!);
      const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
      for (let k = 0; k < 3; k++) {
        const [a, b] = [c[3 * k + i]!, c[3 * k + j]!];
        c[3 * k + i] = cos * a - sin * b;
        c[3 * k + j] = sin * a + cos * b;
      }
      for (let k = 0; k < 3; k++) {
        const [a, b] = [c[3 * i + k]!, c[3 * j + k]!];
        c[3 * i + k] = cos * a - sin * b;
        c[3 * j + k] = sin * a + cos * b;
        const [x, y] = [u[3 * k + i]!, u[3 * k + j]!];
        u[3 * k + i] = cos * x - sin * y;
        u[3 * k + j] = sin * x + cos * y;
      }
    }
  }
  const order = [0, 1, 2].sort((a, b) => c[4 * b]! - c[4 * a]!);
  const axis = (k: number) => new Vector3(u[order[k]!]!, u[3 + order[k]!]!, u[6 + order[k]!]!).normalize();
  const [first, second] = [axis(0), axis(1)];
  const axes: Frame["axes"] = [first, second, new Vector3().crossVectors(first, second)];
  return reaching(geometry, center, axes);
}

/** A frame with these axes, as far as the surface reaches. */
function reaching(geometry: BufferGeometry, center: Vector3, axes: Frame["axes"]): Frame {
  const positions = geometry.getAttribute("position");
  const [low, high] = [new Vector3(Infinity, Infinity, Infinity), new Vector3(-Infinity, -Infinity, -Infinity)];
  const [p, local] = [new Vector3(), new Vector3()];
  for (let v = 0; v < positions.count; v++) {
    p.fromBufferAttribute(positions, v).sub(center);
    local.set(p.dot(axes[0]), p.dot(axes[1]), p.dot(axes[2]));
    low.min(local);
    high.max(local);
  }
  return { center, axes, low, high };
}

/**
 * The frame in which a surface is seen as another of the same vertices is seen in its own: turned by the rotation between the two,
 * which is the orthogonal part of their covariance, by Newton's iteration (Higham 1986).
 */
export function frameLike(geometry: BufferGeometry, model: BufferGeometry): Frame {
  const frame = frameOf(model);
  const [to, from] = [geometry.getAttribute("position"), model.getAttribute("position")];
  if (to.count !== from.count) return frameOf(geometry);
  const center = new Vector3();
  const [p, q] = [new Vector3(), new Vector3()];
  for (let v = 0; v < to.count; v++) center.add(p.fromBufferAttribute(to, v));
  center.divideScalar(Math.max(1, to.count));
  const sum = [0, 0, 0, 0, 0, 0, 0, 0, 0];
  for (let v = 0; v < to.count; v++) {
    const [a, b] = [p.fromBufferAttribute(to, v).sub(center).toArray(), q.fromBufferAttribute(from, v).sub(frame.center).toArray()];
    for (let i = 0; i < 3; i++) for (let j = 0; j < 3; j++) sum[3 * i + j]! += a[i]! * b[j]!;
  }
  const turn = new Matrix3().set(...(sum as unknown as Parameters<Matrix3["set"]>));
  turn.multiplyScalar(1 / (Math.cbrt(Math.abs(turn.determinant())) || 1));
  for (let step = 0; step < 30; step++) {
    const inverse = turn.clone().invert().transpose();
    for (let k = 0; k < 9; k++) turn.elements[k] = (turn.elements[k]! + inverse.elements[k]!) / 2;
  }
  if (!(Math.abs(turn.determinant() - 1) < 0.01)) return frameOf(geometry);
  return reaching(geometry, center, frame.axes.map((axis) => axis.clone().applyMatrix3(turn)) as Frame["axes"]);
}

/** Coordinates of points in the frame: along the longest axis from 0 to 1, along the others in mm from the center. */
export function placesIn(frame: Frame, points: ArrayLike<number>, isKnown: (k: number) => boolean): BufferAttribute {
  const n = points.length / 3;
  const out = new Float32Array(3 * n);
  const p = new Vector3();
  const length = Math.max(1e-9, frame.high.x - frame.low.x);
  for (let k = 0; k < n; k++) {
    p.set(points[3 * k]!, points[3 * k + 1]!, points[3 * k + 2]!).sub(frame.center);
    out[3 * k] = isKnown(k) ? (p.dot(frame.axes[0]) - frame.low.x) / length : -1;
    out[3 * k + 1] = p.dot(frame.axes[1]);
    out[3 * k + 2] = p.dot(frame.axes[2]);
  }
  return new BufferAttribute(out, 3);
}

/** The value below which a share of the numbers is. */
export function quantile(values: Float32Array, share: number): number {
  const known = values.filter((value) => !Number.isNaN(value)).sort();
  return known[Math.min(known.length - 1, Math.floor(share * known.length))] ?? 1;
}
