// All gestures and keys.

import type { Shortcut, ShortcutGroup } from '../../tools/shortcuts';
import { element } from '../widgets/dom';
import { icon } from '../widgets/icons';
import type { StudioActions } from '../../model/studio_actions';
import type { StudioStore } from '../../model/studio_store';

interface Gesture {
  readonly with: string;
  readonly does: string;
}

const kTouch: readonly Gesture[] = [
  { with: 'One finger on the formation', does: 'drags a point' },
  { with: 'Two fingers together', does: 'move a line; its edge stays straight' },
  { with: 'Three or more together', does: 'carry an area; it keeps its shape' },
  { with: 'Draw ahead and lift', does: 'the crowd follows the path' },
  { with: 'Hold a formation in the list', does: 'shows where everybody would stand; lift to take it up' },
  { with: 'Hold Draw, another finger draws', does: 'makes an outline the formation' },
  { with: 'Order, then press or drag', does: 'orders a place or a front; from the formation: a way' },
  { with: 'Cut, then draw across', does: 'divides a formation; from one to another: joins them' },
  { with: 'Cut, then pull two fingers apart', does: 'divides a formation between them' },
  { with: 'Chip onto chip', does: 'joins two groups' },
  { with: 'One finger on empty ground', does: 'pans the camera' },
  { with: 'Two on empty ground', does: 'pinch and turn the camera' },
  { with: 'Three that tap', does: 'take back what you did last' },
];

const kMouse: readonly Gesture[] = [
  { with: 'Drag on the formation', does: 'pulls a point' },
  { with: 'Shift + drag', does: 'spans a line; then drag an end or the bar' },
  { with: 'Ctrl or Alt + drag', does: 'lassoes an area; then drag inside it' },
  { with: 'Double click', does: 'pins a point, or lets a pinned control go' },
  { with: 'Drag on empty ground, or Space + drag', does: 'pans the camera' },
  { with: 'Rest on a formation in the list', does: 'shows where everybody would stand' },
  { with: '9 held + drag', does: 'draws an outline as the formation' },
  { with: 'Right click', does: 'orders the chosen groups there (Shift: queued, Alt: each by its own way)' },
  { with: 'Right drag', does: 'orders a front, from its left to its right end; from the formation: a way' },
  { with: 'Shift + drag on empty ground', does: 'chooses the groups in a box; Shift + click adds one' },
  { with: 'Middle button, or Space + right button', does: 'turns the camera' },
  { with: 'Wheel', does: 'zooms at the pointer' },
  { with: 'Shift + E', does: 'builds the place; then each tool has a letter' },
  { with: 'Shift + P', does: 'moves paths of the open take, which is simulated again' },
];

const kGroups: readonly ShortcutGroup[] = ['Crowd', 'Orders', 'Formations', 'Time', 'Camera', 'Show'];

function rows(title: string, list: readonly { with: HTMLElement | string; does: string }[]): HTMLElement {
  const body = element('dl', { class: 'help-rows' });
  for (const row of list) body.append(element('dt', {}, row.with), element('dd', {}, row.does));
  return element('section', {}, element('h3', {}, title), body);
}

function keysOf(shortcut: Shortcut): HTMLElement {
  const keys = shortcut.keys.split(' ').map((key) => element('kbd', {}, key));
  return element('span', { class: 'keys' }, ...keys);
}

export class HelpDialog {
  readonly root = element('dialog', { class: 'help', 'aria-labelledby': 'help-title' });

  constructor(store: StudioStore, actions: StudioActions, shortcuts: readonly Shortcut[]) {
    const close = element('button', { type: 'button', 'aria-label': 'Close help' }, icon('close'));
    close.addEventListener('click', () => actions.showHelp(false));
    this.root.addEventListener('close', () => actions.showHelp(false));
    this.root.addEventListener('click', (event) => {
      if (event.target === this.root) actions.showHelp(false);
    });
    const keys = kGroups.map((group) => {
      const list = shortcuts.filter((shortcut) => shortcut.group === group && !shortcut.unlisted);
      return rows(
        group,
        list.map((shortcut) => ({ with: keysOf(shortcut), does: shortcut.does })),
      );
    });
    this.root.append(
      element('header', {}, element('h2', { id: 'help-title' }, 'Gestures and keys'), close),
      element(
        'div',
        { class: 'help-body', tabindex: 0, role: 'region', 'aria-labelledby': 'help-title' },
        rows('Touch', kTouch),
        rows('Mouse', kMouse),
        ...keys,
      ),
    );
    store.watch(['help'], ({ help }) => {
      if (help && !this.root.open) this.root.showModal();
      if (!help && this.root.open) this.root.close();
    });
  }
}
