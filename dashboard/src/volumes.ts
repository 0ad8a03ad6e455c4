// Volumes of NRRD, MetaImage and MGH files, read as the service reads them; others are taken for NIfTI.

import { Matrix4, Vector3 } from "three";
import { KINDS, MOST_BYTES, type Reading, type Volume, readNifti, volumeOf } from "./nifti";

/** Bytes that show the format: all fields of MetaImage that it is known by lie within them. */
const BEGINNING_BYTES = 2048;
const TOO_LARGE = "This volume is too large to be shown: at most 1 GiB is.";
const LPS = new Matrix4().makeScale(-1, -1, 1);

/** The readings of numbers, by their names in NIfTI. */
const [U8, I8, I16, U16, I32, U32, F32, F64, I64, U64] = [2, 256, 4, 512, 8, 768, 16, 64, 1024, 1280].map((code) => KINDS[code]!) as [Reading, Reading, Reading, Reading, Reading, Reading, Reading, Reading, Reading, Reading];

/** The bytes of a stream, of which there may be `most`; with `enough`, no more than the first of these. */
async function bytesOf(stream: ReadableStream<Uint8Array>, most: number, enough = Infinity): Promise<Uint8Array<ArrayBuffer>> {
  const reader = stream.getReader();
  const parts: Uint8Array[] = [];
  let n = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    parts.push(value);
    n += value.length;
    if (n > most) throw new Error(TOO_LARGE);
    if (n >= enough) break;
  }
  // What is left is not wanted, whatever becomes of it.
  reader.cancel().catch(() => undefined);
  const bytes = new Uint8Array(n);
  let at = 0;
  for (const part of parts) {
    bytes.set(part, at);
    at += part.length;
  }
  return bytes;
}

async function plain(file: Blob): Promise<ReadableStream<Uint8Array>> {
  const magic = new Uint8Array(await file.slice(0, 2).arrayBuffer());
  return magic[0] === 0x1f && magic[1] === 0x8b ? file.stream().pipeThrough(new DecompressionStream("gzip")) : file.stream();
}

/** At least `n` bytes of voxels, inflated if they are compressed: as many as are needed, or `all`. */
async function voxels(stored: Uint8Array<ArrayBuffer>, n: number, compression: CompressionFormat | null, format: string, all = false): Promise<Uint8Array> {
  const inflated = (as: CompressionFormat) => new Blob([stored]).stream().pipeThrough(new DecompressionStream(as));
  const bytes = compression === null ? stored : await bytesOf(inflated(compression), all ? 2 * MOST_BYTES : Infinity, all ? Infinity : n);
  if (bytes.length < n) throw new Error(`This ${format} file ends too early.`);
  return bytes;
}

function numbers(bytes: Uint8Array, dims: Volume["dims"], [width, read]: Reading, little: boolean, slope = 1, start = 0): Float32Array {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const values = new Float32Array(dims[0] * dims[1] * dims[2]);
  for (let k = 0; k < values.length; k++) values[k] = slope * read(view, k * width, little) + start;
  return values;
}

function needed(dims: number[], [width]: Reading): number {
  const n = width * dims.reduce((product, size) => product * size, 1);
  if (!(n <= MOST_BYTES)) throw new Error(TOO_LARGE);
  return n;
}

/** The lines of a header up to the one that `isLast`, and where the bytes after it begin. */
function linesOf(bytes: Uint8Array, isLast: (line: string) => boolean, format: string): { lines: string[]; end: number } {
  const [decoder, lines] = [new TextDecoder(), [] as string[]];
  for (let at = 0; lines.length < 100_000; ) {
    const end = bytes.indexOf(10, at);
    if (end < 0) break;
    const line = decoder.decode(bytes.subarray(at, end)).replace(/\r$/, "");
    at = end + 1;
    lines.push(line);
    if (isLast(line)) return { lines, end: at };
  }
  throw new Error(`This ${format} file ends within its header.`);
}

const words = (text: string | undefined): string[] => text?.trim().split(/\s+/).filter(Boolean) ?? [];
const reals = (text: string | undefined): number[] => words(text).map(Number);

