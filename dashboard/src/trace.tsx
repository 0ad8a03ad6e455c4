// The energy of a job, point by point as it arrives.

import { useMemo, useState } from "preact/hooks";
import { type TracePoint, quantityOf, runOf } from "./api";
import { number, words } from "./format";
import { Badge, Check } from "./parts";
import { Plot, type Series } from "./plot";

/** A plot has fewer pixels than a long trace has points. */
const MOST_DRAWN = 4000;

/**
 * At most about `MOST_DRAWN` points: of as many consecutive ones as needed those of the lowest and of the highest energy, and all at which
 * something begins or the support is known. Drawn, they look like all of them, and take as long for 100,000 points as for 4,000.
 */
function thinned(points: TracePoint[]): TracePoint[] {
  if (points.length <= MOST_DRAWN) return points;
  const step = Math.ceil((2 * points.length) / MOST_DRAWN);
  const kept: TracePoint[] = [];
  for (let from = 0; from < points.length; from += step) {
    const to = Math.min(points.length, from + step);
    let [low, high] = [from, from];
    for (let k = from + 1; k < to; k++) {
      const energy = points[k]!.energy;
      if (energy === undefined) continue;
      if (!(energy >= (points[low]!.energy ?? Infinity))) low = k;
      if (!(energy <= (points[high]!.energy ?? -Infinity))) high = k;
    }
    for (let k = from; k < to; k++) {
      const point = points[k]!;
      const begins = k === 0 || runOf(point) !== runOf(points[k - 1]!);
      if (k === low || k === high || k === points.length - 1 || point.support !== undefined || begins) kept.push(point);
    }
  }
  return kept;
}

/** What an energy is of, and what its curve does. */
const QUANTITIES: Record<string, { name: string; unary: string; pairwise: string; help: string }> = {
  field_energy: {
    name: "the displacement field",
    unary: "misfit",
    pairwise: "deformation",
    help: "Energy of the displacement field for each independent observation. Every fit begins anew, and a fit estimates its own scale at every step, so that its energy may rise while the surfaces come closer.",
  },
  isometry_energy: {
    name: "distances along the surfaces",
    unary: "unary",
    pairwise: "pairwise",
    help: "Energy of the assignment of target vertices over distances along the surfaces. Belief propagation does not lower it at every point; the phase registration does.",
  },
  mean_isometry_energy: {
    name: "distances along the surfaces, for each variable",
    unary: "unary",
    pairwise: "pairwise",
    help: "Energy of the assignment of target vertices over distances along the surfaces, divided by the number of variables: a point for each assignment from which a field begins.",
  },
  curvature_energy: {
    name: "curvature",
    unary: "unary",
    pairwise: "pairwise",
    help: "Energy of the assignment of target vertices over curvature. Belief propagation and random sweeps do not lower it at every point, and every round begins anew.",
  },
};
const named = (quantity: string) => QUANTITIES[quantity] ?? { ...QUANTITIES.curvature_energy!, name: words(quantity), help: "Values of this quantity are compared within one line only." };

/** Where a run of comparable points begins, in words. */
const begun = ({ start, round, phase, chosen }: TracePoint): string => `${start === undefined ? "" : `start ${start}, `}${phase === "displacement" ? "fit" : "round"} ${round}${chosen ? ", chosen" : ""}`;

