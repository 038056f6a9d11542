// Meshes of imported models: x to the right, y ahead, z up [m].

export interface ModelMesh {
  readonly name: string;
  /** Three numbers a corner. */
  readonly positions: Float32Array;
  /** Three corners a triangle. */
  readonly triangles: Uint32Array;
  /** Red, green, blue, 0 to 1, linear. */
  readonly colour: readonly [number, number, number];
}

export type UpAxis = 'y' | 'z';

/** With z up; a file with y up has its -z ahead then. */
export function standing(mesh: ModelMesh, up: UpAxis): ModelMesh {
  if (up === 'z') return mesh;
  const positions = new Float32Array(mesh.positions.length);
  for (let i = 0; i + 2 < positions.length; i += 3) {
    positions[i] = mesh.positions[i]!;
    positions[i + 1] = -mesh.positions[i + 2]!;
    positions[i + 2] = mesh.positions[i + 1]!;
  }
  return { ...mesh, positions };
}

export interface Extent {
  readonly min: readonly [number, number, number];
  readonly max: readonly [number, number, number];
}

export function extentOf(meshes: readonly ModelMesh[]): Extent {
  const [min, max]: [number, number, number][] = [
    [Infinity, Infinity, Infinity],
    [-Infinity, -Infinity, -Infinity],
  ] as never;
  for (const { positions, triangles } of meshes)
    for (const corner of triangles)
      for (let k = 0; k < 3; ++k) {
        const value = positions[3 * corner + k]!;
        min![k] = Math.min(min![k]!, value);
        max![k] = Math.max(max![k]!, value);
      }
  return { min: min!, max: max! };
}

/** The axis that stands up where the file does not say: places are broader than high. */
export function likelyUp(meshes: readonly ModelMesh[]): UpAxis {
  const { min, max } = extentOf(meshes);
  return max[1] - min[1] > max[2] - min[2] ? 'z' : 'y';
}
