// @vitest-environment jsdom
import { beforeEach, expect, it, vi } from 'vitest';
import type { StudioActions } from '../../model/studio_actions';
import { PlaybackBar } from './playback_bar';
import { StudioStore } from '../../model/studio_store';

let store: StudioStore;
let bar: PlaybackBar;
let root: HTMLElement;
const leaveReplay = vi.fn();
const toggleRecord = vi.fn();
const toggleDemonstration = vi.fn();
const ourPeople = vi.fn();

beforeEach(() => {
  store = new StudioStore();
  bar = new PlaybackBar(store, {
    leaveReplay,
    toggleRecord,
    toggleDemonstration,
    ourPeople,
  } as unknown as StudioActions);
  root = bar.root;
  document.body.replaceChildren(root);
});

it('tells of a replay, does not record in it, and leaves it', () => {
  const replay = root.querySelector<HTMLElement>('.replay')!;
  const record = root.querySelector<HTMLButtonElement>('.record')!;
  expect([replay.hidden, record.disabled]).toEqual([true, false]);
  store.set({ replaying: true });
  expect([replay.hidden, record.disabled]).toEqual([false, true]);
  expect(replay.textContent).toContain('Replay');
  record.click();
  expect(toggleRecord).not.toHaveBeenCalled();
  replay.querySelector('button')!.click();
  expect(leaveReplay).toHaveBeenCalledTimes(1);
  store.set({ replaying: false });
  expect([replay.hidden, record.disabled]).toEqual([true, false]);
});

it('offers to watch only where there is something, and shows that it runs', () => {
  const watch = root.querySelector<HTMLButtonElement>('.watch')!;
  expect(watch.hidden).toBe(true);
  store.set({ demonstration: true });
  expect([watch.hidden, watch.getAttribute('aria-pressed'), watch.tabIndex]).toEqual([false, 'false', -1]);
  watch.click();
  expect(toggleDemonstration).toHaveBeenCalledTimes(1);
  store.set({ demonstrating: true });
  expect(watch.getAttribute('aria-pressed')).toBe('true');
  expect(watch.getAttribute('data-tip')).toContain('back to the start');
  store.set({ demonstration: false, demonstrating: false });
  expect([watch.hidden, watch.getAttribute('aria-pressed')]).toEqual([true, 'false']);
});

it('offers a character of one’s own, and our people back while there is one', () => {
  const items = [...root.querySelectorAll<HTMLButtonElement>('.take-list button')];
  const named = (text: string): HTMLButtonElement => items.find((item) => item.textContent === text)!;
  expect(named('Our people').hidden).toBe(true);
  const input = bar.inputs.find(({ multiple }) => multiple)!;
  const click = vi.spyOn(input, 'click').mockImplementation(() => undefined);
  named('Own character…').click();
  expect(click).toHaveBeenCalledTimes(1);
  store.set({ ownCharacter: 'robot.glb' });
  expect(named('Our people').hidden).toBe(false);
  named('Our people').click();
  expect(ourPeople).toHaveBeenCalledTimes(1);
});
