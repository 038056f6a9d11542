// Ground, obstacles and patches of a player's file (src/files/export/player/scene_record.cpp writes their shapes).

import { MeshMaker, type Point, type SceneMesh } from './mesh_maker';
import { BitModel, DamagedFile, NumberModel, RangeDecoder } from './range_decoder';

const kUnit = 0.002;
const kMostCorners = 4_000_000;
const kMostPoints = 100_000;
const kMostParts = 256;
const kFinishes = 25;

/** Kinds of shapes; the numbers are the writer's. */
const kShapes = ['end', 'floor', 'walls', 'quad', 'frustum', 'beam', 'blob', 'level'] as const;
type Shape = (typeof kShapes)[number];

export interface Scene {
  /** What stands still. */
  readonly still: SceneMesh;
  /** What moves, each about its pivot. */
  readonly moving: readonly SceneMesh[];
}

/** What a shape needs of its kind to be read. */
class KindModels {
  readonly flat = new NumberModel();
  readonly upright = new NumberModel();
  readonly sizes = Array.from({ length: 6 }, () => new NumberModel());
  readonly last = [0, 0, 0, 0, 0, 0];
}

export function readScene(bytes: Uint8Array, things: number): Scene {
  return new SceneReader(bytes).scene(things);
}

class SceneReader {
  private readonly coder_: RangeDecoder;
  private readonly models_ = kShapes.map(() => new KindModels());
  private readonly kind_ = new NumberModel();
  private readonly finish_ = new NumberModel();
  private readonly count_ = new NumberModel();
  private readonly seed_ = new NumberModel();
  private readonly index_ = new NumberModel();
  private readonly more_ = new BitModel();
  private readonly moves_ = new BitModel();
  private readonly last_ = [0, 0, 0];
  private own_ = this.models_[0]!;

  constructor(bytes: Uint8Array) {
    this.coder_ = new RangeDecoder(bytes);
  }

  scene(things: number): Scene {
    const still = new MeshMaker();
    const moving: SceneMesh[] = [];
    while (this.coder_.bit(this.more_)) {
      this.coder_.check();
      if (!this.coder_.bit(this.moves_)) {
        this.object(still);
        continue;
      }
      const maker = new MeshMaker();
      this.object(maker);
      moving.push(maker.take());
    }
    if (moving.length !== things) throw new DamagedFile(`found ${moving.length} moving things, expected ${things}`);
    return { still: still.take(), moving };
  }

  private object(maker: MeshMaker): void {
    for (;;) {
      const kind = this.coder_.count(this.kind_, kShapes.length - 1, 'kind of a shape');
      if (kind === 0) return;
      this.own_ = this.models_[kind]!;
      this.shape(kShapes[kind]!, this.coder_.count(this.finish_, kFinishes - 1, 'finish'), maker);
      if (maker.corners > kMostCorners) throw new DamagedFile('found too many shapes');
    }
  }

  private shape(shape: Shape, finish: number, maker: MeshMaker): void {
    switch (shape) {
      case 'floor': {
        const z = this.length(0);
        return maker.floor(finish, this.outline(), z);
      }
      case 'walls': {
        const reach = [this.length(0), this.length(1)] as const;
        const inside = this.size(2) === 1;
        return maker.walls(finish, this.outline(), reach, inside);
      }
      case 'quad':
        return maker.quad(finish, this.point(), this.point(), this.point(), this.point());
      case 'frustum': {
        const base = this.point();
        const [height, low, high] = [this.length(0), this.length(1), this.length(2)];
        return maker.frustum(finish, base, { height, low, high, sides: this.parts(3) });
      }
      case 'beam': {
        const [a, b] = [this.point(), this.point()];
        return maker.beam(finish, a, b, this.length(0));
      }
      case 'blob': {
        const centre = this.point();
        const [radius, height] = [this.length(0), this.length(1)];
        const [rows, sides] = [this.parts(2), this.parts(3)];
        return maker.blob(finish, centre, { radius, height, rows, sides, seed: this.coder_.natural(this.seed_) });
      }
      case 'level':
        return this.level(finish, maker);
      case 'end':
        return;
    }
  }

  private level(finish: number, maker: MeshMaker): void {
    const points = this.outline();
    const triangles = this.coder_.count(this.count_, kMostPoints, 'corners of a shape');
    let last = 0;
    const next = (): Point => {
      last += this.coder_.whole(this.index_);
      const point = points[last];
      if (!point) throw new DamagedFile(`found corner ${last} of ${points.length}`);
      return [point[0], point[1], 0];
    };
    for (let t = 0; t < triangles; ++t) maker.triangle(finish, next(), next(), next());
  }

  private flat(): Point {
    for (let k = 0; k < 2; ++k) this.last_[k]! += this.coder_.whole(this.own_.flat);
    return [kUnit * this.last_[0]!, kUnit * this.last_[1]!, 0];
  }

  private point(): Point {
    const [x, y] = this.flat();
    this.last_[2]! += this.coder_.whole(this.own_.upright);
    return [x, y, kUnit * this.last_[2]!];
  }

  private outline(): Point[] {
    const count = this.coder_.count(this.count_, kMostPoints, 'corners of a shape');
    const points: Point[] = [];
    for (let k = 0; k < count; ++k) points.push(this.flat());
    this.coder_.check();
    return points;
  }

  private size(slot: number): number {
    return (this.own_.last[slot]! += this.coder_.whole(this.own_.sizes[slot]!));
  }

  private length(slot: number): number {
    return kUnit * this.size(slot);
  }

  private parts(slot: number): number {
    const parts = this.size(slot);
    if (parts < 1 || parts > kMostParts) throw new DamagedFile(`found ${parts} sides, expected 1 to ${kMostParts}`);
    return parts;
  }
}
