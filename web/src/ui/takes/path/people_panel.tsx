// What can be done to the chosen people of a take: pins, time, clips, looks, and what is wrong with it.

import type { VNode } from 'preact';
import { formatClock } from '../../../model/formatters';
import { fasterFrom, isEmpty, laterFrom, longerPart, ownTime, reachingPin } from '../../../model/people_edit';
import type { EditClip, EditFinding, EditLook, PeopleEdit } from '../../../protocol/messages';
import { ToolButton } from '../../widgets/buttons';
import { Menu } from '../../widgets/menu';
import type { PeopleEditor } from './people_editor';

export interface PeopleState {
  readonly chosen: readonly number[];
  readonly edit: PeopleEdit;
  /** Index of the chosen pin; -1 for none. */
  readonly pin: number;
  readonly several: boolean;
  /** What the next tap chooses to look at. */
  readonly aims: 'point' | 'person' | null;
  /** [s of the take]. */
  readonly now: number;
  readonly findings: readonly EditFinding[];
  readonly clips: readonly string[];
  /** Who else is changed. */
  readonly others: readonly number[];
  /** The paths are there. */
  readonly read: boolean;
  /** What would be taken back and done again; empty for nothing. */
  readonly undo: string;
  readonly redo: string;
}

interface Props {
  readonly state: PeopleState;
  readonly editor: PeopleEditor;
}

const kLater = 0.5;
const kFaster = 1.25;
const kStretch = 4;

export function nameOf(people: readonly number[]): string {
  return people.length === 1 ? `Person ${people[0]}` : `${people.length} people`;
}

/** What to do next, or what is so. */
export function wordsOf({ chosen, edit, aims, read, findings, others, pin }: PeopleState): string {
  if (aims === 'point') return 'Tap the ground where they are to look.';
  if (aims === 'person') return 'Tap the person at whom they are to look.';
  if (chosen.length === 0) {
    const changed = others.length === 1 ? 'One person is changed.' : `${others.length} people are changed.`;
    return others.length > 0 ? `Tap a person. ${changed}` : 'Tap a person to see the path.';
  }
  if (!read) return `${nameOf(chosen)}: the path is being read…`;
  const first = findings[0];
  const whose = first && chosen.length > 1 ? `Person ${first.person}` : nameOf(chosen);
  if (first) return `${whose} ${first.text}.`;
  if (pin >= 0) return `${nameOf(chosen)}: drag the pin where the path should go.`;
  if (edit.pins.length > 0) return `${nameOf(chosen)}: tap a pin for more, or the path for another one.`;
  return `${nameOf(chosen)}: drag the path. Everybody else keeps theirs.`;
}

function PinTools({ state: { edit, pin }, editor }: Props): VNode {
  const held = edit.pins[pin];
  if (!held)
    return <ToolButton label="Pin" class="path-pin-add" tip="A pin at the shown moment" act={() => editor.addPin()} />;
  const reach = (factor: number): void => editor.change({ pins: reachingPin(edit.pins, pin, factor) });
  return (
    <div class="path-pin-tools" role="group" aria-label="The chosen pin">
      <ToolButton label="Narrower" word="−" tip="Less of the path moves along" act={() => reach(1 / 1.5)} />
      <span title="So long before and after it the path moves along">{held.seconds.toFixed(1)} s</span>
      <ToolButton label="Wider" word="+" tip="More of the path moves along" act={() => reach(1.5)} />
      <ToolButton label="Remove pin" word="Remove" act={() => editor.removePin()} />
    </div>
  );
}

function TimeMenu({ state: { edit, now }, editor }: Props): VNode {
  const late = now - ownTime(edit.clock, now);
  const later = (by: number): void => editor.change({ clock: laterFrom(edit.clock, now, by) });
  const faster = (factor: number): void => editor.change({ clock: fasterFrom(edit.clock, now, factor, kStretch) });
  const told =
    Math.abs(late) < 0.01
      ? 'As recorded here'
      : `${Math.abs(late).toFixed(1)} s ${late > 0 ? 'later' : 'earlier'} here`;
  return (
    <Menu
      opener={{ label: 'Time', class: 'path-time-open', pressed: edit.clock.length > 0 }}
      class="path-menu"
      label="Their own time"
      besidePanel
    >
      {() => (
        <>
          <p>{told}</p>
          <div class="path-pair">
            <ToolButton label="Earlier" tip="Here half a second earlier" act={() => later(-kLater)} />
            <ToolButton label="Later" tip="Here half a second later" act={() => later(kLater)} />
          </div>
          <div class="path-pair">
            <ToolButton label="Slower" tip={`For ${kStretch} s from here`} act={() => faster(1 / kFaster)} />
            <ToolButton label="Faster" tip={`For ${kStretch} s from here`} act={() => faster(kFaster)} />
          </div>
          <ToolButton label="As recorded" disabled={edit.clock.length === 0} act={() => editor.change({ clock: [] })} />
        </>
      )}
    </Menu>
  );
}

