// The shapes of groups, for previews: where places lie in a group's own axes, which face x.

import type { ShapeMeshView } from './frame_view';
import type { GroundPoint } from './plane';

export interface GroupShape {
  readonly formation: string;
  /** Between neighbouring places [m]. */
  readonly spacing: number;
  /** In the group's axes [m]. */
  readonly places: readonly GroundPoint[];
}

function placesOf({ rest, triangles, placeTriangles, placeWeights }: ShapeMeshView): GroundPoint[] {
  return Array.from(placeTriangles, (triangle, k) => {
    const u = placeWeights[2 * k]!;
    const v = placeWeights[2 * k + 1]!;
    const corner = (i: number): number => 2 * triangles[3 * triangle + i]!;
    const [a, b, c] = [corner(0), corner(1), corner(2)];
    const along = (axis: number): number => u * rest[a + axis]! + v * rest[b + axis]! + (1 - u - v) * rest[c + axis]!;
    return { x: along(0), y: along(1) };
  });
}

export class GroupShapes {
  private readonly shapes_ = new Map<number, GroupShape>();

  setMesh(mesh: ShapeMeshView): void {
    const { formation, spacing } = mesh;
    this.shapes_.set(mesh.group, { formation, spacing, places: placesOf(mesh) });
  }

  clear(): void {
    this.shapes_.clear();
  }

  of(group: number): GroupShape | undefined {
    return this.shapes_.get(group);
  }
}

/** From left to right, as it faces [m]. */
export function widthOf(places: readonly GroundPoint[]): number {
  if (places.length === 0) return 0;
  const across = places.map(({ y }) => y);
  return Math.max(...across) - Math.min(...across);
}

/** From front to rear [m]. */
export function depthOf(places: readonly GroundPoint[]): number {
  if (places.length === 0) return 0;
  const along = places.map(({ x }) => x);
  return Math.max(...along) - Math.min(...along);
}

/** Ranks of so many abreast; the last one stands in the middle. */
function ranks(count: number, files: number, spacing: number): GroundPoint[] {
  const rows = Math.ceil(count / files);
  return Array.from({ length: count }, (_, i) => {
    const rank = Math.floor(i / files);
    const inRank = rank + 1 < rows ? files : count - files * (rows - 1);
    return { x: ((rows - 1) / 2 - rank) * spacing, y: ((inRank - 1) / 2 - (i % files)) * spacing };
  });
}

const kRanked = new Set(['square', 'line', 'column']);

/** The places with a front of another width: other ranks where it stands in ranks, else stretched across. */
export function widened({ formation, spacing, places }: GroupShape, width: number): readonly GroundPoint[] {
  const now = widthOf(places);
  if (!(width > 0) || places.length < 2) return places;
  if (kRanked.has(formation)) {
    const files = Math.min(places.length, Math.max(1, Math.round(width / spacing) + 1));
    return ranks(places.length, files, spacing);
  }
  const stretch = now > 0 ? width / now : 1;
  return places.map(({ x, y }) => ({ x: x / stretch, y: y * stretch }));
}

/** From a group's axes to the ground. */
export function placed(places: readonly GroundPoint[], at: GroundPoint, facing: number): GroundPoint[] {
  const [c, s] = [Math.cos(facing), Math.sin(facing)];
  return places.map(({ x, y }) => ({ x: at.x + c * x - s * y, y: at.y + s * x + c * y }));
}
