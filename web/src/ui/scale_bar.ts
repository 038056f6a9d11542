// How long metres are on the ground in the middle of the view.

import { element, setText } from './dom';
import { scaleBarMetres } from './formatters';

const LONGEST_PX = 160;

export class ScaleBar {
  private readonly text = element('span', { class: 'scale-text' });
  private readonly bar = element('span', { class: 'scale-line' });
  readonly root = element('div', { class: 'scale passive', 'aria-hidden': 'true' }, this.text, this.bar);
  private shown = 0;

  /** Call with every drawn frame. */
  update(pixelsPerMetre: number): void {
    if (Math.abs(pixelsPerMetre - this.shown) < 0.01 || !(pixelsPerMetre > 0)) return;
    this.shown = pixelsPerMetre;
    const metres = scaleBarMetres(pixelsPerMetre, LONGEST_PX);
    setText(this.text, `${metres} m`);
    this.bar.style.width = `${(metres * pixelsPerMetre).toFixed(1)}px`;
  }
}
