// Shapes of obstacles: buildings cut at 3.2 m, pillars, fountains, trees and cars. The name of an obstacle decides.

import { isCarSized } from '../../model/place/frame';
import type { BufferGeometry } from 'three';
import type { Vec2 } from '../../protocol/generated/commands';
import type { SceneObstacle } from '../../protocol/messages';
import { isGatePath, isMoving } from '../../protocol/scene';
import { circlePoints, counterClockwise, GeometryBuilder, type Vec3 } from '../drawing/geometry_builder';
import type { Palette } from '../drawing/palette';

/** Nothing is drawn higher than this, so that streets stay visible [m]. */
export const kCutHeight = 3.2;

/** The length below which a moving obstacle is an animal [m]. */
const kSmall = 1.2;
/** Bars of gates [m]. */
const kBar = { thick: 0.09, apart: 0.3 };

export type ObstacleLook = 'building' | 'gate' | 'hedge' | 'pillar' | 'fountain' | 'tree' | 'car' | 'mouse';

/** How an obstacle is shown. */
export function lookOfObstacle(obstacle: SceneObstacle): ObstacleLook {
  if (isGatePath(obstacle.path)) return 'gate';
  const name = obstacle.name.toLowerCase();
  const disc = obstacle.radius > 0;
  if (!disc && /\b(car|coupe|van|bus|taxi|truck|lorry)\b/.test(name)) return 'car';
  if (!disc && /\b(mouse|mice|rat)\b/.test(name)) return 'mouse';
  if (disc && /tree|oak|pine|birch|linden|elm|maple|beech/.test(name)) return 'tree';
  if (!disc && name.includes('hedge')) return 'hedge';
  if (disc && name.includes('fountain')) return 'fountain';
  if (disc) return 'pillar';
  return isMoving(obstacle) ? lookBySize(outlineOf(obstacle)) : 'building';
}

/** A moving obstacle whose name says nothing is a car where it has the size of one, and a mouse where it is tiny. */
function lookBySize(outline: readonly Vec2[]): ObstacleLook {
  const { length, width } = boxOf(outline);
  if (2 * Math.max(length, width) < kSmall) return 'mouse';
  return isCarSized(2 * length, 2 * width) ? 'car' : 'building';
}

/** An edge line of an obstacle [m]. */
export type EdgeLine = readonly [Vec3, Vec3];

/** Adds an obstacle's body; returns the lines of its upper edge. */
export function addObstacle(builder: GeometryBuilder, obstacle: SceneObstacle, palette: Palette): EdgeLine[] {
  const look = lookOfObstacle(obstacle);
  const height = Math.min(kCutHeight, Math.max(0.1, obstacle.height));
  if (look === 'fountain') return addFountain(builder, obstacle, palette);
  const outline = outlineOf(obstacle);
  if (outline.length < 3) return [];
  if (look === 'mouse') return addMouse(builder, outline, height, palette);
  if (look === 'gate') return addGate(builder, outline, height, palette);
  const walls = { pillar: palette.stone, hedge: palette.crown }[look as string] ?? palette.wall;
  const lids = { pillar: palette.stone, hedge: palette.crown }[look as string] ?? palette.roof;
  builder.prism(outline, 0, height, walls, lids);
  return rimOf(outline, height);
}

/** Corners, counter-clockwise; a disc becomes a polygon of 28 sides. */
export function outlineOf(obstacle: SceneObstacle): readonly Vec2[] {
  if (obstacle.polygon.length >= 3) return counterClockwise(obstacle.polygon);
  return circlePoints(...obstacle.centre, obstacle.radius, 28);
}

/** Bars between two rails. */
function addGate(builder: GeometryBuilder, outline: readonly Vec2[], height: number, palette: Palette): EdgeLine[] {
  const box = boxOf(outline);
  const [c, s] = [Math.cos(box.angle), Math.sin(box.angle)];
  const at = (u: number, z: number): Vec3 => [box.x + c * u, box.y + s * u, z];
  const reach = box.length - kBar.thick / 2;
  const bars = Math.max(2, Math.round((2 * reach) / kBar.apart));
  for (const z of [0.12, height - 2 * kBar.thick])
    builder.beam(at(-reach, z), at(reach, z), kBar.thick, kBar.thick, palette.trunk);
  for (let k = 0; k <= bars; ++k) {
    const [x, y] = at(-reach + (2 * reach * k) / bars, 0);
    builder.frustum(x, y, 0, height, kBar.thick / 2, kBar.thick / 2, 6, palette.trunk, palette.trunk);
  }
  return [];
}

function rimOf(outline: readonly Vec2[], height: number): EdgeLine[] {
  return outline.map((a, i) => {
    const b = outline[(i + 1) % outline.length] as Vec2;
    return [
      [a[0], a[1], height],
      [b[0], b[1], height],
    ] as const;
  });
}

