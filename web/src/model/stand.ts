// How a group would stand: every place on the real ground, and which of them nobody can get to.

import { Standing, type PlacesFrame } from '../protocol/messages';
import { frontLine, outlineOf, placed } from './group_shapes';
import { pointsOf, type GroundPoint } from './plane';
import { StandingGrid } from './standing_grid';

/** A place and heading of a formation. */
export interface StandPose extends GroundPoint {
  /** [rad] */
  readonly facing: number;
}

/** One group's places, to be drawn. */
export interface Stand {
  /** Index into the frame's groups. */
  readonly index: number;
  readonly places: readonly GroundPoint[];
  readonly outline: readonly GroundPoint[];
  readonly front: readonly [GroundPoint, GroundPoint];
  /** Per place: 0 where somebody can stand there. */
  readonly unfit: ArrayLike<number>;
}

/** Where people are. */
interface StandingPeople {
  readonly x: ArrayLike<number>;
  readonly y: ArrayLike<number>;
}

/** Words about places, and whether they warn. */
export interface StandWords {
  readonly text: string;
  readonly warns: boolean;
}

export function standOf({ places, unfit }: PlacesFrame, index: number, { x, y, facing }: StandPose): Stand {
  const points = pointsOf(places);
  const own = placed(
    points.map((point) => ({ x: point.x - x, y: point.y - y })),
    { x: 0, y: 0 },
    -facing,
  );
  const [left, right] = placed(frontLine(own), { x, y }, facing);
  return { index, places: points, outline: outlineOf(points), front: [left!, right!], unfit };
}

/** The same places elsewhere. */
export function movedStand(stand: Stand, dx: number, dy: number): Stand {
  const moved = ({ x, y }: GroundPoint): GroundPoint => ({ x: x + dx, y: y + dy });
  const [left, right] = stand.front;
  const [places, outline] = [stand.places.map(moved), stand.outline.map(moved)];
  return { ...stand, places, outline, front: [moved(left), moved(right)] };
}

/** Per place: 1 where somebody stands nearer than `apart` [m]. */
export function takenPlaces(places: readonly GroundPoint[], { x, y }: StandingPeople, apart: number): number[] {
  const grid = new StandingGrid();
  const pairs = Float32Array.from({ length: 2 * x.length }, (_, k) => (k % 2 === 0 ? x : y)[k >> 1]!);
  grid.fill(pairs, 2, x.length);
  return places.map((at) => Number(grid.someoneNear(at.x, at.y, apart)));
}

function countOf(unfit: ArrayLike<number>, counts: (bar: number) => boolean): number {
  let count = 0;
  for (let i = 0; i < unfit.length; ++i) if (counts(unfit[i]!)) count += 1;
  return count;
}

/** How many spots cannot be reached. */
export function unfitCount(unfit: ArrayLike<number>): number {
  return countOf(unfit, (bar) => bar !== Standing.InPlace);
}

/** Where spots lie that cannot be reached, if all lie there. */
const kWhere: readonly (readonly [Standing, string])[] = [
  [Standing.Outside, 'lie outside the ground'],
  [Standing.Obstacle, 'lie in obstacles'],
];

/** "7 of 60 spots lie outside the ground"; in all groups together. */
export function unfitWords(unfits: readonly ArrayLike<number>[]): StandWords {
  const all = unfits.reduce((sum, unfit) => sum + unfit.length, 0);
  const sumOf = (counts: (bar: number) => boolean): number =>
    unfits.reduce((sum, unfit) => sum + countOf(unfit, counts), 0);
  const bad = sumOf((bar) => bar !== Standing.InPlace);
  if (all === 0) return { text: '', warns: false };
  if (bad === 0)
    return { text: all === 1 ? 'The spot can be reached' : `All ${all} spots can be reached`, warns: false };
  const where = kWhere.find(([standing]) => sumOf((bar) => bar === standing) === bad);
  return { text: `${bad} of ${all} spots ${where?.[1] ?? 'cannot be reached'}`, warns: true };
}
