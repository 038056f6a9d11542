// Places to begin with.

import type { GroupDef, ObstacleDef, Point } from '../../protocol/generated/definitions';
import type { FormationKindWord } from '../../protocol/generated/words';
import type { PlaceDefinition } from './place';

const box = (left: number, bottom: number, right: number, top: number): Point[] => [
  [left, bottom],
  [right, bottom],
  [right, top],
  [left, top],
];

const wall = (name: string, corners: readonly Point[], height = 3): ObstacleDef => ({
  name,
  polygon: corners,
  height,
});

const crowd = (
  name: string,
  count: number,
  position: Point,
  angle = 0,
  formation: FormationKindWord = 'square',
): GroupDef => ({
  name,
  count,
  formation,
  position,
  angle,
});

type Parts = Pick<PlaceDefinition, 'name' | 'description' | 'obstacles' | 'patches' | 'groups' | 'areas' | 'ring'>;

function place(wide: number, high: number, parts: Parts): PlaceDefinition {
  return {
    format: 'muster-scenario',
    version: 1,
    box: [
      [-wide / 2, -high / 2],
      [wide / 2, high / 2],
    ],
    cell: 0.25,
    ...parts,
  };
}

function emptySquare(): PlaceDefinition {
  return place(32, 32, {
    name: 'Empty square',
    description: 'Paved ground with nothing in the way.',
    groups: [crowd('Crowd', 49, [-7, 0])],
  });
}

/** A car comes along the street, and goes back outside of the place. `late`: it begins so far on its round [s]. */
function car(name: string, y: number, way: 1 | -1, late: number): ObstacleDef {
  const [far, out] = [32, -46 * Math.sign(y)];
  const round = [
    { t: 0, x: -far * way, y: 0 },
    { t: 16, x: far * way, y: 0 },
    { t: 20, x: far * way, y: out },
    { t: 26, x: -far * way, y: out },
    { t: 30, x: -far * way, y: 0 },
  ];
  const part = round.findIndex(({ t }) => t > late);
  const [a, b] = [round[part - 1]!, round[part]!];
  const share = (late - a.t) / (b.t - a.t);
  const start = { x: a.x + share * (b.x - a.x), y: a.y + share * (b.y - a.y) };
  const rest = round.slice(part).map((one) => ({ ...one, t: one.t - late }));
  const again = round.slice(1, part).map((one) => ({ ...one, t: one.t + 30 - late }));
  return {
    name,
    polygon: box(-2.1, y - 0.9, 2.1, y + 0.9),
    height: 1.5,
    path: { waypoints: [{ t: 0, ...start }, ...rest, ...again, { t: 30, ...start }], loop: true },
  };
}

function street(): PlaceDefinition {
  return place(48, 32, {
    name: 'Street with a crossing',
    description: 'Two lanes with cars between two rows of houses, and a crowd on either side.',
    obstacles: [
      wall('Bakery', box(-23, 9, -10, 15.5), 5),
      wall('Library', box(10, 9, 23, 15.5), 6),
      wall('Cinema', box(-23, -15.5, -10, -9), 6),
      wall('Station', box(10, -15.5, 23, -9), 5),
      car('Taxi', -1.6, 1, 0.5),
      car('Van', 1.6, -1, 9),
    ],
    groups: [crowd('North', 36, [0, 10], -Math.PI / 2), crowd('South', 36, [0, -10], Math.PI / 2)],
  });
}

function room(): PlaceDefinition {
  const [w, h, t] = [10, 7, 0.4];
  return place(40, 26, {
    name: 'Room with doors',
    description: 'A hall with two doors of different width; one group within, one before it.',
    obstacles: [
      wall('North wall', box(-w, h - t, w, h)),
      wall('South wall', box(-w, -h, w, -h + t)),
      wall('West wall', box(-w, -h + t, -w + t, -0.7)),
      wall('West wall', box(-w, 0.7, -w + t, h - t)),
      wall('East wall', box(w - t, -h + t, w, -1.6)),
      wall('East wall', box(w - t, 1.6, w, h - t)),
      { name: 'Pillar', centre: [0, 3.5], radius: 0.35, height: 3 },
      { name: 'Pillar', centre: [0, -3.5], radius: 0.35, height: 3 },
    ],
    groups: [crowd('Guests', 40, [-4, 0]), crowd('Waiting', 20, [15.5, 0], Math.PI)],
  });
}

/** Passages of a maze by a depth first walk with fixed numbers: true where a cell is open to the east, and to the north. */
function maze(columns: number, rows: number): { readonly east: boolean[]; readonly north: boolean[] } {
  const [east, north] = [
    new Array<boolean>(columns * rows).fill(false),
    new Array<boolean>(columns * rows).fill(false),
  ];
  const seen = new Set([0]);
  let seed = 11;
  const next = (): number => (seed = (seed * 1103515245 + 12345) % 2147483648) / 2147483648;
  const way = [0];
  while (way.length > 0) {
    const at = way[way.length - 1]!;
    const [x, y] = [at % columns, Math.floor(at / columns)];
    const open = [
      ...(x + 1 < columns ? [at + 1] : []),
      ...(x > 0 ? [at - 1] : []),
      ...(y + 1 < rows ? [at + columns] : []),
      ...(y > 0 ? [at - columns] : []),
    ].filter((one) => !seen.has(one));
    if (open.length === 0) {
      way.pop();
      continue;
    }
    const to = open[Math.floor(next() * open.length)]!;
    const low = Math.min(at, to);
    if (Math.abs(to - at) === 1) east[low] = true;
    else north[low] = true;
    seen.add(to);
    way.push(to);
  }
  return { east, north };
}