function addFountain(builder: GeometryBuilder, obstacle: SceneObstacle, palette: Palette): EdgeLine[] {
  const [x, y] = obstacle.centre;
  const { radius } = obstacle;
  const outer = circlePoints(x, y, radius, 36);
  const inner = circlePoints(x, y, 0.8 * radius, 36);
  builder.walls(outer, 0, 0.55, palette.stone);
  for (let i = 0; i < outer.length; ++i) {
    const j = (i + 1) % outer.length;
    const [a, b, c, d] = [outer[i], outer[j], inner[j], inner[i]] as [Vec2, Vec2, Vec2, Vec2];
    builder.quad([a[0], a[1], 0.55], [b[0], b[1], 0.55], [c[0], c[1], 0.55], [d[0], d[1], 0.55], palette.stone);
    builder.quad([c[0], c[1], 0.4], [d[0], d[1], 0.4], [d[0], d[1], 0.55], [c[0], c[1], 0.55], palette.stone);
  }
  builder.floor(inner, 0.42, palette.water);
  builder.frustum(x, y, 0.4, 1.25, 0.24 * radius, 0.17 * radius, 16, palette.stone, palette.stone);
  return [...rimOf(outer, 0.55), ...rimOf(inner, 0.55)];
}

/** The trunk of a tree, for a disc of radius 0.3 m. */
export function makeTrunkGeometry(palette: Palette): BufferGeometry {
  const builder = new GeometryBuilder();
  builder.frustum(0, 0, 0, 2.3, 0.2, 0.11, 7, palette.trunk, palette.trunk);
  for (const [x, y, z] of [
    [0.5, 0.35, 2.5],
    [-0.55, -0.2, 2.55],
    [0.1, -0.5, 2.7],
  ] as const) {
    builder.limb([0, 0, 1.7], [x, y, z], 0.05, palette.trunk);
  }
  return builder.build();
}

/** Its crown of facets. */
export function makeCrownGeometry(palette: Palette): BufferGeometry {
  const builder = new GeometryBuilder();
  addBlob(builder, [0, 0, 2.95], { radius: 1.25, height: 1.05, colour: palette.crown, seed: 3 });
  addBlob(builder, [0.55, 0.4, 2.55], { radius: 0.75, height: 0.6, colour: palette.crown, seed: 11 });
  addBlob(builder, [-0.6, -0.25, 2.6], { radius: 0.7, height: 0.6, colour: palette.crown, seed: 29 });
  return builder.build();
}

/** A lumpy ball of flat facets. */
export interface Blob {
  readonly radius: number;
  /** Half of it, up and down [m]. */
  readonly height: number;
  readonly colour: string;
  /** Makes the lumps. */
  readonly seed: number;
  readonly rows?: number;
  readonly sides?: number;
  /** 1 as a rule, 0 for an even ball. */
  readonly lumps?: number;
}

export function addBlob(
  builder: GeometryBuilder,
  centre: Vec3,
  { radius, height, colour, seed, rows = 5, sides = 9, lumps = 1 }: Blob,
): void {
  const point = (row: number, side: number): Vec3 => {
    const tilt = (Math.PI * row) / rows - Math.PI / 2;
    const s = row === 0 || row === rows ? 0 : side % sides;
    const lump = 1 + lumps * (0.2 * Math.abs(Math.sin(seed * 12.9898 + row * 78.233 + s * 37.719)) - 0.12);
    const turn = (2 * Math.PI * (s + 0.5 * (row % 2))) / sides;
    const flat = Math.cos(tilt) * radius * lump;
    return [
      centre[0] + flat * Math.cos(turn),
      centre[1] + flat * Math.sin(turn),
      centre[2] + Math.sin(tilt) * height * lump,
    ];
  };
  for (let row = 0; row < rows; ++row) {
    for (let side = 0; side < sides; ++side) {
      const [a, b, c, d] = [point(row, side), point(row, side + 1), point(row + 1, side + 1), point(row + 1, side)];
      builder.triangle(a, b, c, colour);
      builder.triangle(a, c, d, colour);
    }
  }
}

/** A small animal: a body, and a head at its front end. */
function addMouse(builder: GeometryBuilder, outline: readonly Vec2[], height: number, palette: Palette): EdgeLine[] {
  const { x, y, length, width, angle } = boxOf(outline);
  const high = Math.min(height, 1.2 * Math.max(length, width)) / 2;
  const at = (share: number): Vec3 => [
    x + share * length * Math.cos(angle),
    y + share * length * Math.sin(angle),
    high,
  ];
  addBlob(builder, at(-0.3), { radius: 0.95 * Math.min(length, width), height: high, colour: palette.stone, seed: 5 });
  addBlob(builder, at(0.45), {
    radius: 0.55 * Math.min(length, width),
    height: 0.7 * high,
    colour: palette.stone,
    seed: 17,
  });
  return [];
}

