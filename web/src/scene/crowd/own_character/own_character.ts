// A visitor's own character: a glTF file's skin on our motion.

import { SkinnedMesh } from 'three';
import { type Body, trianglesOf } from '../bodies/body';
import type { ClipPoses } from '../clips/clip_bank';
import { CharacterError, openFiles } from './own_file';
import { readClips } from './own_motion';
import { readRig } from './own_rig';
import { lowestOf, movingMeshes, partsOf } from './own_skin';

export interface OwnCharacter {
  readonly body: Body;
  /** Of its own, by the names of ours. */
  readonly clips: readonly ClipPoses[];
  readonly triangles: number;
}

/** Throws a CharacterError that says what is missing. */
export async function readCharacter(files: readonly File[]): Promise<OwnCharacter> {
  const { name, gltf } = await openFiles(files);
  gltf.scene.updateMatrixWorld(true);
  const meshes = movingMeshes(gltf.scene);
  const skins = meshes.filter((mesh) => mesh instanceof SkinnedMesh);
  if (skins.length === 0)
    throw new CharacterError(`${name} cannot be used: it has no skin, that is no mesh bound to a skeleton`);
  const own = readRig(name, skins, lowestOf(meshes));
  const parts = partsOf(meshes, own);
  const body: Body = { name, rig: own.rig, near: parts, far: parts };
  return { body, clips: readClips(gltf.scene, gltf.animations, own), triangles: trianglesOf(parts) };
}
