// The list of jobs: live, filtered by the address, with as many rows as there are.

import { Virtualizer, elementScroll, observeElementOffset, observeElementRect } from "@tanstack/virtual-core";
import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import { type Job, type JobState, STATES, type TracePoint, describe, get, isOfField, query as queryOf, send } from "./api";
import { age, duration, isFinal, mm, shortId, verdictWord, words } from "./format";
import { followChanges, isRefused, newest, pause } from "./live";
import { Badge, Bar, Failure, State, Typed, useNow, useWork } from "./parts";
import { go } from "./router";

/** What a row shows: of 100,000 jobs no more is kept. */
export type Row = Pick<
  Job,
  "id" | "state" | "method" | "priority" | "progress" | "created_at" | "started_at" | "finished_at" | "reliable" | "unreliable_reasons" | "surface_distance" | "batch_id" | "external_ref" | "cancel_requested" | "labels"
>;

export const rowOf = (job: Job): Row => {
  const { id, state, method, priority, progress, created_at, started_at, finished_at, reliable, unreliable_reasons, surface_distance, batch_id, external_ref, cancel_requested, labels } = job;
  return { id, state, method, priority, progress, created_at, started_at, finished_at, reliable, unreliable_reasons, surface_distance, batch_id, external_ref, cancel_requested, labels };
};

export interface Page {
  jobs: Job[];
  next_page_token?: string;
}

const [FIRST_PAGE, PAGE] = [100, 500];
/** Changes that follow each other are gathered for this long; what could not be read is asked for again after that. */
const [GATHER_MS, RETRY_MS] = [300, 2_000];
/** Rows that are asked for at the same time, one by one. */
const AT_ONCE = 20;
const ROW_PX = 44;
const FILTERS = ["state", "method", "label", "external_ref", "batch", "study", "order"] as const;

/** What the list can be told to do. */
interface List {
  more(from: string): Promise<void>;
  renew(ids: string[]): Promise<void>;
}

