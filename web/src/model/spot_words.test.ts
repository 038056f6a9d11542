import { expect, it } from 'vitest';
import { areaOf, obstacleOf, patchOf, sceneOf } from '../protocol/test_scene';
import { spotWords } from './spot_words';

const square = (x: number, y: number, half: number): [number, number][] => [
  [x - half, y - half],
  [x + half, y - half],
  [x + half, y + half],
  [x - half, y + half],
];
const scene = sceneOf({
  box: { min: [-20, -20], max: [20, 20] },
  clips: [{ name: 'run' }, { name: 'crawl' }],
  obstacles: [obstacleOf({ id: 1, polygon: square(0, 3, 1) }), obstacleOf({ id: 2, centre: [5, 0], radius: 1 })],
  patches: [patchOf({ id: 1, polygon: square(-6, 0, 1), motion: 1 })],
  areas: [areaOf({ id: 1, kind: 'exit', name: 'Main door', polygon: square(0, -6, 1) })],
});
/** It looks along y. */
const north = { name: 'North', x: 0, y: 0, facing: Math.PI / 2, vertices: [-1, -1, 1, -1, 1, 1, -1, 1] };

it('tells what lies there, and where that is from the nearest group by its front', () => {
  expect(spotWords({ x: 0, y: 3 }, scene, [north])).toBe('Wall, 3 m before North');
  expect(spotWords({ x: 5, y: 0 }, scene, [north])).toBe('Pillar, 5 m right of North');
  expect(spotWords({ x: -6, y: 0 }, scene, [north])).toBe('Ground to crawl, 6 m left of North');
  expect(spotWords({ x: 0, y: -6 }, scene, [north])).toBe('Main door, 6 m behind North');
  expect(spotWords({ x: 0, y: -9 }, scene, [{ ...north, x: 40 }, north])).toBe('Open ground, 9 m behind North');
  expect(spotWords({ x: 30, y: 0 }, scene, [])).toBe('Beyond the edge');
});

it('tells who stands there', () => {
  expect(spotWords({ x: 0.5, y: 0.5 }, scene, [north])).toBe('On North');
});
