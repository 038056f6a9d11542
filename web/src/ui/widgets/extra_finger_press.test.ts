// @vitest-environment jsdom
import { beforeEach, describe, expect, it } from 'vitest';
import { pressWithExtraFingers } from './extra_finger_press';

let buttons: HTMLButtonElement[];
let clicks: string[];

function fire(target: EventTarget, type: string, fields: Record<string, unknown> = {}): void {
  const event = new Event(type, { bubbles: true });
  Object.assign(event, { pointerId: 2, pointerType: 'touch', isPrimary: false, ...fields });
  target.dispatchEvent(event);
}

beforeEach(() => {
  clicks = [];
  document.body.innerHTML = '<div><button><span>a</span></button><button>b</button></div>';
  buttons = [...document.querySelectorAll('button')];
  for (const button of buttons) button.addEventListener('click', () => clicks.push(button.textContent));
  pressWithExtraFingers(document.querySelector('div')!);
});

describe('pressWithExtraFingers', () => {
  it('presses a button by a second finger, also on what lies in it', () => {
    fire(buttons[0]!.firstElementChild!, 'pointerdown');
    fire(buttons[0]!, 'pointerup');
    expect(clicks).toEqual(['a']);
  });
  it('leaves first fingers and the mouse to the browser', () => {
    for (const fields of [{ isPrimary: true }, { pointerType: 'mouse' }]) {
      fire(buttons[0]!, 'pointerdown', fields);
      fire(buttons[0]!, 'pointerup', fields);
    }
    expect(clicks).toEqual([]);
  });
  it('forgets a finger that slid away or was taken', () => {
    fire(buttons[0]!, 'pointerdown');
    fire(buttons[1]!, 'pointerup');
    fire(buttons[0]!, 'pointerdown');
    fire(buttons[0]!, 'pointercancel');
    fire(buttons[0]!, 'pointerup');
    expect(clicks).toEqual([]);
  });
});
