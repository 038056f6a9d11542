// A visitor's file, opened: its nodes, skins and animations.

import { LoadingManager } from 'three';
import { GLTFLoader, type GLTF } from 'three/examples/jsm/loaders/GLTFLoader.js';
import { gltfTrouble } from '../../../model/file_trouble';

/** What a character cannot do without, said to the visitor. */
export class CharacterError extends Error {
  override name = 'CharacterError';
}

/** One .glb, or a .gltf with the files that belong to it. */
export async function openFiles(files: readonly File[]): Promise<{ name: string; gltf: GLTF }> {
  const main = files.find((file) => /\.(glb|gltf|vrm)$/i.test(file.name));
  if (!main) throw new CharacterError(`${files[0]?.name ?? 'That'} is no character: choose a .glb or .gltf file`);
  const addresses = new Map(files.map((file) => [file.name, URL.createObjectURL(file)]));
  const manager = new LoadingManager();
  manager.setURLModifier((url) => addresses.get(decodeURIComponent(url.replace(/^.*\//, ''))) ?? url);
  try {
    const bytes = await main.arrayBuffer();
    return { name: main.name, gltf: await new GLTFLoader(manager).parseAsync(bytes, '') };
  } catch (error) {
    throw new CharacterError(`${main.name} cannot be read: ${gltfTrouble(error)}`);
  } finally {
    for (const address of addresses.values()) URL.revokeObjectURL(address);
  }
}
