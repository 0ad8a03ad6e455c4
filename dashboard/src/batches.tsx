// Batches: a study at a glance, the worst match first.

import { useState } from "preact/hooks";
import { type Batch, STATES, describe, get, query as queryOf, send } from "./api";
import { age, duration, isFinal, mm, number, shortId, verdictWord } from "./format";
import { type Page, type Row, rowOf } from "./jobs";
import { pause } from "./live";
import { Badge, Failure, State, useNow, useWork } from "./parts";
import { Plot } from "./plot";

/** The states of a batch as parts of a bar, with their numbers in words. */
function Counts({ batch }: { batch: Batch }) {
  const total = Math.max(1, batch.n_jobs);
  const shown = STATES.flatMap((state) => (batch.counts[state] ? [{ state, n: batch.counts[state]! }] : []));
  return (
    <>
      <svg class="counts" viewBox="0 0 100 6" preserveAspectRatio="none" aria-hidden="true">
        {shown.map(({ state, n }, k) => {
          const start = shown.slice(0, k).reduce((sum, other) => sum + other.n, 0);
          return <rect class={state} x={(100 * start) / total} width={(100 * n) / total} height="6" />;
        })}
      </svg>
      <span class="soft">{shown.map(({ state, n }) => `${n.toLocaleString("en")} ${state}`).join(", ")}</span>
    </>
  );
}

export function Batches() {
  const [batches, setBatches] = useState<Batch[]>([]);
  const [token, setToken] = useState<string | undefined>();
  const [failure, setFailure] = useState<string | null>(null);
  const [isLoaded, setLoaded] = useState(false);
  const now = useNow();
  const load = async (from: string | undefined, signal?: AbortSignal) => {
    try {
      const page = await get<{ batches: Batch[]; next_page_token?: string }>(`v1/batches${queryOf({ page_size: 50, page_token: from })}`, signal);
      setBatches((before) => (from === undefined ? page.batches : [...before, ...page.batches]));
      setToken(page.next_page_token);
      setLoaded(true);
    } catch (error) {
      if (!signal?.aborted) setFailure(describe(error));
    }
  };
  useWork((signal) => {
    void (async () => {
      await load(undefined, signal);
      while (!signal.aborted) {
        await pause(5_000, signal);
        if (!signal.aborted && !document.hidden && scrollY < 200) await load(undefined, signal);
      }
    })();
  }, []);
  return (
    <div>
      <h1>Batches</h1>
      <p>
        <a class="button" href="#/batches/new">
          New batch from files
        </a>
      </p>
      <Failure text={failure} />
      {isLoaded && batches.length === 0 && (
        <p class="empty">
          There is no batch yet: one template against many subjects, <a href="#/batches/new">from files</a> or by <code>POST /v1/batches</code> of <a href="docs/">the API</a>.
        </p>
      )}
      {batches.length > 0 && (
        <div class="scroll" tabIndex={0} role="region" aria-label="Batches">
          <table>
            <thead>
              <tr>
                <th scope="col">Batch</th>
                <th scope="col" class="numeric">
                  Jobs
                </th>
                <th scope="col">States</th>
                <th scope="col">Tags</th>
                <th scope="col">Age</th>
              </tr>
            </thead>
            <tbody>
              {batches.map((batch) => (
                <tr key={batch.id}>
                  <td>
                    <a href={`#/batches/${batch.id}`}>{batch.external_ref ?? `…${shortId(batch.id)}`}</a>
                  </td>
                  <td class="numeric">{number(batch.n_jobs)}</td>
                  <td>
                    <Counts batch={batch} />
                  </td>
                  <td>{Object.entries(batch.tags).map(([name, value]) => `${name}:${value}`).join(", ")}</td>
                  <td>{age(batch.created_at, now)}</td>
                </tr>
              ))}
            </tbody>
          </table>
        </div>
      )}
      {token !== undefined && <button onClick={() => void load(token)}>More</button>}
    </div>
  );
}

const MEASURES: { name: string; of: (row: Row) => number | undefined }[] = [
  { name: "Mean distance, mm", of: (row) => row.surface_distance?.mean_mm },
  { name: "95 % within, mm", of: (row) => row.surface_distance?.p95_mm },
  { name: "Largest distance, mm", of: (row) => row.surface_distance?.max_mm },
];

/** Worst first: without a result, then not reliable, then by distance. */
function badness(row: Row): number {
  if (!isFinal(row.state)) return -1;
  if (row.state !== "succeeded") return 2e9;
  return (row.reliable === false ? 1e9 : 0) + (row.surface_distance?.p95_mm ?? 0);
}

