// Offers a place that was kept while somebody edited, where the server has another one now.

import { clockOf, type KeptPlace } from '../../model/place_files/kept_place';
import { element } from '../widgets/dom';
import { icon } from '../widgets/icons';

export function placeBanner(place: KeptPlace, open: () => void, dismiss: () => void): HTMLElement {
  const yes = element('button', { type: 'button', class: 'solid' }, 'Open');
  const no = element('button', { type: 'button', class: 'soft' }, 'Dismiss');
  const root = element(
    'section',
    { class: 'banner panel place-banner', role: 'status' },
    icon('place', 24),
    element(
      'div',
      { class: 'banner-words' },
      element('strong', {}, `Your place ‘${place.name}’ of ${clockOf(place.changed)} is kept`),
      element('span', { class: 'secondary' }, place.facts),
    ),
    element('div', { class: 'banner-buttons' }, no, yes),
  );
  yes.addEventListener('click', () => {
    root.remove();
    open();
  });
  no.addEventListener('click', () => {
    root.remove();
    dismiss();
  });
  return root;
}
