// The look of a character follows from its id, and its body also from the build of its group.

import type { BodyBuildWord } from '../../protocol/generated/words';

export const kSkins = ['#F1C9A5', '#E0A97F', '#B97A50', '#8A5636', '#5B3A28'];
export const kHairs = ['#15120F', '#3A2618', '#6B4A2B', '#8F867C', '#241A16'];

export interface Look {
  readonly skin: number;
  readonly hair: number;
  /** 0 to 1. */
  readonly size: number;
}

/** A scrambled number (the finaliser of murmur3). */
function scrambled(id: number): number {
  let h = id | 0;
  h = Math.imul(h ^ (h >>> 16), 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
  return (h ^ (h >>> 16)) >>> 0;
}

export function lookOf(id: number): Look {
  const h = scrambled(id);
  return { skin: h % 5, hair: (h >>> 8) % 5, size: ((h >>> 16) & 255) / 255 };
}

/** Size over that of the skeleton; the server has the same. */
export function sizeOf(id: number): number {
  return 0.96 + 0.08 * lookOf(id).size;
}

/** Which of several bodies. */
export function bodyOf(id: number, bodies: number): number {
  return bodies > 1 ? (scrambled(id) >>> 25) % bodies : 0;
}

const kBuilds: readonly BodyBuildWord[] = ['broad', 'narrow'];

/** Which of our bodies, broad and narrow, somebody has: that of the group's build, else their own. */
export function bodyIndex(build: BodyBuildWord | null | undefined, own: number, bodies: number): number {
  return build && bodies === kBuilds.length ? kBuilds.indexOf(build) : own;
}
