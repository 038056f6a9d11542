// Icons of formations.

import { dotsOf, dotsOfFormation, kSize } from '../../model/formation_dots';
import type { FormationWords } from '../../model/sequence';

/** The icon of a formation of the library, or of one as an order has it. */
export function formationIcon(formation: string | FormationWords): SVGSVGElement {
  const all = typeof formation === 'string' ? dotsOf(formation) : dotsOfFormation(formation);
  const dots = all.map(([x, y]) => {
    return `<circle cx="${x.toFixed(1)}" cy="${y.toFixed(1)}" r="2.2"/>`;
  });
  const template = document.createElement('template');
  template.innerHTML =
    `<svg width="${kSize}" height="${kSize}" viewBox="0 0 ${kSize} ${kSize}" fill="currentColor" aria-hidden="true">` +
    `${dots.join('')}</svg>`;
  return template.content.firstElementChild as SVGSVGElement;
}
