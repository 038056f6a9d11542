import { describe, expect, it } from 'vitest';
import { CrowdState, poseOf } from './crowd_state';
import { madeFrame } from './test_frames';

function crowd(count: number): CrowdState {
  const state = new CrowdState();
  state.setClips(['run', 'crawl', 'swim']);
  state.setMembers(Array.from({ length: count }, (_, i) => i + 1), Array.from({ length: count }, () => 0));
  return state;
}

describe('CrowdState', () => {
  it('stands between two frames', () => {
    const state = crowd(2);
    state.update({ from: madeFrame(1, [0, 4]), to: madeFrame(2, [1, 8]), alpha: 0.25 }, 0.016);
    expect(state.placement[0]).toBeCloseTo(0.25);
    expect(state.placement[4]).toBeCloseTo(5);
  });

  it('forgets who was there with a world, so that the same numbers are news in the next', () => {
    const state = crowd(2);
    state.clear();
    expect([state.count, state.ids.length, state.group.length]).toEqual([0, 0, 0]);
  });

  it('walks its limbs with the ground covered and rests when still', () => {
    const state = crowd(1);
    const at = (x: number): void => {
      const frame = madeFrame(1, [x]);
      state.update({ from: frame, to: frame, alpha: 0 }, 0.02);
    };
    at(0);
    const phase = state.placement[3] ?? 0;
    at(0.03);
    expect((state.placement[3] ?? 0) - phase).toBeCloseTo((0.03 / 1.5) * 2 * Math.PI, 4);
    for (let i = 2; i < 60; ++i) at(0.03 * i);
    expect(state.pose[0]).toBeGreaterThan(0.9);
    for (let i = 0; i < 120; ++i) at(0.03 * 59);
    expect(state.pose[0]).toBeLessThan(0.01);
  });

  it('takes a jump in place as no walk', () => {
    const state = crowd(1);
    const frame = (x: number) => madeFrame(1, [x]);
    state.update({ from: frame(0), to: frame(0), alpha: 0 }, 0.02);
    const phase = state.placement[3];
    state.update({ from: frame(50), to: frame(50), alpha: 0 }, 0.02);
    expect(state.placement[0]).toBe(50);
    expect(state.placement[3]).toBe(phase);
    expect(state.pose[0]).toBe(0);
  });

  it('lies down to swim, not at once', () => {
    const state = crowd(1);
    const run = madeFrame(1, [0]);
    const swim = madeFrame(2, [0], { motion: [2] });
    state.update({ from: run, to: run, alpha: 0 }, 0.02);
    state.update({ from: swim, to: swim, alpha: 0 }, 0.02);
    expect(state.pose[1]).toBeGreaterThan(0);
    expect(state.pose[1]).toBeLessThan(0.5);
    for (let i = 0; i < 100; ++i) state.update({ from: swim, to: swim, alpha: 0 }, 0.02);
    expect(state.pose[1]).toBeCloseTo(poseOf('swim').prone, 3);
    expect(state.pose[3]).toBeLessThan(0);
  });

  it('turns the short way', () => {
    const state = crowd(1);
    const facing = (heading: number) => madeFrame(1, [0], { heading: [heading] });
    state.update({ from: facing(3), to: facing(3), alpha: 0 }, 0.02);
    state.update({ from: facing(-3), to: facing(-3), alpha: 0 }, 0.02);
    expect(state.placement[2]).toBeGreaterThan(3);
  });

  it('bears frames of other lengths', () => {
    const state = crowd(3);
    state.update({ from: madeFrame(1, [0]), to: madeFrame(2, [5, 6, 7]), alpha: 0.5 }, 0.02);
    expect(state.placement[8]).toBe(7);
    state.update({ from: madeFrame(2, [5, 6, 7]), to: madeFrame(3, [1]), alpha: 0.5 }, 0.02);
    expect(state.placement[0]).toBe(1);
  });
});
