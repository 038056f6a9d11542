// Muster's own bodies, from the GLB files that the server has.

import { BufferAttribute, BufferGeometry, Matrix4 } from 'three';
import { ask } from '../../../link/answers';
import type { Body, BodyPart } from './body';
import { readGlbSkin, type GlbSkin, type Rows } from './glb_skin';
import { plainRig, type Rig } from './rig';
import { jointIndex, kJoints, restPositions } from '../../../model/skeleton';

/** Files have y up and face +z: x, y, z there are our y, z, x. */
function toOurs(rows: Rows): Float32Array {
  return filled(rows.count, 3, (i, k) => rows.at(i, (k + 2) % 3));
}

function filled(count: number, columns: number, value: (row: number, column: number) => number): Float32Array {
  return Float32Array.from({ length: columns * count }, (_, at) => value(Math.floor(at / columns), at % columns));
}

function need(skin: GlbSkin, name: string): Rows {
  const found = skin.attribute(name);
  if (!found) throw new Error(`the skin has no ${name}`);
  return found;
}

function partOf(skin: GlbSkin, roles: readonly number[]): BodyPart {
  const [joint, weight, position] = [need(skin, 'JOINTS_0'), need(skin, 'WEIGHTS_0'), need(skin, 'POSITION')];
  const { count } = position;
  const region = skin.attribute('_REGION');
  const geometry = new BufferGeometry();
  const put = (name: string, columns: number, values: Float32Array): void => {
    geometry.setAttribute(name, new BufferAttribute(values, columns));
  };
  put('position', 3, toOurs(position));
  put('normal', 3, toOurs(need(skin, 'NORMAL')));
  put(
    'joints',
    4,
    filled(count, 4, (i, k) => roles[joint.at(i, k)] ?? 0),
  );
  put(
    'weights',
    4,
    filled(count, 4, (i, k) => weight.at(i, k)),
  );
  put(
    'region',
    1,
    filled(count, 1, (i) => region?.at(i, 0) ?? 1),
  );
  put('tint', 3, new Float32Array(3 * count).fill(1));
  geometry.setIndex(Array.from({ length: skin.index.count }, (_, i) => skin.index.at(i, 0)));
  return { geometry, map: null };
}

/** Where its joints are in the pose it was modelled in. */
function rigOf(skin: GlbSkin, roles: readonly number[]): Rig {
  const bind = restPositions();
  roles.forEach((role, b) => {
    const inverse = new Matrix4().fromArray(Array.from({ length: 16 }, (_, k) => skin.inverseBinds.at(b, k)));
    const at = inverse.invert().elements;
    bind.set([at[14], at[12], at[13]], 3 * role);
  });
  return plainRig(bind);
}

/** Joints by the skeleton's names. */
function rolesOf({ joints }: GlbSkin): number[] {
  const roles = joints.map(jointIndex);
  const strange = roles.indexOf(-1);
  if (strange >= 0) throw new Error(`it has a joint called ${joints[strange]!}`);
  if (new Set(roles).size !== kJoints) throw new Error(`it has ${new Set(roles).size} of ${kJoints} joints`);
  return roles;
}

/** A body of two files' contents. Throws with a reason. */
export function readBody(name: string, near: ArrayBuffer, far: ArrayBuffer): Body {
  const [skin, coarse] = [readGlbSkin(near), readGlbSkin(far)];
  const roles = rolesOf(skin);
  return { name, rig: rigOf(skin, roles), near: [partOf(skin, roles)], far: [partOf(coarse, rolesOf(coarse))] };
}

async function bytesOf(path: string): Promise<ArrayBuffer> {
  const answer = await ask(path);
  if (!answer.ok) throw new Error(`${path}: ${answer.status}`);
  return answer.arrayBuffer();
}

/** Those of body-1, body-2... that the server has; none where it has none. */
export async function fetchBodies(names: readonly string[]): Promise<Body[]> {
  const all = await Promise.allSettled(
    names.map(async (name) => {
      const [near, far] = await Promise.all(
        [`bodies/${name}.glb`, `bodies/${name}-far.glb`].map((path) => bytesOf(path)),
      );
      return readBody(name, near!, far!);
    }),
  );
  return all.flatMap((one) => (one.status === 'fulfilled' ? [one.value] : []));
}
