// The energy of a job in a few pixels.

import { useState } from "preact/hooks";
import { type JobState, type TracePoint, get, runOf } from "./api";
import { isFinal, words } from "./format";
import { pause } from "./live";
import { useWork } from "./parts";

interface Line {
  values: number[];
  /** What the energies are of. */
  of: string;
}

const sparks = new Map<string, Line | null>();
const MOST_SPARKS = 2_000;
const [WIDTH, HEIGHT] = [78, 20];

/** The last energies that can be compared with each other; null if there are no two. */
export function lastRun(points: TracePoint[]): Line | null {
  const known = points.filter(({ energy }) => energy !== undefined);
  for (let end = known.length; end > 0; ) {
    const run = runOf(known[end - 1]!);
    let from = end;
    while (from > 0 && runOf(known[from - 1]!) === run) from--;
    if (end - from > 1) {
      const { phase, round } = known[from]!;
      return { values: known.slice(from, end).map(({ energy }) => energy!), of: `${words(phase)}, ${phase === "displacement" ? "fit" : "round"} ${round}` };
    }
    end = from;
  }
  return null;
}

/** A line between these values, from the left to the right; by their logarithms if all are positive. */
export function outline(values: number[]): string {
  const scaled = values.every((value) => value > 0) ? values.map(Math.log) : values;
  const [low, high] = [Math.min(...scaled), Math.max(...scaled)];
  return scaled.map((value, k) => `${((k / (scaled.length - 1)) * WIDTH + 1).toFixed(1)},${(HEIGHT + 1 - (HEIGHT * (value - low)) / (high - low || 1)).toFixed(1)}`).join(" ");
}

/** Read when the row has been in sight for a moment. */
export function Spark({ id, state }: { id: string; state: JobState }) {
  const [line, setLine] = useState<Line | null>(sparks.get(id) ?? null);
  useWork(
    (signal) => {
      const kept = sparks.get(id);
      setLine(kept ?? null);
      if (state === "queued" || (kept !== undefined && isFinal(state))) return;
      void pause(250, signal).then(async () => {
        if (signal.aborted) return;
        const page = await get<{ points: TracePoint[] }>(`v1/jobs/${id}/trace?limit=200`, signal).catch(() => null);
        if (page === null || signal.aborted) return;
        const read = lastRun(page.points);
        if (sparks.size > MOST_SPARKS) sparks.clear();
        if (isFinal(state)) sparks.set(id, read);
        setLine(read);
      });
    },
    [id, state],
  );
  if (line === null) return null;
  const said = `Energy of the ${line.of}, from ${line.values[0]!.toPrecision(3)} to ${line.values.at(-1)!.toPrecision(3)}`;
  return (
    <svg class="spark" width={WIDTH + 2} height={HEIGHT + 2} role="img" aria-label={said}>
      <title>{said}</title>
      <polyline points={outline(line.values)} />
    </svg>
  );
}
