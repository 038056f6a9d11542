// A stroke across formations: which of them it cuts, and along which line.

import { distance, insidePolygon, turn, type GroundPoint } from './plane';

/** A formation that a stroke may cut. */
export interface Cuttable {
  readonly group: number;
  readonly index: number;
  /** The hull of its mesh. */
  readonly outline: readonly GroundPoint[];
  readonly places: readonly GroundPoint[];
}

/** A cut: those to the left of the line leave. */
export interface Cut {
  readonly group: number;
  readonly index: number;
  readonly from: GroundPoint;
  readonly to: GroundPoint;
  /** How many places lie to the left, and to the right. */
  readonly left: number;
  readonly right: number;
}

/** A stroke must cover so much of the way across. */
const kAcross = 0.7;
const kShortest = 0.5;

/** Where a line enters and leaves a convex outline, in metres from `from` towards `to`; null where it misses it. */
export function chordOf(
  outline: readonly GroundPoint[],
  from: GroundPoint,
  to: GroundPoint,
): readonly [number, number] | null {
  const length = distance(from, to);
  if (length === 0) return null;
  const hits: number[] = [];
  outline.forEach((a, i) => {
    const b = outline[(i + 1) % outline.length]!;
    const [sideA, sideB] = [turn(from, to, a), turn(from, to, b)];
    if (sideA > 0 === sideB > 0) return;
    const t = sideA / (sideA - sideB);
    const at = { x: a.x + (b.x - a.x) * t, y: a.y + (b.y - a.y) * t };
    hits.push(((at.x - from.x) * (to.x - from.x) + (at.y - from.y) * (to.y - from.y)) / length);
  });
  return hits.length < 2 ? null : [Math.min(...hits), Math.max(...hits)];
}

/** The cut of one formation by a line that is drawn from end to end, or null. */
function cutOf(one: Cuttable, from: GroundPoint, to: GroundPoint): { cut: Cut; across: number } | null {
  const chord = chordOf(one.outline, from, to);
  if (!chord) return null;
  const [enters, leaves] = chord;
  const covered = Math.min(distance(from, to), leaves) - Math.max(0, enters);
  if (covered < kAcross * (leaves - enters)) return null;
  const left = one.places.filter((place) => turn(from, to, place) > 0).length;
  const { group, index, places } = one;
  return { cut: { group, index, from, to, left, right: places.length - left }, across: covered };
}

/** The formation that a stroke cuts most of, from its first point to its last; null where it crosses none. */
export function cutBy(stroke: readonly GroundPoint[], formations: readonly Cuttable[]): Cut | null {
  const [from, to] = [stroke[0], stroke[stroke.length - 1]];
  if (!from || !to || distance(from, to) < kShortest) return null;
  const cuts = formations.map((one) => cutOf(one, from, to)).filter((one) => one !== null);
  const best = cuts.reduce<(typeof cuts)[number] | null>((a, b) => (a && a.across >= b.across ? a : b), null);
  return best?.cut ?? null;
}

/** The two formations in which a stroke begins and ends, where they differ. */
export function joinedBy(
  stroke: readonly GroundPoint[],
  formations: readonly Cuttable[],
): { readonly dragged: Cuttable; readonly onto: Cuttable } | null {
  const [from, to] = [stroke[0], stroke[stroke.length - 1]];
  if (!from || !to) return null;
  const holding = (at: GroundPoint): Cuttable | undefined => formations.find((one) => insidePolygon(at, one.outline));
  const [dragged, onto] = [holding(from), holding(to)];
  return dragged && onto && dragged.group !== onto.group ? { dragged, onto } : null;
}

/** The line across the middle between two fingers that were pulled apart, square to their line. */
export function lineBetween(a: GroundPoint, b: GroundPoint, half: number): readonly [GroundPoint, GroundPoint] {
  const middle = { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
  const length = Math.max(1e-6, distance(a, b));
  const across = { x: (-(b.y - a.y) / length) * half, y: ((b.x - a.x) / length) * half };
  return [
    { x: middle.x - across.x, y: middle.y - across.y },
    { x: middle.x + across.x, y: middle.y + across.y },
  ];
}
