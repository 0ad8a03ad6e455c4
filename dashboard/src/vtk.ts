// Surfaces with values at their vertices, as the service writes legacy VTK files: version 5.1, binary.

import { BufferAttribute, BufferGeometry } from "three";

export interface Valued {
  geometry: BufferGeometry;
  arrays: Record<string, Float32Array>;
}

export function readVtk(bytes: ArrayBuffer): Valued {
  const view = new DataView(bytes);
  let at = 0;
  const line = (): string => {
    let text = "";
    while (at < view.byteLength) {
      const code = view.getUint8(at++);
      if (code === 10) break;
      text += String.fromCharCode(code);
    }
    return text;
  };
  /** The next line with words, as these. */
  const words = (): string[] => {
    for (;;) {
      const text = line().trim();
      if (text !== "" || at >= view.byteLength) return text.split(" ");
    }
  };
  const numbers = (n: number, kind: string | undefined): Float64Array => {
    const width = { double: 8, vtktypeint64: 8, float: 4, int: 4, unsigned_char: 1 }[kind ?? ""];
    if (width === undefined || at + n * width > view.byteLength) throw new Error("This VTK file cannot be read.");
    const read = (k: number): number => {
      const place = at + k * width;
      if (kind === "double") return view.getFloat64(place);
      if (kind === "float") return view.getFloat32(place);
      if (kind === "vtktypeint64") return Number(view.getBigInt64(place));
      return kind === "int" ? view.getInt32(place) : view.getUint8(place);
    };
    const values = Float64Array.from({ length: n }, (_, k) => read(k));
    at += n * width;
    return values;
  };
  const geometry = new BufferGeometry();
  const arrays: Record<string, Float32Array> = {};
  for (let k = 0; k < 4; k++) line();
  while (at < view.byteLength) {
    const [word, count, kind] = words();
    if (word === "POINTS") {
      geometry.setAttribute("position", new BufferAttribute(Float32Array.from(numbers(3 * Number(count), kind)), 3));
    } else if (word === "POLYGONS") {
      const offsets = numbers(Number(count), words()[1]);
      const corners = numbers(Number(kind), words()[1]);
      const triangles: number[] = [];
      for (let face = 0; face + 1 < offsets.length; face++) {
        for (let k = offsets[face]! + 1; k + 1 < offsets[face + 1]!; k++) triangles.push(corners[offsets[face]!]!, corners[k]!, corners[k + 1]!);
      }
      geometry.setIndex(new BufferAttribute(Uint32Array.from(triangles), 1));
    } else if (word === "FIELD") {
      for (let k = 0; k < Number(kind); k++) {
        const [name, components, n, type] = words();
        arrays[name!] = Float32Array.from(numbers(Number(components) * Number(n), type));
      }
    }
  }
  geometry.computeVertexNormals();
  geometry.computeBoundingSphere();
  return { geometry, arrays };
}
