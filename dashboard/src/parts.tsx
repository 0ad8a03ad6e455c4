// Small parts that several views share.

import type { ComponentChildren, TargetedEvent } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import uPlot from "uplot";
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

export interface Series {
  label: string;
  color: string;
  values: (number | null)[];
  dash?: number[];
  width?: number;
  scale?: string;
  points?: boolean;
}

interface PlotProps {
  title: string;
  x: number[];
  series: Series[];
  log?: boolean;
  height: number;
  xLabel: string;
  yLabel: string;
  rightLabel?: string;
  /** Places on the x axis with a vertical line and a word. */
  marks?: { at: number; text: string }[];
  bars?: boolean;
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

/** A plot whose data may grow. */
export function Plot(props: PlotProps) {
  const box = useRef<HTMLDivElement>(null);
  const plot = useRef<uPlot | null>(null);
  const marks = useRef(props.marks);
  marks.current = props.marks;
  const theme = useShownTheme();
  const shape = JSON.stringify([theme, props.log, props.series.map(({ label, color, scale }) => [label, color, scale]), props.height]);
  const data = [props.x, ...props.series.map((series) => series.values)] as uPlot.AlignedData;

  useEffect(() => {
    const element = box.current!;
    // As they are on the screen: the style sheet sets them for this element.
    const { color: ink, borderTopColor: rule } = getComputedStyle(element);
    const axis = { stroke: ink, grid: { stroke: rule, width: 1 }, ticks: { stroke: rule, width: 1 }, font: "12px system-ui", labelFont: "12px system-ui", labelSize: 18 };
    const hasRight = props.series.some((series) => series.scale === "right");
    const made = new uPlot(
      {
        width: element.clientWidth || 300,
        height: props.height,
        scales: { x: { time: false }, y: { distr: props.log ? 3 : 1 }, right: {} },
        axes: [
          { ...axis, label: props.xLabel },
          { ...axis, label: props.yLabel, size: 58 },
          ...(hasRight ? [{ ...axis, label: props.rightLabel, scale: "right", side: 1 as const, size: 50, grid: { show: false } }] : []),
        ],
        series: [
          { label: props.xLabel },
          ...props.series.map(({ label, color, dash, width, scale, points }) => ({
            label,
            stroke: color,
            width: width ?? 1.5,
            dash,
            scale: scale ?? "y",
            spanGaps: true,
            points: { show: points ?? false, size: 5 },
            fill: props.bars ? color : undefined,
            paths: props.bars ? uPlot.paths.bars!({ size: [0.9] }) : points ? () => null : undefined,
            value: (_: uPlot, value: number | null) => (value === null || value === undefined ? "–" : value.toPrecision(4)),
          })),
        ],
        legend: { live: !props.bars },
        hooks: {
          draw: [
            (u) => {
              const { ctx } = u;
              ctx.save();
              ctx.strokeStyle = rule;
              ctx.fillStyle = ink;
              ctx.font = `${12 * devicePixelRatio}px system-ui`;
              for (const { at, text } of marks.current ?? []) {
                const x = u.valToPos(at, "x", true);
                ctx.beginPath();
                ctx.moveTo(x, u.bbox.top);
                ctx.lineTo(x, u.bbox.top + u.bbox.height);
                ctx.stroke();
                ctx.fillText(text, x + 4 * devicePixelRatio, u.bbox.top + 12 * devicePixelRatio);
              }
              ctx.restore();
            },
          ],
        },
      },
      data,
      element,
    );
    plot.current = made;
    const sizes = new ResizeObserver(() => made.setSize({ width: element.clientWidth, height: props.height }));
    sizes.observe(element);
    return () => {
      sizes.disconnect();
      made.destroy();
    };
  }, [shape]);
  useEffect(() => plot.current?.setData(data));
  return <div class="plot" ref={box} role="img" aria-label={props.title} data-points={props.x.length} />;
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
