// Plots of numbers over numbers: lines and bars whose texts stand beside the picture, whatever the numbers are.

import { useEffect, useRef } from "preact/hooks";
import uPlot from "uplot";
import { useShownTheme } from "./parts";

export interface Series {
  label: string;
  color: string;
  /** `null` ends a line; where there is no value (`undefined`), it goes on. */
  values: (number | null | undefined)[];
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
  /** Places on the x axis with a vertical line and a word, which stands above the picture. */
  marks?: { at: number; text: string }[];
  /** Bars of numbers of things, on the x axis from the first to the second number. */
  bars?: [number, number];
  /** Whether the y axis counts things. */
  whole?: boolean;
}

const FONT_PX = 12;
const FONT = `${FONT_PX}px system-ui, sans-serif`;
/** Whole numbers as steps of an axis. */
const WHOLE = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10_000, 20_000, 50_000, 100_000];

/** The numbers of an axis with as few digits as tell them apart; very large and very small ones by their powers of ten. */
function ticks(_: uPlot, splits: (number | null)[]): string[] {
  const most = Math.max(...splits.map((value) => Math.abs(value ?? 0)));
  const isFar = most >= 1e6 || (most > 0 && most < 1e-3);
  for (let digits = 1; ; digits++) {
    const texts = splits.map((value) => {
      if (value === null) return "";
      if (value === 0) return "0";
      return isFar ? Number(value.toPrecision(digits)).toExponential().replace("e+", "e").replaceAll("-", "−") : value.toLocaleString("en", { maximumSignificantDigits: digits }).replace("-", "−");
    });
    if (digits === 15 || splits.every((value, k) => value === null || Math.abs(Number(value.toPrecision(digits)) - value) <= 1e-9 * most)) return texts;
  }
}

/** As wide as the widest number of an axis. */
function widthOf(u: uPlot, values: string[] | null): number {
  if (!values) return 50;
  u.ctx.save();
  u.ctx.font = FONT;
  const widest = Math.max(0, ...values.map((text) => (text ? u.ctx.measureText(text).width : 0)));
  u.ctx.restore();
  return Math.ceil(widest) + 18;
}

/** Writes the words of marks above the picture, each beside its line, and those alone that cover no other. */
function drawMarks(u: uPlot, marks: { at: number; text: string }[], ink: string, rule: string): void {
  const { ctx, bbox } = u;
  const ratio = devicePixelRatio;
  ctx.save();
  ctx.strokeStyle = rule;
  ctx.fillStyle = ink;
  ctx.font = `${FONT_PX * ratio}px system-ui, sans-serif`;
  [ctx.textAlign, ctx.textBaseline] = ["left", "alphabetic"];
  let free = bbox.left;
  for (const { at, text } of marks) {
    const x = u.valToPos(at, "x", true);
    if (!(x >= bbox.left - 1 && x <= bbox.left + bbox.width + 1)) continue;
    ctx.beginPath();
    ctx.moveTo(x, bbox.top - 4 * ratio);
    ctx.lineTo(x, bbox.top + bbox.height);
    ctx.stroke();
    const width = ctx.measureText(text).width;
    const start = Math.max(bbox.left, Math.min(x, bbox.left + bbox.width - width));
    if (start < free) continue;
    ctx.fillText(text, start, bbox.top - 8 * ratio);
    free = start + width + 10 * ratio;
  }
  ctx.restore();
}

/** A plot whose data may grow. */
export function Plot(props: PlotProps) {
  const box = useRef<HTMLDivElement>(null);
  const plot = useRef<uPlot | null>(null);
  const latest = useRef(props);
  latest.current = props;
  const theme = useShownTheme();
  const shape = JSON.stringify([theme, props.log, props.series.map(({ label, color, scale }) => [label, color, scale]), props.height, props.xLabel, props.yLabel]);
  const data = [props.x, ...props.series.map((series) => series.values)] as uPlot.AlignedData;

  useEffect(() => {
    const element = box.current!;
    // As they are on the screen: the style sheet sets them for this element.
    const { color: ink, borderTopColor: rule } = getComputedStyle(element);
    const axis = { stroke: ink, grid: { stroke: rule, width: 1 }, ticks: { stroke: rule, width: 1 }, font: FONT, labelFont: FONT, labelSize: 18, values: ticks };
    const hasRight = props.series.some((series) => series.scale === "right");
    const hasBars = props.bars !== undefined;
    const made = new uPlot(
      {
        width: element.clientWidth || 300,
        height: props.height,
        padding: [props.marks ? 24 : 10, hasRight ? 0 : 30, 0, 0],
        scales: {
          x: { time: false, ...(hasBars ? { range: () => latest.current.bars! } : {}) },
          y: { distr: props.log ? 3 : 1, ...(hasBars ? { range: (_: uPlot, __: number, high: number): [number, number] => [0, Math.max(1, high)] } : {}) },
          right: {},
        },
        axes: [
          { ...axis, label: props.xLabel, size: 30 },
          { ...axis, label: props.yLabel, size: widthOf, ...(hasBars || props.whole ? { incrs: WHOLE } : {}) },
          ...(hasRight ? [{ ...axis, label: props.rightLabel, scale: "right", side: 1 as const, size: widthOf, grid: { show: false } }] : []),
        ],
        series: [
          { label: props.xLabel },
          ...props.series.map(({ label, color, dash, width, scale, points }) => ({
            label,
            stroke: color,
            width: width ?? 1.5,
            dash,
            scale: scale ?? "y",
            spanGaps: false,
            points: { show: points ?? false, size: 5 },
            fill: hasBars ? color : undefined,
            paths: hasBars ? uPlot.paths.bars!({ size: [0.9] }) : points ? () => null : undefined,
            value: (_: uPlot, value: number | null) => (value === null || value === undefined ? "–" : value.toPrecision(4)),
          })),
        ],
        legend: { show: !hasBars },
        cursor: { show: !hasBars },
        hooks: { draw: [(u) => drawMarks(u, latest.current.marks ?? [], ink, hasBars ? ink : rule)] },
      },
      data,
      element,
    );
    plot.current = made;
    (element as HTMLDivElement & { plot?: uPlot }).plot = made; // what the tests ask
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
