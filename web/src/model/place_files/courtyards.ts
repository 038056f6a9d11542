// Outlines with courtyards: obstacles have no holes, so the outline is cut through each courtyard into pieces side by side.

import { areaOf } from '../outline';
import { type GroundPoint, insidePolygon } from '../plane';
import { isSimple, mendedRing, type Ring } from './rings';

/** Smaller courtyards are filled [m^2]. */
export const kLeastCourtyard = 4;
/** The cut keeps so far from corners [m]. */
const kClear = 0.02;
const kMostPieces = 400;

interface Shape {
  /** Counter-clockwise. */
  readonly outer: Ring;
  /** Clockwise. */
  readonly holes: readonly Ring[];
}

/** Part of a ring on one side of the cut, from where it comes in to where it goes out. */
interface Chain {
  readonly points: Ring;
  readonly entry: number;
  readonly exit: number;
}

/** Near `x`, but clear of all corners. */
function clearLine(rings: readonly Ring[], x: number): number {
  const xs = rings.flatMap((ring) => ring.map((p) => p.x));
  for (let k = 0; k < 60; ++k) {
    const at = x + (k % 2 === 0 ? k : -k) * 0.0313;
    if (xs.every((one) => Math.abs(one - at) > kClear / (1 + k / 10))) return at;
  }
  return x + 0.0001234;
}

function crossingOf(a: GroundPoint, b: GroundPoint, x: number): GroundPoint {
  return { x, y: a.y + ((x - a.x) / (b.x - a.x)) * (b.y - a.y) };
}

/** What of a ring lies on a side: all of it, or chains. */
function chainsOf(ring: Ring, isOn: (p: GroundPoint) => boolean, x: number): Chain[] | 'all' | 'none' {
  const n = ring.length;
  const start = ring.findIndex((p, i) => !isOn(p) && isOn(ring[(i + 1) % n]!));
  if (start < 0) return isOn(ring[0]!) ? 'all' : 'none';
  const chains: Chain[] = [];
  let open: GroundPoint[] | null = null;
  for (let k = 0; k < n; ++k) {
    const [a, b] = [ring[(start + k) % n]!, ring[(start + k + 1) % n]!];
    if (isOn(a) !== isOn(b)) {
      const at = crossingOf(a, b, x);
      if (!isOn(a)) open = [at, b];
      else if (open) {
        chains.push({ points: [...open, at], entry: open[0]!.y, exit: at.y });
        open = null;
      }
    } else if (open) open.push(b);
  }
  return chains;
}

/** Joins chains along the cut: crossings in pairs, upwards, bound what is inside. */
function joined(chains: readonly Chain[]): Ring[] {
  const ends = chains
    .flatMap((chain) => [
      { y: chain.entry, chain, isEntry: true },
      { y: chain.exit, chain, isEntry: false },
    ])
    .sort((a, b) => a.y - b.y);
  const next = new Map<Chain, Chain>();
  for (let i = 0; i + 1 < ends.length; i += 2) {
    const [a, b] = [ends[i]!, ends[i + 1]!];
    if (a.isEntry === b.isEntry) return [];
    const [exit, entry] = a.isEntry ? [b, a] : [a, b];
    next.set(exit.chain, entry.chain);
  }
  const rings: Ring[] = [];
  const left = new Set(chains);
  for (const first of chains) {
    if (!left.has(first)) continue;
    const ring: GroundPoint[] = [];
    for (let at: Chain | undefined = first; at && left.delete(at); at = next.get(at)) ring.push(...at.points);
    rings.push(ring);
  }
  return rings;
}

function side(rings: readonly Ring[], x: number, isOn: (p: GroundPoint) => boolean): Shape[] {
  const whole: Ring[] = [];
  const chains: Chain[] = [];
  for (const ring of rings) {
    const found = chainsOf(ring, isOn, x);
    if (found === 'all') whole.push(ring);
    else if (found !== 'none') chains.push(...found);
  }
  const all = [...whole, ...joined(chains)];
  const outers = all.filter((ring) => areaOf(ring) > 0);
  const holes = all.filter((ring) => areaOf(ring) < 0);
  return outers.map((outer) => ({ outer, holes: holes.filter((hole) => insidePolygon(hole[0]!, outer)) }));
}

/**
 * Pieces that together are the outline without its courtyards, all counter-clockwise. Both may turn either way.
 * Null where that cannot be done: then the courtyards are best filled.
 */
export function withoutCourtyards(outer: Ring, holes: readonly Ring[]): Ring[] | null {
  const turned = (ring: Ring, left: boolean): Ring => (areaOf(ring) > 0 === left ? ring : [...ring].reverse());
  const large = holes.filter((hole) => Math.abs(areaOf(hole)) >= kLeastCourtyard);
  let shapes: Shape[] = [{ outer: turned(outer, true), holes: large.map((hole) => turned(hole, false)) }];
  const done: Ring[] = [];
  while (shapes.length > 0) {
    if (done.length + shapes.length > kMostPieces) return null;
    const { outer: around, holes: within } = shapes.pop()!;
    const [first] = within;
    if (!first) {
      const mended = mendedRing(around);
      if (mended === 'flat') continue;
      if (typeof mended === 'string' || !mended.every(isSimple)) return null;
      done.push(...mended);
      continue;
    }
    const xs = first.map((p) => p.x);
    const rings = [around, ...within];
    const x = clearLine(rings, (Math.min(...xs) + Math.max(...xs)) / 2);
    shapes = [...shapes, ...side(rings, x, (p) => p.x < x), ...side(rings, x, (p) => p.x > x)];
  }
  return done;
}
