import { describe, expect, it } from 'vitest';
import { CrowdState } from './crowd_state';
import { madeFrame } from '../../model/test_frames';

function crowd(count: number): CrowdState {
  const state = new CrowdState();
  state.setMembers(
    Array.from({ length: count }, (_, i) => i + 1),
    Array.from({ length: count }, () => 0),
  );
  return state;
}

describe('CrowdState', () => {
  it('stands between two frames', () => {
    const state = crowd(2);
    state.update({ from: madeFrame(1, [0, 4]), to: madeFrame(2, [1, 5], { y: [1, 0] }), alpha: 0.25 });
    expect(Array.from(state.positions)).toEqual([0.25, 0.25, 4.25, 0]);
    state.update({ from: madeFrame(1, [0, 4]), to: madeFrame(2, [1, 5], { y: [1, 0] }), alpha: 0.5 });
    expect(Array.from(state.positions)).toEqual([0.5, 0.5, 4.5, 0]);
  });

  it('draws big bodies big, and takes other classes and radii as other members', () => {
    const state = new CrowdState();
    state.setUsualRadius(0.25);
    const first = madeFrame(1, [0, 4], { unitClass: [0, 3], radius: [25, 50] });
    expect(state.takeMembers(first)).toBe(true);
    expect(state.scale[0]).toBeCloseTo(1);
    expect(state.scale[1]).toBeCloseTo(2 ** 0.7);
    expect(Array.from(state.unitClass)).toEqual([0, 3]);
    expect(state.takeMembers(first)).toBe(false);
    expect(state.takeMembers(madeFrame(2, [0, 4], { unitClass: [1, 3], radius: [25, 50] }))).toBe(true);
    expect(state.takeMembers(madeFrame(3, [0, 4], { unitClass: [1, 3] }))).toBe(true);
    expect(state.scale[1]).toBeCloseTo(1);
  });

  it('is there at once where somebody was put elsewhere', () => {
    const state = crowd(1);
    state.update({ from: madeFrame(1, [0]), to: madeFrame(2, [50]), alpha: 0.25 });
    expect(state.positions[0]).toBe(50);
  });

  it('forgets who was there with a world, so that the same numbers are news in the next', () => {
    const state = crowd(2);
    const before = state.version;
    state.clear();
    expect([state.count, state.ids.length, state.group.length, state.positions.length]).toEqual([0, 0, 0, 0]);
    expect(state.version).not.toBe(before);
  });

  it('knows who is near a spot in the newer frame', () => {
    const state = crowd(2);
    expect(state.someoneNear(0, 0, 1)).toBe(false);
    state.update({ from: madeFrame(1, [0, 4]), to: madeFrame(2, [1, 5]), alpha: 0 });
    expect([state.someoneNear(1.4, 0, 0.5), state.someoneNear(0, 0, 0.5)]).toEqual([true, false]);
    state.update({ from: madeFrame(2, [1, 5]), to: madeFrame(3, [0, 5]), alpha: 0 });
    expect([state.someoneNear(1.4, 0, 0.5), state.someoneNear(0, 0, 0.5)]).toEqual([false, true]);
  });

  it('gives everybody a size and a body, by id', () => {
    const state = crowd(300);
    const sizes = Array.from(state.size);
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
    expect(state.positions[4]).toBe(7);
    state.update({ from: madeFrame(2, [5, 6, 7]), to: madeFrame(3, [1]), alpha: 0.5 });
    expect(state.positions[0]).toBe(1);
  });
});
