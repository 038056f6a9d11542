// A world without groups, or none yet.

import { element, setText } from '../widgets/dom';
import { icon } from '../widgets/icons';
import type { StudioActions } from '../../model/studio_actions';
import type { StudioState } from '../../model/studio_state';
import type { StudioStore } from '../../model/studio_store';

export class EmptyPanel {
  private readonly title_ = element('h2');
  private readonly about_ = element('p', { class: 'secondary' });
  private readonly choices_ = element('div', { class: 'empty-choices' });
  readonly root = element('section', { class: 'empty panel' }, this.title_, this.about_, this.choices_);

  constructor(
    store: StudioStore,
    private readonly actions_: StudioActions,
  ) {
    store.watch(['groups', 'areas', 'loaded', 'scenarios', 'link'], (state) => this.show(state));
  }

  private show(state: StudioState): void {
    const waiting = !state.loaded;
    // Where there are areas people have left, or come.
    const used = state.groups.length > 0 || state.areas.length > 0;
    this.root.hidden = used || (waiting && state.link.phase === 'lost');
    if (this.root.hidden) return;
    setText(this.title_, waiting ? 'Opening the studio' : 'Nobody is here yet');
    setText(this.about_, waiting ? 'Waiting for the server.' : 'Add a group, or open one of these scenarios.');
    const add = element('button', { type: 'button', class: 'soft' }, icon('plus'), 'Add a group');
    add.addEventListener('click', () => this.actions_.openDialog('group'));
    const choices = state.scenarios.slice(0, 3).map((info) => {
      const button = element('button', { type: 'button', class: 'soft' }, info.title || info.name);
      button.addEventListener('click', () => this.actions_.loadScenario(info.name));
      return button;
    });
    this.choices_.replaceChildren(...(waiting ? [] : [add, ...choices]));
  }
}
