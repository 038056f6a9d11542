// Draws the marks of controls in CSS px: handles, bars, hulls, paths, rings. It knows screens, not worlds.

import { withAlpha } from '../drawing/colour';
import type { MarkBounds } from './mark_extent';
import type { ScreenPoint } from '../../model/plane';

export type Pen = CanvasRenderingContext2D;

export interface MarkColours {
  readonly accent: string;
  /** Round the accent: white, or near black in the dark. */
  readonly casing: string;
}

const kHandle = 22;
const kRing = 60;
/** The ring of the cursor, and where the arms of its cross begin and end [CSS px]. */
const kCursor = { ring: 13, from: 5, to: 21 };
/** On phones, where fingers would bury the crowd. */
const kPhoneRing = 38;
/** Width of a phone's screen, at most [CSS px]. */
const kPhoneWidth = 520;
/** Half the mean width of a letter of a label [CSS px]. */
const kLetter = 3.9;

export class MarkPainter {
  private wide_ = Infinity;
  private readonly hatch_ = new Map<string, CanvasPattern | null>();

  constructor(private readonly pen_: Pen) {}

  /**
   * Begins a picture: clears the canvas, and sets its transform to CSS px of the screen, of which it covers these
   * bounds.
   */
  begin(bounds: MarkBounds, ratio: number, screenWidth = Infinity): void {
    this.wide_ = screenWidth;
    this.pen_.setTransform(ratio, 0, 0, ratio, -bounds.x * ratio, -bounds.y * ratio);
    this.pen_.clearRect(bounds.x, bounds.y, bounds.width, bounds.height);
    this.pen_.lineCap = 'round';
    this.pen_.lineJoin = 'round';
    this.pen_.globalAlpha = 1;
  }

  set alpha(value: number) {
    this.pen_.globalAlpha = Math.min(1, Math.max(0, value));
  }

  /** A stroke in its casing. */
  cased(points: readonly ScreenPoint[], colours: MarkColours, width: number, casing: number, closed = false): void {
    if (points.length < 2) return;
    this.trace(points, closed);
    this.stroke(colours.casing, casing);
    this.stroke(colours.accent, width);
  }

  /** Dashes; in a casing, so that they are seen on meshes of the same colour. */
  dashed(points: readonly ScreenPoint[], colour: string, width: number, closed: boolean, casing?: string): void {
    if (points.length < 2) return;
    if (casing) {
      this.trace(points, closed);
      this.stroke(withAlpha(casing, 0.85), width + 2.8);
    }
    this.pen_.setLineDash([10, 8]);
    this.pen_.lineCap = 'butt';
    this.trace(points, closed);
    this.stroke(colour, width);
    this.pen_.setLineDash([]);
    this.pen_.lineCap = 'round';
  }

  /** A checkpoint; the next one is bigger and filled. */
  checkpoint(at: ScreenPoint, colours: MarkColours, next: boolean): void {
    if (next) {
      this.disc(at, 7.2, colours.casing);
      this.disc(at, 5.5, colours.accent);
      return;
    }
    this.disc(at, 3, colours.accent);
    this.disc(at, 1.6, colours.casing);
  }

  /** A dot without a casing. */
  dot(at: ScreenPoint, radius: number, colour: string): void {
    this.disc(at, radius, colour);
  }

  /** A number on a disc in the accent; `ink` is read on it. */
  badge(at: ScreenPoint, text: string, colours: MarkColours, ink: string): void {
    const pen = this.pen_;
    const half = 10 + 3.2 * (text.length - 1);
    pen.save();
    pen.translate(at.x, at.y);
    this.box(half + 1.5, 11.5, 11.5, colours.casing);
    this.box(half, 10, 10, colours.accent);
    pen.restore();
    pen.fillStyle = ink;
    pen.font = '600 12px "Inter Variable", Inter, system-ui, sans-serif';
    pen.textAlign = 'center';
    pen.textBaseline = 'middle';
    pen.fillText(text, at.x, at.y + 0.5);
  }

  /** Words on a plate of their own. */
  label(at: ScreenPoint, text: string, plate: string, ink: string): void {
    const pen = this.pen_;
    pen.font = '600 14px "Inter Variable", Inter, system-ui, sans-serif';
    const half = kLetter * text.length + 10;
    pen.save();
    pen.translate(at.x, at.y);
    this.box(half + 1, 14, 14, withAlpha(ink, 0.2));
    this.box(half, 13, 13, plate);
    pen.restore();
    pen.fillStyle = ink;
    pen.textAlign = 'center';
    pen.textBaseline = 'middle';
    pen.fillText(text, at.x, at.y + 0.5);
  }

