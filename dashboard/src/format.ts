// Numbers, times and words for people.

import type { Job, JobState } from "./api";

export function number(value: number | null | undefined, digits = 3): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  return Number.isInteger(value) ? value.toLocaleString("en") : value.toLocaleString("en", { maximumSignificantDigits: digits });
}

export const mm = (value: number | null | undefined): string => (value === null || value === undefined ? "–" : `${value.toFixed(2)} mm`);

export const percent = (share: number): string => `${(100 * share).toFixed(share > 0.995 || share < 0.1 ? 1 : 0)} %`;

export function duration(ms: number): string {
  if (ms < 1000) return `${Math.round(ms)} ms`;
  const seconds = ms / 1000;
  if (seconds < 60) return `${seconds.toFixed(1)} s`;
  if (seconds < 3600) return `${Math.floor(seconds / 60)} min ${Math.round(seconds % 60)} s`;
  if (seconds < 86_400) return `${Math.floor(seconds / 3600)} h ${Math.round((seconds % 3600) / 60)} min`;
  return `${Math.floor(seconds / 86_400)} d ${Math.round((seconds % 86_400) / 3600)} h`;
}

export const age = (time: string, now: number): string => {
  const ms = now - Date.parse(time);
  return ms < 1000 ? "now" : duration(Math.floor(ms / 1000) * 1000).replace(".0 s", " s");
};

export const bytes = (n: number): string =>
  n < 1024 ? `${n} B` : n < 1 << 20 ? `${(n / 1024).toFixed(1)} KiB` : n < 1 << 30 ? `${(n / (1 << 20)).toFixed(1)} MiB` : `${(n / (1 << 30)).toFixed(1)} GiB`;

/** `surface_distance` as it is read aloud. */
export const words = (name: string): string => name.replaceAll("_", " ");

export const isFinal = (state: JobState): boolean => state !== "queued" && state !== "running";

export const shortId = (id: string): string => id.slice(-8);

/** Why an answer is not reliable, and what to check; as in docs/results.md. */
export const REASONS: Record<string, { meaning: string; check: string }> = {
  unlike_shape: {
    meaning: "One surface is drawn out far to become the other, compared with how well curvatures of corresponding points agree.",
    check: "Do both files show the same structure? Is a part of one missing?",
  },
  other_handedness: {
    meaning: "A mirrored source fits better.",
    check: "Is one file a left structure and the other a right one, or does an image have a flipped axis?",
  },
  uncertain_side: {
    meaning: "A file states two orientations of different handedness: left and right may be exchanged.",
    check: "Which orientation of the file is right? Write it into both places (sform and qform).",
  },
  units_differ: {
    meaning: "The sizes differ by the ratio of two units of length.",
    check: "Are both files in millimeters? Scale one of them, or state its unit in the file.",
  },
  ambiguous_pose: {
    meaning: "A different pose fits as well.",
    check: "Is the shape nearly symmetric? Landmarks resolve it: submit again with a few corresponding points.",
  },
  piece_dropped: {
    meaning: "A structure is in several pieces, and one that was dropped has 5 % or more of its volume.",
    check: "Are left and right one label, or several structures? Choose the labels of one, or name the repair largest_component.",
  },
  labels_joined: {
    meaning: "Several labels of one input were joined, and the other input has other labels.",
    check: "Which labels are the structure? Submit again with them.",
  },
  cavity_filled: {
    meaning: "A structure had cavities of 5 % or more of its volume, or closing them and its tunnels changed as much.",
    check: "Is the label a wall around something else? Name the repair fill to confirm that the inside belongs to it.",
  },
  second_opinion: {
    meaning: "The default method finds another pose for these surfaces, or other corresponding points.",
    check: "Which of the two answers is right? Submit again with the method balanced, and look at both.",
  },
  too_coarse: {
    meaning: "The voxels are so large for the structure that they leave its rotation uncertain.",
    check: "Is there a segmentation of smaller voxels? Interpolating this one adds nothing.",
  },
};

export type Tone = "good" | "bad" | "wait" | "neutral";

export interface VerdictText {
  tone: Tone;
  mark: string;
  title: string;
  lines: string[];
  next: string;
}

