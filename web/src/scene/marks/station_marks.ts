// Formations that a group takes up along its way, as small outlines of dots above the spots where it does.

import { dotsOfFormation, kSize, type Dot } from '../../model/formation_dots';
import type { GroundPoint, ScreenPoint } from '../../model/plane';
import type { QueueOrder } from '../../model/queue_order';
import type { Palette } from '../drawing/palette';
import type { MarkColours, MarkPainter } from './mark_painter';

interface Leg {
  readonly order: QueueOrder;
  readonly points: readonly GroundPoint[];
}

interface Eye {
  worldToScreen(x: number, y: number): ScreenPoint;
}

interface Station {
  readonly at: ScreenPoint;
  readonly dots: readonly Dot[];
}

/** Above the way, clear of the numbers on it [CSS px]. */
const kAbove = 33;
const kDot = 1.7;
/** Half of a number on the way [CSS px]. */
const kBadge = 11;

/** What the first order took up when it began is seen on the group itself. */
function stationsOf(legs: readonly Leg[], eye: Eye): Station[] {
  return legs.slice(1).flatMap(({ order, points }): Station[] => {
    const dots = order.formation ? dotsOfFormation(order.formation) : [];
    const from = points[0];
    if (dots.length === 0 || !from) return [];
    const { x, y } = eye.worldToScreen(from.x, from.y);
    return [{ at: { x, y: y - kAbove }, dots }];
  });
}

export function stationSpots(legs: readonly Leg[], eye: Eye): ScreenPoint[] {
  return stationsOf(legs, eye).map(({ at }) => at);
}

export function drawStations(
  painter: MarkPainter,
  legs: readonly Leg[],
  colours: MarkColours,
  { camera, palette }: { readonly camera: Eye; readonly palette: Palette },
): void {
  for (const { at, dots } of stationsOf(legs, camera)) {
    painter.cased(
      [
        { x: at.x, y: at.y + kSize / 2 },
        { x: at.x, y: at.y + kAbove - kBadge },
      ],
      colours,
      1.8,
      4.4,
    );
    painter.dot(at, kSize / 2 + 3, colours.casing);
    painter.dot(at, kSize / 2 + 1.6, colours.accent);
    painter.dot(at, kSize / 2, palette.panel);
    for (const [x, y] of dots)
      painter.dot({ x: at.x + 0.8 * (x - kSize / 2), y: at.y + 0.8 * (y - kSize / 2) }, kDot, colours.accent);
  }
}

/** True where a group takes up another formation on its way than ranks as wide as they are drawn. */
export function changesShape(legs: readonly Leg[]): boolean {
  return legs.slice(1).some(({ order: { formation } }) => formation !== null && formation.kind !== 'square');
}
