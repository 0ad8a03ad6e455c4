// A job: the verdict first, then the picture, then how it came about.

import { useMemo, useState } from "preact/hooks";
import { type Job, type Result, type TracePoint, describe, get, isOfField, send } from "./api";
import { duration, isFinal, mm, number, percent, verdict, words } from "./format";
import { answered, follow, newest } from "./live";
import { loadPair, type Pair } from "./pair";
import { Badge, Bar, Check, Facts, Failure, Plot, State, useNow, useWork } from "./parts";
import { go } from "./router";
import { Saves, Viewer } from "./viewer";

export function JobView({ id }: { id: string }) {
  const [job, setJob] = useState<Job | null>(null);
  const [trace, setTrace] = useState<TracePoint[]>([]);
  const [pair, setPair] = useState<Pair | null>(null);
  const [result, setResult] = useState<Result | null>(null);
  const [connected, setConnected] = useState(true);
  const [failure, setFailure] = useState<string | null>(null);
  const failed = (error: unknown) => setFailure(describe(error));
  const now = useNow();

  useWork(
    (signal) => {
      setJob(null);
      setTrace([]);
      setPair(null);
      setResult(null);
      setFailure(null);
      answered(() => get<Job>(`v1/jobs/${id}`, signal), signal).then(
        (found) => !signal.aborted && setJob((before) => before ?? found),
        (error: unknown) => !signal.aborted && failed(error),
      );
      // Points that arrive together are drawn together.
      let waiting: TracePoint[] = [];
      let timer = 0;
      const flush = () => {
        timer = 0;
        const more = waiting;
        waiting = [];
        if (!signal.aborted) setTrace((before) => [...before, ...more]);
      };
      void follow(
        id,
        {
          job: (next) =>
            setJob((before) => newest(before, { ...next, queue_position: next.queue_position ?? (next.state === "queued" ? before?.queue_position : undefined) })),
          trace: (points) => {
            waiting.push(...points);
            if (timer === 0) timer = window.setTimeout(flush, 60);
          },
          progress: (progress) => setJob((before) => (before === null ? before : { ...before, progress })),
          connected: setConnected,
          failed,
        },
        signal,
      );
    },
    [id],
  );
  const hasResult = job?.state === "succeeded";
  useWork(
    (signal) => {
      if (!hasResult || job === null) return;
      loadPair(job, signal).then(
        (loaded) => {
          if (signal.aborted) return;
          setResult(loaded.result);
          setPair(loaded.pair);
        },
        (error: unknown) => !signal.aborted && failed(error),
      );
    },
    [id, hasResult],
  );

  // Progress and the clock do not draw it again.
  const isLive = job !== null && !isFinal(job.state);
  const traced = useMemo(() => <Trace points={trace} isLive={isLive} />, [trace, isLive]);

  if (job === null) return failure === null ? <p class="loading">Loading the job …</p> : <Failure text={failure} />;
  const said = verdict(job);
  const act = (verb: "cancel" | "retry") => {
    setFailure(null);
    send<Job>("POST", `v1/jobs/${id}/${verb}`).then((answer) => (verb === "retry" ? go(`jobs/${answer.id}`) : setJob((before) => (before?.id === answer.id ? newest(before, answer) : before))), failed);
  };
  const took = job.started_at ? duration((job.finished_at ? Date.parse(job.finished_at) : now) - Date.parse(job.started_at)) : null;

  return (
    <article class="job">
      <h1 class="sub">
        Job <code>{id}</code>
      </h1>
      <section class={`verdict ${said.tone}`} aria-label="Verdict">
        <span class="mark" aria-hidden="true">
          {said.mark}
        </span>
        <div>
          <p class="title" id="verdict">
            {said.title}
          </p>
          {said.lines.map((line) => (
            <p>{line}</p>
          ))}
          <p class="next">
            <b>Next:</b> {said.next}
          </p>
        </div>
        <div class="actions">
          {!isFinal(job.state) && (
            <button disabled={job.cancel_requested} onClick={() => act("cancel")}>
              Cancel
            </button>
          )}
          {isFinal(job.state) && <button onClick={() => act("retry")}>Retry</button>}
        </div>
      </section>
      <Failure text={failure} />
      {!isFinal(job.state) && (
        <p class="live" role="status">
          <Bar share={job.progress?.fraction ?? 0} label="Progress" /> {percent(job.progress?.fraction ?? 0)} · {job.progress?.message ?? words(job.state)} {took !== null && `· ${took}`}
          {!connected && <Badge tone="bad">connection lost, trying again</Badge>}
        </p>
      )}
      {pair !== null && <Viewer job={job} pair={pair} />}
      {hasResult && pair === null && failure === null && <p class="loading big">Loading the surfaces …</p>}
      <div class="columns">
        {result !== null && <Measures result={result} />}
        {traced}
        <section class="card">
          <h2>The job</h2>
          <Facts
            rows={[
              ["State", <State state={job.state} />],
              ["Method", `${job.method} ${job.method_version}`],
              ["Source", `${number(job.source.n_vertices)} vertices, ${job.source.report.format}`],
              ["Target", `${number(job.target.n_vertices)} vertices, ${job.target.report.format}`],
              ["Priority", number(job.priority)],
              ["Attempt", `${job.attempt} of ${job.max_attempts}`],
              ["Created", new Date(job.created_at).toLocaleString()],
              ["Ran for", took ?? "–"],
              ["Result from", job.cached ? "an earlier, equal job" : "this job"],
              ...(job.batch_id ? [["Batch", <a href={`#/batches/${job.batch_id}`}>{job.batch_id.slice(-8)}</a>] as [string, preact.ComponentChildren]] : []),
              ...(job.retry_of ? [["Retry of", <a href={`#/jobs/${job.retry_of}`}>{job.retry_of.slice(-8)}</a>] as [string, preact.ComponentChildren]] : []),
              ...(job.external_ref ? [["Reference", job.external_ref] as [string, string]] : []),
              ...Object.entries(job.labels).map(([name, value]): [string, string] => [`Label ${name}`, value]),
            ]}
          />
        </section>
        {result !== null && <Timings result={result} />}
        {hasResult && (
          <section class="card">
            <h2>Save</h2>
            <Saves job={job} failed={failed} />
          </section>
        )}
        <Inputs job={job} />
        <section class="card">
          <h2>Parameters and provenance</h2>
          <Parameters job={job} />
          {result !== null && (
            <Facts
              rows={[
                ["Program", `${result.provenance.version}, commit ${result.provenance.commit}`],
                ["Seed", number(result.provenance.seed)],
                ["Source file", <code class="hash">{job.source.hash}</code>],
                ["Target file", <code class="hash">{job.target.hash}</code>],
              ]}
            />
          )}
        </section>
      </div>
    </article>
  );
}

