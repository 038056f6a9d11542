// At the edge of the view: an arrow to each group that is off screen; a press brings it into view.

import type { CrowdArrow } from '../../model/studio_state';
import type { StudioStore } from '../../model/studio_store';
import type { StudioActions } from '../../model/studio_actions';
import { element, setAttribute } from '../widgets/dom';
import { accentVariable, groupMark } from '../widgets/group_marks';
import { icon } from '../widgets/icons';

export class CrowdArrows {
  readonly root = element('div', { class: 'crowd-arrows' });
  private readonly buttons_ = new Map<number, HTMLButtonElement>();

  constructor(
    private readonly store_: StudioStore,
    private readonly actions_: StudioActions,
  ) {
    store_.watch(['arrows', 'groups'], ({ arrows }) => this.show(arrows));
  }

  private show(arrows: readonly CrowdArrow[]): void {
    for (const [id, button] of this.buttons_) {
      if (arrows.some((arrow) => arrow.id === id)) continue;
      button.remove();
      this.buttons_.delete(id);
    }
    for (const arrow of arrows) this.place(arrow);
  }

  private place(arrow: CrowdArrow): void {
    const group = this.store_.state.groups[arrow.index];
    if (!group) return;
    let button = this.buttons_.get(arrow.id);
    if (!button) {
      button = this.make(arrow.id);
      this.buttons_.set(arrow.id, button);
      this.root.append(button);
    }
    this.paint(button, group.colour);
    setAttribute(button, 'aria-label', `${group.name} is off screen: show it`);
    setAttribute(button, 'data-tip', `${group.name} is there`);
    button.style.transform = `translate(${arrow.x - 24}px, ${arrow.y - 24}px)`;
    button.style.setProperty('--direction', `${arrow.angle}rad`);
  }

  /** The colour of a group may change. */
  private paint(button: HTMLButtonElement, colour: number): void {
    if (button.dataset['colour'] === String(colour)) return;
    button.dataset['colour'] = String(colour);
    button.querySelector('.mark')?.remove();
    button.prepend(groupMark(colour));
    button.style.setProperty('--accent', accentVariable(colour));
  }

  private make(id: number): HTMLButtonElement {
    const point = element('span', { class: 'crowd-arrow-point' }, icon('arrow'));
    const button = element('button', { type: 'button', class: 'crowd-arrow panel' }, point);
    button.addEventListener('click', () => {
      const index = this.store_.state.groups.findIndex((group) => group.id === id);
      if (index >= 0) this.actions_.frameGroup(index);
    });
    return button;
  }
}
