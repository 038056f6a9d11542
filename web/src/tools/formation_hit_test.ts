// Which formation a contact begins on, tested against the newest Vf.

import type { GroupFrame, GroupMesh } from '../protocol/messages';
import type { GroundPoint } from '../view/camera_types';
import { distanceToSegment, insideTriangle, pointsOf } from './ground_geometry';

export interface FormationHit {
  /** Index into the frame's groups. */
  readonly index: number;
  readonly group: number;
  /** To the rim [m]; 0 inside. */
  readonly distance: number;
}

interface Mesh {
  readonly version: number;
  readonly triangles: Uint32Array;
  readonly rim: readonly (readonly [number, number])[];
}

/** Loops (length, then vertices) as edges. */
export function edgesOf(boundary: ArrayLike<number>): [number, number][] {
  const edges: [number, number][] = [];
  let at = 0;
  while (at < boundary.length) {
    const length = boundary[at]!;
    const loop = Array.from({ length }, (_, i) => boundary[at + 1 + i] ?? 0);
    loop.forEach((vertex, i) => edges.push([vertex, loop[(i + 1) % length]!]));
    at += length + 1;
  }
  return edges;
}

export class FormationHitTest {
  private readonly meshes = new Map<number, Mesh>();
  private groups: readonly GroupFrame[] = [];

  setMesh(mesh: GroupMesh): void {
    this.meshes.set(mesh.group, {
      version: mesh.version,
      triangles: mesh.triangles,
      rim: edgesOf(mesh.boundary),
    });
  }

  setGroups(groups: readonly GroupFrame[]): void {
    this.groups = groups;
  }

  clear(): void {
    this.meshes.clear();
    this.groups = [];
  }

  /** The group whose mesh holds the point, or whose rim is nearest within `reach` [m]; null for empty ground. */
  find(point: GroundPoint, reach: number): FormationHit | null {
    let best: FormationHit | null = null;
    this.groups.forEach((group, index) => {
      const distance = this.distanceTo(group, point, best?.distance ?? reach);
      if (distance !== null && (best === null || distance < best.distance)) best = { index, group: group.id, distance };
    });
    return best;
  }

  /** Null beyond `reach`, and where mesh and vertices do not belong together yet. */
  private distanceTo(group: GroupFrame, point: GroundPoint, reach: number): number | null {
    const mesh = this.meshes.get(group.id);
    if (!mesh || mesh.version !== group.meshVersion) return null;
    const vertices = pointsOf(group.vertices);
    const corner = (vertex: number): GroundPoint => vertices[vertex] ?? { x: NaN, y: NaN };
    const t = mesh.triangles;
    for (let i = 0; i + 2 < t.length; i += 3) {
      if (insideTriangle(point, corner(t[i]!), corner(t[i + 1]!), corner(t[i + 2]!))) return 0;
    }
    let nearest = Infinity;
    for (const [from, to] of mesh.rim) nearest = Math.min(nearest, distanceToSegment(point, corner(from), corner(to)));
    return nearest <= reach ? nearest : null;
  }
}

/** How near the rim counts as on it: a fingertip of 24 px, within 0.3 and 1.5 m [m]. */
export function rimReach(pixelsPerMetre: number): number {
  return Math.min(1.5, Math.max(0.3, 24 / Math.max(pixelsPerMetre, 1e-6)));
}
