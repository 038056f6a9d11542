import { describe, expect, it } from 'vitest';
import { forCount, kSpacings, loosened, mirrored, turned, type OwnShape } from './shape_edit';

/** Three ahead of one another, and one to the left of the last. */
const kHook: OwnShape = {
  spacing: 1,
  places: [
    { x: 1, y: 0 },
    { x: 0, y: 0 },
    { x: -1, y: 0 },
    { x: -1, y: 1 },
  ],
};

function leastGap({ places }: OwnShape): number {
  let least = Infinity;
  places.forEach((a, i) => {
    for (const b of places.slice(i + 1)) least = Math.min(least, Math.hypot(a.x - b.x, a.y - b.y));
  });
  return least;
}

describe('changes of a shape', () => {
  it('mirrors left and right, and twice is as before', () => {
    expect(mirrored(kHook).places[3]).toEqual({ x: -1, y: -1 });
    expect(mirrored(mirrored(kHook)).places[3]).toEqual(kHook.places[3]);
  });

  it('turns to the left', () => {
    const [front] = turned(kHook, Math.PI / 2).places;
    expect(front!.x).toBeCloseTo(0);
    expect(front!.y).toBeCloseTo(1);
  });

  it('loosens and closes within limits', () => {
    const loose = loosened(kHook, 2);
    expect(loose.spacing).toBe(2);
    expect(leastGap(loose)).toBeCloseTo(2);
    expect(loosened(kHook, 100).spacing).toBe(kSpacings.most);
    expect(loosened(kHook, 0.001).spacing).toBe(kSpacings.least);
  });
});

describe('a shape for another number of people', () => {
  const ring: OwnShape = {
    spacing: 1,
    places: Array.from({ length: 24 }, (_, i) => {
      const a = (2 * Math.PI * i) / 24;
      return { x: 3.82 * Math.cos(a), y: 3.82 * Math.sin(a) };
    }),
  };

  it('has so many places, as far apart, and its form', () => {
    for (const count of [12, 40]) {
      const other = forCount(ring, count);
      expect(other.places).toHaveLength(count);
      expect(leastGap(other)).toBeCloseTo(1, 5);
      // Still a ring: nobody stands in the middle.
      const radii = other.places.map(({ x, y }) => Math.hypot(x, y));
      expect(Math.min(...radii)).toBeGreaterThan(0.5 * Math.max(...radii));
    }
  });

  it('is the same shape for as many, and for nobody', () => {
    expect(forCount(ring, 24)).toBe(ring);
    expect(forCount(ring, 0)).toBe(ring);
    expect(forCount({ spacing: 1, places: [] }, 5).places).toHaveLength(0);
  });
});
