import { describe, expect, it } from 'vitest';
import type { GroupMesh } from '../protocol/messages';
import type { StudioGroup } from '../model/studio_frame';
import { kIdle } from '../model/test_frames';
import { FormationHitTest, fingertipFrom, metresFrom } from './formation_hit_test';

function square(group: number, x: number, version = 1): { mesh: GroupMesh; frame: StudioGroup } {
  return {
    mesh: {
      type: 'GroupMesh',
      group,
      version,
      formation: 'square',
      spacing: 1,
      rest: new Float32Array(),
      triangles: new Uint32Array([0, 1, 2, 0, 2, 3]),
      boundary: new Uint32Array([4, 0, 1, 2, 3]),
      placeTriangles: new Uint32Array(),
      placeWeights: new Float32Array(),
    },
    frame: {
      id: group,
      meshVersion: version,
      lag: 0,
      walkSum: 0,
      walkSquares: 0,
      walkLongest: 0,
      vertices: new Float32Array([x, 0, x + 4, 0, x + 4, 4, x, 4]),
      places: new Float32Array(),
      fit: new Uint8Array(),
      standings: new Uint32Array(),
      controls: [],
      ...kIdle,
      orders: [],
    },
  };
}

function hitTest(...squares: { mesh: GroupMesh; frame: StudioGroup }[]): FormationHitTest {
  const test = new FormationHitTest();
  for (const { mesh } of squares) test.setMesh(mesh);
  test.setGroups(squares.map(({ frame }) => frame));
  return test;
}

describe('FormationHitTest', () => {
  it('finds the mesh that holds the point', () => {
    const test = hitTest(square(7, 0), square(9, 10));
    expect(test.find({ x: 2, y: 2 }, metresFrom({ x: 2, y: 2 }, 1))).toEqual({ index: 0, group: 7, distance: 0 });
    expect(test.find({ x: 12, y: 2 }, metresFrom({ x: 12, y: 2 }, 1))).toEqual({ index: 1, group: 9, distance: 0 });
  });
  it('takes the nearest rim within reach', () => {
    const test = hitTest(square(7, 0), square(9, 5));
    expect(test.find({ x: 4.8, y: 2 }, metresFrom({ x: 4.8, y: 2 }, 1))?.group).toBe(9);
    expect(test.find({ x: 4.2, y: 2 }, metresFrom({ x: 4.2, y: 2 }, 1))?.group).toBe(7);
    expect(test.find({ x: 4.2, y: 2 }, metresFrom({ x: 4.2, y: 2 }, 0.1))).toBeNull();
  });
  it('calls the rest empty ground', () => {
    expect(hitTest(square(7, 0)).find({ x: 9, y: 9 }, metresFrom({ x: 9, y: 9 }, 1.5))).toBeNull();
    expect(new FormationHitTest().find({ x: 0, y: 0 }, metresFrom({ x: 0, y: 0 }, 1))).toBeNull();
  });
  it('ignores vertices of another mesh version', () => {
    const old = square(7, 0);
    const test = new FormationHitTest();
    test.setMesh({ ...old.mesh, version: 2 });
    test.setGroups([old.frame]);
    expect(test.find({ x: 2, y: 2 }, metresFrom({ x: 2, y: 2 }, 1))).toBeNull();
  });
});

describe('fingertipFrom', () => {
  // A view from low above the ground: a metre is 40 px wide and 20 px high.
  const toScreen = ({ x, y }: { x: number; y: number }) => ({ x: 40 * x, y: -20 * y });
  const at = (x: number, y: number) => hitTest(square(7, 0)).find({ x, y }, fingertipFrom({ x, y }, toScreen));
  it('reaches 24 px on the screen, in depth as well as sideways', () => {
    expect(at(4.55, 2)?.distance).toBeCloseTo(22);
    expect(at(4.65, 2)).toBeNull();
    expect(at(2, 5.1)?.distance).toBeCloseTo(22);
    expect(at(2, 5.3)).toBeNull();
  });
  it('is never more than 1.5 m nor less than 0.3 m', () => {
    const near = (scale: number, x: number) => {
      const scaled = (p: { x: number; y: number }) => ({ x: scale * p.x, y: scale * p.y });
      return hitTest(square(7, 0)).find({ x, y: 2 }, fingertipFrom({ x, y: 2 }, scaled));
    };
    expect(near(4, 5.4)).not.toBeNull();
    expect(near(4, 5.6)).toBeNull();
    expect(near(200, 4.28)).not.toBeNull();
    expect(near(200, 4.32)).toBeNull();
  });
});
