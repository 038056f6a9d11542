// Which joint of somebody else's skeleton plays which role of ours, by its name: Mixamo, Rokoko, Blender, VRM and their
// kin write "mixamorig:LeftForeArm", "LeftForearm", "forearm.L" or "J_Bip_L_LowerArm" for the same.

import { jointIndex, kJoints, kSkeleton } from '../../../model/skeleton';

export interface NamedJoint {
  readonly name: string;
  /** Index in the same list; -1 for none. */
  readonly parent: number;
}

/** Roles without which there is no person, with words for them. */
const kNeeded: Readonly<Record<string, string>> = {
  Hips: 'the hips',
  Head: 'the head',
  LeftArm: 'the left upper arm',
  LeftForeArm: 'the left elbow',
  LeftHand: 'the left hand',
  RightArm: 'the right upper arm',
  RightForeArm: 'the right elbow',
  RightHand: 'the right hand',
  LeftUpLeg: 'the left thigh',
  LeftLeg: 'the left knee',
  LeftFoot: 'the left foot',
  RightUpLeg: 'the right thigh',
  RightLeg: 'the right knee',
  RightFoot: 'the right foot',
};

/** Names without side, prefix and punctuation; a number stands for no, or any, counting. */
const kMiddle: Readonly<Record<string, readonly string[]>> = {
  Hips: ['hips', 'hip', 'pelvis'],
  Neck: ['neck', 'neck1', 'neck01', 'neck0', 'necklower'],
  Head: ['head'],
};
const kSpines = /^(spine|chest|upperchest|torso|abdomen|lowerback|upperback|thorax|waist|back)\d*$/;
const kSided: Readonly<Record<string, readonly string[]>> = {
  Shoulder: ['shoulder', 'clavicle', 'collar', 'collarbone', 'scapula'],
  Arm: ['arm', 'upperarm', 'uparm', 'armupper', 'humerus', 'bicep'],
  ForeArm: ['forearm', 'lowerarm', 'lowarm', 'armlower', 'elbow', 'radius'],
  Hand: ['hand', 'wrist', 'palm'],
  UpLeg: ['upleg', 'upperleg', 'thigh', 'legupper', 'femur', 'hip'],
  Leg: ['leg', 'shin', 'calf', 'lowerleg', 'lowleg', 'leglower', 'knee', 'tibia'],
  Foot: ['foot', 'ankle'],
  ToeBase: ['toebase', 'toe', 'toes', 'ball', 'toe0'],
};

const kPrefixes = /^(mixamorig\d*|armature|def|org|valvebiped|cc_base|bip\d*|j_bip|j)[_\-. ]+/i;
/** Names that are counted though there is but one. */
const kCounted = /^(thigh|shin|calf|foot|hand|forearm|shoulder|clavicle|upperarm)0*1?$/;

interface Words {
  readonly side: 'Left' | 'Right' | '';
  readonly base: string;
}

/** Takes a name apart: "mixamorig1:LeftUpLeg" is left and upleg. */
export function wordsOf(name: string): Words {
  const bare = name
    .replace(/^.*[:|]/, '')
    .replace(kPrefixes, '')
    .replace(/^(mixamorig\d*|bip\d*[_\-. ]*)/i, '');
  const apart = bare
    .replace(/([a-z])([A-Z])/g, '$1 $2')
    .replace(/([A-Za-z])(\d)/g, '$1 $2')
    .toLowerCase();
  const parts = apart.split(/[^a-z0-9]+/).filter(Boolean);
  let side: Words['side'] = '';
  const rest: string[] = [];
  for (const part of parts) {
    if (/^(left|l)$/.test(part)) side = 'Left';
    else if (/^(right|r)$/.test(part)) side = 'Right';
    else if (part !== 'c' && part !== 'jnt' && part !== 'joint' && part !== 'bone') rest.push(part);
  }
  let base = rest.join('');
  const glued = side === '' ? /^(left|right|[lr])(?=.{3})(.+)$/.exec(base) : null;
  // "lfemur" is a thigh, "leg" and "radius" are no sided names.
  if (glued && isSided(glued[2]!)) {
    side = glued[1]!.startsWith('l') ? 'Left' : 'Right';
    base = glued[2]!;
  }
  return { side, base: base.replace(/^(upper|lower)(arm|leg)\d+$/, '$1$2').replace(kCounted, '$1') };
}

function isSided(base: string): boolean {
  return Object.values(kSided).some((names) => names.includes(base));
}

/** Joint per role, or -1. */
export type Roles = Int16Array;

/** Finds the role of each joint; the first joint that fits has it. */
export function rolesOf(joints: readonly NamedJoint[]): Roles {
  const roles = new Int16Array(kJoints).fill(-1);
  const take = (role: string, joint: number): void => {
    const index = jointIndex(role);
    if (index >= 0 && roles[index]! < 0) roles[index] = joint;
  };
  const words = joints.map(({ name }) => wordsOf(name));
  words.forEach(({ side, base }, j) => {
    if (side === '') for (const [role, names] of Object.entries(kMiddle)) if (names.includes(base)) take(role, j);
    if (side !== '') for (const [role, names] of Object.entries(kSided)) if (names.includes(base)) take(side + role, j);
  });
  takeSpine(joints, words, roles);
  for (const side of ['Left', 'Right'] as const) mendSide(side, joints, words, roles);
  return roles;
}

/** Of all joints between hips and neck the lowest bends the waist and the highest carries the arms. */
function takeSpine(joints: readonly NamedJoint[], words: readonly Words[], roles: Roles): void {
  const depth = (j: number): number => (j < 0 ? 0 : 1 + depth(joints[j]!.parent));
  const found = words
    .flatMap(({ side, base }, j) => (side === '' && kSpines.test(base) ? [j] : []))
    .sort((a, b) => depth(a) - depth(b));
  if (found.length === 0) return;
  roles[jointIndex('Chest')] = found[found.length - 1]!;
  if (found.length > 1) roles[jointIndex('Spine')] = found[0]!;
}

/** What a name alone leaves open. */
function mendSide(side: 'Left' | 'Right', joints: readonly NamedJoint[], words: readonly Words[], roles: Roles): void {
  const at = (role: string): number => jointIndex(side + role);
  const [thigh, knee] = [at('UpLeg'), at('Leg')];
  // "Leg" is the lower one beside an upper one, else the upper one above a knee.
  const legs = words.flatMap((word, j) => (word.side === side && kSided['Leg']!.includes(word.base) ? [j] : []));
  if (roles[thigh]! < 0 && legs.length > 1) {
    const upper = legs.find((j) => legs.includes(joints[j]!.parent) === false);
    roles[thigh] = upper ?? -1;
    roles[knee] = legs.find((j) => j !== upper) ?? -1;
  }
  const [shoulder, arm, elbow] = [at('Shoulder'), at('Arm'), at('ForeArm')];
  // Without a collar bone the shoulder is the upper arm.
  if (roles[arm]! < 0 && roles[shoulder]! >= 0 && roles[elbow]! >= 0) {
    roles[arm] = roles[shoulder]!;
    roles[shoulder] = -1;
  }
}

/** What is missing for a person, in words; empty where nothing is. */
export function missingRoles(roles: Roles): string[] {
  return kSkeleton.flatMap(({ name }, j) => (roles[j]! < 0 && kNeeded[name] ? [kNeeded[name]] : []));
}
