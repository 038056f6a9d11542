// A frame as the page uses it: the whole crowd, not only what changed since the last frame.

import type { Frame, GroupFrame } from '../protocol/messages';
import type { QueueOrder } from './queue_order';

/** Numbers per character in `rows`: x, y [m], heading [rad], share of the clip before; clip and its phase (0 to 1),
 * the clip before and its phase. */
export const kRowFloats = 8;
/** Characters side by side where rows are a picture on the graphics card; `rows` holds whole lines of them. */
export const kRowsAcross = 64;

/** Floats of `rows` for so many characters. */
export function rowsLength(count: number): number {
  return kRowFloats * kRowsAcross * Math.max(1, Math.ceil(count / kRowsAcross));
}

export interface StudioGroup extends Omit<GroupFrame, 'moved' | 'offsets' | 'unfit' | 'queued' | 'orders'> {
  orders: readonly QueueOrder[];
  /** x, y per place [m]. */
  places: Float32Array;
  /** Per place: 0 where an obstacle leaves no space for a character. */
  fit: Uint8Array;
}

export interface StudioFrame extends Omit<Frame, 'crowd' | 'groups'> {
  /** Positions of all characters [m]. */
  x: Float32Array;
  y: Float32Array;
  /** Index into the clips. */
  clip: Uint8Array;
  rows: Float32Array;
  /** Indices of the characters that have whole poses. */
  near: Uint32Array;
  /** Per whole pose: hips x, y, z [m], then per joint x, y, z, w, for a body of size 1. */
  nearPoses: Float32Array;
  groups: StudioGroup[];
}

/** Buffers that are transferred to the page instead of copied. */
export function buffersOf(frame: StudioFrame): ArrayBuffer[] {
  const arrays = [
    frame.x,
    frame.y,
    frame.clip,
    frame.rows,
    frame.near,
    frame.nearPoses,
    frame.ids,
    frame.group,
    frame.unitClass,
    frame.radius,
    frame.collected,
  ];
  for (const group of frame.groups) arrays.push(group.places, group.fit, group.vertices);
  return [...new Set(arrays.map((one) => one.buffer as ArrayBuffer))];
}
