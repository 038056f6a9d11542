// Collects triangles with normals and colours into one geometry. World axes: x east, y north, z up [m].

import { BufferAttribute, BufferGeometry, Color, ShapeUtils, Vector2 } from 'three';
import type { Vec2 } from '../../protocol/generated/commands';

export type Vec3 = readonly [number, number, number];

const colourCache = new Map<string, Color>();

function colourOf(hex: string): Color {
  let colour = colourCache.get(hex);
  if (!colour) {
    colour = new Color(hex);
    colourCache.set(hex, colour);
  }
  return colour;
}

/** Twice the signed area; positive where counter-clockwise. */
export function signedArea2(points: readonly Vec2[]): number {
  let sum = 0;
  for (let i = 0; i < points.length; ++i) {
    const a = points[i] as Vec2;
    const b = points[(i + 1) % points.length] as Vec2;
    sum += a[0] * b[1] - a[1] * b[0];
  }
  return sum;
}

/** The same outline, counter-clockwise. */
export function counterClockwise(points: readonly Vec2[]): readonly Vec2[] {
  return signedArea2(points) >= 0 ? points : [...points].reverse();
}

/** Corners of a regular polygon round a centre. */
export function circlePoints(x: number, y: number, radius: number, sides: number): Vec2[] {
  return Array.from({ length: sides }, (_, i) => {
    const angle = (2 * Math.PI * i) / sides;
    return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)] as const;
  });
}

/** Centre of area; of the corners where that is nil. */
export function centroid(points: readonly Vec2[]): Vec2 {
  let area = 0;
  let x = 0;
  let y = 0;
  for (let i = 0; i < points.length; ++i) {
    const a = points[i] as Vec2;
    const b = points[(i + 1) % points.length] as Vec2;
    const cross = a[0] * b[1] - a[1] * b[0];
    area += cross;
    x += (a[0] + b[0]) * cross;
    y += (a[1] + b[1]) * cross;
  }
  if (Math.abs(area) > 1e-12) return [x / (3 * area), y / (3 * area)];
  const n = Math.max(1, points.length);
  return [points.reduce((s, p) => s + p[0], 0) / n, points.reduce((s, p) => s + p[1], 0) / n];
}

export class GeometryBuilder {
  private readonly positions_: number[] = [];
  private readonly normals_: number[] = [];
  private readonly colours_: number[] = [];

  get triangleCount(): number {
    return this.positions_.length / 9;
  }

  triangle(a: Vec3, b: Vec3, c: Vec3, colour: string): void {
    const ux = b[0] - a[0],
      uy = b[1] - a[1],
      uz = b[2] - a[2];
    const vx = c[0] - a[0],
      vy = c[1] - a[1],
      vz = c[2] - a[2];
    let nx = uy * vz - uz * vy;
    let ny = uz * vx - ux * vz;
    let nz = ux * vy - uy * vx;
    const length = Math.hypot(nx, ny, nz);
    if (length < 1e-14) return;
    nx /= length;
    ny /= length;
    nz /= length;
    const rgb = colourOf(colour);
    for (const corner of [a, b, c]) {
      this.positions_.push(corner[0], corner[1], corner[2]);
      this.normals_.push(nx, ny, nz);
      this.colours_.push(rgb.r, rgb.g, rgb.b);
    }
  }

  quad(a: Vec3, b: Vec3, c: Vec3, d: Vec3, colour: string): void {
    this.triangle(a, b, c, colour);
    this.triangle(a, c, d, colour);
  }

  /** A flat polygon at one height, facing up. */
  floor(outline: readonly Vec2[], z: number, colour: string): void {
    const points = counterClockwise(outline);
    const faces = ShapeUtils.triangulateShape(
      points.map((p) => new Vector2(p[0], p[1])),
      [],
    );
    for (const face of faces) {
      const [a, b, c] = face.map((i) => points[i] as Vec2);
      if (a && b && c) this.triangle([a[0], a[1], z], [b[0], b[1], z], [c[0], c[1], z], colour);
    }
  }

  /** Upright walls round a polygon, facing outwards, or inwards. */
  walls(outline: readonly Vec2[], low: number, high: number, colour: string, inwards = false): void {
    const points = counterClockwise(outline);
    for (let i = 0; i < points.length; ++i) {
      const from = points[i] as Vec2;
      const to = points[(i + 1) % points.length] as Vec2;
      const [a, b] = inwards ? [to, from] : [from, to];
      this.quad([a[0], a[1], low], [b[0], b[1], low], [b[0], b[1], high], [a[0], a[1], high], colour);
    }
  }

  /** Walls and a lid. */
  prism(outline: readonly Vec2[], low: number, high: number, wall: string, lid: string): void {
    this.walls(outline, low, high, wall);
    this.floor(outline, high, lid);
  }

  /** A cone cut off, standing. */
  frustum(
    x: number,
    y: number,
    low: number,
    high: number,
    lowRadius: number,
    highRadius: number,
    sides: number,
    wall: string,
    lid: string,
  ): void {
    const bottom = circlePoints(x, y, lowRadius, sides);
    const top = circlePoints(x, y, highRadius, sides);
    for (let i = 0; i < sides; ++i) {
      const j = (i + 1) % sides;
      const [a, b, c, d] = [bottom[i], bottom[j], top[j], top[i]] as [Vec2, Vec2, Vec2, Vec2];
      this.quad([a[0], a[1], low], [b[0], b[1], low], [c[0], c[1], high], [d[0], d[1], high], wall);
    }
    if (highRadius > 1e-6) this.floor(top, high, lid);
  }

  /** A box along a line on the ground: a beam, a post, a wall. */
  beam(from: Vec3, to: Vec3, width: number, height: number, colour: string): void {
    const dx = to[0] - from[0];
    const dy = to[1] - from[1];
    const length = Math.hypot(dx, dy);
    const sx = length > 1e-9 ? (-dy / length) * (width / 2) : width / 2;
    const sy = length > 1e-9 ? (dx / length) * (width / 2) : 0;
    const a: Vec3 = [from[0] - sx, from[1] - sy, from[2]];
    const b: Vec3 = [to[0] - sx, to[1] - sy, to[2]];
    const c: Vec3 = [to[0] + sx, to[1] + sy, to[2]];
    const d: Vec3 = [from[0] + sx, from[1] + sy, from[2]];
    const up = (p: Vec3): Vec3 => [p[0], p[1], p[2] + height];
    this.quad(up(a), up(b), up(c), up(d), colour);
    this.quad(a, b, up(b), up(a), colour);
    this.quad(c, d, up(d), up(c), colour);
    this.quad(b, c, up(c), up(b), colour);
    this.quad(d, a, up(a), up(d), colour);
  }

  /** A thin rod of three sides between any two points. */
  limb(from: Vec3, to: Vec3, radius: number, colour: string): void {
    const corner = (p: Vec3, k: number): Vec3 => {
      const turn = (2 * Math.PI * k) / 3;
      return [p[0] + radius * Math.cos(turn), p[1] + radius * Math.sin(turn), p[2]];
    };
    const [low, high] = from[2] <= to[2] ? [from, to] : [to, from];
    for (let k = 0; k < 3; ++k)
      this.quad(corner(low, k), corner(low, k + 1), corner(high, k + 1), corner(high, k), colour);
  }

  build(): BufferGeometry {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(Float32Array.from(this.positions_), 3));
    geometry.setAttribute('normal', new BufferAttribute(Float32Array.from(this.normals_), 3));
    geometry.setAttribute('color', new BufferAttribute(Float32Array.from(this.colours_), 3));
    return geometry;
  }
}
