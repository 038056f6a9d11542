import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { ByteReader, ByteWriter, ProtocolError } from './bytes';
import { decodeClient, decodeServer, encodeClient, encodeServer } from './encoding';
import {
  ControlKind,
  MovingKind,
  SUBPROTOCOL,
  TouchPhase,
  PlaybackAction,
  VERSION,
  Stance,
  type ClientMessage,
  type Frame,
  type StageTimes,
} from './messages';

function hex(buffer: ArrayBuffer): string {
  return [...new Uint8Array(buffer)].map((byte) => byte.toString(16).padStart(2, '0')).join('');
}

function goldenFrame(): ArrayBuffer {
  const bytes = readFileSync(fileURLToPath(new URL('../../../tests/golden/frame.bin', import.meta.url)));
  return bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
}

const everyMessage: ClientMessage[] = [
  { type: 'Hello', name: 'Zoë' },
  { type: 'Touches', events: [{ phase: TouchPhase.Move, touch: 1, x: 1, y: 2, time: 3, group: 0 }] },
  { type: 'Playback', action: PlaybackAction.Restart },
  { type: 'SetSpeed', factor: 0.5 },
  { type: 'LoadScenario', name: 'open' },
  { type: 'Record', on: false },
  { type: 'SetOverlay', kind: 2, character: 7 },
  {
    type: 'Commands',
    commands: [
      { kind: 'queue', group: 1, edit: 'stop', order: 0 },
      {
        kind: 'control',
        group: 1,
        control: 'line',
        touches: [1, 2],
        positions: [
          [0.5, -0.5],
          [1, 1],
        ],
        time: 9,
      },
      {
        kind: 'changeGroup',
        group: 1,
        formation: null,
        count: 3,
        people: [],
        conduct: null,
        roles: null,
        demands: [1, 0.5],
        name: '',
        colour: { colour: null },
        look: null,
      },
    ],
  },
  { type: 'FrameAck', frame: 4294967295 },
  { type: 'Ping', time: 1.25 },
  {
    type: 'AskForecasts',
    number: 3,
    asks: [{ group: 1, order: 4, asked: null, placed: true, x: 0.5, y: -1, facing: 3 }],
  },
  { type: 'WatchStages', on: true },
];

describe('the bytes', () => {
  it('are those that the protocol promises', () => {
    // The same lines stand in tests/studio/session/protocol_test.cpp.
    expect(hex(encodeClient({ type: 'Hello', name: 'ab' }))).toBe('00020000006162');
    expect(
      hex(
        encodeClient({
          type: 'Touches',
          events: [{ phase: TouchPhase.Up, touch: 258, x: 1, y: -2, time: 0.5, group: 3 }],
        }),
      ),
    ).toBe(
      '01' + '01000000' + '02' + '02010000' + '000000000000f03f' + '00000000000000c0' + '000000000000e03f' + '03000000',
    );
    const pin = { kind: 'editControl', group: 1, control: 2, edit: 'release' } as const;
    expect(hex(encodeClient({ type: 'Commands', commands: [pin] }))).toBe(
      '07' + '0a000000' + '34' + '01000000' + '02000000' + '01',
    );
    expect(hex(encodeClient({ type: 'SetSpeed', factor: 0.5 }))).toBe('030000003f');
    expect(hex(encodeServer({ type: 'Pong', time: 1 }))).toBe('07000000000000f03f');
    expect(SUBPROTOCOL).toBe(`muster.v${VERSION}`);
  });

  it('come back as they went, for every kind', () => {
    for (const message of everyMessage) expect(decodeClient(encodeClient(message))).toEqual(message);
  });

  it('are refused when cut short or prolonged', () => {
    for (const message of everyMessage) {
      const bytes = encodeClient(message);
      for (let length = 0; length < bytes.byteLength; ++length) {
        expect(() => decodeClient(bytes.slice(0, length))).toThrow(ProtocolError);
      }
      const longer = new Uint8Array(bytes.byteLength + 1);
      longer.set(new Uint8Array(bytes));
      expect(() => decodeClient(longer.buffer)).toThrow('1 bytes too many');
    }
  });

  it('are refused with unknown numbers, flags, enumerations and impossible lengths', () => {
    for (const bytes of [[99], [2, 255], [5, 2], [1, 255, 255, 255, 255], [0, 255, 255, 255, 255]]) {
      expect(() => decodeClient(Uint8Array.from(bytes).buffer)).toThrow(ProtocolError);
    }
  });
});

