// Studies: what is computed of each group, and how far it is.

import { useState } from "preact/hooks";
import { type Study, type StudyState, describe, get, query as queryOf } from "./api";
import { age, number, shortId, type Tone } from "./format";
import { pause } from "./live";
import { Badge, Bar, Failure, useNow, useWork } from "./parts";

const TONES: Record<StudyState, Tone> = { queued: "wait", matching: "wait", modelling: "wait", finished: "good", failed: "bad", cancelled: "neutral" };

export const StudyBadge = ({ state }: { state: StudyState }) => <Badge tone={TONES[state]}>{state === "modelling" ? "modeling" : state}</Badge>;

export const isOver = (state: StudyState): boolean => state === "finished" || state === "failed" || state === "cancelled";

/** How far a study is, in words. */
export function stage({ state, progress }: Study): string {
  const { template_round: round, matches_done: done, matches_total: total } = progress;
  if (state === "queued") return "waits for a worker";
  if (state === "modelling") return "computes the shape model and the statistics";
  if (state === "matching") return `${round > 0 ? `makes the template, round ${round}` : "matches the subjects"}: ${number(done)} of ${number(total)}`;
  return state;
}

export function Studies() {
  const [studies, setStudies] = useState<Study[]>([]);
  const [token, setToken] = useState<string | undefined>();
  const [failure, setFailure] = useState<string | null>(null);
  const [isLoaded, setLoaded] = useState(false);
  const now = useNow();
  const load = async (from: string | undefined, signal?: AbortSignal) => {
    try {
      const page = await get<{ studies: Study[]; next_page_token?: string }>(`v1/studies${queryOf({ page_size: 50, page_token: from })}`, signal);
      setStudies((before) => (from === undefined ? page.studies : [...before, ...page.studies]));
      setToken(page.next_page_token);
      setFailure(null);
      setLoaded(true);
    } catch (error) {
      if (!signal?.aborted) setFailure(describe(error));
    }
  };
  useWork((signal) => {
    void (async () => {
      await load(undefined, signal);
      while (!signal.aborted) {
        await pause(3_000, signal);
        if (!signal.aborted && !document.hidden && scrollY < 200) await load(undefined, signal);
      }
    })();
  }, []);
  return (
    <div>
      <h1>Studies</h1>
      <Failure text={failure} />
      {isLoaded && studies.length === 0 && (
        <p class="empty">
          There is no study yet. <code>POST /v1/studies</code> or <code>homolog study</code> begins one; <a href="docs/">the API</a> says how.
        </p>
      )}
      {studies.length > 0 && (
        <div class="scroll" tabIndex={0} role="region" aria-label="Studies">
          <table>
            <thead>
              <tr>
                <th scope="col">Study</th>
                <th scope="col">State</th>
                <th scope="col">Progress</th>
                <th scope="col" class="numeric">
                  Subjects
                </th>
                <th scope="col">Method</th>
                <th scope="col">Tags</th>
                <th scope="col">Age</th>
              </tr>
            </thead>
            <tbody>
              {studies.map((study) => (
                <tr key={study.id}>
                  <td>
                    <a href={`#/studies/${study.id}`}>{study.external_ref ?? `…${shortId(study.id)}`}</a>
                  </td>
                  <td>
                    <StudyBadge state={study.state} />
                  </td>
                  <td>
                    {study.state === "matching" && <Bar share={study.progress.matches_done / Math.max(1, study.progress.matches_total)} label={`Progress of ${study.external_ref ?? shortId(study.id)}`} />}
                    {!isOver(study.state) && <span class="soft">{stage(study)}</span>}
                    {study.error && <span class="soft">{study.error.title}</span>}
                  </td>
                  <td class="numeric">{number(study.n_subjects)}</td>
                  <td>{study.method}</td>
                  <td>{Object.entries(study.tags).map(([name, value]) => `${name}:${value}`).join(", ")}</td>
                  <td>{age(study.created_at, now)}</td>
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
