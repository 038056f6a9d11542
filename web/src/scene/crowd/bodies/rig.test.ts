import { Matrix4, Quaternion, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { kPoseFloats, kPoseNumbers, plainRig, sameRig, solveRig } from './rig';
import { jointIndex, kJoints, kSkeleton } from '../../../model/skeleton';

function restPose(): Float32Array {
  const pose = new Float32Array(kPoseNumbers);
  pose[2] = 0.95;
  for (let j = 0; j < kJoints; ++j) pose[3 + 4 * j + 3] = 1;
  return pose;
}

function turn(pose: Float32Array, joint: string, axis: Vector3, angle: number): void {
  new Quaternion().setFromAxisAngle(axis.normalize(), angle).toArray(pose, 3 + 4 * jointIndex(joint));
}

function solved(pose: Float32Array, rig = plainRig()): (joint: string) => { at: Vector3; turn: Quaternion } {
  const out = new Float32Array(kPoseFloats);
  solveRig(rig, pose, 0, out, 0);
  return (joint) => {
    const o = 8 * jointIndex(joint);
    return { at: new Vector3().fromArray(out, o + 4), turn: new Quaternion().fromArray(out, o) };
  };
}

describe('rig', () => {
  it('stands 1.75 m tall on the ground in rest, arms out', () => {
    const joint = solved(restPose());
    expect(joint('Head').at.z).toBeCloseTo(1.56);
    expect(joint('LeftHand').at.y).toBeCloseTo(0.71);
    expect(joint('RightHand').at.y).toBeCloseTo(-0.71);
    expect(joint('LeftToeBase').at.z).toBeCloseTo(0.03);
  });

  it('agrees with matrices multiplied down the tree', () => {
    const pose = restPose();
    kSkeleton.forEach(({ name }, j) =>
      turn(pose, name, new Vector3(Math.sin(j), Math.cos(3 * j), Math.sin(7 * j + 1)), 0.3 + 0.1 * j),
    );
    pose.set([0.1, -0.2, 0.8], 0);
    const joint = solved(pose);
    const world: Matrix4[] = [];
    kSkeleton.forEach(({ name, parent, offset }, j) => {
      const at = parent < 0 ? new Vector3(0.1, -0.2, 0.8) : new Vector3(...offset);
      const local = new Matrix4().compose(at, new Quaternion().fromArray(pose, 3 + 4 * j), new Vector3(1, 1, 1));
      world.push(parent < 0 ? local : world[parent]!.clone().multiply(local));
      expect(joint(name).at.distanceTo(new Vector3().setFromMatrixPosition(world[j]!))).toBeLessThan(1e-5);
      expect(joint(name).turn.angleTo(new Quaternion().setFromRotationMatrix(world[j]!))).toBeLessThan(1e-3);
    });
  });

  it('carries a body of other proportions and another pose of modelling', () => {
    const hanging = plainRig();
    const s = Math.SQRT1_2;
    const bind = Float32Array.from(hanging.bind, (one) => 2 * one);
    const align = Float32Array.from(hanging.align);
    // Modelled with the left arm hanging: a quarter of a turn about x lifts it.
    const shoulder = 3 * jointIndex('LeftArm');
    for (const [name, down] of [
      ['LeftForeArm', 0.56],
      ['LeftHand', 1.06],
    ] as const) {
      bind.set([bind[shoulder]!, bind[shoulder + 1]!, bind[shoulder + 2]! - down], 3 * jointIndex(name));
    }
    for (const name of ['LeftArm', 'LeftForeArm', 'LeftHand']) align.set([s, 0, 0, s], 4 * jointIndex(name));
    const joint = solved(restPose(), { bind, align, scale: 2 });
    expect(joint('Hips').at.z).toBeCloseTo(1.9);
    expect(joint('LeftHand').at.y).toBeCloseTo(2 * 0.71);
    expect(joint('LeftHand').at.z).toBeCloseTo(joint('LeftArm').at.z);
    expect(sameRig(hanging, plainRig())).toBe(true);
    expect(sameRig(hanging, { ...hanging, align })).toBe(false);
  });
});
