// A body of the characters: its joints, and its skin at two levels of detail.

import type { BufferGeometry, Texture } from 'three';
import type { Rig } from './rig';

/** Materials of the skin, as the attribute `region` numbers them; `own` keeps the colours of the file. */
export const kRegion = {
  skin: 0,
  shirt: 1,
  farShirt: 1.2,
  farHead: 1.3,
  farLegs: 1.4,
  trousers: 2,
  hair: 3,
  shoes: 4,
  own: 5,
} as const;

/** One draw call: geometry with `position`, `normal`, `joints`, `weights`, `region`, `tint`, and `uv` for a map. */
export interface BodyPart {
  readonly geometry: BufferGeometry;
  readonly map: Texture | null;
}

export interface Body {
  readonly name: string;
  readonly rig: Rig;
  readonly near: readonly BodyPart[];
  readonly far: readonly BodyPart[];
}

/** Triangles of one level. */
export function trianglesOf(parts: readonly BodyPart[]): number {
  return parts.reduce(
    (sum, { geometry }) => sum + (geometry.index?.count ?? geometry.attributes['position']!.count) / 3,
    0,
  );
}

/** Frees its geometries and textures. */
export function disposeBody(body: Body): void {
  for (const { geometry, map } of [...body.near, ...body.far]) {
    geometry.dispose();
    map?.dispose();
  }
}
