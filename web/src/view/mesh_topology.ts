// The lines of a group's mesh: which edges lie inside, which on the rim.

import type { GroupMeshView, Numbers } from './frame_types';

export interface MeshTopology {
  readonly version: number;
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

export function makeTopology(mesh: GroupMeshView): MeshTopology {
  const rimKeys = new Set<number>();
  const rim: number[] = [];
  const key = (a: number, b: number): number => Math.min(a, b) * 0x4000000 + Math.max(a, b);
  for (const loop of readLoops(mesh.boundary)) {
    for (let i = 0; i < loop.length; ++i) {
      const a = loop[i] ?? 0;
      const b = loop[(i + 1) % loop.length] ?? 0;
      rimKeys.add(key(a, b));
      rim.push(a, b);
    }
  }
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
    triangles: Uint32Array.from(mesh.triangles),
    inside: Uint32Array.from(inside),
    rim: Uint32Array.from(rim),
  };
}

/** True where the point lies in one of the triangles. */
export function insideMesh(topology: MeshTopology, vertices: Numbers, x: number, y: number): boolean {
  const { triangles } = topology;
  const side = (a: number, b: number): number => {
    const ax = vertices[2 * a] ?? 0;
    const ay = vertices[2 * a + 1] ?? 0;
    return ((vertices[2 * b] ?? 0) - ax) * (y - ay) - ((vertices[2 * b + 1] ?? 0) - ay) * (x - ax);
  };
  for (let t = 0; t + 2 < triangles.length; t += 3) {
    const a = triangles[t] ?? 0;
    const b = triangles[t + 1] ?? 0;
    const c = triangles[t + 2] ?? 0;
    const u = side(a, b);
    const v = side(b, c);
    const w = side(c, a);
    if ((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0)) return true;
  }
  return false;
}
