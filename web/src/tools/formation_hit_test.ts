// Finds the formation on which a contact begins, by the newest final mesh Vf.

import { hasNoPlaces } from '../model/goals';
import { distanceToSegment, insideTriangle, pointsOf, type GroundPoint, type ScreenPoint } from '../model/plane';
import type { GroupMesh } from '../protocol/messages';
import type { StudioGroup } from '../model/studio_frame';
import { rimOf } from '../scene/marks/mesh_topology';

export interface FormationHit {
  /** Index into the frame's groups. */
  readonly index: number;
  readonly group: number;
  /** To the rim, as its reach measures; 0 inside. */
  readonly distance: number;
}

/** How far a piece of rim is from a point, in any measure; null where it is out of reach. */
export type RimReach = (a: GroundPoint, b: GroundPoint) => number | null;

/** A fingertip on the screen, but never less or more than this on the ground [m]. */
const kTipPx = 24;
const kTipLeast = 0.3;
const kTipMost = 1.5;

/** Within so many metres. */
export function metresFrom(point: GroundPoint, most: number): RimReach {
  return (a, b) => {
    const away = distanceToSegment(point, a, b);
    return away <= most ? away : null;
  };
}

/** Within a fingertip, measured on the screen. */
export function fingertipFrom(point: GroundPoint, toScreen: (point: GroundPoint) => ScreenPoint): RimReach {
  const at = toScreen(point);
  return (a, b) => {
    const metres = distanceToSegment(point, a, b);
    if (metres > kTipMost) return null;
    const px = distanceToSegment(at, toScreen(a), toScreen(b));
    return px <= kTipPx || metres <= kTipLeast ? px : null;
  };
}

interface Mesh {
  readonly version: number;
  readonly triangles: Uint32Array;
  /** Pairs of vertices. */
  readonly rim: readonly number[];
}

export class FormationHitTest {
  private readonly meshes_ = new Map<number, Mesh>();
  private groups_: readonly StudioGroup[] = [];

  setMesh({ group, version, triangles, boundary }: GroupMesh): void {
    this.meshes_.set(group, { version, triangles, rim: rimOf(boundary) });
  }

  setGroups(groups: readonly StudioGroup[]): void {
    this.groups_ = groups;
  }

  /** The group whose mesh holds the point, or whose rim is nearest within reach; null for empty ground. */
  find(point: GroundPoint, reach: RimReach): FormationHit | null {
    let best: FormationHit | null = null;
    this.groups_.forEach((group, index) => {
      const distance = hasNoPlaces(group) ? null : this.distanceTo(group, point, reach);
      if (distance !== null && (best === null || distance < best.distance)) best = { index, group: group.id, distance };
    });
    return best;
  }

  /** Null out of reach, and where mesh and vertices do not belong together yet. */
  private distanceTo(group: StudioGroup, point: GroundPoint, reach: RimReach): number | null {
    const mesh = this.meshes_.get(group.id);
    if (!mesh || mesh.version !== group.meshVersion) return null;
    const vertices = pointsOf(group.vertices);
    const corner = (vertex: number): GroundPoint => vertices[vertex] ?? { x: NaN, y: NaN };
    const t = mesh.triangles;
    for (let i = 0; i + 2 < t.length; i += 3) {
      if (insideTriangle(point, corner(t[i]!), corner(t[i + 1]!), corner(t[i + 2]!))) return 0;
    }
    let nearest: number | null = null;
    for (let i = 0; i + 1 < mesh.rim.length; i += 2) {
      const away = reach(corner(mesh.rim[i]!), corner(mesh.rim[i + 1]!));
      if (away !== null && (nearest === null || away < nearest)) nearest = away;
    }
    return nearest;
  }
}