export function BatchView({ id }: { id: string }) {
  const [batch, setBatch] = useState<Batch | null>(null);
  const [rows, setRows] = useState<Row[]>([]);
  const [failure, setFailure] = useState<string | null>(null);
  const [order, setOrder] = useState(0);
  useWork(
    (signal) => {
      void (async () => {
        try {
          let wait = "";
          while (!signal.aborted) {
            const found = await get<Batch>(`v1/batches/${id}${wait}`, signal);
            setBatch(found);
            const all: Row[] = [];
            let token: string | undefined = "";
            while (token !== undefined) {
              const page: Page = await get<Page>(`v1/batches/${id}/jobs${queryOf({ page_size: 500, page_token: token })}`, signal);
              all.push(...page.jobs.map(rowOf));
              token = page.next_page_token;
            }
            setRows(all);
            if (found.finished) return;
            wait = "?wait=20";
            await pause(500, signal);
          }
        } catch (error) {
          if (!signal.aborted) setFailure(describe(error));
        }
      })();
    },
    [id],
  );
  if (batch === null) return failure === null ? <p class="loading">Loading the batch …</p> : <Failure text={failure} />;
  const measure = MEASURES[order - 1];
  const sorted = [...rows].sort((a, b) => (measure ? (measure.of(b) ?? -1) - (measure.of(a) ?? -1) : badness(b) - badness(a)));
  const done = rows.filter((row) => row.state === "succeeded");
  const unreliable = done.filter((row) => row.reliable === false).length;
  const lost = rows.filter((row) => isFinal(row.state) && row.state !== "succeeded").length;
  const tone = lost + unreliable > 0 ? "bad" : batch.finished ? "good" : "wait";
  return (
    <article>
      <h1 class="sub">
        Batch {batch.external_ref ?? <code>{id}</code>}
      </h1>
      <section class={`verdict ${tone}`} aria-label="Verdict">
        <span class="mark" aria-hidden="true">
          {tone === "good" ? "✓" : tone === "bad" ? "✕" : "…"}
        </span>
        <div>
          <p class="title">
            {lost + unreliable > 0 ? `${lost + unreliable} of ${number(batch.n_jobs)} ${lost + unreliable === 1 ? "needs" : "need"} a look` : batch.finished ? "All reliable, or not checked" : "Running"}
          </p>
          <p>
            {unreliable} not reliable, {lost} without a result, {done.length - unreliable} others succeeded.
          </p>
          <Counts batch={batch} />
        </div>
        <div class="actions">
          {!batch.finished && <button onClick={() => send("POST", `v1/batches/${id}/cancel`).catch((error: unknown) => setFailure(describe(error)))}>Cancel the rest</button>}
        </div>
      </section>
      <Failure text={failure} />
      <div class="columns three">
        {MEASURES.map(({ name, of }) => (
          <Histogram key={name} name={name} values={done.flatMap((row) => of(row) ?? [])} />
        ))}
      </div>
      <div class="scroll" tabIndex={0} role="region" aria-label="Subjects">
        <table>
          <thead>
            <tr>
              <th scope="col">Subject</th>
              <th scope="col">State</th>
              <th scope="col" aria-sort={order === 0 ? "descending" : undefined}>
                <button class="plain" onClick={() => setOrder(0)}>
                  Verdict, worst first
                </button>
              </th>
              {MEASURES.map(({ name }, k) => (
                <th scope="col" class="numeric" key={name} aria-sort={order === k + 1 ? "descending" : undefined}>
                  <button class="plain" onClick={() => setOrder(k + 1)}>
                    {name}
                  </button>
                </th>
              ))}
              <th scope="col">Ran for</th>
            </tr>
          </thead>
          <tbody>
            {sorted.slice(0, 500).map((row) => {
              const said = verdictWord(row);
              return (
                <tr key={row.id}>
                  <td>
                    <a href={`#/jobs/${row.id}`}>{row.external_ref ?? `…${shortId(row.id)}`}</a>
                  </td>
                  <td>
                    <State state={row.state} />
                  </td>
                  <td>{said.text !== "" && <Badge tone={said.tone}>{said.text}</Badge>}</td>
                  {MEASURES.map(({ name, of }) => (
                    <td class="numeric" key={name}>
                      {mm(of(row))}
                    </td>
                  ))}
                  <td>{row.started_at && row.finished_at ? duration(Date.parse(row.finished_at) - Date.parse(row.started_at)) : ""}</td>
                </tr>
              );
            })}
          </tbody>
        </table>
      </div>
      {sorted.length > 500 && (
        <p>
          The first 500 of {number(sorted.length)}. <a href={`#/jobs?batch=${id}`}>All of them</a>
        </p>
      )}
    </article>
  );
}

const BINS = 16;

/** How often values lie in each of some intervals of equal width, which cover all of them. */
export function binned(values: number[]): { range: [number, number]; middles: number[]; counts: (number | null)[] } {
  const [low, high] = [Math.min(...values), Math.max(...values)];
  // Of one value alone the picture is one bar in the middle.
  const width = (high - low || Math.abs(high) * 0.1 || 1) / (BINS - 1);
  const range: [number, number] = high > low ? [low - width / 2, high + width / 2] : [low - (BINS * width) / 2, low + (BINS * width) / 2];
  const counts = Array.from({ length: BINS }, (): number | null => null);
  for (const value of values) {
    const k = Math.min(BINS - 1, Math.max(0, Math.floor((value - range[0]) / width)));
    counts[k] = (counts[k] ?? 0) + 1;
  }
  return { range, middles: counts.map((_, k) => range[0] + (k + 0.5) * width), counts };
}

function Histogram({ name, values }: { name: string; values: number[] }) {
  if (values.length === 0) return null;
  const { range, middles, counts } = binned(values);
  const median = [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)]!;
  const said = `median ${number(median)}`;
  return (
    <section class="card">
      <h2>{name}</h2>
      <Plot title={`${name}: ${values.length} matches, ${said}`} x={middles} series={[{ label: "matches", color: "#2f7ebc", values: counts }]} height={190} xLabel={name} yLabel="matches" bars={range} marks={[{ at: median, text: said }]} />
    </section>
  );
}
