// Slices of a volume with the outlines of both surfaces, and one crosshair for them and for the picture in 3D.

import { Box3, type BufferGeometry, Matrix4, Vector3 } from "three";
import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import { ApiError, type Job, call, describe } from "./api";
import { number } from "./format";
import { type Volume, valueAt } from "./nifti";
import type { Pair } from "./pair";
import { Check, Failure, useShownTheme, useWork } from "./parts";
import { readVolume } from "./volumes";

/** A plane of RAS: the axis across it, and those to the right and upwards. */
interface Plane {
  name: string;
  across: 0 | 1 | 2;
  right: 0 | 1 | 2;
  up: 0 | 1 | 2;
}

const PLANES: Plane[] = [
  { name: "Sagittal", across: 0, right: 1, up: 2 },
  { name: "Coronal", across: 1, right: 0, up: 2 },
  { name: "Axial", across: 2, right: 0, up: 1 },
];
/** What lies at the ends of each axis. */
const ENDS = ["LR", "PA", "IS"];
/** As Okabe and Ito have them, which can be told apart on black and on white. */
export const OUTLINES = { target: "#e69f00", source: "#56b4e9" };
/** How much around the surfaces is shown, mm. */
const MARGIN_MM = 10;
/** A volume of at most this size is loaded without being asked for. */
const SMALL_BYTES = 8 << 20;

/** Where a plane is on its canvas: the left lower corner, mm, and the pixels of one mm. */
interface Fit {
  left: number;
  low: number;
  scale: number;
}

function fitted(plane: Plane, box: Box3, width: number, height: number): Fit {
  const [min, max] = [box.min.toArray(), box.max.toArray()];
  const [w, h] = [max[plane.right]! - min[plane.right]!, max[plane.up]! - min[plane.up]!];
  const scale = Math.min(width / w, height / h);
  return { left: (min[plane.right]! + max[plane.right]!) / 2 - width / 2 / scale, low: (min[plane.up]! + max[plane.up]!) / 2 - height / 2 / scale, scale };
}

/** The voxels of a plane: each pixel has the value of the voxel in which it lies, and nothing outside. */
function imageOf(volume: Volume, voxelFromWorld: Matrix4, plane: Plane, at: number, fit: Fit, width: number, height: number): ImageData {
  const image = new ImageData(width, height);
  const place = (x: number, y: number) => {
    const world = [0, 0, 0];
    world[plane.across] = at;
    world[plane.right] = fit.left + (x + 0.5) / fit.scale;
    world[plane.up] = fit.low + (height - y - 0.5) / fit.scale;
    return new Vector3(...(world as [number, number, number])).applyMatrix4(voxelFromWorld);
  };
  const start = place(0, 0);
  const [stepX, stepY] = [place(1, 0).sub(start), place(0, 1).sub(start)];
  const [nx, ny, nz] = volume.dims;
  const factor = 255 / (volume.high - volume.low);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const i = Math.round(start.x + x * stepX.x + y * stepY.x);
      const j = Math.round(start.y + x * stepX.y + y * stepY.y);
      const k = Math.round(start.z + x * stepX.z + y * stepY.z);
      if (i < 0 || j < 0 || k < 0 || i >= nx || j >= ny || k >= nz) continue;
      const shade = Math.max(0, Math.min(255, (volume.values[i + nx * (j + ny * k)]! - volume.low) * factor));
      const pixel = 4 * (y * width + x);
      image.data[pixel] = image.data[pixel + 1] = image.data[pixel + 2] = shade;
      image.data[pixel + 3] = 255;
    }
  }
  return image;
}

