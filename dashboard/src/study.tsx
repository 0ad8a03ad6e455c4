// A study: how far it is, whom to look at, what was decided, and what it found.

import { useState } from "preact/hooks";
import { type Job, type Study, type StudyResult, describe, download, get, open, query as queryOf, send } from "./api";
import { readCsv } from "./csv";
import { age, number, words } from "./format";
import type { Page } from "./jobs";
import { answered, pause } from "./live";
import { Maps, Modes } from "./maps";
import { frameLike } from "./pair";
import { Bar, Facts, Failure, useNow, useWork } from "./parts";
import { type Deciding, Quality, type Verdict } from "./quality";
import { isOver, stage, StudyBadge } from "./studies";
import { readVtk, type Valued } from "./vtk";
import { Archive } from "./zip";

/** What is read of a finished study. */
interface Found {
  archive: Archive;
  result: StudyResult;
  mean: Valued;
  /** The table of quality control, the most urgent first. */
  rows: Record<string, string>[];
  /** Names what was computed: another one after each decision. */
  version: string;
}

type Match = Pick<Job, "id" | "state" | "external_ref">;

/** The newest match of each subject. */
async function matchesOf(id: string, signal: AbortSignal): Promise<Map<string, Match>> {
  const found = new Map<string, Match>();
  let token: string | undefined = "";
  while (token !== undefined) {
    const page: Page = await get<Page>(`v1/jobs${queryOf({ study: id, order: "asc", fields: "id,state,external_ref", page_size: 500, page_token: token })}`, signal);
    for (const job of page.jobs) if (job.external_ref) found.set(job.external_ref, job);
    token = page.next_page_token;
  }
  return found;
}

