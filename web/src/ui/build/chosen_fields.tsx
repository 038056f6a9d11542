// Numbers and words of what is chosen.

import type { VNode } from 'preact';
import { frameOf, resized } from '../../model/place/frame';
import { gatedAgain, gateOf } from '../../model/place/gates';
import { kClimbed, kGoRound, kindName, kJumped, motionWord, withMotion } from '../../model/place/motions';
import { changedAt } from '../../model/place/routes';
import { moved, turned, type Thing } from '../../model/place/things';
import { formationKind, type FormationWords } from '../../model/sequence';
import { Button } from '../widgets/buttons';
import { numberField, selectField, TextField } from '../widgets/fields';
import { AreaFields, GateFields, StairsFields, type FieldsProps } from './area_fields';
import { kShapes, type BuildActions } from './build_actions';
import { GroupBodyFields } from './group_body_fields';
import { GroupColourField } from './group_colour_field';
import { PersonFields } from './person_fields';

const kDegree = Math.PI / 180;
const kFar = { min: -1e5, max: 1e5, unit: 'm' };
const kSize = { min: 0.05, max: 1e4, unit: 'm' };
const kHeight = { min: 0.01, max: 1000, unit: 'm' };
const kTurn = { min: -3600, max: 3600, unit: '°' };

/** From -180 to 180. */
function degreesOf(angle: number): number {
  const degrees = angle / kDegree - 360 * Math.round(angle / kDegree / 360);
  return Math.round(degrees * 1e6) / 1e6 + 0;
}

/** Sides and turn of an outline, along its first side. */
function SizeFields({ one, actions }: FieldsProps): VNode | null {
  if (!one.polygon) return null;
  const { length, width, angle, middle } = frameOf(one.polygon);
  const size = (label: string, side: 'length' | 'width', value: number): VNode =>
    numberField(label, value, kSize, (wished) =>
      actions.edit('Resize', (it) =>
        changedAt(it, actions.time, (defined) => gatedAgain(resized(defined, side, wished))),
      ),
    );
  return (
    <>
      {size('Length', 'length', length)}
      {size('Width', 'width', width)}
      {numberField('Turned by', degreesOf(angle), kTurn, (degrees) =>
        actions.edit('Turn', (it) => turned(it, middle, degrees * kDegree - angle)),
      )}
    </>
  );
}

/** What people do there; whoever is to go round meets an obstacle. */
function MotionField({ one, actions }: FieldsProps): VNode {
  const { clips } = actions.options;
  const words = [kGoRound, ...clips.map(({ name }) => motionWord(name))];
  const now = one.kind === 'patch' ? (words[one.motion + 1] ?? '') : kGoRound;
  return selectField('People here', words, now, (word) =>
    actions.become('People here', (it) => withMotion(it, words.indexOf(word) - 1, clips)),
  );
}

/** What is jumped or climbed is as high as that motion has it; what is higher is in people's way. */
function HeightField({ one, actions }: FieldsProps): VNode | null {
  const { clips } = actions.options;
  const low = { jump: kJumped, climb: kClimbed }[clips[one.motion]?.name ?? ''];
  if (one.kind !== 'obstacle' && (one.kind !== 'patch' || !low || one.ascent !== null)) return null;
  const isLow = one.kind === 'patch';
  const change = (height: number): boolean => {
    if (isLow && height <= low!.most) {
      actions.say(`What people ${motionWord(clips[one.motion]!.name).toLowerCase()} is ${low!.height} m high.`);
      return false;
    }
    if (isLow) actions.become('Height', (it) => ({ ...withMotion(it, -1, clips), height }));
    else actions.edit('Height', (it) => ({ ...it, height }));
    return true;
  };
  return numberField('Height', isLow ? low!.height : one.height, kHeight, change);
}

