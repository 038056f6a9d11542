// People along lines: on every end and corner, and evenly between them.

import { distance, type GroundPoint, lengthOf } from '../plane';
import type { Stroke } from './stroke_font';

/** A line between two places that are taken in any case. */
interface Edge {
  readonly points: readonly GroundPoint[];
  readonly length: number;
  inside: number;
}

export interface LinePlaces {
  readonly places: readonly GroundPoint[];
  /** Between neighbours along the lines. */
  readonly gap: number;
}

const keyOf = ({ x, y }: GroundPoint): string => `${Math.round(x * 1e4)} ${Math.round(y * 1e4)}`;

/** The point of a line so far along it. */
function pointAlong(points: readonly GroundPoint[], away: number): GroundPoint {
  let left = away;
  for (let i = 0; i + 1 < points.length; ++i) {
    const [a, b] = [points[i]!, points[i + 1]!];
    const length = distance(a, b);
    if (left <= length && length > 0)
      return { x: a.x + ((b.x - a.x) * left) / length, y: a.y + ((b.y - a.y) * left) / length };
    left -= length;
  }
  return points[points.length - 1]!;
}

function edgesOf(strokes: readonly Stroke[]): Edge[] {
  return strokes.flatMap(({ points, nodes }) =>
    nodes.slice(1).map((to, i) => {
      const piece = points.slice(nodes[i], to + 1);
      return { points: piece, length: lengthOf(piece), inside: 0 };
    }),
  );
}

/** Exactly so many places along lines; null where there are not even enough for the ends and corners. */
export function placesAlong(strokes: readonly Stroke[], count: number): LinePlaces | null {
  const ends = new Map<string, GroundPoint>();
  for (const { points, nodes } of strokes) for (const node of nodes) ends.set(keyOf(points[node]!), points[node]!);
  const edges = edgesOf(strokes);
  let left = count - ends.size;
  if (left < 0 || (edges.length === 0 && left > 0)) return null;
  // Each next person goes where the gap is widest.
  const gapOf = ({ length, inside }: Edge): number => length / (inside + 1);
  for (; left > 0; --left) {
    edges.reduce((best, edge) => (gapOf(edge) > gapOf(best) ? edge : best)).inside += 1;
  }
  const between = edges.flatMap(({ points, length, inside }) =>
    Array.from({ length: inside }, (_, i) => pointAlong(points, (length * (i + 1)) / (inside + 1))),
  );
  return { places: [...ends.values(), ...between], gap: Math.max(0, ...edges.map(gapOf)) };
}

/** The least distance of two places. */
export function leastDistance(places: readonly GroundPoint[]): number {
  const sorted = [...places].sort((a, b) => a.x - b.x);
  let least = Infinity;
  sorted.forEach((a, i) => {
    for (let j = i + 1; j < sorted.length && sorted[j]!.x - a.x < least; ++j)
      least = Math.min(least, distance(a, sorted[j]!));
  });
  return least;
}

/** Of neighbours on different lines: at least this share of the gap. */
const kApart = 0.6;
/** So many more are tried where lines cross each other. */
const kMoreTries = 40;

/** Like placesAlong, for lines that cross or touch: nobody stands much nearer to another than the gap. */
export function placesApart(strokes: readonly Stroke[], count: number): LinePlaces | null {
  for (let more = 0; more < kMoreTries; ++more) {
    const set = placesAlong(strokes, count + more);
    if (!set) continue;
    const kept: GroundPoint[] = [];
    for (const place of set.places)
      if (kept.every((other) => distance(other, place) >= kApart * set.gap)) kept.push(place);
    if (kept.length >= count) return { places: kept.slice(0, count), gap: set.gap };
  }
  return placesAlong(strokes, count);
}
