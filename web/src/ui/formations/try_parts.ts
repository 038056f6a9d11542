// What dialogs of formations say of the ground, and how they let a formation be looked at there.

import type { ShapeActions } from '../../model/shape_actions';
import type { StudioStore } from '../../model/studio_store';
import { element, setText } from '../widgets/dom';

/** The buttons at the end of a dialog: a look on the ground, and taking it up at once. */
export function lookOrTake(look: () => void): HTMLElement {
  const button = element('button', { type: 'button', class: 'soft' }, 'Try on the ground');
  button.addEventListener('click', look);
  const take = element('button', { type: 'submit', class: 'solid' }, 'Use it');
  return element('div', { class: 'shape-ends' }, button, take);
}

/** How many of the places can be reached. */
export function groundWords(store: StudioStore): HTMLElement {
  const words = element('p', { class: 'secondary shape-ground' });
  store.watch(['stand'], ({ stand }) => {
    setText(words, stand ? `${stand.text}.` : '');
    words.classList.toggle('warns', stand?.warns ?? false);
  });
  return words;
}

/** A dialog has closed: what it showed goes, unless it lies on the ground now. */
export function leave(store: StudioStore, shapes: Pick<ShapeActions, 'lookAt'>, close: () => void): void {
  if (!store.state.trying) shapes.lookAt(null);
  close();
}
