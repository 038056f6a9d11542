// Frames for the demonstration page: a square and a wedge on the march, with controls of all three kinds.

import type { ControlView, FrameView, GroupMeshView, GroupView, OverlayView } from '../frame_types';

interface Lattice {
  readonly vertices: number[];
  readonly triangles: number[];
  readonly boundary: number[];
}

/** A grid of cells turned and moved. */
function lattice(side: number, size: number): Lattice {
  const vertices: number[] = [];
  const triangles: number[] = [];
  const n = side + 1;
  for (let j = 0; j < n; ++j) for (let i = 0; i < n; ++i) vertices.push((i / side - 0.5) * size, (j / side - 0.5) * size);
  for (let j = 0; j < side; ++j) {
    for (let i = 0; i < side; ++i) {
      const a = j * n + i;
      if ((i + j) % 2) triangles.push(a, a + 1, a + n + 1, a, a + n + 1, a + n);
      else triangles.push(a, a + 1, a + n, a + 1, a + n + 1, a + n);
    }
  }
  const rim: number[] = [];
  for (let i = 0; i < side; ++i) rim.push(i);
  for (let j = 0; j < side; ++j) rim.push(j * n + side);
  for (let i = side; i > 0; --i) rim.push(side * n + i);
  for (let j = side; j > 0; --j) rim.push(j * n);
  return { vertices, triangles, boundary: [rim.length, ...rim] };
}

function placed(points: readonly number[], x: number, y: number, angle: number): number[] {
  const c = Math.cos(angle);
  const s = Math.sin(angle);
  const out: number[] = [];
  for (let i = 0; i + 1 < points.length; i += 2) {
    const [u, v] = [points[i] ?? 0, points[i + 1] ?? 0];
    out.push(x + c * u - s * v, y + s * u + c * v);
  }
  return out;
}

function gridPlaces(side: number, spacing: number): number[] {
  const out: number[] = [];
  for (let j = 0; j < side; ++j) for (let i = 0; i < side; ++i) out.push((i - (side - 1) / 2) * spacing, (j - (side - 1) / 2) * spacing);
  return out;
}

function wedgePlaces(rows: number, spacing: number): number[] {
  const out: number[] = [];
  for (let row = 0; row < rows; ++row) {
    for (let i = 0; i <= row; ++i) out.push((i - row / 2) * spacing, (rows / 2 - row) * spacing);
  }
  return out;
}

export const kSquareMesh = lattice(5, 9.4);
const kWedge = { vertices: [0, 5, -5, -4.4, 5, -4.4, -2.5, 0.3, 2.5, 0.3, 0, -4.4], triangles: [0, 3, 4, 3, 1, 5, 3, 5, 4, 4, 5, 2],
  boundary: [6, 0, 3, 1, 5, 2, 4] };

export function madeUpMeshes(): GroupMeshView[] {
  return [
    { group: 1, version: 1, formation: 'square', triangles: kSquareMesh.triangles, boundary: kSquareMesh.boundary },
    { group: 2, version: 1, formation: 'wedge', triangles: kWedge.triangles, boundary: kWedge.boundary },
  ];
}

function point(touch: number, down: boolean, x: number, y: number, path: number[]): ControlView['points'][number] {
  return { touch, down, x, y, path };
}

function curve(fromX: number, fromY: number, toX: number, toY: number, bow: number): number[] {
  const path: number[] = [];
  const length = Math.hypot(toX - fromX, toY - fromY);
  const count = Math.max(2, Math.round(length / 0.5));
  for (let i = 1; i <= count; ++i) {
    const t = i / count;
    const out = bow * Math.sin(Math.PI * t);
    path.push(fromX + (toX - fromX) * t - ((toY - fromY) / length) * out, fromY + (toY - fromY) * t + ((toX - fromX) / length) * out);
  }
  return path;
}

function northControls(v: readonly number[]): ControlView[] {
  const at = (i: number): [number, number] => [v[2 * i] ?? 0, v[2 * i + 1] ?? 0];
  const [a, b] = [at(0), at(5)];
  const area = [at(35), at(33), at(23)] as const;
  const soft: number[] = [];
  for (let i = 1; i < 6; ++i) soft.push(a[0] + ((b[0] - a[0]) * i) / 6, a[1] + ((b[1] - a[1]) * i) / 6);
  return [
    { id: 1, kind: 1, client: 1, pinned: false, open: false, supplementary: soft, points: [
      point(1, false, a[0], a[1], curve(a[0], a[1], a[0] + 1.5, a[1] + 5.5, 1)),
      point(2, false, b[0], b[1], curve(b[0], b[1], b[0] + 5, b[1] + 3.4, -0.9))] },
    { id: 2, kind: 2, client: 1, pinned: false, open: false, supplementary: [], points: area.map((p, i) =>
      point(3 + i, true, p[0], p[1], curve(p[0], p[1], p[0] + 5.5 + (i === 2 ? 0.5 : 0), p[1] + 3.6, 0.5 - 0.3 * i))) },
  ];
}

