// The library of formations; a press changes the active group.

import { element, setAttribute, setPressed } from '../widgets/dom';
import { formationIcon } from '../widgets/formation_icons';
import { accentVariable, groupMark } from '../widgets/group_marks';
import type { StudioActions } from '../../model/studio_actions';
import type { StudioState } from '../../model/studio_state';
import { holdWithFinger } from '../widgets/held_button';
import { lookFirst } from '../widgets/look_first';
import { ToolbarFocus } from '../widgets/toolbar_focus';
import type { StudioStore } from '../../model/studio_store';

export interface FormationChoice {
  readonly name: string;
  readonly label: string;
  /** What it opens instead of taking up a shape of the library. */
  readonly opens?: 'text' | 'draw' | 'shape';
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
  { name: 'text', label: 'Text', opens: 'text' },
  { name: 'draw', label: 'Draw', opens: 'draw' },
  { name: 'more', label: 'More', opens: 'shape' },
];

const kTips = {
  text: 'Words as a formation',
  draw: 'Draw an outline on the ground as a formation; hold it and draw with another finger',
  shape: 'Mirror, turn, loosen, save; a picture as a formation',
} as const;
/** What the server calls shapes that are no part of the library. */
const kOwnShapes: Readonly<Record<string, string>> = { outline: 'draw', points: 'more' };

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
    store.watch(['groups', 'active', 'tool'], (state) => this.show(state));
  }

  private button(choice: FormationChoice, index: number): HTMLButtonElement {
    const key = index < 8 ? String(index + 1) : undefined;
    const button = element(
      'button',
      {
        type: 'button',
        class: 'formation',
        'aria-pressed': 'false',
        'aria-haspopup': choice.opens && choice.opens !== 'draw' ? 'dialog' : undefined,
        'aria-keyshortcuts': key ?? (choice.opens === 'draw' ? '9' : undefined),
        'data-key': key ?? (choice.opens === 'draw' ? '9' : undefined),
        'data-tip': choice.opens ? kTips[choice.opens] : choice.label,
        'data-opens': choice.opens,
      },
      formationIcon(choice.name),
      element('span', { class: 'label' }, choice.label),
    );
    this.watch(button, choice);
    button.addEventListener('click', () => this.chosen(choice));
    this.buttons_.set(choice.name, button);
    return button;
  }

  /** Shapes of the library are shown on the ground first; Draw is in hand while a finger holds it. */
  private watch(button: HTMLButtonElement, choice: FormationChoice): void {
    if (choice.opens === 'draw') holdWithFinger(button, (held, lost) => this.actions_.holdDraw(held, lost));
    if (choice.opens) return;
    lookFirst(button, {
      look: () => this.actions_.lookAtFormation(choice.name),
      leave: () => this.actions_.lookAtFormation(null),
      take: () => this.chosen(choice),
    });
  }

  private chosen({ name, opens }: FormationChoice): void {
    if (opens === 'draw') this.actions_.toggleDraw();
    else if (opens) this.actions_.openDialog(opens);
    else this.actions_.setFormation(name);
  }

  private show(state: StudioState): void {
    const group = state.groups[state.active];
    const shown = kOwnShapes[group?.formation ?? ''] ?? group?.formation;
    for (const [name, button] of this.buttons_) {
      setPressed(button, state.tool === 'draw' ? name === 'draw' : shown === name);
    }
    const colour = group?.colour ?? 0;
    if (colour !== this.shownColour_) {
      this.shownColour_ = colour;
      this.mark_.replaceChildren(groupMark(colour));
      this.root.style.setProperty('--accent', accentVariable(colour));
    }
    setAttribute(this.list_, 'aria-label', group ? `Formations of ${group.name}` : 'Formations');
  }
}
