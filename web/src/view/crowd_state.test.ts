import { describe, expect, it } from 'vitest';
import { CrowdState } from './crowd_state';
import type { FrameView } from './frame_types';
import { madeFrame } from './test_frames';

function crowd(count: number): CrowdState {
  const state = new CrowdState();
  state.setClips({ length: () => 0.8, cyclic: (clip) => clip === 0 });
  state.setMembers(Array.from({ length: count }, (_, i) => i + 1), Array.from({ length: count }, () => 0));
  return state;
}

function between(state: CrowdState, from: Partial<FrameView>, to: Partial<FrameView>, alpha: number): void {
  state.update({ from: madeFrame(1, [0], from), to: madeFrame(2, [0], to), alpha });
}

describe('CrowdState', () => {
  it('stands between two frames, turned the short way', () => {
    const state = crowd(2);
    state.update({ from: madeFrame(1, [0, 4], { heading: [3, 0] }), to: madeFrame(2, [1, 5], { heading: [-3, 1] }), alpha: 0.25 });
    expect(state.placement[0]).toBeCloseTo(0.25);
    expect(state.placement[4]).toBeCloseTo(4.25);
    expect(state.placement[2]).toBeCloseTo(3 + 0.25 * (2 * Math.PI - 6));
    expect(state.placement[6]).toBeCloseTo(0.25);
  });

  it('is there at once where somebody was put elsewhere', () => {
    const state = crowd(1);
    state.update({ from: madeFrame(1, [0]), to: madeFrame(2, [50], { heading: [1] }), alpha: 0.25 });
    expect([state.placement[0], state.placement[2]]).toEqual([50, 1]);
  });

  it('forgets who was there with a world, so that the same numbers are news in the next', () => {
    const state = crowd(2);
    state.clear();
    expect([state.count, state.ids.length, state.group.length]).toEqual([0, 0, 0]);
  });

  it('mixes times of a clip, round its end where it is cyclic', () => {
    const state = crowd(1);
    between(state, { clip: [1], clipTime: [300] }, { clip: [1], clipTime: [320] }, 0.5);
    expect(state.time[0]).toBeCloseTo(0.31);
    between(state, { clip: [0], clipTime: [790] }, { clip: [0], clipTime: [10] }, 0.25);
    expect(Math.cos((2 * Math.PI * state.time[0]!) / 0.8)).toBeCloseTo(Math.cos((2 * Math.PI * 0.795) / 0.8), 5);
  });

  it('takes the later frame where the clip is another or begins anew', () => {
    const state = crowd(1);
    between(state, { clip: [0], clipTime: [700] }, { clip: [1], clipTime: [20], fromClip: [0], fromTime: [720], fade: [204] }, 0.1);
    expect([state.clip[0], state.before[0]]).toEqual([1, 0]);
    expect(state.time[0]).toBeCloseTo(0.02);
    expect(state.fade[0]).toBeCloseTo(0.8);
    between(state, { clip: [1], clipTime: [790] }, { clip: [1], clipTime: [0] }, 0.5);
    expect(state.time[0]).toBe(0);
  });

  it('lets the clip before fade from frame to frame', () => {
    const state = crowd(1);
    between(state, { clip: [1], fade: [255] }, { clip: [1], fade: [0] }, 0.25);
    expect(state.fade[0]).toBeCloseTo(0.75);
  });

  it('gives everybody a size and a body, by id', () => {
    const state = crowd(300);
    const sizes = Array.from({ length: 300 }, (_, i) => state.placement[4 * i + 3]!);
    expect(Math.min(...sizes)).toBeGreaterThan(0.9599);
    expect(Math.max(...sizes)).toBeLessThanOrEqual(1.0401);
    expect(Math.max(...sizes) - Math.min(...sizes)).toBeGreaterThan(0.07);
    const second = sizes.filter((_, i) => state.body(i, 2) === 1).length;
    expect(Math.abs(second - 150)).toBeLessThan(40);
    expect(sizes.every((_, i) => state.body(i, 1) === 0)).toBe(true);
  });

  it('bears frames of other lengths', () => {
    const state = crowd(3);
    state.update({ from: madeFrame(1, [0]), to: madeFrame(2, [5, 6, 7]), alpha: 0.5 });
    expect(state.placement[8]).toBe(7);
    state.update({ from: madeFrame(2, [5, 6, 7]), to: madeFrame(3, [1]), alpha: 0.5 });
    expect(state.placement[0]).toBe(1);
  });
});
