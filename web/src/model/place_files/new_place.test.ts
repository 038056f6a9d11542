import { describe, expect, it } from 'vitest';
import { encodeClient } from '../../protocol/encoding';
import { insidePolygon } from '../plane';
import { largestRegion, roomOf, startFor } from './free_ground';
import { placeOfMap, readGridMap } from './grid_map';
import { additionOf, cellFor, kMostBytes, placeAround, within } from './new_place';
import { obstacleOf, placedOutlines, type Outline } from './place';
import { drawingOf, factsOf } from './place_drawing';

const square = (x: number, y: number, size: number, name = ''): Outline => ({
  name,
  height: 5,
  corners: [
    { x, y },
    { x: x + size, y },
    { x: x + size, y: y + size },
    { x, y: y + size },
  ],
});

describe('a new place', () => {
  it('has room around what was imported, and people on free ground', () => {
    const outlines = [square(0, 0, 40), square(60, 0, 40)];
    const place = placeAround(outlines, { name: 'Town', description: 'x', people: 36 });
    expect(place.box).toEqual([
      [-8, -8],
      [108, 48],
    ]);
    expect(place.cell).toBe(0.25);
    const [x, y] = place.groups![0]!.position!;
    expect(outlines.some(({ corners }) => insidePolygon({ x, y }, corners))).toBe(false);
    expect(Math.abs(x - 50)).toBeLessThan(7);
    expect(factsOf(place)).toBe('116 × 56 m · 2 obstacles · 36 people');
  });

  it('has cells as large as its size wants', () => {
    expect(cellFor(100, 100)).toBe(0.25);
    expect(cellFor(1000, 1000)).toBe(0.5);
    const cell = cellFor(10000, 10000);
    expect(1e8 / cell ** 2).toBeLessThan(16e6);
  });

  it('is scaled and turned about its middle', () => {
    const [one] = placedOutlines([square(10, 10, 2)], { scale: 3, turn: Math.PI / 2, at: { x: 1, y: 0 } });
    expect(obstacleOf(one!)).toEqual({
      name: '',
      height: 15,
      polygon: [
        [4, -3],
        [4, 3],
        [-2, 3],
        [-2, -3],
      ],
    });
  });
});

describe('what is added', () => {
  it('comes in messages of 256 commands and 256 KiB at most, with one gesture', () => {
    const many = Array.from({ length: 600 }, (_, i) => obstacleOf(square(i, 0, 1)));
    const messages = additionOf(many, 'Import town', 77);
    expect(messages.map(({ commands }) => commands.length)).toEqual([256, 256, 88]);
    expect(new Set(messages.map(({ gesture, label }) => `${gesture} ${label}`))).toEqual(new Set(['77 Import town']));
    expect(messages[2]!.commands[0]!.kind).toBe('putThing');
    const round = Array.from({ length: 3000 }, (_, i) => ({ x: 1000 * Math.cos(i), y: 1000 * Math.sin(i) }));
    const large = Array.from({ length: 9 }, () => obstacleOf({ name: 'Ü'.repeat(90), height: 3, corners: round }));
    const sizes = additionOf(large, 'x', 1).map((message) => encodeClient(message).byteLength);
    expect(sizes.length).toBeGreaterThan(1);
    expect(Math.max(...sizes)).toBeLessThanOrEqual(kMostBytes + 32);
    expect(additionOf([], 'x', 1)).toEqual([]);
  });

  it('leaves out what lies outside', () => {
    const left = {};
    const box = { min: { x: 0, y: 0 }, max: { x: 10, y: 10 } };
    expect(within([square(9, 9, 5), square(20, 0, 5)], box, left)).toHaveLength(1);
    expect(left).toEqual({ outside: 1 });
  });
});

describe('free ground', () => {
  it('is measured in cells to what blocks it', () => {
    const blocked = new Uint8Array(49);
    blocked[0] = 1;
    const room = roomOf(blocked, 7, 7);
    expect([room[0], room[8], room[24], room[48], room[16]]).toEqual([0, 1, 3, 1, 2]);
  });

  it('is never that of a closed courtyard', () => {
    const box = { min: { x: 0, y: 0 }, max: { x: 40, y: 40 } };
    const sides = [
      [10, 10, 20, 2],
      [10, 28, 20, 2],
      [10, 10, 2, 20],
      [28, 10, 2, 20],
    ] as const;
    const walls = sides.map(([x, y, wide, high]) => ({
      name: '',
      height: 3,
      corners: [
        { x, y },
        { x: x + wide, y },
        { x: x + wide, y: y + high },
        { x, y: y + high },
      ],
    }));
    const { x, y } = startFor(9, box, walls);
    expect(x > 10 && x < 30 && y > 10 && y < 30).toBe(false);
    expect([...largestRegion([0, 1, 0, 1, 1, 0], 3, 2)]).toEqual([1, 1, 0, 1, 1, 0]);
    expect([...largestRegion([1, 1], 2, 1)]).toEqual([1, 1]);
  });

  it('is found in the only gap, and the middle serves where there is none', () => {
    const box = { min: { x: 0, y: 0 }, max: { x: 40, y: 20 } };
    const start = startFor(25, box, [square(0, -5, 30)]);
    expect(start.x).toBeGreaterThan(32);
    expect(startFor(25, box, [square(-10, -20, 80)])).toEqual({ x: 20, y: 10 });
  });
});

describe('a grid map', () => {
  const kMap = 'type octile\nheight 4\nwidth 6\nmap\n@@@@@@\n@....T\n@..S.@\n@@@W@@\n';

  it('becomes a place with people where there is room', () => {
    const map = readGridMap(kMap, 'a.map');
    expect(map).toMatchObject({ width: 6, height: 4, free: 8 });
    const place = placeOfMap(map, 'A', 2, 9);
    expect(place.map!.rows).toEqual(['@@@@@@', '@....T', '@..S.@', '@@@.@@']);
    expect(place.patches).toMatchObject([{ name: 'Water' }]);
    expect(place.patches![0]!.polygon).toEqual([
      [6, 0],
      [8, 0],
      [8, 2],
      [6, 2],
    ]);
    expect(place.cell).toBe(0.5);
    const [x, y] = place.groups![0]!.position!;
    expect(map.rows[Math.floor(4 - y / 2)]![Math.floor(x / 2)]).toMatch(/[.S]/);
    expect(drawingOf(place).viewBox).toEqual([0, -8, 12, 8]);
    expect(drawingOf(place).obstacles).toContain('M0 -8h12v2h-12Z');
  });

  it.each([
    ['type octile\nheight x\n', '“a.map” is broken in line 2: there should be “height” and a number up to 4,096.'],
    [
      'type octile\nheight 2\nwidth 9999\n',
      '“a.map” is broken in line 3: there should be “width” and a number up to 4,096.',
    ],
    ['type octile\nheight 1\nwidth 2\ngrid\n', '“a.map” is broken in line 4: there should be “map”.'],
    [
      'type octile\nheight 2\nwidth 3\nmap\n...\n..',
      '“a.map” is broken in line 6: a row has 3 of the letters . G @ O T S W.',
    ],
    ['type octile\nheight 2\nwidth 3\nmap\n...', '“a.map” ends after 1 of 2 rows.'],
    ['type octile\nheight 1\nwidth 3\nmap\n@@@', '“a.map” has no ground on which people could stand.'],
  ])('that is bad gets one sentence: %j', (text, sentence) => {
    expect(() => readGridMap(text, 'a.map')).toThrow(sentence);
  });
});
