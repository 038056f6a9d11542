// All gestures and keys.

import type { VNode } from 'preact';
import type { Shortcut, ShortcutGroup } from '../../tools/shortcuts';

type Gesture = readonly [withWhat: string, does: string];

const kTouch: readonly Gesture[] = [
  ['One finger on the formation', 'drags a point'],
  ['Two fingers together', 'move a line; its edge stays straight'],
  ['Three or more together', 'carry an area; it keeps its shape'],
  ['Draw ahead and lift', 'the crowd follows the path'],
  ['Hold a formation in the list', 'shows where everybody would stand; lift to take it up'],
  ['Hold Draw, another finger draws', 'makes an outline the formation'],
  ['Order, then press or drag', 'orders a place or a front; from the formation: a way'],
  ['Cut, then draw across', 'divides a formation; from one to another: joins them'],
  ['Cut, then pull two fingers apart', 'divides a formation between them'],
  ['Chip onto chip', 'joins two groups'],
  ['One finger on empty ground', 'pans the camera'],
  ['Two on empty ground', 'pinch and turn the camera'],
  ['Three that tap', 'take back what you did last'],
];

const kMouse: readonly Gesture[] = [
  ['Drag on the formation', 'pulls a point'],
  ['Shift + drag', 'spans a line; then drag an end or the bar'],
  ['Ctrl or Alt + drag', 'lassoes an area; then drag inside it'],
  ['Double click', 'pins a point, or lets a pinned control go'],
  ['Drag on empty ground, or Space + drag', 'pans the camera'],
  ['Rest on a formation in the list', 'shows where everybody would stand'],
  ['9 held + drag', 'draws an outline as the formation'],
  ['Right click', 'orders the chosen groups there (Shift: queued, Alt: each by its own way)'],
  ['Right drag', 'orders a front, from its left to its right end; from the formation: a way'],
  ['Shift + drag on empty ground', 'chooses the groups in a box; Shift + click adds one'],
  ['Middle button, or Space + right button', 'turns the camera'],
  ['Wheel', 'zooms at the pointer'],
  ['Shift + E', 'builds the place; then each tool has a letter'],
  ['Shift + P', 'moves paths of the open take, which is simulated again'],
];

const kGroups: readonly ShortcutGroup[] = ['Crowd', 'Orders', 'Formations', 'Time', 'Camera', 'Show'];

interface RowsProps {
  readonly title: string;
  readonly rows: readonly (readonly [withWhat: VNode | string, does: string])[];
}

function Rows({ title, rows }: RowsProps): VNode {
  return (
    <section>
      <h3>{title}</h3>
      <dl class="help-rows">
        {rows.map(([withWhat, does]) => (
          <>
            <dt>{withWhat}</dt>
            <dd>{does}</dd>
          </>
        ))}
      </dl>
    </section>
  );
}

function Keys({ of }: { readonly of: string }): VNode {
  return (
    <span class="keys">
      {of.split(' ').map((key) => (
        <kbd>{key}</kbd>
      ))}
    </span>
  );
}

export function HelpBody({ shortcuts }: { readonly shortcuts: readonly Shortcut[] }): VNode {
  const listed = shortcuts.filter(({ unlisted }) => !unlisted);
  return (
    <div class="help-body" tabIndex={0} role="region" aria-labelledby="help-keys-title">
      <Rows title="Touch" rows={kTouch} />
      <Rows title="Mouse" rows={kMouse} />
      {kGroups.map((name) => {
        const own = listed.filter(({ group }) => group === name);
        return <Rows key={name} title={name} rows={own.map(({ keys, does }) => [<Keys of={keys} />, does])} />;
      })}
    </div>
  );
}
