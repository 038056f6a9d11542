// Colour and shape of a group's mark, so that groups can be told apart without colour.

import { accentOf, chosenOf, type Accent } from '../../model/accent';
import { swatchOf } from '../../model/swatches';
import { betweenLuminances } from '../../scene/drawing/colour';

/** Of colours that stand out 3:1 from the panels of both themes. */
const kBetween = [0.152, 0.29] as const;

/** As chosen, or null; a swatch follows the theme. */
function chosenVariable(colour: number): { exact: string; own: boolean } | null {
  const chosen = chosenOf(colour);
  if (!chosen) return null;
  const swatch = swatchOf(chosen);
  return swatch ? { exact: `var(${swatch.variable})`, own: false } : { exact: chosen, own: true };
}

/** For style sheets: the colour follows the theme; people's own is made lighter or darker until panels let it be seen. */
export function accentVariable(colour: number): string {
  const chosen = chosenVariable(colour);
  if (!chosen) return `var(--group-${accentOf(colour)})`;
  return chosen.own ? betweenLuminances(chosen.exact, ...kBetween) : chosen.exact;
}

const kShapes: Record<Accent, string> = {
  blue: '<circle cx="8" cy="8" r="7"/>',
  ember: '<path d="M8 1.2 15.6 14.6H.4Z"/>',
  green: '<rect x="1.6" y="1.6" width="12.8" height="12.8" rx="1.5"/>',
  plum: '<path d="M8 .4 15.6 8 8 15.6.4 8Z"/>',
  ochre: '<path d="M5.6 1h4.8v4.6H15v4.8h-4.6V15H5.6v-4.6H1V5.6h4.6Z"/>',
  slate: '<circle cx="8" cy="8" r="5.4" fill="none" stroke="currentColor" stroke-width="3.2"/>',
};

/** 16 px, in the group's colour; the shape stays whichever colour is chosen. An own colour has an edge. */
export function groupMark(colour: number): SVGSVGElement {
  const template = document.createElement('template');
  template.innerHTML =
    `<svg class="mark" width="16" height="16" viewBox="0 0 16 16" fill="currentColor" aria-hidden="true">` +
    `${kShapes[accentOf(colour)]}</svg>`;
  const mark = template.content.firstElementChild as SVGSVGElement;
  mark.style.color = chosenVariable(colour)?.exact ?? accentVariable(colour);
  if (chosenVariable(colour)?.own && accentOf(colour) !== 'slate')
    mark.firstElementChild!.setAttribute('style', `stroke: ${accentVariable(colour)}; stroke-width: 1.5`);
  return mark;
}