function Measures({ result }: { result: Result }) {
  const { surface_distance: distance, topology, deformation, support, reliability } = result;
  const rows: [string, string][] = [
    ["Surface distance, mean", mm(distance.mean_mm)],
    ["Surface distance, 95 % within", mm(distance.p95_mm)],
    ["Surface distance, largest", mm(distance.max_mm)],
    ["Neighbors that stay neighbors", percent(topology.consistency)],
    ["Target vertices reached", percent(topology.coverage)],
    ["Inliers of the transform", `${number(support.inliers)} (${percent(support.ratio)})`],
    ["Rotation", `${result.transform.rotation_angle_deg.toFixed(1)}°`],
  ];
  if (deformation) {
    rows.push(
      ["Folded triangles", `${number(deformation.folded_triangles)} (${percent(deformation.folded_area_share)} of the area)`],
      ["Area, target over source (5th to 95th percentile)", `${number(deformation.area_ratio)} (${number(deformation.area_ratio_p05)} to ${number(deformation.area_ratio_p95)})`],
      ["Volume, target over source", number(deformation.volume_ratio)],
    );
  }
  if (reliability) {
    rows.push(
      ["Misfit (about 1.0 for copies, 1.2 for two subjects)", number(reliability.misfit)],
      ["Misfit of the next best pose", number(reliability.runner_up_misfit)],
      ["Misfit of a mirrored source", number(reliability.other_handedness_misfit)],
      ["Curvature agreement", number(reliability.curvature_agreement)],
      ["Agreement of directions", number(reliability.normal_agreement)],
    );
    if (reliability.distortion !== undefined) {
      rows.push(["Distortion (0 if angles are kept, about 0.2 for two subjects)", number(reliability.distortion)]);
    }
  }
  return (
    <section class="card">
      <h2>How good it is</h2>
      <Facts rows={rows} />
    </section>
  );
}