export function Jobs({ query }: { query: URLSearchParams }) {
  const filters = Object.fromEntries(FILTERS.map((name) => [name, query.get(name) ?? ""])) as Record<(typeof FILTERS)[number], string>;
  const filterKey = JSON.stringify(filters);
  const [rows, setRows] = useState<Row[]>([]);
  const [token, setToken] = useState<string | undefined>("");
  const [failure, setFailure] = useState<string | null>(null);
  const [connected, setConnected] = useState(true);
  const [methods, setMethods] = useState<string[]>([]);
  /** Whether changes are followed. Until then there is the first page only. */
  const [isLive, setLive] = useState(false);
  const failed = (error: unknown) => setFailure(describe(error));
  const known = useRef(new Map<string, Row>());
  known.current = useMemo(() => new Map(rows.map((row) => [row.id, row])), [rows]);
  const list = useRef<List | null>(null);

  useWork(
    (signal) => {
      setRows([]);
      setToken("");
      setLive(false);
      const reading = new Set<Set<string>>();
      /** Reads what `take` gets, with the jobs that have changed since it was asked for: of these it may be out of date. */
      const read = async <T,>(ask: () => Promise<T>, take: (answer: T, changed: Set<string>) => void): Promise<void> => {
        const changed = new Set<string>();
        reading.add(changed);
        try {
          const answer = await ask();
          if (!signal.aborted) take(answer, changed);
        } finally {
          reading.delete(changed);
        }
      };
      const readPage = (size: number, from: string, take: (page: Page, rows: Row[], changed: Set<string>) => void) =>
        read(
          () => get<Page>(`v1/jobs${queryOf({ ...filters, page_size: size, page_token: from })}`, signal),
          (page, changed) => {
            take(page, page.jobs.map(rowOf), changed);
            renewSoon(page.jobs.map(({ id }) => id).filter((id) => changed.has(id)));
          },
        );
      const reload = () =>
        readPage(FIRST_PAGE, "", (page, top) => {
          setRows((before) => {
            const known = new Map(before.map((row) => [row.id, row]));
            return top.map((row) => newest(known.get(row.id), row));
          });
          setToken(page.next_page_token);
          setFailure(null);
        });
      let isLoading = false;
      const more = async (from: string) => {
        if (isLoading) return;
        isLoading = true;
        try {
          await readPage(PAGE, from, (page, further) => {
            setRows((before) => [...before, ...further]);
            setToken(page.next_page_token);
            setFailure(null);
          });
        } catch (error) {
          if (!signal.aborted) failed(error);
        } finally {
          isLoading = false;
        }
      };
      /** The newest jobs, before those that are shown. Returns which they are. */
      const renewTop = async (): Promise<Set<string>> => {
        let ids = new Set<string>();
        if (filters.order === "asc") return ids;
        await readPage(FIRST_PAGE, "", (_, top, changed) => {
          ids = new Set(top.map((row) => row.id));
          setRows((before) => {
            const known = new Map(before.map((row) => [row.id, row]));
            return [...top.map((row) => (changed.has(row.id) && known.get(row.id)) || newest(known.get(row.id), row)), ...before.filter((row) => !ids.has(row.id))];
          });
        });
        return ids;
      };
      const fits = (row: Row) => filters.state === "" || filters.state.split(",").includes(row.state);
      const renew = async (ids: string[]) => {
        for (let k = 0; k < ids.length && !signal.aborted; k += AT_ONCE) {
          const lost: string[] = [];
          const ask = (id: string) =>
            get<Job>(`v1/jobs/${id}`, signal).then(rowOf, (error: unknown) => {
              if (!isRefused(error)) lost.push(id);
              return null;
            });
          await read(
            () => Promise.all(ids.slice(k, k + AT_ONCE).map(ask)),
            (found, changed) => {
              // Those that have changed since are asked for again anyway.
              const by = new Map(found.flatMap((row) => (row === null || changed.has(row.id) ? [] : [[row.id, row]])));
              setRows((before) => before.map((row) => newest(row, by.get(row.id) ?? row)).filter(fits));
            },
          );
          renewSoon(lost, RETRY_MS);
        }
      };
      const waiting = new Set<string>();
      let timer = 0;
      const renewSoon = (ids: string[], ms = GATHER_MS) => {
        ids.forEach((id) => waiting.add(id));
        if (waiting.size > 0 && timer === 0 && !signal.aborted) timer = window.setTimeout(() => void renewWaiting(), ms);
      };
      let areManyRead = false;
      const renewWaiting = async () => {
        timer = 0;
        const ids = [...waiting];
        waiting.clear();
        const shown = ids.filter((id) => known.current.has(id));
        const areMany = shown.length > AT_ONCE;
        // A few do not wait for others, whose answers may be late; many do, or requests would pile up.
        if (areMany && areManyRead) return renewSoon(ids, RETRY_MS);
        areManyRead ||= areMany;
        try {
          const top = areMany || shown.length < ids.length ? await renewTop() : new Set();
          await renew(shown.filter((id) => !top.has(id)));
        } catch (error) {
          if (!isRefused(error)) renewSoon(ids, RETRY_MS);
        } finally {
          if (areMany) areManyRead = false;
        }
      };
      list.current = { more, renew };

      const first = reload().catch((error: unknown) => {
        if (!signal.aborted) failed(error);
      });
      void followChanges(
        async () => {
          await first;
          try {
            await reload();
            setLive(true);
          } catch (error) {
            if (!isRefused(error)) throw error;
            failed(error);
          }
        },
        (changes) => {
          const ids = changes.map(({ job_id }) => job_id);
          for (const changed of reading) ids.forEach((id) => changed.add(id));
          renewSoon(ids);
        },
        setConnected,
        signal,
      );
      // Progress is no change of state.
      void (async () => {
        while (!signal.aborted) {
          await pause(2_000, signal);
          const running = [...known.current.values()].filter((row) => row.state === "running").slice(0, 16);
          if (running.length > 0 && !document.hidden) await renew(running.map((row) => row.id));
        }
      })();
    },
    [filterKey],
  );
  useEffect(() => {
    get<{ methods: { name: string }[] }>("v1/methods").then(({ methods }) => setMethods(methods.map(({ name }) => name)), () => undefined);
  }, []);

  const filter = (name: string, value: string) => go("jobs", { ...filters, [name]: value }, true);
  const cancelShown = () => {
    const { order: _, ...which } = filters;
    const set = Object.values(which).some((value) => value !== "");
    if (!confirm(set ? "Cancel all queued and running jobs that these filters select?" : "Cancel all queued and running jobs?")) return;
    send("POST", `v1/jobs/cancel${queryOf({ ...which, all: set ? undefined : "true" })}`).catch(failed);
  };
  const isFiltered = FILTERS.some((name) => filters[name] !== "");

  return (
    <div class="jobs">
      <h1>Jobs {!connected && <Badge tone="bad">connection lost, trying again</Badge>}</h1>
      <form class="tools" role="search" aria-label="Filters" onSubmit={(e) => e.preventDefault()}>
        <label>
          State{" "}
          <select value={filters.state} onChange={(e) => filter("state", e.currentTarget.value)}>
            <option value="">any</option>
            {STATES.map((state) => (
              <option value={state}>{state}</option>
            ))}
          </select>
        </label>
        <label>
          Method{" "}
          <select value={filters.method} onChange={(e) => filter("method", e.currentTarget.value)}>
            <option value="">any</option>
            {methods.map((method) => (
              <option value={method}>{method}</option>
            ))}
          </select>
        </label>
        <label>
          Label <Typed value={filters.label} placeholder="name:value" take={(text) => filter("label", text)} />
        </label>
        <label>
          Reference <Typed value={filters.external_ref} take={(text) => filter("external_ref", text)} />
        </label>
        <label>
          Order{" "}
          <select value={filters.order} onChange={(e) => filter("order", e.currentTarget.value)}>
            <option value="">newest first</option>
            <option value="asc">oldest first</option>
          </select>
        </label>
        {isFiltered && (
          <button type="button" onClick={() => go("jobs", {}, true)}>
            Clear filters
          </button>
        )}
        <button type="button" onClick={cancelShown}>
          Cancel these …
        </button>
      </form>
      <Failure text={failure} />
      <Table rows={rows} hasMore={token !== undefined} more={isLive && token ? () => void list.current?.more(token) : null} renew={(ids) => void list.current?.renew(ids)} failed={failed} />
      {rows.length === 0 && token === undefined && (
        <p class="empty">
          {isFiltered ? "No job fits these filters." : "There is no job yet."} <a href="#/submit">Submit a pair of surfaces</a>, or the two built-in phantoms.
        </p>
      )}
    </div>
  );
}

