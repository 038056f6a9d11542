// Body, appearance, class and role of a chosen group.

import { areaOf, classesOf, kAnywhere, kAreas, withArea } from '../../model/place/group_body';
import type { PlaceChange, Thing } from '../../model/place/things';
import type { GroupLook } from '../../protocol/generated/commands';
import type { BuildActions } from './build_actions';
import { selectField, sliderField, type SliderRange } from '../widgets/fields';

const kRadius: SliderRange = { min: 0.05, max: 1.5, from: 0.1, to: 1, step: 0.01, unit: 'm' };
const kSpeed: SliderRange = { min: 0.01, max: 50, from: 0.1, to: 6, step: 0.1, unit: 'm/s' };
const kNone = 'None';
const kMixed = 'Mixed';
const kClasses: readonly string[] = [kNone, '1', '2', '3', '4', '5', '6'];

/** What is shown for a field of the appearance, by its word in files; the empty word is that of a field left out. */
const kBuilds: Readonly<Record<string, string>> = { '': 'Both', broad: 'Broad', narrow: 'Narrow' };
const kMotions: Readonly<Record<string, string>> = { '': 'Plain', march: 'March', weary: 'Weary' };

/** No number of a body changes. */
const kAsTheyAre = { radius: null, maxSpeed: null, unitClass: null } as const;

type Hold = (held: boolean) => void;

function bodySlider(
  [one, key, label, range]: readonly [Thing, 'radius' | 'maxSpeed', string, SliderRange],
  actions: BuildActions,
  hold: Hold,
): HTMLElement {
  const event =
    (value: number) =>
    ({ id }: Thing): PlaceChange => ({ kind: 'groupBody', edit: { ...kAsTheyAre, group: id, [key]: value } });
  const dragging = {
    begins: () => {
      hold(true);
      actions.dragBegins();
    },
    drags: (value: number) => actions.dragGroup(label, event(value), false),
    ends: (value: number) => {
      actions.dragGroup(label, event(value), true);
      hold(false);
    },
  };
  const value = one.body?.[key] ?? null;
  return sliderField(label, value, range, dragging, (typed) => actions.editGroup(label, event(typed)));
}

/** Build and motion set: a look has both, none for what is as usual. */
function appearanceField(
  one: Thing,
  [key, label, words]: readonly ['build' | 'motions', string, Readonly<Record<string, string>>],
  actions: BuildActions,
): HTMLElement {
  const word = one.rest[key];
  return selectField(label, Object.values(words), words[typeof word === 'string' ? word : ''] ?? '', (shown) => {
    const chosen = Object.keys(words).find((known) => words[known] === shown) ?? '';
    actions.editGroup(label, ({ id, rest }) => {
      const wished = { build: rest['build'] ?? null, motions: rest['motions'] ?? null, [key]: chosen || null };
      return { kind: 'changeGroup', group: id, look: wished as GroupLook };
    });
  });
}

/** `hold`: a slider is being dragged, so that the fields have to stay. */
export function groupBodyFields(one: Thing, actions: BuildActions, hold: Hold): HTMLElement[] {
  const { body, roles } = one;
  if (!body) return [];
  const unitClass = body.unitClass === null ? kMixed : body.unitClass === 0 ? kNone : String(body.unitClass);
  return [
    bodySlider([one, 'radius', 'Body radius', kRadius], actions, hold),
    bodySlider([one, 'maxSpeed', 'Top speed', kSpeed], actions, hold),
    appearanceField(one, ['build', 'Build', kBuilds], actions),
    appearanceField(one, ['motions', 'Motion set', kMotions], actions),
    selectField('Class', kClasses, unitClass, (word) => {
      const chosen = word === kNone ? 0 : Number(word);
      if (word !== kMixed)
        actions.editGroup('Class', ({ id }) => ({
          kind: 'groupBody',
          edit: { ...kAsTheyAre, group: id, unitClass: chosen },
        }));
    }),
    ...classesOf(body, roles).map((of) =>
      selectField(`Class ${of} stands`, [kAnywhere, ...Object.values(kAreas)], areaOf(roles, of), (label) =>
        actions.editGroup('Role', (it) => ({
          kind: 'changeGroup',
          group: it.id,
          roles: withArea(it.roles, of, label),
        })),
      ),
    ),
  ];
}
