// A visitor's skeleton as a rig of ours: roles by name, bones aligned with our rest pose, as tall as our hips.

import { type Bone, type Object3D, type Quaternion, type SkinnedMesh, Vector3 } from 'three';
import { missingRoles, rolesOf, type Roles } from './joint_roles';
import { CharacterError } from './own_file';
import { shortestArc, type Vector } from '../bodies/quaternion';
import type { Rig } from '../bodies/rig';
import { jointIndex, kJoints, kSkeleton, restPositions } from '../../../model/skeleton';

/** From a file's axes (y up, facing +z or -z) to ours, on the ground, scaled. */
export interface Axes {
  /** -1 where the figure faces away. */
  readonly facing: number;
  readonly scale: number;
  /** What becomes the origin, in our axes before scaling. */
  readonly origin: Vector;
}

export function pointToOurs({ facing, scale, origin }: Axes, p: Vector3): [number, number, number] {
  return [scale * (facing * p.z - origin[0]), scale * (facing * p.x - origin[1]), scale * (p.y - origin[2])];
}

/** A turn in the file's axes as one in ours. */
export function turnToOurs({ facing }: Axes, q: Quaternion): [number, number, number, number] {
  return [facing * q.z, facing * q.x, q.y, q.w];
}

export interface OwnRig {
  readonly rig: Rig;
  readonly axes: Axes;
  readonly roles: Roles;
  /** All joints of all skins. */
  readonly bones: readonly Object3D[];
  /** The role that carries what hangs on each of them. */
  readonly carriers: Uint8Array;
}

/** The name that its maker gave it. */
function nameOf(node: Object3D): string {
  const original: unknown = node.userData['name'];
  return typeof original === 'string' ? original : node.name;
}

function bonesOf(skins: readonly SkinnedMesh[]): Bone[] {
  return [...new Set(skins.flatMap((skin) => skin.skeleton.bones))];
}

/** Reads the skeleton as it stands in the file. `lowest`: of its skin, in the file's axes. */
export function readRig(name: string, skins: readonly SkinnedMesh[], lowest: number): OwnRig {
  const bones = bonesOf(skins);
  const index = new Map<Object3D, number>(bones.map((bone, i) => [bone, i]));
  const parents = bones.map((bone) => (bone.parent ? (index.get(bone.parent) ?? -1) : -1));
  const roles = rolesOf(bones.map((bone, i) => ({ name: nameOf(bone), parent: parents[i]! })));
  const missing = missingRoles(roles);
  if (missing.length > 0) {
    const more = missing.length > 3 ? ` and ${missing.length - 3} more` : '';
    throw new CharacterError(`${name} cannot be used: there is no joint for ${missing.slice(0, 3).join(', ')}${more}`);
  }
  const axes = axesOf(name, bones, roles, lowest);
  const bind = bindOf(bones, roles, axes);
  const rig: Rig = { bind, align: alignOf(bind, roles), scale: bind[2]! / restPositions()[2]! };
  return { rig, axes, roles, bones, carriers: carriersOf(parents, roles) };
}

function worldOf(bones: readonly Object3D[], roles: Roles, role: string): Vector3 {
  return new Vector3().setFromMatrixPosition(bones[roles[jointIndex(role)]!]!.matrixWorld);
}

function axesOf(name: string, bones: readonly Object3D[], roles: Roles, lowest: number): Axes {
  const at = (role: string): Vector3 => worldOf(bones, roles, role);
  const hips = at('Hips');
  const facing = at('LeftUpLeg').x + at('LeftArm').x >= at('RightUpLeg').x + at('RightArm').x ? 1 : -1;
  const high = hips.y - lowest;
  if (!(high > 1e-6))
    throw new CharacterError(`${name} cannot be used: its hips are not above its feet; is it modelled with y up?`);
  return { facing, scale: restPositions()[2]! / high, origin: [facing * hips.z, facing * hips.x, lowest] };
}

/** Positions of the joints; a missing joint takes that of its parent. */
function bindOf(bones: readonly Object3D[], roles: Roles, axes: Axes): Float32Array {
  const bind = new Float32Array(3 * kJoints);
  kSkeleton.forEach(({ parent }, j) => {
    const bone = roles[j]! < 0 ? null : bones[roles[j]!]!;
    if (bone) bind.set(pointToOurs(axes, new Vector3().setFromMatrixPosition(bone.matrixWorld)), 3 * j);
    else bind.copyWithin(3 * j, 3 * parent, 3 * parent + 3);
  });
  return bind;
}

/** Upper and lower limbs are turned to lie as ours do in rest; hands go with their arms. */
function alignOf(bind: Float32Array, roles: Roles): Float32Array {
  const rest = restPositions();
  const align = new Float32Array(4 * kJoints);
  for (let j = 0; j < kJoints; ++j) align[4 * j + 3] = 1;
  const between = (points: Float32Array, a: number, b: number): Vector => [
    points[3 * b]! - points[3 * a]!,
    points[3 * b + 1]! - points[3 * a + 1]!,
    points[3 * b + 2]! - points[3 * a + 2]!,
  ];
  for (const side of ['Left', 'Right']) {
    for (const [upper, lower] of [
      ['Arm', 'ForeArm'],
      ['ForeArm', 'Hand'],
      ['UpLeg', 'Leg'],
      ['Leg', 'Foot'],
    ] as const) {
      const [a, b] = [jointIndex(side + upper), jointIndex(side + lower)];
      align.set(shortestArc(between(bind, a, b), between(rest, a, b)), 4 * a);
    }
    const [arm, hand] = [jointIndex(`${side}ForeArm`), jointIndex(`${side}Hand`)];
    if (roles[hand]! >= 0) align.copyWithin(4 * hand, 4 * arm, 4 * arm + 4);
  }
  return align;
}

/** Fingers go with the hand, a twisting joint with its limb: the nearest role above. */
function carriersOf(parents: readonly number[], roles: Roles): Uint8Array {
  const own = new Map<number, number>();
  roles.forEach((bone, role) => {
    if (bone >= 0) own.set(bone, role);
  });
  return Uint8Array.from(parents, (_, bone) => {
    for (let at = bone; at >= 0; at = parents[at]!) {
      const role = own.get(at);
      if (role !== undefined) return role;
    }
    return 0;
  });
}
