// The list of jobs: live, filtered by the address, with as many rows as there are.

import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import { type Job, STATES, describe, get, query as queryOf, send } from "./api";
import { FILTERS, type Filters, SavedFilters } from "./filters";
import { JobTable } from "./jobtable";
import { followChanges, isRefused, newest, pause } from "./live";
import { Badge, Check, Failure, Typed, useKept, useWork } from "./parts";
import { go } from "./router";

/** What a row shows: of 100,000 jobs no more is kept. */
export interface Row
  extends Pick<
    Job,
    "id" | "state" | "method" | "priority" | "progress" | "created_at" | "started_at" | "finished_at" | "reliable" | "unreliable_reasons" | "surface_distance" | "batch_id" | "study_id" | "external_ref" | "cancel_requested" | "tags"
  > {
  /** The surface that tells the job from others of the same template; null if it is too large for a small picture. */
  pictured: "source" | "target" | null;
}

/** A surface of more faces is not loaded for a small picture. */
const MOST_FACES = 60_000;

export const rowOf = (job: Job): Row => {
  const { id, state, method, priority, progress, created_at, started_at, finished_at, reliable, unreliable_reasons, surface_distance, batch_id, study_id, external_ref, cancel_requested, tags } = job;
  // The template of a study is the source of its matches.
  const side = study_id ? "target" : "source";
  const pictured = job.method !== "study_score" && (job[side]?.n_faces ?? Infinity) <= MOST_FACES ? side : null;
  return { id, state, method, priority, progress, created_at, started_at, finished_at, reliable, unreliable_reasons, surface_distance, batch_id, study_id, external_ref, cancel_requested, tags, pictured };
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

/** What the list can be told to do. */
interface List {
  more(from: string): Promise<void>;
  renew(ids: string[]): Promise<void>;
}

export function Jobs({ query }: { query: URLSearchParams }) {
  const filters = Object.fromEntries(FILTERS.map((name) => [name, query.get(name) ?? ""])) as Filters;
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
  const [pictures, setPictures] = useKept("pictures", "yes");

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
          Tag <Typed value={filters.tag} placeholder="name:value" take={(text) => filter("tag", text)} />
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
        <Check label="Pictures" checked={pictures === "yes"} onChange={(e) => setPictures(e.currentTarget.checked ? "yes" : "no")} />
        <SavedFilters filters={filters} isFiltered={isFiltered} />
      </form>
      <Failure text={failure} />
      <JobTable rows={rows} pictures={pictures === "yes"} hasMore={token !== undefined} more={isLive && token ? () => void list.current?.more(token) : null} renew={(ids) => void list.current?.renew(ids)} failed={failed} />
      {rows.length === 0 && token === undefined && (
        <p class="empty">
          {isFiltered ? "No job fits these filters." : "There is no job yet."} <a href="#/submit">Submit a pair of surfaces</a>, or the two built-in phantoms.
        </p>
      )}
    </div>
  );
}
