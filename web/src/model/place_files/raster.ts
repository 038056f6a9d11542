// A grid over a piece of ground, on which shapes are marked cell by cell.

import type { GroundPoint } from '../plane';

/** Cells of a grid, at most. */
const kMostCells = 2e6;

export class Raster {
  readonly width: number;
  readonly height: number;
  /** Edge of a cell [m]. */
  readonly cell: number;
  private readonly left_: number;
  private readonly bottom_: number;

  /** Over a box with a rim of one free cell; cells are larger than wished where there were too many. */
  constructor(min: GroundPoint, max: GroundPoint, cell: number) {
    const [wide, high] = [max.x - min.x, max.y - min.y];
    this.cell = Math.max(cell, Math.sqrt((wide * high) / kMostCells), Math.max(wide, high) / (kMostCells / 8));
    this.left_ = min.x - 1.5 * this.cell;
    this.bottom_ = min.y - 1.5 * this.cell;
    this.width = Math.ceil(wide / this.cell) + 4;
    this.height = Math.ceil(high / this.cell) + 4;
  }

  get size(): number {
    return this.width * this.height;
  }

  column(x: number): number {
    return Math.floor((x - this.left_) / this.cell);
  }

  row(y: number): number {
    return Math.floor((y - this.bottom_) / this.cell);
  }

  indexAt({ x, y }: GroundPoint): number {
    return this.row(y) * this.width + this.column(x);
  }

  /** Lower left corner of a cell, or any crossing of the grid's lines. */
  corner(column: number, row: number): GroundPoint {
    return { x: this.left_ + column * this.cell, y: this.bottom_ + row * this.cell };
  }

  /** Every cell whose middle lies in a polygon, by the even-odd rule. */
  fill(polygon: readonly GroundPoint[], mark: (index: number) => void): void {
    let [low, high] = [Infinity, -Infinity];
    for (const { y } of polygon) [low, high] = [Math.min(low, y), Math.max(high, y)];
    for (let row = Math.max(0, this.row(low)); row <= Math.min(this.height - 1, this.row(high)); ++row) {
      const y = this.bottom_ + (row + 0.5) * this.cell;
      const xs = this.crossings(polygon, y);
      for (let k = 0; k + 1 < xs.length; k += 2) {
        const from = Math.max(0, Math.ceil((xs[k]! - this.left_) / this.cell - 0.5));
        const to = Math.min(this.width - 1, Math.floor((xs[k + 1]! - this.left_) / this.cell - 0.5));
        for (let column = from; column <= to; ++column) mark(row * this.width + column);
      }
    }
  }

  /** Every cell that a segment passes through, one beside the other. */
  line(a: GroundPoint, b: GroundPoint, mark: (index: number) => void): void {
    let [column, row] = [this.column(a.x), this.row(a.y)];
    const [toColumn, toRow] = [this.column(b.x), this.row(b.y)];
    const [dx, dy] = [b.x - a.x, b.y - a.y];
    const [stepX, stepY] = [Math.sign(dx), Math.sign(dy)];
    const next = (from: number, step: number, at: number, d: number, corner: number): number =>
      step === 0 ? Infinity : (corner + (from + (step > 0 ? 1 : 0)) * this.cell - at) / d;
    let tx = next(column, stepX, a.x, dx, this.left_);
    let ty = next(row, stepY, a.y, dy, this.bottom_);
    mark(row * this.width + column);
    for (let left = Math.abs(toColumn - column) + Math.abs(toRow - row); left > 0; --left) {
      if (tx < ty ? column !== toColumn : row === toRow) {
        column += stepX;
        tx += Math.abs(this.cell / dx);
      } else {
        row += stepY;
        ty += Math.abs(this.cell / dy);
      }
      mark(row * this.width + column);
    }
  }

  private crossings(polygon: readonly GroundPoint[], y: number): number[] {
    const xs: number[] = [];
    for (let i = 0; i < polygon.length; ++i) {
      const [a, b] = [polygon[i]!, polygon[(i + 1) % polygon.length]!];
      if (a.y > y !== b.y > y) xs.push(a.x + ((y - a.y) / (b.y - a.y)) * (b.x - a.x));
    }
    return xs.sort((p, q) => p - q);
  }
}

/** Numbers the regions of marked cells that lie side by side, from 1 on; 0 where nothing is marked. */
export function regionsOf(raster: Raster, marked: Uint8Array): { readonly labels: Int32Array; readonly count: number } {
  const labels = new Int32Array(raster.size);
  const { width } = raster;
  let count = 0;
  const open: number[] = [];
  for (let start = 0; start < marked.length; ++start) {
    if (marked[start] === 0 || labels[start] !== 0) continue;
    labels[start] = ++count;
    open.push(start);
    for (let at = open.pop(); at !== undefined; at = open.pop())
      // The rim is never marked, so that all neighbours are on the grid.
      for (const beside of [at - 1, at + 1, at - width, at + width])
        if (marked[beside] === 1 && labels[beside] === 0) {
          labels[beside] = count;
          open.push(beside);
        }
  }
  return { labels, count };
}

/** Cells of each region, by its number. */
export function cellsOf(labels: Int32Array, count: number): number[][] {
  const cells: number[][] = Array.from({ length: count + 1 }, () => []);
  labels.forEach((label, index) => label > 0 && cells[label]!.push(index));
  return cells;
}

/** Rings round the cells of one region: counter-clockwise outside, clockwise round holes; corners only. */
export function traced(raster: Raster, cells: readonly number[], labels: Int32Array): GroundPoint[][] {
  const { width } = raster;
  const label = labels[cells[0]!]!;
  const columns = width + 1;
  /** From the crossing where an edge starts to where it ends; two edges may start at one. */
  const edges = new Map<number, number[]>();
  const add = (from: number, to: number): void => {
    const known = edges.get(from);
    if (known) known.push(to);
    else edges.set(from, [to]);
  };
  for (const index of cells) {
    const [column, row] = [index % width, Math.floor(index / width)];
    const [a, c] = [row * columns + column, (row + 1) * columns + column + 1];
    if (labels[index - width] !== label) add(a, a + 1);
    if (labels[index + 1] !== label) add(a + 1, c);
    if (labels[index + width] !== label) add(c, c - 1);
    if (labels[index - 1] !== label) add(c - 1, a);
  }
  const rings: GroundPoint[][] = [];
  for (const start of edges.keys()) while (edges.get(start)?.length) rings.push(ringFrom(start, edges, raster));
  return rings;
}

function ringFrom(start: number, edges: Map<number, number[]>, raster: Raster): GroundPoint[] {
  const columns = raster.width + 1;
  const ring: GroundPoint[] = [];
  let [at, before] = [start, 0];
  do {
    const ends = edges.get(at)!;
    // Where two cells touch by a corner alone the way goes on to the left, round the same cell.
    const left = [...ends].findIndex((end) => end - at === leftOf(before, columns));
    const to = ends.splice(Math.max(0, left), 1)[0]!;
    if (to - at !== before) ring.push(raster.corner(at % columns, Math.floor(at / columns)));
    before = to - at;
    at = to;
  } while (at !== start);
  return ring;
}

function leftOf(step: number, columns: number): number {
  if (step === 1) return columns;
  if (step === columns) return -1;
  return step === -1 ? -columns : 1;
}
