// The library of formations; a press changes the active group.

import { element, setAttribute, setPressed } from './dom';
import { formationIcon } from './formation_icons';
import { accentColour, groupMark } from './group_marks';
import type { StudioActions } from './studio_actions';
import type { StudioState, StudioStore } from './studio_state';
import { ToolbarFocus } from './toolbar_focus';

export interface FormationChoice {
  readonly name: string;
  readonly label: string;
  readonly soon?: boolean;
}

/** The first eight answer to the keys 1 to 8. */
export const FORMATIONS: readonly FormationChoice[] = [
  { name: 'square', label: 'Square' },
  { name: 'line', label: 'Line' },
  { name: 'column', label: 'Column' },
  { name: 'wedge', label: 'Wedge' },
  { name: 'ring', label: 'Ring' },
  { name: 'circle', label: 'Circle' },
  { name: 'crescent', label: 'Crescent' },
  { name: 'pacman', label: 'Pacman' },
  { name: 'text', label: 'Text', soon: true },
  { name: 'draw', label: 'Draw', soon: true },
];

export class FormationPanel {
  private readonly mark = element('span', { class: 'formation-mark' });
  private readonly heading = element('div', { class: 'formation-heading secondary' }, this.mark, 'Formation');
  private readonly list = element('div', { class: 'formation-list', role: 'toolbar', 'aria-label': 'Formations' });
  readonly root = element('section', { class: 'formations panel', 'aria-label': 'Formation' }, this.heading, this.list);
  private readonly buttons = new Map<string, HTMLButtonElement>();
  private shownColour = -1;

  constructor(store: StudioStore, private readonly actions: StudioActions) {
    FORMATIONS.forEach((choice, i) => this.list.append(this.button(choice, i)));
    new ToolbarFocus(this.list, store);
    store.watch(['groups', 'active'], (state) => this.show(state));
  }

  private button(choice: FormationChoice, index: number): HTMLButtonElement {
    const key = index < 8 ? String(index + 1) : undefined;
    const button = element('button', {
      type: 'button', class: 'formation', 'aria-pressed': choice.soon ? undefined : 'false',
      'aria-disabled': choice.soon ? 'true' : undefined, 'aria-keyshortcuts': key, 'data-key': key,
      'data-tip': choice.soon ? `${choice.label}: soon` : choice.label, 'data-soon': choice.soon,
    }, formationIcon(choice.name), element('span', { class: 'label' }, choice.label));
    if (choice.soon) return button;
    button.addEventListener('click', () => this.actions.setFormation(choice.name));
    this.buttons.set(choice.name, button);
    return button;
  }

  private show(state: StudioState): void {
    const group = state.groups[state.active];
    for (const [name, button] of this.buttons) setPressed(button, group?.formation === name);
    const colour = group?.colour ?? 0;
    if (colour !== this.shownColour) {
      this.shownColour = colour;
      this.mark.replaceChildren(groupMark(colour));
      this.root.style.setProperty('--accent', accentColour(colour));
    }
    setAttribute(this.list, 'aria-label', group ? `Formations of ${group.name}` : 'Formations');
  }
}
