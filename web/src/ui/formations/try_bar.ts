// A formation that lies on the ground to be looked at: what is said of its places, and whether it is taken up.

import type { ShapeActions } from '../../model/shape_actions';
import type { StudioStore } from '../../model/studio_store';
import { element, setText } from '../widgets/dom';
import { icon } from '../widgets/icons';

export class TryBar {
  private readonly title_ = element('span', { class: 'try-title' });
  private readonly words_ = element('span', { class: 'try-words', role: 'status' });
  private readonly take_ = element('button', { type: 'button', class: 'solid' }, 'Use it');
  readonly root: HTMLElement;

  constructor(store: StudioStore, shapes: Pick<ShapeActions, 'endTry'>) {
    const change = element('button', { type: 'button', class: 'soft' }, 'Change…');
    const drop = element('button', { type: 'button', class: 'try-drop', 'aria-label': 'Drop it' }, icon('close'));
    const said = element('div', { class: 'try-said' }, this.title_, this.words_);
    this.root = element(
      'section',
      { class: 'try-bar panel', 'aria-label': 'Formation on the ground', hidden: true },
      said,
      change,
      this.take_,
      drop,
    );
    this.take_.addEventListener('click', () => shapes.endTry('take'));
    change.addEventListener('click', () => shapes.endTry('change'));
    drop.addEventListener('click', () => shapes.endTry('drop'));
    window.addEventListener(
      'keydown',
      (event) => {
        if (event.key !== 'Escape' || this.root.hidden || event.defaultPrevented) return;
        event.preventDefault();
        event.stopImmediatePropagation();
        shapes.endTry('drop');
      },
      true,
    );
    store.watch(['trying'], ({ trying }) => {
      const opens = trying !== null && this.root.hidden;
      this.root.hidden = trying === null;
      setText(this.title_, trying?.title ?? '');
      if (opens) this.take_.focus();
    });
    store.watch(['stand'], ({ stand }) => {
      setText(this.words_, stand?.text ?? '…');
      this.words_.classList.toggle('warns', stand?.warns ?? false);
    });
  }
}
