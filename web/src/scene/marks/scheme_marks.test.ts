import { expect, it } from 'vitest';
import { schemePicture } from './scheme_marks';

const kNothing = { selected: new Set<number>(), rectangle: [], stroke: [], goals: [], pointers: [] };

it('finds the selected characters where the picture shows them', () => {
  const crowd = { ids: [3, 5, 9], positions: [1, 2, 3, 4, 5, 6], radius: [0.25, 0.3, 0.25] };
  expect(schemePicture({ ...kNothing, selected: new Set([5, 9, 12]) }, crowd).selected).toEqual([
    { x: 3, y: 4, radius: 0.3 },
    { x: 5, y: 6, radius: 0.25 },
  ]);
  expect(schemePicture(kNothing, crowd).selected).toEqual([]);
});
