// A brick wall to climb, along the middle of its patch.

import type { Vec2 } from '../../protocol/generated/commands';
import { boxOf } from '../obstacles/obstacle_geometry';
import type { Palette } from '../drawing/palette';
import { addPlain, blended, type PatchParts, thrown } from './patch_parts';

/** Height that the climb clip expects [m]. */
export const kWallHeight = 1.3;
export const kWallThickness = 0.4;
const kCourse = 0.13;
const kBrick = 0.39;
const kCap = 0.08;

/** Runs along a wall and through it. */
interface Frame {
  at(along: number, across: number): Vec2;
}

export function addWall(parts: PatchParts, outline: readonly Vec2[], palette: Palette): void {
  addPlain(parts, outline, palette.plainFloor, palette.brickLine);
  const box = boxOf(outline);
  const c = Math.cos(box.angle);
  const s = Math.sin(box.angle);
  const frame: Frame = { at: (u, v) => [box.x + c * u - s * v, box.y + s * u + c * v] };
  const reach = Math.max(0.2, box.length - 0.04);
  const half = Math.min(kWallThickness / 2, 0.5 * box.width);
  const joint = blended(palette.brick, palette.brickLine, 0.35);
  const corners = (u: number, v: number): Vec2[] => [
    frame.at(-u, -v),
    frame.at(u, -v),
    frame.at(u, v),
    frame.at(-u, v),
  ];
  parts.solid.prism(corners(reach - 0.01, half - 0.008), 0, kWallHeight - kCap, joint, joint);
  parts.solid.prism(corners(reach, half), kWallHeight - kCap, kWallHeight, palette.coping, palette.coping);
  addFaces(parts, frame, reach, half, palette);
  addEdges(parts, frame, reach, half, palette);
}

/** Bricks, each of its own shade, in running bond; joints show between them. */
function addFaces(parts: PatchParts, frame: Frame, reach: number, half: number, palette: Palette): void {
  const rows = Math.round((kWallHeight - kCap) / kCourse);
  const course = (kWallHeight - kCap) / rows;
  const gap = 0.012;
  for (const side of [-1, 1]) {
    for (let row = 0; row < rows; ++row) {
      for (let u = -reach - (row % 2 ? kBrick / 2 : 0); u < reach; u += kBrick) {
        const [from, to] = [Math.max(-reach, u + gap), Math.min(reach, u + kBrick - gap)];
        if (to - from < 0.03) continue;
        const colour = blended(
          palette.brick,
          palette.brickLine,
          0.32 * thrown(row + 40 * side, Math.round(u / kBrick + reach)),
        );
        const [a, b] = [frame.at(side < 0 ? from : to, side * half), frame.at(side < 0 ? to : from, side * half)];
        const [low, high] = [row * course + gap, (row + 1) * course];
        parts.solid.quad([a[0], a[1], low], [b[0], b[1], low], [b[0], b[1], high], [a[0], a[1], high], colour);
      }
    }
  }
}

function addEdges(parts: PatchParts, frame: Frame, reach: number, half: number, palette: Palette): void {
  const corners = [frame.at(-reach, -half), frame.at(reach, -half), frame.at(reach, half), frame.at(-reach, half)];
  corners.forEach((a, i) => {
    const b = corners[(i + 1) % 4] as Vec2;
    for (const z of [kWallHeight, kWallHeight - kCap]) {
      parts.lines.push({
        line: [
          [a[0], a[1], z],
          [b[0], b[1], z],
        ],
        colour: palette.brickLine,
        alpha: 0.75,
      });
    }
    parts.lines.push({
      line: [
        [a[0], a[1], 0],
        [a[0], a[1], kWallHeight],
      ],
      colour: palette.brickLine,
      alpha: 0.5,
    });
  });
}
