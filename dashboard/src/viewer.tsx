// The picture of a match, with what can be chosen about it.

import type { Vector3 } from "three";
import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import { type Job, download, save } from "./api";
import { OUTLIERS, css, type MapName, colorMap, STEPS } from "./colors";
import { mm, number, words } from "./format";
import { type Pair, quantile } from "./pair";
import { Check, useShownTheme } from "./parts";
import { type Coloring, type Look, PairScene, type Picked } from "./scene";

const COLORINGS: { name: Coloring; label: string; help: string; unit: string }[] = [
  {
    name: "correspondence",
    label: "Correspondence",
    help: "The target is colored along its length, with a grid; each source vertex has the color and the grid of its corresponding point. Where colors jump or the grid breaks, the match is wrong.",
    unit: "",
  },
  { name: "confidence", label: "Confidence", help: "Probability that the corresponding point is right to within one edge of the target.", unit: "" },
  { name: "residual", label: "Residual", help: "Distance of each vertex, moved rigidly, from its corresponding point: how far the rest of the match has to bend the source.", unit: "mm" },
  { name: "displacement", label: "Displacement", help: "The part of it along the outward normal: the target lies inside of the source where it is negative (dark), outside where it is positive (light).", unit: "mm" },
  { name: "spread", label: "Spread", help: "Expected error of the corresponding point.", unit: "mm" },
  { name: "outlier", label: "Outliers", help: "Vertices that do not follow the transform or their neighbors, and why.", unit: "" },
];

function Scale({ map, low, high, label }: { map: MapName; low: string; high: string; label: string }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    const context = canvas.current?.getContext("2d");
    context?.putImageData(new ImageData(new Uint8ClampedArray(colorMap(map)), STEPS, 1), 0, 0);
  }, [map]);
  return (
    <div class="scale">
      <span>{low}</span>
      <canvas ref={canvas} width={STEPS} height={1} role="img" aria-label={label} />
      <span>{high}</span>
    </div>
  );
}

interface ViewerProps {
  job: Job;
  pair: Pair;
  /** The crosshair of the slices, in the space of the target. */
  cross: Vector3 | null;
  setCross: (point: Vector3) => void;
}

