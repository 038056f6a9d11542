// GeoJSON (RFC 7946) as obstacles and water: polygons are buildings or water, lines are walls.

import type { GroundPoint } from '../plane';
import { withoutCourtyards } from './courtyards';
import { footOf, heightOf, type Properties } from './heights';
import { count, type LeftOut } from './left_out';
import { localMetres, mercatorStretch } from './local_metres';
import { boundsOf, FileProblem, kMostObstacles, type Outline } from './place';
import { mendedRing, type Ring } from './rings';
import { wallsAlong } from './walls';

export interface GeoOptions {
  /** Of what says nothing of its height, and of walls [m]. */
  readonly usualHeight: number;
  readonly wallWidth: number;
}

export const kUsualGeoOptions: GeoOptions = { usualHeight: 6, wallWidth: 0.3 };

export interface GeoReading {
  /** In metres, to the east and to the north of the data's middle. */
  readonly outlines: readonly Outline[];
  readonly left: LeftOut;
  /** Polygons and lines that were found. */
  readonly total: number;
  /** They were longitudes and latitudes. */
  readonly geographic: boolean;
  /** So many outlines said nothing of their height. */
  readonly withoutHeight: number;
}

interface Shape {
  readonly kind: 'polygon' | 'line';
  readonly rings: readonly Ring[];
  readonly properties: Properties;
}

/** Begins higher than this: people pass below [m]. */
const kHeadroom = 2;
const kWallHeight = 2;
/** What OpenStreetMap says of things that are in nobody's way. */
const kNoObstacle = [
  'highway',
  'railway',
  'waterway',
  'landuse',
  'leisure',
  'natural',
  'boundary',
  'place',
  'route',
  'power',
  'amenity',
  'area:highway',
];
/** What OpenStreetMap calls water. */
const kWater: Readonly<Record<string, readonly string[]>> = {
  natural: ['water', 'bay'],
  waterway: ['riverbank', 'dock'],
  landuse: ['reservoir', 'basin'],
  leisure: ['swimming_pool'],
};
const kObstacle = ['building', 'building:part', 'barrier', 'wall', 'man_made'];

const isRecord = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

function pointOf(value: unknown): GroundPoint {
  const [x, y] = Array.isArray(value) ? (value as unknown[]) : [];
  return { x: typeof x === 'number' ? x : NaN, y: typeof y === 'number' ? y : NaN };
}

const ringOf = (value: unknown): Ring => (Array.isArray(value) ? value.map(pointOf) : []);
const listOf = (value: unknown): readonly unknown[] => (Array.isArray(value) ? (value as unknown[]) : []);

function shapesOf(geometry: unknown, properties: Properties): Shape[] {
  if (!isRecord(geometry)) return [];
  const { type, coordinates } = geometry;
  const polygon = (one: unknown): Shape => ({ kind: 'polygon', rings: listOf(one).map(ringOf), properties });
  const line = (one: unknown): Shape => ({ kind: 'line', rings: [ringOf(one)], properties });
  switch (type) {
    case 'Polygon':
      return [polygon(coordinates)];
    case 'MultiPolygon':
      return listOf(coordinates).map(polygon);
    case 'LineString':
      return [line(coordinates)];
    case 'MultiLineString':
      return listOf(coordinates).map(line);
    case 'GeometryCollection':
      return listOf(geometry['geometries']).flatMap((one) => shapesOf(one, properties));
    case 'Feature':
      return shapesOf(geometry['geometry'], isRecord(geometry['properties']) ? geometry['properties'] : {});
    case 'FeatureCollection':
      return listOf(geometry['features']).flatMap((one) => shapesOf(one, properties));
    default:
      return [];
  }
}

/** What the file says of its coordinates, as "EPSG::3857"; empty for longitude and latitude. */
function crsOf(root: Record<string, unknown>): string {
  const crs = root['crs'];
  const name = isRecord(crs) && isRecord(crs['properties']) ? crs['properties']['name'] : '';
  const text = typeof name === 'string' ? name : '';
  return /CRS84|EPSG:*(4326|4258)$/i.test(text) ? '' : text;
}

interface Projection {
  readonly geographic: boolean;
  readonly toMetres: (point: GroundPoint) => GroundPoint;
}

function projectionOf(root: Record<string, unknown>, shapes: readonly Shape[]): Projection {
  const points = function* (): Iterable<GroundPoint> {
    for (const { rings } of shapes)
      for (const ring of rings) for (const p of ring) if (Number.isFinite(p.x) && Number.isFinite(p.y)) yield p;
  };
  const bounds = boundsOf(points());
  if (!bounds) return { geographic: false, toMetres: (p) => p };
  const { min, max } = bounds;
  const middle = { x: (min.x + max.x) / 2, y: (min.y + max.y) / 2 };
  const crs = crsOf(root);
  if (crs === '' && min.x >= -180 && max.x <= 180 && min.y >= -90 && max.y <= 90) {
    // Data on both sides of the date line: half of them go once round.
    const wraps = max.x - min.x > 180;
    const unwrapped = (p: GroundPoint): GroundPoint => (wraps && p.x < 0 ? { x: p.x + 360, y: p.y } : p);
    const xs = boundsOf([...points()].map(unwrapped))!;
    const project = localMetres({ x: (xs.min.x + xs.max.x) / 2, y: middle.y });
    return { geographic: true, toMetres: (p) => project(unwrapped(p)) };
  }
  const stretch = /3857|900913|102100/.test(crs) ? mercatorStretch(middle.y) : 1;
  return {
    geographic: false,
    toMetres: ({ x, y }) => ({ x: (x - middle.x) / stretch, y: (y - middle.y) / stretch }),
  };
}

