import { describe, expect, it } from 'vitest';
import { hexToRgb, oklabToRgb, rampBytes, rampColour, rgbToHex, rgbToOklab, withAlpha } from './colour';
import { paletteOf } from './palette';

describe('colour', () => {
  it('knows OKLab of white, black and pure red', () => {
    expect(rgbToOklab([1, 1, 1])[0]).toBeCloseTo(1, 4);
    expect(rgbToOklab([0, 0, 0])[0]).toBeCloseTo(0, 6);
    const red = rgbToOklab([1, 0, 0]);
    expect(red[0]).toBeCloseTo(0.628, 3);
    expect(red[1]).toBeCloseTo(0.2249, 3);
    expect(red[2]).toBeCloseTo(0.1258, 3);
  });

  it('goes there and back', () => {
    for (const hex of ['#1D5FD1', '#CB4A0E', '#3B4564', '#F5F3C9']) {
      expect(rgbToHex(oklabToRgb(rgbToOklab(hexToRgb(hex))))).toBe(hex);
    }
  });

  it('writes CSS with an alpha', () => {
    expect(withAlpha('#FF8A4C', 0.5)).toBe('rgba(255,138,76,0.5)');
  });

  it('ramps meet their stops, and go evenly away from the lightness of the ground', () => {
    for (const theme of ['light', 'dark'] as const) {
      const stops = paletteOf(theme).ramp;
      expect(rgbToHex(rampColour(stops, 0))).toBe(stops[0]);
      expect(rgbToHex(rampColour(stops, 0.25))).toBe(stops[1]);
      expect(rgbToHex(rampColour(stops, 1))).toBe(stops[4]);
      const lightness = stops.map((stop) => rgbToOklab(hexToRgb(stop))[0]);
      const steps = lightness.slice(1).map((value, i) => (lightness[i] ?? 0) - value);
      const mean = steps.reduce((sum, step) => sum + step, 0) / steps.length;
      expect(Math.sign(mean)).toBe(theme === 'light' ? 1 : -1);
      for (const step of steps) expect(Math.abs(step - mean)).toBeLessThan(0.25 * Math.abs(mean));
    }
  });

  it('makes opaque bytes for a texture', () => {
    const bytes = rampBytes(['#000000', '#FFFFFF'], 5);
    expect(bytes.length).toBe(20);
    expect(bytes[3]).toBe(255);
    expect(bytes[16]).toBe(255);
    expect(bytes[0]).toBe(0);
  });
});
