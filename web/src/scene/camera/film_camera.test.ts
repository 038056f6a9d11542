import { describe, expect, it } from 'vitest';
import {
  keysOf,
  poseAt,
  readKeys,
  shotsOf,
  toldKeys,
  withCut,
  withKey,
  withKeyAt,
  withoutKey,
  type CameraKey,
} from './film_camera';

const pose = (targetX: number, distance = 10, turn = 0) => ({ targetX, targetY: 0, distance, turn, pitch: 1 });
const keys: readonly CameraKey[] = [
  { step: 60, pose: pose(0) },
  { step: 180, pose: pose(12, 40) },
];

describe('the camera of a film', () => {
  it('rests before the first key and behind the last', () => {
    expect(poseAt(keys, 0)).toEqual(pose(0));
    expect(poseAt(keys, 500)).toEqual(pose(12, 40));
    expect(poseAt([], 5)).toBeNull();
  });

  it('moves with ease: half way at half time, slowly at both ends', () => {
    const at = (step: number): number => poseAt(keys, step)!.targetX;
    expect(at(120)).toBeCloseTo(6);
    expect(at(66)).toBeLessThan(12 * 0.01);
    expect(at(174)).toBeGreaterThan(12 * 0.99);
    let before = -1;
    for (let step = 60; step <= 180; ++step) {
      expect(at(step)).toBeGreaterThanOrEqual(before);
      before = at(step);
    }
  });

  it('comes nearer by as many times in each moment, and turns the short way round', () => {
    expect(poseAt(keys, 120)!.distance).toBeCloseTo(20);
    const round = [
      { step: 0, pose: pose(0, 10, 3) },
      { step: 10, pose: pose(0, 10, -3) },
    ];
    expect(poseAt(round, 5)!.turn).toBeCloseTo(Math.PI);
  });
});

describe('cuts', () => {
  const cut = withCut(keys, 180, true);

  it('let the camera rest, and then be there at once', () => {
    expect(poseAt(cut, 179)).toEqual(pose(0));
    expect(poseAt(cut, 180)).toEqual(pose(12, 40));
  });

  it('divide a part into shots', () => {
    expect(shotsOf(cut, 30, 300)).toEqual([
      { from: 30, to: 180 },
      { from: 180, to: 300 },
    ]);
    expect(shotsOf(keys, 30, 300)).toEqual([{ from: 30, to: 300 }]);
    expect(shotsOf([], 30, 300)).toEqual([]);
  });

  it('stay cuts where a key moves, and as the take keeps them', () => {
    const moved = withKeyAt(cut, 180, 40);
    expect(moved.map(({ step, cut: is }) => [step, is ?? false])).toEqual([
      [40, true],
      [60, false],
    ]);
    expect(keysOf(toldKeys(moved))).toEqual(moved.map((key) => ({ ...key, cut: key.cut ?? false })));
  });
});

describe('keys', () => {
  it('ascend, and one that is as good as there is replaced', () => {
    const more = withKey(withKey(keys, 100, pose(5)), 182, pose(7));
    expect(more.map(({ step, pose: { targetX } }) => [step, targetX])).toEqual([
      [60, 0],
      [100, 5],
      [182, 7],
    ]);
    expect(withoutKey(more, 100).map(({ step }) => step)).toEqual([60, 182]);
  });

  it('come back from what a browser has kept, without what is none', () => {
    expect(readKeys(JSON.stringify(keys))).toEqual(keys);
    const bad = [
      null,
      { step: -1, pose: pose(0) },
      { step: 1.5, pose: pose(0) },
      { step: 3 },
      { step: 4, pose: pose(0, -1) },
    ];
    expect(readKeys(JSON.stringify([...bad, keys[1], keys[0]]))).toEqual(keys);
    expect(readKeys('{')).toEqual([]);
    expect(readKeys(null)).toEqual([]);
  });
});
