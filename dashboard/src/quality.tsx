// Quality control of a study: whom to look at, the most urgent first, and what was decided about them.

import { useLayoutEffect, useRef, useState } from "preact/hooks";
import type { Job, Study } from "./api";
import { number, type Tone, words } from "./format";
import { Badge } from "./parts";
import { Picture, type Subject } from "./pictures";

export type Verdict = "kept" | "dropped";

export interface Deciding {
  decide(subject: string, decision: Verdict, reason: string): Promise<void>;
  undo(subject: string): Promise<void>;
}

const PLACES: Record<string, { text: string; tone: Tone }> = {
  model: { text: "in the model", tone: "good" },
  scored: { text: "compared with the model", tone: "good" },
  unreliable: { text: "left out: match not reliable", tone: "bad" },
  dropped: { text: "excluded by decision", tone: "neutral" },
  failed: { text: "no match", tone: "bad" },
};

/** What is unusual about a subject, with the reasons of its match. */
function why({ flags = "", reasons = "", error = "" }: Record<string, string>): string {
  const said = flags.split("; ").filter(Boolean);
  const because = [words(reasons).replaceAll(";", ","), error].filter(Boolean).join(", ");
  return said.map((flag, k) => (k === 0 && because !== "" ? `${flag} (${because})` : flag)).join(", ") || because;
}

/** Rows of a page of the table. */
const SHOWN = 100;

interface QualityProps {
  study: Study;
  /** The table of the archive; null until there is one. */
  rows: Record<string, string>[] | null;
  matches: Map<string, Pick<Job, "id" | "state">>;
  deciding: Deciding;
  picture: ((subject: string) => Promise<Subject | null>) | null;
  version: string;
  /** The ends of the colors of the pictures, mm from the mean. */
  top: number;
}

export function Quality({ study, rows, matches, deciding, picture, version, top }: QualityProps) {
  const [open, setOpen] = useState<string | null>(null);
  const [most, setMost] = useState(SHOWN);
  const [flagged, setFlagged] = useState(false);
  const decisions = new Map((study.subjects ?? []).map((subject) => [subject.id, subject]));
  // Until the study is finished there are its subjects, with their matches.
  const all: Record<string, string>[] = rows ?? (study.subjects ?? []).map(({ id }) => ({ id }));
  const shown = all.filter((row) => !flagged || row.flags || decisions.get(row.id!)?.decision);
  if (all.length === 0) return null;
  return (
    <section aria-label="Quality control" class="section">
      <h2>Quality control</h2>
      <div class="tools">
        <span class="hint">{rows === null ? "The subjects and their matches." : `The most urgent first. Pictures: the template deformed onto the subject; red lies outside of the mean (${number(top, 2)} mm or more), blue inside.`}</span>
        {rows !== null && (
          <label class="check">
            <input type="checkbox" checked={flagged} onChange={(e) => setFlagged(e.currentTarget.checked)} /> Only those to look at, or decided
          </label>
        )}
      </div>
      <div class="scroll" tabIndex={0} role="region" aria-label="Subjects">
        <table class="quality">
          <thead>
            <tr>
              <th scope="col">Subject</th>
              {rows !== null && (
                <>
                  <th scope="col">Shape</th>
                  <th scope="col">Place</th>
                  <th scope="col">Look at</th>
                  <th scope="col" class="numeric">
                    Residual, mm
                  </th>
                  <th scope="col" class="numeric">
                    Turned over, %
                  </th>
                  <th scope="col" class="numeric">
                    Unusual, p
                  </th>
                </>
              )}
              <th scope="col">Match</th>
              <th scope="col">Decision</th>
            </tr>
          </thead>
          <tbody>
            {shown.slice(0, most).map((row) => {
              const id = row.id!;
              const match = matches.get(id);
              const place = PLACES[row.place ?? ""];
              // Of a study whose subjects are not sent with it, what the table says.
              const known = decisions.get(id) ?? { decision: row.decision || undefined, reason: row.reason };
              const isMatched = row.place !== "failed";
              return (
                <tr key={id} data-subject={id} data-place={row.place}>
                  <th scope="row">{id}</th>
                  {rows !== null && (
                    <>
                      <td>{picture && isMatched && <Picture name={`${version}/${id}`} alt={`Shape of ${id}`} load={() => picture(id)} />}</td>
                      <td>{place && <Badge tone={place.tone}>{place.text}</Badge>}</td>
                      <td class="why">{why(row)}</td>
                      <td class="numeric">{isMatched ? Number(row.residual_mm).toFixed(3) : ""}</td>
                      <td class="numeric">{isMatched ? (100 * Number(row.folded)).toFixed(2) : ""}</td>
                      <td class="numeric">{row.mahalanobis_p ? number(Number(row.mahalanobis_p), 2) : ""}</td>
                    </>
                  )}
                  <td>{match && <a href={`#/jobs/${match.id}`}>{match.state}</a>}</td>
                  <td class="decision">
                    {open === id ? (
                      <Decide
                        subject={id}
                        cancel={() => setOpen(null)}
                        decide={async (verdict, reason) => {
                          await deciding.decide(id, verdict, reason);
                          setOpen(null);
                        }}
                      />
                    ) : known?.decision ? (
                      <>
                        <Badge tone={known.decision === "kept" ? "good" : "neutral"}>{known.decision === "kept" ? "keep" : "exclude"}</Badge> {known.reason}{" "}
                        <button aria-label={`Take back the decision about ${id}`} onClick={() => void deciding.undo(id).catch(() => undefined)}>
                          Take back
                        </button>
                      </>
                    ) : (
                      <button aria-label={`Decide about ${id}`} onClick={() => setOpen(id)}>
                        Decide …
                      </button>
                    )}
                  </td>
                </tr>
              );
            })}
          </tbody>
        </table>
      </div>
      {shown.length === 0 && <p class="empty">Nobody is to be looked at.</p>}
      {shown.length > most && (
        <button onClick={() => setMost(most + SHOWN)}>
          Further {number(Math.min(SHOWN, shown.length - most))} of {number(shown.length)}
        </button>
      )}
    </section>
  );
}

function Decide({ subject, decide, cancel }: { subject: string; decide: (verdict: Verdict, reason: string) => Promise<void>; cancel: () => void }) {
  const [verdict, setVerdict] = useState<Verdict>("dropped");
  const [reason, setReason] = useState("");
  const [isSending, setSending] = useState(false);
  const first = useRef<HTMLSelectElement>(null);
  useLayoutEffect(() => first.current?.focus(), []);
  const send = async (event: Event) => {
    event.preventDefault();
    setSending(true);
    // What went wrong is said at the head of the page.
    await decide(verdict, reason.trim()).catch(() => setSending(false));
  };
  return (
    <form class="tools" aria-label={`Decision about ${subject}`} onSubmit={send} onKeyDown={(e) => e.key === "Escape" && cancel()}>
      <select aria-label="Decision" value={verdict} ref={first} onChange={(e) => setVerdict(e.currentTarget.value as Verdict)}>
        <option value="dropped">exclude</option>
        <option value="kept">keep</option>
      </select>
      <input aria-label="Reason" placeholder="reason" required value={reason} onInput={(e) => setReason(e.currentTarget.value)} />
      <button class="primary" type="submit" disabled={isSending}>
        Save
      </button>
      <button type="button" onClick={cancel}>
        Cancel
      </button>
    </form>
  );
}
