import { describe, expect, it } from 'vitest';
import { niceTicks } from './plot';

describe('niceTicks', () => {
  it('are round and few', () => {
    expect(niceTicks(0, 5.25, 3)).toEqual([0, 2, 4]);
    expect(niceTicks(0, 1, 3)).toEqual([0, 0.5, 1]);
    expect(niceTicks(12, 73, 4)).toEqual([20, 40, 60]);
    expect(niceTicks(3, 3, 4)).toEqual([3]);
  });
});
