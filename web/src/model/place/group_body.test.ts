import { expect, it } from 'vitest';
import { areaOf, classesOf, kAnywhere, likeGroup, withArea } from './group_body';

const roles = [
  { area: 'front', class: 2 },
  { area: 'rim', class: 1 },
];

it('names the classes of a group and where they stand', () => {
  expect(classesOf({ class: 3 }, roles)).toEqual([1, 2, 3]);
  expect(classesOf({ class: 0 }, [])).toEqual([]);
  expect(classesOf(null, roles)).toEqual([1, 2]);
  expect(areaOf(roles, 2)).toBe('Front');
  expect(areaOf(roles, 3)).toBe(kAnywhere);
});

it('gives a class another part of the formation', () => {
  expect(withArea(roles, 2, 'Left flank')).toEqual([{ area: 'leftFlank', class: 2 }, roles[1]]);
  expect(withArea(roles, 3, 'Rear')).toEqual([...roles, { area: 'rear', class: 3 }]);
  expect(withArea(roles, 1, kAnywhere)).toEqual([roles[0]]);
});

it('makes a copy like the group, and leaves to the parameters what is theirs', () => {
  const usual = { radius: 0.25, maxSpeed: 2, class: 0 };
  expect(likeGroup(usual, [], usual)).toEqual({});
  expect(likeGroup({ radius: 0.4, maxSpeed: 2, class: 1 }, roles, usual)).toEqual({
    bodies: [{ radius: 0.4, class: 1 }],
    roles,
  });
});
