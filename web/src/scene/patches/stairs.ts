// Stairs: treads across the way up, and arrows that point up.

import type { Vec2 } from '../../protocol/generated/commands';
import { centroid } from '../drawing/geometry_builder';
import type { Palette } from '../drawing/palette';
import { addPlain, hatchChords, kLineHeight, type PatchParts } from './patch_parts';

/** From one tread to the next [m]. */
const kTread = 0.3;
/** Half the width of an arrow, and its length [m]. */
const kArrow = { half: 0.3, length: 0.3 };

export function addStairs(parts: PatchParts, outline: readonly Vec2[], ascent: number, palette: Palette): void {
  addPlain(parts, outline, palette.stone, palette.obstacleEdge);
  const [c, s] = [Math.cos(ascent), Math.sin(ascent)];
  const push = (a: Vec2, b: Vec2, alpha: number): void => {
    const line = [
      [a[0], a[1], kLineHeight],
      [b[0], b[1], kLineHeight],
    ] as const;
    parts.lines.push({ line, colour: palette.obstacleEdge, alpha });
  };
  for (const [a, b] of hatchChords(outline, ascent + Math.PI / 2, kTread)) push(a, b, 0.45);
  const [x, y] = centroid(outline);
  for (const along of [-0.45, 0, 0.45]) {
    const tip: Vec2 = [x + c * (along + kArrow.length), y + s * (along + kArrow.length)];
    for (const side of [-kArrow.half, kArrow.half]) push([x + c * along - s * side, y + s * along + c * side], tip, 1);
  }
}
