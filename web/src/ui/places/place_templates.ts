// Places to begin with, as cards.

import type { PlaceActions } from '../../model/place_files/place_actions';
import { drawingOf, factsOf } from '../../model/place_files/place_drawing';
import { kTemplates, type Template } from '../../model/place_files/templates';
import { element } from '../widgets/dom';
import { placePicture } from './place_picture';

function card(template: Template, actions: PlaceActions): HTMLElement {
  const place = template.make();
  const button = element(
    'button',
    { type: 'button', class: 'place-card' },
    element('span', { class: 'place-card-picture' }, placePicture(drawingOf(place))),
    element('strong', {}, template.name),
    element('span', { class: 'secondary place-card-about' }, place.description ?? ''),
    element('span', { class: 'secondary place-card-facts' }, factsOf(place)),
  );
  button.addEventListener('click', () => actions.openTemplate(template));
  return element('li', {}, button);
}

export function templateCards(actions: PlaceActions): HTMLElement {
  return element(
    'div',
    { class: 'place-section' },
    element('ul', { class: 'place-cards', 'aria-label': 'Templates' }, ...kTemplates.map((one) => card(one, actions))),
  );
}
