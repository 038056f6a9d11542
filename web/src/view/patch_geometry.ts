// What patches look like, by motion: a net to crawl under, a pool, a brick wall, a bar to jump, shade to duck in.

import type { Point2, ScenePatch } from '../protocol/scene';
import { counterClockwise, type GeometryBuilder, type Vec3 } from './geometry_builder';
import { boxOf, type EdgeLine } from './obstacle_geometry';
import type { Palette } from './palette';

export type PatchLook = 'net' | 'pool' | 'wall' | 'bar' | 'shade' | 'plain';

/** Everything one patch, or all still ones together, puts into the scene. */
export interface PatchParts {
  readonly floor: GeometryBuilder;
  readonly solid: GeometryBuilder;
  /** Dashed. */
  readonly rim: TintedLine[];
  readonly lines: TintedLine[];
}

export interface TintedLine {
  readonly line: EdgeLine;
  readonly colour: string;
  readonly alpha: number;
}

/** The look that goes with a clip's name. */
export function lookOfMotion(clip: string): PatchLook {
  const looks: Readonly<Record<string, PatchLook>> = {
    crawl: 'net', swim: 'pool', climb: 'wall', jump: 'bar', duck: 'shade',
  };
  return looks[clip] ?? 'plain';
}

/** Height of the object above a patch [m], for its tag. */
export function heightOfLook(look: PatchLook): number {
  return { net: 1.1, pool: 0.1, wall: 1.6, bar: 0.6, shade: 0.1, plain: 0 }[look];
}

const kFloorHeight = 0.006;
const kLineHeight = 0.012;

/** Adds a patch, lying where its polygon says. */
export function addPatch(parts: PatchParts, patch: ScenePatch, clip: string, palette: Palette): void {
  const outline = counterClockwise(patch.polygon);
  if (outline.length < 3) return;
  const look = lookOfMotion(clip);
  switch (look) {
    case 'net': return addNet(parts, outline, palette);
    case 'pool': return addPool(parts, outline, palette);
    case 'wall': return addWall(parts, outline, palette);
    case 'bar': return /mouse/i.test(patch.name) ? addMouse(parts, outline, palette) : addBar(parts, outline, palette);
    case 'shade': return addPlain(parts, outline, palette.shadowKeeps < 0.65 ? '#1A2A1D' : '#B9C3A6', palette.crown);
    case 'plain': return addPlain(parts, outline, palette.plainFloor, palette.obstacleEdge);
  }
}

function edges(outline: readonly Point2[], z: number): EdgeLine[] {
  return outline.map((a, i) => {
    const b = outline[(i + 1) % outline.length] as Point2;
    return [[a[0], a[1], z], [b[0], b[1], z]] as const;
  });
}

function addRim(parts: PatchParts, outline: readonly Point2[], colour: string): void {
  for (const line of edges(outline, kLineHeight)) parts.rim.push({ line, colour, alpha: 0.95 });
}

function addPlain(parts: PatchParts, outline: readonly Point2[], floor: string, rim: string): void {
  parts.floor.floor(outline, kFloorHeight, floor);
  addRim(parts, outline, rim);
}

/** Points along the rim, no more than `spacing` apart, corners included. */
export function postsAlong(outline: readonly Point2[], spacing: number): Point2[] {
  const posts: Point2[] = [];
  outline.forEach((a, i) => {
    const b = outline[(i + 1) % outline.length] as Point2;
    const count = Math.max(1, Math.ceil(Math.hypot(b[0] - a[0], b[1] - a[1]) / spacing - 1e-9));
    for (let k = 0; k < count; ++k) posts.push([a[0] + ((b[0] - a[0]) * k) / count, a[1] + ((b[1] - a[1]) * k) / count]);
  });
  return posts;
}

