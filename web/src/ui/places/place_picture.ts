// A place as a small drawing, in the colours of the theme.

import { accentVariable } from '../widgets/group_marks';
import type { PlaceDrawing } from '../../model/place_files/place_drawing';

const kSvg = 'http://www.w3.org/2000/svg';

function path(shape: string, className: string): SVGPathElement {
  const made = document.createElementNS(kSvg, 'path');
  made.setAttribute('d', shape);
  made.setAttribute('class', className);
  return made;
}

/** With `present`, another place behind it, faintly; its box counts then. */
export function placePicture(drawing: PlaceDrawing, present: PlaceDrawing | null = null): SVGSVGElement {
  const svg = document.createElementNS(kSvg, 'svg');
  const [left, top, width, height] = (present ?? drawing).viewBox;
  const margin = 0.03 * Math.max(width, height);
  svg.setAttribute('viewBox', [left - margin, top - margin, width + 2 * margin, height + 2 * margin].join(' '));
  svg.setAttribute('class', 'place-drawing');
  svg.setAttribute('aria-hidden', 'true');
  const ground = document.createElementNS(kSvg, 'rect');
  for (const [name, value] of Object.entries({ x: left, y: top, width, height }))
    ground.setAttribute(name, String(value));
  ground.setAttribute('class', 'drawn-ground');
  svg.append(ground);
  if (present) svg.append(path(present.patches + present.obstacles, 'drawn-present'));
  svg.append(path(drawing.patches, 'drawn-patches'), path(drawing.obstacles, 'drawn-obstacles'));
  drawing.groups.forEach((shape, i) => {
    const group = path(shape, 'drawn-group');
    group.style.color = accentVariable(drawing.colours[i] ?? i);
    svg.append(group);
  });
  return svg;
}
