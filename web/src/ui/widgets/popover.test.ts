// @vitest-environment jsdom
import { beforeEach, describe, expect, it } from 'vitest';
import { element } from './dom';
import { Popover } from './popover';

let button: HTMLButtonElement;
let panel: HTMLElement;
let popover: Popover;

function press(key: string): void {
  document.activeElement!.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true, cancelable: true }));
}

beforeEach(() => {
  button = element('button', {}, 'open');
  panel = element('div', {}, element('button', {}, 'a'), element('button', { 'aria-current': 'true' }, 'b'));
  document.body.replaceChildren(button, panel);
  popover = new Popover(button, panel);
});

describe('Popover', () => {
  it('opens on the current item and says so', () => {
    expect(panel.hidden).toBe(true);
    button.click();
    expect(panel.hidden).toBe(false);
    expect(button.getAttribute('aria-expanded')).toBe('true');
    expect(document.activeElement!.textContent).toBe('b');
  });
  it('moves by arrows and gives the focus back on Escape', () => {
    popover.open();
    press('ArrowDown');
    expect(document.activeElement!.textContent).toBe('a');
    press('End');
    expect(document.activeElement!.textContent).toBe('b');
    press('Home');
    expect(document.activeElement!.textContent).toBe('a');
    press('Escape');
    expect(popover.isOpen).toBe(false);
    expect(document.activeElement).toBe(button);
  });
  it('closes on a press elsewhere, not on one inside', () => {
    popover.open();
    panel.dispatchEvent(new Event('pointerdown', { bubbles: true }));
    expect(popover.isOpen).toBe(true);
    document.body.dispatchEvent(new Event('pointerdown', { bubbles: true }));
    expect(popover.isOpen).toBe(false);
  });
});
