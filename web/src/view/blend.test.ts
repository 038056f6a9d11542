import { describe, expect, it } from 'vitest';
import { mix, mixAngle, mixNumbers } from './blend';

describe('blend', () => {
  it('mixes numbers and angles the short way', () => {
    expect(mix(2, 6, 0.25)).toBe(3);
    expect(mixAngle(3, -3, 0.5)).toBeCloseTo(Math.PI, 6);
    expect(mixAngle(0.2, 0.4, 0.5)).toBeCloseTo(0.3);
  });

  it('mixes lists in place, and lets the second hold where lengths differ', () => {
    const out = new Float32Array(2);
    expect(mixNumbers([0, 10], [4, 20], 0.5, out)).toBe(out);
    expect([...out]).toEqual([2, 15]);
    expect([...mixNumbers([1], [4, 20], 0.5, out)]).toEqual([4, 20]);
    expect(mixNumbers([], [1, 2, 3], 0.5, out).length).toBe(3);
  });
});
