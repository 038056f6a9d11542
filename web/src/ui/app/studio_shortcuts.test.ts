// @vitest-environment jsdom
import { expect, it } from 'vitest';
import { findShortcut } from '../../tools/shortcuts';
import type { OrderActions } from '../../model/order_actions';
import type { StudioActions } from '../../model/studio_actions';
import { studioShortcuts, type KeyTools } from './studio_shortcuts';

const calls: string[] = [];
const recorder = new Proxy(
  {},
  {
    get:
      (_, name) =>
      (...values: unknown[]) =>
        calls.push([name, ...values].map(String).join(' ')),
  },
);
const shortcuts = studioShortcuts(recorder as StudioActions, recorder as OrderActions, recorder as KeyTools);

function press(key: string, shiftKey = false, code = ''): string | undefined {
  calls.length = 0;
  const event = { key, code, shiftKey, ctrlKey: false, metaKey: false, altKey: code !== '', target: null };
  findShortcut(shortcuts, event)?.run!(event as unknown as KeyboardEvent);
  return calls[0];
}

it('every key does what the help says', () => {
  expect(press('3')).toBe('setFormation column');
  expect(press('8')).toBe('setFormation pacman');
  expect(press('.')).toBe('singleStep');
  expect(press('R')).toBe('toggleRecord');
  expect(press('+')).toBe('zoom 1.2');
  expect(press('<')).toBe('nextSpeed true');
  expect(press('ArrowLeft', true)).toBe('arrow ArrowLeft true');
  expect(press('f')).toBe('fit');
  expect(press('c')).toBe('toggleOverlay 2');
  expect(press('?')).toBe('showHelp true');
  expect(press('p')).toBe('togglePin');
  expect(press('i')).toBe('toggleFollow');
  expect(press('0')).toBe('toggleClean');
  expect(press('†', false, 'KeyT')).toBe('toggleTop');
  expect(press('o', false, 'KeyO')).toBe('toggleFlat');
  expect(press('!', true, 'Digit1')).toBe('saveView 1');
  expect(press('3', false, 'Digit3')).toBe('showView 3');
  expect(press('r', false, 'KeyR')).toBeUndefined();
  expect(press('x')).toBe('toggleTool cut');
  expect(press('s')).toBe('stop');
  expect(press('k')).toBe('toggleHold');
  expect(press('a')).toBe('chooseAll');
});

it('only camera, steps and carrying repeat while a key is held', () => {
  const repeated = shortcuts.filter((shortcut) => shortcut.repeats).flatMap((shortcut) => shortcut.match);
  expect(repeated.sort()).toEqual(['+', '-', '.', '=', 'ArrowDown', 'ArrowLeft', 'ArrowRight', 'ArrowUp', 'e', 'q']);
});

it('no key means two things', () => {
  const keys = shortcuts.flatMap((one) =>
    one.run ? one.match.map((key) => (one.ctrl === 'only' ? `Ctrl+${key}` : key)) : [],
  );
  expect(new Set(keys).size).toBe(keys.length);
});

it('takes back and does again, with Ctrl and without', () => {
  const keyed = (key: string, ctrlKey: boolean, shiftKey = false): string | undefined => {
    calls.length = 0;
    const event = { key, code: '', shiftKey, ctrlKey, metaKey: false, altKey: false, target: null };
    findShortcut(shortcuts, event)?.run!(event as unknown as KeyboardEvent);
    return calls[0];
  };
  expect([keyed('z', false), keyed('z', true)]).toEqual(['undo false', 'undo false']);
  expect([keyed('Z', false, true), keyed('Z', true, true), keyed('y', true)]).toEqual(Array(3).fill('undo true'));
  expect(keyed('y', false)).toBe('skipOrder');
});
