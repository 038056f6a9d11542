import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { accentOf } from '../../model/accent';
import { contrast } from './colour';
import { accentColour, paletteOf } from './palette';

describe('palette', () => {
  it('accents stand out from the ground, and their words from them', () => {
    for (const theme of ['light', 'dark'] as const) {
      const palette = paletteOf(theme);
      for (const accent of Object.values(palette.accents)) {
        expect(contrast(accent, palette.ground)).toBeGreaterThan(3);
        expect(contrast(accent, palette.onAccent)).toBeGreaterThanOrEqual(4.5);
      }
      for (const mark of [palette.waterLine, palette.net, palette.brickLine, palette.obstacleEdge]) {
        expect(contrast(mark, palette.ground)).toBeGreaterThan(3);
      }
      for (const { floor, line } of Object.values(palette.areas)) {
        expect(contrast(line, floor)).toBeGreaterThan(3);
        expect(contrast(line, palette.ground)).toBeGreaterThan(3);
      }
      expect(contrast(palette.edge, palette.ground)).toBeGreaterThan(3);
      expect(contrast(palette.ink, palette.panel)).toBeGreaterThan(12);
    }
  });

  it('repeats after six', () => {
    const palette = paletteOf('light');
    expect(accentColour(palette, 6)).toBe(accentColour(palette, 0));
    expect(accentColour(palette, -1)).toBe(accentColour(palette, 5));
  });

  it('has the accents of the style sheet', () => {
    const sheet = readFileSync(new URL('../../ui/styles/tokens.css', import.meta.url), 'utf8');
    const [light, dark] = sheet.split(":root[data-theme='dark']");
    for (const [theme, rules] of [
      ['light', light],
      ['dark', dark],
    ] as const) {
      for (let colour = 0; colour < 6; ++colour) {
        const found = new RegExp(`--group-${accentOf(colour)}: (#\\w+);`).exec(rules ?? '')?.[1];
        expect(found?.toUpperCase()).toBe(accentColour(paletteOf(theme), colour));
      }
    }
  });
});
