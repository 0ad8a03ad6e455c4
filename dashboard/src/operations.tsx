// Is the queue well? From the metrics of the service and the lists of jobs.

import { useState } from "preact/hooks";
import { ApiError, type Job, call, describe, get, query as queryOf } from "./api";
import { age, bytes, duration, number, shortId, words } from "./format";
import type { Page } from "./jobs";
import { pause } from "./live";
import { Bar, Badge, Facts, Failure, useNow, useWork } from "./parts";
import { Plot } from "./plot";

export type Metrics = Map<string, { labels: Record<string, string>; value: number }[]>;

/** The text format of Prometheus, without histograms. */
export function readMetrics(text: string): Metrics {
  const found: Metrics = new Map();
  for (const line of text.split("\n")) {
    const parts = /^([a-zA-Z_:][\w:]*)(?:\{(.*)\})? (\S+)$/.exec(line);
    if (!parts || line.startsWith("#")) continue;
    const labels = Object.fromEntries([...(parts[2] ?? "").matchAll(/(\w+)="((?:[^"\\]|\\.)*)"/g)].map(([, name, value]) => [name, value]));
    const rows = found.get(parts[1]!) ?? [];
    rows.push({ labels, value: Number(parts[3]) });
    found.set(parts[1]!, rows);
  }
  return found;
}

/** Over all labels of a metric. */
const total = (metrics: Metrics, name: string): number => (metrics.get(name) ?? []).reduce((sum, { value }) => sum + value, 0);

interface Sample {
  at: number;
  finished: number;
  queued: number;
  running: number;
}

/** Failed jobs that are looked at. */
const RECENT = 500;