export function StudyView({ id }: { id: string }) {
  const [study, setStudy] = useState<Study | null>(null);
  const [matches, setMatches] = useState(new Map<string, Match>());
  const [found, setFound] = useState<Found | null>(null);
  const [failure, setFailure] = useState<string | null>(null);
  /** Counts what was asked of the study: each time its state is followed anew. */
  const [asked, setAsked] = useState(0);
  const failed = (error: unknown) => setFailure(describe(error));
  const now = useNow();

  useWork(
    (signal) => {
      void (async () => {
        try {
          for (;;) {
            const next = await answered(() => get<Study>(`v1/studies/${id}`, signal), signal);
            setStudy(next);
            setMatches(await answered(() => matchesOf(id, signal), signal));
            if (isOver(next.state)) break;
            // The matches of a large study are many answers.
            await pause(Math.max(2_000, 4 * next.n_subjects), signal);
            signal.throwIfAborted();
          }
        } catch (error) {
          if (!signal.aborted) failed(error);
        }
      })();
    },
    [id, asked],
  );
  const version = study?.state === "finished" ? `${id}/${study.finished_at}` : null;
  useWork(
    (signal) => {
      if (version === null) return;
      void (async () => {
        try {
          const [archive, result] = await Promise.all([
            answered(() => Archive.open(`v1/studies/${id}/archive`), signal),
            answered(() => get<StudyResult>(`v1/studies/${id}/result`, signal), signal),
          ]);
          const [rows, mean] = [readCsv(await archive.text("quality.csv")), readVtk(await archive.bytes("mean.vtk"))];
          if (!signal.aborted) setFound({ archive, result, mean, rows, version });
        } catch (error) {
          if (!signal.aborted) failed(error);
        }
      })();
    },
    [version],
  );
  if (study === null) return failure === null ? <p class="loading">Loading the study …</p> : <Failure text={failure} />;

  const act = (ask: Promise<Study>): Promise<void> => {
    setFailure(null);
    return ask.then(
      (answer) => {
        setStudy((before) => ({ ...before, ...answer }));
        setAsked((n) => n + 1);
      },
      (error: unknown) => {
        failed(error);
        throw error;
      },
    );
  };
  const decisionOf = (subject: string) => `v1/studies/${id}/subjects/${encodeURIComponent(subject)}/decision`;
  const deciding: Deciding = {
    decide: (subject: string, decision: Verdict, reason: string) => act(send<Study>("PUT", decisionOf(subject), { decision, reason })),
    undo: (subject: string) => act(send<Study>("DELETE", decisionOf(subject))),
  };
  const name = study.external_ref ?? id.slice(-8);
  return (
    <article class="study">
      <h1 class="sub">
        Study {study.external_ref ?? <code>{id}</code>} <StudyBadge state={study.state} />
      </h1>
      <Summary study={study} found={found} cancel={() => void act(send<Study>("POST", `v1/studies/${id}/cancel`)).catch(() => undefined)} />
      <Failure text={failure} />
      <div class="columns">
        <Steps study={study} matches={matches} hasResult={found !== null} />
        <section class="card">
          <h2>The study</h2>
          <Facts
            rows={[
              ["Subjects", number(study.n_subjects)],
              ["Method of the matches", study.method],
              ...settings(found?.result),
              ["Created", `${new Date(study.created_at).toLocaleString()}, ${age(study.created_at, now)} ago`],
              ...(study.finished_at ? [["Finished", new Date(study.finished_at).toLocaleString()] as [string, string]] : []),
              ...Object.entries(study.tags).map(([name, value]): [string, string] => [`Tag ${name}`, value]),
            ]}
          />
        </section>
        {study.state === "finished" && (
          <section class="card">
            <h2>Report and files</h2>
            <div class="saves">
              <button onClick={() => open(`v1/studies/${id}/report`, true).catch(failed)}>Open the report</button>
              <button onClick={() => open(`v1/studies/${id}/archive`, false).catch(failed)}>Save the archive, ZIP</button>
              <button onClick={() => download(`v1/studies/${id}/result`, `study-${name}.json`).catch(failed)}>Save the result, JSON</button>
            </div>
            <p class="soft">The report is one page to print; the archive has all tables, surfaces, maps, modes and labels.</p>
          </section>
        )}
      </div>
      <Quality study={study} rows={found?.rows ?? null} matches={matches} deciding={deciding} top={found ? spreadOf(found.result) : 0} picture={found && (async (subject) => (version === found.version ? pictureOf(found, subject) : null))} version={found?.version ?? id} />
      {found !== null && (
        <>
          <section class="card section" aria-label="Maps">
            <h2>Maps on the mean surface</h2>
            <Maps key={found.version} archive={found.archive} result={found.result} name={`study-${name}`} />
          </section>
          <section class="card section" aria-label="Modes">
            <h2>Modes of the shape model</h2>
            <Modes key={found.version} archive={found.archive} result={found.result} name={`study-${name}`} />
          </section>
        </>
      )}
    </article>
  );
}

function settings(result: StudyResult | undefined): [string, string][] {
  const analysis = result?.settings.analysis;
  if (!analysis) return [];
  return [
    ["Effect", analysis.effect ?? "none asked for"],
    ...(analysis.adjust?.length ? [["Adjusted for", analysis.adjust.join(", ")] as [string, string]] : []),
    ...(analysis.effect && analysis.permutations ? [["Permutations", number(analysis.permutations)] as [string, string]] : []),
  ];
}

/** Twice how far the surface of a subject lies from the mean, as a root mean square over all. */
const spreadOf = ({ found }: StudyResult): number => 2 * Math.sqrt(found.model.variances_mm2.reduce((sum, variance) => sum + variance, 0)) || 1;

/** The bent template of a subject in the colors of its displacement from the mean, turned as the mean is seen. */
async function pictureOf({ archive, mean, result }: Found, subject: string) {
  const file = `subjects/${subject}.vtk`;
  if (!archive.has(file)) return null;
  const { geometry, arrays } = readVtk(await archive.bytes(file));
  const values = arrays.normal_displacement;
  const top = spreadOf(result);
  return { geometry, frame: frameLike(geometry, mean.geometry), coloring: values && { values, low: -top, high: top, map: "blue_red" as const } };
}

