// MovingAI maps: rows of letters for cells. A place embeds them.

import type { GroupDef, PatchDef, Point } from '../../protocol/generated/definitions';
import { largestRegion, roomiest, roomOf } from './free_ground';
import { kSwim } from './new_place';
import { FileProblem, toMillimetre, type PlaceDefinition } from './place';

export interface GridMap {
  readonly width: number;
  readonly height: number;
  /** The top row first. */
  readonly rows: readonly string[];
  /** Cells on which people stand: ground and swamp. */
  readonly free: number;
}

/** Cells on a side, at most. */
const kMostSide = 4096;
/** Cells of the ground that a scenario takes, at most. */
const kMostGround = 16e6;
const kStanding = '.GS';

function numberAfter(word: string, line: string | undefined, number: number, file: string): number {
  const found = new RegExp(`^${word}\\s+(\\d+)\\s*$`).exec(line ?? '');
  const value = Number(found?.[1]);
  if (!found || value < 1 || value > kMostSide)
    throw new FileProblem(`“${file}” is broken in line ${number}: there should be “${word}” and a number up to 4,096.`);
  return value;
}

/** Throws a FileProblem. */
export function readGridMap(text: string, file: string): GridMap {
  const lines = text.replace(/\r/g, '').split('\n');
  if (!/^type\s+\w+/.test(lines[0] ?? '')) throw new FileProblem(`“${file}” is no grid map: it begins with no type.`);
  const height = numberAfter('height', lines[1], 2, file);
  const width = numberAfter('width', lines[2], 3, file);
  if (lines[3]?.trim() !== 'map') throw new FileProblem(`“${file}” is broken in line 4: there should be “map”.`);
  const rows = lines.slice(4, 4 + height);
  rows.forEach((row, i) => {
    if (row.length !== width || !/^[.G@OTSW]*$/.test(row))
      throw new FileProblem(`“${file}” is broken in line ${5 + i}: a row has ${width} of the letters . G @ O T S W.`);
  });
  if (rows.length < height) throw new FileProblem(`“${file}” ends after ${rows.length} of ${height} rows.`);
  const free = rows.reduce((sum, row) => sum + [...row].filter((one) => kStanding.includes(one)).length, 0);
  if (free === 0) throw new FileProblem(`“${file}” has no ground on which people could stand.`);
  return { width, height, rows, free };
}

/** Water, in which people swim, as strips of cells as high as they are alike. */
function watersOf({ rows, height }: GridMap, metresPerCell: number): PatchDef[] {
  const open = new Map<string, { readonly from: number; readonly to: number; readonly top: number }>();
  const found: PatchDef[] = [];
  const metres = (cells: number): number => toMillimetre(cells * metresPerCell);
  for (let y = 0; y <= height; ++y) {
    const here = [...(rows[y] ?? '').matchAll(/W+/g)].map(({ index, 0: run }) => `${index} ${index + run.length}`);
    for (const [key, { from, to, top }] of open) {
      if (here.includes(key)) continue;
      open.delete(key);
      const [left, right, low, high] = [metres(from), metres(to), metres(height - y), metres(height - top)];
      const polygon = [
        [left, low],
        [right, low],
        [right, high],
        [left, high],
      ] as const;
      found.push({ name: 'Water', polygon, motion: kSwim });
    }
    for (const key of here) {
      const [from, to] = key.split(' ').map(Number) as [number, number];
      if (!open.has(key)) open.set(key, { from, to, top: y });
    }
  }
  return found;
}

/** Distance between people, and of people from walls [m]. */
const kApart = { people: 1, walls: 0.3 };

/** A crowd where there is most room: in a square where that has room, else on free ground round about, as many as find some. */
function crowdOf({ width, height, rows }: GridMap, metresPerCell: number, people: number): GroupDef {
  const blocked = rows.flatMap((row) => Array.from(row, (one) => (kStanding.includes(one) ? 0 : 1)));
  const room = roomOf(largestRegion(blocked, width, height), width, height);
  const found = roomiest(room, width, Math.sqrt(people) / 2 / metresPerCell + 1)!;
  const spot = (column: number, row: number): Point => [
    toMillimetre((column + 0.5) * metresPerCell),
    toMillimetre((height - row - 0.5) * metresPerCell),
  ];
  const position = spot(found.column, found.row);
  const group = { name: 'Crowd', position, angle: 0 };
  const free = (2 * found.room - 1) * metresPerCell - 2 * kApart.walls;
  const abreast = Math.max(1, Math.floor(free / kApart.people) + 1);
  if (abreast * abreast >= people) return { ...group, count: people, formation: 'square' };
  const step = Math.ceil(kApart.people / metresPerCell);
  const cells: Point[] = [];
  room.forEach((own, i) => {
    const [column, row] = [i % width, Math.floor(i / width)];
    const onStep = (column - found.column) % step === 0 && (row - found.row) % step === 0;
    if (onStep && (own - 0.5) * metresPerCell >= kApart.walls) cells.push(spot(column, row));
  });
  const local = cells.map(([x, y]): Point => [toMillimetre(x - position[0]), toMillimetre(y - position[1])]);
  const points = local.sort((a, b) => Math.hypot(...a) - Math.hypot(...b)).slice(0, people);
  if (points.length <= abreast * abreast) return { ...group, count: abreast * abreast, formation: 'square' };
  return { ...group, count: points.length, formation: { kind: 'points', points } };
}

/** A place on a map whose cells have an edge [m]. */
export function placeOfMap(map: GridMap, name: string, metresPerCell: number, people: number): PlaceDefinition {
  const { width, height, rows } = map;
  const usual = Math.min(0.5, Math.max(0.25, metresPerCell / 2));
  const least = metresPerCell * Math.sqrt((width * height) / kMostGround);
  const patches = watersOf(map, metresPerCell);
  return {
    format: 'muster-scenario',
    version: 1,
    name,
    // People swim through water: it is ground with that motion.
    map: { metresPerCell, origin: [0, 0], rows: rows.map((row) => row.replaceAll('W', '.')) },
    cell: toMillimetre(Math.max(usual, 1.01 * least)),
    ...(patches.length > 0 ? { patches } : {}),
    groups: [crowdOf(map, metresPerCell, people)],
  };
}
