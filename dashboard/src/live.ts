// What keeps the page up to date: the events of one job, and the changes of all jobs.

import { EventSourceParserStream } from "eventsource-parser/stream";
import { ApiError, call, get, type Job, type JobState, type TracePoint } from "./api";
import { isFinal } from "./format";

export interface Follower {
  job(job: Job): void;
  trace(points: TracePoint[]): void;
  progress(progress: NonNullable<Job["progress"]>): void;
  /** Whether events arrive. */
  connected(is: boolean): void;
  failed(error: unknown): void;
}

/**
 * What is known of a job after `next` has arrived. Answers and events overtake each other, and a finished state never changes: what
 * says otherwise was written before. A request to cancel is never taken back either.
 */
export function newest<T extends Pick<Job, "id" | "state" | "cancel_requested">>(known: T | null | undefined, next: T): T {
  if (!known || known.id !== next.id) return next;
  if (isFinal(known.state) && !isFinal(next.state)) return known;
  return known.cancel_requested && !next.cancel_requested ? { ...next, cancel_requested: true } : next;
}

export const pause = (ms: number, signal: AbortSignal): Promise<void> =>
  new Promise((resolve) => {
    const over = () => {
      clearTimeout(timer);
      signal.removeEventListener("abort", over);
      resolve();
    };
    const timer = setTimeout(over, ms);
    signal.addEventListener("abort", over);
  });

/** Whether the service has refused, so that asking again is in vain: not a lost connection, nor a service that is busy or down. */
export const isRefused = (error: unknown): boolean => error instanceof ApiError && error.problem.status < 500 && error.problem.status !== 429;

/** What `ask` answers: asked again after a lost connection, until the service answers or refuses. */
export async function answered<T>(ask: () => Promise<T>, signal: AbortSignal): Promise<T> {
  for (let wait = 500; ; wait = Math.min(wait * 2, 8_000)) {
    try {
      return await ask();
    } catch (error) {
      if (signal.aborted || isRefused(error)) throw error;
    }
    await pause(wait, signal);
    signal.throwIfAborted();
  }
}

/** Longest silence of a stream: the service sends a comment every 15 s. */
const SILENCE_MS = 40_000;

/** Longest time of reading events before the page may do something else. */
const TURN_MS = 30;

/**
 * Follows a job by its events until it ends. An `EventSource` could send no key, so the stream is read here; after a loss of
 * the connection it goes on behind the last event that arrived, so that no point of the trace is lost or repeated.
 */
export async function follow(id: string, to: Follower, signal: AbortSignal): Promise<void> {
  let last: string | undefined;
  let seen = 0;
  let wait = 500;
  while (!signal.aborted) {
    const attempt = new AbortController();
    const stop = () => attempt.abort();
    signal.addEventListener("abort", stop, { once: true });
    let silence = 0;
    try {
      const headers: HeadersInit = { accept: "text/event-stream" };
      if (last !== undefined) headers["last-event-id"] = last;
      const response = await call(`v1/jobs/${id}/events?fields=*`, { headers, signal: attempt.signal, cache: "no-store" });
      if (response.status === 204 || response.body === null) return;
      to.connected(true);
      wait = 500;
      const watch = () => {
        clearTimeout(silence);
        silence = window.setTimeout(stop, SILENCE_MS);
      };
      const heard = new TransformStream<Uint8Array, Uint8Array>({
        transform(chunk, controller) {
          watch();
          controller.enqueue(chunk);
        },
      });
      const decoder = new TextDecoderStream() as unknown as ReadableWritablePair<string, Uint8Array>;
      const events = response.body.pipeThrough(heard).pipeThrough(decoder).pipeThrough(new EventSourceParserStream());
      const reader = events.getReader();
      let began = performance.now();
      for (;;) {
        const { done, value } = await reader.read();
        if (done) break;
        // What has arrived already is read without a pause: a long trace would hold up the page.
        if (performance.now() - began > TURN_MS) {
          await pause(0, attempt.signal);
          began = performance.now();
        }
        if (value.id !== undefined) last = value.id;
        const data = JSON.parse(value.data);
        if (value.event === "trace") {
          const point = data as TracePoint;
          if (point.seq > seen) {
            seen = point.seq;
            to.trace([point]);
          }
        } else if (value.event === "progress") {
          to.progress(data.progress ?? data);
        } else {
          to.job(data as Job);
          if (value.event === "done") return;
        }
      }
    } catch (error) {
      if (signal.aborted) return;
      if (isRefused(error)) {
        to.failed(error);
        return;
      }
    } finally {
      clearTimeout(silence);
      signal.removeEventListener("abort", stop);
    }
    to.connected(false);
    await pause(wait, signal);
    wait = Math.min(wait * 2, 8_000);
  }
}

export interface Change {
  seq: number;
  job_id: string;
  batch_id?: string;
  state: JobState;
}

interface Changes {
  changes: Change[];
  next_since: number;
}

/**
 * Tells of every change of a job's state, by long polls. Which changes come later is found out first, and `begin` reads the state of
 * things only then: read before, it would lack the changes between the two, of which nothing tells.
 */
export async function followChanges(
  begin: () => Promise<void>,
  told: (changes: Change[]) => void,
  connected: (is: boolean) => void,
  signal: AbortSignal,
): Promise<void> {
  let since: number | undefined;
  let wait = 500;
  while (!signal.aborted) {
    try {
      if (since === undefined) {
        const latest = await latestChange(signal);
        await begin();
        since = latest;
      }
      const page: Changes = await get<Changes>(`v1/changes?since=${since}&wait=20`, signal);
      connected(true);
      wait = 500;
      since = page.next_since;
      if (page.changes.length > 0) told(page.changes);
    } catch (error) {
      if (signal.aborted) return;
      connected(false);
      if (error instanceof ApiError && error.problem.status === 401) return;
      // Reading goes on behind the last change that was told, so that none is missed.
      await pause(wait, signal);
      wait = Math.min(wait * 2, 8_000);
    }
  }
}

/** The number of the last change, 0 if there is none: found by halving, since the feed is read from its beginning only. */
async function latestChange(signal: AbortSignal): Promise<number> {
  const isAfter = async (since: number): Promise<boolean> =>
    (await get<Changes>(`v1/changes?since=${since}&limit=1`, signal)).changes.length > 0;
  let [low, high] = [-1, 0];
  while (await isAfter(high)) [low, high] = [high, Math.max(1, high * 4)];
  while (high - low > 1) {
    const middle = Math.floor((low + high) / 2);
    if (await isAfter(middle)) low = middle;
    else high = middle;
  }
  return high;
}
