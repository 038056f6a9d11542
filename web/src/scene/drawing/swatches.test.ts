import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { contrast, hexToRgb, linearToSrgb, rgbToHex, rgbToOklab, srgbToLinear, type Rgb } from './colour';
import { accentColour, casingOf, inkOn, paletteOf } from './palette';
import { accentOf, chosenOf, colourNumber } from '../../model/accent';
import { kSwatches, swatchOf } from '../../model/swatches';

const kThemes = ['light', 'dark'] as const;

/** Machado et al. 2009, whole loss of one kind of cones. */
const kSights: Readonly<Record<string, readonly (readonly [number, number, number])[]>> = {
  all: [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ],
  'no red': [
    [0.152286, 1.052583, -0.204868],
    [0.114503, 0.786281, 0.099216],
    [-0.003882, -0.048116, 1.051998],
  ],
  'no green': [
    [0.367322, 0.860646, -0.227968],
    [0.280085, 0.672501, 0.047413],
    [-0.01182, 0.04294, 0.968881],
  ],
};

function seen(hex: string, sight: string): Rgb {
  const linear = hexToRgb(hex).map(srgbToLinear);
  const part = (row: readonly number[]): number => {
    const sum = row.reduce((all, factor, k) => all + factor * linear[k]!, 0);
    return linearToSrgb(Math.min(1, Math.max(0, sum)));
  };
  const [red, green, blue] = kSights[sight]!;
  return [part(red!), part(green!), part(blue!)];
}

function difference(a: string, b: string, sight: string): number {
  const [one, other] = [rgbToOklab(seen(a, sight)), rgbToOklab(seen(b, sight))];
  return Math.hypot(one[0] - other[0], one[1] - other[1], one[2] - other[2]);
}

describe('swatches', () => {
  it('stand out from the ground, and words from them, in both themes', () => {
    for (const theme of kThemes)
      for (const swatch of kSwatches) {
        const palette = paletteOf(theme);
        expect(contrast(swatch[theme], palette.ground), swatch.name).toBeGreaterThan(3);
        expect(contrast(swatch[theme], palette.onAccent), swatch.name).toBeGreaterThanOrEqual(4.5);
      }
  });

  it('differ, also without the cones for red or for green', () => {
    for (const theme of kThemes)
      for (const sight of Object.keys(kSights))
        kSwatches.forEach((one, i) => {
          for (const other of kSwatches.slice(i + 1)) {
            const apart = difference(one[theme], other[theme], sight);
            expect(apart, `${one.name} and ${other.name}, ${theme}, ${sight}`).toBeGreaterThan(0.055);
          }
        });
  });

  it('are those of the pictures that the program draws, and of the style sheet', () => {
    const program = readFileSync(new URL('../../../../src/lab/picture/swatches.cpp', import.meta.url), 'utf8');
    const pairs = [...program.matchAll(/\{0x(\w{6}), 0x(\w{6})\}/g)].map(([, light, dark]) => [
      `#${light}`,
      `#${dark}`,
    ]);
    expect(pairs).toEqual(kSwatches.map(({ light, dark }) => [light, dark]));
    const sheet = readFileSync(new URL('../../ui/styles/tokens.css', import.meta.url), 'utf8');
    const rules = sheet.split(":root[data-theme='dark']");
    for (const swatch of kSwatches)
      kThemes.forEach((theme, k) => {
        const found = new RegExp(`${swatch.variable}: (#\\w+);`).exec(rules[k] ?? '')?.[1];
        expect(found?.toUpperCase(), `${swatch.name}, ${theme}`).toBe(swatch[theme]);
      });
  });

  it('have different names', () => {
    expect(new Set(kSwatches.map(({ name }) => name)).size).toBe(kSwatches.length);
  });
});

describe('a colour number', () => {
  it('keeps a chosen colour and the accent, which is the shape', () => {
    for (let accent = 0; accent < 6; ++accent)
      for (const chosen of ['#000000', '#00a1ff', '#FFFFFF']) {
        const number = colourNumber(accent, chosen);
        expect(chosenOf(number)).toBe(chosen.toUpperCase());
        expect(accentOf(number)).toBe(accentOf(accent));
      }
    expect(colourNumber(3, undefined)).toBe(3);
    expect(colourNumber(3, 'red')).toBe(3);
    expect(chosenOf(3)).toBe(null);
  });

  it('is shown as chosen; a swatch by its shade for the theme', () => {
    const teal = colourNumber(2, '#05536d');
    expect(accentColour(paletteOf('light'), teal)).toBe('#05536D');
    expect(accentColour(paletteOf('dark'), teal)).toBe('#17D7FF');
    expect(accentColour(paletteOf('dark'), colourNumber(2, '#123456'))).toBe('#123456');
    expect(swatchOf('#05536d')?.name).toBe('Teal');
    expect(swatchOf('#123456')).toBeUndefined();
  });

  it('has readable words and a casing that is seen, whatever was chosen', () => {
    for (const theme of kThemes)
      for (let grey = 0; grey <= 255; grey += 5) {
        const accent = rgbToHex([grey / 255, grey / 255, 0.5]);
        expect(contrast(accent, inkOn(paletteOf(theme), accent)), accent).toBeGreaterThanOrEqual(4.5);
        expect(contrast(accent, casingOf(paletteOf(theme), accent)), accent).toBeGreaterThanOrEqual(2);
      }
  });
});
