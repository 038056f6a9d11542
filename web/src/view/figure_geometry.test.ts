import { describe, expect, it } from 'vitest';
import { kLimb, makeFigureGeometry } from './figure_geometry';
import { lookOf } from './figures';

describe('figure', () => {
  it('is 1.75 m tall and within its budgets of triangles', () => {
    for (const [detail, most] of [[{ sides: 8, shape: 'fine' }, 2000], [{ sides: 4, shape: 'coarse' }, 300], [{ sides: 4, shape: 'plain' }, 100]] as const) {
      const geometry = makeFigureGeometry(detail);
      geometry.computeBoundingBox();
      expect(geometry.boundingBox?.max.z).toBeGreaterThan(1.7);
      expect(geometry.boundingBox?.max.z).toBeLessThan(1.8);
      expect(geometry.boundingBox?.min.z).toBeCloseTo(0, 5);
      expect((geometry.index?.count ?? 0) / 3).toBeLessThanOrEqual(most);
    }
  });

  it('faces outwards: its tubes hold a body of plausible volume', () => {
    const geometry = makeFigureGeometry({ sides: 8, shape: 'fine' });
    const p = geometry.attributes['position']?.array ?? [];
    const index = geometry.index?.array ?? [];
    let sum = 0;
    for (let i = 0; i < index.length; i += 3) {
      const [a, b, c] = [3 * (index[i] ?? 0), 3 * (index[i + 1] ?? 0), 3 * (index[i + 2] ?? 0)];
      const at = (k: number): number => p[k] ?? 0;
      sum += at(a) * (at(b + 1) * at(c + 2) - at(b + 2) * at(c + 1)) + at(a + 1) * (at(b + 2) * at(c) - at(b) * at(c + 2))
        + at(a + 2) * (at(b) * at(c + 1) - at(b + 1) * at(c));
    }
    expect(Math.abs(sum / 6)).toBeGreaterThan(0.04);
    expect(Math.abs(sum / 6)).toBeLessThan(0.12);
    expect(sum).toBeGreaterThan(0);
  });

  it.each(['fine', 'coarse', 'plain'] as const)('has two of each limb, one to a side, when %s', (shape) => {
    const limbs = makeFigureGeometry({ sides: 4, shape }).attributes['limb']?.array ?? [];
    const sides = new Map<number, Set<number>>();
    for (let i = 0; i < limbs.length; i += 3) {
      const set = sides.get(limbs[i] ?? 0) ?? new Set<number>();
      sides.set(limbs[i] ?? 0, set.add(limbs[i + 1] ?? 0));
    }
    for (const limb of [kLimb.upperArm, kLimb.foreArm, kLimb.thigh, kLimb.shin]) {
      expect([...(sides.get(limb) ?? [])].sort()).toEqual([-1, 1]);
    }
  });

  it('spreads skins and hairs over ids, always the same for one', () => {
    const skins = [0, 0, 0, 0, 0];
    const hairs = [0, 0, 0, 0, 0];
    for (let id = 1; id <= 1000; ++id) {
      const look = lookOf(id);
      skins[look.skin] = (skins[look.skin] ?? 0) + 1;
      hairs[look.hair] = (hairs[look.hair] ?? 0) + 1;
    }
    for (const count of [...skins, ...hairs]) expect(Math.abs(count - 200)).toBeLessThan(60);
    expect(lookOf(42)).toEqual(lookOf(42));
  });
});
