// What few visitors use is loaded when it is used first. Where that fails, the next try loads once more.

import type { StudioState } from '../../model/studio_state';
import type { StudioStore } from '../../model/studio_store';
import { problem } from '../../protocol/problem';

/** Loads once, however often it is asked; a load that failed is forgotten. */
export function once<Loaded>(load: () => Promise<Loaded>): () => Promise<Loaded> {
  let loaded: Promise<Loaded> | null = null;
  return () =>
    (loaded ??= load().catch((error: unknown) => {
      loaded = null;
      throw error;
    }));
}

/** Says that something could not be loaded; `off` takes back what asked for it. */
export function couldNotLoad(store: StudioStore, off: Partial<StudioState> = {}): void {
  store.set({ ...off, notice: problem('page', 'The server does not answer: try again.') });
}

/** Loads what follows the state by itself as soon as the state wants it. Returns what loads it at once. */
export function loadWhen(
  store: StudioStore,
  fields: readonly (keyof StudioState)[],
  wanted: (state: StudioState) => boolean,
  load: () => Promise<unknown>,
  off: Partial<StudioState> = {},
): () => void {
  const ready = once(load);
  const now = (): void => void ready().catch(() => couldNotLoad(store, off));
  store.watch(fields, (state) => wanted(state) && now());
  return now;
}

/** Loads a panel that a switch of the state opens and closes; <html> has the switch, too. Returns what gives the panel. */
export function openLazily<Panel extends { setOpen(open: boolean): void }>(
  store: StudioStore,
  name: 'build' | 'measures' | 'paths' | 'tracks' | 'words',
  load: () => Promise<Panel>,
): () => Panel | null {
  let panel: Panel | null = null;
  store.watch([name], (state) => {
    document.documentElement.toggleAttribute(`data-${name}`, state[name]);
    panel?.setOpen(state[name]);
  });
  const open = async (): Promise<void> => {
    panel = await load();
    panel.setOpen(store.state[name]);
  };
  loadWhen(store, [name], (state) => state[name], open, { [name]: false });
  return () => panel;
}
