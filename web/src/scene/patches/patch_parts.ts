// The parts of one moving patch, or of all still patches together.

import type { Vec2 } from '../../protocol/generated/commands';
import { GeometryBuilder } from '../drawing/geometry_builder';
import type { EdgeLine } from '../obstacles/obstacle_geometry';

export interface TintedLine {
  readonly line: EdgeLine;
  readonly colour: string;
  readonly alpha: number;
}

export interface PatchParts {
  readonly floor: GeometryBuilder;
  readonly solid: GeometryBuilder;
  /** Where the ground opens. */
  readonly opening: GeometryBuilder;
  /** What one sees through. */
  readonly water: GeometryBuilder;
  readonly leaves: GeometryBuilder;
  /** Dashed. */
  readonly rim: TintedLine[];
  readonly lines: TintedLine[];
}

export function emptyParts(): PatchParts {
  const made = (): GeometryBuilder => new GeometryBuilder();
  return { floor: made(), solid: made(), opening: made(), water: made(), leaves: made(), rim: [], lines: [] };
}

export const kFloorHeight = 0.006;
export const kLineHeight = 0.012;

/** The sides of an outline at a height. */
export function edges(outline: readonly Vec2[], z: number): EdgeLine[] {
  return outline.map((a, i) => {
    const b = outline[(i + 1) % outline.length] as Vec2;
    return [
      [a[0], a[1], z],
      [b[0], b[1], z],
    ] as const;
  });
}

export function addRim(parts: PatchParts, outline: readonly Vec2[], colour: string): void {
  for (const line of edges(outline, kLineHeight)) parts.rim.push({ line, colour, alpha: 0.95 });
}

export function addPlain(parts: PatchParts, outline: readonly Vec2[], floor: string, rim: string): void {
  parts.floor.floor(outline, kFloorHeight, floor);
  addRim(parts, outline, rim);
}

/** Points along the rim, no more than `spacing` apart, corners included. */
export function postsAlong(outline: readonly Vec2[], spacing: number): Vec2[] {
  const posts: Vec2[] = [];
  outline.forEach((a, i) => {
    const b = outline[(i + 1) % outline.length] as Vec2;
    const count = Math.max(1, Math.ceil(Math.hypot(b[0] - a[0], b[1] - a[1]) / spacing - 1e-9));
    for (let k = 0; k < count; ++k)
      posts.push([a[0] + ((b[0] - a[0]) * k) / count, a[1] + ((b[1] - a[1]) * k) / count]);
  });
  return posts;
}

/** Chords of parallel lines across a polygon: direction [rad], spacing [m]. */
export function hatchChords(outline: readonly Vec2[], angle: number, spacing: number): [Vec2, Vec2][] {
  const c = Math.cos(angle);
  const s = Math.sin(angle);
  const across = outline.map((p) => -s * p[0] + c * p[1]);
  const chords: [Vec2, Vec2][] = [];
  const first = Math.ceil(Math.min(...across) / spacing) * spacing;
  for (let v = first + 1e-7; v < Math.max(...across); v += spacing) {
    const meets: number[] = [];
    outline.forEach((a, i) => {
      const b = outline[(i + 1) % outline.length] as Vec2;
      const va = -s * a[0] + c * a[1] - v;
      const vb = -s * b[0] + c * b[1] - v;
      if (va > 0 === vb > 0) return;
      const t = va / (va - vb);
      meets.push(c * (a[0] + (b[0] - a[0]) * t) + s * (a[1] + (b[1] - a[1]) * t));
    });
    meets.sort((a, b) => a - b);
    for (let i = 0; i + 1 < meets.length; i += 2) {
      const from = meets[i] ?? 0;
      const to = meets[i + 1] ?? 0;
      chords.push([
        [c * from - s * v, s * from + c * v],
        [c * to - s * v, s * to + c * v],
      ]);
    }
  }
  return chords;
}

/** A pseudo-random number in [0, 1) that depends only on the arguments. */
export function thrown(a: number, b = 0): number {
  const wave = Math.sin(a * 127.1 + b * 311.7) * 43758.5453;
  return wave - Math.floor(wave);
}

/** Mixes two colours written as #RRGGBB. */
export function blended(from: string, to: string, share: number): string {
  const part = (hex: string, at: number): number => parseInt(hex.slice(at, at + 2), 16);
  const mixed = [1, 3, 5].map((at) => Math.round(part(from, at) + (part(to, at) - part(from, at)) * share));
  return `#${mixed.map((one) => one.toString(16).padStart(2, '0')).join('')}`;
}
