// A world without groups, or none yet.

import { element, setText } from './dom';
import { icon } from './icons';
import type { StudioActions } from './studio_actions';
import type { StudioState, StudioStore } from './studio_state';

export class EmptyPanel {
  private readonly title = element('h2');
  private readonly about = element('p', { class: 'secondary' });
  private readonly choices = element('div', { class: 'empty-choices' });
  readonly root = element('section', { class: 'empty panel' }, this.title, this.about, this.choices);

  constructor(store: StudioStore, private readonly actions: StudioActions) {
    store.watch(['groups', 'loaded', 'scenarios', 'link'], (state) => this.show(state));
  }

  private show(state: StudioState): void {
    const waiting = !state.loaded;
    this.root.hidden = state.groups.length > 0 || (waiting && state.link.phase === 'lost');
    if (this.root.hidden) return;
    setText(this.title, waiting ? 'Opening the studio' : 'Nobody is here yet');
    setText(this.about, waiting ? 'Waiting for the server.' : 'Add a group, or open one of these scenarios.');
    const add = element('button', { type: 'button', class: 'soft', 'aria-disabled': 'true', 'data-tip': 'Add a group: soon' }, icon('plus'), 'Add a group');
    const choices = state.scenarios.slice(0, 3).map((info) => {
      const button = element('button', { type: 'button', class: 'soft' }, info.title || info.name);
      button.addEventListener('click', () => this.actions.loadScenario(info.name));
      return button;
    });
    this.choices.replaceChildren(...(waiting ? [] : [add, ...choices]));
  }
}
