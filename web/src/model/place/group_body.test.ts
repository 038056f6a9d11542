import { expect, it } from 'vitest';
import { areaOf, classesOf, kAnywhere, withArea } from './group_body';

const kMixed = { radius: null, maxSpeed: null, unitClass: null };
const roles = [
  { area: 'front', unitClass: 2 },
  { area: 'rim', unitClass: 1 },
] as const;

it('names the classes of a group and where they stand', () => {
  expect(classesOf({ ...kMixed, unitClass: 3 }, roles)).toEqual([1, 2, 3]);
  expect(classesOf({ ...kMixed, unitClass: 0 }, [])).toEqual([]);
  expect(classesOf(null, roles)).toEqual([1, 2]);
  expect(areaOf(roles, 2)).toBe('Front');
  expect(areaOf(roles, 3)).toBe(kAnywhere);
});

it('gives a class another part of the formation', () => {
  expect(withArea(roles, 2, 'Left flank')).toEqual([{ area: 'leftFlank', unitClass: 2 }, roles[1]]);
  expect(withArea(roles, 3, 'Rear')).toEqual([...roles, { area: 'rear', unitClass: 3 }]);
  expect(withArea(roles, 1, kAnywhere)).toEqual([roles[0]]);
});
