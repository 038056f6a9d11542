import { describe, expect, it } from 'vitest';
import { CameraController } from '../camera/camera_controller';
import { kFar, kHidden, kNear, kSpeck, kTiny, kTriangles, LevelOfDetail } from './level_of_detail';

function camera(distance: number): CameraController {
  const made = new CameraController();
  made.resize(1280, 800);
  made.setWorld(-300, -300, 300, 300);
  made.setPose({ targetX: 0, targetY: 0, distance, turn: 0, pitch: 0.8 });
  return made;
}

describe('LevelOfDetail', () => {
  it('goes by the size on the screen, and leaves out who is not in view', () => {
    const levels = new LevelOfDetail();
    levels.begin(camera(30), 1);
    expect(levels.levelAt(0, 0, 0)).toBe(kNear);
    expect(levels.levelAt(0, 200, 0)).toBe(kHidden);
    expect(levels.levelAt(0, 0, -60)).toBe(kHidden);
    levels.begin(camera(300), 1);
    expect(levels.levelAt(0, 0, 0)).toBe(kFar);
    levels.begin(camera(500), 1);
    expect(levels.levelAt(0, 0, 0)).toBe(kTiny);
    levels.begin(camera(900), 1);
    expect(levels.levelAt(0, 0, 0)).toBe(kSpeck);
  });

  it('leaves nobody out whose figure shows', () => {
    const view = camera(25);
    const levels = new LevelOfDetail();
    levels.begin(view, 1);
    for (let x = -30; x <= 30; x += 0.7) {
      for (let y = -30; y <= 60; y += 0.9) {
        const seen = [0, 0.9, 1.8].some((z) => {
          const at = view.worldToScreen(x, y, z);
          return at.x >= 0 && at.y >= 0 && at.x <= 1280 && at.y <= 800;
        });
        if (seen) expect([x, y, levels.levelAt(0, x, y)]).not.toEqual([x, y, kHidden]);
      }
    }
  });

  it('asks for more px where too many would be fine, and for fewer again', () => {
    const levels = new LevelOfDetail();
    const fine = (people: number): number => {
      levels.begin(camera(40), people);
      let count = 0;
      // In view from near to far.
      for (let i = 0; i < people; ++i) if (levels.levelAt(i, 0, -8 + (20 * i) / people) === kNear) count += 1;
      return count;
    };
    expect(fine(1000)).toBe(1000);
    for (let i = 0; i < 40; ++i) fine(1000);
    // And it stays so: nobody changes to and fro.
    const settled = [0, 1, 2, 3].map(() => fine(1000));
    expect(settled[0]).toBeLessThanOrEqual(250);
    expect(settled[0]).toBeGreaterThan(50);
    expect(new Set(settled).size).toBe(1);
    for (let i = 0; i < 40; ++i) fine(20);
    expect(fine(20)).toBe(20);
  });

  it('keeps coarse bodies to some thousand and a half of ten thousand', () => {
    const levels = new LevelOfDetail();
    const counts = (): number[] => {
      const found = [0, 0, 0, 0, 0];
      levels.begin(camera(160), 10000);
      for (let i = 0; i < 10000; ++i) found[levels.levelAt(i, (i % 100) / 4 - 12, -20 + (i / 100) * 0.5)]! += 1;
      return found;
    };
    for (let i = 0; i < 60; ++i) counts();
    const [hidden, speck, tiny, far, near] = counts();
    expect(hidden! + speck! + tiny! + far! + near!).toBe(10000);
    expect(far! + near!).toBeLessThanOrEqual(1750);
    expect(far!).toBeGreaterThan(200);
    expect(tiny!).toBeGreaterThan(5000);
  });

  it('keeps a crowd within the triangles that its canvas has room for, from any distance', () => {
    const { speck, tiny, far, near } = kTriangles;
    const cost = [0, speck, tiny, far, near];
    for (const count of [300, 3000, 10000]) {
      for (const distance of [20, 60, 120, 250, 500]) {
        const levels = new LevelOfDetail();
        const view = camera(distance);
        view.resize(390, 844);
        const across = Math.ceil(Math.sqrt(count));
        let sum = 0;
        let seen = 0;
        for (let picture = 0; picture < 80; ++picture) {
          sum = seen = 0;
          levels.begin(view, count);
          for (let i = 0; i < count; ++i) {
            const level = levels.levelAt(i, (i % across) - across / 2, Math.floor(i / across) - across / 2);
            sum += cost[level]!;
            seen += level === kHidden ? 0 : 1;
          }
        }
        // A step of a limit may let a row of people more pass.
        expect([count, distance, sum > 1.1 * Math.max(576000, speck * seen) ? sum : 'few']).toEqual([
          count,
          distance,
          'few',
        ]);
      }
    }
  });

  it('keeps the level of somebody who sways about its limit', () => {
    const levels = new LevelOfDetail();
    const found = new Set<number>();
    for (let picture = 0; picture < 40; ++picture) {
      levels.begin(camera(picture % 2 === 0 ? 143 : 146), 1);
      found.add(levels.levelAt(0, 0, 0));
    }
    expect(found.size).toBe(1);
  });
});