/** The line in which a plane cuts a surface. */
function outline(context: CanvasRenderingContext2D, positions: ArrayLike<number>, index: ArrayLike<number>, plane: Plane, at: number, onCanvas: (right: number, up: number) => [number, number]): void {
  context.beginPath();
  for (let t = 0; t < index.length; t += 3) {
    const ends: [number, number][] = [];
    for (let k = 0; k < 3; k++) {
      const [a, b] = [3 * index[t + k]!, 3 * index[t + ((k + 1) % 3)]!];
      const [from, to] = [positions[a + plane.across]! - at, positions[b + plane.across]! - at];
      if (from < 0 === to < 0) continue;
      const share = from / (from - to);
      const mix = (axis: number) => positions[a + axis]! + share * (positions[b + axis]! - positions[a + axis]!);
      ends.push(onCanvas(mix(plane.right), mix(plane.up)));
    }
    if (ends.length === 2) {
      context.moveTo(...ends[0]!);
      context.lineTo(...ends[1]!);
    }
  }
  context.stroke();
}

interface Outlined {
  positions: ArrayLike<number>;
  index: ArrayLike<number>;
  color: string;
}

interface SliceProps {
  plane: Plane;
  volume: Volume;
  voxelFromWorld: Matrix4;
  box: Box3;
  outlines: Outlined[];
  point: Vector3;
  /** The side of a voxel, mm: how far a key moves the crosshair. */
  step: number;
  move: (point: Vector3) => void;
}

function Slice({ plane, volume, voxelFromWorld, box, outlines, point, step, move }: SliceProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const [size, setSize] = useState(0);
  const theme = useShownTheme();
  const at = point.getComponent(plane.across);
  const [right, up] = [point.getComponent(plane.right), point.getComponent(plane.up)];
  useEffect(() => {
    const sizes = new ResizeObserver(() => setSize(canvas.current?.clientWidth ?? 0));
    sizes.observe(canvas.current!);
    return () => sizes.disconnect();
  }, []);
  const fit = useMemo(() => (size > 0 ? fitted(plane, box, size, size) : null), [plane, box, size]);
  const image = useMemo(() => fit && imageOf(volume, voxelFromWorld, plane, at, fit, size, size), [volume, plane, at, fit]);
  useEffect(() => {
    if (!fit || !image) return;
    const element = canvas.current as HTMLCanvasElement & { project?: (place: number[]) => [number, number] };
    const ratio = Math.min(2, devicePixelRatio);
    element.width = element.height = size * ratio;
    const context = element.getContext("2d")!;
    context.scale(ratio, ratio);
    const still = document.createElement("canvas");
    still.width = still.height = size;
    still.getContext("2d")!.putImageData(image, 0, 0);
    context.imageSmoothingEnabled = false;
    context.drawImage(still, 0, 0, size, size);
    const onCanvas = (x: number, y: number): [number, number] => [(x - fit.left) * fit.scale, size - (y - fit.low) * fit.scale];
    element.project = (place) => onCanvas(place[plane.right]!, place[plane.up]!); // what the tests ask
    context.lineWidth = 2;
    for (const { positions, index, color } of outlines) {
      context.strokeStyle = color;
      outline(context, positions, index, plane, at, onCanvas);
    }
    const [x, y] = onCanvas(right, up);
    context.strokeStyle = "#ff2d95";
    context.lineWidth = 1;
    context.beginPath();
    // The middle stays free, so that what is there is seen.
    for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1]] as const) {
      context.moveTo(x + 6 * dx, y + 6 * dy);
      context.lineTo(x + 2 * size * dx, y + 2 * size * dy);
    }
    context.stroke();
    context.font = "600 13px system-ui, sans-serif";
    context.textBaseline = "middle";
    const [left, rightEnd, low, high] = [...ENDS[plane.right]!, ...ENDS[plane.up]!] as [string, string, string, string];
    for (const [text, px, py] of [[left, 12, size / 2], [rightEnd, size - 12, size / 2], [high, size / 2, 12], [low, size / 2, size - 12]] as const) {
      context.textAlign = "center";
      context.lineWidth = 3;
      context.strokeStyle = "#000000";
      context.strokeText(text, px, py);
      context.fillStyle = "#ffffff";
      context.fillText(text, px, py);
    }
  }, [image, outlines, right, up, theme]);
  const moved = (change: Partial<Record<"across" | "right" | "up", number>>) => {
    const next = point.clone();
    for (const name of ["across", "right", "up"] as const) if (change[name] !== undefined) next.setComponent(plane[name], change[name]);
    move(next);
  };
  const press = (event: PointerEvent) => {
    if (event.buttons !== 1 || !fit) return;
    const area = canvas.current!.getBoundingClientRect();
    moved({ right: fit.left + (event.clientX - area.left) / fit.scale, up: fit.low + (area.height - (event.clientY - area.top)) / fit.scale });
  };
  const keys = (event: KeyboardEvent) => {
    const by: Record<string, Parameters<typeof moved>[0]> = {
      ArrowLeft: { right: right - step },
      ArrowRight: { right: right + step },
      ArrowUp: { up: up + step },
      ArrowDown: { up: up - step },
      PageUp: { across: at + step },
      PageDown: { across: at - step },
    };
    const change = by[event.key];
    if (!change) return;
    event.preventDefault();
    moved(change);
  };
  return (
    <figure class="slice">
      <canvas
        ref={canvas}
        tabIndex={0}
        role="img"
        aria-label={`${plane.name} slice with the outlines of both surfaces. Arrow keys move the crosshair, Page Up and Page Down go to other slices.`}
        data-plane={plane.name}
        onPointerDown={(e) => {
          canvas.current!.setPointerCapture(e.pointerId);
          press(e);
        }}
        onPointerMove={press}
        onWheel={(e) => {
          e.preventDefault();
          moved({ across: at - Math.sign(e.deltaY) * step });
        }}
        onKeyDown={keys}
      />
      <figcaption>{plane.name}</figcaption>
    </figure>
  );
}

