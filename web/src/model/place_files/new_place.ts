// Places made of outlines: a new one around them, or commands that add them to the present one.

import type { Command } from '../../protocol/generated/commands';
import type { ObstacleDef, PatchDef } from '../../protocol/generated/definitions';
import { sizeOf } from '../../protocol/encoding';
import type { Edit } from '../../protocol/messages';
import { startFor } from './free_ground';
import { count, type LeftOut } from './left_out';
import {
  type Bounds,
  boundsOfOutlines,
  obstacleOf,
  type Outline,
  type PlaceDefinition,
  toMillimetre,
  waterOf,
} from './place';

/** Free ground around what was imported: such a share of its size, at least [m]. */
const kMargin = { share: 0.08, least: 6 };
/** The motion of people in water. */
export const kSwim = 'swim';
/** Cells of the ground: at most so many, and so large where places are large [m]. */
const kMostGround = 15.5e6;
const kCells = { fine: 0.25, usual: 0.5, fineUpTo: 200 };
/** What one message may hold (docs/protocol.md). */
export const kMostCommands = 256;
export const kMostBytes = 256 * 1024;

export function cellFor(wide: number, high: number): number {
  const usual = Math.max(wide, high) <= kCells.fineUpTo ? kCells.fine : kCells.usual;
  const least = Math.sqrt((wide * high) / kMostGround);
  return Math.max(usual, Math.ceil(least * 20) / 20);
}

/** The box of a place around these outlines. */
export function boxAround(outlines: readonly Outline[]): Bounds {
  const bounds = boundsOfOutlines(outlines) ?? { min: { x: -16, y: -16 }, max: { x: 16, y: 16 } };
  const { min, max } = bounds;
  const margin = Math.max(kMargin.least, kMargin.share * Math.max(max.x - min.x, max.y - min.y));
  return {
    min: { x: Math.floor(min.x - margin), y: Math.floor(min.y - margin) },
    max: { x: Math.ceil(max.x + margin), y: Math.ceil(max.y + margin) },
  };
}

/** A place around outlines, with people where they have room. */
export function placeAround(
  outlines: readonly Outline[],
  about: { readonly name: string; readonly description: string; readonly people: number },
): PlaceDefinition {
  const box = boxAround(outlines);
  const { x, y } = startFor(about.people, box, outlines);
  const waters = outlines.filter(({ water }) => water);
  return {
    format: 'muster-scenario',
    version: 1,
    name: about.name,
    description: about.description,
    box: [
      [box.min.x, box.min.y],
      [box.max.x, box.max.y],
    ],
    cell: cellFor(box.max.x - box.min.x, box.max.y - box.min.y),
    obstacles: outlines.filter(({ water }) => !water).map(obstacleOf),
    ...(waters.length > 0 ? { patches: waters.map((one) => waterOf(one, kSwim)) } : {}),
    groups: [
      {
        name: 'Crowd',
        count: about.people,
        formation: 'square',
        position: [toMillimetre(x), toMillimetre(y)],
        angle: 0,
      },
    ],
  };
}

/** Those that reach into a box; the others are counted. */
export function within(outlines: readonly Outline[], box: Bounds, left: LeftOut): Outline[] {
  const kept = outlines.filter((outline) => {
    const { min, max } = boundsOfOutlines([outline])!;
    return max.x > box.min.x && max.y > box.min.y && min.x < box.max.x && min.y < box.max.y;
  });
  count(left, 'outside', outlines.length - kept.length);
  return kept;
}

/** Messages that add obstacles and water; one undo takes all of them back. */
export function additionOf(
  obstacles: readonly ObstacleDef[],
  label: string,
  gesture: number,
  waters: readonly (PatchDef & { readonly motion: number })[] = [],
): Edit[] {
  const messages: Edit[] = [];
  let commands: Command[] = [];
  let size = 0;
  const send = (): void => {
    if (commands.length > 0) messages.push({ type: 'Edit', label, gesture, commands, bodies: [] });
    [commands, size] = [[], 0];
  };
  const made: Command[] = [
    ...obstacles.map(({ name, polygon, centre, radius, height }): Command => ({
      kind: 'putThing',
      obstacle: { name, polygon, centre, radius, height },
    })),
    ...waters.map(({ name, polygon, motion }): Command => ({ kind: 'putThing', patch: { name, polygon, motion } })),
  ];
  for (const command of made) {
    const own = sizeOf('Command', command);
    if (commands.length === kMostCommands || size + own > kMostBytes) send();
    commands.push(command);
    size += own;
  }
  send();
  return messages;
}
