// The shapes of groups, for previews: where places lie in a group's own axes, which face x.

import type { ShapeMeshView } from './frame_view';
import { convexHull, type GroundPoint } from './plane';

/** Outlines and fronts lie this far outside the outermost places [m]. */
const kRim = 0.5;

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

/** Ranks of so many abreast, the last one in the middle, their mean at the origin: as the engine makes them. */
function ranks(count: number, files: number, spacing: number): GroundPoint[] {
  const places = Array.from({ length: count }, (_, i) => {
    const rank = Math.floor(i / files);
    const inRank = Math.min(files, count - files * rank);
    return { x: -rank * spacing, y: ((inRank - 1) / 2 - (i % files)) * spacing };
  });
  const mean = places.reduce((sum, { x }) => sum + x, 0) / Math.max(1, count);
  return places.map(({ x, y }) => ({ x: x - mean, y }));
}

/** Formations that stand in ranks, or in no order of their own: they take up a front as wide as it is drawn. */
const kRanked = new Set(['square', 'line', 'column', 'points']);

/** True where a formation takes up a front of any width. */
export function isRanked({ formation }: GroupShape): boolean {
  return kRanked.has(formation);
}

/** The places with a front of another width: other ranks where it stands in ranks, else as they are. */
export function widened(shape: GroupShape, width: number): readonly GroundPoint[] {
  const { spacing, places } = shape;
  if (!(width > 0) || places.length < 2 || !isRanked(shape)) return places;
  const files = Math.min(places.length, Math.floor(width / spacing + 1e-6) + 1);
  return ranks(places.length, files, spacing);
}

/** How far the foremost place is from the centre [m]. */
export function frontOf(places: readonly GroundPoint[]): number {
  return Math.max(0, ...places.map(({ x }) => x));
}

/** Round places, half a metre outside [m]. */
export function outlineOf(places: readonly GroundPoint[]): GroundPoint[] {
  const round = places.flatMap(({ x, y }) =>
    [0, 1, 2, 3, 4, 5, 6, 7].map((k) => ({
      x: x + kRim * Math.cos((k * Math.PI) / 4),
      y: y + kRim * Math.sin((k * Math.PI) / 4),
    })),
  );
  return convexHull(round);
}

/** The front of places that face x, from left to right, half a metre before them. */
export function frontLine(places: readonly GroundPoint[]): readonly [GroundPoint, GroundPoint] {
  const [half, ahead] = [widthOf(places) / 2 + kRim, frontOf(places) + kRim];
  return [
    { x: ahead, y: half },
    { x: ahead, y: -half },
  ];
}

/** From a group's axes to the ground. */
export function placed(places: readonly GroundPoint[], at: GroundPoint, facing: number): GroundPoint[] {
  const [c, s] = [Math.cos(facing), Math.sin(facing)];
  return places.map(({ x, y }) => ({ x: at.x + c * x - s * y, y: at.y + s * x + c * y }));
}
