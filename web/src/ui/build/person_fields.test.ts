// @vitest-environment jsdom
import { beforeEach, expect, it } from 'vitest';
import { kAdults } from '../../model/place/people';
import { thing, type PlaceChange, type Thing } from '../../model/place/things';
import { fieldsPage, fillIn } from './test_support';

const group: Thing = thing('group', { id: 4, name: 'Guests', count: 9, rest: { people: [kAdults] } });
const source: Thing = thing('area', {
  id: 2,
  polygon: [
    [0, 0],
    [1, 0],
    [1, 1],
  ],
  area: { kind: 'source', open: true, rate: 1, queue: [] },
  rest: { from: 5, timetable: [{ time: 60, count: 20 }] },
});
let sent: unknown[] = [];
let said = '';
let shown: Thing = group;
let fields: ReturnType<typeof fieldsPage>;

const give = (label: string, value: string): void => fillIn(fields.root, label, value, 'change');

function press(word: string): void {
  const found = [...fields.root.querySelectorAll('button')].find(
    (one) => one.textContent === word || one.getAttribute('aria-label') === word,
  );
  found!.click();
}

function show(one: Thing): void {
  shown = one;
  fields.show([one]);
}

/** The change is made and shown. */
function follow(people: unknown): void {
  show({ ...shown, rest: { ...shown.rest, people } });
}

const last = (): { people?: unknown } => sent[sent.length - 1] as { people?: unknown };

beforeEach(() => {
  sent = [];
  said = '';
  const actions = {
    editGroup: (_: string, event: (one: Thing) => PlaceChange) => sent.push(event(shown)),
    edit: (_: string, change: (one: Thing) => Thing) => sent.push(change(shown).rest),
    say: (text: string) => (said = text),
  };
  fields = fieldsPage(actions);
});

it('adults become sorts of one’s own, whose spreads are typed', async () => {
  show(group);
  give('Persons', 'Sorts of one’s own');
  const adults = { spread: 'normal', a: 1.34, b: 0.26, least: 0.5, most: 2.2 };
  expect(last()).toEqual({ kind: 'changeGroup', group: 4, people: [{ ...kAdults, name: 'Sort 1' }] });
  follow(last().people);
  give('Speed, mean', '1');
  expect(last().people).toEqual([{ ...kAdults, name: 'Sort 1', speed: { ...adults, a: 1 } }]);
  give('Premovement', 'Uniform');
  expect(last().people).toMatchObject([{ premovement: { spread: 'uniform', a: 30, b: 90 } }]);
  give('Speed, least', '5');
  await Promise.resolve();
  expect(fields.root.querySelector('.build-refused')!.textContent).toBe(
    'The least speed is not below the largest one.',
  );
  give('Persons', 'All alike');
  expect(last()).toEqual({ kind: 'changeGroup', group: 4, people: [] });
});

it('sorts are added, stay unfolded, and are removed', () => {
  const sorts = [{ ...kAdults, share: 3, name: 'Women' }];
  show({ ...group, rest: { people: sorts } });
  press('Add a sort');
  expect(last().people).toHaveLength(2);
  follow(last().people);
  expect([...fields.root.querySelectorAll('details')].map(({ open }) => open)).toEqual([false, true]);
  expect(fields.root.querySelector('summary')!.textContent).toBe('Women · 75 % · 1.34 ± 0.26 m/s');
  give('Sort 2, share', '2');
  // Before that is shown.
  give('Sort 2, name of the sort', 'Men');
  expect(last().people).toMatchObject([{ name: 'Women' }, { share: 2, name: 'Men' }]);
  press('Remove this sort');
  expect(last().people).toMatchObject([{ share: 2, name: 'Men' }]);
});

it('a source has times, a number and a timetable by ascending times', () => {
  show(source);
  give('Until, 0: no end [s]', '90');
  expect(sent.pop()).toEqual({ from: 5, until: 90, timetable: [{ time: 60, count: 20 }] });
  give('Until, 0: no end [s]', '4');
  expect([sent.length, said]).toEqual([0, 'That is not after the beginning.']);
  give('In all, 0: no end', '40');
  expect(sent.pop()).toMatchObject({ most: 40 });
  press('Add an arrival');
  expect(sent.pop()).toMatchObject({
    timetable: [
      { time: 60, count: 20 },
      { time: 120, count: 20 },
    ],
  });
  give('Arrival 1, people', '35');
  expect(sent.pop()).toMatchObject({ timetable: [{ time: 60, count: 35 }] });
  press('Remove arrival 1');
  expect(sent.pop()).toEqual({ from: 5 });
});

it('an exit opens and closes', () => {
  show({ ...source, area: { kind: 'exit', open: true, rate: 0, queue: [] }, rest: {} });
  give('Opens at [s]', '30');
  give('Closes at, 0: never [s]', '60');
  expect(sent).toEqual([{ from: 30 }, { until: 60 }]);
});