export function Operations() {
  const [metrics, setMetrics] = useState<Metrics | null>(null);
  const [samples, setSamples] = useState<Sample[]>([]);
  const [running, setRunning] = useState<Job[]>([]);
  const [failures, setFailures] = useState<[string, number, string][]>([]);
  const [ready, setReady] = useState<Record<string, string> | null>(null);
  const [failure, setFailure] = useState<string | null>(null);
  const now = useNow();
  useWork((signal) => {
    void (async () => {
      for (let k = 0; !signal.aborted; k++) {
        try {
          const read = readMetrics(await (await call("metrics", { signal })).text());
          const one = (state: string) => read.get("homolog_jobs")?.find(({ labels }) => labels.state === state)?.value ?? 0;
          setMetrics(read);
          setSamples((before) => [...before.slice(-299), { at: Date.now(), finished: total(read, "homolog_jobs_finished_total"), queued: one("queued"), running: one("running") }]);
          setRunning((await get<Page>("v1/jobs?state=running&page_size=100", signal)).jobs);
          get<{ dependencies: Record<string, string> }>("readyz", signal).then(
            ({ dependencies }) => setReady(dependencies),
            (error: unknown) => setReady(error instanceof ApiError ? ((error.problem as unknown as { dependencies?: Record<string, string> }).dependencies ?? {}) : null),
          );
          if (k % 10 === 0) setFailures(await recentFailures(signal));
          setFailure(null);
        } catch (error) {
          if (!signal.aborted) setFailure(describe(error));
        }
        await pause(2_000, signal);
      }
    })();
  }, []);
  if (metrics === null) return failure === null ? <p class="loading">Loading …</p> : <Failure text={failure} />;
  const value = (name: string) => metrics.get(name)?.[0]?.value ?? 0;
  const sum = (name: string) => total(metrics, name);
  const of = (name: string, label: string) => (metrics.get(name) ?? []).map(({ labels, value }) => [labels[label] ?? Object.values(labels).join(" "), value] as const).filter(([, n]) => n > 0);
  const last = samples.at(-1)!;
  const oldest = value("homolog_queue_oldest_age_seconds");
  const isUp = value("homolog_job_store_up") === 1;
  const bad = Object.entries(ready ?? {}).filter(([, state]) => state !== "ok");
  const inState = (state: string) => metrics.get("homolog_workers")?.find(({ labels }) => labels.state === state)?.value ?? 0;
  const isStuck = last.queued > 0 && last.running === 0 && oldest > 30;
  const tone = !isUp || bad.length > 0 || isStuck ? "bad" : oldest > 600 ? "wait" : "good";
  const workers = new Map<string, Job[]>();
  for (const job of running) {
    const worker = (job as Job & { worker?: string }).worker ?? "unnamed worker";
    workers.set(worker, [...(workers.get(worker) ?? []), job]);
  }
  const began = samples[0]!.at;
  return (
    <div>
      <h1>Operations</h1>
      <section class={`verdict ${tone}`} aria-label="Verdict">
        <span class="mark" aria-hidden="true">
          {tone === "good" ? "✓" : tone === "bad" ? "✕" : "…"}
        </span>
        <div>
          <p class="title">{tone === "good" ? "The queue is healthy" : isStuck ? "Nothing runs" : tone === "wait" ? "Jobs wait long" : "A dependency fails"}</p>
          <p>
            {number(last.queued)} queued, {number(last.running)} running{last.queued > 0 && `; the oldest has waited ${duration(oldest * 1000)}`}.
          </p>
          <p class="next">
            <b>Next:</b>{" "}
            {tone === "good"
              ? "nothing to do."
              : isStuck
                ? inState("idle") === 0
                  ? "No worker runs: start one, and look into the log of those that ended."
                  : "Workers are idle: look whether a job asks for more memory than one of them has."
                : tone === "wait"
                  ? "Add workers, or lower the priority of what can wait."
                  : `Look at ${bad.map(([name, state]) => `${name} (${state})`).join(", ") || "the database"}.`}
          </p>
        </div>
      </section>
      <Failure text={failure} />
      <div class="columns">
        <section class="card wide">
          <h2>Queue, since this page was opened</h2>
          <Plot
            title={`Queued ${last.queued}, running ${last.running}`}
            x={samples.map(({ at }) => (at - began) / 1000)}
            series={[
              { label: "queued", color: "#2f7ebc", values: samples.map(({ queued }) => queued), width: 2 },
              { label: "running", color: "#d55e00", values: samples.map(({ running }) => running), width: 2 },
            ]}
            height={220}
            xLabel="seconds"
            yLabel="jobs"
            whole
          />
        </section>
        <section class="card">
          <h2>Workers and what they run</h2>
          <p id="use">
            <b>
              {number(inState("busy"))} {inState("busy") === 1 ? "worker runs" : "workers run"} {number(last.running)} {last.running === 1 ? "job" : "jobs"}
            </b>
            , {number(inState("idle"))} {inState("idle") === 1 ? "is" : "are"} idle{last.queued > 0 && `, ${number(last.queued)} ${last.queued === 1 ? "job waits" : "jobs wait"}`}.
          </p>
          <Facts
            rows={[
              ["Processes for computations, at work or at rest", number(sum("homolog_children_started_total") - sum("homolog_children_ended_total"))],
              ["Jobs finished here since this page was opened", number(sum("homolog_jobs_finished_total") - samples[0]!.finished)],
            ]}
          />
          <p class="soft">A worker is a process, of all tenants; below are those that run jobs of this key's tenant.</p>
          {[...workers].map(([worker, jobs]) => (
            <div key={worker}>
              <h3>
                <code>{worker}</code>: {jobs.length} {jobs.length === 1 ? "job" : "jobs"}
              </h3>
              <ul class="running">
                {jobs.map((job) => (
                  <li>
                    <a href={`#/jobs/${job.id}`}>…{shortId(job.id)}</a> {job.method}, {words(job.progress?.phase ?? "starting")}, {job.started_at ? age(job.started_at, now) : ""} <Bar share={job.progress?.fraction ?? 0} label={`Progress of ${shortId(job.id)}`} />
                  </li>
                ))}
              </ul>
            </div>
          ))}
        </section>
        <section class="card">
          <h2>Failures by kind</h2>
          {failures.length === 0 ? (
            <p class="hint">No job of this tenant has failed.</p>
          ) : (
            <Facts
              rows={failures.map(([kind, n, id]) => [
                kind,
                <>
                  {number(n)}, newest <a href={`#/jobs/${id}`}>…{shortId(id)}</a>
                </>,
              ])}
            />
          )}
          <p class="soft">Among the last {RECENT} jobs of this tenant that failed or were given up.</p>
        </section>
        <section class="card">
          <h2>Finished since the service was started</h2>
          <Facts rows={of("homolog_jobs_finished_total", "state").map(([state, n]) => [state, number(n)])} />
          <Facts rows={of("homolog_problems_total", "type").map(([type, n]) => [`Refused: ${words(type).replaceAll("-", " ")}`, number(n)])} />
        </section>
        <section class="card">
          <h2>This process</h2>
          <Facts
            rows={[
              ...Object.entries(ready ?? {}).map(([name, state]): [string, preact.ComponentChildren] => [words(name), <Badge tone={state === "ok" ? "good" : "bad"}>{state}</Badge>]),
              ["Memory", bytes(value("process_resident_memory_bytes"))],
              ["Running since", value("process_start_time_seconds") ? new Date(1000 * value("process_start_time_seconds")).toLocaleString() : "–"],
              ["Leases of lost workers", number(value("homolog_leases_expired_total"))],
              ["Jobs given up", number(value("homolog_jobs_dead_total"))],
            ]}
          />
        </section>
      </div>
    </div>
  );
}

async function recentFailures(signal: AbortSignal): Promise<[string, number, string][]> {
  const pages = await Promise.all(["failed", "dead"].map((state) => get<Page>(`v1/jobs${queryOf({ state, page_size: RECENT })}`, signal)));
  const kinds = new Map<string, [number, string]>();
  for (const job of pages.flatMap(({ jobs }) => jobs)) {
    const kind = job.error?.title ?? "Crashed too often";
    const [n, id] = kinds.get(kind) ?? [0, job.id];
    kinds.set(kind, [n + 1, id > job.id ? id : job.id]);
  }
  return [...kinds].map(([kind, [n, id]]): [string, number, string] => [kind, n, id]).sort(([, a], [, b]) => b - a);
}