  /** Where a way ends that leads no farther, or a place that nobody can get to. */
  cross(at: ScreenPoint, colours: MarkColours, half = 6): void {
    const stroke = (dx: number): ScreenPoint[] => [
      { x: at.x - dx, y: at.y - half },
      { x: at.x + dx, y: at.y + half },
    ];
    const width = 0.56 * half;
    for (const dx of [half, -half]) this.cased(stroke(dx), colours, 0, 2 * width);
    for (const dx of [half, -half]) this.cased(stroke(dx), { ...colours, casing: colours.accent }, width, width);
  }

  /** A raised hand on a disc: who holds. */
  holdBadge(at: ScreenPoint, colours: MarkColours, ink: string): void {
    this.disc(at, 11.5, colours.casing);
    this.disc(at, 10, colours.accent);
    const fingers = [-3.6, -1.2, 1.2, 3.6].map((x, i) => [
      { x, y: [-3, -5.4, -5.6, -4][i]! },
      { x, y: 2 },
    ]);
    for (const parts of [
      ...fingers,
      [
        { x: -6, y: -0.4 },
        { x: -3, y: 4 },
      ],
    ])
      this.cased(
        parts.map(({ x, y }) => ({ x: at.x + x, y: at.y + y })),
        { accent: ink, casing: ink },
        1.7,
        1.7,
      );
    this.pen_.fillStyle = ink;
    this.pen_.fillRect(at.x - 4.4, at.y, 8.8, 5);
  }

  /** The head of an arrow where a finger lifted; `angle` on the screen [rad]. */
  chevron(at: ScreenPoint, angle: number, colours: MarkColours): void {
    const pen = this.pen_;
    pen.save();
    pen.translate(at.x, at.y);
    pen.rotate(angle);
    pen.beginPath();
    pen.moveTo(7, 0);
    pen.lineTo(-6.5, 6);
    pen.lineTo(-3.2, 0);
    pen.lineTo(-6.5, -6);
    pen.closePath();
    this.stroke(colours.casing, 4);
    pen.fillStyle = colours.accent;
    pen.fill();
    pen.restore();
  }

  /** Under a finger, wider than its tip; `size` 0 to 1. */
  ring(at: ScreenPoint, colours: MarkColours, size: number): void {
    const phone = this.wide_ <= kPhoneWidth;
    const radius = ((phone ? kPhoneRing : kRing) / 2) * size;
    if (!phone) this.disc(at, radius, withAlpha(colours.accent, 0.13));
    this.circle(at, radius + 1.5, withAlpha(colours.casing, 0.85), 1.5);
    this.circle(at, radius, colours.accent, 2);
  }

  /** Of the keys: a ring, and a cross that leaves its middle free. */
  cursor({ x, y }: ScreenPoint, colours: MarkColours): void {
    const arms = [
      [1, 0],
      [-1, 0],
      [0, 1],
      [0, -1],
    ].map(([dx, dy]) => [kCursor.from, kCursor.to].map((r) => ({ x: x + r * dx!, y: y + r * dy! })));
    for (const [colour, width] of [
      [colours.casing, 6],
      [colours.accent, 2.6],
    ] as const) {
      for (const arm of arms) this.cased(arm, { accent: colour, casing: colour }, width, width);
      this.circle({ x, y }, kCursor.ring, colour, width);
    }
  }

  /** A pin that sticks in a handle: it stays where it is. */
  pin(at: ScreenPoint, colours: MarkColours, ink: string): void {
    const head = { x: at.x + 6, y: at.y - 21 };
    const needle = [at, { x: at.x + 4.4, y: at.y - 15.5 }];
    this.cased(needle, { accent: ink, casing: colours.casing }, 2.2, 5.4);
    this.disc(head, 8, colours.casing);
    this.disc(head, 6.4, ink);
    this.disc({ x: head.x - 1.8, y: head.y - 1.8 }, 1.7, colours.casing);
  }

  pointHandle(at: ScreenPoint, colours: MarkColours, size: number): void {
    this.disc(at, (kHandle / 2 + 1.5) * size, colours.casing);
    this.disc(at, (kHandle / 2) * size, colours.accent);
    this.disc(at, 7.6 * size, colours.casing);
    this.disc(at, 4.4 * size, colours.accent);
  }

