// Parts of dialogs that are made by hand.

import { element } from './dom';

/** An input with its label. */
export function field(label: string, input: HTMLElement): HTMLElement {
  return element('label', { class: 'shape-field' }, element('span', {}, label), input);
}
