import { describe, expect, it } from 'vitest';
import type { SceneObstacle } from '../../protocol/messages';
import { GeometryBuilder } from '../drawing/geometry_builder';
import {
  addCar,
  addObstacle,
  boxOf,
  kCutHeight,
  lookOfObstacle,
  makeCrownGeometry,
  makeTrunkGeometry,
} from './obstacle_geometry';
import { paletteOf } from '../drawing/palette';
import { outerEdges } from './outer_edges';
import { kMoves, obstacleOf } from '../../protocol/test_scene';

const kHouse = obstacleOf({
  id: 1,
  name: 'House',
  polygon: [
    [0, 0],
    [4, 0],
    [4, 3],
    [0, 3],
  ],
  height: 9,
});

function disc(name: string): SceneObstacle {
  return obstacleOf({ id: 2, name, centre: [1, 1], radius: 0.5, height: 2 });
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
  });

  it('that move are cars only where they are called or sized like one', () => {
    const moving = (name: string, long: number, wide: number) =>
      lookOfObstacle({
        ...kHouse,
        name,
        path: kMoves,
        polygon: [
          [0, 0],
          [long, 0],
          [long, wide],
          [0, wide],
        ],
      });
    expect(moving('', 4.2, 1.8)).toBe('car');
    expect(moving('', 1.8, 4.2)).toBe('car');
    expect(moving('Bus', 12, 2.5)).toBe('car');
    expect(moving('', 0.5, 0.3)).toBe('mouse');
    expect(moving('Mouse', 1.5, 1)).toBe('mouse');
    expect(moving('', 2, 2)).toBe('building');
    expect(moving('Gate', 12, 1)).toBe('building');
    expect(moving('', 5, 5)).toBe('building');
  });

  it('that are mice stay small and low', () => {
    const builder = new GeometryBuilder();
    const mouse: SceneObstacle = {
      ...kHouse,
      name: 'Mouse',
      path: kMoves,
      height: 3,
      polygon: [
        [0, 0],
        [0.6, 0],
        [0.6, 0.4],
        [0, 0.4],
      ],
    };
    expect(addObstacle(builder, mouse, paletteOf('light'))).toEqual([]);
    const geometry = builder.build();
    geometry.computeBoundingBox();
    const { min, max } = geometry.boundingBox!;
    expect(max.z).toBeLessThan(0.5);
    expect(Math.min(min.x, min.y, min.z)).toBeGreaterThan(-0.1);
    expect(Math.max(max.x - 0.6, max.y - 0.4)).toBeLessThan(0.1);
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
    const right = addObstacle(
      builder,
      {
        ...kHouse,
        polygon: [
          [4, 0],
          [8, 0],
          [8, 3],
          [4, 3],
        ],
      },
      paletteOf('light'),
    );
    const length = outerEdges([...left, ...right]).reduce(
      (sum, [a, b]) => sum + Math.hypot(b[0] - a[0], b[1] - a[1]),
      0,
    );
    expect(length).toBeCloseTo(8 + 3 + 8 + 3);
  });

  it('a car fills its box, whichever way it is turned', () => {
    const c = Math.cos(0.7);
    const s = Math.sin(0.7);
    const outline = (
      [
        [-2, -1],
        [2, -1],
        [2, 1],
        [-2, 1],
      ] as const
    ).map(([x, y]) => [5 + c * x - s * y, s * x + c * y] as const);
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
    const palette = paletteOf('dark');
    const triangles = [makeCrownGeometry(palette), makeTrunkGeometry(palette)].reduce(
      (sum, geometry) => sum + geometry.attributes['position']!.count / 3,
      0,
    );
    expect(triangles).toBeGreaterThan(60);
    expect(triangles).toBeLessThan(400);
  });
});
