// Body, appearance, class and role of a chosen group.

import type { VNode } from 'preact';
import { areaOf, classesOf, kAnywhere, kAreas, withArea } from '../../model/place/group_body';
import type { PlaceChange, Thing } from '../../model/place/things';
import type { GroupLook } from '../../protocol/generated/commands';
import { selectField, SliderField, type SliderRange } from '../widgets/fields';
import type { BuildActions } from './build_actions';

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

interface FieldsProps {
  readonly one: Thing;
  readonly actions: BuildActions;
}

interface BodySliderProps extends FieldsProps {
  readonly of: 'radius' | 'maxSpeed';
  readonly label: string;
  readonly range: SliderRange;
}

function BodySlider({ one, actions, of, label, range }: BodySliderProps): VNode {
  const event =
    (value: number) =>
    ({ id }: Thing): PlaceChange => ({ kind: 'groupBody', edit: { ...kAsTheyAre, group: id, [of]: value } });
  return (
    <SliderField
      label={label}
      value={one.body?.[of] ?? null}
      range={range}
      typed={(value) => actions.editGroup(label, event(value))}
      begins={() => actions.dragBegins()}
      drags={(value) => actions.dragGroup(label, event(value), false)}
      ends={(value) => actions.dragGroup(label, event(value), true)}
    />
  );
}

interface AppearanceProps extends FieldsProps {
  readonly of: 'build' | 'motions';
  readonly label: string;
  readonly words: Readonly<Record<string, string>>;
}

/** Build and motion set: a look has both, none for what is as usual. */
function AppearanceField({ one, actions, of, label, words }: AppearanceProps): VNode {
  const word = one.rest[of];
  return selectField(label, Object.values(words), words[typeof word === 'string' ? word : ''] ?? '', (shown) => {
    const chosen = Object.keys(words).find((known) => words[known] === shown) ?? '';
    actions.editGroup(label, ({ id, rest }) => {
      const wished = { build: rest['build'] ?? null, motions: rest['motions'] ?? null, [of]: chosen || null };
      return { kind: 'changeGroup', group: id, look: wished as GroupLook };
    });
  });
}

export function GroupBodyFields({ one, actions }: FieldsProps): VNode | null {
  const { body, roles } = one;
  if (!body) return null;
  const unitClass = body.unitClass === null ? kMixed : body.unitClass === 0 ? kNone : String(body.unitClass);
  const both = { one, actions };
  return (
    <>
      <BodySlider {...both} of="radius" label="Body radius" range={kRadius} />
      <BodySlider {...both} of="maxSpeed" label="Top speed" range={kSpeed} />
      <AppearanceField {...both} of="build" label="Build" words={kBuilds} />
      <AppearanceField {...both} of="motions" label="Motion set" words={kMotions} />
      {selectField('Class', kClasses, unitClass, (word) => {
        const chosen = word === kNone ? 0 : Number(word);
        if (word !== kMixed)
          actions.editGroup('Class', ({ id }) => ({
            kind: 'groupBody',
            edit: { ...kAsTheyAre, group: id, unitClass: chosen },
          }));
      })}
      {classesOf(body, roles).map((of) =>
        selectField(`Class ${of} stands`, [kAnywhere, ...Object.values(kAreas)], areaOf(roles, of), (label) =>
          actions.editGroup('Role', (it) => ({
            kind: 'changeGroup',
            group: it.id,
            roles: withArea(it.roles, of, label),
          })),
        ),
      )}
    </>
  );
}
