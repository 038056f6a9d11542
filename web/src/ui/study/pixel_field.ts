// How large a pixel of this display is: an outline on the page is made as high as a bank card.

import type { AnswerFrame, QuestionFrame } from '../../protocol/messages';
import { element } from '../widgets/dom';
import type { Field } from './fields';

/** The short side of a bank card (ISO/IEC 7810, ID-1) [mm]. */
const kCard = 53.98;
const kLong = 85.6;
const kLeast = 120;
const kMost = 430;
/** On a display of 96 dpi. */
const kUsual = 204;

/** Size of a pixel for an outline of that height [mm]. */
export function pixelSize(height: number): number {
  return Math.round((kCard / height) * 1e4) / 1e4;
}

export function pixelField({ name }: QuestionFrame): Field {
  const slider = element('input', { type: 'range', min: kLeast, max: kMost, step: 1, value: kUsual, id: 'study-card' });
  const card = element('div', { class: 'study-card-outline', 'aria-hidden': 'true' }, 'Bank card');
  const root = element(
    'div',
    { class: 'study-field' },
    element('label', { for: 'study-card' }, 'How large is this screen?'),
    element(
      'p',
      { class: 'secondary' },
      'Hold a bank card against the screen and move the slider until the outline is as high as the card’s short side.',
    ),
    slider,
    card,
  );
  const show = (): void => {
    const height = Number(slider.value);
    card.style.height = `${height}px`;
    card.style.width = `min(100%, ${Math.round((height * kLong) / kCard)}px)`;
  };
  slider.addEventListener('input', show);
  show();
  return {
    root,
    answer: (): AnswerFrame => {
      const size = pixelSize(Number(slider.value));
      return { name, text: String(size), number: size };
    },
    complain: () => undefined,
    focus: () => slider.focus(),
  };
}