/** A plot has fewer pixels than a long trace has points. */
const MOST_DRAWN = 4000;

/**
 * At most about `MOST_DRAWN` points: of as many consecutive ones as needed those of the lowest and of the highest energy, and all at which
 * a round begins or the support is known. Drawn, they look like all of them, and take as long for 100,000 points as for 4,000.
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
      if (k === low || k === high || k === points.length - 1 || point.support !== undefined || point.round !== points[k - 1]?.round) kept.push(point);
    }
  }
  return kept;
}

function Trace({ points, isLive }: { points: TracePoint[]; isLive: boolean }) {
  const [isLog, setLog] = useState(false);
  const [parts, setParts] = useState(false);
  const [round, setRound] = useState("all");
  const [model, setModel] = useState<"field" | "labels" | null>(null);
  const ofField = useMemo(() => points.filter(isOfField), [points]);
  const ofLabels = useMemo(() => points.filter((point) => !isOfField(point) && (point.energy !== undefined || point.support !== undefined)), [points]);
  const ofModel = (model ?? (ofField.length > 0 ? "field" : "labels")) === "field" ? ofField : ofLabels;
  const rounds = useMemo(() => [...new Set(ofModel.map((point) => point.round))], [ofModel]);
  const isRound = rounds.map(String).includes(round);
  const chosen = useMemo(() => ofModel.filter((point) => !isRound || String(point.round) === round), [ofModel, isRound, round]);
  const shown = useMemo(() => thinned(chosen), [chosen]);
  const of = (name: "energy" | "energy_unary" | "energy_pairwise" | "lower_bound" | "support" | "temperature") =>
    shown.map((point) => {
      const value = point[name];
      return value === undefined || (isLog && name !== "support" && value <= 0) ? null : value;
    });
  const has = (name: keyof TracePoint) => shown.some((point) => point[name] !== undefined);
  const marks = shown.flatMap((point, k) => (k === 0 || shown[k - 1]!.round !== point.round ? [{ at: point.seq, text: `round ${point.round}` }] : []));
  const last = chosen.at(-1);
  const series = [
    { label: "energy", color: "#0072b2", values: of("energy"), width: 2.5 },
    ...(parts ? [{ label: ofModel === ofField ? "misfit" : "unary", color: "#d55e00", values: of("energy_unary"), dash: [6, 3] }, { label: ofModel === ofField ? "deformation" : "pairwise", color: "#009e73", values: of("energy_pairwise"), dash: [2, 3] }] : []),
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
        {ofField.length > 0 && ofLabels.length > 0 && (
          <label>
            Of{" "}
            <select value={ofModel === ofField ? "field" : "labels"} onChange={(e) => setModel(e.currentTarget.value === "field" ? "field" : "labels")}>
              <option value="field">the displacement field</option>
              <option value="labels">the labels</option>
            </select>
          </label>
        )}
        {rounds.length > 1 && (
          <label>
            Round{" "}
            <select value={isRound ? round : "all"} onChange={(e) => setRound(e.currentTarget.value)}>
              <option value="all">all</option>
              {rounds.map((k) => (
                <option value={String(k)}>{k}</option>
              ))}
            </select>
          </label>
        )}
        {last && (
          <span>
            {points.length} points · latest {number(last.energy ?? null)} in {words(last.phase)}, round {last.round}, iteration {last.iteration}
          </span>
        )}
      </div>
      {shown.length === 0 ? (
        <p class="hint">{isLive ? "The first point comes with the first iteration." : "This method minimizes no energy, or its trace has been removed."}</p>
      ) : (
        <Plot
          title={`Energy over ${points.length} points, the last one ${number(last?.energy ?? null)}`}
          x={shown.map((point) => point.seq)}
          series={series}
          log={isLog}
          height={260}
          xLabel="point of the trace"
          yLabel="energy, lower is better"
          rightLabel={has("temperature") ? "temperature" : "inliers"}
          marks={marks}
        />
      )}
    </section>
  );
}

function Timings({ result }: { result: Result }) {
  const { total = 1, ...phases } = result.timings_ms;
  const rows = Object.entries(phases).sort(([, a], [, b]) => b - a);
  return (
    <section class="card">
      <h2>Time: {duration(total)}</h2>
      <Facts rows={rows.map(([name, ms]) => [words(name), <><Bar share={ms / total} label={`Share of ${words(name)}`} /> {duration(ms)}</>])} />
    </section>
  );
}

export function Inputs({ job }: { job: Pick<Job, "source" | "target"> }) {
  const { source, target } = job;
  const row = (name: string, of: (input: Job["source"]) => string) => (
    <tr>
      <th scope="row">{name}</th>
      <td>{of(source)}</td>
      <td>{of(target)}</td>
    </tr>
  );
  return (
    <section class="card">
      <h2>Surfaces</h2>
      <table class="plain">
        <thead>
          <tr>
            <td />
            <th scope="col">Source</th>
            <th scope="col">Target</th>
          </tr>
        </thead>
        <tbody>
          {row("Format", (input) => input.report.format)}
          {row("Vertices", (input) => number(input.n_vertices))}
          {row("Faces", (input) => number(input.n_faces))}
          {row("Genus", (input) => String(input.report.topology.genus ?? "open"))}
          {row("Pieces", (input) => number(input.report.topology.n_components))}
          {row("Boundary edges", (input) => number(input.report.topology.n_boundary_edges))}
          {row("Area", (input) => `${number(input.report.topology.area_mm2)} mm²`)}
          {row("Volume", (input) => (input.report.topology.volume_mm3 === null ? "–" : `${number(input.report.topology.volume_mm3)} mm³`))}
          {row("Repairs", (input) => (input.report.repairs.length === 0 ? "none" : String(input.report.repairs.length)))}
        </tbody>
      </table>
    </section>
  );
}

function Parameters({ job }: { job: Job }) {
  const [defaults, setDefaults] = useState<Record<string, unknown> | null>(null);
  useWork((signal) => {
    // A service that does not know the method any more shows all parameters without comparing them.
    answered(() => get<{ defaults: Record<string, unknown> }>(`v1/methods/${job.method}`, signal), signal).then(
      (method) => !signal.aborted && setDefaults(method.defaults),
      () => undefined,
    );
  }, [job.method]);
  const all = flatten(job.parameters);
  const usual = new Map(defaults ? flatten(defaults) : []);
  const changed = defaults === null ? [] : all.filter(([name, value]) => name !== "seed" && usual.get(name) !== value);
  return (
    <>
      <p>{defaults === null ? "" : changed.length === 0 ? `All as the method ${job.method} sets them.` : `Different from the method ${job.method}:`}</p>
      {changed.length > 0 && <Facts rows={changed.map(([name, value]) => [name, <code>{value}</code>])} />}
      <details>
        <summary>All {all.length} parameters</summary>
        <Facts rows={all.map(([name, value]) => [name, <code>{value}</code>])} />
      </details>
    </>
  );
}

/** `{a: {b: 1}}` as `[["a.b", "1"]]`; lists stay whole. */
export function flatten(value: unknown, prefix = ""): [string, string][] {
  if (value === null || typeof value !== "object" || Array.isArray(value)) return [[prefix, JSON.stringify(value)]];
  return Object.entries(value).flatMap(([name, inner]) => flatten(inner, prefix === "" ? name : `${prefix}.${name}`));
}