/** Chords of parallel lines across a polygon: direction [rad], spacing [m]. */
export function hatchChords(outline: readonly Point2[], angle: number, spacing: number): [Point2, Point2][] {
  const c = Math.cos(angle);
  const s = Math.sin(angle);
  const across = outline.map((p) => -s * p[0] + c * p[1]);
  const chords: [Point2, Point2][] = [];
  const first = Math.ceil(Math.min(...across) / spacing) * spacing;
  for (let v = first + 1e-7; v < Math.max(...across); v += spacing) {
    const meets: number[] = [];
    outline.forEach((a, i) => {
      const b = outline[(i + 1) % outline.length] as Point2;
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
      chords.push([[c * from - s * v, s * from + c * v], [c * to - s * v, s * to + c * v]]);
    }
  }
  return chords;
}

function addNet(parts: PatchParts, outline: readonly Point2[], palette: Palette): void {
  parts.floor.floor(outline, kFloorHeight, palette.netFloor);
  addRim(parts, outline, palette.net);
  const high = 1.05;
  for (const [x, y] of postsAlong(outline, 2.2)) {
    parts.solid.frustum(x, y, 0, high + 0.06, 0.055, 0.05, 6, palette.net, palette.net);
  }
  for (const line of edges(outline, high)) parts.lines.push({ line, colour: palette.net, alpha: 1 });
  const turn = boxOf(outline).angle;
  for (const angle of [turn + 0.7, turn - 0.7]) {
    for (const [a, b] of hatchChords(outline, angle, 0.34)) {
      parts.lines.push({ line: [[a[0], a[1], high], [b[0], b[1], high]], colour: palette.net, alpha: 0.5 });
    }
  }
}

function addPool(parts: PatchParts, outline: readonly Point2[], palette: Palette): void {
  parts.floor.floor(outline, kFloorHeight, palette.water);
  outline.forEach((a, i) => {
    const b = outline[(i + 1) % outline.length] as Point2;
    parts.solid.beam([a[0], a[1], 0], [b[0], b[1], 0], 0.34, 0.07, palette.coping);
  });
  for (const line of edges(outline, 0.075)) parts.lines.push({ line, colour: palette.waterLine, alpha: 0.9 });
  const box = boxOf(outline);
  hatchChords(outline, box.angle, 0.85).forEach((chord, row) => addWaves(parts, chord, row, palette));
}

/** Short wavy strokes along a chord. */
function addWaves(parts: PatchParts, chord: readonly [Point2, Point2], row: number, palette: Palette): void {
  const [a, b] = chord;
  const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
  const ux = (b[0] - a[0]) / Math.max(length, 1e-6);
  const uy = (b[1] - a[1]) / Math.max(length, 1e-6);
  const span = 1.15;
  for (let start = 0.5 + ((row * 1.37) % 1.6); start + span < length - 0.4; start += 2.5) {
    let before: Vec3 | null = null;
    for (let k = 0; k <= 8; ++k) {
      const t = start + (span * k) / 8;
      const wave = 0.07 * Math.sin((2 * Math.PI * k) / 8);
      const at: Vec3 = [a[0] + ux * t - uy * wave, a[1] + uy * t + ux * wave, kLineHeight];
      if (before) parts.lines.push({ line: [before, at], colour: palette.waterLine, alpha: 0.75 });
      before = at;
    }
  }
}

function addWall(parts: PatchParts, outline: readonly Point2[], palette: Palette): void {
  parts.floor.floor(outline, kFloorHeight, palette.plainFloor);
  addRim(parts, outline, palette.brickLine);
  const box = boxOf(outline);
  const thick = Math.min(0.32, 0.5 * box.width);
  const high = 1.5;
  const c = Math.cos(box.angle);
  const s = Math.sin(box.angle);
  const at = (u: number, v: number): Point2 => [box.x + c * u - s * v, box.y + s * u + c * v];
  const reach = Math.max(0.2, box.length - 0.08);
  const corners = [at(-reach, -thick), at(reach, -thick), at(reach, thick), at(-reach, thick)];
  parts.solid.prism(corners, 0, high, palette.brick, palette.brick);
  const stroke = (a: Point2, za: number, b: Point2, zb: number, alpha: number): void => {
    parts.lines.push({ line: [[a[0], a[1], za], [b[0], b[1], zb]], colour: palette.brickLine, alpha });
  };
  const course = 0.25;
  for (const side of [-1, 1]) {
    const v = side * (thick + 0.012);
    for (let row = 1; row <= high / course; ++row) {
      stroke(at(-reach, v), row * course, at(reach, v), row * course, row * course >= high - 1e-6 ? 0.9 : 0.6);
      const shift = row % 2 === 0 ? 0 : 0.25;
      for (let u = -reach + shift; u < reach; u += 0.5) stroke(at(u, v), (row - 1) * course, at(u, v), row * course, 0.6);
    }
    stroke(at(side * reach, -thick), high, at(side * reach, thick), high, 0.9);
  }
}

function addBar(parts: PatchParts, outline: readonly Point2[], palette: Palette): void {
  addPlain(parts, outline, palette.plainFloor, palette.brickLine);
  const box = boxOf(outline);
  const c = Math.cos(box.angle);
  const s = Math.sin(box.angle);
  const end = (sign: number, z: number): Vec3 => [box.x + sign * c * box.length, box.y + sign * s * box.length, z];
  parts.solid.beam(end(-0.96, 0.42), end(0.96, 0.42), 0.12, 0.12, palette.brick);
  for (const sign of [-0.94, 0, 0.94]) {
    const [x, y] = end(sign, 0);
    parts.solid.frustum(x, y, 0, 0.44, 0.07, 0.06, 6, palette.trunk, palette.trunk);
  }
}

/** A small grey beast to jump over. */
function addMouse(parts: PatchParts, outline: readonly Point2[], palette: Palette): void {
  addRim(parts, outline, palette.brickLine);
  const box = boxOf(outline);
  const size = 0.75 * Math.min(box.length, box.width);
  const lump = (x: number, z: number, radius: number): void => {
    parts.solid.frustum(x, box.y, z, z + 0.6 * radius, 0.75 * radius, radius, 10, palette.grey, palette.grey);
    parts.solid.frustum(x, box.y, z + 0.6 * radius, z + 1.3 * radius, radius, 0.35 * radius, 10, palette.grey, palette.grey);
  };
  lump(box.x - 0.25 * size, 0, 0.75 * size);
  lump(box.x + 0.62 * size, 0.06, 0.42 * size);
  for (const side of [-1, 1]) {
    parts.solid.frustum(box.x + 0.5 * size, box.y + side * 0.26 * size, 0.36 * size, 0.7 * size, 0.16 * size, 0.14 * size, 8,
      palette.grey, palette.grey);
  }
  parts.solid.beam([box.x - 0.95 * size, box.y, 0.05], [box.x - 1.7 * size, box.y + 0.2 * size, 0.05], 0.06, 0.05, palette.grey);
}
