import { describe, expect, it } from 'vitest';
import type { Vec2 } from '../../protocol/generated/commands';
import type { GeometryBuilder } from '../drawing/geometry_builder';
import { addArea } from './area_shapes';
import { addPatch, lookOfMotion } from './patch_geometry';
import { paletteOf } from '../drawing/palette';
import { blended, emptyParts, hatchChords, type PatchParts, postsAlong } from './patch_parts';
import { kBottom, kWaterLevel, widened } from './pool';
import { areaOf, patchOf } from '../../protocol/test_scene';

const kSquare: readonly Vec2[] = [
  [0, 0],
  [4, 0],
  [4, 4],
  [0, 4],
];

const kWay = { waypoints: [{ time: 0, position: [0, 0] as Vec2, angle: 0 }], loop: true };

function partsOf(clip: string, polygon = kSquare, moves = false): PatchParts {
  const parts = emptyParts();
  const patch = patchOf({ id: 1, polygon, ...(moves ? { path: kWay } : {}) });
  addPatch(parts, patch, clip, paletteOf('light'));
  return parts;
}

function boundsOf(builder: GeometryBuilder): { min: number[]; max: number[] } {
  const geometry = builder.build();
  geometry.computeBoundingBox();
  return { min: geometry.boundingBox!.min.toArray(), max: geometry.boundingBox!.max.toArray() };
}

describe('patches', () => {
  it('have an object by motion', () => {
    expect(['crawl', 'swim', 'climb', 'jump', 'duck', 'run'].map(lookOfMotion)).toEqual([
      'net',
      'pool',
      'wall',
      'jump',
      'branches',
      'plain',
    ]);
  });

  it('all have a floor but pools, and a dashed rim of their outline', () => {
    for (const clip of ['crawl', 'climb', 'jump', 'duck', 'run', 'swim']) {
      const parts = partsOf(clip);
      expect(parts.floor.triangleCount).toBe(clip === 'swim' ? 0 : 2);
      expect(parts.rim).toHaveLength(clip === 'swim' ? 0 : 4);
      expect(parts.opening.triangleCount).toBe(clip === 'swim' ? 2 : 0);
      expect(parts.leaves.triangleCount > 0).toBe(clip === 'duck');
    }
  });

  it('wall: 1.3 m high and 0.4 m thick, along the middle of the patch, whichever way it lies', () => {
    for (const outline of [
      [
        [-0.6, -7],
        [0.6, -7],
        [0.6, 7],
        [-0.6, 7],
      ],
      [
        [-7, -0.6],
        [7, -0.6],
        [7, 0.6],
        [-7, 0.6],
      ],
    ] as Vec2[][]) {
      const { min, max } = boundsOf(partsOf('climb', outline).solid);
      const sizes = [max[0]! - min[0]!, max[1]! - min[1]!].sort((a, b) => a - b);
      expect(sizes[0]).toBeCloseTo(0.4);
      expect(sizes[1]).toBeGreaterThan(13.8);
      expect([max[2], min[2]]).toEqual([expect.closeTo(1.3), expect.closeTo(0)]);
      expect(min[0]! + max[0]!).toBeCloseTo(0);
    }
  });

  it('net: nowhere lower than the back of one who crawls, nowhere higher than its posts', () => {
    const wide: Vec2[] = [
      [0, 0],
      [6, 0],
      [6, 15],
      [0, 15],
    ];
    const heights = partsOf('crawl', wide).lines.flatMap(({ line }) => [line[0][2], line[1][2]]);
    expect(Math.min(...heights)).toBeGreaterThan(0.66);
    expect(Math.min(...heights)).toBeLessThan(0.75);
    expect(Math.max(...heights)).toBeLessThanOrEqual(0.82);
  });

  it('pool: a basin below the ground, water just below its rim', () => {
    const parts = partsOf('swim');
    const { min, max } = boundsOf(parts.solid);
    expect(min[2]).toBeCloseTo(kBottom);
    expect(max[2]).toBeLessThan(0.05);
    expect(boundsOf(parts.water).min[2]).toBeCloseTo(kWaterLevel);
    // Walls face the water: seen from inside their area is that of the basin.
    const p = parts.solid.build().attributes['normal']!.array;
    expect(Array.from(p).filter((one, i) => i % 3 === 0 && one > 0.99).length).toBeGreaterThan(0);
    expect(widened(kSquare, 0.5)).toEqual([
      [-0.5, -0.5],
      [4.5, -0.5],
      [4.5, 4.5],
      [-0.5, 4.5],
    ]);
  });

  it('hedge, and mouse where it moves: half a metre high at most, whatever they are called', () => {
    const strip: Vec2[] = [
      [0, 0],
      [2, 0],
      [2, 8],
      [0, 8],
    ];
    const square = strip.map(([x, y]): Vec2 => [x, Math.min(2, y)]);
    for (const moves of [false, true]) {
      const { min, max } = boundsOf(partsOf('jump', moves ? square : strip, moves).solid);
      expect(max[2]).toBeGreaterThan(0.4);
      expect(max[2]).toBeLessThan(0.57);
      expect(min[2]).toBeGreaterThan(-0.1);
    }
  });

  it('branches: leaves above those who duck, in reach of those who do not', () => {
    const { min, max } = boundsOf(partsOf('duck').leaves);
    expect(min[2]).toBeGreaterThan(1.25);
    expect(min[2]).toBeLessThan(1.5);
    expect(max[2]).toBeLessThan(2.6);
    expect([min[0]! > -0.6, max[0]! < 4.6]).toEqual([true, true]);
  });

  it('posts stand at corners and no farther apart than asked', () => {
    const posts = postsAlong(kSquare, 1.5);
    expect(posts).toHaveLength(12);
    for (const corner of kSquare) expect(posts).toContainEqual(corner);
  });

  it('hatch chords add up to the area over their spacing, holes between arms left out', () => {
    const total = (outline: readonly Vec2[]): number =>
      hatchChords(outline, 0.6, 0.05).reduce((sum, [a, b]) => sum + Math.hypot(b[0] - a[0], b[1] - a[1]), 0) * 0.05;
    expect(total(kSquare)).toBeCloseTo(16, 0);
    const bay: readonly Vec2[] = [
      [0, 0],
      [6, 0],
      [6, 4],
      [4, 4],
      [4, 1],
      [2, 1],
      [2, 4],
      [0, 4],
    ];
    expect(total(bay)).toBeCloseTo(18, 0);
  });

  it('colours mix by parts', () => {
    expect(blended('#000000', '#FF8040', 0.5)).toBe('#804020');
  });
});

