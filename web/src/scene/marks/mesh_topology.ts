// The lines of a group's mesh: which edges lie inside, which on the rim.

import type { GroupMeshView, Numbers } from '../../model/frame_view';

export interface MeshTopology {
  readonly version: number;
  /** Its places draw a picture: lines round it are faint. */
  readonly drawn: boolean;
  readonly triangles: Uint32Array<ArrayBuffer>;
  /** Pairs of vertices. */
  readonly inside: Uint32Array;
  /** Pairs of vertices along the boundary loops. */
  readonly rim: Uint32Array;
}

/** Reads loops written as length, then vertices; a torn last loop is left out. */
export function readLoops(boundary: Numbers): number[][] {
  const loops: number[][] = [];
  let at = 0;
  while (at < boundary.length) {
    const length = boundary[at] ?? 0;
    if (length < 1 || at + 1 + length > boundary.length) break;
    const loop: number[] = [];
    for (let i = 0; i < length; ++i) loop.push(boundary[at + 1 + i] ?? 0);
    loops.push(loop);
    at += length + 1;
  }
  return loops;
}

/** Pairs of vertices along the loops. */
export function rimOf(boundary: Numbers): number[] {
  return readLoops(boundary).flatMap((loop) => loop.flatMap((vertex, i) => [vertex, loop[(i + 1) % loop.length] ?? 0]));
}

export function makeTopology(mesh: GroupMeshView): MeshTopology {
  const rimKeys = new Set<number>();
  const rim = rimOf(mesh.boundary);
  const key = (a: number, b: number): number => Math.min(a, b) * 0x4000000 + Math.max(a, b);
  for (let i = 0; i < rim.length; i += 2) rimKeys.add(key(rim[i] ?? 0, rim[i + 1] ?? 0));
  const seen = new Set<number>();
  const inside: number[] = [];
  for (let t = 0; t + 2 < mesh.triangles.length; t += 3) {
    for (let e = 0; e < 3; ++e) {
      const a = mesh.triangles[t + e] ?? 0;
      const b = mesh.triangles[t + ((e + 1) % 3)] ?? 0;
      const id = key(a, b);
      if (rimKeys.has(id) || seen.has(id)) continue;
      seen.add(id);
      inside.push(a, b);
    }
  }
  return {
    version: mesh.version,
    drawn: mesh.formation === 'points',
    triangles: Uint32Array.from(mesh.triangles),
    inside: Uint32Array.from(inside),
    rim: Uint32Array.from(rim),
  };
}
