// @vitest-environment jsdom
import { describe, expect, it } from 'vitest';
import { Sparkline, sparklinePoints } from './sparkline';

describe('sparklinePoints', () => {
  it('spreads values over the width, the top value at the upper edge', () => {
    expect(sparklinePoints([0, 5, 10], 100, 20, 10)).toBe('0.0,20.0 50.0,10.0 100.0,0.0');
  });
  it('clips what is beyond and survives a single value and no scale', () => {
    expect(sparklinePoints([30], 100, 20, 10)).toBe('0.0,0.0');
    expect(sparklinePoints([1, 2], 100, 20, 0)).toBe('0.0,20.0 100.0,20.0');
  });
});

it('keeps the newest 48 values and scales to the largest of them', () => {
  const spark = new Sparkline(16, 1);
  spark.push(1000);
  for (let i = 0; i < 48; ++i) spark.push(8.4);
  const points = spark.root.querySelector('polyline')!.getAttribute('points')!.split(' ');
  expect(points).toHaveLength(48);
  expect(points[47]).toBe('92.0,6.6');
});
