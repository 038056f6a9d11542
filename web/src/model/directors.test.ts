import { describe, expect, it } from 'vitest';
import { directorColour, directorInfos, initialOf, sameDirectors } from './directors';

/** Contrast of white text on a colour (WCAG 2). */
function contrastToWhite(hex: string): number {
  const [r, g, b] = [1, 3, 5].map((at) => {
    const share = parseInt(hex.slice(at, at + 2), 16) / 255;
    return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
  }) as [number, number, number];
  return 1.05 / (0.2126 * r + 0.7152 * g + 0.0722 * b + 0.05);
}

describe('directors', () => {
  it('have colours that white can be read on, all different', () => {
    const all = Array.from({ length: 16 }, (_, i) => directorColour(i));
    expect(new Set(all).size).toBe(16);
    for (const colour of all) expect(contrastToWhite(colour), colour).toBeGreaterThan(4.5);
    expect(directorColour(16)).toBe(directorColour(0));
  });

  it('are known by the first letter of their name, or by their number', () => {
    expect(initialOf('anna')).toBe('A');
    expect(initialOf('Director 3')).toBe('3');
    expect(initialOf('😀 x')).toBe('😀');
    expect(initialOf('')).toBe('?');
  });

  it('hold the groups on which they have a control', () => {
    const control = (client: number) => ({ client }) as never;
    const groups = [
      { id: 4, controls: [control(7), control(8)] },
      { id: 9, controls: [control(7)] },
    ];
    const frames = [
      { client: 7, name: 'Anna', colour: 0, groups: Uint32Array.of() },
      { client: 8, name: 'Ben', colour: 1, groups: Uint32Array.of(4) },
    ];
    const [anna, ben] = directorInfos(frames, 8, groups);
    expect(anna).toMatchObject({ own: false, holds: [4, 9], groups: [] });
    expect(ben).toMatchObject({ own: true, holds: [4], groups: [4] });
    expect(sameDirectors([anna!], [anna!])).toBe(true);
    expect(sameDirectors([anna!], [ben!])).toBe(false);
  });
});
