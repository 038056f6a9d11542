// What directors tell and ask each other is loaded when there is somebody else.

import type { StudioClient } from '../../link/studio_client';
import type { StudioStore } from '../../model/studio_store';

export interface SharedParts {
  readonly client: StudioClient;
  readonly store: StudioStore;
  readonly page: HTMLElement;
}

export function openSharedLazily(parts: SharedParts): void {
  const { client, store } = parts;
  let loaded: Promise<unknown> | null = null;
  client.on('sharedWorld', (shared) => store.set({ shared }));
  client.on('ask', ({ number, client: by, request: wish, seconds }) =>
    store.set({ asked: wish === '' ? null : { number, client: by, wish, until: performance.now() + 1000 * seconds } }),
  );
  client.on('link', ({ phase }) => phase !== 'open' && store.set({ asked: null }));
  client.on('scenarios', ({ scenarios }) => store.set({ scenarios }));
  store.watch(['directors'], ({ directors }) => {
    if (directors.length < 2) return;
    loaded ??= import('./shared_controller').then(
      (module) => new module.SharedController(parts),
      () => (loaded = null),
    );
  });
}
