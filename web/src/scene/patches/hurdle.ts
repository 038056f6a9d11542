// Patches to jump over: a hedge, or a mouse.

import type { Vec2 } from '../../protocol/generated/commands';
import type { Vec3 } from '../drawing/geometry_builder';
import { addBlob, boxOf } from '../obstacles/obstacle_geometry';
import type { Palette } from '../drawing/palette';
import { addPlain, addRim, blended, type PatchParts, thrown } from './patch_parts';

/** Height that the jump clips expect [m]. */
export const kHurdleHeight = 0.5;

/** What is jumped over while it moves is a mouse. */
export function addJump(parts: PatchParts, outline: readonly Vec2[], moves: boolean, palette: Palette): void {
  if (moves) addMouse(parts, outline, palette);
  else addHedge(parts, outline, palette);
}

function addHedge(parts: PatchParts, outline: readonly Vec2[], palette: Palette): void {
  addPlain(parts, outline, palette.plainFloor, palette.crown);
  const box = boxOf(outline);
  const c = Math.cos(box.angle),
    s = Math.sin(box.angle);
  const half = 0.13;
  const bushes = Math.max(2, Math.round((2 * box.length) / 0.36));
  for (let i = 0; i < bushes; ++i) {
    const u = -box.length + (2 * box.length * (i + 0.5)) / bushes;
    const v = 0.03 * (thrown(i, 3) - 0.5);
    const colour = blended(palette.crown, palette.trunk, 0.28 * thrown(i, 7));
    const high = kHurdleHeight * (0.94 + 0.06 * thrown(i, 1));
    addBlob(parts.solid, [box.x + c * u - s * v, box.y + s * u + c * v, high / 2], {
      radius: half + 0.09,
      height: high / 2,
      colour,
      seed: i,
      rows: 4,
      sides: 7,
    });
  }
}

/** A mouse with ears, eyes and tail. */
function addMouse(parts: PatchParts, outline: readonly Vec2[], palette: Palette): void {
  addRim(parts, outline, palette.brickLine);
  const box = boxOf(outline);
  const size = 0.62 * Math.min(box.length, box.width);
  const fur = blended(palette.grey, palette.trunk, 0.4);
  const skin = blended(palette.grey, '#E8A08C', 0.75);
  const blob = (x: number, y: number, z: number, radius: number, height: number, colour = fur): void =>
    addBlob(parts.solid, [box.x + x * size, box.y + y * size, z * size], {
      radius: radius * size,
      height: height * size,
      colour,
      seed: 0,
      rows: 8,
      sides: 12,
      lumps: 0,
    });
  blob(-0.2, 0, 0.38, 0.52, 0.38);
  blob(0.42, 0, 0.33, 0.32, 0.27);
  blob(0.74, 0, 0.27, 0.08, 0.07, palette.ink);
  for (const side of [-1, 1]) {
    blob(0.3, side * 0.27, 0.62, 0.15, 0.17);
    blob(0.345, side * 0.27, 0.62, 0.12, 0.13, skin);
    for (const x of [-0.35, 0.2]) blob(x, side * 0.3, 0.06, 0.13, 0.07, skin);
    blob(0.62, side * 0.17, 0.42, 0.045, 0.045, palette.ink);
  }
  const tail = (k: number): Vec3 => [box.x - (0.66 + 0.16 * k) * size, box.y + 0.16 * Math.sin(k) * size, 0.06 * size];
  for (let k = 0; k < 5; ++k) parts.solid.beam(tail(k), tail(k + 1), 0.05 * size, 0.05 * size, skin);
}
