import { beforeEach, expect, it, vi } from 'vitest';
import { StudioStore } from '../../model/studio_store';
import type { ClientMessage } from '../../protocol/messages';
import { HistoryController } from './history_controller';

let sent: ClientMessage[];
let store: StudioStore;
let controller: HistoryController;
const told = (): string | undefined => store.state.notice?.text;

function server(undo: number, undoLabel: string, redo = 0, redoLabel = ''): void {
  controller.took({ undo, undoLabel, redo, redoLabel });
}

beforeEach(() => {
  vi.useFakeTimers();
  sent = [];
  store = new StudioStore();
  controller = new HistoryController({ send: (one) => sent.push(one) }, store);
});

it('tells what was taken back and done again, for a moment', () => {
  server(2, 'Change shape');
  controller.undo();
  server(1, 'Move', 1, 'Change shape');
  expect(told()).toBe('Undone: Change shape');
  controller.undo(true);
  server(2, 'Change shape');
  expect(told()).toBe('Done again: Change shape');
  vi.advanceTimersByTime(5000);
  expect(store.state.notice).toBeNull();
  expect(sent.length).toBe(2);
});

it('says that the crowd walks back from where it was dragged', () => {
  server(1, 'Drag');
  controller.undo();
  server(0, '', 1, 'Drag');
  expect(told()).toBe('Undone: Drag. The crowd walks back');
  controller.undo(true);
  server(1, 'Drag');
  expect(told()).toBe('Done again: Drag');
});

it('takes back two edits that belong together at once, and does both again', () => {
  server(3, 'Add source');
  controller.undo();
  server(2, 'Add source, first', 1, 'Add source');
  expect(told()).toBeUndefined();
  server(1, 'Move', 2, 'Add source, first');
  expect(told()).toBe('Undone: Add source');
  controller.undo(true);
  server(2, 'Add source, first', 1, 'Add source');
  server(3, 'Add source');
  expect(told()).toBe('Done again: Add source');
  expect(sent.map((one) => one.type === 'UndoEdit' && one.redo)).toEqual([false, false, true, true]);
});

it('says nothing of what others, or we ourselves, do meanwhile', () => {
  server(1, 'Move');
  expect(store.state.notice).toBeNull();
  controller.undo();
  server(2, 'Cohesion');
  expect(store.state.notice).toBeNull();
  server(1, 'Move', 1, 'Cohesion');
  expect(told()).toBe('Undone: Cohesion');
});

it('says where nothing was left of it, and where there is nothing', () => {
  server(1, 'Move');
  controller.undo();
  server(0, '');
  expect(told()).toBe('Nothing of it was left');
  controller.undo();
  expect(told()).toBe('There is nothing to undo');
  controller.undo(true);
  expect(told()).toBe('There is nothing to redo');
  expect(sent.length).toBe(1);
});

it('says what Escape lets go of, where there is nothing to undo', () => {
  new HistoryController({ send: () => undefined }, store, () => 'line').undo();
  expect(told()).toBe('There is nothing to undo. Esc lets go of the line');
});
