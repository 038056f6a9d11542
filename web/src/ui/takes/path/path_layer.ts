// A path of the open take, drawn over the scene: a line with a dot per quarter of a second, and as it is being bent.

import { formatClock } from '../../../model/formatters';
import type { GroundPoint, ScreenPoint } from '../../../model/plane';
import { timesBeside, type TakeWay } from '../../../model/take_path';

const kSvg = 'http://www.w3.org/2000/svg';
/** Between two times that are written [CSS px]. */
const kBetweenTimes = 56;
/** Dots nearer than this to the last drawn one are left out [CSS px]. */
const kBetweenDots = 7;

export interface PathPicture {
  readonly way: TakeWay | null;
  /** The path as it is being bent; null for none. */
  readonly bent: readonly GroundPoint[] | null;
  /** The point of the shown moment. */
  readonly now: number;
  /** The point that is held or pointed at; -1 for none. */
  readonly held: number;
}

export function shape(name: string, attributes: Readonly<Record<string, string | number>>): SVGElement {
  const made = document.createElementNS(kSvg, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, String(value));
  return made;
}

export function line(points: readonly ScreenPoint[], name: string): SVGElement {
  return shape('polyline', {
    points: points.map(({ x, y }) => `${x.toFixed(1)},${y.toFixed(1)}`).join(' '),
    class: name,
  });
}

export class PathLayer {
  readonly root = shape('svg', { class: 'path-layer', 'aria-hidden': 'true' }) as SVGSVGElement;
  private drawn_ = '';

  constructor(private readonly toScreen_: (point: GroundPoint) => ScreenPoint) {}

  /** Draws other shapes instead of a path. */
  drawShapes(parts: readonly SVGElement[]): void {
    this.drawn_ = '';
    this.root.replaceChildren(...parts);
  }

  draw({ way, bent, now, held }: PathPicture): void {
    const old = way ? way.points.map(this.toScreen_) : [];
    const fresh = bent ? bent.map(this.toScreen_) : null;
    const shown = fresh ?? old;
    const state = `${now} ${held} ${shown.map(({ x, y }) => `${x.toFixed(1)},${y.toFixed(1)}`).join(' ')}`;
    if (state === this.drawn_) return;
    this.drawn_ = state;
    const parts: SVGElement[] = [];
    if (fresh) parts.push(line(old, 'path-before'));
    parts.push(line(shown, 'path-casing'), line(shown, 'path-line'));
    parts.push(...this.dots(shown, now, held));
    if (way) parts.push(...this.times(way, shown));
    this.root.replaceChildren(...parts);
  }

  private dots(points: readonly ScreenPoint[], now: number, held: number): SVGElement[] {
    const made: SVGElement[] = [];
    let last: ScreenPoint | null = null;
    points.forEach((point, k) => {
      if (last && Math.hypot(point.x - last.x, point.y - last.y) < kBetweenDots) return;
      made.push(shape('circle', { cx: point.x, cy: point.y, r: 3.2, class: 'path-dot' }));
      last = point;
      if (k === held) last = null;
    });
    const at = points[now];
    if (at) made.push(shape('circle', { cx: at.x, cy: at.y, r: 7, class: 'path-now' }));
    const hand = points[held];
    if (hand) made.push(shape('circle', { cx: hand.x, cy: hand.y, r: 10, class: 'path-held' }));
    return made;
  }

  private times(way: TakeWay, points: readonly ScreenPoint[]): SVGElement[] {
    return timesBeside(way, points, kBetweenTimes).map((k) => {
      const { x, y } = points[k]!;
      const text = shape('text', { x: x + 9, y: y - 9, class: 'path-time' });
      text.textContent = formatClock(k * way.spacing * way.stepTime);
      return text;
    });
  }
}
