// Small frames for tests.

import { kRowFloats, rowsLength } from './studio_frame';
import type { Given, Order } from '../protocol/generated/commands';
import { filled } from '../protocol/encoding';
import type { QueueOrder } from './queue_order';
import type { GroupMesh } from '../protocol/messages';
import type { ControlView, FrameView, GroupView } from './frame_view';
import { GroupShapes } from './group_shapes';
import type { GroundPoint } from './plane';
import type { OpenTake } from './take_facts';

/** What each character plays, and where it faces; what is not given is 0. */
export interface Played {
  readonly heading?: readonly number[];
  readonly fade?: readonly number[];
  readonly clip?: readonly number[];
  readonly phase?: readonly number[];
  readonly before?: readonly number[];
  readonly beforePhase?: readonly number[];
}

/** A frame with one character per entry of `x`. */
export function madeFrame(frame: number, x: readonly number[], more: Partial<FrameView> & Played = {}): FrameView {
  const zeros = x.map(() => 0);
  const { heading = [], fade = [], clip = zeros, phase = [], before = [], beforePhase = [], ...rest } = more;
  const rows = new Float32Array(rowsLength(x.length));
  const y = rest.y ?? zeros;
  x.forEach((at, i) => {
    const row = [at, y[i], heading[i], fade[i], clip[i], phase[i], before[i], beforePhase[i]].map((one) => one ?? 0);
    rows.set(row, kRowFloats * i);
  });
  return {
    frame,
    step: frame,
    time: frame / 60,
    playing: true,
    ids: x.map((_, i) => i + 1),
    group: zeros,
    unitClass: [],
    radius: [],
    x,
    y,
    clip,
    rows,
    near: [],
    nearPoses: [],
    groups: [],
    moving: [],
    collected: [],
    ...rest,
  };
}

/** A control of a kind with a handle per x, y pair; touches count from 1. */
export function madeControl(id: number, kind: number, handles: readonly (readonly [number, number])[]): ControlView {
  return {
    id,
    kind,
    client: 1,
    pinned: false,
    open: false,
    supplementary: [],
    points: handles.map(([x, y], i) => ({ touch: i + 1, down: true, x, y, path: [] })),
  };
}

/** A group without orders. */
export const kIdle = {
  x: 0,
  y: 0,
  facing: 0,
  orders: [],
  way: new Float32Array(),
  held: false,
  patrols: false,
  stance: 0,
  cohesion: 0,
  squeeze: 1,
  avoids: false,
} as const;

export function madeGroup(id: number, controls: readonly ControlView[], more: Partial<GroupView> = {}): GroupView {
  return { id, meshVersion: 1, lag: 0, vertices: [], places: [], fit: [], controls, ...kIdle, ...more };
}

/** A march to a place, or another order. */
export function madeOrder(id: number, more: Given<Order> = {}): QueueOrder {
  return { id, ...filled<Order>('Order', more) };
}

/** What is drawn of groups and their orders. */
interface QuietOrders {
  readonly greyed: boolean;
  readonly groups: readonly GroupView[];
  readonly shapes: GroupShapes;
  readonly selected: ReadonlySet<number>;
  readonly queues: boolean;
  readonly drawn: null;
  readonly forecasts: readonly never[];
  readonly ways: ReadonlyMap<number, GroundPoint[]>;
  readonly returns: ReadonlyMap<number, GroundPoint[]>;
  readonly picked: number;
  readonly cut: null;
  readonly cursor: null;
  readonly scheme: null;
  readonly barred: readonly never[];
}

/** The same where nobody has done anything yet. */
export function quietOrders(): QuietOrders {
  return {
    greyed: false,
    groups: [],
    shapes: new GroupShapes(),
    selected: new Set<number>(),
    queues: true,
    drawn: null,
    forecasts: [],
    ways: new Map<number, GroundPoint[]>(),
    returns: new Map<number, GroundPoint[]>(),
    picked: 0,
    cursor: null,
    cut: null,
    scheme: null,
    barred: [],
  };
}

/** A take of ten seconds that is open, without a title and without marks. */
export const kOpenTake: OpenTake = {
  name: 'a.take',
  title: '',
  steps: 600,
  stepTime: 1 / 60,
  from: 60,
  to: 540,
  loop: false,
  stored: false,
  speeds: [],
  marks: [],
  beneath: '',
};

/** The mesh of a group, of two triangles with a place in each. */
export function madeMesh(group: number, more: Partial<GroupMesh> = {}): GroupMesh {
  return {
    type: 'GroupMesh',
    group,
    version: 1,
    formation: 'square',
    spacing: 1,
    rest: new Float32Array(),
    triangles: Uint32Array.of(0, 1, 2, 0, 2, 3),
    boundary: new Uint32Array(),
    placeTriangles: Uint32Array.of(0, 1),
    placeWeights: Float32Array.of(0.5, 0.25, 0, 0),
    ...more,
  };
}
