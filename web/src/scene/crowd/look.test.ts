import { expect, it } from 'vitest';
import { bodyIndex, bodyOf, lookOf, sizeOf } from './look';

it('spreads skins, hairs and bodies over ids, always the same for one', () => {
  const skins = [0, 0, 0, 0, 0];
  const hairs = [0, 0, 0, 0, 0];
  const bodies = [0, 0];
  for (let id = 1; id <= 1000; ++id) {
    const look = lookOf(id);
    skins[look.skin]! += 1;
    hairs[look.hair]! += 1;
    bodies[bodyOf(id, 2)]! += 1;
  }
  for (const count of [...skins, ...hairs]) expect(Math.abs(count - 200)).toBeLessThan(60);
  expect(Math.abs(bodies[0]! - 500)).toBeLessThan(80);
  expect(lookOf(42)).toEqual(lookOf(42));
  expect(bodyOf(42, 1)).toBe(0);
  // As characterSize() of the server has it.
  expect(sizeOf(0)).toBeCloseTo(0.96);
});

it('takes the body of the group, where there are two', () => {
  for (const own of [0, 1]) {
    expect(bodyIndex('broad', own, 2)).toBe(0);
    expect(bodyIndex('narrow', own, 2)).toBe(1);
    expect(bodyIndex(undefined, own, 2)).toBe(own);
  }
  expect(bodyIndex('narrow', 0, 1)).toBe(0);
});
