// @vitest-environment jsdom
import { beforeEach, expect, it, vi } from 'vitest';
import { thing, type PlaceChange, type Thing } from '../../model/place/things';
import { fieldsPage, fieldOf, fillIn } from './test_support';

const body = { radius: 0.25, maxSpeed: 2, unitClass: 0 };
const group: Thing = thing('group', {
  id: 4,
  name: 'Guests',
  count: 9,
  body,
});
let sent: [string, PlaceChange | null][] = [];
const kAsTheyAre = { group: 4, radius: null, maxSpeed: null, unitClass: null };
let shown: Thing = group;
let fields: ReturnType<typeof fieldsPage>;

const control = (label: string): HTMLInputElement => fieldOf(fields.root, label);
const give = (label: string, value: string, ...events: string[]): void => fillIn(fields.root, label, value, ...events);

function show(one: Thing): void {
  shown = one;
  fields.show([one]);
}

beforeEach(() => {
  sent = [];
  const actions = {
    editGroup: (label: string, event: (one: Thing) => PlaceChange) => sent.push([label, event(shown)]),
    dragBegins: vi.fn(() => sent.push(['begins', null])),
    dragGroup: (label: string, event: (one: Thing) => PlaceChange, ends: boolean) =>
      sent.push([`${ends ? 'ends' : 'drags'} ${label}`, event(shown)]),
  };
  fields = fieldsPage(actions);
  show(group);
});

it('sends a typed radius and refuses one that nobody has', () => {
  give('Body radius [m]', '0.4', 'change');
  give('Body radius [m]', '9', 'change');
  expect(sent).toEqual([['Body radius', { kind: 'groupBody', edit: { ...kAsTheyAre, radius: 0.4 } }]]);
});

it('keeps the slider while it is dragged, and shows the newest after', () => {
  const slider = control('Top speed, slider');
  give('Top speed, slider', '3', 'input');
  show({ ...group, body: { ...body, maxSpeed: 3 } });
  expect(control('Top speed, slider')).toBe(slider);
  give('Top speed, slider', '4', 'input', 'change');
  expect(sent.map(([label, change]) => [label, change?.kind === 'groupBody' && change.edit.maxSpeed])).toEqual([
    ['begins', false],
    ['drags Top speed', 3],
    ['drags Top speed', 4],
    ['ends Top speed', 4],
  ]);
  show({ ...group, body: { ...body, maxSpeed: 4 } });
  expect(control('Top speed [m/s]').value).toBe('4');
  expect(control('Top speed, slider').getAttribute('aria-valuetext')).toBe('4 m/s');
});

it('gives a class, and a class its part of the formation', () => {
  give('Class', '2', 'change');
  show({ ...group, body: { ...body, unitClass: 2 } });
  give('Class 2 stands', 'Rear', 'change');
  expect(sent.map(([, event]) => event)).toEqual([
    { kind: 'groupBody', edit: { ...kAsTheyAre, unitClass: 2 } },
    { kind: 'changeGroup', group: 4, roles: [{ area: 'rear', unitClass: 2 }] },
  ]);
});

it('says where people differ', () => {
  show({ ...group, body: { radius: 0.25, maxSpeed: null, unitClass: null }, roles: [{ area: 'front', unitClass: 1 }] });
  expect(control('Class').value).toBe('Mixed');
  expect(control('Top speed [m/s]').value).toBe('');
  expect(control('Top speed [m/s]').placeholder).toBe('Mixed');
  expect(control('Top speed, slider').getAttribute('aria-valuetext')).toBe('Mixed');
  expect(control('Class 1 stands').value).toBe('Front');
});

it('leaves the focus in the field whose number comes back', () => {
  control('People').focus();
  show({ ...group, count: 10 });
  expect(document.activeElement).toBe(control('People'));
});

it('sends build and motion set together, none for what is as usual', () => {
  give('Build', 'Narrow', 'change');
  show({ ...group, rest: { build: 'narrow' } });
  expect(control('Build').value).toBe('Narrow');
  give('Motion set', 'March', 'change');
  show({ ...group, rest: { build: 'narrow', motions: 'march' } });
  give('Build', 'Both', 'change');
  expect(sent).toEqual([
    ['Build', { kind: 'changeGroup', group: 4, look: { build: 'narrow', motions: null } }],
    ['Motion set', { kind: 'changeGroup', group: 4, look: { build: 'narrow', motions: 'march' } }],
    ['Build', { kind: 'changeGroup', group: 4, look: { build: null, motions: 'march' } }],
  ]);
});
