// A small plot over time, with labelled axes.

import { element } from '../widgets/dom';

/** A point: time [s], value; a value that is not finite is a gap. */
export type PlotPoint = readonly [number, number];

export interface PlotCurve {
  /** In the heading. */
  readonly name?: string;
  readonly points: readonly PlotPoint[];
  /** It keeps each value until the next point. */
  readonly stepped?: boolean;
}

const kSvg = 'http://www.w3.org/2000/svg';
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

function shape(name: string, attributes: Readonly<Record<string, string | number>>, text = ''): SVGElement {
  const made = document.createElementNS(kSvg, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, String(value));
  if (text) made.textContent = text;
  return made;
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

export class Plot {
  private readonly svg_ = shape('svg', { viewBox: `0 0 ${kWidth} ${kHeight}`, 'aria-hidden': 'true' });
  private readonly heading_ = element('figcaption');
  readonly root = element('figure', { class: 'plot' }, this.heading_, this.svg_);

  /** `unit` is that of the values; `least` the smallest upper end of their axis. */
  constructor(
    private readonly quantity_: string,
    private readonly unit_: string,
    private readonly least_: number,
  ) {}

  draw(from: number, to: number, curves: readonly PlotCurve[]): void {
    const values = curves.flatMap(({ points }) => points.map(([, value]) => value)).filter(Number.isFinite);
    const top = values.reduce((most, one) => Math.max(most, 1.05 * one), this.least_);
    const end = Math.max(to, from + 5);
    const { left, right, bottom, top: upper } = kBox;
    const toX = (time: number): number => left + ((time - from) / (end - from)) * (right - left);
    const toY = (value: number): number => bottom - (value / top) * (bottom - upper);
    const parts: SVGElement[] = [];
    for (const tick of niceTicks(0, top, 4)) {
      const y = toY(tick);
      parts.push(shape('path', { d: `M${left} ${y.toFixed(1)}H${right}`, class: 'plot-grid' }));
      parts.push(shape('text', { x: left - 4, y: y + 3.5, class: 'plot-end' }, short(tick)));
    }
    for (const tick of niceTicks(from, end, 4)) {
      const x = toX(tick);
      parts.push(shape('path', { d: `M${x.toFixed(1)} ${bottom}v3`, class: 'plot-axis' }));
      parts.push(shape('text', { x, y: bottom + 13, class: 'plot-middle' }, short(tick)));
    }
    parts.push(shape('text', { x: right, y: kHeight - 3, class: 'plot-end' }, 'Time [s]'));
    parts.push(shape('path', { d: `M${left} ${upper}V${bottom}H${right}`, class: 'plot-axis' }));
    curves.forEach((curve, k) => parts.push(shape('path', { d: pathOf(curve, toX, toY), class: `plot-curve-${k}` })));
    this.svg_.replaceChildren(...parts);
    this.nameCurves(curves);
  }

  private nameCurves(curves: readonly PlotCurve[]): void {
    const names = curves.flatMap(({ name }, k) => (name ? [element('span', { class: `plot-name-${k}` }, name)] : []));
    this.heading_.replaceChildren(`${this.quantity_} [${this.unit_}]`, ...names);
  }
}
