import { describe, expect, it } from 'vitest';
import { contourLabels, makeFieldRaster } from './field_raster';
import type { OverlayView } from '../../model/frame_view';
import { fieldScale, niceCeiling } from '../../model/field_scale';

function cone(width: number, height: number, cell: number): OverlayView {
  const values: number[] = [];
  for (let j = 0; j < height; ++j)
    for (let i = 0; i < width; ++i) values.push(cell * Math.hypot(i - width / 2, j - height / 2));
  return { kind: 2, character: 1, x: 0, y: 0, cell, width, height, values, path: [] };
}

describe('field picture', () => {
  it('rounds up to 1, 2 or 5', () => {
    expect(niceCeiling(0.7)).toBeCloseTo(1);
    expect(niceCeiling(1.2)).toBe(2);
    expect(niceCeiling(23)).toBe(50);
    expect(niceCeiling(0)).toBe(1);
    expect(niceCeiling(Infinity)).toBe(1);
  });

  it('scales so that contours are few and each fifth has a number', () => {
    for (const most of [0.02, 3, 16, 480]) {
      const scale = fieldScale(Array.from({ length: 1000 }, (_, i) => (most * i) / 999));
      expect(scale.max / scale.step).toBeLessThanOrEqual(25);
      expect((scale.max / scale.step) % 5).toBeCloseTo(0, 9);
      expect(scale.max).toBeGreaterThan(0.9 * most);
    }
  });

  it('bears fields without a finite value', () => {
    expect(fieldScale([Infinity, NaN]).max).toBe(1);
    expect(fieldScale([]).max).toBe(1);
  });

  it('marks what is not reached', () => {
    const overlay = { ...cone(4, 4, 1), values: [0, 1, Infinity, NaN, ...Array.from({ length: 12 }, () => 2)] };
    const picture = makeFieldRaster(overlay);
    expect([...picture.texels.slice(0, 8)].filter((_, i) => i % 2)).toEqual([1, 1, 0, 0]);
    expect([...picture.texels].every((value) => Number.isFinite(value) && value >= 0 && value <= 1)).toBe(true);
    expect(picture.spanX).toBe(4);
    expect(picture.x).toBe(-0.5);
  });

  it('numbers contours where their value is', () => {
    const overlay = cone(200, 200, 0.25);
    const scale = fieldScale(overlay.values);
    const labels = contourLabels(overlay, scale, 2.5);
    expect(labels.length).toBeGreaterThan(0);
    for (const label of labels) {
      expect(Math.hypot(label.x - 25, label.y - 25)).toBeCloseTo(Number(label.text), 0);
      expect(Number(label.text) % (5 * scale.step)).toBeCloseTo(0, 6);
    }
  });
});
