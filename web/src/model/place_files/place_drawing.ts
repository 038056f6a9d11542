// A place seen from above, as paths of an SVG whose y grows downwards.

import type { GroupDef, ObstacleDef, Point } from '../../protocol/generated/definitions';
import { colourNumber } from '../accent';
import { kGroupRoom } from './group_room';
import { boundsOf, type PlaceDefinition } from './place';

export interface PlaceDrawing {
  /** Left, top, width, height [m]. */
  readonly viewBox: readonly [number, number, number, number];
  readonly obstacles: string;
  /** With exits, sources and waiting areas. */
  readonly patches: string;
  /** One for each group, in the order of the accents. */
  readonly groups: readonly string[];
  /** The colour number of each. */
  readonly colours: readonly number[];
}

/** A number that takes few letters. */
const short = (value: number): string => String(Math.round(value * 100) / 100);

function polygonPath(points: readonly Point[]): string {
  return `M${points.map(([x, y]) => `${short(x)} ${short(-y)}`).join('L')}Z`;
}

function discPath([x, y]: Point, radius: number): string {
  const r = short(radius);
  return `M${short(x - radius)} ${short(-y)}a${r} ${r} 0 1 0 ${short(2 * radius)} 0a${r} ${r} 0 1 0 ${short(-2 * radius)} 0Z`;
}

export function obstaclePath({ polygon, centre = [0, 0], radius = 0 }: ObstacleDef): string {
  return polygon && polygon.length >= 3 ? polygonPath(polygon) : radius > 0 ? discPath(centre, radius) : '';
}

/** Blocked cells of a map, as strips. */
function mapPath({ map }: PlaceDefinition): string {
  if (!map?.rows) return '';
  const size = map.metresPerCell ?? 1;
  const [left, bottom] = map.origin ?? [0, 0];
  const { rows } = map;
  const strips: string[] = [];
  rows.forEach((row, i) => {
    const y = -(bottom + (rows.length - i) * size);
    for (const strip of row.matchAll(/[^.GS]+/g))
      strips.push(
        `M${short(left + strip.index * size)} ${short(y)}h${short(strip[0].length * size)}v${short(size)}h${short(-strip[0].length * size)}Z`,
      );
  });
  return strips.join('');
}

/** Of a group whose count a scenario leaves out. */
const kUsualCount = 36;

/** About as large as the group stands. */
function groupPath(group: GroupDef): string {
  const [x, y] = group.position ?? [0, 0];
  const formation = group.formation ?? 'square';
  const [kind, spacing] = typeof formation === 'string' ? [formation, 1] : [formation.kind, formation.spacing ?? 1];
  const [ahead, aside] = (kGroupRoom[kind ?? 'square'] ?? kGroupRoom['square']!)(group.count ?? kUsualCount);
  const [c, s] = [Math.cos(group.angle ?? 0), Math.sin(group.angle ?? 0)];
  const corners = [
    [1, 1],
    [-1, 1],
    [-1, -1],
    [1, -1],
  ].map(([a, b]): Point => {
    const [u, v] = [(a! * ahead * spacing) / 2, (b! * aside * spacing) / 2];
    return [x + c * u - s * v, y + s * u + c * v];
  });
  return polygonPath(corners);
}

/** The place's box, else its map's, else what stands in it. */
export function boxOf(place: PlaceDefinition): readonly [Point, Point] {
  if (place.box) return place.box;
  const { rows, metresPerCell = 1, origin = [0, 0] } = place.map ?? {};
  if (rows?.length)
    return [origin, [origin[0] + (rows[0]?.length ?? 0) * metresPerCell, origin[1] + rows.length * metresPerCell]];
  const corners = (place.obstacles ?? []).flatMap(({ polygon }) => (polygon ?? []).map(([x, y]) => ({ x, y })));
  const bounds = boundsOf(corners);
  if (!bounds)
    return [
      [-16, -16],
      [16, 16],
    ];
  return [
    [bounds.min.x, bounds.min.y],
    [bounds.max.x, bounds.max.y],
  ];
}

export function drawingOf(place: PlaceDefinition): PlaceDrawing {
  const [[left, bottom], [right, top]] = boxOf(place);
  return {
    viewBox: [left, -top, right - left, top - bottom],
    obstacles: mapPath(place) + (place.obstacles ?? []).map(obstaclePath).join(''),
    patches: [...(place.patches ?? []), ...(place.areas ?? [])].map(({ polygon }) => polygonPath(polygon)).join(''),
    groups: (place.groups ?? []).map(groupPath),
    colours: (place.groups ?? []).map(({ colour }, i) => colourNumber(i, colour)),
  };
}

/** "64 × 48 m, 12 obstacles, 80 people". */
export function factsOf(place: PlaceDefinition): string {
  const [[left, bottom], [right, top]] = boxOf(place);
  const metres = (value: number): string => Math.round(value).toLocaleString('en');
  const number = (value: number, one: string, more: string): string =>
    `${value.toLocaleString('en')} ${value === 1 ? one : more}`;
  const people = (place.groups ?? []).reduce((sum, { count = kUsualCount }) => sum + count, 0);
  const parts = [`${metres(right - left)} × ${metres(top - bottom)} m`];
  const obstacles = place.obstacles?.length ?? 0;
  if (obstacles > 0) parts.push(number(obstacles, 'obstacle', 'obstacles'));
  if (people > 0) parts.push(number(people, 'person', 'people'));
  return parts.join(' · ');
}
