import { expect, it } from 'vitest';
import type { SceneArea } from '../protocol/messages';
import { areaAt } from './goals';
import { areaOf } from '../protocol/test_scene';

const square = (x: number): SceneArea['polygon'] => [
  [x, 0],
  [x + 2, 0],
  [x + 2, 2],
  [x, 2],
];
const areas: readonly SceneArea[] = [
  areaOf({ id: 1, kind: 'exit', polygon: square(0) }),
  areaOf({ id: 2, kind: 'exit', polygon: square(3) }),
  areaOf({ id: 3, kind: 'waiting', polygon: square(6) }),
];

it('takes the area under a press, or one that is near, of the kind that is meant', () => {
  expect(areaAt(areas, 'exit', { x: 1, y: 1 })?.id).toBe(1);
  expect(areaAt(areas, 'exit', { x: 2.7, y: 1 })?.id).toBe(2);
  expect(areaAt(areas, 'exit', { x: 7, y: 1 })).toBeNull();
  expect(areaAt(areas, 'waiting', { x: 7, y: 2.9 })?.id).toBe(3);
  expect(areaAt(areas, 'waiting', { x: 7, y: 3.1 })).toBeNull();
});
