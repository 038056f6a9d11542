// What directors tell and ask each other is loaded when there is somebody else.

import type { StudioClient } from '../../link/studio_client';
import type { StudioStore } from '../../model/studio_store';
import { once } from '../widgets/lazily';

export interface SharedParts {
  readonly client: StudioClient;
  readonly store: StudioStore;
  readonly page: HTMLElement;
}

export function openSharedLazily(parts: SharedParts): void {
  const { client, store } = parts;
  const loaded = once(async () => {
    const module = await import('./shared_controller');
    return new module.SharedController(parts);
  });
  client.on('sharedWorld', (shared) => store.set({ shared }));
  client.on('ask', ({ number, client: by, request: wish, seconds }) =>
    store.set({ asked: wish === '' ? null : { number, client: by, wish, until: performance.now() + 1000 * seconds } }),
  );
  client.on('link', ({ phase }) => phase !== 'open' && store.set({ asked: null }));
  client.on('scenarios', ({ scenarios }) => store.set({ scenarios }));
  // Who comes or goes is the next try.
  store.watch(['directors'], ({ directors }) => directors.length > 1 && void loaded().catch(() => undefined));
}