type Which = "target" | "source" | "own";

interface SlicesProps {
  job: Job;
  pair: Pair;
  /** The crosshair, in the space of the target. */
  cross: Vector3 | null;
  setCross: (point: Vector3) => void;
}

// Only volumes have a size of voxels.
const isVolume = (input: Job["source"]): boolean => Boolean(input.report.sampling);

export function Slices({ job, pair, cross, setCross }: SlicesProps) {
  const offered = (["target", "source"] as const).filter((side) => isVolume(job[side]));
  const [which, setWhich] = useState<Which | null>(offered.find((side) => job[side].n_bytes <= SMALL_BYTES) ?? null);
  const [own, setOwn] = useState<File | null>(null);
  const [volume, setVolume] = useState<Volume | null>(null);
  const [isWhole, setWhole] = useState(false);
  const [failure, setFailure] = useState<string | null>(null);
  useWork(
    (signal) => {
      setVolume(null);
      setFailure(null);
      if (which === null || (which === "own" && own === null)) return;
      const bytes = which === "own" ? Promise.resolve<Blob>(own!) : call(`v1/jobs/${job.id}/volumes/${which}`, { signal }).then((answer) => answer.blob());
      bytes.then(readVolume).then(
        (read) => !signal.aborted && setVolume(read),
        (error: unknown) => {
          if (signal.aborted) return;
          setFailure(error instanceof ApiError ? describe(error) : error instanceof Error ? error.message : String(error));
        },
      );
    },
    [which, own],
  );
  // What is drawn lies in the space of the volume: that of the source, or else of the target.
  const worldFromTarget = useMemo(() => (which === "source" ? pair.targetFromSource.clone().invert() : new Matrix4()), [which, pair]);
  const outlines = useMemo((): Outlined[] => {
    const moved = (geometry: BufferGeometry, by: Matrix4, color: string): Outlined => {
      const position = geometry.getAttribute("position");
      const positions = new Float32Array(3 * position.count);
      const p = new Vector3();
      for (let v = 0; v < position.count; v++) p.fromBufferAttribute(position, v).applyMatrix4(by).toArray(positions, 3 * v);
      return { positions, index: geometry.getIndex()!.array, color };
    };
    const worldFromSource = worldFromTarget.clone().multiply(pair.targetFromSource);
    return [moved(pair.target, worldFromTarget, OUTLINES.target), moved(pair.source, worldFromSource, OUTLINES.source)];
  }, [worldFromTarget, pair]);
  const voxelFromWorld = useMemo(() => volume?.worldFromVoxel.clone().invert() ?? new Matrix4(), [volume]);
  const box = useMemo(() => {
    const around = new Box3();
    if (isWhole && volume) {
      for (let k = 0; k < 8; k++) around.expandByPoint(new Vector3(...(volume.dims.map((n, axis) => ((k >> axis) & 1 ? n - 0.5 : -0.5)) as [number, number, number])).applyMatrix4(volume.worldFromVoxel));
      return around;
    }
    for (const { positions } of outlines) around.union(new Box3().setFromArray(positions as Float32Array));
    return around.expandByScalar(MARGIN_MM);
  }, [outlines, isWhole, volume]);
  const step = useMemo(() => {
    const sides = [0, 1, 2].map((k) => new Vector3().setFromMatrixColumn(volume?.worldFromVoxel ?? new Matrix4(), k).length());
    return Math.min(...sides) || 1;
  }, [volume]);
  const point = (cross ?? pair.frame.center).clone().applyMatrix4(worldFromTarget);
  const found = volume && valueAt(volume, voxelFromWorld, point);
  const space = job.target.report.space;
  return (
    <section class="card section" aria-label="Slices">
      <h2>Slices of a volume</h2>
      <div class="tools">
        {offered.map((side) => (
          <label class="check">
            <input type="radio" name="volume" checked={which === side} onChange={() => setWhich(side)} /> the {side}'s label volume
          </label>
        ))}
        <label class="button">
          {own === null ? "A file of yours …" : own.name}
          <input
            class="quiet"
            type="file"
            aria-label="A volume of yours: NIfTI, NRRD, MetaImage or MGH"
            onChange={(e) => {
              const file = e.currentTarget.files?.[0];
              if (!file) return;
              setOwn(file);
              setWhich("own");
            }}
          />
        </label>
        {volume && <Check label="Whole volume" checked={isWhole} onChange={(e) => setWhole(e.currentTarget.checked)} />}
        <ul class="categories">
          {(["target", "source"] as const).map((side) => (
            <li>
              <svg width="16" height="12" aria-hidden="true">
                <rect y="4" width="16" height="4" fill={OUTLINES[side]} />
              </svg>{" "}
              {side}
              {side === "source" && ", aligned"}
            </li>
          ))}
        </ul>
      </div>
      <Failure text={failure} />
      {which === null && <p class="hint">A volume in the space of the target (NIfTI, NRRD, MetaImage, MGH), such as the image that it was segmented from, is shown under both surfaces. The file stays in this browser.</p>}
      {which === "own" && space !== "scanner_ras" && volume && <p class="hint">The target's file declares {space === undefined || space === "unknown" ? "no space" : `the space ${space.replaceAll("_", " ")}`}: the volume fits only if its coordinates are the same.</p>}
      {which !== null && volume === null && failure === null && <p class="loading">Loading the volume …</p>}
      {volume && (
        <>
          <div class="slices">
            {PLANES.map((plane) => (
              <Slice key={plane.name} plane={plane} volume={volume} voxelFromWorld={voxelFromWorld} box={box} outlines={outlines} point={point} step={step} move={(next) => setCross(next.applyMatrix4(worldFromTarget.clone().invert()))} />
            ))}
          </div>
          <output class="readout" aria-live="off" id="crosshair">
            R {point.x.toFixed(1)}, A {point.y.toFixed(1)}, S {point.z.toFixed(1)} mm · {found ? `voxel ${found.voxel.join(", ")} · value ${number(found.value)}` : "outside of the volume"}
            <span class="hint"> · Press on a slice, or on a surface above, to move the crosshair; scroll for other slices.</span>
          </output>
        </>
      )}
    </section>
  );
}
