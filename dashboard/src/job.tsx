// A job: the verdict first, then the picture, then how it came about.

import type { Vector3 } from "three";
import { useMemo, useState } from "preact/hooks";
import { type Job, type Result, type TracePoint, describe, get, send } from "./api";
import { duration, isFinal, mm, number, percent, verdict, words } from "./format";
import { answered, follow, newest } from "./live";
import { loadPair, type Pair } from "./pair";
import { Badge, Bar, Facts, Failure, State, useNow, useWork } from "./parts";
import { go } from "./router";
import { ScoreView, isScore } from "./score";
import { Slices } from "./slices";
import { Trace } from "./trace";
import { Saves, Viewer } from "./viewer";

export function JobView({ id }: { id: string }) {
  const [job, setJob] = useState<Job | null>(null);
  const [trace, setTrace] = useState<TracePoint[]>([]);
  const [pair, setPair] = useState<Pair | null>(null);
  const [result, setResult] = useState<Result | null>(null);
  const [cross, setCross] = useState<Vector3 | null>(null);
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
      setCross(null);
      setFailure(null);
      answered(() => get<Job>(`v1/jobs/${id}?fields=*`, signal), signal).then(
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
  const hasResult = job?.state === "succeeded" && !isScore(job);
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
    send<Job>("POST", `v1/jobs/${id}/${verb}`).then((answer) => (verb === "retry" ? go(`jobs/${answer.id}`) : setJob((before) => (before?.id === answer.id ? newest(before, { ...answer, parameters: before.parameters }) : before))), failed);
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
      {pair !== null && (
        <>
          <Viewer job={job} pair={pair} cross={cross} setCross={setCross} />
          <Slices job={job} pair={pair} cross={cross} setCross={setCross} />
        </>
      )}
      {hasResult && pair === null && failure === null && <p class="loading big">Loading the surfaces …</p>}
      <div class="columns">
        {job.state === "succeeded" && isScore(job) && <ScoreView job={job} />}
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
              ...Object.entries(job.tags).map(([name, value]): [string, string] => [`Tag ${name}`, value]),
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
    if (reliability.second_opinion) {
      rows.push(["Agreement with the default method (1 if equal, 0 if unrelated)", number(reliability.second_opinion.agreement)], ["Angle to its pose", `${reliability.second_opinion.angle_deg.toFixed(1)}°`]);
    }
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
  const all = flatten(job.parameters ?? {});
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
