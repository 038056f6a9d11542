import { describe, expect, it } from 'vitest';
import { mix, mixAngle } from './blend';

describe('blend', () => {
  it('mixes numbers and angles the short way', () => {
    expect(mix(2, 6, 0.25)).toBe(3);
    expect(mixAngle(3, -3, 0.5)).toBeCloseTo(Math.PI, 6);
    expect(mixAngle(0.2, 0.4, 0.5)).toBeCloseTo(0.3);
  });
});