export function Viewer({ job, pair, cross, setCross }: ViewerProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const scene = useRef<PairScene | null>(null);
  const [failure, setFailure] = useState<string | null>(null);
  const [picked, setPicked] = useState<Picked | null>(null);
  const [look, setLook] = useState<Look>({
    coloring: "correspondence",
    map: "viridis",
    top: 1,
    grid: true,
    overlay: false,
    pose: 1,
    lines: false,
    section: null,
    opacity: 0.6,
  });
  const tops = useMemo(() => {
    const top = (name: "residual" | "displacement" | "spread") => quantile(pair.columns[name].map(Math.abs), 0.95) || 1;
    return { correspondence: 1, confidence: 1, outlier: 1, residual: top("residual"), displacement: top("displacement"), spread: top("spread") };
  }, [pair]);
  const change = (part: Partial<Look>) =>
    setLook((before) => {
      const after = { ...before, ...part };
      return { ...after, top: tops[after.coloring] };
    });

  useEffect(() => {
    let made: PairScene;
    try {
      made = new PairScene(canvas.current!, pair, look);
    } catch {
      setFailure("This browser cannot draw in 3D (WebGL 2 is not available). The surfaces can be saved below and opened in another program.");
      return;
    }
    scene.current = made;
    (canvas.current as HTMLCanvasElement & { scene?: PairScene }).scene = made; // what the tests ask
    return () => {
      made.dispose();
      scene.current = null;
    };
  }, [pair]);
  useEffect(() => scene.current?.set(look), [look, pair]);
  useEffect(() => scene.current?.cross(cross), [cross, pair]);
  const theme = useShownTheme();
  useEffect(() => scene.current?.redraw(), [theme]);

  const hover = (event: PointerEvent) => {
    if (event.buttons !== 0) return;
    const found = scene.current?.pick(event.offsetX, event.offsetY) ?? null;
    scene.current?.mark(found);
    setPicked(found);
  };
  // A press that turns nothing puts the crosshair there.
  const pressed = useRef<[number, number]>([0, 0]);
  const release = (event: PointerEvent) => {
    const [x, y] = pressed.current;
    if (event.button !== 0 || Math.hypot(event.clientX - x, event.clientY - y) > 3) return;
    const found = scene.current?.pick(event.offsetX, event.offsetY);
    if (found) setCross(scene.current!.placeOf(found));
  };
  const leave = () => {
    scene.current?.mark(null);
    setPicked(null);
  };
  const keys = (event: KeyboardEvent) => {
    const turns: Record<string, [number, number]> = { ArrowLeft: [-0.12, 0], ArrowRight: [0.12, 0], ArrowUp: [0, -0.12], ArrowDown: [0, 0.12] };
    const turn = turns[event.key];
    if (turn) scene.current?.turn(...turn);
    else if (event.key === "+" || event.key === "=") scene.current?.zoom(1.2);
    else if (event.key === "-") scene.current?.zoom(1 / 1.2);
    else if (event.key === "Home") scene.current?.view();
    else return;
    event.preventDefault();
  };
  const coloring = COLORINGS.find(({ name }) => name === look.coloring)!;
  const columns = pair.columns;

  return (
    <section class="viewer" aria-label="The match in 3D">
      <div class="tools">
        <label>
          Color{" "}
          <select value={look.coloring} onChange={(e) => change({ coloring: e.currentTarget.value as Coloring })}>
            {COLORINGS.map(({ name, label }) => (
              <option value={name}>{label}</option>
            ))}
          </select>
        </label>
        <label>
          Map{" "}
          <select value={look.map} onChange={(e) => change({ map: e.currentTarget.value as Look["map"] })}>
            <option value="viridis">viridis</option>
            <option value="cividis">cividis</option>
          </select>
        </label>
        <div class="choice" role="group" aria-label="Arrangement">
          <button aria-pressed={!look.overlay} onClick={() => change({ overlay: false })}>
            Side by side
          </button>
          <button aria-pressed={look.overlay} onClick={() => change({ overlay: true })}>
            Overlaid
          </button>
        </div>
        <label class="slider">
          Pose: original{" "}
          <input type="range" min={0} max={1} step={0.01} value={look.pose} aria-label="Pose, from original to aligned" onInput={(e) => change({ pose: Number(e.currentTarget.value) })} /> aligned
        </label>
        {look.overlay && (
          <label class="slider">
            Source{" "}
            <input type="range" min={0.15} max={1} step={0.05} value={look.opacity} aria-label="Opacity of the source" onInput={(e) => change({ opacity: Number(e.currentTarget.value) })} />
          </label>
        )}
        {look.coloring === "correspondence" && <Check label="Grid" checked={look.grid} onChange={(e) => change({ grid: e.currentTarget.checked })} />}
        <Check label="Inlier lines" checked={look.lines} onChange={(e) => change({ lines: e.currentTarget.checked })} />
        <Check label="Section" checked={look.section !== null} onChange={(e) => change({ section: e.currentTarget.checked ? 0.4 : null })} />
        {look.section !== null && (
          <input type="range" min={0.02} max={0.98} step={0.01} value={look.section} aria-label="Depth of the section" onInput={(e) => change({ section: Number(e.currentTarget.value) })} />
        )}
        <span class="group">
        <button onClick={() => scene.current?.view()}>Reset view</button>
        <button onClick={async () => {
          const blob = await scene.current?.picture();
          if (blob) save(blob, `match-${job.id}.png`);
        }}>
          Save picture
        </button>
        </span>
      </div>
      {failure !== null && <p class="failure">{failure}</p>}
      <div class="stage">
        {!look.overlay && (
          <>
            <span class="caption first">Source{look.pose === 1 ? ", aligned" : look.pose === 0 ? ", original pose" : ""}</span>
            <span class="caption second">Target</span>
          </>
        )}
        <canvas
          ref={canvas}
          id="view"
          tabIndex={0}
          role="img"
          aria-label="Source and target surface. Arrow keys turn, plus and minus zoom, Home resets the view."
          onPointerMove={hover}
          onPointerDown={(e) => (pressed.current = [e.clientX, e.clientY])}
          onPointerUp={release}
          onPointerLeave={leave}
          onKeyDown={keys}
        />
        <output class="readout" aria-live="off">
          {picked === null ? (
            <span class="hint">Point at a vertex to see its correspondent. Drag to turn, scroll to zoom, right button to move.</span>
          ) : picked.side === "source" ? (
            <>
              <b>source vertex {picked.vertex}</b> → {picked.others[0]! < 0 ? "no counterpart" : `target vertex ${picked.others[0]}`} · confidence {number(columns.confidence[picked.vertex], 2)} · spread{" "}
              {mm(columns.spread[picked.vertex])} · residual {mm(columns.residual[picked.vertex])} · {OUTLIERS[Math.floor(columns.outlier[picked.vertex]! * OUTLIERS.length)]?.name}
            </>
          ) : (
            <>
              <b>target vertex {picked.vertex}</b> ← {picked.others.length === 0 ? "no source vertex has it as its nearest" : `${picked.others.length} source ${picked.others.length === 1 ? "vertex" : "vertices"}: ${picked.others.slice(0, 6).join(", ")}${picked.others.length > 6 ? " …" : ""}`}
              {picked.spread_mm > 0 && ` · spread ${mm(picked.spread_mm)}`}
            </>
          )}
        </output>
      </div>
      <div class="legend">
        {look.coloring === "outlier" ? (
          <ul class="categories">
            {OUTLIERS.map(({ name, color }, k) => {
              const n = columns.outlier.reduce((sum, value) => sum + (Math.floor(value * OUTLIERS.length) === k ? 1 : 0), 0);
              return (
                <li>
                  <svg width="12" height="12" aria-hidden="true">
                    <rect width="12" height="12" fill={css(color)} />
                  </svg>{" "}
                  {name}: {n.toLocaleString("en")}
                </li>
              );
            })}
          </ul>
        ) : (
          <Scale
            map={look.map}
            low={look.coloring === "correspondence" ? "one end of the target" : look.coloring === "displacement" ? `≤ −${number(look.top, 2)} mm` : `0 ${coloring.unit}`}
            high={look.coloring === "correspondence" ? "the other end" : `${look.coloring === "confidence" ? "" : "≥ "}${number(look.top, 2)} ${coloring.unit}`}
            label={`Scale of ${words(look.coloring)}`}
          />
        )}
        <p>{coloring.help} Gray: no counterpart.</p>
      </div>
    </section>
  );
}

const SAVES: [string, string, string][] = [
  ["Correspondences, CSV", "correspondences?format=csv", "correspondences.csv"],
  ["Aligned source, PLY", "aligned?format=ply", "aligned.ply"],
  ["Bent source, PLY", "warped?format=ply", "warped.ply"],
  ["Bent source, GIFTI", "warped?format=gifti", "warped.surf.gii"],
  ["Bent source, VTP", "warped?format=vtp", "warped.vtp"],
  ["Target surface, PLY", "surfaces/target?format=ply", "target.ply"],
  ["Both surfaces in color, glTF", "correspondences?format=glb", "match.glb"],
  ["Transform, ITK", "transform?format=tfm", "transform.tfm"],
  ["Transform, FreeSurfer", "transform?format=lta", "transform.lta"],
  ["Result, JSON", "result", "result.json"],
  ["Report, HTML", "report?format=html", "report.html"],
];

export function Saves({ job, failed }: { job: Job; failed: (error: unknown) => void }) {
  return (
    <div class="saves">
      {SAVES.map(([label, path, name]) => (
        <button onClick={() => download(`v1/jobs/${job.id}/${path}`, name).catch(failed)}>{label}</button>
      ))}
    </div>
  );
}
