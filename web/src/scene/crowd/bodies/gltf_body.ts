// Muster's own bodies, from the GLB files that the server has.

import { BufferAttribute, BufferGeometry, type InterleavedBufferAttribute, SkinnedMesh } from 'three';
import { GLTFLoader, type GLTF } from 'three/examples/jsm/loaders/GLTFLoader.js';
import { ask } from '../../../link/answers';
import type { Body, BodyPart } from './body';
import { plainRig, type Rig } from './rig';
import { jointIndex, kJoints, restPositions } from '../../../model/skeleton';

type Attribute = BufferAttribute | InterleavedBufferAttribute;

/** Files have y up and face +z: x, y, z there are our y, z, x. */
export function toOurs(attribute: Attribute): Float32Array {
  const out = new Float32Array(3 * attribute.count);
  for (let i = 0; i < attribute.count; ++i) {
    out[3 * i] = attribute.getZ(i);
    out[3 * i + 1] = attribute.getX(i);
    out[3 * i + 2] = attribute.getY(i);
  }
  return out;
}

function need(geometry: BufferGeometry, name: string): Attribute {
  const found = geometry.attributes[name];
  if (!found) throw new Error(`the skin has no ${name}`);
  return found;
}

/** The first skinned mesh of a file. */
function skinOf(gltf: GLTF): SkinnedMesh {
  let found: SkinnedMesh | null = null;
  gltf.scene.traverse((node) => {
    if (!found && node instanceof SkinnedMesh) found = node;
  });
  if (!found) throw new Error('there is no skinned mesh');
  return found;
}

function partOf(mesh: SkinnedMesh, roles: readonly number[]): BodyPart {
  const { geometry: source } = mesh;
  const [skin, weight, position] = [need(source, 'skinIndex'), need(source, 'skinWeight'), need(source, 'position')];
  const count = position.count;
  const joints = new Float32Array(4 * count);
  const weights = new Float32Array(4 * count);
  const region = new Float32Array(count);
  // three.js writes the names of attributes of its own in small letters.
  const named = source.attributes['_region'] ?? source.attributes['_REGION'];
  for (let i = 0; i < count; ++i) {
    for (let k = 0; k < 4; ++k) {
      joints[4 * i + k] = roles[skin.getComponent(i, k)] ?? 0;
      weights[4 * i + k] = weight.getComponent(i, k);
    }
    region[i] = named ? named.getX(i) : 1;
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(toOurs(position), 3));
  geometry.setAttribute('normal', new BufferAttribute(toOurs(need(source, 'normal')), 3));
  geometry.setAttribute('joints', new BufferAttribute(joints, 4));
  geometry.setAttribute('weights', new BufferAttribute(weights, 4));
  geometry.setAttribute('region', new BufferAttribute(region, 1));
  geometry.setAttribute('tint', new BufferAttribute(new Float32Array(3 * count).fill(1), 3));
  geometry.setIndex(source.index);
  return { geometry, map: null };
}

/** Where its joints are in the pose it was modelled in. */
function rigOf(mesh: SkinnedMesh, roles: readonly number[]): Rig {
  const bind = restPositions();
  mesh.skeleton.bones.forEach((_, b) => {
    const role = roles[b]!;
    const inverse = mesh.skeleton.boneInverses[b]!.clone().invert().elements;
    bind.set([inverse[14], inverse[12], inverse[13]], 3 * role);
  });
  return plainRig(bind);
}

/** Joints by the skeleton's names. */
function rolesOf(mesh: SkinnedMesh): number[] {
  const roles = mesh.skeleton.bones.map((bone) => jointIndex(bone.name));
  const strange = roles.indexOf(-1);
  if (strange >= 0) throw new Error(`it has a joint called ${mesh.skeleton.bones[strange]!.name}`);
  if (new Set(roles).size !== kJoints) throw new Error(`it has ${new Set(roles).size} of ${kJoints} joints`);
  return roles;
}

/** A body of two files' contents. Throws with a reason. */
export async function readBody(name: string, near: ArrayBuffer, far: ArrayBuffer): Promise<Body> {
  const loader = new GLTFLoader();
  const [skin, coarse] = (await Promise.all([loader.parseAsync(near, ''), loader.parseAsync(far, '')])).map(skinOf);
  const roles = rolesOf(skin!);
  return { name, rig: rigOf(skin!, roles), near: [partOf(skin!, roles)], far: [partOf(coarse!, rolesOf(coarse!))] };
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
