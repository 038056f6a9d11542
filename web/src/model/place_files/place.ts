// What a place is made of, as scenario files say it (docs/scenario-format.md), and what was read from other files.

import type { ObstacleDef, PatchDef, Point, WorldDef } from '../../protocol/generated/definitions';
import type { GroundPoint } from '../plane';

/** A scenario that has a name. */
export type PlaceDefinition = WorldDef & {
  readonly format: 'muster-scenario';
  readonly version: 1;
  readonly name: string;
};

/** The ground that something takes [m], counter-clockwise. */
export interface Outline {
  readonly name: string;
  readonly height: number;
  readonly corners: readonly GroundPoint[];
  /** People swim there. */
  readonly water?: boolean;
}

export interface Bounds {
  readonly min: GroundPoint;
  readonly max: GroundPoint;
}

/** Obstacles of a place, at most. */
export const kMostObstacles = 20000;
/** Heights that a scenario takes [m]. */
const kHeights = { least: 0.01, most: 1000 };
/** Lengths are written to the millimetre. */
const kDigits = 1000;

/** A file that cannot be used; the message is the sentence for the visitor. */
export class FileProblem extends Error {
  override name = 'FileProblem';
}

export const toMillimetre = (value: number): number => Math.round(value * kDigits) / kDigits;

export const pairOf = ({ x, y }: GroundPoint): Point => [toMillimetre(x), toMillimetre(y)];

/** Null where there are no points. */
export function boundsOf(points: Iterable<GroundPoint>): Bounds | null {
  let [left, bottom, right, top] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const { x, y } of points) {
    [left, bottom] = [Math.min(left, x), Math.min(bottom, y)];
    [right, top] = [Math.max(right, x), Math.max(top, y)];
  }
  return left > right ? null : { min: { x: left, y: bottom }, max: { x: right, y: top } };
}

export function boundsOfOutlines(outlines: readonly Outline[]): Bounds | null {
  return boundsOf(
    (function* () {
      for (const { corners } of outlines) yield* corners;
    })(),
  );
}

const nameOf = (name: string): string => [...name].slice(0, 80).join('');

/** The ground on which people swim, by the name of that motion or its index. */
export function waterOf<Motion extends string | number>(
  { name, corners }: Outline,
  motion: Motion,
): PatchDef & { readonly motion: Motion } {
  return { name: nameOf(name) || 'Water', polygon: corners.map(pairOf), motion };
}

export function obstacleOf({ name, height, corners }: Outline): ObstacleDef {
  return {
    name: nameOf(name),
    polygon: corners.map(pairOf),
    height: toMillimetre(Math.min(kHeights.most, Math.max(kHeights.least, height))),
  };
}

/** Scaled and turned [rad] about the middle of their box, which comes to stand at a point. */
export function placedOutlines(
  outlines: readonly Outline[],
  { scale, turn, at }: { readonly scale: number; readonly turn: number; readonly at: GroundPoint },
): Outline[] {
  const bounds = boundsOfOutlines(outlines);
  if (!bounds) return [];
  const [mx, my] = [(bounds.min.x + bounds.max.x) / 2, (bounds.min.y + bounds.max.y) / 2];
  const [c, s] = [scale * Math.cos(turn), scale * Math.sin(turn)];
  return outlines.map(({ height, corners, ...more }) => ({
    ...more,
    height: height * scale,
    corners: corners.map(({ x, y }) => ({
      x: at.x + c * (x - mx) - s * (y - my),
      y: at.y + s * (x - mx) + c * (y - my),
    })),
  }));
}