function hedges(): PlaceDefinition {
  const [columns, rows, size, half] = [7, 5, 4, 0.4];
  const { east, north } = maze(columns, rows);
  const [left, bottom] = [(-columns * size) / 2, (-rows * size) / 2];
  const list: ObstacleDef[] = [];
  const hedge = (x0: number, y0: number, x1: number, y1: number): void => {
    list.push(
      wall(
        'Hedge',
        box(left + x0 * size - half, bottom + y0 * size - half, left + x1 * size + half, bottom + y1 * size + half),
        1.8,
      ),
    );
  };
  hedge(0, 0, columns, 0);
  hedge(0, rows, columns, rows);
  hedge(0, 1, 0, rows);
  hedge(columns, 0, columns, rows - 1);
  for (let y = 0; y < rows; ++y)
    for (let x = 0; x < columns; ++x) {
      if (x + 1 < columns && !east[y * columns + x]) hedge(x + 1, y, x + 1, y + 1);
      if (y + 1 < rows && !north[y * columns + x]) hedge(x, y + 1, x + 1, y + 1);
    }
  return place(50, 26, {
    name: 'Maze of hedges',
    description: 'From the lower left to the upper right there is one way, three metres wide.',
    obstacles: list,
    groups: [crowd('Visitors', 24, [-19.5, -8], 0), crowd('Gardeners', 9, [19.5, 8], Math.PI)],
  });
}

function course(): PlaceDefinition {
  const across = (name: string, from: number, to: number, motion: string) => ({
    name,
    polygon: box(from, -6.5, to, 6.5),
    motion,
  });
  return place(68, 16, {
    name: 'Obstacle course',
    description: 'Boughs to duck under, a net to crawl under, a wall to climb and a pool to swim through.',
    obstacles: [wall('North stand', box(-34, 6.5, 34, 8), 2.5), wall('South stand', box(-34, -8, 34, -6.5), 2.5)],
    patches: [
      across('Boughs', -16, -13, 'duck'),
      across('Net', -7, -1, 'crawl'),
      across('Wall', 5, 6.2, 'climb'),
      across('Pool', 12, 18, 'swim'),
    ],
    groups: [crowd('Runners', 60, [-26, 0])],
  });
}

function funnel(): PlaceDefinition {
  const side = (s: 1 | -1): ObstacleDef[] => [
    wall(
      'Stand',
      [
        [4, 1.6 * s],
        [5, 1.6 * s],
        [5, 12 * s],
        [4, 12 * s],
      ],
      3,
    ),
    wall(
      'Barrier',
      [
        [4, 1.6 * s],
        [4, 2.2 * s],
        [-8, 9.2 * s],
        [-8, 8.6 * s],
      ],
      1.1,
    ),
    wall('Stand', box(5, s > 0 ? 9 : -12, 20, s > 0 ? 12 : -9), 3),
  ];
  return place(56, 26, {
    name: 'Stadium gate',
    description: 'Barriers lead a large crowd to a gate of three metres; stewards stand behind it.',
    obstacles: [...side(1), ...side(-1)],
    groups: [crowd('Visitors', 120, [-17, 0]), crowd('Stewards', 12, [14, 0], Math.PI, 'line')],
  });
}

function hall(): PlaceDefinition {
  const [w, h, t] = [12, 8, 0.4];
  const leaves = { people: 'adults', orders: [{ kind: 'leave' }] } as const;
  return place(40, 24, {
    name: 'Hall with exits',
    description: 'Guests leave a hall by the exit where they have left soonest, while others come by the stop.',
    obstacles: [
      wall('North wall', box(-w, h - t, w, h)),
      wall('South wall', box(-w, -h, w, -h + t)),
      wall('West wall', box(-w, -h + t, -w + t, -0.8)),
      wall('West wall', box(-w, 0.8, -w + t, h - t)),
      wall('East wall', box(w - t, -h + t, w, 3)),
      wall('East wall', box(w - t, 4.2, w, h - t)),
    ],
    groups: [
      { ...crowd('Guests', 80, [-3, -2]), ...leaves },
      { ...crowd('Arrivals', 0, [0, 5]), ...leaves },
    ],
    areas: [
      { kind: 'exit', name: 'Main door', polygon: box(-w - 1.5, -1.5, -w - 0.5, 1.5) },
      { kind: 'exit', name: 'Side door', polygon: box(w + 0.5, 2.5, w + 1.5, 4.7) },
      { kind: 'source', name: 'Stop', polygon: box(-1.5, 4, 1.5, 7), group: 1, rate: 0.5 },
    ],
  });
}

function corridor(): PlaceDefinition {
  const people = (name: string, x: number, facing: number): GroupDef => ({
    ...crowd(name, 30, [x, 0], facing),
    people: 'adults',
    orders: [{ kind: 'walk', facing }],
  });
  return place(40, 8, {
    name: 'Corridor without ends',
    description: 'Its left and its right side are joined: two crowds walk through each other, again and again.',
    obstacles: [wall('North wall', box(-20, 2, 20, 4)), wall('South wall', box(-20, -4, 20, -2))],
    groups: [people('East', -8, 0), people('West', 8, Math.PI)],
    ring: true,
  });
}

export interface Template {
  readonly name: string;
  readonly make: () => PlaceDefinition;
}

export const kTemplates: readonly Template[] = [
  { name: 'Empty square', make: emptySquare },
  { name: 'Street with a crossing', make: street },
  { name: 'Room with doors', make: room },
  { name: 'Maze of hedges', make: hedges },
  { name: 'Obstacle course', make: course },
  { name: 'Stadium gate', make: funnel },
  { name: 'Hall with exits', make: hall },
  { name: 'Corridor without ends', make: corridor },
];
