// The tracks of a take are loaded when somebody unfolds them.

import type { StudioClient } from '../../link/studio_client';
import type { StudioStore } from '../../model/studio_store';
import { openLazily } from '../widgets/lazily';
import type { TracksController, TracksHost, TracksShown } from './tracks/tracks_controller';

export class LazyTracks {
  private readonly tracks_: () => TracksController | null;
  private shown_: TracksShown = { take: null, step: 0, keys: [], films: false };

  /** Below the time line. */
  constructor(client: StudioClient, store: StudioStore, host: TracksHost, line: HTMLElement) {
    this.tracks_ = openLazily(store, 'tracks', async () => {
      const module = await import('./tracks/tracks_controller');
      const controller = new module.TracksController(client, store, host);
      line.append(controller.root);
      controller.show(this.shown_);
      return controller;
    });
  }

  show(shown: Partial<TracksShown>): void {
    this.shown_ = { ...this.shown_, ...shown };
    this.tracks_()?.show(this.shown_);
  }
}
