// The library of formations; a press changes the active group.

import { element, setAttribute, setPressed } from '../widgets/dom';
import { formationIcon } from '../widgets/formation_icons';
import { accentVariable, groupMark } from '../widgets/group_marks';
import type { StudioActions } from '../../model/studio_actions';
import type { StudioState } from '../../model/studio_state';
import { ToolbarFocus } from '../widgets/toolbar_focus';
import type { StudioStore } from '../../model/studio_store';

export interface FormationChoice {
  readonly name: string;
  readonly label: string;
  readonly soon?: boolean;
}

/** The first eight answer to the keys 1 to 8. */
export const kFormations: readonly FormationChoice[] = [
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
  private readonly mark_ = element('span', { class: 'formation-mark' });
  private readonly heading_ = element('div', { class: 'formation-heading secondary' }, this.mark_, 'Formation');
  private readonly list_ = element('div', { class: 'formation-list', role: 'toolbar', 'aria-label': 'Formations' });
  readonly root = element(
    'section',
    { class: 'formations panel', 'aria-label': 'Formation' },
    this.heading_,
    this.list_,
  );
  private readonly buttons_ = new Map<string, HTMLButtonElement>();
  private shownColour_ = -1;

  constructor(
    store: StudioStore,
    private readonly actions_: StudioActions,
  ) {
    kFormations.forEach((choice, i) => this.list_.append(this.button(choice, i)));
    new ToolbarFocus(this.list_, store);
    store.watch(['groups', 'active'], (state) => this.show(state));
  }

  private button(choice: FormationChoice, index: number): HTMLButtonElement {
    const key = index < 8 ? String(index + 1) : undefined;
    const button = element(
      'button',
      {
        type: 'button',
        class: 'formation',
        'aria-pressed': choice.soon ? undefined : 'false',
        'aria-disabled': choice.soon ? 'true' : undefined,
        'aria-keyshortcuts': key,
        'data-key': key,
        'data-tip': choice.soon ? `${choice.label}: soon` : choice.label,
        'data-soon': choice.soon,
      },
      formationIcon(choice.name),
      element('span', { class: 'label' }, choice.label),
    );
    if (choice.soon) return button;
    button.addEventListener('click', () => this.actions_.setFormation(choice.name));
    this.buttons_.set(choice.name, button);
    return button;
  }

  private show(state: StudioState): void {
    const group = state.groups[state.active];
    for (const [name, button] of this.buttons_) setPressed(button, group?.formation === name);
    const colour = group?.colour ?? 0;
    if (colour !== this.shownColour_) {
      this.shownColour_ = colour;
      this.mark_.replaceChildren(groupMark(colour));
      this.root.style.setProperty('--accent', accentVariable(colour));
    }
    setAttribute(this.list_, 'aria-label', group ? `Formations of ${group.name}` : 'Formations');
  }
}
