// @vitest-environment jsdom
import { beforeEach, describe, expect, it } from 'vitest';
import { element } from './dom';
import { ToolbarFocus } from './toolbar_focus';

let root: HTMLElement;
let buttons: HTMLButtonElement[];

function press(key: string): void {
  document.activeElement!.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true, cancelable: true }));
}

beforeEach(() => {
  buttons = ['one', 'two', 'three'].map((name) => element('button', {}, name));
  root = element('div', { role: 'toolbar' }, ...buttons);
  document.body.replaceChildren(root);
});

describe('ToolbarFocus', () => {
  it('has one Tab stop that follows the focus', () => {
    new ToolbarFocus(root);
    expect(buttons.map((button) => button.tabIndex)).toEqual([0, -1, -1]);
    buttons[1]!.focus();
    expect(buttons.map((button) => button.tabIndex)).toEqual([-1, 0, -1]);
  });
  it('moves by arrows round the ends, Home and End', () => {
    new ToolbarFocus(root);
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
    new ToolbarFocus(root);
    buttons[0]!.focus();
    press('ArrowRight');
    expect(document.activeElement).toBe(buttons[2]);
  });
});
