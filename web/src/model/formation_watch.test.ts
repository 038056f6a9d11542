import { expect, it } from 'vitest';
import { FormationWatch } from './formation_watch';

const group = (id: number, formation: string) => ({ id, name: `G${id}`, colour: 0, count: 9, formation });

it('tells of formations that change, once, but not of a world that is new or began anew', () => {
  const watch = new FormationWatch();
  const changes = (step: number, ...groups: ReturnType<typeof group>[]) =>
    watch.observe(groups, step).map(({ id, formation }) => `${id} ${formation}`);
  expect(changes(1, group(1, 'square'), group(2, 'ring'))).toEqual([]);
  expect(changes(2, group(1, 'square'), group(2, 'line'))).toEqual(['2 line']);
  expect(changes(3, group(1, 'square'), group(2, 'line'))).toEqual([]);
  expect(changes(4, group(1, 'square'), group(2, 'line'), group(3, 'wedge'))).toEqual([]);
  expect(changes(0, group(1, 'square'), group(2, 'ring'))).toEqual([]);
  watch.clear();
  expect(changes(9, group(1, 'pacman'))).toEqual([]);
});
