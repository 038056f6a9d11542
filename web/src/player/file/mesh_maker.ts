// Makes meshes from the shapes of a scene, as src/files/export/scene_mesh.cpp does.

export type Point = readonly [number, number, number];

/** Triangles with a normal and a finish per corner. */
export interface SceneMesh {
  /** Three per corner [m]. */
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  /** One per corner: number of the finish. */
  readonly finishes: Uint8Array;
}

/** A number from 0 to 1; the same arguments give the same number. */
export function thrown(a: number, b: number): number {
  let h = (Math.imul(a, 0x9e3779b9) + Math.imul(b, 0x85ebca6b) + 0x6b43a9b5) | 0;
  h = Math.imul(h ^ (h >>> 16), 0x7feb352d);
  h = Math.imul(h ^ (h >>> 15), 0x846ca68b);
  return ((h ^ (h >>> 16)) >>> 8) / (1 << 24);
}

const sum = (a: Point, b: Point): Point => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const difference = (a: Point, b: Point): Point => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const times = (a: Point, k: number): Point => [a[0] * k, a[1] * k, a[2] * k];

function cross(a: Point, b: Point): Point {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

function unit(a: Point, instead: Point = [0, 0, 1]): Point {
  const length = Math.hypot(...a);
  return length > 1e-9 ? times(a, 1 / length) : instead;
}

export class MeshMaker {
  private readonly positions_: number[] = [];
  private readonly normals_: number[] = [];
  private readonly finishes_: number[] = [];

  get corners(): number {
    return this.finishes_.length;
  }

  triangle(finish: number, a: Point, b: Point, c: Point, normals?: readonly [Point, Point, Point]): void {
    const across = cross(difference(b, a), difference(c, a));
    if (!(Math.hypot(...across) > 1e-9)) return;
    const flat = unit(across);
    [a, b, c].forEach((at, k) => {
      this.positions_.push(...at);
      this.normals_.push(...(normals?.[k] ?? flat));
      this.finishes_.push(finish);
    });
  }

  quad(finish: number, a: Point, b: Point, c: Point, d: Point): void {
    this.triangle(finish, a, b, c);
    this.triangle(finish, a, c, d);
  }

  /** A convex level polygon, counter-clockwise from above. */
  floor(finish: number, outline: readonly Point[], z: number): void {
    const at = (k: number): Point => [outline[k]![0], outline[k]![1], z];
    for (let k = 2; k < outline.length; ++k) this.triangle(finish, at(0), at(k - 1), at(k));
  }

  walls(finish: number, outline: readonly Point[], [low, high]: readonly [number, number], inside: boolean): void {
    const up = (p: Point, z: number): Point => [p[0], p[1], z];
    for (let k = 0; k < outline.length; ++k) {
      let [a, b] = [outline[k]!, outline[(k + 1) % outline.length]!];
      if (inside) [a, b] = [b, a];
      this.quad(finish, up(a, low), up(b, low), up(b, high), up(a, high));
    }
  }

  /** A truncated cone with a lid. */
  frustum(finish: number, base: Point, size: { height: number; low: number; high: number; sides: number }): void {
    const { height, low, high, sides } = size;
    const rim = (k: number, radius: number, z: number): Point => {
      const angle = (2 * Math.PI * k) / sides;
      return sum(base, [radius * Math.cos(angle), radius * Math.sin(angle), z]);
    };
    const normal = (k: number): Point => {
      const angle = (2 * Math.PI * k) / sides;
      return unit([Math.cos(angle), Math.sin(angle), (low - high) / height]);
    };
    for (let k = 0; k < sides; ++k) {
      const [a, b, c, d] = [rim(k, low, 0), rim(k + 1, low, 0), rim(k + 1, high, height), rim(k, high, height)];
      this.triangle(finish, a, b, c, [normal(k), normal(k + 1), normal(k + 1)]);
      this.triangle(finish, a, c, d, [normal(k), normal(k + 1), normal(k)]);
    }
    const lid = Array.from({ length: sides }, (_, k) => rim(k, high, height));
    this.floor(finish, lid, base[2] + height);
  }

  beam(finish: number, a: Point, b: Point, width: number): void {
    const along = unit(difference(b, a), [1, 0, 0]);
    const side = times(unit(cross([0, 0, 1], along), [0, 1, 0]), width / 2);
    const rise = times(unit(cross(along, side)), width / 2);
    const ring = [
      sum(times(side, -1), times(rise, -1)),
      difference(side, rise),
      sum(side, rise),
      difference(rise, side),
    ] as const;
    for (let k = 0; k < 4; ++k) {
      const [p, q] = [ring[k]!, ring[(k + 1) % 4]!];
      this.quad(finish, sum(a, q), sum(b, q), sum(b, p), sum(a, p));
    }
    this.quad(finish, sum(a, ring[3]), sum(a, ring[2]), sum(a, ring[1]), sum(a, ring[0]));
    this.quad(finish, sum(b, ring[0]), sum(b, ring[1]), sum(b, ring[2]), sum(b, ring[3]));
  }

  /** An irregular ball of flat facets. */
  blob(
    finish: number,
    centre: Point,
    size: { radius: number; height: number; rows: number; sides: number; seed: number },
  ): void {
    const { radius, height, rows, sides, seed } = size;
    const point = (row: number, side: number): Point => {
      const tilt = (Math.PI * row) / rows - Math.PI / 2;
      const pole = row === 0 || row === rows;
      const lump = 0.88 + 0.2 * thrown(seed, row * 64 + (pole ? 0 : side % sides));
      const turn = (2 * Math.PI * ((pole ? 0 : side % sides) + 0.5 * (row % 2))) / sides;
      const flat = pole ? 0 : Math.cos(tilt) * radius * lump;
      return sum(centre, [flat * Math.cos(turn), flat * Math.sin(turn), Math.sin(tilt) * height * lump]);
    };
    for (let row = 0; row < rows; ++row) {
      for (let side = 0; side < sides; ++side) {
        const [a, b, c, d] = [point(row, side), point(row, side + 1), point(row + 1, side + 1), point(row + 1, side)];
        this.triangle(finish, a, b, c);
        this.triangle(finish, a, c, d);
      }
    }
  }

  take(): SceneMesh {
    return {
      positions: Float32Array.from(this.positions_),
      normals: Float32Array.from(this.normals_),
      finishes: Uint8Array.from(this.finishes_),
    };
  }
}
