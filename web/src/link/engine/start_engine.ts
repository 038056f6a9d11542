// Brings up the engine beside the page, and connects the studio to it.

import { answerBy } from '../answers';
import { problem } from '../../protocol/problem';
import { openShared, sharedIn } from '../shared_link';
import type { StudioClient } from '../studio_client';
import { EngineLink, type EnginePort } from './engine_link';

const makeWorker = (): EnginePort => new Worker(new URL('./engine_worker.ts', import.meta.url), { type: 'module' });

/** The scenario that the address asks for: "#scenario=market". */
function wantedScenario(hash: string): string {
  return new URLSearchParams(hash.replace(/^#/, '')).get('scenario') ?? '';
}

/** Most threads of a world: more bring little to crowds of browsers. */
const kMostThreads = 8;

/** Threads share memory on isolated pages only, which the service worker makes of all visits but the first. A core is left for
 * the picture; `?threads=` in the address asks for another number. */
function threadsHere(): number {
  if (!crossOriginIsolated || document.documentElement.dataset['threads'] === undefined) return 1;
  const asked = Number(new URLSearchParams(location.search).get('threads') ?? navigator.hardwareConcurrency - 1);
  return Math.min(Math.max(1, Math.floor(asked) || 1), kMostThreads);
}

/** A place or a take inside the address is opened. */
async function openLink(): Promise<void> {
  const shared = await sharedIn(location.hash);
  if (shared) await openShared(shared);
}

function messageOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}

/** `folder` of the engine's files, relative to the page. Once people are `seen` the rest is loaded, and kept. */
export function startEngine(client: StudioClient, folder: string, seen: Promise<void>): void {
  const base = new URL(folder, document.baseURI).href;
  const fallback = document.documentElement.dataset['scenario'] ?? '';
  const scenario = wantedScenario(location.hash) || fallback;
  const link = new EngineLink(makeWorker(), { base, scenario, threads: threadsHere() }, makeWorker, (reason) =>
    client.tell(problem('engine', `The engine cannot run here: ${reason}`)),
  );
  answerBy(link.ask);
  client.connectEngine(link.port);
  void seen.then(() => {
    link.complete();
    // Keeps the site's files for visits without a network; a browser that has no such workers loads it each time.
    void navigator.serviceWorker?.register('service_worker.js').catch(() => undefined);
  });
  const openFragment = (): void => {
    openLink().catch((error: unknown) => client.tell(problem('link', messageOf(error))));
  };
  openFragment();
  window.addEventListener('hashchange', openFragment);
}
