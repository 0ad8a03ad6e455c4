// Colors that people with a color vision deficiency can tell apart: viridis and cividis along a scale, blue and red around zero, and
// the categories of Okabe and Ito.

import { interpolateCividis, interpolateRdBu, interpolateViridis } from "d3-scale-chromatic";

export type Rgb = [number, number, number];
export type MapName = "viridis" | "cividis" | "blue_red";

function parse(text: string): Rgb {
  const hex = /^#(..)(..)(..)$/.exec(text);
  const parts = hex ? hex.slice(1).map((part) => parseInt(part, 16)) : (text.match(/[\d.]+/g) ?? []).map(Number);
  return [parts[0] ?? 0, parts[1] ?? 0, parts[2] ?? 0];
}

export const STEPS = 256;

/** The map at equal steps, red, green, blue and opacity. */
export function colorMap(name: MapName): Uint8Array {
  const at = { viridis: interpolateViridis, cividis: interpolateCividis, blue_red: (share: number) => interpolateRdBu(1 - share) }[name];
  const bytes = new Uint8Array(4 * STEPS);
  for (let k = 0; k < STEPS; k++) bytes.set([...parse(at(k / (STEPS - 1))), 255], 4 * k);
  return bytes;
}

/** Why a vertex is an outlier, by the number of the column `outlier`. */
export const OUTLIERS: { name: string; color: Rgb }[] = [
  { name: "no outlier", color: [208, 212, 218] },
  { name: "too far away after registration", color: [230, 159, 0] },
  { name: "its neighbors map elsewhere", color: [0, 114, 178] },
  { name: "both", color: [213, 94, 0] },
  { name: "the target has nothing there", color: [86, 60, 92] },
];

/** The categories as a map, each at the middle of its share. */
export function outlierMap(): Uint8Array {
  const bytes = new Uint8Array(4 * STEPS);
  for (let k = 0; k < STEPS; k++) {
    const entry = OUTLIERS[Math.min(OUTLIERS.length - 1, Math.floor((k / STEPS) * OUTLIERS.length))];
    bytes.set([...(entry?.color ?? [0, 0, 0]), 255], 4 * k);
  }
  return bytes;
}

export const css = ([r, g, b]: Rgb): string => `rgb(${r}, ${g}, ${b})`;

/** Where category `k` lies on the scale of [`outlierMap`]. */
export const ofCategory = (k: number): number => (k + 0.5) / OUTLIERS.length;
