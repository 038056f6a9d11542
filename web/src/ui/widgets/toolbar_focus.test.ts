// @vitest-environment jsdom
import { beforeEach, describe, expect, it } from 'vitest';
import { element } from './dom';
import { ToolbarFocus } from './toolbar_focus';
import { StudioStore } from '../../model/studio_store';

let root: HTMLElement;
let buttons: HTMLButtonElement[];
let store: StudioStore;

function press(key: string): void {
  document.activeElement!.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true, cancelable: true }));
}

beforeEach(() => {
  store = new StudioStore();
  buttons = ['one', 'two', 'three'].map((name) => element('button', {}, name));
  root = element('div', { role: 'toolbar' }, ...buttons);
  document.body.replaceChildren(root);
});

describe('ToolbarFocus', () => {
  it('has one Tab stop that follows the focus', () => {
    new ToolbarFocus(root, store);
    expect(buttons.map((button) => button.tabIndex)).toEqual([0, -1, -1]);
    buttons[1]!.focus();
    expect(buttons.map((button) => button.tabIndex)).toEqual([-1, 0, -1]);
  });
  it('moves by arrows round the ends, Home and End', () => {
    new ToolbarFocus(root, store);
    buttons[0]!.focus();
    press('ArrowLeft');
    expect(document.activeElement).toBe(buttons[2]);
    press('ArrowRight');
    expect(document.activeElement).toBe(buttons[0]);
    press('End');
    expect(document.activeElement).toBe(buttons[2]);
    press('Home');
    expect(document.activeElement).toBe(buttons[0]);
  });
  it('passes hidden buttons over', () => {
    buttons[1]!.hidden = true;
    new ToolbarFocus(root, store);
    buttons[0]!.focus();
    press('ArrowRight');
    expect(document.activeElement).toBe(buttons[2]);
  });
  it('moves the Tab stop when a layout hides its button', () => {
    new ToolbarFocus(root, store);
    expect(buttons[0]!.tabIndex).toBe(0);
    // As a layout's style would.
    const holder = element('span', { style: 'display: none' });
    root.prepend(holder);
    holder.append(buttons[0]!);
    store.set({ layout: 'phone' });
    expect(buttons.slice(1).map((button) => button.tabIndex)).toEqual([0, -1]);
    holder.style.display = '';
    store.set({ layout: 'desktop' });
    expect(buttons.map((button) => button.tabIndex).filter((index) => index === 0)).toHaveLength(1);
  });
  it('passes over what is inert or disabled', () => {
    buttons[0]!.setAttribute('inert', '');
    buttons[1]!.disabled = true;
    new ToolbarFocus(root, store);
    expect(buttons[2]!.tabIndex).toBe(0);
  });
  it('leaves lists that its buttons open to themselves', () => {
    const item = element('button', {}, 'item');
    root.append(element('div', { role: 'group' }, item));
    new ToolbarFocus(root, store);
    item.focus();
    expect(buttons.map((button) => button.tabIndex)).toEqual([0, -1, -1]);
  });
});
