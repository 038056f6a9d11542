import { describe, expect, it } from 'vitest';
import type { EdgeLine } from './obstacle_geometry';
import { outerEdges } from './outer_edges';

function box(x0: number, y0: number, x1: number, y1: number): EdgeLine[] {
  const corners = [
    [x0, y0],
    [x1, y0],
    [x1, y1],
    [x0, y1],
  ] as const;
  return corners.map((a, i) => {
    const b = corners[(i + 1) % 4] ?? a;
    return [
      [a[0], a[1], 3],
      [b[0], b[1], 3],
    ] as const;
  });
}

function total(edges: readonly EdgeLine[]): number {
  return edges.reduce((sum, [a, b]) => sum + Math.hypot(b[0] - a[0], b[1] - a[1]), 0);
}

describe('outerEdges', () => {
  it('leaves a lone piece as it is', () => {
    expect(total(outerEdges(box(0, 0, 2, 3)))).toBeCloseTo(10);
  });

  it('has the perimeter of any union of cells, as counted cell by cell', () => {
    const cells = new Set<string>();
    for (let i = 0; i < 60; ++i) cells.add(`${(i * 7) % 11},${(i * 5) % 9}`);
    let perimeter = 0;
    const edges: EdgeLine[] = [];
    for (const cell of cells) {
      const [x, y] = cell.split(',').map(Number) as [number, number];
      edges.push(...box(x, y, x + 1, y + 1));
      for (const [dx, dy] of [
        [1, 0],
        [-1, 0],
        [0, 1],
        [0, -1],
      ] as const) {
        if (!cells.has(`${x + dx},${y + dy}`)) ++perimeter;
      }
    }
    expect(total(outerEdges(edges))).toBeCloseTo(perimeter);
  });

  it('cancels where pieces touch along a part of a side only', () => {
    expect(total(outerEdges([...box(0, 0, 4, 1), ...box(1, 1, 2, 3)]))).toBeCloseTo(10 + 6 - 2);
  });

  it('keeps roofs of different heights apart', () => {
    const low = box(0, 0, 1, 1);
    const high = box(1, 0, 2, 1).map(
      ([a, b]) =>
        [
          [a[0], a[1], 5],
          [b[0], b[1], 5],
        ] as const,
    );
    expect(total(outerEdges([...low, ...high]))).toBeCloseTo(8);
  });
});
