import { describe, expect, it } from 'vitest';
import { missingRoles, type NamedJoint, rolesOf, wordsOf } from './joint_roles';
import { kSkeleton } from '../../../model/skeleton';

/** Names in the order of a walk down the tree: "  " per level. */
function tree(text: string): NamedJoint[] {
  const lines = text.split('\n').filter((line) => line.trim().length > 0);
  const depth = lines.map((line) => line.search(/\S/));
  return lines.map((line, i) => {
    let parent = i - 1;
    while (parent >= 0 && depth[parent]! >= depth[i]!) parent -= 1;
    return { name: line.trim(), parent };
  });
}

function namesByRole(joints: readonly NamedJoint[]): Record<string, string> {
  const roles = rolesOf(joints);
  return Object.fromEntries(
    kSkeleton.flatMap(({ name }, j) => (roles[j]! >= 0 ? [[name, joints[roles[j]!]!.name]] : [])),
  );
}

/** A skeleton by the words for its parts, left and right by a pattern. */
function skeletonOf(words: readonly string[], sided: (side: 'Left' | 'Right', word: string) => string): NamedJoint[] {
  const [hips, spine, chest, neck, head, ...limbs] = words;
  const side = (s: 'Left' | 'Right', depth: number, list: readonly string[]): string =>
    list.map((word, i) => `${' '.repeat(depth + i)}${sided(s, word)}`).join('\n');
  const both = (depth: number, list: readonly string[]): string =>
    `${side('Left', depth, list)}\n${side('Right', depth, list)}`;
  return tree(
    `${hips}\n ${spine}\n  ${chest}\n   ${neck}\n    ${head}\n${both(3, limbs.slice(0, 4))}\n${both(1, limbs.slice(4))}`,
  );
}

const kMixamoLimbs = ['Shoulder', 'Arm', 'ForeArm', 'Hand', 'UpLeg', 'Leg', 'Foot', 'ToeBase'];
const kKinds: readonly (readonly [string, NamedJoint[]])[] = [
  [
    'Mixamo',
    skeletonOf(
      ['mixamorig:Hips', 'mixamorig:Spine', 'mixamorig:Spine2', 'mixamorig:Neck', 'mixamorig:Head', ...kMixamoLimbs],
      (side, word) => `mixamorig:${side}${word}`,
    ),
  ],
  [
    'Mixamo, numbered and without colon',
    skeletonOf(
      ['mixamorig1Hips', 'mixamorig1Spine', 'mixamorig1Spine1', 'mixamorig1Neck', 'mixamorig1Head', ...kMixamoLimbs],
      (side, word) => `mixamorig1${side}${word}`,
    ),
  ],
  [
    'Rokoko',
    skeletonOf(
      [
        'Hips',
        'Spine1',
        'Spine4',
        'Neck',
        'Head',
        'Shoulder',
        'Arm',
        'ForeArm',
        'Hand',
        'Thigh',
        'Shin',
        'Foot',
        'Toe',
      ],
      (side, word) => `${side}${word}`,
    ),
  ],
  [
    'Blender',
    skeletonOf(
      [
        'hips',
        'spine',
        'chest',
        'neck',
        'head',
        'shoulder',
        'upper_arm',
        'forearm',
        'hand',
        'thigh',
        'shin',
        'foot',
        'toe',
      ],
      (side, word) => `${word}.${side[0]}`,
    ),
  ],
  [
    'Rigify',
    skeletonOf(
      [
        'DEF-pelvis',
        'DEF-spine',
        'DEF-spine.003',
        'DEF-neck',
        'DEF-head',
        'shoulder',
        'upper_arm',
        'forearm',
        'hand',
        'thigh',
        'shin',
        'foot',
        'toe',
      ],
      (side, word) => `DEF-${word}.${side[0]}`,
    ),
  ],
  [
    'VRM',
    skeletonOf(
      [
        'J_Bip_C_Hips',
        'J_Bip_C_Spine',
        'J_Bip_C_UpperChest',
        'J_Bip_C_Neck',
        'J_Bip_C_Head',
        'Shoulder',
        'UpperArm',
        'LowerArm',
        'Hand',
        'UpperLeg',
        'LowerLeg',
        'Foot',
        'ToeBase',
      ],
      (side, word) => `J_Bip_${side[0]}_${word}`,
    ),
  ],
  [
    'Unreal',
    skeletonOf(
      [
        'pelvis',
        'spine_01',
        'spine_03',
        'neck_01',
        'head',
        'clavicle',
        'upperarm',
        'lowerarm',
        'hand',
        'thigh',
        'calf',
        'foot',
        'ball',
      ],
      (side, word) => `${word}_${side[0]!.toLowerCase()}`,
    ),
  ],
  [
    'small letters before the word',
    skeletonOf(
      [
        'root|pelvis',
        'lowerback',
        'thorax',
        'neck',
        'head',
        'clavicle',
        'humerus',
        'radius',
        'wrist',
        'femur',
        'tibia',
        'foot',
        'toes',
      ],
      (side, word) => `${side[0]!.toLowerCase()}${word}`,
    ),
  ],
  [
    'hip, knee and ankle',
    skeletonOf(
      ['hips', 'spine', 'chest', 'neck', 'head', 'shoulder', 'arm', 'elbow', 'wrist', 'hip', 'knee', 'ankle', 'toe'],
      (side, word) => `${side.toLowerCase()}_${word}`,
    ),
  ],
];

describe('roles of joints', () => {
  it.each(kKinds)('%s', (_, joints) => {
    const roles = rolesOf(joints);
    expect(missingRoles(roles)).toEqual([]);
    expect(Array.from(roles)).toEqual([0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20]);
  });

  it('without collar bones the shoulder is the upper arm, and one spine carries the arms', () => {
    const joints = tree(
      'hips\n torso\n  head\n  shoulder_l\n   elbow_l\n    hand_l\n  shoulder_r\n   elbow_r\n    hand_r\n leg_l\n  shin_l\n   foot_l\n leg_r\n  shin_r\n   foot_r',
    );
    const names = namesByRole(joints);
    expect([names['LeftArm'], names['LeftForeArm'], names['RightHand'], names['Chest']]).toEqual([
      'shoulder_l',
      'elbow_l',
      'hand_r',
      'torso',
    ]);
    expect([names['LeftUpLeg'], names['LeftLeg'], names['RightLeg']]).toEqual(['leg_l', 'shin_l', 'shin_r']);
    expect(names['LeftShoulder']).toBeUndefined();
    expect(missingRoles(rolesOf(joints))).toEqual([]);
  });

  it('says what is missing', () => {
    const joints = kKinds[0]![1].map((joint) =>
      /LeftLeg|RightHand/.test(joint.name) ? { ...joint, name: 'Box' } : joint,
    );
    expect(missingRoles(rolesOf(joints))).toEqual(['the right hand', 'the left knee']);
    expect(missingRoles(rolesOf([]))).toHaveLength(14);
  });

  it('fingers and twists take nobody else’s role', () => {
    expect(wordsOf('mixamorig:LeftHandIndex1').base).toBe('handindex1');
    expect(wordsOf('upperarm_twist_01_l').base).not.toBe('upperarm');
    expect(wordsOf('Legs')).toEqual({ side: '', base: 'legs' });
  });
});