/** Box round an outline whose longest side gives the direction: centre, half length, half width, angle [rad]. */
export function boxOf(outline: readonly Vec2[]): {
  x: number;
  y: number;
  length: number;
  width: number;
  angle: number;
} {
  let longest = 0;
  let angle = 0;
  for (let i = 0; i < outline.length; ++i) {
    const a = outline[i] as Vec2;
    const b = outline[(i + 1) % outline.length] as Vec2;
    const size = Math.hypot(b[0] - a[0], b[1] - a[1]);
    if (size > longest + 1e-9) {
      longest = size;
      angle = Math.atan2(b[1] - a[1], b[0] - a[0]);
    }
  }
  const c = Math.cos(angle);
  const s = Math.sin(angle);
  const along = outline.map((p) => c * p[0] + s * p[1]);
  const across = outline.map((p) => -s * p[0] + c * p[1]);
  const middle = (values: number[]): number => (Math.min(...values) + Math.max(...values)) / 2;
  const half = (values: number[]): number => (Math.max(...values) - Math.min(...values)) / 2;
  const u = middle(along);
  const v = middle(across);
  return { x: c * u - s * v, y: s * u + c * v, length: half(along), width: half(across), angle };
}

/** Adds a car that fills the outline, or a van where it is high [m]: body, cabin, wheels. */
export function addCar(
  builder: GeometryBuilder,
  outline: readonly Vec2[],
  height: number,
  body: string,
  palette: Palette,
): void {
  const box = boxOf(outline);
  const c = Math.cos(box.angle);
  const s = Math.sin(box.angle);
  const at = (u: number, v: number): Vec2 => [
    box.x + c * u * box.length - s * v * box.width,
    box.y + s * u * box.length + c * v * box.width,
  ];
  const slab = (u0: number, u1: number, v: number, low: number, high: number, colour: string): void =>
    builder.prism([at(u0, -v), at(u1, -v), at(u1, v), at(u0, v)], low, high, colour, colour);
  for (const u of [-0.62, 0.62])
    for (const side of [-1, 1]) addWheel(builder, at(u, 0.72 * side), at(u, side), Math.min(0.34, 0.15 * box.length));
  const high = Math.min(kCutHeight, Math.max(1.3, height));
  const van = high > 1.9;
  const sill = van ? 0.5 * high : 0.56 * high;
  slab(-1, 1, 0.94, 0.22, sill, body);
  const [back, front] = van ? [-1, 0.94] : [-0.72, 0.45];
  const [backTop, frontTop] = van ? [-0.99, 0.8] : [-0.55, 0.2];
  const low = [at(back, -0.9), at(front, -0.9), at(front, 0.9), at(back, 0.9)] as const;
  const top = [at(backTop, -0.78), at(frontTop, -0.78), at(frontTop, 0.78), at(backTop, 0.78)] as const;
  const pane = van ? sill + 0.55 * (high - sill) : high;
  const between = low.map((p, i) => {
    const q = top[i] as Vec2;
    const t = (pane - sill) / (high - sill);
    return [p[0] + (q[0] - p[0]) * t, p[1] + (q[1] - p[1]) * t] as const;
  });
  addSkirt(builder, low, between, sill, pane, palette.glass);
  addSkirt(builder, between, top, pane, high, body);
  builder.floor(top, high, body);
}

/** A wheel between two points of its axle, standing on the ground. */
function addWheel(builder: GeometryBuilder, inner: Vec2, outer: Vec2, radius: number): void {
  const length = Math.hypot(outer[0] - inner[0], outer[1] - inner[1]) || 1;
  const [ax, ay] = [(outer[0] - inner[0]) / length, (outer[1] - inner[1]) / length];
  const sides = 14;
  const rim = (p: Vec2, k: number, share: number): Vec3 => {
    const turn = (2 * Math.PI * k) / sides;
    return [
      p[0] - ay * Math.cos(turn) * radius * share,
      p[1] + ax * Math.cos(turn) * radius * share,
      radius + Math.sin(turn) * radius * share,
    ];
  };
  const hub: Vec3 = [outer[0], outer[1], radius];
  for (let k = 0; k < sides; ++k) {
    builder.quad(rim(outer, k, 1), rim(outer, k + 1, 1), rim(inner, k + 1, 1), rim(inner, k, 1), '#1B1E22');
    builder.quad(rim(outer, k, 0.6), rim(outer, k + 1, 0.6), rim(outer, k + 1, 1), rim(outer, k, 1), '#1B1E22');
    builder.triangle(hub, rim(outer, k + 1, 0.6), rim(outer, k, 0.6), '#9AA0A6');
  }
}

/** Sloping walls between two outlines with the same number of corners. */
function addSkirt(
  builder: GeometryBuilder,
  low: readonly Vec2[],
  top: readonly Vec2[],
  from: number,
  to: number,
  colour: string,
): void {
  if (to - from < 1e-6) return;
  low.forEach((a, i) => {
    const j = (i + 1) % low.length;
    const [b, e, d] = [low[j], top[j], top[i]] as [Vec2, Vec2, Vec2];
    builder.quad([a[0], a[1], from], [b[0], b[1], from], [e[0], e[1], to], [d[0], d[1], to], colour);
  });
}
