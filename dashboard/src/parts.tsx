// Small parts that several views share.

import type { ComponentChildren, TargetedEvent } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import type { JobState } from "./api";
import type { Tone } from "./format";

export const Badge = ({ tone, children }: { tone: Tone; children: ComponentChildren }) => <span class={`badge ${tone}`}>{children}</span>;

const TONES: Record<JobState, Tone> = {
  queued: "wait",
  running: "wait",
  succeeded: "good",
  failed: "bad",
  dead: "bad",
  expired: "bad",
  cancelled: "neutral",
};

export const State = ({ state }: { state: JobState }) => <Badge tone={TONES[state]}>{state}</Badge>;

export const Bar = ({ share, label }: { share: number; label: string }) => (
  <progress class="bar" max={1} value={share} aria-label={label} />
);

export function Failure({ text }: { text: string | null }) {
  return text === null ? null : (
    <p class="failure" role="alert">
      {text}
    </p>
  );
}

export function Facts({ rows }: { rows: [string, ComponentChildren][] }) {
  return (
    <dl class="facts">
      {rows.map(([name, value]) => (
        <div key={name}>
          <dt>{name}</dt>
          <dd>{value}</dd>
        </div>
      ))}
    </dl>
  );
}

/** The time, renewed every second, for ages. */
export function useNow(): number {
  const [now, setNow] = useState(Date.now());
  useEffect(() => {
    const timer = setInterval(() => setNow(Date.now()), 1000);
    return () => clearInterval(timer);
  }, []);
  return now;
}

/** A choice that this browser keeps. */
export function useKept(name: string, usual: string): [string, (value: string) => void] {
  const [value, setValue] = useState(localStorage.getItem(`homolog-${name}`) ?? usual);
  return [
    value,
    (next) => {
      setValue(next);
      localStorage.setItem(`homolog-${name}`, next);
    },
  ];
}

/** Runs `work` when `inputs` change; its signal ends what the last run began. */
export function useWork(work: (signal: AbortSignal) => void, inputs: unknown[]): void {
  useEffect(() => {
    const stop = new AbortController();
    work(stop.signal);
    return () => stop.abort();
  }, inputs);
}

/** Changes whenever light turns to dark or back. */
export function useShownTheme(): number {
  const [n, setN] = useState(0);
  useEffect(() => {
    const changed = () => setN((before) => before + 1);
    const scheme = matchMedia("(prefers-color-scheme: dark)");
    scheme.addEventListener("change", changed);
    window.addEventListener("theme", changed);
    return () => {
      scheme.removeEventListener("change", changed);
      window.removeEventListener("theme", changed);
    };
  }, []);
  return n;
}

/** An input whose text is taken when it is left or Enter is pressed; until then nothing changes it but its user. */
export function Typed({ value, take, ...more }: { value: string; take: (text: string) => void } & Record<string, unknown>) {
  const [text, setText] = useState<string | null>(null);
  return (
    <input
      {...more}
      value={text ?? value}
      onInput={(e) => setText(e.currentTarget.value)}
      onChange={(e) => {
        setText(null);
        take(e.currentTarget.value);
      }}
    />
  );
}

export function Check({ label, checked, onChange }: { label: string; checked: boolean; onChange: (event: TargetedEvent<HTMLInputElement>) => void }) {
  return (
    <label class="check">
      <input type="checkbox" checked={checked} onChange={onChange} /> {label}
    </label>
  );
}