function GroupFields({ one, actions }: FieldsProps): VNode {
  const formation = (change: Partial<FormationWords>): void =>
    actions.editGroup('Formation', (it) => ({
      kind: 'changeGroup',
      group: it.id,
      formation: { ...it.formation, ...change },
    }));
  return (
    <>
      {numberField('People', one.count, { min: Math.min(1, one.count), max: 20000, whole: true }, (count) =>
        actions.editGroup('People', (it) => ({ kind: 'changeGroup', group: it.id, count })),
      )}
      {numberField('Spacing', one.formation.spacing ?? 1, { min: 0.3, max: 20, unit: 'm' }, (spacing) =>
        formation({ spacing }),
      )}
      {selectField('Formation', kShapes, one.formation.kind, (kind) => formation({ kind: formationKind(kind) }))}
      {numberField('Turned by', degreesOf(one.angle), kTurn, (degrees) =>
        actions.edit('Turn', (it) => turned(it, { x: it.centre[0], y: it.centre[1] }, degrees * kDegree - it.angle)),
      )}
      <GroupColourField one={one} actions={actions} />
      <GroupBodyFields one={one} actions={actions} />
      <PersonFields one={one} actions={actions} />
    </>
  );
}

function NameField({ one, actions }: FieldsProps): VNode | null {
  if (one.kind === 'item' || one.kind === 'checkpoint') return null;
  const rename = (name: string): void => {
    if (one.kind !== 'group') actions.edit('Rename', (it) => ({ ...it, name }));
    else if (name) actions.editGroup('Rename', (it) => ({ kind: 'changeGroup', group: it.id, name }));
  };
  return <TextField label="Name" value={one.name} act={rename} />;
}

function OneFields({ one, actions }: FieldsProps): VNode {
  const gate = gateOf(one);
  const both = { one, actions };
  const place = (label: string, axis: 0 | 1): VNode =>
    numberField(label, one.centre[axis], kFar, (to) =>
      actions.edit('Move', (it) => moved(it, axis === 0 ? to - it.centre[0] : 0, axis === 1 ? to - it.centre[1] : 0)),
    );
  return (
    <>
      <NameField {...both} />
      {(one.kind === 'obstacle' || (one.kind === 'patch' && one.ascent === null)) && one.polygon && !gate && (
        <MotionField {...both} />
      )}
      <SizeFields {...both} />
      {!one.polygon &&
        one.kind !== 'group' &&
        numberField('Radius', one.radius, kSize, (radius) => actions.edit('Resize', (it) => ({ ...it, radius })))}
      <HeightField {...both} />
      {gate && <GateFields times={gate} actions={actions} />}
      {one.ascent !== null && <StairsFields {...both} ascent={one.ascent} />}
      {one.area && <AreaFields {...both} area={one.area} />}
      {one.kind === 'checkpoint' &&
        selectField('Formation', kShapes, one.formation.kind, (kind) =>
          actions.edit('Formation', (it) => ({
            ...it,
            formation: { ...it.formation, kind: formationKind(kind) },
          })),
        )}
      {one.kind === 'group' && <GroupFields {...both} />}
      {place('X', 0)}
      {place('Y', 1)}
      {one.path && !gate && (
        <Button act={() => actions.edit('Stand still', (it) => ({ ...it, path: null }))}>Stand still</Button>
      )}
    </>
  );
}

export interface ChosenProps {
  readonly chosen: readonly Thing[];
  readonly actions: BuildActions;
}

export function ChosenFields({ chosen, actions }: ChosenProps): VNode | null {
  const [one] = chosen;
  if (!one) return null;
  const several = chosen.length > 1;
  return (
    <div class="build-chosen-fields" key={several ? 'several' : `${one.kind} ${one.id}`}>
      <h3>{several ? `${chosen.length} things` : kindName(one, actions.options.clips)}</h3>
      <div class="build-fields">
        {several ? (
          numberField('Turn by', 0, kTurn, (degrees) => (actions.turnChosen(degrees * kDegree), false))
        ) : (
          <OneFields one={one} actions={actions} />
        )}
      </div>
    </div>
  );
}
