// What the dialogs about formations and groups are made of.

import type { GroundPoint } from '../../model/plane';
import { element } from './dom';
import { icon } from './icons';

/** Size of a preview [CSS px]. */
const kPreview = { width: 340, height: 110 };

/** A modal dialog with a form in it; `close` is called however it closes. */
export function dialogOf(title: string, close: () => void): { root: HTMLDialogElement; form: HTMLFormElement } {
  const id = `dialog-${title.toLowerCase().replace(/\W+/g, '-')}`;
  const end = element('button', { type: 'button', 'aria-label': 'Close' }, icon('close'));
  const form = element('form', { method: 'dialog', class: 'shape-form' });
  const root = element(
    'dialog',
    { class: 'help shape-dialog', 'aria-labelledby': id },
    element('header', {}, element('h2', { id }, title), end),
    form,
  );
  end.addEventListener('click', () => root.close());
  root.addEventListener('close', close);
  root.addEventListener('click', (event) => event.target === root && root.close());
  return { root, form };
}

/** An input with its label. */
export function field(label: string, input: HTMLElement): HTMLElement {
  return element('label', { class: 'shape-field' }, element('span', {}, label), input);
}

/** Draws places as dots, x to the right and y up, as large as they fit. `gap`: between neighbours, in their unit. */
export function drawPlaces(
  picture: HTMLCanvasElement,
  places: readonly GroundPoint[],
  gap: number,
  { width, height } = kPreview,
): void {
  const ratio = Math.min(2, window.devicePixelRatio || 1);
  [picture.width, picture.height] = [width * ratio, height * ratio];
  const pen = picture.getContext('2d');
  if (!pen || places.length === 0) return;
  const wide = Math.max(...places.map(({ x }) => Math.abs(x)), 1);
  const high = Math.max(...places.map(({ y }) => Math.abs(y)), 1);
  const scale = Math.min((width / 2 - 10) / wide, (height / 2 - 10) / high);
  pen.setTransform(ratio, 0, 0, ratio, (width / 2) * ratio, (height / 2) * ratio);
  pen.fillStyle = getComputedStyle(picture).color;
  for (const { x, y } of places) {
    pen.beginPath();
    pen.arc(scale * x, -scale * y, Math.min(4, Math.max(1.2, 0.36 * scale * gap)), 0, 2 * Math.PI);
    pen.fill();
  }
}
