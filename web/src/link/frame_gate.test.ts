import { describe, expect, it } from 'vitest';
import type { EventFrame } from '../protocol/messages';
import type { StudioFrame } from '../model/studio_frame';
import { FrameGate, mergeStale } from './frame_gate';

function frame(number: number, ids: number[] = [], events: number[] = []): StudioFrame {
  const part = {
    type: 'Frame',
    frame: number,
    ids: Uint32Array.from(ids),
    group: Uint16Array.from(ids.map(() => 0)),
    events: events.map((subject) => ({ subject }) as EventFrame),
  };
  return part as unknown as StudioFrame;
}

function gate(): { gate: FrameGate; seen: StudioFrame[] } {
  const seen: StudioFrame[] = [];
  return { gate: new FrameGate((one) => seen.push(one)), seen };
}

describe('FrameGate', () => {
  it('hands a frame over at once while the page is ready', () => {
    const { gate: one, seen } = gate();
    one.offer(frame(1), 0);
    one.ready();
    one.offer(frame(2), 0);
    expect(seen.map((f) => f.frame)).toEqual([1, 2]);
    expect(one.dropped).toBe(0);
  });
  it('keeps only the newest for a busy page', () => {
    const { gate: one, seen } = gate();
    for (let i = 1; i <= 5; ++i) one.offer(frame(i), i);
    expect(seen.map((f) => f.frame)).toEqual([1]);
    one.ready();
    expect(seen.map((f) => f.frame)).toEqual([1, 5]);
    expect(one.dropped).toBe(3);
    one.ready();
    expect(seen).toHaveLength(2);
  });
  it('forgets what waits when the connection is gone', () => {
    const { gate: one, seen } = gate();
    one.offer(frame(1), 0);
    one.offer(frame(2), 0);
    one.reset();
    one.ready();
    expect(seen).toHaveLength(1);
  });
});

describe('mergeStale', () => {
  it('carries ids and events of an overtaken frame over', () => {
    const merged = mergeStale(frame(1, [4, 5], [1]), frame(2, [], [2]));
    expect([...merged.ids]).toEqual([4, 5]);
    expect(merged.group).toHaveLength(2);
    expect(merged.events.map((event) => event.subject)).toEqual([1, 2]);
    expect(merged.frame).toBe(2);
  });
  it('prefers newer ids', () => {
    expect([...mergeStale(frame(1, [4]), frame(2, [7, 8])).ids]).toEqual([7, 8]);
  });
});
