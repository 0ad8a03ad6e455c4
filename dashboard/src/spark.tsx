// The energy of a job in a few pixels.

import { useState } from "preact/hooks";
import { type JobState, type TracePoint, get, isOfField } from "./api";
import { isFinal } from "./format";
import { pause } from "./live";
import { useWork } from "./parts";

const sparks = new Map<string, number[]>();
const MOST_SPARKS = 2_000;

/** The energy of a job as a line of a few pixels; read when the row has been in sight for a moment. */
export function Spark({ id, state }: { id: string; state: JobState }) {
  const [values, setValues] = useState<number[]>(sparks.get(id) ?? []);
  useWork(
    (signal) => {
      const kept = sparks.get(id);
      setValues(kept ?? []);
      if (state === "queued" || (kept !== undefined && isFinal(state))) return;
      void pause(250, signal).then(async () => {
        if (signal.aborted) return;
        const page = await get<{ points: TracePoint[] }>(`v1/jobs/${id}/trace?limit=200`, signal).catch(() => null);
        if (page === null) return;
        const ofField = page.points.filter(isOfField);
        const shown = ofField.length > 0 ? ofField : page.points.filter(({ phase }) => phase === "inference");
        const read = shown.flatMap(({ energy }) => (energy === undefined ? [] : [energy]));
        if (sparks.size > MOST_SPARKS) sparks.clear();
        if (isFinal(state)) sparks.set(id, read);
        setValues(read);
      });
    },
    [id, state],
  );
  if (values.length < 2) return null;
  const logs = values.map((value) => Math.log(Math.max(value, 1e-9)));
  const [low, high] = [Math.min(...logs), Math.max(...logs)];
  const points = logs.map((value, k) => `${((k / (logs.length - 1)) * 78 + 1).toFixed(1)},${(21 - (20 * (value - low)) / (high - low || 1)).toFixed(1)}`);
  return (
    <svg class="spark" width="80" height="22" role="img" aria-label={`Energy from ${values[0]!.toPrecision(3)} to ${values.at(-1)!.toPrecision(3)}`}>
      <polyline points={points.join(" ")} />
    </svg>
  );
}
