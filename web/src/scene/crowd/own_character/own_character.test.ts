import { describe, expect, it } from 'vitest';
import { madeCharacter } from '../../../../tests/support/made_glb.mjs';
import { kRegion } from '../bodies/body';
import { ClipBank, standingClip } from '../clips/clip_bank';
import { readCharacter } from './own_character';
import { clipOfName } from './own_motion';
import { kPoseFloats, kPoseNumbers, solveRig } from '../bodies/rig';
import { jointIndex, kJoints, restPositions } from '../../../model/skeleton';

function fileOf(bytes: Uint8Array, name = 'visitor.glb'): File {
  return new File([new Uint8Array(bytes)], name);
}

const mixamo = (name: string): string => `mixamorig:${name.replace('Chest', 'Spine2')}`;

describe('a visitor’s character', () => {
  it('in centimetres and with hanging arms stands as ours do, in its own colour', async () => {
    const { body, clips } = await readCharacter([fileOf(madeCharacter({ rename: mixamo, unit: 100 }))]);
    expect(clips).toEqual([]);
    const rest = restPositions();
    // On the ground stands the lowest corner of its skin; hips are as high as ours.
    expect(body.rig.bind[2]).toBeCloseTo(rest[2]!, 5);
    expect(body.rig.scale).toBeCloseTo(1, 5);
    const pose = new Float32Array(kPoseNumbers);
    pose[2] = 0.95;
    for (let j = 0; j < kJoints; ++j) pose[3 + 4 * j + 3] = 1;
    const out = new Float32Array(kPoseFloats);
    solveRig(body.rig, pose, 0, out, 0);
    const at = (name: string): number[] => [4, 5, 6].map((k) => out[8 * jointIndex(name) + k]!);
    const [left, right, shoulder] = [at('LeftHand'), at('RightHand'), at('LeftArm')];
    expect(left[2]).toBeCloseTo(shoulder[2]!, 3);
    expect(left[1]).toBeGreaterThan(0.6);
    expect(right[1]).toBeCloseTo(-left[1]!, 4);
    const { geometry } = body.near[0]!;
    expect(Array.from(geometry.attributes['region']!.array).every((one) => one === kRegion.own)).toBe(true);
    expect(geometry.attributes['tint']!.getX(0)).toBeCloseTo(0.8, 2);
    geometry.computeBoundingBox();
    expect(geometry.boundingBox!.min.z).toBeCloseTo(0, 5);
    // Toes point forward.
    const toe = 3 * jointIndex('LeftToeBase'),
      ankle = 3 * jointIndex('LeftFoot');
    expect(body.rig.bind[toe]! - body.rig.bind[ankle]!).toBeGreaterThan(0.1);
  });

  it('without collar bones, toes and fingers does as well', async () => {
    const spare = (name: string): string | null => (/Toe|Neck/.test(name) ? null : /Head/.test(name) ? 'Head' : name);
    await expect(readCharacter([fileOf(madeCharacter({ rename: spare }))])).rejects.toThrow('the head');
    const toeless = await readCharacter([
      fileOf(madeCharacter({ rename: (name) => (/Toe/.test(name) ? null : name) })),
    ]);
    const [toe, foot] = [3 * jointIndex('LeftToeBase'), 3 * jointIndex('LeftFoot')];
    expect(toeless.body.rig.bind.slice(toe, toe + 3)).toEqual(toeless.body.rig.bind.slice(foot, foot + 3));
  });

  it('names what is missing, or what is no character', async () => {
    const legless = madeCharacter({ rename: (name) => (name === 'LeftLeg' ? null : name) });
    await expect(readCharacter([fileOf(legless)])).rejects.toThrow(
      'visitor.glb cannot be used: there is no joint for the left knee, the left foot',
    );
    await expect(readCharacter([fileOf(new Uint8Array(40))])).rejects.toThrow(
      'visitor.glb cannot be read: it is no whole glTF file',
    );
    await expect(readCharacter([fileOf(new Uint8Array(4), 'cat.png')])).rejects.toThrow('cat.png is no character');
  });

  it('brings clips of its own, the way taken out of them', async () => {
    const { clips, body } = await readCharacter([
      fileOf(madeCharacter({ clip: 'Armature|Running', unit: 100, rename: mixamo })),
    ]);
    expect(clips.map((clip) => clip.name)).toEqual(['run']);
    const run = clips[0]!;
    expect(run.poses).toBe(30);
    const hips = (i: number): number[] => [0, 1, 2].map((k) => run.hips[3 * i + k]!);
    expect(hips(0)[2]).toBeCloseTo(0.95, 2);
    expect(hips(15)[2]).toBeCloseTo(0.85, 2);
    expect(Math.abs(hips(29)[0]!)).toBeLessThan(0.01);
    // Half-way the hips are turned by 0.5 about the vertical, and all else with them.
    expect(2 * Math.asin(run.rotations[4 * kJoints * 15 + 2]!)).toBeCloseTo(0.5, 2);
    expect(Math.abs(run.rotations[4 * kJoints * 15 + 4 * jointIndex('LeftLeg')]!)).toBeLessThan(1e-3);
    const bank = new ClipBank([standingClip(), { ...standingClip(), name: 'run' }], clips);
    expect(bank.replaced(1)).toBe(true);
    const out = new Float32Array(bank.poseCount * kPoseFloats);
    bank.bake(body.rig, out);
    expect(out.every(Number.isFinite)).toBe(true);
  });

  it('knows motions by the names that animations have', () => {
    const names = {
      'Armature|Run': 'run',
      'mixamo.com|Walking': 'walk',
      Idle: 'idle',
      crawlForward: 'crawl',
      Swim_Loop: 'swim',
      Running_Jump: 'jump',
      'run left': null,
      walk_to_stop: null,
      Dance: null,
    };
    for (const [name, clip] of Object.entries(names)) expect([name, clipOfName(name)]).toEqual([name, clip]);
  });
});
