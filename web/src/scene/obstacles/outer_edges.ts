// The outline of many pieces laid side by side: where two pieces touch there is no edge.

import type { Vec3 } from '../drawing/geometry_builder';
import type { EdgeLine } from './obstacle_geometry';

interface Span {
  /** Along the line's direction [m]. */
  readonly from: number;
  readonly to: number;
  /** +1 along the direction, -1 against it. */
  readonly sign: number;
}

interface Line {
  readonly ux: number;
  readonly uy: number;
  /** Distance of the line from the origin [m]. */
  readonly offset: number;
  readonly z: number;
  readonly spans: Span[];
}

/** Lines closer than this are one [m]. */
const kSame = 1e-3;

/**
 * Edges of counter-clockwise pieces, less the parts where two pieces lie side by side: there the edges run in opposite
 * directions and cancel, even where they only overlap in part.
 */
export function outerEdges(edges: readonly EdgeLine[]): EdgeLine[] {
  const lines = new Map<string, Line>();
  for (const [a, b] of edges) {
    const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
    if (length < 1e-9) continue;
    let ux = (b[0] - a[0]) / length;
    let uy = (b[1] - a[1]) / length;
    const sign = ux > 1e-9 || (Math.abs(ux) <= 1e-9 && uy > 0) ? 1 : -1;
    ux *= sign;
    uy *= sign;
    const offset = -uy * a[0] + ux * a[1];
    const key = [ux, uy, offset, a[2]].map((value) => Math.round(value / kSame)).join();
    const line = lines.get(key) ?? { ux, uy, offset, z: a[2], spans: [] };
    const from = ux * a[0] + uy * a[1];
    const to = ux * b[0] + uy * b[1];
    line.spans.push({ from: Math.min(from, to), to: Math.max(from, to), sign });
    lines.set(key, line);
  }
  return [...lines.values()].flatMap(uncovered);
}

/** The parts of a line where directions do not cancel. */
function uncovered(line: Line): EdgeLine[] {
  const ends = line.spans.flatMap((span) => [
    { at: span.from, add: span.sign },
    { at: span.to, add: -span.sign },
  ]);
  ends.sort((a, b) => a.at - b.at || a.add - b.add);
  const uncancelled: EdgeLine[] = [];
  const point = (along: number): Vec3 => [
    line.ux * along - line.uy * line.offset,
    line.uy * along + line.ux * line.offset,
    line.z,
  ];
  let cover = 0;
  let begin = 0;
  for (const { at, add } of ends) {
    if (cover === 0) begin = at;
    cover += add;
    if (cover === 0) uncancelled.push([point(begin), point(at)]);
  }
  return uncancelled.filter(([a, b]) => Math.hypot(b[0] - a[0], b[1] - a[1]) > kSame);
}
