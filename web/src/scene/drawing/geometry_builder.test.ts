import { describe, expect, it } from 'vitest';
import type { Vec2 } from '../../protocol/generated/commands';
import { centroid, circlePoints, counterClockwise, GeometryBuilder, signedArea2 } from './geometry_builder';

const kSquare: readonly Vec2[] = [
  [0, 0],
  [2, 0],
  [2, 2],
  [0, 2],
];

function volume(builder: GeometryBuilder): number {
  const p = builder.build().attributes['position']?.array ?? [];
  let sum = 0;
  for (let i = 0; i < p.length; i += 9) {
    const [ax, ay, az, bx, by, bz, cx, cy, cz] = Array.from(p).slice(i, i + 9) as [
      number,
      number,
      number,
      number,
      number,
      number,
      number,
      number,
      number,
    ];
    sum += ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
  }
  return sum / 6;
}

describe('geometry', () => {
  it('knows area, order and centre', () => {
    expect(signedArea2(kSquare)).toBe(8);
    expect(signedArea2(counterClockwise([...kSquare].reverse()))).toBe(8);
    expect(centroid(kSquare)).toEqual([1, 1]);
    expect(
      centroid([
        [0, 0],
        [4, 0],
      ]),
    ).toEqual([2, 0]);
    expect(circlePoints(1, 2, 3, 8)).toHaveLength(8);
  });

  it('a prism is closed from outside: its walls and lid hold its volume above an open floor at 0', () => {
    const concave: readonly Vec2[] = [
      [0, 0],
      [4, 0],
      [4, 4],
      [2, 4],
      [2, 2],
      [0, 2],
    ];
    for (const outline of [kSquare, [...kSquare].reverse(), concave]) {
      const builder = new GeometryBuilder();
      builder.prism(outline, 0, 3, '#FFFFFF', '#FFFFFF');
      expect(volume(builder)).toBeCloseTo((3 * Math.abs(signedArea2(outline))) / 2, 5);
    }
  });

  it('a cone cut off has the volume of the formula for its polygon', () => {
    const builder = new GeometryBuilder();
    builder.frustum(0, 0, 0, 2, 1, 0.5, 64, '#FFFFFF', '#FFFFFF');
    expect(volume(builder)).toBeCloseTo((Math.PI * 2 * (1 + 0.5 + 0.25)) / 3, 1);
  });

  it('a beam has its size', () => {
    const builder = new GeometryBuilder();
    builder.beam([0, 0, 0], [3, 4, 0], 0.5, 0.2, '#FFFFFF');
    expect(volume(builder)).toBeCloseTo(5 * 0.5 * 0.2, 5);
  });

  it('leaves out triangles without area', () => {
    const builder = new GeometryBuilder();
    builder.triangle([0, 0, 0], [1, 1, 1], [2, 2, 2], '#FFFFFF');
    expect(builder.triangleCount).toBe(0);
  });
});