export function Trace({ points, isLive }: { points: TracePoint[]; isLive: boolean }) {
  const [isLog, setLog] = useState(false);
  const [parts, setParts] = useState(false);
  const [round, setRound] = useState("all");
  const [wanted, setQuantity] = useState<string | null>(null);
  const known = useMemo(() => points.filter((point) => point.energy !== undefined || point.support !== undefined), [points]);
  const quantities = useMemo(() => [...new Set(known.map(quantityOf))], [known]);
  // The energy of the answer comes last.
  const quantity = wanted !== null && quantities.includes(wanted) ? wanted : (quantities.at(-1) ?? "curvature_energy");
  const meant = named(quantity);
  const ofQuantity = useMemo(() => known.filter((point) => quantityOf(point) === quantity), [known, quantity]);
  const rounds = useMemo(() => [...new Set(ofQuantity.map((point) => begun({ ...point, chosen: false })))], [ofQuantity]);
  const isRound = rounds.includes(round);
  const chosen = useMemo(() => ofQuantity.filter((point) => !isRound || begun({ ...point, chosen: false }) === round), [ofQuantity, isRound, round]);
  const shown = useMemo(() => thinned(chosen), [chosen]);
  // Between points that cannot be compared there is one without values, at which all lines end.
  const drawn = shown.flatMap((point, k): (TracePoint | null)[] => (k > 0 && runOf(shown[k - 1]!) !== runOf(point) ? [null, point] : [point]));
  const x = drawn.map((point, k) => point?.seq ?? drawn[k + 1]!.seq - 0.5);
  const of = (name: "energy" | "energy_unary" | "energy_pairwise" | "lower_bound" | "support" | "temperature"): Series["values"] =>
    drawn.map((point) => {
      if (point === null) return null;
      const value = point[name];
      return value === undefined || (isLog && name !== "support" && value <= 0) ? undefined : value;
    });
  const has = (name: keyof TracePoint) => shown.some((point) => point[name] !== undefined);
  const marks = shown.flatMap((point, k) => {
    const text = begun(point);
    return k === 0 || begun(shown[k - 1]!) !== text ? [{ at: point.seq, text }] : [];
  });
  // A run of one point is no line.
  const isAlone = (k: number) => shown[k]!.energy !== undefined && [shown[k - 1], shown[k + 1]].every((other) => other === undefined || runOf(other) !== runOf(shown[k]!));
  const alone = new Set(shown.filter((_, k) => isAlone(k)));
  const last = chosen.at(-1);
  const series: Series[] = [
    { label: "energy", color: "#0072b2", values: of("energy"), width: 2.5 },
    ...(alone.size > 0 ? [{ label: "energy, single points", color: "#0072b2", values: drawn.map((point) => (point !== null && alone.has(point) ? point.energy : undefined)), points: true }] : []),
    ...(parts ? [{ label: meant.unary, color: "#d55e00", values: of("energy_unary"), dash: [6, 3] }, { label: meant.pairwise, color: "#009e73", values: of("energy_pairwise"), dash: [2, 3] }] : []),
    ...(has("lower_bound") ? [{ label: "lower bound", color: "#8c6d1f", values: of("lower_bound"), dash: [10, 4] }] : []),
    ...(has("temperature") ? [{ label: "temperature", color: "#cc79a7", values: of("temperature"), scale: "right" }] : []),
    ...(has("support") && !has("temperature") ? [{ label: "support (inliers)", color: "#b0607f", values: of("support"), scale: "right", points: true }] : []),
  ];
  return (
    <section class="card wide" id="trace" data-points={points.length} data-last={points.at(-1)?.seq ?? 0}>
      <h2>Energy {isLive && <Badge tone="wait">live</Badge>}</h2>
      <div class="tools">
        <Check label="Logarithmic" checked={isLog} onChange={(e) => setLog(e.currentTarget.checked)} />
        <Check label="Its parts" checked={parts} onChange={(e) => setParts(e.currentTarget.checked)} />
        {quantities.length > 1 && (
          <label>
            Of{" "}
            <select value={quantity} onChange={(e) => setQuantity(e.currentTarget.value)}>
              {quantities.map((each) => (
                <option value={each}>{named(each).name}</option>
              ))}
            </select>
          </label>
        )}
        {rounds.length > 1 && (
          <label>
            Show{" "}
            <select value={isRound ? round : "all"} onChange={(e) => setRound(e.currentTarget.value)}>
              <option value="all">all</option>
              {rounds.map((each) => (
                <option value={each}>{each}</option>
              ))}
            </select>
          </label>
        )}
        {last && (
          <span>
            {number(points.length)} points · latest {number(last.energy ?? null)} in {words(last.phase)}, {begun(last)}, iteration {last.iteration}
          </span>
        )}
      </div>
      {shown.length === 0 ? (
        <p class="hint">{isLive ? "The first point comes with the first iteration." : "This method minimizes no energy, or its trace has been removed."}</p>
      ) : (
        <>
          <Plot
            title={`Energy of ${meant.name} over ${points.length} points, the last one ${number(last?.energy ?? null)}`}
            x={x}
            series={series}
            log={isLog}
            height={280}
            xLabel="point of the trace"
            yLabel="energy"
            rightLabel={has("temperature") ? "temperature" : "inliers"}
            marks={marks}
          />
          <p class="soft">{meant.help} Lines are not joined where values cannot be compared.</p>
        </>
      )}
    </section>
  );
}
