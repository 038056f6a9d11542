// @vitest-environment jsdom
import { beforeEach, describe, expect, it } from 'vitest';
import { element } from './dom';
import { Popup } from './popup';

let button: HTMLButtonElement;
let panel: HTMLElement;
let popup: Popup;

function press(key: string): void {
  document.activeElement!.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true, cancelable: true }));
}

beforeEach(() => {
  button = element('button', {}, 'open');
  panel = element('div', {}, element('button', {}, 'a'), element('button', { 'aria-current': 'true' }, 'b'));
  document.body.replaceChildren(button, panel);
  popup = new Popup(button, panel);
});

describe('Popup', () => {
  it('opens on the current item and says so', () => {
    expect(panel.hidden).toBe(true);
    button.click();
    expect(panel.hidden).toBe(false);
    expect(button.getAttribute('aria-expanded')).toBe('true');
    expect(document.activeElement!.textContent).toBe('b');
  });
  it('moves by arrows and gives the focus back on Escape', () => {
    popup.open();
    press('ArrowDown');
    expect(document.activeElement!.textContent).toBe('a');
    press('End');
    expect(document.activeElement!.textContent).toBe('b');
    press('Home');
    expect(document.activeElement!.textContent).toBe('a');
    press('Escape');
    expect(popup.isOpen).toBe(false);
    expect(document.activeElement).toBe(button);
  });
  it('closes on a press elsewhere, not on one inside', () => {
    popup.open();
    panel.dispatchEvent(new Event('pointerdown', { bubbles: true }));
    expect(popup.isOpen).toBe(true);
    document.body.dispatchEvent(new Event('pointerdown', { bubbles: true }));
    expect(popup.isOpen).toBe(false);
  });
});
