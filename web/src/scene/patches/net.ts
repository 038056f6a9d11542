// A net to crawl under: low posts, ropes, and a mesh that sags between them.

import type { Vec2 } from '../../protocol/generated/commands';
import { boxOf } from '../obstacles/obstacle_geometry';
import type { Palette } from '../drawing/palette';
import { addRim, hatchChords, kFloorHeight, type PatchParts, postsAlong } from './patch_parts';

/**
 * Height of the ropes at the posts, and depth to which the mesh sags below them; the backs of crawlers are lower
 * [m].
 */
export const kNetHeight = 0.82;
const kSag = 0.11;
const kPostSpacing = 1.9;
const kMeshes = 0.32;
/** Threads are bent where they hang, in pieces no longer than this [m]. */
const kPiece = 0.75;

export function addNet(parts: PatchParts, outline: readonly Vec2[], palette: Palette): void {
  parts.floor.floor(outline, kFloorHeight, palette.netFloor);
  addRim(parts, outline, palette.net);
  const posts = postsAlong(outline, kPostSpacing);
  for (const [x, y] of posts) parts.solid.frustum(x, y, 0, kNetHeight + 0.05, 0.05, 0.042, 6, palette.net, palette.net);
  posts.forEach((post, i) => hang(parts, post, posts[(i + 1) % posts.length] as Vec2, () => 0.05, palette.net, 1));
  const box = boxOf(outline);
  const c = Math.cos(box.angle),
    s = Math.sin(box.angle);
  // Deepest in the middle, none at the rim.
  const sag = (x: number, y: number): number => {
    const u = (c * (x - box.x) + s * (y - box.y)) / box.length,
      v = (-s * (x - box.x) + c * (y - box.y)) / box.width;
    return kSag * Math.max(0, 1 - u ** 4) * Math.max(0, 1 - v ** 4) + 0.02;
  };
  for (const angle of [box.angle + 0.79, box.angle - 0.79]) {
    for (const [a, b] of hatchChords(outline, angle, kMeshes)) hang(parts, a, b, sag, palette.net, 0.62);
  }
}

/** A thread between two points that hangs lower by `sag`, which may depend on the position. */
function hang(
  parts: PatchParts,
  a: Vec2,
  b: Vec2,
  sag: (x: number, y: number) => number,
  colour: string,
  alpha: number,
): void {
  const pieces = Math.max(2, Math.ceil(Math.hypot(b[0] - a[0], b[1] - a[1]) / kPiece));
  const at = (k: number): readonly [number, number, number] => {
    const t = k / pieces;
    const [x, y] = [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t];
    return [x, y, kNetHeight - sag(x, y) * 4 * Math.min(0.25, t * (1 - t))];
  };
  for (let k = 0; k < pieces; ++k) parts.lines.push({ line: [at(k), at(k + 1)], colour, alpha });
}
