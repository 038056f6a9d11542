// Numbers and words of a chosen exit, source or waiting area, and of stairs.

import { groupChoices } from '../../model/place/areas';
import type { AreaFields, Thing } from '../../model/place/things';
import type { SceneFacts } from '../../protocol/scene';
import { element } from '../widgets/dom';
import type { BuildActions } from './build_actions';
import { numberField, selectField } from './fields';

const kDegree = Math.PI / 180;
const kRate = { min: 0, max: 1000, unit: '1/s' };
/** Travel speeds relative to running. */
const kSpeed = { min: 0.01, max: 100, unit: '×' };
const kOpen = { true: 'Open', false: 'Closed' };

export function areaFields(one: Thing, area: AreaFields, scene: SceneFacts | null, desk: BuildActions): HTMLElement[] {
  const change = (label: string, fields: Partial<AreaFields>): void =>
    desk.edit(label, (it) => ({ ...it, area: it.area && { ...it.area, ...fields } }));
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
  if (area.kind === 'source') fields.push(joinField(one, scene, desk));
  if (area.queue.length > 0) fields.push(noQueue(() => change('No queue', { queue: [] })));
  return fields;
}

function joinField(one: Thing, scene: SceneFacts | null, desk: BuildActions): HTMLElement {
  const choices = groupChoices(scene);
  const words = choices.map(({ word }) => word);
  const shown = choices.find(({ id }) => id === one.group)?.word ?? '';
  return selectField('Join', words, shown, (word) => {
    const group = choices.find((choice) => choice.word === word)?.id ?? one.group;
    desk.edit('Join', (it) => ({ ...it, group }));
  });
}

function noQueue(act: () => void): HTMLElement {
  const button = element('button', { type: 'button', class: 'soft' }, 'No queue');
  button.addEventListener('click', act);
  return button;
}

/** `ascent`: heading of the way up [rad]. */
export function stairsFields(one: Thing, ascent: number, desk: BuildActions): HTMLElement[] {
  const speed = (label: string, key: 'speed' | 'speedDown'): HTMLElement => {
    const now = one.rest[key] ?? one.rest['speed'];
    return numberField(label, typeof now === 'number' ? now : NaN, kSpeed, (value) =>
      desk.edit(label, (it) => ({ ...it, rest: { ...it.rest, [key]: value } })),
    );
  };
  return [
    numberField('Up towards', ascent / kDegree, { min: -3600, max: 3600, unit: '°' }, (degrees) =>
      desk.edit('Way up', (it) => ({ ...it, ascent: degrees * kDegree })),
    ),
    speed('Speed up', 'speed'),
    speed('Speed down', 'speedDown'),
  ];
}
