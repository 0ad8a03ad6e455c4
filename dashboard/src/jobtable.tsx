// The rows of the list of jobs: as many in the document as are in sight, for the pointer and for the keyboard.

import { Virtualizer, elementScroll, observeElementOffset, observeElementRect } from "@tanstack/virtual-core";
import { useEffect, useRef, useState } from "preact/hooks";
import { type Job, call, send } from "./api";
import { age, duration, isFinal, mm, shortId, verdictWord, words } from "./format";
import type { Row } from "./jobs";
import { readPly } from "./pair";
import { Badge, Bar, State, Typed, useNow } from "./parts";
import { Picture, type Subject } from "./pictures";
import { go } from "./router";
import { Spark } from "./spark";

const ROW_PX = 44;

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

/** The surface of a job that tells it from others. */
async function surfaceOf({ id, pictured }: Row, signal: AbortSignal): Promise<Subject> {
  const bytes = await (await call(`v1/jobs/${id}/surfaces/${pictured}?format=ply`, { signal })).arrayBuffer();
  return { geometry: readPly(bytes).geometry };
}

/** The names of a job's files, if they were sent with it. */
export function namesOf({ tags }: Pick<Row, "tags">): string {
  const { source_file: source, target_file: target } = tags;
  return source && target ? `${source} → ${target}` : (source ?? target ?? "");
}

interface TableProps {
  rows: Row[];
  pictures: boolean;
  hasMore: boolean;
  /** Reads further rows, if that can be done now. */
  more: (() => void) | null;
  renew: (ids: string[]) => void;
  failed: (error: unknown) => void;
}

export function JobTable({ rows, pictures, hasMore, more, renew, failed }: TableProps) {
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
    if (event.ctrlKey || event.altKey || event.metaKey) return;
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
  // From the moment that the page is there: before anything has the focus, keys are those of the list.
  const latest = useRef(keys);
  latest.current = keys;
  useEffect(() => {
    const unfocused = (event: KeyboardEvent) => (event.target === document.body || event.target === document.getElementById("main")) && latest.current(event);
    window.addEventListener("keydown", unfocused);
    return () => window.removeEventListener("keydown", unfocused);
  }, []);
  const before = items[0]?.start ?? 0;
  const after = Math.max(0, virtual.getTotalSize() - (items.at(-1)?.end ?? 0));
  return (
    <div class="rows" ref={box} onKeyDown={keys} tabIndex={0} role="region" aria-label="Jobs; arrow keys move from row to row, Enter opens one">
      <table aria-rowcount={hasMore ? -1 : rows.length + 1}>
        <thead>
          <tr>
            <th scope="col">Job</th>
            {pictures && <th scope="col">Shape</th>}
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
            const said = verdictWord(row);
            return (
              <tr key={row.id} data-index={index} data-state={row.state} aria-rowindex={index + 2}>
                <td>
                  <a href={`#/jobs/${row.id}`} title={row.id}>
                    <code>…{shortId(row.id)}</code>
                  </a>{" "}
                  {(row.external_ref || namesOf(row)) && (
                    <span class="soft files" title={[row.external_ref, namesOf(row)].filter(Boolean).join(": ")}>
                      {row.external_ref ?? namesOf(row)}
                    </span>
                  )}
                  {row.batch_id && (
                    <a class="soft" href={`#/batches/${row.batch_id}`}>
                      batch
                    </a>
                  )}
                  {row.study_id && (
                    <a class="soft" href={`#/studies/${row.study_id}`}>
                      study
                    </a>
                  )}
                </td>
                {pictures && <td>{row.state === "succeeded" && row.pictured && <Picture name={`job/${row.id}`} alt={`The ${row.pictured} of ${shortId(row.id)}`} load={(signal) => surfaceOf(row, signal)} />}</td>}
                <td>
                  <State state={row.state} />
                  {row.state === "running" && <Bar share={row.progress?.fraction ?? 0} label={`Progress: ${words(row.progress?.phase ?? "running")}`} />}
                </td>
                <td title={said.text}>{said.text !== "" && <Badge tone={said.tone}>{said.text}</Badge>}</td>
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
