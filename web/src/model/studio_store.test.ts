import { expect, it } from 'vitest';
import { StudioStore } from './studio_store';

it('tells watchers only of their fields', () => {
  const store = new StudioStore();
  const seen: string[] = [];
  store.watch(['title', 'speed'], (state) => seen.push(`${state.title} ${state.speed}`));
  store.set({ playing: true });
  store.set({ title: 'Open' });
  store.set({ title: 'Open', speed: 2 });
  store.set({ speed: 2 });
  expect(seen).toEqual([' 1', 'Open 1', 'Open 2']);
});
