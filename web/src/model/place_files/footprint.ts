// What of a model stands in people's way: its parts between knee and head, seen from above.

import { areaOf } from '../outline';
import { convexHull, type GroundPoint } from '../plane';
import { kLeastCourtyard, withoutCourtyards } from './courtyards';
import { count, type LeftOut } from './left_out';
import { extentOf, type ModelMesh } from './mesh';
import { kMostObstacles, type Outline } from './place';
import { cellsOf, Raster, regionsOf, traced } from './raster';
import { mendedRing, simplifiedRing, type Ring } from './rings';

/** Lower things are ground, higher ones are passed below [m]. */
export const kBand = { low: 0.1, high: 2 };
/** Edge of a cell in which footprints are drawn [m]. */
const kCell = 0.1;
/** The convex hull serves where it takes so much more ground at most. */
const kHullSlack = 0.03;
/** Detail of traced rings that is left out: steps of a slanting edge are so many cells high. */
const kStairs = 1.4;
/** What faces up less than this is a slope or a wall. */
const kLevel = 0.9;
/** The ground takes at least such a share of the box seen from above. */
const kGroundShare = 0.4;
/** Heights of levels are told apart so far [m]. */
const kStep = 0.05;
/** A courtyard that is roofed over by more than this share is filled. */
const kRoofed = 0.5;

export interface FootprintOptions {
  /** Metres for one unit of the model. */
  readonly scale: number;
  /** Where the ground is [units of the model]. */
  readonly ground: number;
}

export interface Footprints {
  readonly outlines: readonly Outline[];
  readonly left: LeftOut;
  /** Objects of the model. */
  readonly total: number;
}

type Corner = readonly [x: number, y: number, z: number];

/** The height of the broadest level floor in the lower half, else of the lowest point [units of the model]. */
export function groundOf(meshes: readonly ModelMesh[]): number {
  const { min, max } = extentOf(meshes);
  const middle = (min[2] + max[2]) / 2;
  const levels = new Map<number, number>();
  for (const mesh of meshes)
    for (let t = 0; t < mesh.triangles.length; t += 3) {
      const [a, b, c] = cornersOf(mesh, t, 1, 0);
      const area = ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
      const high = Math.max(a[2], b[2], c[2]);
      const slope = high - Math.min(a[2], b[2], c[2]);
      if (area <= 0 || high > middle || slope > (1 - kLevel) * Math.sqrt(area)) continue;
      const level = Math.round(high / kStep);
      levels.set(level, (levels.get(level) ?? 0) + area);
    }
  const [level, area] = [...levels].reduce((best, one) => (one[1] > best[1] ? one : best), [0, 0]);
  const box = (max[0] - min[0]) * (max[1] - min[1]);
  return area >= kGroundShare * box ? level * kStep : min[2];
}

function cornersOf(mesh: ModelMesh, t: number, scale: number, ground: number): readonly [Corner, Corner, Corner] {
  const corner = (k: number): Corner => {
    const i = 3 * mesh.triangles[t + k]!;
    return [scale * mesh.positions[i]!, scale * mesh.positions[i + 1]!, scale * (mesh.positions[i + 2]! - ground)];
  };
  return [corner(0), corner(1), corner(2)];
}

/** The part of a convex polygon on one side of a level. */
function clipped(polygon: readonly Corner[], level: number, above: boolean): Corner[] {
  const isOn = (p: Corner): boolean => (above ? p[2] >= level : p[2] <= level);
  return polygon.flatMap((a, i) => {
    const b = polygon[(i + 1) % polygon.length]!;
    const kept = isOn(a) ? [a] : [];
    if (isOn(a) === isOn(b)) return kept;
    const t = (level - a[2]) / (b[2] - a[2]);
    return [...kept, [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), level] as const];
  });
}

const flat = (polygon: readonly Corner[]): GroundPoint[] => polygon.map(([x, y]) => ({ x, y }));

/** The grid of one object: what is in the way, how high it is there, and what hangs above. */
class ObjectGrid {
  readonly raster: Raster;
  private readonly solid_: Uint8Array;
  private readonly top_: Float32Array;
  private readonly roof_: Uint8Array;
  private readonly pieces_: GroundPoint[][] = [];

  constructor(pieces: readonly (readonly Corner[])[], triangles: readonly (readonly Corner[])[]) {
    let [left, bottom, right, top] = [Infinity, Infinity, -Infinity, -Infinity];
    for (const piece of pieces)
      for (const [x, y] of piece) {
        [left, bottom] = [Math.min(left, x), Math.min(bottom, y)];
        [right, top] = [Math.max(right, x), Math.max(top, y)];
      }
    this.raster = new Raster({ x: left, y: bottom }, { x: right, y: top }, kCell);
    this.solid_ = new Uint8Array(this.raster.size);
    this.top_ = new Float32Array(this.raster.size);
    this.roof_ = new Uint8Array(this.raster.size);
    for (const piece of pieces) this.mark(flat(piece));
    for (const triangle of triangles) this.raise(triangle);
  }

  private mark(piece: GroundPoint[]): void {
    this.pieces_.push(piece);
    const mark = (index: number): void => void (this.solid_[index] = 1);
    this.raster.fill(piece, mark);
    piece.forEach((a, i) => this.raster.line(a, piece[(i + 1) % piece.length]!, mark));
  }

