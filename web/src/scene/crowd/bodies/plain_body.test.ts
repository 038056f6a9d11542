import { describe, expect, it } from 'vitest';
import { trianglesOf } from './body';
import { makePlainBody } from './plain_body';

/** Volume that a closed skin holds [m³]; negative where it faces inwards. */
export function volumeOf(position: ArrayLike<number>, index: ArrayLike<number>): number {
  let sum = 0;
  for (let i = 0; i < index.length; i += 3) {
    const [a, b, c] = [3 * index[i]!, 3 * index[i + 1]!, 3 * index[i + 2]!];
    const p = (k: number): number => position[k]!;
    sum +=
      p(a) * (p(b + 1) * p(c + 2) - p(b + 2) * p(c + 1)) +
      p(a + 1) * (p(b + 2) * p(c) - p(b) * p(c + 2)) +
      p(a + 2) * (p(b) * p(c + 1) - p(b + 1) * p(c));
  }
  return sum / 6;
}

describe('the simple person', () => {
  const body = makePlainBody();

  it('is 1.75 m tall, stands on the ground and has few triangles', () => {
    for (const [parts, most] of [
      [body.near, 700],
      [body.far, 300],
    ] as const) {
      const { geometry } = parts[0]!;
      geometry.computeBoundingBox();
      expect(geometry.boundingBox!.max.z).toBeCloseTo(1.775, 1);
      expect(geometry.boundingBox!.min.z).toBeGreaterThan(-0.01);
      expect(geometry.boundingBox!.min.z).toBeLessThan(0.03);
      expect(trianglesOf(parts)).toBeLessThanOrEqual(most);
    }
  });

  it('faces outwards', () => {
    const { geometry } = body.near[0]!;
    const volume = volumeOf(geometry.attributes['position']!.array, geometry.index!.array);
    expect(volume).toBeGreaterThan(0.04);
    expect(volume).toBeLessThan(0.12);
  });

  it('hangs every corner on one joint wholly', () => {
    const { geometry } = body.far[0]!;
    const weights = geometry.attributes['weights']!;
    for (let i = 0; i < weights.count; ++i)
      expect(weights.getX(i) + weights.getY(i) + weights.getZ(i) + weights.getW(i)).toBe(1);
  });
});
