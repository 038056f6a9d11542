import { describe, expect, it } from 'vitest';
import { kJoints } from '../model/skeleton';
import type { Order } from '../protocol/generated/commands';
import { filled } from '../protocol/encoding';
import type { Frame, GroupFrame } from '../protocol/messages';
import { kIdle, madeMesh } from '../model/test_frames';
import { FrameUnpacker, unpackPoses } from './frame_unpacker';
import { buffersOf } from '../model/studio_frame';

/** As docs/protocol.md tells it, written a second time. */
function packTurn(q: readonly number[]): number[] {
  const largest = q.reduce((best, one, k) => (Math.abs(one) > Math.abs(q[best]!) ? k : best), 0);
  const sign = q[largest]! < 0 ? -1 : 1;
  const others = q.flatMap((one, k) => (k === largest ? [] : [Math.round(sign * one * Math.SQRT2 * 16383)]));
  return others.map((one, n) => 2 * one + (n < 2 ? (largest >> n) & 1 : 0));
}

function frameOf(group: Partial<GroupFrame>): Frame {
  const none = { x: new Uint16Array(), y: new Uint16Array(), jumpedX: new Uint16Array(), jumpedY: new Uint16Array() };
  const crowd = {
    count: 1,
    x0: 0,
    y0: 0,
    quantum: 1,
    ...none,
    x: Uint16Array.of(3),
    y: Uint16Array.of(4),
    stepX: new Int8Array(),
    stepY: new Int8Array(),
    jumped: new Uint32Array(),
    heading: new Uint8Array(1),
    headingFine: new Uint8Array(),
    changed: new Uint32Array(),
    clip: Uint8Array.of(0),
    phase: new Uint8Array(1),
    phaseFine: new Uint8Array(),
    near: Uint32Array.of(0),
    nearPlaces: Float32Array.of(3.25, 4.125, 1.5),
    nearPoses: new Int16Array(),
  };
  const moved = {
    moved: new Uint32Array(),
    offsets: new Int16Array(),
    unfit: new Uint8Array(),
    standings: new Uint32Array(),
  };
  const figures = { lag: 0, walkSum: 0, walkSquares: 0, walkLongest: 0 };
  return {
    type: 'Frame',
    frame: 1,
    step: 1,
    time: 1,
    playing: true,
    speed: 1,
    recordedSeconds: -1,
    replaying: false,
    demonstrating: false,
    touchEcho: 0,
    sceneRevision: 1,
    areas: [],
    ids: Uint32Array.of(1),
    group: Uint16Array.of(0),
    unitClass: new Uint8Array(),
    radius: new Uint8Array(),
    crowd,
    moving: [],
    collected: new Uint8Array(),
    stepMs: 0,
    lagP95: 0,
    swapsPerSecond: 0,
    events: [],
    groups: [
      {
        id: 7,
        meshVersion: 1,
        ...figures,
        vertices: Float32Array.of(0, 0, 4, 0, 4, 4, 0, 4),
        ...moved,
        controls: [],
        ...kIdle,
        queued: true,
        orders: [],
        ...group,
      },
    ],
  };
}

describe('whole poses', () => {
  it('come back within a hundredth of a degree, whichever component is the largest', () => {
    const turns = Array.from({ length: kJoints }, (_, j) => {
      const q = [0, 1, 2, 3].map((k) => Math.sin(1 + 7.3 * j + 2.1 * k) * (k === j % 4 ? 3 : 1));
      const size = Math.hypot(...q);
      return q.map((one) => one / size);
    });
    const packed = Int16Array.from([10, -20, 950, ...turns.flatMap(packTurn)]);
    const pose = unpackPoses(packed);
    expect(Array.from(pose.subarray(0, 3)).map((one) => one.toFixed(3))).toEqual(['0.010', '-0.020', '0.950']);
    turns.forEach((q, j) => {
      const told = Array.from(pose.subarray(3 + 4 * j, 7 + 4 * j));
      const sign = q.reduce((sum, one, k) => sum + one * told[k]!, 0) < 0 ? -1 : 1;
      // Half the angle between them, for small ones.
      expect(Math.hypot(...q.map((one, k) => one - sign * told[k]!))).toBeLessThan((0.005 * Math.PI) / 180);
    });
  });
});

describe('FrameUnpacker', () => {
  it('puts those near at their very places', () => {
    const { x, y, rows } = new FrameUnpacker().unpack(frameOf({}));
    expect([x[0], y[0], rows[0], rows[1], rows[2]]).toEqual([3.25, 4.125, 3.25, 4.125, 1.5]);
  });

  it('lays places on their points of the mesh, off by what was told last', () => {
    const unpacker = new FrameUnpacker();
    unpacker.setMesh(madeMesh(7));
    const places = (group: Partial<GroupFrame>): number[] =>
      Array.from(unpacker.unpack(frameOf(group)).groups[0]!.places);
    expect(places({})).toEqual([2, 1, 0, 4]);
    expect(places({ moved: Uint32Array.of(1), offsets: Int16Array.of(50, -100) })).toEqual([2, 1, 0.5, 3]);
    const wide = Float32Array.of(0, 0, 8, 0, 8, 4, 0, 4);
    expect(places({ vertices: wide })).toEqual([4, 1, 0.5, 3]);
    unpacker.setMesh(madeMesh(7));
    expect(places({})).toEqual([2, 1, 0, 4]);
  });

  it('keeps who finds no room until that is told anew', () => {
    const unpacker = new FrameUnpacker();
    unpacker.setMesh(madeMesh(7));
    const fit = (unfit: number[]): number[] =>
      Array.from(unpacker.unpack(frameOf({ unfit: Uint8Array.from(unfit) })).groups[0]!.fit);
    expect([fit([]), fit([2]), fit([]), fit([0])]).toEqual([
      [1, 1],
      [1, 0],
      [1, 0],
      [1, 1],
    ]);
  });

  it('keeps a queue until another follows, or the mesh is another', () => {
    const unpacker = new FrameUnpacker();
    unpacker.setMesh(madeMesh(7));
    const ids = (queued: boolean, orders: number[]): number[] => {
      const queue = orders.map((id) => ({ id, order: filled<Order>('Order', {}) }));
      return unpacker.unpack(frameOf({ queued, orders: queue })).groups[0]!.orders.map(({ id }) => id);
    };
    expect([ids(true, [4, 5]), ids(false, []), ids(true, [])]).toEqual([[4, 5], [4, 5], []]);
    expect(ids(true, [6])).toEqual([6]);
    unpacker.setMesh(madeMesh(7));
    expect(ids(false, [])).toEqual([]);
  });

  it('gives buffers that can be handed on, each once', () => {
    const unpacker = new FrameUnpacker();
    unpacker.setMesh(madeMesh(7));
    const frame = unpacker.unpack(frameOf({}));
    const buffers = buffersOf(frame);
    expect(new Set(buffers).size).toBe(buffers.length);
    const moved = structuredClone(frame, { transfer: buffers });
    expect([moved.x[0], frame.x.length]).toEqual([3.25, 0]);
  });
});
