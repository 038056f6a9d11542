// Imported models that are shown where they stand; the server knows their footprints alone.

import type { ObstacleDef, Point } from '../../protocol/generated/definitions';
import type { GroundPoint } from '../plane';
import type { ModelMesh } from './mesh';
import { boundsOf } from './place';

/** One model, ready to be drawn: triangles by their three corners. */
export interface SceneryModel {
  readonly name: string;
  /** x, y, z of each corner [m]. */
  readonly positions: Float32Array;
  /** Red, green, blue of each triangle, 0 to 255, linear. */
  readonly colours: Uint8Array;
  /** The obstacles that it came to: those are not drawn as long as they are where they were. */
  readonly obstacles: readonly SceneryObstacle[];
}

export interface SceneryObstacle {
  readonly name: string;
  /** Middle of its box [m]. */
  readonly x: number;
  readonly y: number;
}

/** What an obstacle may be off and still be the same [m]. */
const kSame = 0.05;

export function middleOfBox(polygon: readonly Point[]): GroundPoint {
  const bounds = boundsOf(polygon.map(([x, y]) => ({ x, y })));
  if (!bounds) return { x: NaN, y: NaN };
  return { x: (bounds.min.x + bounds.max.x) / 2, y: (bounds.min.y + bounds.max.y) / 2 };
}

/** Puts meshes together, moved to a point. */
export function sceneryOf(
  name: string,
  meshes: readonly ModelMesh[],
  at: GroundPoint,
  obstacles: readonly Pick<ObstacleDef, 'name' | 'polygon'>[],
): SceneryModel {
  const triangles = meshes.reduce((sum, mesh) => sum + mesh.triangles.length / 3, 0);
  const positions = new Float32Array(9 * triangles);
  const colours = new Uint8Array(3 * triangles);
  let [corner, triangle] = [0, 0];
  for (const mesh of meshes) {
    for (const index of mesh.triangles) {
      positions[corner++] = mesh.positions[3 * index]! + at.x;
      positions[corner++] = mesh.positions[3 * index + 1]! + at.y;
      positions[corner++] = mesh.positions[3 * index + 2]!;
    }
    for (let t = 0; t < mesh.triangles.length; t += 3)
      for (const part of mesh.colour) colours[triangle++] = Math.round(255 * Math.min(1, Math.max(0, part)));
  }
  return {
    name,
    positions,
    colours,
    obstacles: obstacles.map(({ name: own = '', polygon = [] }) => ({ name: own, ...middleOfBox(polygon) })),
  };
}

/** Tells whether an obstacle is shown by one of these models. */
export function shownBy(models: readonly SceneryModel[]): (obstacle: Pick<ObstacleDef, 'name' | 'polygon'>) => boolean {
  const known = new Map<string, SceneryObstacle[]>();
  for (const { obstacles } of models)
    for (const one of obstacles) known.set(one.name, [...(known.get(one.name) ?? []), one]);
  return ({ name = '', polygon }) => {
    const same = known.get(name);
    if (!same || !polygon?.length) return false;
    const { x, y } = middleOfBox(polygon);
    return same.some((one) => Math.abs(one.x - x) < kSame && Math.abs(one.y - y) < kSame);
  };
}
