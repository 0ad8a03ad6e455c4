// Volumes of NIfTI-1 and NIfTI-2 files, in either byte order, as they are or in gzip.

import { Matrix4, Quaternion, Vector3 } from "three";

export interface Volume {
  dims: [number, number, number];
  /** The voxels, the first index fastest. */
  values: ArrayLike<number>;
  /** From voxels to RAS, mm. */
  worldFromVoxel: Matrix4;
  /** The values that are drawn black and white: all but the outermost hundredths. */
  low: number;
  high: number;
}

/** A larger volume would take more memory than a page should. */
export const MOST_BYTES = 1 << 30;

/** The bytes of a number, and how it is read. */
export type Reading = [number, (view: DataView, at: number, little: boolean) => number];

export const KINDS: Record<number, Reading> = {
  2: [1, (view, at) => view.getUint8(at)],
  256: [1, (view, at) => view.getInt8(at)],
  4: [2, (view, at, little) => view.getInt16(at, little)],
  512: [2, (view, at, little) => view.getUint16(at, little)],
  8: [4, (view, at, little) => view.getInt32(at, little)],
  768: [4, (view, at, little) => view.getUint32(at, little)],
  16: [4, (view, at, little) => view.getFloat32(at, little)],
  64: [8, (view, at, little) => view.getFloat64(at, little)],
  1024: [8, (view, at, little) => Number(view.getBigInt64(at, little))],
  1280: [8, (view, at, little) => Number(view.getBigUint64(at, little))],
};

/** The fields of a header, by their places in the two versions. */
class Header {
  readonly little: boolean;
  readonly second: boolean;

  constructor(readonly view: DataView) {
    const sizes = [true, false].map((little) => view.getInt32(0, little));
    const found = sizes.findIndex((size) => size === 348 || size === 540);
    if (found < 0) throw new Error("This is no volume of NIfTI, NRRD, MetaImage or MGH.");
    this.little = found === 0;
    this.second = sizes[found] === 540;
  }

  private integer(first: number, second: number, width: 2 | 4 | 8): number {
    if (!this.second) return width === 2 || width === 8 ? this.view.getInt16(first, this.little) : this.view.getInt32(first, this.little);
    return width === 8 ? Number(this.view.getBigInt64(second, this.little)) : width === 4 ? this.view.getInt32(second, this.little) : this.view.getInt16(second, this.little);
  }

  real(first: number, second: number, k = 0): number {
    return this.second ? this.view.getFloat64(second + 8 * k, this.little) : this.view.getFloat32(first + 4 * k, this.little);
  }

  get dims(): [number, number, number] {
    const at = (k: number) => Math.max(1, this.integer(40 + 2 * k, 16 + 8 * k, 8));
    const n = this.integer(40, 16, 8);
    return [1, 2, 3].map((k) => (k <= n ? at(k) : 1)) as [number, number, number];
  }

  get kind(): number {
    return this.integer(70, 12, 2);
  }

  get offset(): number {
    return this.second ? Number(this.view.getBigInt64(168, this.little)) : Math.round(this.view.getFloat32(108, this.little));
  }

  /** The sform if its code is positive, else the qform, else the sizes of the voxels: as the service takes them. */
  get worldFromVoxel(): Matrix4 {
    const code = (first: number, second: number) => (this.second ? this.view.getInt32(second, this.little) : this.view.getInt16(first, this.little));
    const unit = [1, 1000, 1, 0.001][(this.second ? this.view.getInt32(500, this.little) : this.view.getUint8(123)) & 7] ?? 1;
    const sizes = [1, 2, 3].map((k) => Math.abs(this.real(76, 104, k)));
    const made = new Matrix4();
    if (code(254, 348) > 0) {
      const rows = Array.from({ length: 12 }, (_, k) => this.real(280, 400, k));
      made.set(...(rows as unknown as Parameters<Matrix4["set"]>)).setPosition(rows[3]!, rows[7]!, rows[11]!);
      const e = made.elements;
      [e[3], e[7], e[11], e[15]] = [0, 0, 0, 1];
    } else if (code(252, 344) > 0) {
      const [b, c, d] = [0, 1, 2].map((k) => this.real(256, 352, k)) as [number, number, number];
      const turn = new Quaternion(b, c, d, Math.sqrt(Math.max(0, 1 - b * b - c * c - d * d))).normalize();
      const place = new Vector3(...([0, 1, 2].map((k) => this.real(268, 376, k)) as [number, number, number]));
      made.compose(place, turn, new Vector3(sizes[0], sizes[1], sizes[2]! * (this.real(76, 104) < 0 ? -1 : 1)));
    } else {
      made.makeScale(sizes[0]!, sizes[1]!, sizes[2]!);
    }
    return new Matrix4().makeScale(unit, unit, unit).multiply(made);
  }
}

