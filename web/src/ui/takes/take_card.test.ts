// @vitest-environment jsdom
import { beforeEach, expect, it } from 'vitest';
import type { TakeActions } from '../../model/take_actions';
import type { ShelvedTake } from '../../model/take_facts';
import { recordingActions } from '../widgets/test_support';
import { TakeCard } from './take_card';
import { TakeShelf } from './take_shelf';

const take: ShelvedTake = {
  name: 'open-1.take',
  title: '',
  scenario: 'Open ground',
  characters: 36,
  steps: 600,
  stepTime: 1 / 60,
  from: 60,
  to: 540,
  seconds: 8,
  finished: true,
  recording: false,
  picture: true,
  changed: 1000,
  bytes: 4200,
  speeds: [],
};

let calls: string[];
let actions: TakeActions;

beforeEach(() => {
  calls = [];
  actions = recordingActions(calls) as unknown as TakeActions;
});

it('tells of a kept take, and takes a name', () => {
  const card = new TakeCard(actions);
  document.body.replaceChildren(card.root);
  expect(card.root.hidden).toBe(true);
  card.show(take, 'kept', 'takes/open-1.take/picture');
  expect(card.root.querySelector('.card-about')!.textContent).toBe('0:08 · 36 people · Open ground');
  const name = card.root.querySelector<HTMLInputElement>('.card-name')!;
  expect(name.value).toBe('Open ground');
  name.value = 'Rain';
  name.dispatchEvent(new Event('change'));
  expect(calls[0]).toMatch(/^renameTake .*"Rain"$/);
  card.root.querySelector<HTMLButtonElement>('.card-close')!.click();
  expect(calls[1]).toBe('closeCard');
});

it('offers to bring a removed take back, and nothing else', () => {
  const card = new TakeCard(actions);
  document.body.replaceChildren(card.root);
  card.show(take, 'removed', '');
  expect(card.root.querySelector<HTMLElement>('.card-tools')!.hidden).toBe(true);
  card.root.querySelector<HTMLButtonElement>('.card-undo')!.click();
  expect(calls[0]).toMatch(/^restoreTake /);
});

it('lists takes, and says which was cut off and which is being recorded', () => {
  const shelf = new TakeShelf(
    actions,
    ({ name }) => name,
    () => calls.push('file'),
    () => 1100,
  );
  document.body.replaceChildren(shelf.root);
  shelf.setTakes([], '');
  expect(shelf.root.querySelector<HTMLElement>('.shelf-empty')!.hidden).toBe(false);
  shelf.setTakes(
    [
      { ...take, name: 'c', recording: true, finished: false },
      { ...take, name: 'b', finished: false },
      { ...take, title: 'Rain' },
    ],
    'open-1.take',
  );
  const items = [...shelf.root.querySelectorAll('.shelf-item')];
  expect(items.map((item) => item.querySelector('.secondary')!.textContent)).toEqual([
    'recording · 0:08 · a minute ago · 4.2 kB',
    'cut off · 0:08 · a minute ago · 4.2 kB',
    '0:08 · a minute ago · 4.2 kB',
  ]);
  expect(items[2]!.querySelector('[aria-current]')).not.toBeNull();
  items[2]!.querySelector<HTMLButtonElement>('.shelf-item-open')!.click();
  expect(calls[0]).toBe('openTake "open-1.take"');
  items[2]!.querySelector<HTMLButtonElement>('[aria-label="Remove Rain"]')!.click();
  expect(calls[1]).toMatch(/^removeTake /);
});
