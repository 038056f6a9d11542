import { describe, expect, it } from 'vitest';
import type { PlayedClip, Skeleton } from '../file/figures_reader';
import { kJointFloats, PoseBank } from './pose_bank';

/** Hips, a spine 0.5 m above, a head 0.3 m above that. */
const kSkeleton: Skeleton = {
  parents: Int16Array.of(-1, 0, 1),
  offsets: Float32Array.of(0, 0, 1, 0, 0, 0.5, 0, 0, 0.3),
};

/** Two poses: at rest, and with the spine turned about y by an angle and the hips lower. */
function bow(angle: number, cyclic: boolean): PlayedClip {
  const rest = [0, 0, 0, 1];
  const turned = [0, Math.sin(angle / 2), 0, Math.cos(angle / 2)];
  return {
    duration: 100,
    cyclic,
    poses: 2,
    hips: Float32Array.of(0, 0, 1, 0.1, 0, 0.8),
    rotations: Float32Array.from([rest, rest, rest, rest, turned, rest].flat()),
  };
}

/** Where a point of the rest pose comes to with a joint. */
function moved(out: Float32Array, joint: number, [x, y, z]: readonly [number, number, number]): number[] {
  const at = kJointFloats * joint;
  const [qx, qy, qz, qw] = [out[at]!, out[at + 1]!, out[at + 2]!, out[at + 3]!];
  const t = [2 * (qy * z - qz * y), 2 * (qz * x - qx * z), 2 * (qx * y - qy * x)] as const;
  return [
    x + qw * t[0] + qy * t[2] - qz * t[1] + out[at + 4]!,
    y + qw * t[1] + qz * t[0] - qx * t[2] + out[at + 5]!,
    z + qw * t[2] + qx * t[1] - qy * t[0] + out[at + 6]!,
  ];
}

function posed(clips: readonly PlayedClip[], ...args: readonly [number, number, number, number, number]): Float32Array {
  const out = new Float32Array(3 * kJointFloats + 5);
  new PoseBank(kSkeleton, clips).write(...args, out, 5);
  return out.subarray(5);
}

function close(found: readonly number[], expected: readonly number[]): void {
  found.forEach((value, k) => expect(value).toBeCloseTo(expected[k]!, 5));
}

describe('PoseBank', () => {
  it('leaves the rest pose where it is', () => {
    const out = posed([bow(1, false)], 0, 0, 0, 0, 0);
    for (let joint = 0; joint < 3; ++joint) close(moved(out, joint, [0.2, 0.1, 1.7]), [0.2, 0.1, 1.7]);
  });

  it('turns what hangs on a joint about it', () => {
    // A right angle forward: the tip of the head, 0.5 m above the spine's joint at (0.1, 0, 1.3), comes to lie before it.
    const out = posed([bow(Math.PI / 2, false)], 0, 100, 0, 0, 0);
    close(moved(out, 2, [0, 0, 2]), [0.6, 0, 1.3]);
    close(moved(out, 0, [0, 0, 1]), [0.1, 0, 0.8]);
  });

  it('is half-way between poses half-way in time, and goes round where the clip does', () => {
    const half = posed([bow(1, false)], 0, 50, 0, 0, 0);
    expect(2 * Math.asin(half[kJointFloats + 1]!)).toBeCloseTo(0.5, 5);
    close(moved(half, 0, [0, 0, 1]), [0.05, 0, 0.9]);
    // Of a clip that goes round, the second pose is at half of its time, and then the first comes again.
    const late = posed([bow(1, true)], 0, 75, 0, 0, 0);
    expect(2 * Math.asin(late[kJointFloats + 1]!)).toBeCloseTo(0.5, 5);
  });

  it('mixes in a share of the clip before', () => {
    const out = posed([bow(0, false), bow(1, false)], 0, 100, 1, 100, 0.25);
    expect(2 * Math.asin(out[kJointFloats + 1]!)).toBeCloseTo(0.25, 2);
  });
});