  /** A capsule across the bar; `angle` of the bar [rad]. */
  lineHandle(at: ScreenPoint, angle: number, colours: MarkColours, size: number): void {
    const pen = this.pen_;
    pen.save();
    pen.translate(at.x, at.y);
    pen.rotate(angle + Math.PI / 2);
    pen.scale(size, size);
    this.box(15, 10.5, 10.5, colours.casing);
    this.box(13.5, 9, 9, colours.accent);
    this.box(10.4, 5.9, 5.9, colours.casing);
    this.box(5.5, 1.9, 1.9, colours.accent);
    pen.restore();
  }

  areaHandle(at: ScreenPoint, colours: MarkColours, size: number): void {
    const pen = this.pen_;
    pen.save();
    pen.translate(at.x, at.y);
    pen.scale(size, size);
    this.box(12, 12, 6.5, colours.casing);
    this.box(10.5, 10.5, 5.5, colours.accent);
    this.box(7.8, 7.8, 3.2, colours.casing);
    pen.beginPath();
    pen.moveTo(0, -4.4);
    pen.lineTo(4.6, 3.7);
    pen.lineTo(-4.6, 3.7);
    pen.closePath();
    pen.fillStyle = colours.accent;
    pen.fill();
    pen.restore();
  }

  /** A supplementary point. */
  softPoint(at: ScreenPoint, colours: MarkColours): void {
    this.disc(at, 3.1, colours.accent);
    this.disc(at, 1.9, colours.casing);
  }

  /** The part of a mesh that an area holds. */
  hull(points: readonly ScreenPoint[], colours: MarkColours): void {
    if (points.length < 3) return;
    this.trace(points, true);
    this.pen_.fillStyle = withAlpha(colours.accent, 0.17);
    this.pen_.fill();
    const hatch = this.hatchOf(colours.accent);
    if (hatch) {
      this.pen_.fillStyle = hatch;
      this.pen_.fill();
    }
    this.stroke(withAlpha(colours.casing, 0.7), 5);
    this.stroke(colours.accent, 3);
  }

  /** A filled outline with a thin rim, for a lasso. */
  veil(points: readonly ScreenPoint[], colour: string): void {
    if (points.length < 3) return;
    this.trace(points, true);
    this.pen_.fillStyle = withAlpha(colour, 0.1);
    this.pen_.fill();
  }

  private hatchOf(colour: string): CanvasPattern | null {
    const known = this.hatch_.get(colour);
    if (known !== undefined) return known;
    const tile = document.createElement('canvas');
    tile.width = 8;
    tile.height = 8;
    const pen = tile.getContext('2d');
    let pattern: CanvasPattern | null = null;
    if (pen) {
      pen.strokeStyle = withAlpha(colour, 0.22);
      pen.lineWidth = 1;
      for (const shift of [-8, 0, 8]) {
        pen.beginPath();
        pen.moveTo(shift - 1, 9);
        pen.lineTo(shift + 9, -1);
        pen.stroke();
      }
      pattern = this.pen_.createPattern(tile, 'repeat');
    }
    this.hatch_.set(colour, pattern);
    return pattern;
  }

  private trace(points: readonly ScreenPoint[], closed: boolean): void {
    this.pen_.beginPath();
    points.forEach((point, i) => (i === 0 ? this.pen_.moveTo(point.x, point.y) : this.pen_.lineTo(point.x, point.y)));
    if (closed) this.pen_.closePath();
  }

  private stroke(colour: string, width: number): void {
    this.pen_.strokeStyle = colour;
    this.pen_.lineWidth = width;
    this.pen_.stroke();
  }

  private disc(at: ScreenPoint, radius: number, colour: string): void {
    this.pen_.beginPath();
    this.pen_.arc(at.x, at.y, Math.max(0, radius), 0, 2 * Math.PI);
    this.pen_.fillStyle = colour;
    this.pen_.fill();
  }

  private circle(at: ScreenPoint, radius: number, colour: string, width: number): void {
    this.pen_.beginPath();
    this.pen_.arc(at.x, at.y, Math.max(0, radius), 0, 2 * Math.PI);
    this.stroke(colour, width);
  }

  private box(halfWidth: number, halfHeight: number, radius: number, colour: string): void {
    this.pen_.beginPath();
    this.pen_.roundRect(-halfWidth, -halfHeight, 2 * halfWidth, 2 * halfHeight, radius);
    this.pen_.fillStyle = colour;
    this.pen_.fill();
  }
}