/** The frame at a time [s]; `count` above 0 replaces the square's crowd by a lattice of so many. */
export function madeUpFrame(frame: number, time: number, count: number): FrameView {
  const drift = 0.9 * time;
  const [cx, cy] = [-2.2 + 0.25 * drift, 0.2 + 0.1 * drift];
  const squareVertices = placed(kSquareMesh.vertices, cx, cy, 0.06);
  const squarePlaces = placed(gridPlaces(8, 1.12), cx, cy, 0.06);
  const wedgeVertices = placed(kWedge.vertices, 5.5, -4.2, -0.2);
  const wedgePlaces_ = placed(wedgePlaces(8, 1.1), 5.5, -4.2, -0.2);
  const x: number[] = [], y: number[] = [], heading: number[] = [], group: number[] = [], motion: number[] = [], ids: number[] = [];
  const add = (px: number, py: number, facing: number, g: number): void => {
    const i = ids.length;
    ids.push(i + 1);
    group.push(g);
    x.push(px + 0.15 * Math.sin(i * 7.1) - 0.35);
    y.push(py + 0.15 * Math.cos(i * 3.3) - 0.1);
    heading.push(facing + 0.15 * Math.sin(i));
    const inNet = Math.abs(px + 0.4) < 2.5 && Math.abs(py - 4.4) < 1.6;
    const inPool = Math.abs(px - 8) < 2.8 && Math.abs(py + 0.5) < 1.8;
    motion.push(inNet ? 3 : inPool ? 4 : 0);
  };
  if (count > 0) {
    const side = Math.ceil(Math.sqrt(count));
    for (let i = 0; i < count; ++i) add(((i % side) - side / 2) * 0.7 + 0.9 * time, (Math.floor(i / side) - side / 2) * 0.7, 0.4, 0);
  } else {
    for (let i = 0; i + 1 < squarePlaces.length; i += 2) add((squarePlaces[i] ?? 0) + 0.6 * time, (squarePlaces[i + 1] ?? 0) + 0.3 * time, 0.5, 0);
  }
  for (let i = 0; i + 1 < wedgePlaces_.length; i += 2) add((wedgePlaces_[i] ?? 0), (wedgePlaces_[i + 1] ?? 0) + 0.6 * time, 1.4, 1);
  const tip: [number, number] = [wedgeVertices[0] ?? 0, wedgeVertices[1] ?? 0];
  const groups: GroupView[] = [
    { id: 1, meshVersion: 1, lag: 0.8, vertices: squareVertices, places: squarePlaces,
      fit: squarePlaces.filter((_, i) => i % 2).map((_, i) => (i === 63 ? 0 : 1)), controls: northControls(squareVertices) },
    { id: 2, meshVersion: 1, lag: 0.8, vertices: wedgeVertices, places: wedgePlaces_, fit: [], controls: [
      { id: 3, kind: 0, client: 1, pinned: false, open: false, supplementary: [], points: [
        point(9, true, tip[0], tip[1], curve(tip[0], tip[1], tip[0] + 7.5, tip[1] + 3.2, 1.8))] }] },
  ];
  const moving = [{ kind: 0, id: 60, x: -3 * time, y: 0, angle: 0 }];
  return { frame, step: frame, time, playing: true, ids, group, x, y, heading, motion, phase: [], groups, moving, collected: [0, 0] };
}

/** A cost field round a place, with a slow pool. */
export function madeUpCost(): OverlayView {
  const [width, height, cell] = [208, 192, 0.25];
  const values: number[] = [];
  for (let j = 0; j < height; ++j) {
    for (let i = 0; i < width; ++i) {
      const x = -26 + (i + 0.5) * cell;
      const y = -22 + (j + 0.5) * cell;
      const slow = Math.exp(-((x - 8) ** 2 + (y + 0.5) ** 2) / 6) * 3;
      const blocked = x > 14 && y > 9 && x < 24 && y < 18;
      values.push(blocked ? Infinity : 0.55 * Math.hypot(x - 7, y + 8) + slow);
    }
  }
  return { kind: 2, character: 70, x: -26 + cell / 2, y: -22 + cell / 2, cell, width, height, values,
    path: [1, 9.5, 6, 4, 10.6, 2.4, 12, -1.5, 10, -5, 7, -8] };
}
