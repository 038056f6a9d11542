// @vitest-environment jsdom
import { expect, it } from 'vitest';
import { guardBackdrops } from './backdrop_press';
import { element } from './dom';

it('lets a click close a dialog only where its press began on the backdrop', () => {
  guardBackdrops(document);
  const [button, dialog] = [element('button', {}), element('dialog', {})];
  document.body.replaceChildren(button, dialog);
  let closed = 0;
  dialog.addEventListener('click', ({ target }) => void (target === dialog && closed++));
  const press = (target: Element): unknown => target.dispatchEvent(new Event('pointerdown', { bubbles: true }));
  const click = (target: Element): unknown => target.dispatchEvent(new MouseEvent('click', { bubbles: true }));
  press(button);
  click(dialog);
  expect(closed).toBe(0);
  press(dialog);
  click(dialog);
  expect(closed).toBe(1);
});
