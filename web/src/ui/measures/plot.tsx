// A small plot over time, with labelled axes.

import type { VNode } from 'preact';

/** A point: time [s], value; a value that is not finite is a gap. */
export type PlotPoint = readonly [number, number];

export interface PlotCurve {
  /** In the heading. */
  readonly name?: string;
  readonly points: readonly PlotPoint[];
  /** It keeps each value until the next point. */
  readonly stepped?: boolean;
}

const kWidth = 156;
const kHeight = 96;
/** The box of the curves. */
const kBox = { left: 30, right: kWidth - 5, top: 6, bottom: kHeight - 27 };
/** More points than this are not told apart. */
const kMostPoints = 240;

/** About so many round values from 0 to the largest one. */
export function niceTicks(from: number, to: number, wished: number): number[] {
  const span = to - from;
  if (!(span > 0)) return [from];
  const rough = span / wished;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((one) => one * power).find((one) => one >= rough * 0.999)!;
  const ticks: number[] = [];
  for (let k = Math.ceil(from / step - 1e-9); k * step <= to + 1e-9 * span; ++k) ticks.push(k * step + 0);
  return ticks;
}

function thinned(points: readonly PlotPoint[]): readonly PlotPoint[] {
  if (points.length <= kMostPoints) return points;
  const every = Math.ceil(points.length / kMostPoints);
  return points.filter((_, k) => k % every === 0 || k === points.length - 1);
}

function short(value: number): string {
  return String(Math.round(value * 1000) / 1000);
}

/** The way of a curve in the box, as path data. */
function pathOf({ points, stepped }: PlotCurve, toX: (t: number) => number, toY: (v: number) => number): string {
  let path = '';
  let drawing = false;
  for (const [time, value] of thinned(points)) {
    if (!Number.isFinite(value)) {
      drawing = false;
      continue;
    }
    const [x, y] = [toX(time).toFixed(1), toY(value).toFixed(1)];
    path += !drawing ? `M${x} ${y}` : stepped ? `H${x}V${y}` : `L${x} ${y}`;
    drawing = true;
  }
  return path;
}

export interface PlotProps {
  readonly quantity: string;
  /** Of the values. */
  readonly unit: string;
  /** The smallest upper end of their axis. */
  readonly least: number;
  readonly from: number;
  readonly to: number;
  readonly curves: readonly PlotCurve[];
}

export function Plot({ quantity, unit, least, from, to, curves }: PlotProps): VNode {
  const values = curves.flatMap(({ points }) => points.map(([, value]) => value)).filter(Number.isFinite);
  const most = values.reduce((largest, one) => Math.max(largest, 1.05 * one), least);
  const end = Math.max(to, from + 5);
  const { left, right, bottom, top } = kBox;
  const toX = (time: number): number => left + ((time - from) / (end - from)) * (right - left);
  const toY = (value: number): number => bottom - (value / most) * (bottom - top);
  return (
    <figure class="plot">
      <figcaption>
        {`${quantity} [${unit}]`}
        {curves.map(({ name }, k) => name && <span class={`plot-name-${k}`}>{name}</span>)}
      </figcaption>
      <svg viewBox={`0 0 ${kWidth} ${kHeight}`} aria-hidden="true">
        {niceTicks(0, most, 4).map((tick) => (
          <>
            <path d={`M${left} ${toY(tick).toFixed(1)}H${right}`} class="plot-grid" />
            <text x={left - 4} y={toY(tick) + 3.5} class="plot-end">
              {short(tick)}
            </text>
          </>
        ))}
        {niceTicks(from, end, 4).map((tick) => (
          <>
            <path d={`M${toX(tick).toFixed(1)} ${bottom}v3`} class="plot-axis" />
            <text x={toX(tick)} y={bottom + 13} class="plot-middle">
              {short(tick)}
            </text>
          </>
        ))}
        <text x={right} y={kHeight - 3} class="plot-end">
          Time [s]
        </text>
        <path d={`M${left} ${top}V${bottom}H${right}`} class="plot-axis" />
        {curves.map((curve, k) => (
          <path key={k} d={pathOf(curve, toX, toY)} class={`plot-curve-${k}`} />
        ))}
      </svg>
    </figure>
  );
}
