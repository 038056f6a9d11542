import { describe, expect, it } from 'vitest';
import type { SceneObstacle } from '../protocol/scene';
import { GeometryBuilder } from './geometry_builder';
import { addCar, addObstacle, boxOf, kCutHeight, lookOfObstacle, makeTreeGeometry } from './obstacle_geometry';
import { paletteOf } from './palette';
import { outerEdges } from './outer_edges';

const kHouse: SceneObstacle = { id: 1, name: 'House', polygon: [[0, 0], [4, 0], [4, 3], [0, 3]], height: 9, moving: false };

function disc(name: string): SceneObstacle {
  return { id: 2, name, centre: [1, 1], radius: 0.5, height: 2, moving: false };
}

describe('obstacles', () => {
  it('are told apart by name and shape', () => {
    expect(lookOfObstacle(kHouse)).toBe('building');
    expect(lookOfObstacle(disc('Tree 4'))).toBe('tree');
    expect(lookOfObstacle(disc('Fountain'))).toBe('fountain');
    expect(lookOfObstacle(disc(''))).toBe('pillar');
    expect(lookOfObstacle({ ...kHouse, name: 'red car' })).toBe('car');
    expect(lookOfObstacle({ ...kHouse, name: 'Carlton house' })).toBe('building');
    expect(lookOfObstacle({ ...kHouse, name: 'Upper hedge' })).toBe('hedge');
    expect(lookOfObstacle({ ...kHouse, name: '', moving: true })).toBe('car');
  });

  it('are cut at 3.2 m, with an edge line per side', () => {
    const builder = new GeometryBuilder();
    const edges = addObstacle(builder, kHouse, paletteOf('light'));
    expect(edges).toHaveLength(4);
    const geometry = builder.build();
    geometry.computeBoundingBox();
    expect(geometry.boundingBox?.max.z).toBeCloseTo(kCutHeight);
  });

  it('edges that two pieces share are left out', () => {
    const builder = new GeometryBuilder();
    const left = addObstacle(builder, kHouse, paletteOf('light'));
    const right = addObstacle(builder, { ...kHouse, polygon: [[4, 0], [8, 0], [8, 3], [4, 3]] }, paletteOf('light'));
    const length = outerEdges([...left, ...right]).reduce((sum, [a, b]) => sum + Math.hypot(b[0] - a[0], b[1] - a[1]), 0);
    expect(length).toBeCloseTo(8 + 3 + 8 + 3);
  });

  it('a car fills its box, whichever way it is turned', () => {
    const c = Math.cos(0.7);
    const s = Math.sin(0.7);
    const outline = ([[-2, -1], [2, -1], [2, 1], [-2, 1]] as const).map(([x, y]) => [5 + c * x - s * y, s * x + c * y] as const);
    const box = boxOf(outline);
    expect(box.length).toBeCloseTo(2);
    expect(box.width).toBeCloseTo(1);
    expect(box.x).toBeCloseTo(5);
    const builder = new GeometryBuilder();
    for (const height of [1.4, 3]) addCar(builder, outline, height, '#FF0000', paletteOf('light'));
    const p = builder.build().attributes['position']?.array ?? [];
    for (let i = 0; i < p.length; i += 3) {
      const dx = (p[i] ?? 0) - 5;
      const dy = p[i + 1] ?? 0;
      expect(Math.abs(c * dx + s * dy)).toBeLessThan(2.001);
      expect(Math.abs(-s * dx + c * dy)).toBeLessThan(1.001);
    }
  });

  it('a tree stays small in triangles', () => {
    const geometry = makeTreeGeometry(paletteOf('dark'));
    const triangles = (geometry.attributes['position']?.count ?? 0) / 3;
    expect(triangles).toBeGreaterThan(60);
    expect(triangles).toBeLessThan(400);
  });
});
