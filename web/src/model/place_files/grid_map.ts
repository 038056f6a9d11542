// MovingAI maps: rows of letters for cells. A place embeds them.

import { largestRegion, roomiest, roomOf } from './free_ground';
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

/** A place on a map whose cells have an edge [m], with people where there is most room. */
export function placeOfMap(map: GridMap, name: string, metresPerCell: number, people: number): PlaceDefinition {
  const { width, height, rows } = map;
  const blocked = rows.flatMap((row) => Array.from(row, (one) => (kStanding.includes(one) ? 0 : 1)));
  const needed = Math.sqrt(people) / 2 / metresPerCell + 1;
  const found = roomiest(roomOf(largestRegion(blocked, width, height), width, height), width, needed)!;
  const usual = Math.min(0.5, Math.max(0.25, metresPerCell / 2));
  const least = metresPerCell * Math.sqrt((width * height) / kMostGround);
  return {
    format: 'muster-scenario',
    version: 1,
    name,
    map: { metresPerCell, origin: [0, 0], rows },
    cell: toMillimetre(Math.max(usual, 1.01 * least)),
    groups: [
      {
        name: 'Crowd',
        count: people,
        formation: 'square',
        position: [
          toMillimetre((found.column + 0.5) * metresPerCell),
          toMillimetre((height - found.row - 0.5) * metresPerCell),
        ],
        angle: 0,
      },
    ],
  };
}
