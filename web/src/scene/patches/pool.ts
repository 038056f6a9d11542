// A pool: the ground opens on a tiled basin, filled with water one sees through.

import type { Vec2 } from '../../protocol/generated/commands';
import type { Vec3 } from '../drawing/geometry_builder';
import { boxOf } from '../obstacles/obstacle_geometry';
import type { Palette } from '../drawing/palette';
import { blended, edges, hatchChords, type PatchParts } from './patch_parts';

/** Heights of the water and of the bottom [m]. */
export const kWaterLevel = -0.1;
export const kBottom = -1.15;
const kCoping = 0.34;
const kTile = 1;

export function addPool(parts: PatchParts, outline: readonly Vec2[], palette: Palette): void {
  parts.opening.floor(outline, 0, '#000000');
  parts.water.floor(outline, kWaterLevel, palette.water);
  addBasin(parts, outline, palette);
  addCoping(parts, outline, palette);
  const box = boxOf(outline);
  hatchChords(outline, box.angle, 0.85).forEach((chord, row) => addWaves(parts, chord, row, palette));
}

function addBasin(parts: PatchParts, outline: readonly Vec2[], palette: Palette): void {
  const bottom = blended(palette.water, palette.waterLine, 0.1);
  const wall = blended(palette.coping, palette.water, 0.45);
  parts.solid.floor(outline, kBottom, bottom);
  // Walls are seen from inside.
  parts.solid.walls(outline, kBottom, 0, wall, true);
  for (const line of edges(outline, kWaterLevel)) parts.lines.push({ line, colour: palette.waterLine, alpha: 0.75 });
  const tile = blended(palette.water, palette.waterLine, 0.35);
  const { angle } = boxOf(outline);
  for (const turn of [angle, angle + Math.PI / 2]) {
    for (const [a, b] of hatchChords(outline, turn, kTile)) {
      parts.lines.push({
        line: [
          [a[0], a[1], kBottom + 0.01],
          [b[0], b[1], kBottom + 0.01],
        ],
        colour: tile,
        alpha: 0.5,
      });
    }
  }
}

/** Corners moved outwards, each side by the same width. */
export function widened(outline: readonly Vec2[], width: number): Vec2[] {
  return outline.map((p, i) => {
    const before = outline[(i + outline.length - 1) % outline.length] as Vec2;
    const after = outline[(i + 1) % outline.length] as Vec2;
    const [ax, ay] = outwards(before, p),
      [bx, by] = outwards(p, after);
    // Where both sides are moved they meet farther out.
    const size = Math.max(0.3, 1 + ax * bx + ay * by);
    return [p[0] + (width * (ax + bx)) / size, p[1] + (width * (ay + by)) / size] as const;
  });
}

/** Across a side of a counter-clockwise outline. */
function outwards(a: Vec2, b: Vec2): [number, number] {
  const size = Math.hypot(b[0] - a[0], b[1] - a[1]) || 1;
  return [(b[1] - a[1]) / size, (a[0] - b[0]) / size];
}

function addCoping(parts: PatchParts, outline: readonly Vec2[], palette: Palette): void {
  const outer = widened(outline, kCoping);
  const high = 0.022;
  outline.forEach((a, i) => {
    const j = (i + 1) % outline.length;
    const [b, c, d] = [outline[j], outer[j], outer[i]] as [Vec2, Vec2, Vec2];
    parts.solid.quad([d[0], d[1], high], [c[0], c[1], high], [b[0], b[1], high], [a[0], a[1], high], palette.coping);
  });
  parts.solid.walls(outer, 0, high, palette.coping);
  for (const line of edges(outer, high + 0.004)) parts.lines.push({ line, colour: palette.obstacleEdge, alpha: 0.35 });
}

/** Short wavy strokes along a chord. */
function addWaves(parts: PatchParts, chord: readonly [Vec2, Vec2], row: number, palette: Palette): void {
  const [a, b] = chord;
  const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
  const ux = (b[0] - a[0]) / Math.max(length, 1e-6);
  const uy = (b[1] - a[1]) / Math.max(length, 1e-6);
  const span = 1.15;
  for (let start = 0.5 + ((row * 1.37) % 1.6); start + span < length - 0.4; start += 2.5) {
    let before: Vec3 | null = null;
    for (let k = 0; k <= 8; ++k) {
      const t = start + (span * k) / 8;
      const wave = 0.07 * Math.sin((2 * Math.PI * k) / 8);
      const at: Vec3 = [a[0] + ux * t - uy * wave, a[1] + uy * t + ux * wave, kWaterLevel + 0.01];
      if (before) parts.lines.push({ line: [before, at], colour: palette.waterLine, alpha: 0.6 });
      before = at;
    }
  }
}
