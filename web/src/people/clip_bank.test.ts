import { describe, expect, it } from 'vitest';
import { ClipBank, type ClipPoses, type Moment, standingClip } from './clip_bank';
import { kPoseFloats, plainRig } from './rig';
import { jointIndex, kJoints } from './skeleton';

/** Hips at the height of the pose's number. */
function madeClip(name: string, poses: number, more: Partial<ClipPoses> = {}): ClipPoses {
  const rotations = new Int16Array(4 * kJoints * poses).map((_, i) => (i % 4 === 3 ? 32767 : 0));
  const hips = Float32Array.from({ length: 3 * poses }, (_, i) => (i % 3 === 2 ? Math.floor(i / 3) : 0));
  return { name, motion: name, rate: 10, cyclic: true, poses, hips, rotations, ...more };
}

function momentOf(bank: ClipBank, clip: number, time: number): Moment {
  const moment = { first: -1, second: -1, mix: -1 };
  bank.moment(clip, time, moment);
  return moment;
}

function expectMoment(bank: ClipBank, clip: number, time: number, first: number, second: number, mix: number): void {
  const moment = momentOf(bank, clip, time);
  expect([moment.first, moment.second]).toEqual([first, second]);
  expect(moment.mix).toBeCloseTo(mix);
}

describe('ClipBank', () => {
  const bank = new ClipBank([madeClip('run', 8), madeClip('climb', 5, { cyclic: false })]);

  it('goes round in cyclic clips and stays at the ends of others', () => {
    expect(bank.length(0)).toBeCloseTo(0.8);
    expect(bank.length(1)).toBeCloseTo(0.4);
    expectMoment(bank, 0, 0.25, 2, 3, 0.5);
    expectMoment(bank, 0, 0.75, 7, 0, 0.5);
    expectMoment(bank, 0, 1.6 + 0.12, 1, 2, 0.2);
    expectMoment(bank, 0, -0.05, 7, 0, 0.5);
    expectMoment(bank, 1, 0.15, 9, 10, 0.5);
    expectMoment(bank, 1, 9, 12, 12, 0);
    expectMoment(bank, 1, -1, 8, 9, 0);
  });

  it('plays the first clip where an index has none, and stands before any came', () => {
    expectMoment(bank, 77, 0.25, 2, 3, 0.5);
    expectMoment(new ClipBank([]), 3, 12.3, 0, 0, momentOf(new ClipBank([]), 3, 12.3).mix);
  });

  it('stretches a clip of the same name over the time of the one it replaces', () => {
    const own = new ClipBank([madeClip('idle', 4), madeClip('run', 8)], [madeClip('run', 16)]);
    expect([own.replaced(0), own.replaced(1)]).toEqual([false, true]);
    expect(own.poseCount).toBe(20);
    expect(own.length(1)).toBeCloseTo(0.8);
    expectMoment(own, 1, 0.4, 4 + 8, 4 + 9, 0);
    expectMoment(own, 1, 0.8 * 1.5 / 16, 4 + 1, 4 + 2, 0.5);
  });

  it('bakes poses in order, its whole numbers over 32767', () => {
    const out = new Float32Array(bank.poseCount * kPoseFloats);
    bank.bake(plainRig(), out);
    for (const pose of [0, 3, 9]) {
      expect(out[kPoseFloats * pose + 6]).toBeCloseTo(pose < 8 ? pose : pose - 8);
      expect(out[kPoseFloats * pose + 3]).toBeCloseTo(1);
    }
  });

  it('stands with hanging arms', () => {
    const stand = new ClipBank([standingClip()]);
    const out = new Float32Array(kPoseFloats);
    stand.bake(plainRig(), out);
    for (const side of ['Left', 'Right']) {
      expect(out[8 * jointIndex(`${side}Hand`) + 6]).toBeLessThan(1);
      expect(Math.abs(out[8 * jointIndex(`${side}Hand`) + 5]!)).toBeLessThan(0.35);
    }
  });
});