/** The rows of a list that are in sight, by their places. */
function useVirtual(count: number, box: { current: HTMLDivElement | null }) {
  const [, draw] = useState(0);
  const virtual = useRef<Virtualizer<HTMLDivElement, Element> | null>(null);
  const options = {
    count,
    getScrollElement: () => box.current,
    estimateSize: () => ROW_PX,
    overscan: 8,
    scrollToFn: elementScroll,
    observeElementRect,
    observeElementOffset,
    onChange: () => draw((n) => n + 1),
  };
  virtual.current ??= new Virtualizer<HTMLDivElement, Element>(options);
  virtual.current.setOptions(options);
  useEffect(() => virtual.current!._didMount(), []);
  useEffect(() => virtual.current!._willUpdate());
  return virtual.current;
}

interface TableProps {
  rows: Row[];
  hasMore: boolean;
  /** Reads further rows, if that can be done now. */
  more: (() => void) | null;
  renew: (ids: string[]) => void;
  failed: (error: unknown) => void;
}

function Table({ rows, hasMore, more, renew, failed }: TableProps) {
  const box = useRef<HTMLDivElement>(null);
  const virtual = useVirtual(rows.length, box);
  const now = useNow();
  const items = virtual.getVirtualItems();
  const last = items.at(-1)?.index ?? 0;
  useEffect(() => {
    if (last >= rows.length - 12) more?.();
  }, [more === null, last, rows.length]);

  const act = (verb: "cancel" | "retry", id: string) => {
    send<Job>("POST", `v1/jobs/${id}/${verb}`).then((answer) => (verb === "retry" ? go(`jobs/${answer.id}`) : renew([id])), failed);
  };
  const setPriority = (id: string, priority: number) => send("PATCH", `v1/jobs/${id}`, { priority }).then(() => renew([id]), failed);
  const keys = (event: KeyboardEvent) => {
    const step = { ArrowDown: 1, j: 1, ArrowUp: -1, k: -1, PageDown: 12, PageUp: -12 }[event.key];
    const target = event.target as HTMLElement;
    if (step === undefined || target.tagName === "INPUT") return;
    const at = Number(target.closest("tr")?.dataset.index ?? -1);
    const next = Math.min(rows.length - 1, Math.max(0, at + step));
    event.preventDefault();
    virtual.scrollToIndex(next);
    const focus = (tries: number) => {
      const link = box.current?.querySelector<HTMLElement>(`tr[data-index="${next}"] a`);
      if (link) link.focus();
      else if (tries > 0) requestAnimationFrame(() => focus(tries - 1));
    };
    requestAnimationFrame(() => focus(10));
  };
  const before = items[0]?.start ?? 0;
  const after = Math.max(0, virtual.getTotalSize() - (items.at(-1)?.end ?? 0));
  return (
    <div class="rows" ref={box} onKeyDown={keys} tabIndex={0} role="region" aria-label="Jobs; arrow keys move from row to row, Enter opens one">
      <table aria-rowcount={hasMore ? -1 : rows.length + 1}>
        <thead>
          <tr>
            <th scope="col">Job</th>
            <th scope="col">State</th>
            <th scope="col">Verdict</th>
            <th scope="col" class="numeric">
              Distance
            </th>
            <th scope="col">Energy</th>
            <th scope="col">Method</th>
            <th scope="col">Age</th>
            <th scope="col">Ran for</th>
            <th scope="col">Priority</th>
            <th scope="col">
              <span class="quiet">Actions</span>
            </th>
          </tr>
        </thead>
        <tbody>
          {before > 0 && <tr aria-hidden="true" style={{ height: `${before}px` }} />}
          {items.map(({ index }) => {
            const row = rows[index];
            if (row === undefined) return null;
            const said = verdictWord(row as Job);
            return (
              <tr key={row.id} data-index={index} data-state={row.state} aria-rowindex={index + 2}>
                <td>
                  <a href={`#/jobs/${row.id}`} title={row.id}>
                    <code>…{shortId(row.id)}</code>
                  </a>{" "}
                  {row.external_ref && <span class="soft">{row.external_ref}</span>}
                  {row.batch_id && (
                    <a class="soft" href={`#/batches/${row.batch_id}`}>
                      batch
                    </a>
                  )}
                </td>
                <td>
                  <State state={row.state} />
                  {row.state === "running" && <Bar share={row.progress?.fraction ?? 0} label={`Progress: ${words(row.progress?.phase ?? "running")}`} />}
                </td>
                <td>{said.text !== "" && <Badge tone={said.tone}>{said.text}</Badge>}</td>
                <td class="numeric">{row.surface_distance ? mm(row.surface_distance.mean_mm) : ""}</td>
                <td>
                  <Spark id={row.id} state={row.state} />
                </td>
                <td>{row.method}</td>
                <td>{age(row.created_at, now)}</td>
                <td>{row.started_at ? duration((row.finished_at ? Date.parse(row.finished_at) : now) - Date.parse(row.started_at)) : ""}</td>
                <td>
                  {row.state === "queued" ? (
                    <Typed
                      class="priority"
                      type="number"
                      min={-100}
                      max={100}
                      value={String(row.priority)}
                      aria-label={`Priority of job ${shortId(row.id)}, −100 to 100, higher first`}
                      take={(text) => void setPriority(row.id, Number(text))}
                    />
                  ) : (
                    row.priority
                  )}
                </td>
                <td>
                  {isFinal(row.state) ? (
                    <button aria-label={`Retry job ${shortId(row.id)}`} onClick={() => act("retry", row.id)}>
                      Retry
                    </button>
                  ) : (
                    <button aria-label={`Cancel job ${shortId(row.id)}`} disabled={row.cancel_requested} onClick={() => act("cancel", row.id)}>
                      Cancel
                    </button>
                  )}
                </td>
              </tr>
            );
          })}
          {after > 0 && <tr aria-hidden="true" style={{ height: `${after}px` }} />}
        </tbody>
      </table>
    </div>
  );
}

const sparks = new Map<string, number[]>();
const MOST_SPARKS = 2_000;

/** The energy of a job as a line of a few pixels; read when the row has been in sight for a moment. */
function Spark({ id, state }: { id: string; state: JobState }) {
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