/** The bytes of a file up to the number that `enough` asks for once it has the head. */
async function bytesOf(file: Blob, enough: (head: DataView) => number): Promise<DataView> {
  const magic = new Uint8Array(await file.slice(0, 2).arrayBuffer());
  const stream: ReadableStream<Uint8Array> = magic[0] === 0x1f && magic[1] === 0x8b ? file.stream().pipeThrough(new DecompressionStream("gzip")) : file.stream();
  const reader = stream.getReader();
  let [bytes, n, wanted] = [new Uint8Array(1 << 16), 0, Infinity];
  for (;;) {
    const { done, value } = await reader.read();
    if (value) {
      if (n + value.length > bytes.length) {
        const more = new Uint8Array(Math.min(Math.max(2 * bytes.length, n + value.length), Math.max(wanted, n + value.length)));
        more.set(bytes.subarray(0, n));
        bytes = more;
      }
      bytes.set(value, n);
      n += value.length;
    }
    if (wanted === Infinity && n >= 544) wanted = enough(new DataView(bytes.buffer, 0, n));
    if (done || n >= wanted) break;
  }
  await reader.cancel();
  if (n < (wanted === Infinity ? 352 : wanted)) throw new Error("This NIfTI file ends too early.");
  return new DataView(bytes.buffer, 0, n);
}

export async function readNifti(file: Blob): Promise<Volume> {
  const needed = (head: DataView): number => {
    const header = new Header(head);
    const kind = KINDS[header.kind];
    if (!kind) throw new Error("This NIfTI file has voxels of a kind that is not shown: numbers of up to 64 bits are.");
    const n = header.offset + header.dims[0] * header.dims[1] * header.dims[2] * kind[0];
    if (!(n <= MOST_BYTES)) throw new Error("This volume is too large to be shown: at most 1 GiB is.");
    return n;
  };
  const view = await bytesOf(file, needed);
  needed(view);
  const header = new Header(view);
  const [width, read] = KINDS[header.kind]!;
  const { dims, offset, little } = header;
  const n = dims[0] * dims[1] * dims[2];
  const [slope, start] = [header.real(112, 176), header.real(116, 184)];
  const [a, b] = slope !== 0 && Number.isFinite(slope) && Number.isFinite(start) ? [slope, start] : [1, 0];
  const values = new Float32Array(n);
  for (let k = 0; k < n; k++) values[k] = a * read(view, offset + k * width, little) + b;
  return volumeOf(dims, values, header.worldFromVoxel);
}

/** A volume with the shades in which it is drawn. */
export function volumeOf(dims: Volume["dims"], values: Float32Array, worldFromVoxel: Matrix4): Volume {
  const step = Math.max(1, Math.floor(values.length / 100_000));
  const sample = values.filter((value, k) => k % step === 0 && Number.isFinite(value)).sort();
  let [low, high] = [0.01, 0.99].map((share) => sample[Math.floor(share * (sample.length - 1))] ?? 0) as [number, number];
  // A small label fills less than a hundredth.
  if (low === high) [low, high] = [sample[0] ?? 0, values.reduce((most, value) => Math.max(most, value), low)];
  return { dims, values, worldFromVoxel, low, high: high > low ? high : low + 1 };
}

/** The value of the voxel in which a place lies; undefined outside. */
export function valueAt({ dims, values }: Volume, voxelFromWorld: Matrix4, place: Vector3): { voxel: [number, number, number]; value: number } | undefined {
  const voxel = place.clone().applyMatrix4(voxelFromWorld).round().toArray() as [number, number, number];
  if (voxel.some((x, k) => x < 0 || x >= dims[k]!)) return undefined;
  return { voxel, value: values[voxel[0] + dims[0] * (voxel[1] + dims[1] * voxel[2])]! };
}
