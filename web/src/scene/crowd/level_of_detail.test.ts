import { describe, expect, it } from 'vitest';
import { CameraController } from '../camera/camera_controller';
import { kFar, kHidden, kNear, kTiny, LevelOfDetail } from './level_of_detail';

function camera(distance: number): CameraController {
  const made = new CameraController();
  made.resize(1280, 800);
  made.setPose({ targetX: 0, targetY: 0, distance, turn: 0, pitch: 0.8 });
  return made;
}

describe('LevelOfDetail', () => {
  it('goes by the size on the screen, and leaves out who is not in view', () => {
    const levels = new LevelOfDetail();
    levels.begin(camera(30));
    expect(levels.levelAt(0, 0)).toBe(kNear);
    expect(levels.levelAt(200, 0)).toBe(kHidden);
    expect(levels.levelAt(0, -60)).toBe(kHidden);
    levels.begin(camera(300));
    expect(levels.levelAt(0, 0)).toBe(kFar);
    levels.begin(camera(900));
    expect(levels.levelAt(0, 0)).toBe(kTiny);
  });

  it('leaves nobody out whose figure shows', () => {
    const view = camera(25);
    const levels = new LevelOfDetail();
    levels.begin(view);
    for (let x = -30; x <= 30; x += 0.7) {
      for (let y = -30; y <= 60; y += 0.9) {
        const seen = [0, 0.9, 1.8].some((z) => {
          const at = view.worldToScreen(x, y, z);
          return at.x >= 0 && at.y >= 0 && at.x <= 1280 && at.y <= 800;
        });
        if (seen) expect([x, y, levels.levelAt(x, y)]).not.toEqual([x, y, kHidden]);
      }
    }
  });

  it('asks for more px where too many would be fine, and for fewer again', () => {
    const levels = new LevelOfDetail();
    const fine = (people: number): number => {
      levels.begin(camera(40));
      let count = 0;
      // In view from near to far.
      for (let i = 0; i < people; ++i) if (levels.levelAt(0, -8 + (20 * i) / people) === kNear) count += 1;
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
      const found = [0, 0, 0, 0];
      levels.begin(camera(160));
      for (let i = 0; i < 10000; ++i) found[levels.levelAt((i % 100) / 4 - 12, -20 + (i / 100) * 0.5)]! += 1;
      return found;
    };
    for (let i = 0; i < 60; ++i) counts();
    const [hidden, tiny, far, near] = counts();
    expect(hidden! + tiny! + far! + near!).toBe(10000);
    expect(far! + near!).toBeLessThanOrEqual(1750);
    expect(far!).toBeGreaterThan(200);
    expect(tiny!).toBeGreaterThan(5000);
  });
});
