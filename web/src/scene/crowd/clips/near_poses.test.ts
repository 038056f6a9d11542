import { describe, expect, it } from 'vitest';
import { NearPoses, type NearFrame } from './near_poses';
import { kPoseFloats, kPoseNumbers, plainRig } from '../bodies/rig';
import { jointIndex } from '../../../model/skeleton';

/** One pose per entry: hips at that height, turned about z by `angle`; `members` are there. */
function frame(near: readonly number[], heights: readonly number[], angle = 0, members = 8): NearFrame {
  const numbers = heights.flatMap((height) => {
    const pose = new Array<number>(kPoseNumbers).fill(0);
    pose[2] = height;
    for (let j = 0; j < 21; ++j) pose[3 + 4 * j + 3] = 1;
    pose[5] = Math.sin(angle / 2);
    pose[6] = Math.cos(angle / 2);
    return pose;
  });
  return { x: new Float32Array(members), near, nearPoses: Float32Array.from(numbers) };
}

function solvedHeights(near: NearPoses): number[] {
  const out = new Float32Array(kPoseFloats * near.count);
  near.solve(plainRig(), out);
  return Array.from({ length: near.count }, (_, k) => out[kPoseFloats * k + 6]!);
}

describe('NearPoses', () => {
  it('mixes hips and turns of those who are near in both frames', () => {
    const near = new NearPoses();
    near.mix(frame([2, 5], [1, 0.8], 0), frame([2, 5], [0.9, 0.6], 0.4), 0.25, 8, 100);
    expect(Array.from(near.slots)).toEqual([-1, -1, 0, -1, -1, 1, -1, -1]);
    const heights = solvedHeights(near);
    expect(heights[0]).toBeCloseTo(0.975);
    expect(heights[1]).toBeCloseTo(0.75);
    const out = new Float32Array(kPoseFloats * 2);
    near.solve(plainRig(), out);
    expect(2 * Math.asin(out[2]!)).toBeCloseTo(0.1, 3);
  });

  it('finds one by who it is, not by where it stands in the list', () => {
    const near = new NearPoses();
    near.mix(frame([1, 3, 4], [0.1, 0.3, 0.4]), frame([3, 6], [0.5, 0.9]), 0.5, 7, 100);
    const heights = solvedHeights(near);
    expect(heights[near.slots[3]!]).toBeCloseTo(0.4);
    expect(heights[near.slots[6]!]).toBeCloseTo(0.9);
    expect(near.slots[1]).toBe(-1);
  });

  it('mixes nobody where somebody came or went, as who is who in the frame before is not known', () => {
    const near = new NearPoses();
    near.mix(frame([0, 1], [0.3, 0.3], 0, 3), frame([0, 1], [0.9, 0.9], 0, 2), 0.5, 2, 9);
    for (const height of solvedHeights(near)) expect(height).toBeCloseTo(0.9);
  });

  it('bears more near ones than it shows, torn lists and strangers', () => {
    const near = new NearPoses();
    near.mix(frame([0, 1, 2], [1, 1, 1]), frame([0, 1, 2], [1, 1, 1]), 0.5, 3, 2);
    expect(near.count).toBe(2);
    near.mix(frame([], []), { x: [0, 0, 0], near: [0, 1], nearPoses: new Float32Array(kPoseNumbers + 5) }, 0.5, 3, 9);
    expect(near.count).toBe(1);
    near.mix(frame([], []), frame([9], [1]), 0.5, 3, 9);
    expect(Array.from(near.slots)).toEqual([-1, -1, -1]);
  });

  it('keeps a foot that both frames hold within half a millimetre, while the body goes on', () => {
    const leg = 0.83,
      ankle = 0.08,
      thigh = jointIndex('LeftUpLeg');
    // A stiff leg over a foot at x = 0.2: where the body is tells the angle and the height of the hips.
    const standing = (x: number): NearFrame => {
      const angle = Math.asin((0.2 - x) / leg);
      const { x: places, near, nearPoses } = frame([0], [ankle + leg * Math.cos(angle) + 0.04]);
      const pose = Array.from(nearPoses);
      pose[3 + 4 * thigh + 1] = Math.sin(-angle / 2);
      pose[3 + 4 * thigh + 3] = Math.cos(-angle / 2);
      return { x: places, near, nearPoses: pose };
    };
    const near = new NearPoses();
    const out = new Float32Array(kPoseFloats);
    for (let x = -0.1; x < 0.4; x += 0.05) {
      for (const alpha of [0, 0.25, 0.5, 0.75]) {
        near.mix(standing(x), standing(x + 0.05), alpha, 1, 1);
        near.solve(plainRig(), out);
        const foot = 8 * jointIndex('LeftFoot') + 4;
        expect(Math.abs(x + 0.05 * alpha + out[foot]! - 0.2)).toBeLessThan(6e-4);
        expect(Math.abs(out[foot + 2]! - ankle)).toBeLessThan(1.1e-3);
      }
    }
  });
});
