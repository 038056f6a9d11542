// @vitest-environment jsdom
import { beforeEach, describe, expect, it, vi } from 'vitest';
import { ShortcutHandler, findShortcut, type Shortcut } from './shortcuts';
import { SpaceKey } from './space_key';

const run = vi.fn();
const shortcuts: Shortcut[] = [
  { keys: 'R', does: '', group: 'Time', match: ['r'], run },
  { keys: 'Enter', does: '', group: 'Crowd', match: ['Enter'], run, sceneOnly: true },
];

function press(target: EventTarget, key: string, type = 'keydown'): KeyboardEvent {
  const event = new KeyboardEvent(type, { key, bubbles: true, cancelable: true });
  target.dispatchEvent(event);
  return event;
}

beforeEach(() => {
  run.mockReset();
  document.body.innerHTML = '<button>b</button><input><dialog><p>x</p></dialog>';
});

describe('findShortcut', () => {
  const event = (key: string, target: EventTarget | null, ctrlKey = false) => ({
    key,
    code: '',
    altKey: false,
    target,
    ctrlKey,
    metaKey: false,
  });
  it('takes letters of either case, but leaves Ctrl to the browser', () => {
    expect(findShortcut(shortcuts, event('R', document.body))?.keys).toBe('R');
    expect(findShortcut(shortcuts, event('r', document.body, true))).toBeNull();
  });
  it('keeps out of text fields and dialogs; Enter stays with a focused button', () => {
    expect(findShortcut(shortcuts, event('r', document.querySelector('input')))).toBeNull();
    expect(findShortcut(shortcuts, event('r', document.querySelector('p')))).toBeNull();
    expect(findShortcut(shortcuts, event('Enter', document.querySelector('button')))).toBeNull();
    expect(findShortcut(shortcuts, event('r', document.querySelector('button')))?.keys).toBe('R');
  });
});

it('ShortcutHandler runs once and stops the default', () => {
  const root = document.createElement('div');
  document.body.append(root);
  new ShortcutHandler(root, shortcuts);
  expect(press(root, 'r').defaultPrevented).toBe(true);
  expect(press(root, 'x').defaultPrevented).toBe(false);
  expect(run).toHaveBeenCalledTimes(1);
});

it('a held key acts once, unless it is one that repeats', () => {
  const root = document.createElement('div');
  document.body.append(root);
  const zoom = vi.fn();
  new ShortcutHandler(root, [
    ...shortcuts,
    { keys: '+', does: '', group: 'Camera', match: ['+'], run: zoom, repeats: true },
  ]);
  for (const [key, repeat] of [
    ['r', false],
    ['r', true],
    ['+', false],
    ['+', true],
  ] as const) {
    const event = new KeyboardEvent('keydown', { key, repeat, cancelable: true });
    root.dispatchEvent(event);
    expect(event.defaultPrevented).toBe(true);
  }
  expect(run).toHaveBeenCalledTimes(1);
  expect(zoom).toHaveBeenCalledTimes(2);
});

describe('SpaceKey', () => {
  it('plays on a tap, pans while the mouse drags, and leaves buttons alone', () => {
    const panning: boolean[] = [];
    let taps = 0;
    new SpaceKey(
      document,
      (held) => panning.push(held),
      () => (taps += 1),
    );
    press(document.body, ' ');
    press(document.body, ' ', 'keyup');
    expect([taps, panning]).toEqual([1, [true, false]]);
    press(document.body, ' ');
    document.body.dispatchEvent(new Event('pointerdown', { bubbles: true }));
    press(document.body, ' ', 'keyup');
    expect(taps).toBe(1);
    press(document.querySelector('button')!, ' ');
    press(document.querySelector('button')!, ' ', 'keyup');
    expect(taps).toBe(1);
  });
});
