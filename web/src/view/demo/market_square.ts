// A made-up world for the view's demonstration page: a square with buildings, trees, a fountain and four patches.

import type { Point2, SceneFacts, SceneObstacle, ScenePatch } from '../../protocol/scene';

function building(id: number, polygon: readonly Point2[]): SceneObstacle {
  return { id, name: 'House', polygon, height: 9, moving: false };
}

function disc(id: number, name: string, x: number, y: number, radius: number, height: number): SceneObstacle {
  return { id, name, centre: [x, y], radius, height, moving: false };
}

function turned(x: number, y: number, halfX: number, halfY: number, angle: number): Point2[] {
  const c = Math.cos(angle);
  const s = Math.sin(angle);
  return ([[-1, -1], [1, -1], [1, 1], [-1, 1]] as const).map(
    ([u, v]) => [x + c * u * halfX - s * v * halfY, y + s * u * halfX + c * v * halfY] as const);
}

const trees: readonly (readonly [number, number])[] = [
  [-9.6, 10.5], [-8.2, 7.2], [-13.6, 1.5], [-15.5, 4.2], [-3, 15.5], [1.5, 15], [16.5, 3.6], [12, 14.5], [8, 15.8], [-12, 14.6],
  [15.5, -9], [-14, -10],
];

const obstacles: readonly SceneObstacle[] = [
  building(1, [[-22, 4], [-12, 4], [-12, 8], [-15, 8], [-15, 18], [-22, 18]]),
  building(2, [[14, 9], [24, 9], [24, 18], [14, 18]]),
  building(3, [[-22, -18], [-15, -18], [-15, -13], [-22, -13]]),
  building(4, [[3, 17], [12, 17], [12, 24], [3, 24]]),
  disc(5, 'Fountain', -1.5, 10.2, 1.9, 0.6),
  disc(6, 'Bollard', 17, -2, 0.4, 1.1),
  ...trees.map(([x, y], i) => disc(20 + i, 'Tree', x, y, 0.3, 4)),
  { id: 60, name: 'Car', polygon: turned(20, -12, 2.2, 0.9, 0), height: 1.4, moving: true },
];

const patches: readonly ScenePatch[] = [
  { id: 1, name: 'Net', polygon: turned(-0.4, 4.4, 2.6, 1.7, 0.05), motion: 3, speed: 0.21, moving: false },
  { id: 2, name: 'Pool', polygon: turned(8, -0.5, 3.2, 2.3, 0.25), motion: 4, speed: 0.34, moving: false },
  { id: 3, name: 'Wall', polygon: turned(11, 7, 2.3, 0.7, -0.55), motion: 6, speed: 0.15, moving: false },
  { id: 4, name: 'Bar', polygon: turned(-11, -8, 1.8, 0.5, 0.4), motion: 5, speed: 0.8, moving: false },
  { id: 5, name: 'Branches', polygon: turned(-13, -3, 1.6, 1.6, 0), motion: 2, speed: 0.57, moving: false },
];

export const kMarketSquare: SceneFacts = {
  name: 'market', title: 'Market square', description: '', credit: '',
  box: { min: [-26, -22], max: [26, 26] }, cell: 0.25, radius: 0.25, obstacles, patches,
  clips: ['run', 'walk', 'duck', 'crawl', 'swim', 'jump', 'climb', 'idle'].map((name) => ({ name, speed: 1, cyclic: true })),
  groups: [
    { id: 1, name: 'North', count: 64, formation: 'square', colour: 0 },
    { id: 2, name: 'South', count: 36, formation: 'wedge', colour: 1 },
  ],
  items: [{ position: [4, -9], radius: 0.5 }, { position: [6, -10], radius: 0.5 }],
  checkpoints: [{ position: [-9, -14], radius: 2, formation: 'line', group: -1 }],
};
