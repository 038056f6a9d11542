import { describe, expect, it } from 'vitest';
import type { Point2 } from '../protocol/scene';
import { GeometryBuilder } from './geometry_builder';
import { addPatch, hatchChords, lookOfMotion, type PatchParts, postsAlong } from './patch_geometry';
import { paletteOf } from './palette';

const kSquare: readonly Point2[] = [[0, 0], [4, 0], [4, 4], [0, 4]];

function partsOf(clip: string): PatchParts {
  const parts: PatchParts = { floor: new GeometryBuilder(), solid: new GeometryBuilder(), rim: [], lines: [] };
  addPatch(parts, { id: 1, name: '', polygon: kSquare, motion: 0, speed: 1, moving: false }, clip, paletteOf('light'));
  return parts;
}

describe('patches', () => {
  it('have an object by motion', () => {
    expect(['crawl', 'swim', 'climb', 'jump', 'duck', 'run'].map(lookOfMotion)).toEqual(
      ['net', 'pool', 'wall', 'bar', 'shade', 'plain']);
  });

  it('all have a floor; all but pools a dashed rim of their outline', () => {
    for (const clip of ['crawl', 'climb', 'jump', 'duck', 'run', 'swim']) {
      const parts = partsOf(clip);
      expect(parts.floor.triangleCount).toBe(2);
      expect(parts.rim).toHaveLength(clip === 'swim' ? 0 : 4);
    }
    expect(partsOf('crawl').lines.length).toBeGreaterThan(20);
    expect(partsOf('swim').lines.length).toBeGreaterThan(20);
    expect(partsOf('climb').solid.triangleCount).toBeGreaterThan(0);
  });

  it('posts stand at corners and no farther apart than asked', () => {
    const posts = postsAlong(kSquare, 1.5);
    expect(posts).toHaveLength(12);
    for (const corner of kSquare) expect(posts).toContainEqual(corner);
  });

  it('hatch chords add up to the area over their spacing, holes between arms left out', () => {
    const total = (outline: readonly Point2[]): number => hatchChords(outline, 0.6, 0.05).reduce(
      (sum, [a, b]) => sum + Math.hypot(b[0] - a[0], b[1] - a[1]), 0) * 0.05;
    expect(total(kSquare)).toBeCloseTo(16, 0);
    const bay: readonly Point2[] = [[0, 0], [6, 0], [6, 4], [4, 4], [4, 1], [2, 1], [2, 4], [0, 4]];
    expect(total(bay)).toBeCloseTo(18, 0);
  });
});
