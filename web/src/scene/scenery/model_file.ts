// Reads the meshes of a glTF file: their triangles, where its nodes put them, and their plain colours.

import { Color, InstancedMesh, LoadingManager, Matrix4, Mesh, type Object3D, Vector3 } from 'three';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';
import { gltfTrouble } from '../../model/file_trouble';
import type { ModelMesh } from '../../model/place_files/mesh';
import { FileProblem } from '../../model/place_files/place';

/** More triangles than this are too many to look at [triangles]. */
const kMostTriangles = 3e6;
const kPale: ModelMesh['colour'] = [0.55, 0.52, 0.48];

function colourOf(mesh: Mesh): ModelMesh['colour'] {
  const material: unknown = Array.isArray(mesh.material) ? mesh.material[0] : mesh.material;
  const { color, map } = material as { color?: unknown; map?: unknown };
  // A picture tints a white base colour: without the picture it would be white.
  if (!(color instanceof Color) || map) return kPale;
  return [color.r, color.g, color.b];
}

function meshOf(mesh: Mesh, matrix: Matrix4, name: string): ModelMesh | null {
  const { position } = mesh.geometry.attributes;
  if (!position) return null;
  const count = mesh.geometry.index?.count ?? position.count;
  const triangles = new Uint32Array(count - (count % 3));
  for (let i = 0; i < triangles.length; ++i) triangles[i] = mesh.geometry.index?.getX(i) ?? i;
  const positions = new Float32Array(3 * position.count);
  const at = new Vector3();
  for (let i = 0; i < position.count; ++i) {
    at.fromBufferAttribute(position, i).applyMatrix4(matrix);
    positions.set([at.x, at.y, at.z], 3 * i);
  }
  return triangles.length > 0 ? { name, positions, triangles, colour: colourOf(mesh) } : null;
}

/** The name that somebody gave: that of the mesh's node, or of the node above where the file's parts have none. */
function nameOf(node: Object3D): string {
  const said = (one: Object3D | null): string =>
    ((one?.userData['name'] as string | undefined) ?? one?.name ?? '').trim();
  const own = said(node);
  return own !== '' ? own : said(node.parent);
}

function meshesOf(root: Object3D): ModelMesh[] {
  const found: ModelMesh[] = [];
  root.updateMatrixWorld(true);
  root.traverse((node) => {
    if (!(node instanceof Mesh)) return;
    const copies = node instanceof InstancedMesh ? node.count : 1;
    for (let i = 0; i < copies; ++i) {
      const matrix = node.matrixWorld.clone();
      if (node instanceof InstancedMesh) {
        const own = new Matrix4();
        node.getMatrixAt(i, own);
        matrix.multiply(own);
      }
      const made = meshOf(node as Mesh, matrix, nameOf(node));
      if (made) found.push(made);
    }
  });
  return found;
}

/** One .glb, or a .gltf with the files that belong to it, with y up. Throws a FileProblem. */
export async function readModel(main: File, files: readonly File[]): Promise<ModelMesh[]> {
  const addresses = new Map(files.map((file) => [file.name, URL.createObjectURL(file)]));
  const missing: string[] = [];
  const manager = new LoadingManager();
  manager.setURLModifier((url) => {
    const name = decodeURIComponent(url.replace(/^.*\//, ''));
    if (!/^(data|blob):/.test(url) && !addresses.has(name)) missing.push(name);
    return addresses.get(name) ?? url;
  });
  let meshes: ModelMesh[];
  try {
    const bytes = await main.arrayBuffer();
    meshes = meshesOf((await new GLTFLoader(manager).parseAsync(bytes, '')).scene);
  } catch (error) {
    const [lost] = missing;
    if (lost) throw new FileProblem(`“${main.name}” needs “${lost}”: choose both together.`);
    throw new FileProblem(`“${main.name}” cannot be read: ${gltfTrouble(error)}.`);
  } finally {
    for (const address of addresses.values()) URL.revokeObjectURL(address);
  }
  const triangles = meshes.reduce((sum, mesh) => sum + mesh.triangles.length / 3, 0);
  if (triangles === 0) throw new FileProblem(`“${main.name}” holds no surfaces.`);
  if (triangles > kMostTriangles)
    throw new FileProblem(
      `“${main.name}” has ${triangles.toLocaleString('en')} triangles; three million are the most.`,
    );
  return meshes;
}
