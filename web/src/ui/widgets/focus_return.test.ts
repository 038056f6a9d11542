// @vitest-environment jsdom
import { beforeEach, expect, it } from 'vitest';
import { element } from './dom';
import { returnFocus } from './focus_return';

let scene: HTMLElement;
let root: HTMLElement;
let button: HTMLButtonElement;

beforeEach(() => {
  scene = element('canvas', { tabindex: 0 });
  button = element('button', {}, 'Play');
  root = element('div', {}, button);
  document.body.replaceChildren(scene, root);
  returnFocus(root, scene);
});

function click(target: HTMLElement, detail: number): void {
  target.focus();
  target.dispatchEvent(new MouseEvent('click', { bubbles: true, detail }));
}

it('gives the focus back after a press of a pointer, not after one of a key', () => {
  click(button, 1);
  expect(document.activeElement).toBe(scene);
  click(button, 0);
  expect(document.activeElement).toBe(button);
});

it('leaves the focus in a list that is open, and takes it when a choice closed it', () => {
  const item = element('button', {}, 'One');
  const list = element('div', { role: 'group' }, item);
  root.append(list);
  button.setAttribute('aria-expanded', 'false');
  button.addEventListener('click', () => {
    button.setAttribute('aria-expanded', 'true');
    item.focus();
  });
  item.addEventListener('click', () => {
    button.setAttribute('aria-expanded', 'false');
    button.focus();
  });
  click(button, 1);
  expect(document.activeElement).toBe(item);
  click(item, 1);
  expect(document.activeElement).toBe(scene);
});

it('leaves the focus in a dialog', () => {
  const inside = element('button', {}, 'Close');
  const dialog = element('dialog', { open: true }, inside);
  root.append(dialog);
  click(inside, 1);
  expect(document.activeElement).toBe(inside);
  dialog.removeAttribute('open');
  click(button, 1);
  expect(document.activeElement).toBe(scene);
});
