import { expect, it } from 'vitest';
import { PaceMeter } from './pace_meter';

it('measures how fast the world goes on, anew after a pause or another speed', () => {
  const meter = new PaceMeter();
  const run = (from: number, pace: number, playing = true, speed = 1): number[] =>
    [0, 1, 2, 3].map((k) => meter.observe(from + pace * k, playing, speed, 1000 * (from + k)));
  expect(run(0, 0.5).map((one) => Math.round(100 * one))).toEqual([NaN, NaN, 50, 50]);
  expect(run(10, 1, false)).toEqual([NaN, NaN, NaN, NaN]);
  expect(run(20, 1, true, 2)).toEqual([NaN, NaN, 1, 1]);
});