/** The millimeters of a unit of length; 1 for other units. */
function millimeters(unit: string | undefined): number {
  const names: Record<string, number> = { nm: 1e-6, um: 1e-3, "µm": 1e-3, micron: 1e-3, microns: 1e-3, mm: 1, cm: 10, dm: 100, m: 1000, in: 25.4, ft: 304.8 };
  const long: Record<string, number> = { nano: 1e-6, micro: 1e-3, milli: 1, centi: 10, deci: 100, "": 1000 };
  const word = unit?.replace(/^["'\s]+|["'\s]+$/g, "").toLowerCase() ?? "";
  const prefix = /^(nano|micro|milli|centi|deci|)met(er|re)s?$/.exec(word)?.[1];
  return names[word] ?? (prefix === undefined ? 1 : long[prefix]!);
}

/** The three axes of space: all but those of one voxel. */
function axesOf(sizes: number[], format: string): [number, number, number] {
  const axes = sizes.map((_, axis) => axis);
  while (axes.length > 3) {
    const at = axes.map((axis) => sizes[axis]).lastIndexOf(1);
    if (at < 0) break;
    axes.splice(at, 1);
  }
  if (axes.length !== 3 || !sizes.every((size) => Number.isInteger(size) && size > 0)) throw new Error(`This ${format} file has not three dimensions: one volume is shown, without layers.`);
  return axes as [number, number, number];
}

const NRRD_KINDS: [RegExp, Reading][] = [
  [/^(signed char|int8(_t)?)$/, I8],
  [/^(uchar|unsigned char|uint8(_t)?)$/, U8],
  [/^((signed )?short( int)?|int16(_t)?)$/, I16],
  [/^(ushort|unsigned short( int)?|uint16(_t)?)$/, U16],
  [/^((signed )?int|int32(_t)?)$/, I32],
  [/^(uint|unsigned int|uint32(_t)?)$/, U32],
  [/^((signed )?long ?long( int)?|int64(_t)?)$/, I64],
  [/^(ulonglong|unsigned long long( int)?|uint64(_t)?)$/, U64],
  [/^float$/, F32],
  [/^double$/, F64],
];

async function readNrrd(bytes: Uint8Array<ArrayBuffer>): Promise<Volume> {
  const { lines, end } = linesOf(bytes, (line) => line === "", "NRRD");
  const fields = new Map(lines.slice(1).flatMap((line) => {
    const found = /^([^#:=]+):(?!=)\s*(.*)$/.exec(line);
    return found ? [[found[1]!.trim().toLowerCase().replace(/^(data|line|byte)(file|skip)$/, "$1 $2"), found[2]!.trim()] as const] : [];
  }));
  if (fields.has("data file")) throw new Error("The voxels of this NRRD header are in another file: header and voxels in one .nrrd file are shown.");
  const kind = NRRD_KINDS.find(([name]) => name.test(fields.get("type") ?? ""))?.[1];
  if (!kind) throw new Error("This NRRD file has voxels of a kind that is not shown: integers and real numbers are.");
  const sizes = reals(fields.get("sizes"));
  const axes = axesOf(sizes, "NRRD");
  const dims = axes.map((axis) => sizes[axis]!) as Volume["dims"];
  const n = needed(dims, kind);
  const encoding = fields.get("encoding")?.toLowerCase() ?? "";
  if (!["raw", "gzip", "gz"].includes(encoding)) throw new Error("This NRRD file has an encoding that is not shown: raw and gzip are.");
  let stored = bytes.subarray(end);
  for (let k = Number(fields.get("line skip") ?? 0); k > 0; k--) stored = stored.subarray(stored.indexOf(10) + 1);
  const skip = Number(fields.get("byte skip") ?? 0);
  const compression = encoding === "raw" ? null : stored[0] === 0x1f && stored[1] === 0x8b ? "gzip" : "deflate";
  // A negative number of bytes to skip counts from the end.
  const whole = await voxels(stored, skip < 0 ? n - skip - 1 : n + skip, compression, "NRRD", skip < 0);
  const raw = whole.subarray(skip < 0 ? whole.length - n + skip + 1 : skip);
  const vectors = [...(fields.get("space directions") ?? "").matchAll(/none|\(([^)]*)\)/g)].map((found) => found[1]?.split(",").map(Number));
  const spacings = reals(fields.get("spacings"));
  const column = (k: number): Vector3 => {
    const [axis, stated] = [axes[k]!, vectors[axes[k]!]];
    if (stated) return new Vector3(...(stated as [number, number, number]));
    const spacing = spacings[axis]!;
    return new Vector3().setComponent(k, spacing > 0 ? spacing : 1);
  };
  const made = new Matrix4().makeBasis(column(0), column(1), column(2));
  const origin = /\(([^)]*)\)/.exec(fields.get("space origin") ?? "")?.[1]?.split(",").map(Number);
  if (origin?.length === 3) made.setPosition(origin[0]!, origin[1]!, origin[2]!);
  const named = (field: string): string[] => [...(fields.get(field) ?? "").matchAll(/"([^"]*)"|(\S+)/g)].map((found) => found[1] ?? found[2]!);
  const units = vectors.length > 0 || !fields.has("units") ? named("space units") : axes.map((axis) => named("units")[axis] ?? "");
  const [x, y, z] = [0, 1, 2].map((k) => millimeters(units[k])) as [number, number, number];
  made.premultiply(new Matrix4().makeScale(x, y, z));
  const space = (fields.get("space") ?? "").toLowerCase();
  if (["left-posterior-superior", "lps"].includes(space)) made.premultiply(LPS);
  else if (["left-anterior-superior", "las"].includes(space)) made.premultiply(new Matrix4().makeScale(-1, 1, 1));
  return volumeOf(dims, numbers(raw, dims, kind, fields.get("endian")?.toLowerCase() !== "big"), made);
}

const META_KINDS: Record<string, Reading> = { MET_CHAR: I8, MET_UCHAR: U8, MET_SHORT: I16, MET_USHORT: U16, MET_INT: I32, MET_LONG: I32, MET_UINT: U32, MET_ULONG: U32, MET_LONG_LONG: I64, MET_ULONG_LONG: U64, MET_FLOAT: F32, MET_DOUBLE: F64 };

async function readMetaImage(bytes: Uint8Array<ArrayBuffer>): Promise<Volume> {
  const { lines, end } = linesOf(bytes, (line) => /^\s*ElementDataFile\s*[=:]/.test(line), "MetaImage");
  const fields = new Map(lines.map((line) => line.split(/[=:](.*)/s).map((part) => part.trim()) as [string, string]));
  if (fields.get("ElementDataFile")?.toUpperCase() !== "LOCAL") throw new Error("The voxels of this MetaImage header are in another file: header and voxels in one .mha file are shown.");
  const kind = META_KINDS[fields.get("ElementType") ?? ""];
  if (!kind || !["1", undefined].includes(fields.get("ElementNumberOfChannels")) || fields.get("BinaryData")?.toLowerCase() === "false") throw new Error("This MetaImage file has voxels of a kind that is not shown: binary integers and real numbers of one channel are.");
  const sizes = reals(fields.get("DimSize"));
  const axes = axesOf(sizes, "MetaImage");
  const dims = axes.map((axis) => sizes[axis]!) as Volume["dims"];
  const n = needed(dims, kind);
  const is = (...names: string[]): boolean => names.some((name) => fields.get(name)?.toLowerCase() === "true");
  const header = Number(fields.get("HeaderSize") ?? 0);
  const from = is("CompressedData") ? end : header < 0 ? Math.max(end, bytes.length - n) : Math.max(end, header);
  const raw = await voxels(bytes.subarray(from), n, is("CompressedData") ? "deflate" : null, "MetaImage");
  const first = (names: string[], count: number): number[] | undefined => names.map((name) => reals(fields.get(name))).find((list) => list.length === count);
  const turn = first(["TransformMatrix", "Rotation", "Orientation"], sizes.length ** 2);
  const spacing = first(["ElementSpacing", "ElementSize"], sizes.length);
  const offset = first(["Offset", "Position", "Origin"], sizes.length);
  const column = (k: number): Vector3 => {
    const direction = turn ? axes.map((axis) => turn[axes[k]! * sizes.length + axis]!) : [0, 1, 2].map((axis) => Number(axis === k));
    return new Vector3(...(direction as [number, number, number])).multiplyScalar(spacing?.[axes[k]!] ?? 1);
  };
  const made = new Matrix4().makeBasis(column(0), column(1), column(2));
  if (offset) made.setPosition(...(axes.map((axis) => offset[axis]!) as [number, number, number]));
  const unit = millimeters(fields.get("DistanceUnits"));
  made.premultiply(new Matrix4().makeScale(unit, unit, unit)).premultiply(LPS);
  const scale = (name: string, otherwise: number): number => (fields.has(name) ? Number(fields.get(name)) : otherwise);
  const [slope, start] = [scale("ElementToIntensityFunctionSlope", 1), scale("ElementToIntensityFunctionOffset", 0)];
  return volumeOf(dims, numbers(raw, dims, kind, !is("BinaryDataByteOrderMSB", "ElementByteOrderMSB"), slope, start), made);
}

const MGH_BYTES = 284;
const MGH_KINDS: Record<number, Reading> = { 0: U8, 1: I32, 3: F32, 4: I16, 10: U16 };

function isMgh(view: DataView): boolean {
  if (view.byteLength < 24) return false;
  const [version, ...counts] = Array.from({ length: 6 }, (_, k) => view.getInt32(4 * k)) as [number, ...number[]];
  const kind = counts.pop()!;
  return (version & 0xff) === 1 && version > 0 && version < 1 << 16 && counts.every((count) => count >= 1 && count <= 1 << 20) && kind >= 0 && kind <= 11;
}

async function readMgh(bytes: Uint8Array<ArrayBuffer>): Promise<Volume> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const kind = MGH_KINDS[view.getInt32(20)];
  if (!kind || view.getInt32(16) !== 1) throw new Error("This MGH file has voxels of a kind that is not shown: one frame of integers or real numbers is.");
  const dims = [4, 8, 12].map((at) => view.getInt32(at)) as Volume["dims"];
  const raw = (await voxels(bytes, MGH_BYTES + needed(dims, kind), null, "MGH")).subarray(MGH_BYTES);
  const isPlaced = view.getInt16(28) > 0;
  // Without the flag, FreeSurfer assumes coronal slices of 1 mm around the origin.
  const field = isPlaced ? Array.from({ length: 15 }, (_, k) => view.getFloat32(30 + 4 * k)) : [1, 1, 1, -1, 0, 0, 0, 0, -1, 0, 1, 0, 0, 0, 0];
  const column = (k: number): Vector3 => new Vector3(field[3 + 3 * k], field[4 + 3 * k], field[5 + 3 * k]).multiplyScalar(field[k]!);
  const made = new Matrix4().makeBasis(column(0), column(1), column(2));
  const middle = new Vector3(...dims).divideScalar(2).applyMatrix4(made);
  return volumeOf(dims, numbers(raw, dims, kind, false), made.setPosition(new Vector3(field[12], field[13], field[14]).sub(middle)));
}

/** The volume of a file, in the format that its bytes show. */
export async function readVolume(file: Blob): Promise<Volume> {
  const head = await bytesOf(await plain(file), Infinity, BEGINNING_BYTES);
  const text = new TextDecoder("latin1").decode(head.subarray(0, BEGINNING_BYTES));
  const whole = async () => bytesOf(await plain(file), 2 * MOST_BYTES);
  if (text.startsWith("NRRD000")) return readNrrd(await whole());
  if (/^\s*\w+\s*=/.test(text) && /^\s*(NDims|DimSize|ElementType)\s*[=:]/m.test(text)) return readMetaImage(await whole());
  if (text.slice(128, 132) === "DICM") throw new Error("DICOM files of yours are not shown: convert the series to NIfTI, for example with dcm2niix.");
  if (isMgh(new DataView(head.buffer, 0, head.length))) return readMgh(await whole());
  return readNifti(file);
}