/** Whether a mirrored source fits better, and the service can mirror it. */
function isMirrored(job: Job): boolean {
  const input = job.parameters?.input as { source?: { mirror?: unknown } } | undefined;
  return (job.unreliable_reasons ?? []).includes("other_handedness") && input?.source?.mirror === false;
}

/** The verdict on a job, for whoever has to keep or drop the match. */
export function verdict(job: Job): VerdictText {
  if (job.state === "succeeded") {
    if (job.method === "study_score") {
      return {
        tone: "neutral",
        mark: "=",
        title: "Scored against its study",
        lines: ["The subject was matched to the template of the study and compared with its group; both inputs below are the subject."],
        next: "Look first whether its match is reliable, then at the p of its shape and at the regions beyond the bound.",
      };
    }
    if (job.reliable === true) {
      const distance = job.surface_distance ? `The registered surfaces are ${mm(job.surface_distance.mean_mm)} apart on average.` : "";
      return {
        tone: "good",
        mark: "✓",
        title: "Reliable",
        lines: [`${job.method === "balanced" ? "No check found a fault." : "No check found a fault, and the default method finds the same."} ${distance}`, ...(job.warnings ?? [])],
        next: "Look for colors that jump in the picture below; if there are none, keep this match.",
      };
    }
    if (job.reliable === false) {
      const reasons = (job.unreliable_reasons ?? []).map((name) => REASONS[name] ?? { meaning: words(name), check: "" });
      return {
        tone: "bad",
        mark: "✕",
        title: "Not reliable",
        lines: [...reasons.map((reason) => reason.meaning), ...(job.warnings ?? [])],
        next: [...reasons.map((reason) => reason.check), ...(isMirrored(job) ? ["If so, submit it again with input.source.mirror: true, which mirrors the source."] : [])].join(" "),
      };
    }
    return {
      tone: "neutral",
      mark: "?",
      title: "Not checked",
      lines: ["No displacement field could be fitted, which the checks are made of.", ...(job.warnings ?? [])],
      next: job.method === "balanced" ? "Judge by the picture: where colors jump or the grid breaks, the match is wrong." : "Judge by the picture, or match again with the method balanced, whose answer beside this one is the check.",
    };
  }
  const running: Partial<Record<JobState, VerdictText>> = {
    queued: {
      tone: "wait",
      mark: "…",
      title: "Waiting",
      lines: [job.queue_position ? `Number ${job.queue_position} in the queue.` : "In the queue."],
      next: "It starts when a worker is free.",
    },
    running: {
      tone: "wait",
      mark: "…",
      title: job.cancel_requested ? "Being cancelled" : "Running",
      lines: [job.eta_ms ? `About ${duration(job.eta_ms)} left.` : "The verdict comes with the result."],
      next: "The energy below says what it minimizes at present; whether the match is right, the verdict says at the end.",
    },
    cancelled: { tone: "neutral", mark: "–", title: "Cancelled", lines: ["It has no result."], next: "Submit it again with Retry." },
    expired: {
      tone: "bad",
      mark: "✕",
      title: "Expired",
      lines: ["It had not started by its deadline."],
      next: "Submit it again with Retry, or with a later deadline.",
    },
  };
  const known = running[job.state];
  if (known) return known;
  return {
    tone: "bad",
    mark: "✕",
    title: job.state === "dead" ? "Given up" : "Failed",
    lines: [[job.error?.title, job.error?.detail].filter(Boolean).join(": ") || "It has no result."],
    next: job.state === "dead" ? "Its workers crashed too often. Retry once; if it fails again, report it." : "Correct the input, then submit it again.",
  };
}

/** The verdict in one word, for tables. */
export function verdictWord(job: Pick<Job, "state" | "reliable" | "unreliable_reasons">): { tone: Tone; text: string } {
  if (job.state !== "succeeded") return { tone: "neutral", text: "" };
  if (job.reliable === true) return { tone: "good", text: "✓ reliable" };
  const [first, ...more] = job.unreliable_reasons ?? [];
  if (job.reliable === false) return { tone: "bad", text: `✕ ${words(first ?? "not reliable")}${more.length > 0 ? ` and ${more.length} more` : ""}` };
  return { tone: "neutral", text: "not checked" };
}
