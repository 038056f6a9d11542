// What the address of the page names is opened: a place or a take on the studio's server, or one inside the link.

import { hasEngine } from '../../link/answers';
import type { StudioClient } from '../../link/studio_client';
import { openingOf, takeOpeningOf, whenAllowed } from '../../model/consent';
import type { StudioStore } from '../../model/studio_store';
import { problem } from '../../protocol/problem';

function forget(): void {
  history.replaceState(null, '', location.pathname + location.search);
}

export function openLinksLazily({ client, store }: { client: StudioClient; store: StudioStore }): void {
  const failed = (error: unknown): void =>
    store.set({ notice: problem('link', error instanceof Error ? error.message : String(error)) });
  const openTake = async (name: string): Promise<void> => {
    const module = await import('../../link/shelf_link');
    const shelf = new module.ShelfLink();
    const found = (await shelf.list()).find((one) => one.name === name);
    if (!found) throw new Error('The take of this link is not here any more.');
    const open = (): void => void shelf.open(name).catch(failed);
    whenAllowed(store, takeOpeningOf(found.title || found.scenario), open);
  };
  const openWhole = async (hash: string): Promise<void> => {
    const { openShared, sharedIn } = await import('../../link/shared_link');
    const shared = await sharedIn(hash);
    if (shared)
      whenAllowed(store, openingOf(`the ${shared.kind} of a link`), () => void openShared(shared).catch(failed));
  };
  const follow = (): void => {
    const { hash } = location;
    if (hasEngine() || hash === '') return;
    const wanted = new URLSearchParams(hash.slice(1));
    const [scenario, take] = [wanted.get('scenario'), wanted.get('shelved')];
    forget();
    if (take) openTake(take).catch(failed);
    else if (!scenario) openWhole(hash).catch(failed);
    else if (scenario !== store.state.scenario) {
      const title = store.state.scenarios.find(({ name }) => name === scenario)?.title || scenario;
      whenAllowed(store, openingOf(title), () => client.send({ type: 'LoadScenario', name: scenario }));
    }
  };
  const stop = client.on('scene', () => {
    stop();
    follow();
    window.addEventListener('hashchange', follow);
  });
}