describe('a frame of the server', () => {
  it('is read as it was written', () => {
    const frame = decodeServer(goldenFrame()) as Frame;
    expect(frame.type).toBe('Frame');
    expect([frame.frame, frame.step, frame.time]).toEqual([7, 42, 0.7]);
    expect([frame.playing, frame.recordedSeconds, frame.sceneRevision]).toEqual([true, -1, 3]);
    expect([frame.replaying, frame.demonstrating]).toEqual([false, true]);
    expect(frame.ids).toEqual(Uint32Array.of(1, 2));
    expect(frame.group).toEqual(Uint16Array.of(0, 1));
    const { crowd } = frame;
    expect([crowd.count, crowd.x0, crowd.y0, crowd.quantum]).toEqual([2, -32.5, 16, 1 / 1024]);
    expect([crowd.stepX, crowd.stepY]).toEqual([Int8Array.of(-128, 127), Int8Array.of(0, -1)]);
    expect([crowd.jumpedX, crowd.jumpedY]).toEqual([Uint16Array.of(65535), Uint16Array.of(258)]);
    expect([crowd.heading, crowd.clip]).toEqual([Uint8Array.of(0, 200), Uint8Array.of(5)]);
    expect(crowd.nearPlaces).toEqual(Float32Array.of(0.5, -1.25, 3));
    expect(crowd.nearPoses).toEqual(Int16Array.of(950, -3, -32767));
    expect(frame.groups[0]!.vertices).toEqual(Float32Array.of(0, 0, 1, 0, 0, 1));
    expect(frame.groups[0]!.walkSum).toBe(12.5);
    expect(frame.groups[0]!.offsets).toEqual(Int16Array.of(-40, 300));
    const control = frame.groups[0]!.controls[0]!;
    expect(control.kind).toBe(ControlKind.Area);
    expect(control.points[0]).toEqual({ touch: 9, down: true, x: 1, y: 2, path: Float32Array.of(3, 4) });
    const [order] = frame.groups[0]!.orders;
    expect([order!.id, order!.order.kind, order!.order.facing]).toEqual([4, 'guard', 1.5]);
    expect([order!.order.halfSize, order!.order.route, order!.order.formation?.kind]).toEqual([
      [2, 1],
      [[1, -2]],
      'wedge',
    ]);
    expect([frame.groups[0]!.held, frame.groups[0]!.stance]).toEqual([true, Stance.Yield]);
    expect([frame.unitClass, frame.radius]).toEqual([Uint8Array.of(0, 3), Uint8Array.of(25, 60)]);
    expect(frame.moving[0]!.kind).toBe(MovingKind.Patch);
    expect(frame.moving[0]!.angle).toBeCloseTo(0.3);
    expect(frame.events[0]).toEqual({ kind: 5, subject: 1, value: 2, x: 0, y: 0 });
    expect(hex(encodeServer(frame))).toBe(hex(goldenFrame()));
  });

  it('is refused when cut short anywhere', () => {
    const bytes = goldenFrame();
    for (let length = 0; length < bytes.byteLength; ++length) {
      expect(() => decodeServer(bytes.slice(0, length))).toThrow(ProtocolError);
    }
  });

  it('has arrays of its own, aligned, that can be transferred', () => {
    const bytes = goldenFrame();
    const frame = decodeServer(bytes) as Frame;
    const { jumpedX } = frame.crowd;
    expect(jumpedX.byteOffset).toBe(0);
    expect(jumpedX.buffer).not.toBe(bytes);
    expect(jumpedX.buffer.byteLength).toBe(2);
  });
});

describe('times of stages', () => {
  const times: StageTimes = {
    type: 'StageTimes',
    step: 60,
    total: 0.75,
    stages: [
      { name: 'commands', about: 'Applies the commands.', milliseconds: 0.25 },
      { name: 'orders', about: '', milliseconds: 0.5 },
    ],
  };

  it('come back as they went, with the bytes that the protocol promises', () => {
    const bytes = encodeServer(times);
    expect(decodeServer(bytes)).toEqual(times);
    // Number, step, total and the number of stages; the same bytes stand in tests/studio/session/stage_means_test.cpp.
    expect(hex(bytes).slice(0, 26)).toBe('13' + '3c000000' + '0000403f' + '02000000');
    expect(hex(encodeClient({ type: 'WatchStages', on: true }))).toBe('1c01');
  });

  it('are refused when cut short, prolonged, or of an impossible number', () => {
    const bytes = new Uint8Array(encodeServer(times));
    for (let length = 0; length < bytes.length; ++length) {
      expect(() => decodeServer(bytes.slice(0, length).buffer)).toThrow(ProtocolError);
    }
    const longer = new Uint8Array(bytes.length + 1);
    longer.set(bytes);
    expect(() => decodeServer(longer.buffer)).toThrow('1 bytes too many');
    const many = bytes.slice();
    many.fill(255, 9, 13);
    expect(() => decodeServer(many.buffer)).toThrow(ProtocolError);
  });
});

describe('ByteWriter and ByteReader', () => {
  it('grow and keep every kind of value', () => {
    const w = new ByteWriter();
    const many = Float64Array.from({ length: 5000 }, (_, i) => i / 3);
    w.f64s(many);
    w.text('ü'.repeat(300));
    w.u32(4294967295);
    w.f32(0.1);
    w.bool(true);
    // A view that begins inside its buffer.
    w.f32s(Float32Array.of(1, 2, 3).subarray(1));
    const r = new ByteReader(w.bytes());
    expect(r.f64s()).toEqual(many);
    expect(r.text()).toBe('ü'.repeat(300));
    expect(r.u32()).toBe(4294967295);
    expect(r.f32()).toBeCloseTo(0.1);
    expect(r.bool()).toBe(true);
    expect(r.f32s()).toEqual(Float32Array.of(2, 3));
    r.end();
  });
});