describe('areas and stairs', () => {
  const palette = paletteOf('light');
  const partsOfArea = (kind: 'exit' | 'source' | 'waiting', open = true, queue: Vec2[] = []): PatchParts => {
    const parts = emptyParts();
    addArea(parts, areaOf({ id: 1, kind, polygon: kSquare, open, queue }), palette);
    return parts;
  };

  it('differ by rim and pattern, not by colour alone', () => {
    const [exit, source, waiting] = [partsOfArea('exit'), partsOfArea('source'), partsOfArea('waiting')];
    expect([exit.rim.length, exit.lines.length]).toEqual([0, 4]);
    expect(source.rim).toHaveLength(4);
    expect(source.lines.length).toBeGreaterThan(4);
    // A rim, and a mark for each square metre.
    expect(waiting.lines.length).toBeGreaterThanOrEqual(4 + 16);
    for (const parts of [exit, source, waiting]) expect(parts.floor.triangleCount).toBe(2);
  });

  it('are crossed out in the colour of what cannot be where they are closed', () => {
    const closed = partsOfArea('exit', false);
    expect(closed.lines.length).toBeGreaterThan(10);
    expect(new Set(closed.lines.map(({ colour }) => colour))).toEqual(new Set([palette.alarm]));
  });

  it('show the line in which people queue', () => {
    const queue: Vec2[] = [
      [4, 2],
      [6, 2],
      [6, 5],
    ];
    expect(partsOfArea('exit', true, queue).lines).toHaveLength(6);
  });

  it('stairs have treads across the way up, and arrows along it', () => {
    const parts = emptyParts();
    addPatch(parts, patchOf({ id: 1, polygon: kSquare, speed: 0.5, ascent: 0 }), 'walk', palette);
    const treads = parts.lines.filter(({ alpha }) => alpha < 1);
    expect(treads.length).toBe(13);
    for (const { line } of treads) expect(line[0][0]).toBeCloseTo(line[1][0]);
    const arrows = parts.lines.filter(({ alpha }) => alpha === 1);
    expect(arrows).toHaveLength(6);
    for (const { line } of arrows) expect(line[1][0]).toBeGreaterThan(line[0][0]);
  });
});
