// @vitest-environment jsdom
import { beforeEach, expect, it, vi } from 'vitest';
import type { QueueItem } from '../../model/studio_state';
import { StudioStore } from '../../model/studio_store';
import { QueueBar } from './queue_bar';
import { recordingActions } from '../widgets/test_support';

const calls: string[] = [];
const actions = recordingActions(calls);
let store: StudioStore;
let root: HTMLElement;
const chips = (): HTMLElement[] => [...root.querySelectorAll<HTMLElement>('.queue-chip')];
const act = (label: string): HTMLElement => root.querySelector<HTMLElement>(`.queue-act[aria-label="${label}"]`)!;
const acts = (): HTMLElement => root.querySelector<HTMLElement>('.queue-acts')!;

function item(id: number, more: Partial<QueueItem> = {}): QueueItem {
  return { id, kind: 'move', word: 'Move', arrives: true, span: '0:10', ...more };
}

beforeEach(() => {
  calls.length = 0;
  store = new StudioStore();
  root = new QueueBar(store, actions).root;
  document.body.replaceChildren(root);
  store.set({ loaded: true, queue: [item(31), item(32, { kind: 'guard', word: 'Guard', span: '' }), item(33)] });
});

it('lists the orders, and is hidden where there are none', () => {
  expect(root.hidden).toBe(false);
  expect(chips().map((chip) => chip.getAttribute('aria-label'))).toEqual([
    'Order 1, Move, done in 0:10',
    'Order 2, Guard',
    'Order 3, Move, done in 0:10',
  ]);
  store.set({ queue: [item(31, { arrives: false, span: '' })] });
  expect(chips()[0]!.getAttribute('aria-label')).toBe('Order 1, Move, cannot be reached');
  expect(chips()[0]!.textContent).toBe('1Moveno way');
  store.set({ queue: [] });
  expect(root.hidden).toBe(true);
});

it('keeps its chips while only times change', () => {
  const before = chips();
  store.set({ queue: store.state.queue.map((one) => ({ ...one, span: '0:09' })) });
  expect(chips()).toEqual(before);
  expect(chips()[0]!.lastElementChild!.textContent).toBe('0:09');
});

it('offers what can be done with the chosen order', () => {
  expect(acts().hidden).toBe(true);
  chips()[1]!.click();
  expect(calls).toEqual(['pickOrder 32']);
  store.set({ picked: 32 });
  expect(acts().hidden).toBe(false);
  for (const label of ['Insert', 'Earlier', 'Later', 'Cancel', 'Skip']) act(label).click();
  expect(calls.slice(1)).toEqual([
    'insertBefore 32',
    'moveOrder 32 0',
    'moveOrder 32 2',
    'cancelOrder 32',
    'skipOrder',
  ]);
  store.set({ picked: 31 });
  expect(['Earlier', 'Later'].map((label) => act(label).getAttribute('aria-disabled'))).toEqual(['true', 'false']);
});

it('lets new orders come last, as Shift does', () => {
  act('Add').click();
  store.set({ style: { ...store.state.style, mode: 'append' } });
  expect(act('Add').getAttribute('aria-pressed')).toBe('true');
  act('Add').click();
  expect(calls).toEqual(['setStyle {"mode":"append"}', 'setStyle {"mode":"replace"}']);
});

it('says where the next order goes', () => {
  store.set({ picked: 33, insertBefore: 33 });
  expect(acts().textContent).toContain('before 3');
  expect(act('Insert').getAttribute('aria-pressed')).toBe('true');
  expect(chips().map((chip) => chip.classList.contains('inserting'))).toEqual([false, false, true]);
});

it('a chip that is dragged behind another one moves its order there, and its click chooses nothing', () => {
  const [first, , last] = chips();
  vi.spyOn(last!, 'getBoundingClientRect').mockReturnValue({ left: 200, width: 80 } as DOMRect);
  document.elementsFromPoint = () => [last!];
  first!.setPointerCapture = () => undefined;
  const pointer = (type: string, x: number): void => {
    const event = new MouseEvent(type, { clientX: x, clientY: 10, bubbles: true });
    first!.dispatchEvent(Object.assign(event, { pointerId: 1 }));
  };
  pointer('pointerdown', 40);
  pointer('pointermove', 270);
  expect(last!.classList.contains('drop-after')).toBe(true);
  pointer('pointerup', 270);
  first!.click();
  expect(calls).toEqual(['moveOrder 31 2']);
  pointer('pointerdown', 40);
  pointer('pointermove', 210);
  expect(last!.classList.contains('drop-before')).toBe(true);
  // The queue changes meanwhile: the drag is dropped.
  store.set({ queue: [item(32), item(33)] });
  pointer('pointerup', 210);
  expect(calls).toHaveLength(1);
});
