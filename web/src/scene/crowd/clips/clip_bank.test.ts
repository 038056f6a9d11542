import { describe, expect, it } from 'vitest';
import { ClipBank, type ClipPoses, standingClip } from './clip_bank';
import { kPoseFloats, plainRig } from '../bodies/rig';
import { jointIndex, kJoints } from '../../../model/skeleton';

/** Hips at the height of the pose's number. */
function madeClip(name: string, poses: number, more: Partial<ClipPoses> = {}): ClipPoses {
  const rotations = new Int16Array(4 * kJoints * poses).map((_, i) => (i % 4 === 3 ? 32767 : 0));
  const hips = Float32Array.from({ length: 3 * poses }, (_, i) => (i % 3 === 2 ? Math.floor(i / 3) : 0));
  return { name, motion: name, rate: 10, cyclic: true, poses, hips, rotations, ...more };
}

describe('ClipBank', () => {
  const bank = new ClipBank([madeClip('run', 8), madeClip('climb', 5, { cyclic: false })]);

  it('knows where the poses of a clip begin, and which go round', () => {
    expect(bank.span(0)).toMatchObject({ first: 0, poses: 8, cyclic: true });
    expect(bank.span(1)).toMatchObject({ first: 8, poses: 5, cyclic: false });
    expect(bank.poseCount).toBe(13);
  });

  it('plays the first clip where an index has none, and stands before any came', () => {
    expect(bank.span(77)).toMatchObject({ first: 0, poses: 8 });
    expect(new ClipBank([]).span(3)).toMatchObject({ first: 0, poses: 1 });
  });

  it('plays a clip of the same name in place of ours, however many poses it has', () => {
    const own = new ClipBank([madeClip('idle', 4), madeClip('run', 8)], [madeClip('run', 16)]);
    expect([own.replaced(0), own.replaced(1)]).toEqual([false, true]);
    expect(own.poseCount).toBe(20);
    expect(own.span(1)).toMatchObject({ first: 4, poses: 16, cyclic: true });
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
