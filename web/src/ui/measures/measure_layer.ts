// Lines and areas of measurement, drawn over the scene.

import type { Measure } from '../../model/measures/measures';
import type { GroundPoint, ScreenPoint } from '../../model/plane';

const kSvg = 'http://www.w3.org/2000/svg';
/** Of the arrow beside a line [CSS px]. */
const kArrow = 26;

export interface MeasurePicture {
  readonly measures: readonly Measure[];
  /** What is being drawn: two ends, or the corners of an area. */
  readonly drawn: readonly GroundPoint[];
}

function shape(name: string, attributes: Readonly<Record<string, string | number>>, text = ''): SVGElement {
  const made = document.createElementNS(kSvg, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, String(value));
  if (text) made.textContent = text;
  return made;
}

function middleOf(points: readonly ScreenPoint[]): ScreenPoint {
  const sum = points.reduce((s, p) => ({ x: s.x + p.x, y: s.y + p.y }), { x: 0, y: 0 });
  return { x: sum.x / points.length, y: sum.y / points.length };
}

export class MeasureLayer {
  readonly root = shape('svg', { class: 'measure-layer', 'aria-hidden': 'true' }) as SVGSVGElement;
  private shown_ = '';

  constructor(private readonly toScreen_: (point: GroundPoint) => ScreenPoint) {}

  /** Call before every picture: it is made anew only where something has changed. */
  draw({ measures, drawn }: MeasurePicture): void {
    const seen = measures.filter(({ hidden }) => !hidden);
    const lists = [...seen.map((one) => this.cornersOf(one)), drawn.map(this.toScreen_)];
    const key = JSON.stringify([
      lists.map((list) => list.map(({ x, y }) => [x.toFixed(1), y.toFixed(1)])),
      seen.map(({ name }) => name),
    ]);
    if (key === this.shown_) return;
    this.shown_ = key;
    const parts = seen.flatMap((one, k) => this.partsOf(one, lists[k]!));
    if (drawn.length > 1) parts.push(...this.outline(lists[lists.length - 1]!, 'measure-drawn'));
    this.root.replaceChildren(...parts);
  }

  private cornersOf(one: Measure): ScreenPoint[] {
    return (one.kind === 'line' ? [one.a, one.b] : one.record.polygon).map(this.toScreen_);
  }

  private outline(points: readonly ScreenPoint[], name: string): SVGElement[] {
    const tag = points.length > 2 ? 'polygon' : 'polyline';
    const list = points.map(({ x, y }) => `${x.toFixed(1)},${y.toFixed(1)}`).join(' ');
    return [shape(tag, { points: list, class: 'measure-casing' }), shape(tag, { points: list, class: name })];
  }

  private partsOf(one: Measure, corners: readonly ScreenPoint[]): SVGElement[] {
    const middle = middleOf(corners);
    const parts = this.outline(corners, `measure-${one.kind}`);
    if (one.kind === 'area') return [...parts, this.label(one.name, middle.x, middle.y + 4)];
    for (const { x, y } of corners) parts.push(shape('circle', { cx: x, cy: y, r: 4, class: 'measure-end' }));
    const tip = this.tipOf(one.a, one.b, middle);
    parts.push(...this.arrow(middle, tip));
    // The name stands on the other side of the line.
    const [dx, dy] = [middle.x - tip.x, middle.y - tip.y];
    const long = Math.max(1, Math.hypot(dx, dy));
    return [...parts, this.label(one.name, middle.x + (34 * dx) / long, middle.y + (20 * dy) / long + 4)];
  }

  /** Where the arrow of direction 1 ends: to the right of the line on the ground, wherever that is on the screen. */
  private tipOf(a: GroundPoint, b: GroundPoint, middle: ScreenPoint): ScreenPoint {
    const [x, y] = [(a.x + b.x) / 2, (a.y + b.y) / 2];
    const length = Math.max(1e-6, Math.hypot(b.x - a.x, b.y - a.y));
    const at = this.toScreen_({ x: x + (b.y - a.y) / length, y: y - (b.x - a.x) / length });
    const [dx, dy] = [at.x - middle.x, at.y - middle.y];
    const long = Math.max(1e-6, Math.hypot(dx, dy));
    return { x: middle.x + (kArrow * dx) / long, y: middle.y + (kArrow * dy) / long };
  }

  private arrow(from: ScreenPoint, tip: ScreenPoint): SVGElement[] {
    const [dx, dy] = [(tip.x - from.x) / kArrow, (tip.y - from.y) / kArrow];
    const wing = (side: number): string =>
      `${(tip.x - 8 * dx - side * 6 * dy).toFixed(1)} ${(tip.y - 8 * dy + side * 6 * dx).toFixed(1)}`;
    const at = (p: ScreenPoint): string => `${p.x.toFixed(1)} ${p.y.toFixed(1)}`;
    const d = `M${at(from)}L${at(tip)}M${wing(1)}L${at(tip)}L${wing(-1)}`;
    return [shape('path', { d, class: 'measure-casing' }), shape('path', { d, class: 'measure-arrow' })];
  }

  private label(text: string, x: number, y: number): SVGElement {
    return shape('text', { x: x.toFixed(1), y: y.toFixed(1), class: 'measure-name' }, text);
  }
}
