import { expect, it } from 'vitest';
import { classColour, countClasses, kClassColours } from './roles';

/** Lightness of a colour, 0 to 1, as CIE has it. */
function lightness(hex: string): number {
  const part = (from: number): number => {
    const value = parseInt(hex.slice(from, from + 2), 16) / 255;
    return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
  };
  const y = 0.2126 * part(1) + 0.7152 * part(3) + 0.0722 * part(5);
  return y > 0.008856 ? 1.16 * Math.cbrt(y) - 0.16 : 9.033 * y;
}

it('neighbouring classes differ in lightness, whatever hues one sees', () => {
  kClassColours.forEach((colour, i) => {
    const next = kClassColours[(i + 1) % kClassColours.length]!;
    expect(Math.abs(lightness(colour) - lightness(next)), `${colour} ${next}`).toBeGreaterThan(0.04);
  });
  expect(classColour(0)).toBe('');
  expect(classColour(1 + kClassColours.length)).toBe(classColour(1));
});

it('counts the classes of each group, and nobody of none', () => {
  const counts = countClasses([0, 0, 1, 0, 7], [2, 0, 1, 2, 3], 2);
  expect(counts).toEqual([[{ unitClass: 2, count: 2 }], [{ unitClass: 1, count: 1 }]]);
  expect(countClasses([0, 1], [], 2)).toEqual([[], []]);
});
