import { describe, expect, it } from 'vitest';
import { insideMesh, makeTopology, readLoops } from './mesh_topology';

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
    expect(readLoops([3, 0, 1, 2, 4, 5, 6, 7, 8])).toEqual([[0, 1, 2], [5, 6, 7, 8]]);
    expect(readLoops([3, 0, 1, 2, 9, 5])).toEqual([[0, 1, 2]]);
    expect(readLoops([0, 0])).toEqual([]);
  });

  it('knows what is inside, whichever way triangles turn', () => {
    const vertices = [0, 0, 1, 0, 1, 1, 0, 1];
    for (const triangles of [[0, 1, 2, 0, 2, 3], [0, 2, 1, 0, 3, 2]]) {
      const topology = makeTopology({ ...kSquare, triangles });
      expect(insideMesh(topology, vertices, 0.3, 0.8)).toBe(true);
      expect(insideMesh(topology, vertices, 1.01, 0.5)).toBe(false);
    }
  });

  it('a large mesh has edges by Euler: inside and rim together', () => {
    const side = 20;
    const triangles: number[] = [];
    const rim: number[] = [];
    const n = side + 1;
    for (let j = 0; j < side; ++j) for (let i = 0; i < side; ++i) {
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
