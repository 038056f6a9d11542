import { describe, expect, it } from 'vitest';
import { makeTopology, readLoops, rimOf } from './mesh_topology';

// Two triangles of a unit square.
const kSquare = { group: 1, version: 3, formation: 'square', triangles: [0, 1, 2, 0, 2, 3], boundary: [4, 0, 1, 2, 3] };

describe('mesh topology', () => {
  it('tells the rim from the inside', () => {
    const topology = makeTopology(kSquare);
    expect([...topology.rim]).toEqual([0, 1, 1, 2, 2, 3, 3, 0]);
    expect([...topology.inside]).toEqual([2, 0]);
    expect(topology.version).toBe(3);
  });

  it('reads several loops and leaves a torn one out', () => {
    expect(readLoops([3, 0, 1, 2, 4, 5, 6, 7, 8])).toEqual([
      [0, 1, 2],
      [5, 6, 7, 8],
    ]);
    expect(readLoops([3, 0, 1, 2, 9, 5])).toEqual([[0, 1, 2]]);
    expect(readLoops([0, 0])).toEqual([]);
    expect(rimOf([3, 0, 1, 2, 2, 5, 6])).toEqual([0, 1, 1, 2, 2, 0, 5, 6, 6, 5]);
  });

  it('a large mesh has edges by Euler: inside and rim together', () => {
    const side = 20;
    const triangles: number[] = [];
    const rim: number[] = [];
    const n = side + 1;
    for (let j = 0; j < side; ++j)
      for (let i = 0; i < side; ++i) {
        const a = j * n + i;
        triangles.push(a, a + 1, a + n + 1, a, a + n + 1, a + n);
      }
    for (let i = 0; i < side; ++i) rim.push(i);
    for (let j = 0; j < side; ++j) rim.push(j * n + side);
    for (let i = side; i > 0; --i) rim.push(side * n + i);
    for (let j = side; j > 0; --j) rim.push(j * n);
    const topology = makeTopology({ ...kSquare, triangles, boundary: [rim.length, ...rim] });
    const edges = (topology.inside.length + topology.rim.length) / 2;
    expect(n * n - edges + triangles.length / 3).toBe(1);
  });
});
