// Numbers and words of a chosen exit, source or waiting area, of stairs, and of a gate.

import type { VNode } from 'preact';
import { groupChoices } from '../../model/place/areas';
import { gated, isOpenAt, kNever, pressedAt, type GateTimes } from '../../model/place/gates';
import { changedAt } from '../../model/place/routes';
import type { AreaFields as Area, Thing } from '../../model/place/things';
import type { Arrivals } from '../../protocol/generated/commands';
import { Button } from '../widgets/buttons';
import { BuildIcon } from '../widgets/build_icons';
import { numberField, selectField } from '../widgets/fields';
import type { BuildActions } from './build_actions';

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

export interface FieldsProps {
  readonly one: Thing;
  readonly actions: BuildActions;
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

interface TimesProps {
  readonly labels: readonly [string, string];
  readonly from: number;
  /** 0 for never. */
  readonly until: number;
  readonly actions: BuildActions;
  readonly act: (times: { readonly from?: number; readonly until?: number }) => void;
}

/** When something begins and ends. */
function Times({ labels, from, until, actions, act }: TimesProps): VNode {
  const refuse = (text: string): false => (actions.say(text), false);
  return (
    <>
      {numberField(labels[0], from, kTime, (time) =>
        until > 0 && time >= until ? refuse('That is not before the end.') : act({ from: time }),
      )}
      {numberField(labels[1], until, kTime, (time) =>
        time > 0 && time <= from ? refuse('That is not after the beginning.') : act({ until: time }),
      )}
    </>
  );
}

/** When an exit opens and closes, or people begin and end to come by the rate of a source. */
function AreaTimes({ one, actions, isExit }: FieldsProps & { readonly isExit: boolean }): VNode {
  const until = given(one, 'until', kForEver);
  return (
    <Times
      labels={isExit ? ['Opens at', 'Closes at, 0: never'] : ['From', 'Until, 0: no end']}
      from={given(one, 'from', 0)}
      until={until >= kForEver ? 0 : until}
      actions={actions}
      act={(times) => {
        const [[key, time]] = Object.entries(times) as [[string, number]];
        put(actions, 'Times', { [key]: time || undefined });
      }}
    />
  );
}

export function AreaFields({ one, actions, area }: FieldsProps & { readonly area: Area }): VNode | null {
  const change = (label: string, fields: Partial<Area>): void =>
    actions.edit(label, (it) => ({ ...it, area: it.area && { ...it.area, ...fields } }));
  if (area.kind === 'waiting') return null;
  const isExit = area.kind === 'exit';
  return (
    <>
      {selectField('State', Object.values(kOpen), kOpen[`${area.open}`], (word) =>
        change(word === kOpen.true ? 'Open' : 'Close', { open: word === kOpen.true }),
      )}
      {numberField(isExit ? 'At most, 0: all' : 'People', area.rate, kRate, (rate) => change('Rate', { rate }))}
      {!isExit && (
        <JoinField
          group={one.group}
          actions={actions}
          act={(group) => actions.edit('Join', (it) => ({ ...it, group }))}
        />
      )}
      <AreaTimes one={one} actions={actions} isExit={isExit} />
      {!isExit &&
        numberField('In all, 0: no end', given(one, 'most', 0), kPeople, (most) =>
          put(actions, 'Number', { most: most || undefined }),
        )}
      {!isExit && <Timetable one={one} actions={actions} />}
      {area.queue.length > 0 && <Button act={() => change('No queue', { queue: [] })}>No queue</Button>}
    </>
  );
}

export interface JoinProps {
  readonly group: number;
  /** A choice before those of the place: a new group. */
  readonly first?: string;
  readonly actions: Pick<BuildActions, 'scene'>;
  readonly act: (group: number) => void;
}

/** Whom the people of a source join. */
export function JoinField({ group, first, actions, act }: JoinProps): VNode {
  const choices = [...(first ? [{ id: 0, word: first }] : []), ...groupChoices(actions.scene)];
  return selectField(
    'Join',
    choices.map(({ word }) => word),
    choices.find(({ id }) => id === group)?.word ?? first ?? '',
    (word) => act(choices.find((one) => one.word === word)?.id ?? group),
  );
}

function arrivalsOf({ rest }: Thing): readonly Arrivals[] {
  return (Array.isArray(rest['timetable']) ? rest['timetable'] : []) as readonly Arrivals[];
}

/** People who come at times of their own, beside those of the rate. */
function Timetable({ one, actions }: FieldsProps): VNode {
  const change = (next: (now: readonly Arrivals[]) => readonly Arrivals[]): void =>
    actions.edit('Timetable', (it) => {
      const rest = Object.fromEntries(Object.entries(it.rest).filter(([key]) => key !== 'timetable'));
      const sorted = [...next(arrivalsOf(it))].sort((a, b) => a.time - b.time);
      return { ...it, rest: sorted.length > 0 ? { ...rest, timetable: sorted } : rest };
    });
  const add = (): void =>
    change((now) => {
      const last = now[now.length - 1];
      return [...now, { time: (last?.time ?? 0) + kApart, count: last?.count ?? 20 }];
    });
  const row = ({ time, count }: Arrivals, k: number): VNode => {
    const edit = (fields: Partial<Arrivals>): void =>
      change((now) => now.map((other, n) => (n === k ? { ...other, ...fields } : other)));
    const name = `Arrival ${k + 1}`;
    return (
      <div key={k} class="build-arrival">
        {numberField('At', time, kTime, (to) => edit({ time: to }), `${name}, time`)}
        {numberField('People', count, { ...kPeople, min: 1 }, (to) => edit({ count: to }), `${name}, people`)}
        <button
          type="button"
          aria-label={`Remove ${name.toLowerCase()}`}
          onClick={() => change((now) => now.filter((_, n) => n !== k))}
        >
          <BuildIcon name="remove" />
        </button>
      </div>
    );
  };
  return (
    <div class="build-timetable">
      <h4>Timetable</h4>
      {arrivalsOf(one).map(row)}
      <Button act={add}>Add an arrival</Button>
    </div>
  );
}

/** `ascent`: heading of the way up [rad]. */
export function StairsFields({ one, actions, ascent }: FieldsProps & { readonly ascent: number }): VNode {
  const speed = (label: string, key: 'speed' | 'speedDown'): VNode => {
    const now = [key, 'speed'].map((known) => given(one, known, -1)).find((value) => value > 0);
    return numberField(label, now ?? NaN, kSpeed, (value) => put(actions, label, { [key]: value }));
  };
  return (
    <>
      {numberField('Up towards', ascent / kDegree, { min: -3600, max: 3600, unit: '°' }, (degrees) =>
        actions.edit('Way up', (it) => ({ ...it, ascent: degrees * kDegree })),
      )}
      {speed('Speed up', 'speed')}
      {speed('Speed down', 'speedDown')}
    </>
  );
}

export interface GateFieldsProps {
  readonly times: GateTimes;
  readonly actions: BuildActions;
  readonly act: (times: GateTimes) => void;
}

/** When a gate opens and shuts again. */
export function GateTimeFields({ times, actions, act }: GateFieldsProps): VNode {
  const shown = (time: number): number => (time === kNever ? 0 : time);
  const time = (typed: number): number => (typed === 0 ? kNever : typed);
  return (
    <Times
      labels={['Opens at, 0: never', 'Shuts at, 0: never']}
      from={shown(times.opens)}
      until={shown(times.shuts)}
      actions={actions}
      act={({ from, until }) =>
        act({
          opens: from === undefined ? times.opens : time(from),
          shuts: until === undefined ? times.shuts : time(until),
        })
      }
    />
  );
}

export function GateFields({ times, actions }: Omit<GateFieldsProps, 'act'>): VNode {
  const { time } = actions;
  const isOpen = isOpenAt(times, time);
  const set = (label: string, to: GateTimes): void =>
    actions.edit(label, (it) => changedAt(it, time, (gate) => gated(gate, to)));
  return (
    <>
      <GateTimeFields times={times} actions={actions} act={(to) => set('Times', to)} />
      <Button act={() => set(isOpen ? 'Shut' : 'Open', pressedAt(times, time))}>
        {isOpen ? 'Shut now' : 'Open now'}
      </Button>
    </>
  );
}
