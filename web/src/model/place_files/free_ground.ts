// Where a new group has room to stand.

import type { GroundPoint } from '../plane';
import type { Bounds, Outline } from './place';
import { Raster } from './raster';

/** The ground is looked at with cells of this size [m] or larger. */
const kCell = 0.5;

/** Blocks all free cells but those of the largest region: nobody shall begin in a closed courtyard. */
export function largestRegion(blocked: ArrayLike<number>, width: number, height: number): Uint8Array {
  const region = new Int32Array(width * height);
  const sizes = [0];
  const open: number[] = [];
  const visit = (i: number): void => {
    if (blocked[i] || region[i] !== 0) return;
    region[i] = sizes.length - 1;
    sizes[sizes.length - 1]! += 1;
    open.push(i);
  };
  for (let start = 0; start < region.length; ++start) {
    if (blocked[start] || region[start] !== 0) continue;
    sizes.push(0);
    visit(start);
    for (let i = open.pop(); i !== undefined; i = open.pop()) {
      const x = i % width;
      if (x > 0) visit(i - 1);
      if (x + 1 < width) visit(i + 1);
      if (i >= width) visit(i - width);
      if (i + width < region.length) visit(i + width);
    }
  }
  const largest = sizes.indexOf(Math.max(...sizes.slice(1)), 1);
  return Uint8Array.from(region, (one) => (one === largest && largest > 0 ? 0 : 1));
}

/** Distance of each free cell to the nearest blocked one or to the rim, in cells; 0 where blocked. Chessboard steps. */
export function roomOf(blocked: ArrayLike<number>, width: number, height: number): Uint16Array {
  const room = new Uint16Array(width * height);
  const at = (x: number, y: number): number => (x < 0 || y < 0 || x >= width || y >= height ? 0 : room[y * width + x]!);
  const least = (x: number, y: number, side: number): number =>
    1 + Math.min(at(x - side, y), at(x - 1, y - side), at(x, y - side), at(x + 1, y - side));
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x) room[y * width + x] = blocked[y * width + x] ? 0 : Math.min(65535, least(x, y, 1));
  for (let y = height - 1; y >= 0; --y)
    for (let x = width - 1; x >= 0; --x) {
      const i = y * width + x;
      room[i] = Math.min(room[i]!, least(x, y, -1));
    }
  return room;
}

/** The cell with most room; of those with as much as is needed, the one nearest to the middle. Null where all is blocked. */
export function roomiest(
  room: Uint16Array,
  width: number,
  needed: number,
): { readonly column: number; readonly row: number; readonly room: number } | null {
  const height = room.length / Math.max(1, width);
  let best = -1;
  let bestWorth = -Infinity;
  room.forEach((own, i) => {
    if (own === 0) return;
    const away = Math.hypot((i % width) + 0.5 - width / 2, Math.floor(i / width) + 0.5 - height / 2);
    const worth = Math.min(own, needed) * 1e6 - away;
    if (worth > bestWorth) [best, bestWorth] = [i, worth];
  });
  return best < 0 ? null : { column: best % width, row: Math.floor(best / width), room: room[best]! };
}

/** The middle of the ground with room for a square of so many people; the middle of the box where there is none. */
export function startFor(people: number, box: Bounds, outlines: readonly Outline[], spacing = 1): GroundPoint {
  const raster = new Raster(box.min, box.max, kCell);
  const blocked = new Uint8Array(raster.size);
  const block = (index: number): void => void (index >= 0 && index < blocked.length && (blocked[index] = 1));
  for (const { corners } of outlines) {
    raster.fill(corners, block);
    const inside = corners.every(({ x, y }) => x >= box.min.x && y >= box.min.y && x <= box.max.x && y <= box.max.y);
    if (inside) corners.forEach((a, i) => raster.line(a, corners[(i + 1) % corners.length]!, block));
  }
  const needed = (Math.sqrt(people) * spacing) / 2 / raster.cell + 2;
  const { width, height } = raster;
  const found = roomiest(roomOf(largestRegion(blocked, width, height), width, height), width, needed);
  if (!found) return { x: (box.min.x + box.max.x) / 2, y: (box.min.y + box.max.y) / 2 };
  const corner = raster.corner(found.column, found.row);
  return { x: corner.x + raster.cell / 2, y: corner.y + raster.cell / 2 };
}
