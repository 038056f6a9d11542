import { describe, expect, it } from 'vitest';
import { areaOf } from '../outline';
import { readGeoJson } from './geojson';
import { footOf, heightOf, lengthOf } from './heights';
import { leftOutText } from './left_out';
import { localMetres } from './local_metres';
import { boundsOfOutlines } from './place';

const feature = (type: string, coordinates: unknown, properties: object = {}) => ({
  type: 'Feature',
  properties,
  geometry: { type, coordinates },
});
const collection = (...features: object[]): string => JSON.stringify({ type: 'FeatureCollection', features });
const square = (x: number, y: number, size: number): number[][] => [
  [x, y],
  [x + size, y],
  [x + size, y + size],
  [x, y + size],
  [x, y],
];

describe('longitude and latitude', () => {
  /** Radii of curvature of WGS84 [m]. */
  const curvature = (latitude: number) => {
    const [a, e2] = [6378137, 0.00669437999014];
    const w = Math.sqrt(1 - e2 * Math.sin((latitude * Math.PI) / 180) ** 2);
    return { north: (a * (1 - e2)) / w ** 3, across: a / w };
  };

  it.each([0, 35, 52.5, -33.9, 68])('within 2 km of latitude %s are right to a ten thousandth', (latitude) => {
    const project = localMetres({ x: 13.4, y: latitude });
    const { north, across } = curvature(latitude);
    const radians = Math.PI / 180;
    // Arcs of a kilometre along the meridian and the parallel.
    const dy = 1000 / north / radians;
    const dx = 1000 / (across * Math.cos(latitude * radians)) / radians;
    const [up, right] = [project({ x: 13.4, y: latitude + dy }), project({ x: 13.4 + dx, y: latitude })];
    expect(Math.abs(Math.hypot(up.x, up.y) / 1000 - 1)).toBeLessThan(1e-5);
    expect(Math.abs(Math.hypot(right.x, right.y) / 1000 - 1)).toBeLessThan(1e-5);
    // A length away from the middle, too.
    const above = curvature(latitude + dy);
    const [a, b] = [project({ x: 13.4, y: latitude + dy }), project({ x: 13.4 + dx, y: latitude + dy })];
    const arc = dx * radians * above.across * Math.cos((latitude + dy) * radians);
    expect(Math.abs(Math.hypot(b.x - a.x, b.y - a.y) / arc - 1)).toBeLessThan(1e-5);
  });

  it('of a known pair of towers give their distance', () => {
    // Two trigonometric points of Flinders Peak and Buninyong are too far apart; a pair at 60 degrees north, 0.01 degrees apart.
    const project = localMetres({ x: 10, y: 60 });
    const b = project({ x: 10.01, y: 60 });
    // cos(60°) × N(60°) × 0.01° = 558.0 m.
    expect(b.x).toBeCloseTo(558.0, 1);
    expect(b.y).toBeCloseTo(0.042, 2);
  });
});

describe('heights', () => {
  it.each([
    [12, 12],
    ['12 m', 12],
    ['12,5', 12.5],
    ['~9', 9],
    ["40'", 12.192],
    ['40 ft', 12.192],
    ['5\'10"', 1.778],
    ['350 cm', 3.5],
    ['tall', null],
    [null, null],
    [Infinity, null],
  ])('%s is %s m', (said, metres) => {
    if (metres === null) expect(lengthOf(said)).toBeNull();
    else expect(lengthOf(said)).toBeCloseTo(metres, 9);
  });

  it('are read from all that maps call them', () => {
    expect(heightOf({ 'building:height': '7 m' })).toBe(7);
    expect(heightOf({ render_height: 20, levels: 3 })).toBe(20);
    expect(heightOf({ 'building:levels': '4' })).toBe(12);
    expect(heightOf({ height: '0', name: 'x' })).toBeNull();
    expect(footOf({ min_height: '3 m' })).toBe(3);
    expect(footOf({ 'building:min_level': 2 })).toBe(6);
  });
});

