import { expect, it } from 'vitest';
import type { ScenarioInfo } from '../protocol/messages';
import { groupScenarios } from './scenario_groups';

const list = (...names: string[]): ScenarioInfo[] =>
  names.map((name) => ({ name, title: name, description: '', characters: 1 }));

it('puts scenarios under the titles of their folders, in the order of the list', () => {
  const groups = groupScenarios(list('block', 'open', 'mine/a', 'paper/x1', 'paper/x2', 'constructor/b'));
  expect(groups.map(({ title, scenarios }) => [title, scenarios.map(({ name }) => name)])).toEqual([
    ['', ['block', 'open']],
    ['mine', ['mine/a']],
    ['The paper’s experiments', ['paper/x1', 'paper/x2']],
    ['constructor', ['constructor/b']],
  ]);
});

it('makes no group of nothing', () => {
  expect(groupScenarios([])).toEqual([]);
});
