// What is drawn over the scene while somebody builds: outlines, handles, what is being drawn, gaps and ground that cannot be
// reached.

import type { OverlayView } from '../../model/frame_view';
import type { GroundPoint, ScreenPoint } from '../../model/plane';
import type { Guide } from '../../model/place/guides';
import { hasCorners, middlesOf } from '../../model/place/corners';
import { defined } from '../../model/place/routes';
import { startOutline } from '../../model/place/start_outline';
import { accentVariable } from '../widgets/group_marks';
import { extentOf, outlineOf, sameThing, type Extent, type Thing } from '../../model/place/things';

const kSvg = 'http://www.w3.org/2000/svg';
/** Half the length of the arrow that marks a gap [CSS px]. */
const kGapArm = 14;
/** Words below where a group begins [CSS px]. */
const kBelow = 16;
/** Above the box round what is chosen [CSS px]. */
const kTurnHandle = 34;

export interface BuildPicture {
  /** Of the world [s]. */
  readonly time: number;
  readonly things: readonly Thing[];
  readonly chosen: readonly Thing[];
  /** Things as a drag leaves them, or as they are being drawn. */
  readonly preview: readonly Thing[];
  /** A line, box or lasso that is being drawn. */
  readonly line: readonly GroundPoint[];
  readonly closed: boolean;
  /** Those of what is chosen. */
  readonly handles: boolean;
  /** The corner that was tapped; -1 for none. */
  readonly corner: number;
  /** What is moved lines up with others along these. */
  readonly guides: readonly Guide[];
}

export interface Sight {
  toScreen(point: GroundPoint): ScreenPoint;
}

function shape(name: string, attributes: Readonly<Record<string, string | number>>): SVGElement {
  const made = document.createElementNS(kSvg, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, String(value));
  return made;
}

/** Where the handles of what is chosen are on the screen. */
export function handlesOf(extent: Extent, sight: Sight): { scale: ScreenPoint; turn: ScreenPoint } {
  const corners = [
    sight.toScreen({ x: extent.minX, y: extent.minY }),
    sight.toScreen({ x: extent.maxX, y: extent.minY }),
    sight.toScreen({ x: extent.maxX, y: extent.maxY }),
    sight.toScreen({ x: extent.minX, y: extent.maxY }),
  ];
  const xs = corners.map(({ x }) => x);
  const ys = corners.map(({ y }) => y);
  const scale = { x: Math.max(...xs) + 10, y: Math.max(...ys) + 10 };
  return { scale, turn: { x: (Math.min(...xs) + Math.max(...xs)) / 2, y: Math.min(...ys) - kTurnHandle } };
}

/** Runs of cells that cannot be reached, row by row, as boxes [m]. */
export function unreachedRuns({ x, y, cell, width, values }: OverlayView, most = 3000): Extent[] {
  const runs: Extent[] = [];
  for (let from = 0; from < values.length && runs.length < most; ++from) {
    if (values[from] !== 1) continue;
    const row = Math.floor(from / width);
    let to = from;
    while (to + 1 < (row + 1) * width && values[to + 1] === 1) ++to;
    const [left, right] = [x + (from - row * width - 0.5) * cell, x + (to - row * width + 0.5) * cell];
    runs.push({ minX: left, maxX: right, minY: y + (row - 0.5) * cell, maxY: y + (row + 0.5) * cell });
    from = to;
  }
  return runs;
}

function sameItems(a: readonly unknown[], b: readonly unknown[]): boolean {
  return a.length === b.length && a.every((one, i) => one === b[i]);
}

/** Spots whose places on the screen tell whether the camera has moved [m]. */
const kWatched: readonly GroundPoint[] = [
  { x: 0, y: 0 },
  { x: 10, y: 0 },
  { x: 0, y: 10 },
];

export class BuildLayer {
  /** What lies there; it changes with the place and the camera alone. */
  private readonly still_ = shape('g', {});
  /** What is being drawn, moved or chosen. */
  private readonly moving_ = shape('g', {});
  readonly root = shape('svg', { class: 'build-layer', 'aria-hidden': 'true' }) as SVGSVGElement;
  private shown_: BuildPicture | null = null;
  private sightKey_ = '';
  private runs_: readonly Extent[] = [];
  private gaps_: readonly { readonly at: GroundPoint; readonly width: number }[] = [];

  constructor(private readonly sight_: Sight) {
    this.root.append(this.still_, this.moving_);
  }

  /** What can be reached, as the server tells. */
  setReach(overlay: OverlayView & { readonly gaps: ArrayLike<number> }): void {
    this.shown_ = null;
    this.runs_ = unreachedRuns(overlay);
    const { gaps } = overlay;
    this.gaps_ = Array.from({ length: Math.floor(gaps.length / 3) }, (_, k) => ({
      at: { x: gaps[3 * k]!, y: gaps[3 * k + 1]! },
      width: gaps[3 * k + 2]!,
    }));
  }

  /** Call before every picture: only what has changed is made anew. */
  draw(picture: BuildPicture): void {
    const before = this.shown_;
    const sightKey = kWatched.map((spot) => Object.values(this.sight_.toScreen(spot)).join(' ')).join(' ');
    const seen = before !== null && sightKey === this.sightKey_;
    const still = seen && sameItems(before.things, picture.things) && sameItems(before.chosen, picture.chosen);
    const moving =
      still &&
      sameItems(before.preview, picture.preview) &&
      sameItems(before.line, picture.line) &&
      before.closed === picture.closed &&
      before.handles === picture.handles &&
      before.corner === picture.corner &&
      before.guides === picture.guides;
    if (moving) return;
    this.sightKey_ = sightKey;
    this.shown_ = { ...picture, line: [...picture.line] };
    if (!still) this.drawStill(picture);
    this.drawMoving(picture);
  }

