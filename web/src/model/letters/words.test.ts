import { describe, expect, it } from 'vitest';
import type { GroundPoint } from '../plane';
import { LetterReader, type LetterDrawn } from './legibility';
import { kStrokeChars, strokeLetters } from './stroke_font';
import { leastDistance, placesAlong, placesApart } from './stroke_places';
import { peopleFor, strokeWords } from './words';

const line = (...points: [number, number][]) => ({
  points: points.map(([x, y]) => ({ x, y })),
  nodes: points.map((_, i) => i),
});

describe('people along lines', () => {
  it('stand on every corner and evenly between, exactly as many as there are', () => {
    const angle = line([0, 2], [0, 0], [1, 0]);
    const { places, gap } = placesAlong([angle], 7)!;
    expect(places).toHaveLength(7);
    expect(gap).toBeCloseTo(0.5);
    for (const [x, y] of [
      [0, 0],
      [0, 2],
      [1, 0],
      [0, 1.5],
      [0.5, 0],
    ])
      expect(places.some((p) => Math.hypot(p.x - x!, p.y - y!) < 1e-9)).toBe(true);
    expect(placesAlong([angle], 2)).toBeNull();
  });

  it('keep apart where lines cross', () => {
    const cross = [line([0, 0], [1, 1]), line([0, 1.02], [1, -0.02])];
    const { places, gap } = placesApart(cross, 23)!;
    expect(places).toHaveLength(23);
    expect(leastDistance(places)).toBeGreaterThan(0.55 * gap);
  });
});

/** Letters of five by seven dots, as on displays of that kind. */
const kDisplay: Readonly<Record<string, string>> = {
  E: '11111 10000 10000 11110 10000 10000 11111',
  F: '11111 10000 10000 11110 10000 10000 10000',
  H: '10001 10001 10001 11111 10001 10001 10001',
  T: '11111 00100 00100 00100 00100 00100 00100',
};
const dots = (rows: string): GroundPoint[] =>
  rows.split(' ').flatMap((row, j) => [...row].flatMap((on, i) => (on === '1' ? [{ x: i / 6, y: 1 - j / 6 }] : [])));

describe('legibility', () => {
  const draw = (char: string): LetterDrawn => {
    const { places, gap } = placesAlong(strokeLetters(char)![0]!.strokes, 300)!;
    return { samples: places, step: gap, dots: [] };
  };
  const reader = new LetterReader(draw, [...'ABCDEFGHIJKLMNOPQRSTUVWXYZ']);

  it('reads letters of a display, each as itself and none as another', () => {
    for (const char of Object.keys(kDisplay)) {
      const places = dots(kDisplay[char]!);
      expect(reader.read([{ char, places }], 1 / 6), char).toMatchObject({ reads: true, unread: [] });
      for (const other of 'EFHTLMOI'.replace(char, ''))
        expect(reader.read([{ char: other, places }], 1 / 6).reads, `${char} as ${other}`).toBe(false);
    }
  });

  it('reads neither what lacks a stroke, nor dots too far apart, nor a heap', () => {
    const lacks = dots(kDisplay['E']!).filter(({ y }) => y > 0);
    expect(reader.read([{ char: 'E', places: lacks }], 1 / 6).reads).toBe(false);
    const corners = placesAlong(strokeLetters('M')![0]!.strokes, 7)!;
    expect(reader.read([{ char: 'M', places: corners.places }], corners.gap).reads).toBe(false);
    const heap = Array.from({ length: 30 }, (_, i) => ({ x: (i % 5) / 6, y: Math.floor(i / 5) / 6 }));
    expect(reader.read([{ char: 'E', places: heap }], 1 / 6).reads).toBe(false);
    expect(reader.read([{ char: 'E', places: [] }], 1 / 6)).toEqual({ reads: false, share: 0, unread: ['E'] });
  });
});

describe('words', () => {
  it('are read with enough people and not with few', () => {
    const enough = peopleFor('MUSTER');
    expect(enough).toBeGreaterThan(60);
    expect(enough).toBeLessThan(120);
    expect(strokeWords('MUSTER', enough)!.legibility.reads).toBe(true);
    expect(strokeWords('MUSTER', 49)!.legibility.reads).toBe(false);
    expect(strokeWords('MUSTER', 120)!.places).toHaveLength(120);
    expect(peopleFor('I')).toBeLessThan(15);
  });

  it('has every sign of the font, each read with forty people', () => {
    for (const char of kStrokeChars.filter((one) => !'.:,;'.includes(one)))
      expect(strokeWords(char, 40)?.legibility.unread, char).toEqual([]);
  });

  it('writes lower case in capitals, signs above letters, and nothing that it has no drawing of', () => {
    const [small, large] = [strokeWords('grüße', 150)!, strokeWords('GRÜSSE', 150)!];
    expect(small).toEqual(large);
    expect(large.legibility.reads).toBe(true);
    const [plain, marked] = [strokeLetters('U')![0]!, strokeLetters('Ü')![0]!];
    expect(marked.strokes).toHaveLength(plain.strokes.length + 2);
    expect(strokeWords('東京', 200)).toBeNull();
    expect(strokeWords(' ', 20)).toBeNull();
    expect(peopleFor('東京')).toBe(0);
    expect(strokeWords('MUSTER', 9)).toBeNull();
  });

  it('leaves nobody too near to another', () => {
    for (const words of ['ABCDEFGHIJKLM', 'NOPQRSTUVWXYZ', '0123456789', '?!&:;()"\'=+-/']) {
      const { places, gap } = strokeWords(words, 26 * words.length)!;
      expect(leastDistance(places) / gap, words).toBeGreaterThan(0.6);
    }
  });
});
