// Numbers and words of a chosen exit, source or waiting area, and of stairs.

import { groupChoices } from '../../model/place/areas';
import type { Arrivals } from '../../protocol/generated/commands';
import type { AreaFields, Thing } from '../../model/place/things';
import type { SceneFacts } from '../../protocol/scene';
import { element } from '../widgets/dom';
import type { BuildActions } from './build_actions';
import { buildIcon } from '../widgets/build_icons';
import { numberField, selectField } from '../widgets/fields';

const kDegree = Math.PI / 180;
const kRate = { min: 0, max: 1000, unit: '1/s' };
/** Travel speeds relative to running. */
const kSpeed = { min: 0.01, max: 100, unit: '×' };
/** Of the world; what is never over ends then [s]. */
const kForEver = 1e9;
const kTime = { min: 0, max: 1e7, unit: 's' };
const kPeople = { min: 0, max: 200_000, whole: true };
/** From one arrival to the next that is added [s]. */
const kApart = 60;

const kOpen = { true: 'Open', false: 'Closed' };

export function areaFields(
  one: Thing,
  area: AreaFields,
  scene: SceneFacts | null,
  actions: BuildActions,
): HTMLElement[] {
  const change = (label: string, fields: Partial<AreaFields>): void =>
    actions.edit(label, (it) => ({ ...it, area: it.area && { ...it.area, ...fields } }));
  const fields: HTMLElement[] = [];
  if (area.kind !== 'waiting')
    fields.push(
      selectField('State', Object.values(kOpen), kOpen[`${area.open}`], (word) =>
        change(word === kOpen.true ? 'Open' : 'Close', { open: word === kOpen.true }),
      ),
      numberField(area.kind === 'exit' ? 'At most, 0: all' : 'People', area.rate, kRate, (rate) =>
        change('Rate', { rate }),
      ),
    );
  if (area.kind === 'source') fields.push(joinField(one, scene, actions));
  if (area.kind !== 'waiting') fields.push(...timeFields(one, area.kind === 'exit', actions));
  if (area.kind === 'source') fields.push(mostField(one, actions), timetable(one, actions));
  if (area.queue.length > 0) fields.push(noQueue(() => change('No queue', { queue: [] })));
  return fields;
}

function joinField(one: Thing, scene: SceneFacts | null, actions: BuildActions): HTMLElement {
  const choices = groupChoices(scene);
  const words = choices.map(({ word }) => word);
  const shown = choices.find(({ id }) => id === one.group)?.word ?? '';
  return selectField('Join', words, shown, (word) => {
    const group = choices.find((choice) => choice.word === word)?.id ?? one.group;
    actions.edit('Join', (it) => ({ ...it, group }));
  });
}

function given(one: Thing, key: string, otherwise: number): number {
  const value = one.rest[key];
  return typeof value === 'number' ? value : otherwise;
}

/** `fields` of the definition; what is as usual is left out. */
function put(actions: BuildActions, label: string, fields: Readonly<Record<string, unknown>>): void {
  actions.edit(label, (it) => {
    const rest = Object.entries({ ...it.rest, ...fields }).filter(([, value]) => value !== undefined);
    return { ...it, rest: Object.fromEntries(rest) };
  });
}

/** When an exit opens and closes, or people begin and end to come by the rate of a source. */
function timeFields(one: Thing, exit: boolean, actions: BuildActions): HTMLElement[] {
  const until = given(one, 'until', kForEver);
  const [from, end] = [given(one, 'from', 0), until >= kForEver ? 0 : until];
  return [
    numberField(exit ? 'Opens at' : 'From', from, kTime, (time) => {
      if (end > 0 && time >= end) return actions.say('That is not before the end.');
      put(actions, 'Times', { from: time || undefined });
    }),
    numberField(exit ? 'Closes at, 0: never' : 'Until, 0: no end', end, kTime, (time) => {
      if (time > 0 && time <= from) return actions.say('That is not after the beginning.');
      put(actions, 'Times', { until: time || undefined });
    }),
  ];
}

function mostField(one: Thing, actions: BuildActions): HTMLElement {
  return numberField('In all, 0: no end', given(one, 'most', 0), kPeople, (most) =>
    put(actions, 'Number', { most: most || undefined }),
  );
}

function arrivalsOf({ rest }: Thing): readonly Arrivals[] {
  return (Array.isArray(rest['timetable']) ? rest['timetable'] : []) as readonly Arrivals[];
}

/** People who come at times of their own, beside those of the rate. */
function timetable(one: Thing, actions: BuildActions): HTMLElement {
  const rows = arrivalsOf(one);
  const change = (next: (now: readonly Arrivals[]) => readonly Arrivals[]): void =>
    actions.edit('Timetable', (it) => {
      const rest = Object.fromEntries(Object.entries(it.rest).filter(([key]) => key !== 'timetable'));
      const sorted = [...next(arrivalsOf(it))].sort((a, b) => a.time - b.time);
      return { ...it, rest: sorted.length > 0 ? { ...rest, timetable: sorted } : rest };
    });
  const lines = rows.map((row, k) => {
    const edit = (fields: Partial<Arrivals>): void =>
      change((now) => now.map((other, n) => (n === k ? { ...other, ...fields } : other)));
    const remove = element('button', { type: 'button', 'aria-label': `Remove arrival ${k + 1}` }, buildIcon('remove'));
    remove.addEventListener('click', () => change((now) => now.filter((_, n) => n !== k)));
    const [time, count] = [
      numberField('At', row.time, kTime, (value) => edit({ time: value })),
      numberField('People', row.count, { min: 1, max: kPeople.max, whole: true }, (value) => edit({ count: value })),
    ];
    time.querySelector('input')!.setAttribute('aria-label', `Arrival ${k + 1}, time`);
    count.querySelector('input')!.setAttribute('aria-label', `Arrival ${k + 1}, people`);
    return element('div', { class: 'build-arrival' }, time, count, remove);
  });
  const add = element('button', { type: 'button', class: 'soft' }, 'Add an arrival');
  add.addEventListener('click', () => {
    change((now) => {
      const last = now[now.length - 1];
      return [...now, { time: (last?.time ?? 0) + kApart, count: last?.count ?? 20 }];
    });
  });
  return element('div', { class: 'build-timetable' }, element('h4', {}, 'Timetable'), ...lines, add);
}

function noQueue(act: () => void): HTMLElement {
  const button = element('button', { type: 'button', class: 'soft' }, 'No queue');
  button.addEventListener('click', act);
  return button;
}

/** `ascent`: heading of the way up [rad]. */
export function stairsFields(one: Thing, ascent: number, actions: BuildActions): HTMLElement[] {
  const speed = (label: string, key: 'speed' | 'speedDown'): HTMLElement => {
    const now = [key, 'speed'].map((known) => given(one, known, -1)).find((value) => value > 0);
    return numberField(label, now ?? NaN, kSpeed, (value) =>
      actions.edit(label, (it) => ({ ...it, rest: { ...it.rest, [key]: value } })),
    );
  };
  return [
    numberField('Up towards', ascent / kDegree, { min: -3600, max: 3600, unit: '°' }, (degrees) =>
      actions.edit('Way up', (it) => ({ ...it, ascent: degrees * kDegree })),
    ),
    speed('Speed up', 'speed'),
    speed('Speed down', 'speedDown'),
  ];
}