  private drawStill({ things, chosen }: BuildPicture): void {
    const parts = [this.reach()];
    for (const one of things) {
      const taken = chosen.some((other) => sameThing(other, one));
      const kind = one.area?.kind ?? one.kind;
      parts.push(this.outline(one, `build-thing build-${kind}${taken ? ' build-chosen' : ''}`));
    }
    for (const gap of this.gaps_) parts.push(...this.gap(gap));
    this.still_.replaceChildren(...parts);
  }

  private drawMoving({ chosen, preview, line, closed, handles, corner, guides }: BuildPicture): void {
    const parts = preview.map((one) => this.outline(one, 'build-preview'));
    if (line.length > 1) parts.push(this.path(line, closed, 'build-line'));
    for (const { from, to } of guides) parts.push(this.path([from, to], false, 'build-guide'));
    const extent = handles ? extentOf(preview.length > 0 ? preview : chosen) : null;
    if (extent) parts.push(...this.handles(extent), ...this.corners(preview.length > 0 ? preview : chosen, corner));
    this.moving_.replaceChildren(...parts);
  }

  private points(points: readonly GroundPoint[]): string {
    return points
      .map((p) => this.sight_.toScreen(p))
      .map(({ x, y }) => `${x.toFixed(1)},${y.toFixed(1)}`)
      .join(' ');
  }

  private path(points: readonly GroundPoint[], closed: boolean, name: string): SVGElement {
    return shape(closed ? 'polygon' : 'polyline', { points: this.points(points), class: name });
  }

  private outline(one: Thing, name: string): SVGElement {
    if (one.kind === 'group') return this.start(one, name);
    const group = shape('g', { class: name });
    group.append(this.path(outlineOf(one), true, 'build-casing'), this.path(outlineOf(one), true, 'build-outline'));
    if (one.path) {
      const [x, y] = defined(one, this.shown_?.time ?? 0).centre;
      const way = one.path.waypoints.map(({ position: [dx, dy] }) => ({ x: x + dx, y: y + dy }));
      group.append(this.path(way, false, 'build-way'));
    }
    return group;
  }

  /** Where a group begins and faces, in its colour, with words. */
  private start(one: Thing, name: string): SVGElement {
    const { angle, radius } = one;
    const [x, y] = one.centre;
    const group = shape('g', { class: name, style: `color: ${accentVariable(one.colour)}` });
    const outline = startOutline(one);
    const tip = { x: x + 1.3 * radius * Math.cos(angle), y: y + 1.3 * radius * Math.sin(angle) };
    const spots = outline.map((p) => this.sight_.toScreen(p));
    const across = spots.map((p) => p.x);
    const at = {
      x: (Math.min(...across) + Math.max(...across)) / 2,
      y: Math.max(...spots.map((p) => p.y)) + kBelow,
      class: 'build-start-label',
    };
    const label = shape('text', at);
    label.textContent = `${one.name || 'Group'} begins here`;
    group.append(
      this.path(outline, true, 'build-casing'),
      this.path(outline, true, 'build-outline'),
      this.path([{ x, y }, tip], false, 'build-facing'),
      label,
    );
    return group;
  }

  private gap({ at, width }: { readonly at: GroundPoint; readonly width: number }): SVGElement[] {
    const { x, y } = this.sight_.toScreen(at);
    const label = shape('text', { x: x + kGapArm + 4, y: y + 4, class: 'build-gap-label' });
    label.textContent = `${width.toFixed(1)} m`;
    return [shape('line', { x1: x - kGapArm, y1: y, x2: x + kGapArm, y2: y, class: 'build-gap' }), label];
  }

  private reach(): SVGElement {
    const d = this.runs_
      .map(({ minX, minY, maxX, maxY }) => [
        { x: minX, y: minY },
        { x: maxX, y: minY },
        { x: maxX, y: maxY },
        { x: minX, y: maxY },
      ])
      .map((corners) => `M${this.points(corners).replaceAll(' ', 'L')}Z`)
      .join('');
    return shape('path', { d, class: 'build-unreached' });
  }

  private corners(chosen: readonly Thing[], tapped: number): SVGElement[] {
    const [one] = chosen;
    if (!one || !hasCorners(chosen)) return [];
    const dot = (point: GroundPoint, r: number, name: string): SVGElement => {
      const { x, y } = this.sight_.toScreen(point);
      return shape('circle', { cx: x, cy: y, r, class: name });
    };
    return [
      ...middlesOf(one).map((point) => dot(point, 3.5, 'build-middle')),
      ...outlineOf(one).map((point, k) => dot(point, 6, `build-corner${k === tapped ? ' build-tapped' : ''}`)),
    ];
  }

  private handles(extent: Extent): SVGElement[] {
    const { scale, turn } = handlesOf(extent, this.sight_);
    return [
      shape('rect', { x: scale.x - 8, y: scale.y - 8, width: 16, height: 16, rx: 4, class: 'build-handle' }),
      shape('circle', { cx: turn.x, cy: turn.y, r: 9, class: 'build-handle' }),
    ];
  }
}