interface PartsProps<T> {
  readonly parts: readonly T[];
  readonly name: (part: T) => string;
  readonly change: (parts: T[]) => void;
}

function Parts<T extends EditClip | EditLook>({ parts, name, change }: PartsProps<T>): VNode {
  return (
    <ul class="path-parts">
      {parts.map((part, k) => (
        <li key={part.from}>
          <span>
            {name(part)} {formatClock(part.from)}–{formatClock(part.to)}
          </span>
          <ToolButton label="Shorter" word="−" act={() => change(longerPart(parts, k, -0.5))} />
          <ToolButton label="Longer" word="+" act={() => change(longerPart(parts, k, 0.5))} />
          <ToolButton label="Remove" icon="close" iconOnly act={() => change(parts.filter((one) => one !== part))} />
        </li>
      ))}
    </ul>
  );
}

function ClipMenu({ state: { edit, clips }, editor }: Props): VNode {
  return (
    <Menu
      opener={{ label: 'Clip', class: 'path-clip-open', pressed: edit.clips.length > 0 }}
      class="path-menu"
      label="Clips that they play"
      besidePanel
    >
      {(close) => (
        <>
          <Parts parts={edit.clips} name={({ name }) => name} change={(parts) => editor.change({ clips: parts })} />
          <p>From the shown moment on</p>
          <div class="path-clips">
            {clips.map((name) => (
              <ToolButton
                key={name}
                label={name}
                act={() => {
                  editor.playClip(name);
                  close();
                }}
              />
            ))}
          </div>
        </>
      )}
    </Menu>
  );
}

function LookMenu({ state: { edit, aims }, editor }: Props): VNode {
  const name = ({ person }: EditLook): string => (person > 0 ? `Person ${person}` : 'A point');
  const choices: readonly (readonly [string, () => void])[] = [
    ['A point…', () => editor.aim('point')],
    ['A person…', () => editor.aim('person')],
    ['The camera', () => editor.lookAtCamera()],
  ];
  return (
    <Menu
      opener={{ label: 'Look at', class: 'path-look-open', pressed: edit.looks.length > 0 || aims !== null }}
      class="path-menu"
      label="What they look at"
      besidePanel
    >
      {(close) => (
        <>
          <Parts parts={edit.looks} name={name} change={(parts) => editor.change({ looks: parts })} />
          <p>From the shown moment on</p>
          {choices.map(([label, act]) => (
            <ToolButton
              key={label}
              label={label}
              act={() => {
                close();
                act();
              }}
            />
          ))}
        </>
      )}
    </Menu>
  );
}

function Findings({ state: { findings, edit, chosen }, editor }: Props): VNode | null {
  if (findings.length === 0) return null;
  const whose = ({ person, text }: EditFinding): string => (chosen.length > 1 ? `Person ${person} ${text}` : text);
  return (
    <Menu
      opener={{ label: `${findings.length} to look at`, icon: 'warning', class: 'path-troubles-open' }}
      class="path-menu"
      label="What is wrong with it"
      besidePanel
    >
      {(close) => (
        <>
          <ul class="path-troubles">
            {findings.map((one) => (
              <li key={`${one.person} ${one.kind} ${one.other} ${one.from}`}>
                <span>{whose(one)}</span>
                <ToolButton
                  label="Show"
                  act={() => {
                    close();
                    editor.show(one);
                  }}
                />
              </li>
            ))}
          </ul>
          {edit.pins.length > 0 && (
            <ToolButton
              label="Keep clear"
              tip="Moves the pins out of walls"
              act={() => {
                close();
                editor.change({}, true, true);
              }}
            />
          )}
        </>
      )}
    </Menu>
  );
}

/** Between the choice of persons and the words of the bar. */
export function PeopleTools({ state, editor }: Props): VNode {
  const { edit, chosen, several, undo, redo } = state;
  return (
    <>
      <ToolButton
        label="Several"
        class="path-several"
        pressed={several}
        tip="Taps add people, a drag encloses them"
        act={() => editor.setSeveral(!several)}
      />
      {chosen.length > 0 && (
        <>
          <PinTools state={state} editor={editor} />
          <TimeMenu state={state} editor={editor} />
          <ClipMenu state={state} editor={editor} />
          <LookMenu state={state} editor={editor} />
          <Findings state={state} editor={editor} />
          {!isEmpty(edit) && (
            <ToolButton
              label="Remove changes"
              word="Reset"
              class="path-remove"
              tip="They are shown as recorded"
              act={() => editor.change({ pins: [], clock: [], clips: [], looks: [] })}
            />
          )}
        </>
      )}
      <ToolButton
        icon="undo"
        label="Undo"
        iconOnly
        class="path-undo"
        hidden={!undo}
        tip={`Undo: ${undo}`}
        act={() => editor.undo(false)}
      />
      <ToolButton
        icon="redo"
        label="Redo"
        iconOnly
        class="path-redo"
        hidden={!redo}
        tip={`Redo: ${redo}`}
        act={() => editor.undo(true)}
      />
    </>
  );
}
