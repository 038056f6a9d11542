// Exits, sources and waiting areas on the ground: told apart by colour, rim and pattern, so that no colour is needed.

import type { AreaKindWord } from '../../protocol/generated/words';
import type { Vec2 } from '../../protocol/generated/commands';
import type { SceneArea } from '../../protocol/messages';
import { counterClockwise } from '../drawing/geometry_builder';
import type { Palette } from '../drawing/palette';
import { addRim, edges, hatchChords, kFloorHeight, kLineHeight, type PatchParts } from './patch_parts';

/** Between the stripes of a source, of what is closed, and between the marks of a waiting area [m]. */
const kSpacing = { source: 0.8, closed: 0.6, waiting: 1 };
const kSlope = Math.PI / 4;
/** Half the length of a mark [m]. */
const kMark = 0.09;

function addLine(parts: PatchParts, a: Vec2, b: Vec2, colour: string, alpha: number): void {
  const line = [
    [a[0], a[1], kLineHeight],
    [b[0], b[1], kLineHeight],
  ] as const;
  parts.lines.push({ line, colour, alpha });
}

function addPattern(parts: PatchParts, outline: readonly Vec2[], kind: AreaKindWord, colour: string): void {
  if (kind === 'source')
    for (const [a, b] of hatchChords(outline, kSlope, kSpacing.source)) addLine(parts, a, b, colour, 0.4);
  if (kind !== 'waiting') return;
  // A mark where somebody could stand.
  for (const [a, b] of hatchChords(outline, 0, kSpacing.waiting))
    for (let x = Math.ceil(a[0] / kSpacing.waiting) * kSpacing.waiting; x <= b[0]; x += kSpacing.waiting)
      addLine(parts, [x - kMark, a[1]], [x + kMark, a[1]], colour, 0.75);
}

export function addArea(parts: PatchParts, area: SceneArea, palette: Palette): void {
  const outline = counterClockwise(area.polygon);
  if (outline.length < 3) return;
  const { floor, line } = palette.areas[area.kind];
  const colour = area.open ? line : palette.alarm;
  parts.floor.floor(outline, kFloorHeight, area.open ? floor : palette.plainFloor);
  if (area.kind === 'source') addRim(parts, outline, colour);
  else for (const edge of edges(outline, kLineHeight)) parts.lines.push({ line: edge, colour, alpha: 0.95 });
  if (area.open) addPattern(parts, outline, area.kind, line);
  else
    for (const angle of [kSlope, -kSlope])
      for (const [a, b] of hatchChords(outline, angle, kSpacing.closed)) addLine(parts, a, b, colour, 0.3);
  const { queue } = area;
  queue.slice(1).forEach((b, k) => addLine(parts, queue[k]!, b, colour, 0.8));
}