describe('GeoJSON', () => {
  it('becomes buildings with heights and names, in metres about the middle', () => {
    const { outlines, left, total, geographic, withoutHeight } = readGeoJson(
      collection(
        feature('Polygon', [square(13.4, 52.5, 0.001)], { building: 'yes', height: '12 m', name: 'Town hall' }),
        feature('MultiPolygon', [[square(13.402, 52.5, 0.001)], [square(13.404, 52.5, 0.001)]], {
          'addr:street': 'Main',
          'addr:housenumber': '7',
        }),
      ),
      'town.geojson',
    );
    expect(geographic).toBe(true);
    expect([outlines.length, total, withoutHeight]).toEqual([3, 3, 2]);
    expect(left).toEqual({});
    expect(outlines[0]).toMatchObject({ name: 'Town hall', height: 12 });
    expect(outlines[1]).toMatchObject({ name: 'Main 7', height: 6 });
    // A thousandth of a degree is 67.9 m by 111.3 m there.
    expect(areaOf(outlines[0]!.corners)).toBeCloseTo(67.9 * 111.27, -2);
    const { min, max } = boundsOfOutlines(outlines)!;
    expect(min.x + max.x).toBeCloseTo(0, 1);
    expect(min.y + max.y).toBeCloseTo(0, 1);
    expect(max.x - min.x).toBeCloseTo(5 * 67.9, 0);
  });

  it('may be in metres, and the web’s Mercator is shrunk', () => {
    const plain = readGeoJson(collection(feature('Polygon', [square(391000, 5820000, 10)])), 'a');
    expect(plain.geographic).toBe(false);
    expect(areaOf(plain.outlines[0]!.corners)).toBeCloseTo(100, 6);
    const crs = { type: 'name', properties: { name: 'urn:ogc:def:crs:EPSG::3857' } };
    // At 60 degrees north, where it stretches lengths twice.
    const y = 6378137 * Math.log(Math.tan(Math.PI / 4 + Math.PI / 6));
    const web = { ...feature('Polygon', [square(0, y - 10, 20)]), crs };
    expect(areaOf(readGeoJson(JSON.stringify(web), 'a').outlines[0]!.corners)).toBeCloseTo(100, 1);
  });

  it('on both sides of the date line stays together', () => {
    const { outlines } = readGeoJson(
      collection(feature('Polygon', [square(179.999, 0, 0.0005)]), feature('Polygon', [square(-179.999, 0, 0.0005)])),
      'a',
    );
    const { min, max } = boundsOfOutlines(outlines)!;
    expect(max.x - min.x).toBeCloseTo(0.0025 * 111319.5, 0);
  });

  it('counts what it leaves out', () => {
    const { outlines, left, total } = readGeoJson(
      collection(
        feature('Polygon', [
          [
            [0, 0],
            [1000, 1000],
            [1000, 0],
            [0, 1000],
            [0, 0],
          ],
        ]),
        feature('Polygon', [
          [
            [0, 0],
            [1000, null],
            [1000, 0],
          ],
        ]),
        feature('Polygon', [
          [
            [0, 0],
            [5, 0],
            [0, 0],
          ],
        ]),
        feature('Polygon', [square(0, 0, 20)], { building: 'roof', min_height: 4 }),
        feature('Polygon', [square(0, 0, 20)], { building: 'yes', layer: '-1' }),
        feature('Polygon', [square(0, 0, 900)], { landuse: 'grass' }),
        feature(
          'LineString',
          [
            [0, 0],
            [100, 0],
          ],
          { highway: 'primary' },
        ),
        feature(
          'LineString',
          [
            [0, 0],
            [100, 0],
          ],
          { barrier: 'wall', height: 1.2 },
        ),
        feature('Point', [0, 0]),
      ),
      'a',
    );
    expect(total).toBe(8);
    expect(left).toEqual({ crosses: 1, numbers: 1, flat: 1, above: 1, below: 1, other: 2 });
    expect(outlines).toHaveLength(1);
    expect(outlines[0]).toMatchObject({ height: 1.2 });
    expect(areaOf(outlines[0]!.corners)).toBeCloseTo(30, 6);
    expect(leftOutText({ crosses: 3 }, 812)).toBe('3 of 812 outlines were left out: they cross themselves.');
    expect(leftOutText({ flat: 1 }, 2)).toBe('1 of 2 outlines was left out: it encloses no ground.');
    expect(leftOutText({ crosses: 3, other: 1 }, 1812)).toBe(
      '4 of 1,812 outlines were left out: 3 cross themselves, 1 is no building, wall or water.',
    );
    expect(leftOutText({}, 3)).toBe('');
  });

  it('keeps courtyards open', () => {
    const { outlines } = readGeoJson(
      collection(feature('Polygon', [square(1000, 1000, 40), square(1010, 1010, 20).reverse()])),
      'a',
    );
    expect(outlines.reduce((sum, { corners }) => sum + areaOf(corners), 0)).toBeCloseTo(1600 - 400, 1);
  });

  it.each([
    ['{"type": "FeatureCollection", ', '“a.json” cannot be read: it is no whole JSON file.'],
    ['[1, 2]', '“a.json” is no GeoJSON: it has no type.'],
    [
      '{"type": "FeatureCollection", "features": [null, 3, {"type": "Feature", "geometry": null}]}',
      '“a.json” holds no polygons and no lines.',
    ],
    ['{"type": "Point", "coordinates": [1, 2]}', '“a.json” holds no polygons and no lines.'],
  ])('that is bad gets one sentence: %s', (text, sentence) => {
    expect(() => readGeoJson(text, 'a.json')).toThrow(sentence);
  });
});
