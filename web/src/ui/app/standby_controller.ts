// Going on without the server: the engine is loaded while nothing else is, and waits.

import { NoticeLevel } from '../../protocol/messages';
import { problem } from '../../protocol/problem';
import type { StudioClient } from '../../link/studio_client';
import type { EnginePort } from '../../link/engine/engine_link';
import { Standby } from '../../link/engine/standby';
import type { StudioStore } from '../../model/studio_store';

/** After so many attempts of a page that has never reached its server, it goes on without one. */
const kMostAttempts = 3;
/** The engine is loaded when the crowd has walked for a moment [ms]. */
const kLoadAfter = 1500;
const kWords =
  'This browser simulates now, for you alone. Takes are kept in it. Load the page again to return to the server.';

const makeWorker = (): EnginePort =>
  new Worker(new URL('../../link/engine/engine_worker.ts', import.meta.url), { type: 'module' });

/** What the page loads when it is first used, and could not without a server. */
async function loadTheRest(): Promise<void> {
  await Promise.all([
    import('../build/build_controller'),
    import('../takes/take_controller'),
    import('../takes/path/path_controller'),
    import('../takes/tracks/tracks_controller'),
    import('../takes/film_writer'),
    import('../formations/sequence/sequence_controller'),
    import('../formations/shape_dialogs'),
    import('../formations/group_ghost'),
    import('../places/place_controller'),
    import('../measures/measure_controller'),
    import('../orders/words_controller'),
    import('../../tools/ground_cursor'),
    import('../../model/spot_words'),
    import('../../scene/crowd/own_character/own_character'),
    import('../../scene/scenery/model_file'),
  ]);
}

/** `folder` of the engine's files, relative to the page. */
export function standBy(client: StudioClient, store: StudioStore, folder: string): void {
  const base = new URL(folder, document.baseURI).href;
  const tell = (reason: string): void => client.tell(problem('engine', `The engine cannot run here: ${reason}`));
  const standby = new Standby({
    client,
    base,
    makeWorker,
    askServer: (path, init) => fetch(path, init),
    hidden: () => document.hidden,
    failed: tell,
  });
  const goOn = async (): Promise<void> => {
    await standby.goOn('');
    store.set({ standby: 'none' });
    client.tell({ ...problem('alone', kWords), level: NoticeLevel.Info });
  };
  const prepare = async (): Promise<void> => {
    await standby.prepare();
    standby.keep();
    store.set({ standby: 'ready' });
    await loadTheRest();
  };
  const stopWaiting = client.on('frame', () => {
    stopWaiting();
    // Without it the page is as it was: a lost server is waited for.
    setTimeout(() => void prepare().catch(() => undefined), kLoadAfter);
  });
  store.watch(['standby'], ({ standby: now }) => {
    if (now === 'wanted')
      goOn().catch((error: unknown) => {
        store.set({ standby: 'ready' });
        tell(error instanceof Error ? error.message : String(error));
      });
  });
  client.on('link', (link) => {
    const neverCame = client.clientId === 0 && link.phase === 'lost' && link.attempt >= kMostAttempts;
    if (neverCame && store.state.standby === 'none') store.set({ standby: 'wanted' });
  });
}