function Summary({ study, found, cancel }: { study: Study; found: Found | null; cancel: () => void }) {
  const isDone = study.state === "finished";
  const open = (found?.rows ?? []).filter((row) => row.flags !== "" && row.decision === "").length;
  const counts = found?.result.found.subjects;
  const parts = counts && [
    `${number(counts.model)} in the shape model`,
    ...(counts.scored ? [`${number(counts.scored)} compared with it`] : []),
    ...(counts.unreliable ? [`${number(counts.unreliable)} left out: match not reliable`] : []),
    ...(counts.dropped ? [`${number(counts.dropped)} excluded by decision`] : []),
    ...(counts.failed ? [`${number(counts.failed)} without a match`] : []),
  ];
  const tone = study.state === "failed" || (isDone && open > 0) ? "bad" : isDone ? "good" : study.state === "cancelled" ? "neutral" : "wait";
  const said = stage(study);
  const title = isDone ? (found === null ? "Finished" : open > 0 ? `${number(open)} of ${number(study.n_subjects)} to look at` : "No subject stands out") : said[0]!.toUpperCase() + said.slice(1);
  const next = isDone
    ? open > 0
      ? "Look at the subjects at the head of the table; exclude those that are wrong, and keep those that are right."
      : "Look at the maps, then open the report."
    : study.state === "failed"
      ? "Correct what is said above, or add subjects, and submit it again."
      : study.state === "cancelled"
        ? "Submit it again; matches that are finished are not computed twice."
        : "Quality control, maps and modes appear here when it is finished.";
  return (
    <section class={`verdict ${tone}`} aria-label="Verdict">
      <span class="mark" aria-hidden="true">
        {{ good: "✓", bad: "✕", neutral: "–", wait: "…" }[tone]}
      </span>
      <div role="status">
        <p class="title" id="verdict">
          {title}
        </p>
        {isDone && parts && <p>{parts.join(", ")}.</p>}
        {study.error && <p>{[study.error.title, study.error.detail].filter(Boolean).join(": ")}</p>}
        <p class="next">
          <b>Next:</b> {next}
        </p>
      </div>
      <div class="actions">{!isOver(study.state) && <button onClick={cancel}>Cancel</button>}</div>
    </section>
  );
}

type Step = "done" | "now" | "to come" | "not reached";

/** The steps of a study, and the states of its matches. */
function Steps({ study, matches, hasResult }: { study: Study; matches: Map<string, Match>; hasResult: boolean }) {
  const { state, progress } = study;
  const at = state === "finished" ? 3 : state === "modelling" ? 2 : state === "matching" && progress.template_round === 0 ? 1 : 0;
  const stopped = state === "failed" || state === "cancelled";
  const of = (k: number): Step => (stopped ? (hasResult ? "done" : "not reached") : k < at ? "done" : k === at ? "now" : "to come");
  const steps: [string, Step][] = [
    [progress.template_round > 0 ? `Template, round ${progress.template_round}` : "Template", of(0)],
    ["Matches with all subjects", of(1)],
    ["Shape model, statistics and report", of(2)],
  ];
  const counts = new Map<string, number>();
  for (const { state } of matches.values()) counts.set(state, (counts.get(state) ?? 0) + 1);
  return (
    <section class="card">
      <h2>Steps and matches</h2>
      <ol class="steps">
        {steps.map(([name, step]) => (
          <li class={step.replace(" ", "-")} aria-current={step === "now" ? "step" : undefined}>
            {name}: <b>{step}</b>
          </li>
        ))}
      </ol>
      {state === "matching" && (
        <p>
          <Bar share={progress.matches_done / Math.max(1, progress.matches_total)} label="Matches that are finished" /> {number(progress.matches_done)} of {number(progress.matches_total)}
        </p>
      )}
      <p id="matches">
        {[...counts].map(([state, n]) => `${number(n)} ${words(state)}`).join(", ") || "No match yet"}. <a href={`#/jobs?study=${study.id}`}>All matches</a>
      </p>
    </section>
  );
}
