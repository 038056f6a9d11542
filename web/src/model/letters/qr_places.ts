// A QR code made of people: one person, or a few in a square, on each dark module.

import { correction, generate, type Bitmap2D } from 'lean-qr';
import type { GroundPoint } from '../plane';

export interface QrPlaces {
  /** About the middle of the code, y up; neighbours stand 1 apart. */
  readonly places: readonly GroundPoint[];
  /** Modules on a side. */
  readonly modules: number;
  /** People on a side of a module. */
  readonly side: number;
  /** People who are no part of the code, and stand in rows below it. */
  readonly spare: number;
}

export type QrAnswer = { readonly code: QrPlaces } | { readonly needs: number } | { readonly why: string };

/** White round the code that readers need, in modules. */
export const kQuietZone = 4;
/** A larger version has modules too small to be told apart from above (41 modules on a side). */
const kLargestVersion = 6;
const kMostBytes = 120;
const kMostSide = 8;
const kLevels = [correction.L, correction.M, correction.Q, correction.H] as const;
const kMasks = [0, 1, 2, 3, 4, 5, 6, 7] as const;
/** A code that uses this share of the most people who can be used may be taken for being safer. */
const kNearlyAll = 0.95;

interface Candidate {
  readonly code: Bitmap2D;
  readonly dark: number;
  readonly level: number;
}

function darkOf(code: Bitmap2D): number {
  let dark = 0;
  for (let y = 0; y < code.size; ++y) for (let x = 0; x < code.size; ++x) if (code.get(x, y)) dark += 1;
  return dark;
}

/** Every code of the address up to the largest version: by correction, size and mask. */
function candidatesFor(address: string): Candidate[] {
  const found: Candidate[] = [];
  kLevels.forEach((wanted, level) => {
    for (let version = 1; version <= kLargestVersion; ++version) {
      const fixed = {
        minCorrectionLevel: wanted,
        maxCorrectionLevel: wanted,
        minVersion: version,
        maxVersion: version,
      };
      for (const mask of kMasks) {
        try {
          const code = generate(address, { ...fixed, mask });
          found.push({ code, dark: darkOf(code), level });
        } catch {
          // Too long for this version.
          break;
        }
      }
    }
  });
  return found;
}

/** A code of an address for so many people; how many it needs where they are too few. */
export function qrPlaces(address: string, count: number): QrAnswer {
  const long = `An address of more than ${kMostBytes} letters makes a code too fine to be read: shorten it.`;
  if (new TextEncoder().encode(address).length > kMostBytes) return { why: long };
  const candidates = candidatesFor(address);
  if (candidates.length === 0) return { why: long };
  const needs = Math.min(...candidates.map(({ dark }) => dark));
  if (count < needs) return { needs };
  const sides = Array.from({ length: kMostSide }, (_, i) => i + 1);
  const fitting = candidates
    .flatMap((candidate) => sides.map((side) => ({ ...candidate, side, used: candidate.dark * side * side })))
    .filter(({ used }) => used <= count);
  const most = Math.max(...fitting.map(({ used }) => used));
  // The more of it may be missing, and the larger its modules are, the better it is read.
  const [best] = fitting
    .filter(({ used }) => used >= kNearlyAll * most)
    .sort((a, b) => b.level - a.level || a.code.size - b.code.size || b.used - a.used);
  const { code, side, used } = best!;
  return { code: { places: placesOf(code, side, count - used), modules: code.size, side, spare: count - used } };
}

function placesOf(code: Bitmap2D, side: number, spare: number): GroundPoint[] {
  const places: GroundPoint[] = [];
  const wide = code.size * side;
  const at = (column: number, row: number): GroundPoint => ({
    x: column - (wide - 1) / 2,
    y: (wide - 1) / 2 - row,
  });
  for (let row = 0; row < wide; ++row)
    for (let column = 0; column < wide; ++column)
      if (code.get(Math.floor(column / side), Math.floor(row / side))) places.push(at(column, row));
  for (let i = 0; i < spare; ++i) places.push(at(i % wide, wide + kQuietZone * side + Math.floor(i / wide)));
  return places;
}
