// What a study found, on the mean surface in 3D: maps of contrasts, and the modes of the shape model.

import { type BufferGeometry, Vector3 } from "three";
import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import { type StudyResult, describe, save } from "./api";
import { ColorBar } from "./colorbar";
import type { MapName } from "./colors";
import { number, words } from "./format";
import { quantile } from "./pair";
import { Check, Failure, useShownTheme, useWork } from "./parts";
import { type Coloring, SurfaceScene } from "./surface";
import { readVtk } from "./vtk";
import type { Archive } from "./zip";

interface SurfaceProps {
  geometry: BufferGeometry;
  coloring: Coloring | null;
  /** Where the vertices are now, if not where they were. */
  positions?: Float32Array;
  label: string;
  id: string;
  file: string;
  readout: (vertex: number) => string;
}

/** A surface to turn, and the value under the pointer. */
function Surface({ geometry, coloring, positions, label, id, file, readout }: SurfaceProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const scene = useRef<SurfaceScene | null>(null);
  const [failure, setFailure] = useState<string | null>(null);
  const [picked, setPicked] = useState<number | null>(null);
  const theme = useShownTheme();
  useEffect(() => {
    try {
      scene.current = new SurfaceScene(canvas.current!, geometry.clone());
    } catch {
      setFailure("This browser cannot draw in 3D (WebGL 2 is not available). The maps are in the archive.");
      return;
    }
    (canvas.current as HTMLCanvasElement & { scene?: SurfaceScene }).scene = scene.current; // what the tests ask
    return () => {
      scene.current?.dispose();
      scene.current = null;
    };
  }, [geometry]);
  useEffect(() => void (coloring && scene.current?.color(coloring)), [geometry, coloring]);
  useEffect(() => void (positions && scene.current?.move(positions)), [geometry, positions]);
  useEffect(() => scene.current?.redraw(), [theme]);
  const hover = (event: PointerEvent) => {
    if (event.buttons !== 0) return;
    setPicked(scene.current?.pick(event.offsetX, event.offsetY) ?? null);
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
  return (
    <>
      <Failure text={failure} />
      <div class="stage half">
        <canvas ref={canvas} id={id} tabIndex={0} role="img" aria-label={`${label}. Arrow keys turn, plus and minus zoom, Home resets the view.`} onPointerMove={hover} onPointerLeave={() => setPicked(null)} onKeyDown={keys} />
      </div>
      <output class="readout" aria-live="off">
        {picked === null ? <span class="hint">Point at a vertex for its values. Drag to turn, scroll to zoom.</span> : readout(picked)}
      </output>
      <div class="tools">
        <button onClick={() => scene.current?.view()}>Reset view</button>
        <button
          onClick={async () => {
            const blob = await scene.current?.picture();
            if (blob) save(blob, file);
          }}
        >
          Save picture
        </button>
      </div>
    </>
  );
}

const MEASURES: Record<string, { title: string; unit: string }> = {
  normal_displacement: { title: "normal displacement", unit: "mm" },
  log_area: { title: "logarithm of area", unit: "ln" },
  thickness: { title: "thickness", unit: "mm" },
};

/** What a map file has at every vertex, in the order in which it is offered. */
const QUANTITIES: { name: string; title: string; kind: "effect" | "signed" | "p" }[] = [
  { name: "effect", title: "effect", kind: "effect" },
  { name: "hedges_g", title: "Hedges' g", kind: "signed" },
  { name: "t", title: "t", kind: "signed" },
  { name: "z", title: "z", kind: "signed" },
  { name: "p_local", title: "p, local (TFCE and false discovery rate)", kind: "p" },
  { name: "p_tfce_fwe", title: "p, corrected (TFCE, family-wise)", kind: "p" },
  { name: "p_permutation", title: "p, uncorrected (permutations)", kind: "p" },
  { name: "p", title: "p, uncorrected", kind: "p" },
  { name: "q_fdr", title: "q (false discovery rate)", kind: "p" },
];
/** The least p of the scale, as a power of ten. */
const LEAST_P = 3;

const signedTicks = (top: number): string[] => [-1, -0.5, 0, 0.5, 1].map((k) => (k === 0 ? "0" : `${k === -1 ? "≤ " : k === 1 ? "≥ " : ""}${k < 0 ? "−" : ""}${number(Math.abs(k) * top, 2)}`));

/** The largest values that few vertices exceed: the ends of a scale around zero. */
const topOf = (values: Float32Array): number => quantile(values.map(Math.abs), 0.99) || 1e-6;

export function Maps({ archive, result, name }: { archive: Archive; result: StudyResult; name: string }) {
  const maps = result.found.maps.filter(({ measure, contrast }) => archive.has(`maps/${measure}.${contrast}.vtk`));
  const contrasts = [...new Set(maps.map(({ contrast }) => contrast))];
  const [contrast, setContrast] = useState(contrasts[0] ?? "");
  const [measure, setMeasure] = useState(maps[0]?.measure ?? "");
  const [quantity, setQuantity] = useState("effect");
  const [only, setOnly] = useState(false);
  const [loaded, setLoaded] = useState<{ file: string; geometry: BufferGeometry; arrays: Record<string, Float32Array> } | null>(null);
  const [failure, setFailure] = useState<string | null>(null);
  const file = `maps/${measure}.${contrast}.vtk`;
  useWork(
    (signal) => {
      if (!archive.has(file)) return;
      archive.bytes(file).then(
        (bytes) => {
          if (signal.aborted) return;
          const { geometry, arrays } = readVtk(bytes);
          // All maps are on the same surface, so that the view stays.
          setLoaded((before) => ({ file, geometry: before?.geometry ?? geometry, arrays }));
        },
        (error: unknown) => !signal.aborted && setFailure(describe(error)),
      );
    },
    [archive, file],
  );
  const arrays = loaded?.arrays;
  const offered = QUANTITIES.filter(({ name }) => arrays === undefined || name in arrays);
  const shown = offered.find(({ name }) => name === quantity) ?? offered[0]!;
  // Archives of earlier versions have no local p.
  const local = arrays?.p_local ?? arrays?.p_tfce_fwe ?? arrays?.q_fdr;
  const { title, unit } = MEASURES[measure] ?? { title: words(measure), unit: "" };
  const view = useMemo((): { coloring: Coloring; ticks: string[]; map: MapName } | null => {
    const values = arrays?.[shown.name];
    if (values === undefined) return null;
    const isShown = (v: number) => !only || local === undefined || local[v]! < 0.05;
    if (shown.kind === "p") {
      const logs = values.map((p, v) => (isShown(v) ? -Math.log10(Math.max(p, 10 ** -LEAST_P)) : NaN));
      return { coloring: { values: logs, low: 0, high: LEAST_P, map: "viridis" }, ticks: ["1", "0.1", "0.01", "≤ 0.001"], map: "viridis" };
    }
    const top = topOf(values);
    return { coloring: { values: values.map((value, v) => (isShown(v) ? value : NaN)), low: -top, high: top, map: "blue_red" }, ticks: signedTicks(top), map: "blue_red" };
  }, [arrays, shown.name, only]);
  if (maps.length === 0) return <p class="hint">No effect was asked for, so there are no maps.</p>;
  const found = maps.find((map) => map.measure === measure && map.contrast === contrast);
  const withUnit = shown.kind === "effect" ? `effect on ${title}${unit === "mm" ? ", mm" : unit === "ln" ? ", natural logarithm" : ""}` : `${shown.title} of ${title}`;
  const covered = arrays && local ? local.filter((p) => p < 0.05).length : null;
  return (
    <>
      <div class="tools">
        <label>
          Contrast{" "}
          <select value={contrast} onChange={(e) => setContrast(e.currentTarget.value)}>
            {contrasts.map((each) => (
              <option value={each}>{each}</option>
            ))}
          </select>
        </label>
        <label>
          Measure{" "}
          <select value={measure} onChange={(e) => setMeasure(e.currentTarget.value)}>
            {maps.filter((map) => map.contrast === contrast).map((map) => (
              <option value={map.measure}>{MEASURES[map.measure]?.title ?? words(map.measure)}</option>
            ))}
          </select>
        </label>
        <label>
          Color by{" "}
          <select value={shown.name} onChange={(e) => setQuantity(e.currentTarget.value)}>
            {offered.map(({ name, title }) => (
              <option value={name}>{title}</option>
            ))}
          </select>
        </label>
        <Check label="Only local p < 0.05" checked={only} onChange={(e) => setOnly(e.currentTarget.checked)} />
      </div>
      <Failure text={failure} />
      {loaded === null ? (
        <p class="loading big">Loading the map …</p>
      ) : (
        <Surface
          geometry={loaded.geometry}
          coloring={view?.coloring ?? null}
          id="map"
          label={`The mean surface, colored by ${withUnit}, contrast ${contrast}`}
          file={`${name}-${measure}-${contrast}-${shown.name}.png`}
          readout={(v) => `vertex ${v} · ${offered.map(({ name, title, kind }) => `${title.split(" (")[0]} ${number(arrays?.[name]?.[v])}${kind === "effect" && unit === "mm" ? " mm" : ""}`).join(" · ")}`}
        />
      )}
      <div class="legend">
        {view && <ColorBar map={view.map} title={withUnit} ticks={view.ticks} />}
        <p id="map-says">
          {found && `Smallest corrected p ${number(found.smallest_p, 2)}; ${number(100 * found.significant_share, 2)} % of the surface significant${covered === null ? "" : ` (${number(covered)} vertices)`}.`}
          {shown.kind !== "p" && " Red: above zero; blue: below."} {only && "Gray: local p not below 0.05."}
        </p>
      </div>
    </>
  );
}

const MODE_DEVIATIONS = 2;

export function Modes({ archive, result, name }: { archive: Archive; result: StudyResult; name: string }) {
  const { compactness } = result.found.model;
  const shareOf = (mode: number) => 100 * (compactness[mode - 1]! - (compactness[mode - 2] ?? 0));
  const modes = compactness.map((_, k) => k + 1).filter((mode) => archive.has(`modes/mode-${mode}-plus-2sd.vtk`));
  const [mode, setMode] = useState(modes[0] ?? 1);
  const [along, setAlong] = useState(MODE_DEVIATIONS);
  const [loaded, setLoaded] = useState<{ geometry: BufferGeometry; mean: Float32Array; normals: Float32Array; step: Float32Array } | null>(null);
  const [failure, setFailure] = useState<string | null>(null);
  useWork(
    (signal) => {
      if (modes.length === 0) return;
      Promise.all(["minus", "plus"].map((sign) => archive.bytes(`modes/mode-${mode}-${sign}-2sd.vtk`))).then(
        ([minus, plus]) => {
          if (signal.aborted) return;
          const [low, high] = [readVtk(minus!).geometry, readVtk(plus!).geometry];
          const [from, to] = [low, high].map((geometry) => geometry.getAttribute("position").array as Float32Array) as [Float32Array, Float32Array];
          // The mean is in the middle; a step is one standard deviation.
          const mean = from.map((x, k) => (x + to[k]!) / 2);
          const step = from.map((x, k) => (to[k]! - x) / (2 * MODE_DEVIATIONS));
          setLoaded((before) => {
            if (before) return { ...before, step };
            low.getAttribute("position").array.set(mean);
            low.computeVertexNormals();
            low.computeBoundingSphere();
            return { geometry: low, mean, normals: Float32Array.from(low.getAttribute("normal").array), step };
          });
        },
        (error: unknown) => !signal.aborted && setFailure(describe(error)),
      );
    },
    [archive, mode],
  );
  const view = useMemo(() => {
    if (loaded === null) return null;
    const { mean, normals, step } = loaded;
    const outwards = Float32Array.from({ length: mean.length / 3 }, (_, v) => new Vector3().fromArray(step, 3 * v).dot(new Vector3().fromArray(normals, 3 * v)));
    const top = MODE_DEVIATIONS * topOf(outwards);
    const coloring: Coloring = { values: outwards.map((value) => along * value), low: -top, high: top, map: "blue_red" };
    return { coloring, top, positions: mean.map((x, k) => x + along * step[k]!) };
  }, [loaded, along]);
  if (modes.length === 0) return <p class="hint">The model has no modes.</p>;
  return (
    <>
      <div class="tools">
        <label>
          Mode{" "}
          <select value={String(mode)} onChange={(e) => setMode(Number(e.currentTarget.value))}>
            {modes.map((k) => (
              <option value={String(k)}>
                {k}: {number(shareOf(k))} % of the variance
              </option>
            ))}
          </select>
        </label>
        <label class="slider">
          −{MODE_DEVIATIONS} SD{" "}
          <input type="range" min={-MODE_DEVIATIONS} max={MODE_DEVIATIONS} step={0.1} value={along} aria-label="Standard deviations along the mode" aria-valuetext={`${along.toFixed(1)} standard deviations`} onInput={(e) => setAlong(Number(e.currentTarget.value))} /> +{MODE_DEVIATIONS} SD
        </label>
        <button onClick={() => setAlong(0)}>Mean</button>
      </div>
      <Failure text={failure} />
      {loaded === null ? (
        <p class="loading big">Loading the mode …</p>
      ) : (
        <Surface
          geometry={loaded.geometry}
          coloring={view!.coloring}
          positions={view!.positions}
          id="mode"
          label={`The mean shape, moved by ${along.toFixed(1)} standard deviations along mode ${mode}`}
          file={`${name}-mode-${mode}-${along.toFixed(1)}sd.png`}
          readout={(v) => `vertex ${v} · ${number(view!.coloring.values[v])} mm along the normal of the mean`}
        />
      )}
      <div class="legend">
        {view && <ColorBar map="blue_red" title="displacement along the normal of the mean, mm" ticks={signedTicks(view.top)} />}
        <p>
          The mean {along === 0 ? "itself" : `and ${along > 0 ? "+" : "−"}${Math.abs(along).toFixed(1)} standard deviations`} along mode {mode}, which explains {number(shareOf(mode))} % of the variance. Red: outwards; blue: inwards.
        </p>
      </div>
    </>
  );
}
