// While marks and panels are hidden: a button that brings them back. It fades away where nobody moves, and comes with
// the next move.

import type { StudioActions } from '../../model/studio_actions';
import type { StudioStore } from '../../model/studio_store';
import { toolButton } from '../widgets/tool_button';

/** It stays for so long after the last move [ms]. */
const kStays = 1800;

export class CleanPicture {
  readonly root: HTMLButtonElement;
  private timer_ = 0;

  constructor(store: StudioStore, actions: StudioActions) {
    this.root = toolButton({
      icon: 'show',
      label: 'Show marks and panels',
      iconOnly: true,
      key: '0',
      className: 'clean-end panel',
      act: () => actions.toggleClean(),
    });
    this.root.hidden = true;
    store.watch(['clean'], ({ clean }) => {
      this.root.hidden = !clean;
      if (clean) this.appear();
    });
    for (const type of ['pointermove', 'pointerdown', 'keydown'] as const) {
      window.addEventListener(type, () => !this.root.hidden && this.appear(), { passive: true });
    }
  }

  private appear(): void {
    this.root.classList.remove('faded');
    window.clearTimeout(this.timer_);
    this.timer_ = window.setTimeout(() => this.root.classList.add('faded'), kStays);
  }
}