function isWater({ kind, properties }: Shape): boolean {
  return kind === 'polygon' && Object.entries(kWater).some(([key, words]) => words.includes(String(properties[key])));
}

function isObstacle({ kind, properties }: Shape): boolean {
  const says = (key: string): boolean =>
    properties[key] !== undefined && properties[key] !== null && properties[key] !== 'no';
  if (kObstacle.some(says)) return true;
  if (kind === 'polygon' && heightOf(properties) !== null) return true;
  return !kNoObstacle.some(says);
}

function liesBelow(properties: Properties): boolean {
  return Number(properties['layer'] ?? 0) < 0 || properties['location'] === 'underground';
}

function nameOf(properties: Properties): string {
  const house = [properties['addr:street'], properties['addr:housenumber']].filter((one) => typeof one === 'string');
  const name = [properties['name'], properties['Name'], properties['addr:housename']].find(
    (one) => typeof one === 'string',
  );
  return name ?? house.join(' ');
}

/** Outlines of one shape, or why it is none. */
function outlinesOf(
  shape: Shape,
  toMetres: Projection['toMetres'],
  options: GeoOptions,
): readonly Ring[] | keyof LeftOut {
  if (!isWater(shape) && !isObstacle(shape)) return 'other';
  if (liesBelow(shape.properties)) return 'below';
  if (footOf(shape.properties) >= kHeadroom) return 'above';
  const [outer, ...holes] = shape.rings.map((ring) => ring.map(toMetres));
  if (!outer) return 'flat';
  if (shape.kind === 'line') {
    if (!outer.every(({ x, y }) => Number.isFinite(x) && Number.isFinite(y))) return 'numbers';
    const walls = wallsAlong(outer, options.wallWidth);
    return walls.length > 0 ? walls : 'flat';
  }
  const mended = mendedRing(outer);
  if (typeof mended === 'string' || holes.length === 0 || mended.length > 1) return mended;
  // Courtyards that cannot be mended are filled.
  const yards = holes.flatMap((hole) => {
    const ring = mendedRing(hole);
    return typeof ring === 'string' ? [] : ring;
  });
  return withoutCourtyards(mended[0]!, yards) ?? mended;
}

function parsed(text: string, file: string): Record<string, unknown> {
  let root: unknown;
  try {
    root = JSON.parse(text.replace(/^\uFEFF/, ''));
  } catch {
    throw new FileProblem(`“${file}” cannot be read: it is no whole JSON file.`);
  }
  if (!isRecord(root) || typeof root['type'] !== 'string')
    throw new FileProblem(`“${file}” is no GeoJSON: it has no type.`);
  return root;
}

/** Nearest to the middle first, as many as a place holds. */
function most(outlines: Outline[], left: LeftOut): Outline[] {
  if (outlines.length <= kMostObstacles) return outlines;
  const away = ({ corners }: Outline): number => Math.hypot(corners[0]!.x, corners[0]!.y);
  count(left, 'many', outlines.length - kMostObstacles);
  return outlines.sort((a, b) => away(a) - away(b)).slice(0, kMostObstacles);
}

/** Reads GeoJSON; throws a FileProblem where there is nothing to use. */
export function readGeoJson(text: string, file: string, options: GeoOptions = kUsualGeoOptions): GeoReading {
  const root = parsed(text, file);
  const shapes = shapesOf(root, {});
  if (shapes.length === 0) throw new FileProblem(`“${file}” holds no polygons and no lines.`);
  const { geographic, toMetres } = projectionOf(root, shapes);
  const left: LeftOut = {};
  const outlines: Outline[] = [];
  let withoutHeight = 0;
  for (const shape of shapes) {
    const found = outlinesOf(shape, toMetres, options);
    if (typeof found === 'string') {
      count(left, found);
      continue;
    }
    const height = heightOf(shape.properties);
    const water = isWater(shape);
    if (height === null && !water) withoutHeight += 1;
    const usual = shape.kind === 'line' ? kWallHeight : options.usualHeight;
    for (const corners of found)
      outlines.push({ name: nameOf(shape.properties), height: height ?? usual, corners, ...(water ? { water } : {}) });
  }
  return { outlines: most(outlines, left), left, total: shapes.length, geographic, withoutHeight };
}
