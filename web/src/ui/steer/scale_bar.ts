// How long metres are on the ground in the middle of the view.

import { element, setText } from '../widgets/dom';
import { scaleBarMetres } from '../../model/formatters';

const kLongestPx = 160;

export class ScaleBar {
  private readonly text_ = element('span', { class: 'scale-text' });
  private readonly bar_ = element('span', { class: 'scale-line' });
  readonly root = element('div', { class: 'scale passive', 'aria-hidden': 'true' }, this.text_, this.bar_);
  private shown_ = 0;

  /** Call with every picture. */
  update(pixelsPerMetre: number): void {
    if (Math.abs(pixelsPerMetre - this.shown_) < 0.01 || !(pixelsPerMetre > 0)) return;
    this.shown_ = pixelsPerMetre;
    const metres = scaleBarMetres(pixelsPerMetre, kLongestPx);
    setText(this.text_, `${metres} m`);
    this.bar_.style.width = `${(metres * pixelsPerMetre).toFixed(1)}px`;
  }
}
