// The score of a new subject against the group of a study.

import { useState } from "preact/hooks";
import { type Job, describe, get } from "./api";
import { number, words } from "./format";
import { answered } from "./live";
import { Facts, Failure, useWork } from "./parts";

interface Score {
  within: { covariate: string; level: string } | null;
  members: number;
  reliable: boolean | null;
  reasons: string[];
  unusual_p: number;
  largest_score: number;
  largest_score_p: number;
  bound: { score: number; level: number };
  regions: { vertices: number; area_mm2: number; peak_mm: [number, number, number]; score: number; deviation_mm: number }[];
}

export const isScore = (job: Pick<Job, "method">) => job.method === "study_score";

export function ScoreView({ job }: { job: Job }) {
  const [score, setScore] = useState<Score | null>(null);
  const [failure, setFailure] = useState<string | null>(null);
  const link = job.links.score?.slice(1);
  useWork(
    (signal) => {
      if (link === undefined) return;
      answered(() => get<Score>(link, signal), signal).then(
        (found) => !signal.aborted && setScore(found),
        (error: unknown) => !signal.aborted && setFailure(describe(error)),
      );
    },
    [link],
  );
  if (failure !== null) return <Failure text={failure} />;
  if (score === null) return <p class="loading">Loading the score …</p>;
  const match = score.reliable === null ? "not checked" : score.reliable ? "reliable" : `not reliable: ${score.reasons.map(words).join(", ")}`;
  return (
    <section class="card" aria-label="Score">
      <h2>Against the group</h2>
      <Facts
        rows={[
          ["Compared with", `${number(score.members)} members${score.within ? ` with ${score.within.covariate} ${score.within.level}` : ""}`],
          ["Match with the template", match],
          ["p of a shape as unusual", score.unusual_p.toFixed(3)],
          ["Largest score, in standard deviations", `${score.largest_score.toFixed(2)} (p ${score.largest_score_p.toFixed(3)})`],
          [`Bound of the screening, at ${score.bound.level}`, score.bound.score.toFixed(2)],
          ["Regions beyond the bound", number(score.regions.length)],
        ]}
      />
      {score.regions.length > 0 && (
        <table>
          <thead>
            <tr>
              <th scope="col">area, mm²</th>
              <th scope="col">vertices</th>
              <th scope="col">largest score</th>
              <th scope="col">deviation there, mm</th>
              <th scope="col">place, mm</th>
            </tr>
          </thead>
          <tbody>
            {score.regions.map((region) => (
              <tr>
                <td>{region.area_mm2.toFixed(1)}</td>
                <td>{number(region.vertices)}</td>
                <td>{region.score.toFixed(2)}</td>
                <td>{region.deviation_mm.toFixed(2)}</td>
                <td>{region.peak_mm.map((x) => x.toFixed(1)).join(", ")}</td>
              </tr>
            ))}
          </tbody>
        </table>
      )}
    </section>
  );
}