  private raise(triangle: readonly Corner[]): void {
    const high = Math.max(...triangle.map(([, , z]) => z));
    const low = Math.min(...triangle.map(([, , z]) => z));
    const points = flat(triangle);
    const raise = (index: number): void => {
      if (high > this.top_[index]!) this.top_[index] = high;
      if (low >= kBand.high) this.roof_[index] = 1;
    };
    this.raster.fill(points, raise);
    for (const point of points) {
      const { column, row } = { column: this.raster.column(point.x), row: this.raster.row(point.y) };
      const isOn = column >= 0 && row >= 0 && column < this.raster.width && row < this.raster.height;
      if (isOn) raise(row * this.raster.width + column);
    }
  }

  outlines(): { readonly height: number; readonly rings: readonly Ring[] }[] {
    const { labels, count: regions } = regionsOf(this.raster, this.solid_);
    const points: GroundPoint[][] = Array.from({ length: regions + 1 }, () => []);
    for (const piece of this.pieces_) points[labels[this.raster.indexAt(piece[0]!)]!]!.push(...piece);
    return cellsOf(labels, regions)
      .slice(1)
      .map((cells, k) => {
        const height = cells.reduce((most, index) => Math.max(most, this.top_[index]!), kBand.low);
        return { height, rings: this.ringsOf(cells, labels, points[k + 1]!) };
      });
  }

  private ringsOf(cells: readonly number[], labels: Int32Array, points: readonly GroundPoint[]): readonly Ring[] {
    const loops = traced(this.raster, cells, labels).sort((a, b) => areaOf(b) - areaOf(a));
    const yards = loops.slice(1).filter((loop) => areaOf(loop) <= -kLeastCourtyard && !this.isRoofed(loop));
    const { cell } = this.raster;
    const outer = smooth(loops[0]!, cell);
    const hull = convexHull(points);
    const within = outer.reduce((sum, ring) => sum + areaOf(ring), 0);
    const slack = Math.max(kHullSlack * areaOf(hull), (cell / 4) * lengthOf(hull), (4 * cell) ** 2);
    if (yards.length === 0 && areaOf(hull) - within <= slack) {
      const mended = mendedRing(simplifiedRing(hull, cell / 5));
      if (typeof mended !== 'string') return mended;
    }
    if (yards.length === 0 || outer.length !== 1) return outer;
    const holes = yards.flatMap((yard) => smooth([...yard].reverse(), -cell));
    return withoutCourtyards(outer[0]!, holes) ?? outer;
  }

  private isRoofed(loop: Ring): boolean {
    let [all, roofed] = [0, 0];
    this.raster.fill(loop, (index) => {
      all += 1;
      roofed += this.roof_[index]!;
    });
    return roofed > kRoofed * all;
  }
}

function lengthOf(ring: Ring): number {
  return ring.reduce((sum, a, i) => {
    const b = ring[(i + 1) % ring.length]!;
    return sum + Math.hypot(b.x - a.x, b.y - a.y);
  }, 0);
}

/** Moved inwards, to the left of a ring that is counter-clockwise. */
function inset(ring: Ring, away: number): GroundPoint[] {
  const n = ring.length;
  const normal = (a: GroundPoint, b: GroundPoint): GroundPoint => {
    const long = Math.hypot(b.x - a.x, b.y - a.y);
    return { x: (a.y - b.y) / long, y: (b.x - a.x) / long };
  };
  return ring.map((p, i) => {
    const [before, after] = [normal(ring[(i + n - 1) % n]!, p), normal(p, ring[(i + 1) % n]!)];
    const [x, y] = [before.x + after.x, before.y + after.y];
    const square = Math.max(0.5, x * x + y * y);
    return { x: p.x + (2 * away * x) / square, y: p.y + (2 * away * y) / square };
  });
}

/** A traced ring without its stairs. Cells at the rim are half covered, so it is drawn in by half a cell. */
function smooth(loop: Ring, cell: number): readonly Ring[] {
  const size = Math.abs(cell);
  const plain = mendedRing(simplifiedRing(loop, kStairs * size));
  if (typeof plain === 'string') return [];
  return plain.flatMap((ring) => {
    const drawn = mendedRing(inset(ring, cell / 2));
    if (typeof drawn === 'string' || drawn.length !== 1) return [ring];
    const kept = areaOf(drawn[0]!) / areaOf(ring);
    return kept > 0.3 && kept < 4 ? drawn : [ring];
  });
}

/** The obstacles that meshes with z up come to. */
export function footprintsOf(meshes: readonly ModelMesh[], { scale, ground }: FootprintOptions): Footprints {
  const left: LeftOut = {};
  const outlines: Outline[] = [];
  for (const mesh of meshes) {
    const pieces: Corner[][] = [];
    const standing: (readonly Corner[])[] = [];
    let highest = -Infinity;
    for (let t = 0; t < mesh.triangles.length; t += 3) {
      const triangle = cornersOf(mesh, t, scale, ground);
      const top = Math.max(triangle[0][2], triangle[1][2], triangle[2][2]);
      highest = Math.max(highest, top);
      if (!(top > kBand.low)) continue;
      standing.push(triangle);
      const piece = clipped(clipped(triangle, kBand.low, true), kBand.high, false);
      if (piece.length >= 3) pieces.push(piece);
    }
    if (pieces.length === 0) {
      // Floors are no objects that anybody misses.
      if (highest > kBand.high) count(left, 'above');
      continue;
    }
    for (const { height, rings } of new ObjectGrid(pieces, standing).outlines())
      for (const corners of rings) outlines.push({ name: mesh.name, height, corners });
  }
  if (outlines.length > kMostObstacles) count(left, 'many', outlines.length - kMostObstacles);
  return { outlines: outlines.slice(0, kMostObstacles), left, total: meshes.length };
}
