// The tracks of a take are loaded when somebody unfolds them.

import type { StudioClient } from '../../link/studio_client';
import type { StudioStore } from '../../model/studio_store';
import { problem } from '../../protocol/problem';
import type { TracksController, TracksHost, TracksShown } from './tracks/tracks_controller';

export class LazyTracks {
  private controller_: TracksController | null = null;
  private loading_ = false;
  private shown_: TracksShown = { take: null, step: 0, keys: [], films: false };

  /** Below the time line. */
  constructor(
    private readonly client_: StudioClient,
    private readonly store_: StudioStore,
    private readonly host_: TracksHost,
    private readonly line_: HTMLElement,
  ) {
    store_.watch(['tracks'], ({ tracks }) => this.setOpen(tracks));
  }

  show(shown: Partial<TracksShown>): void {
    this.shown_ = { ...this.shown_, ...shown };
    this.controller_?.show(this.shown_);
  }

  private setOpen(open: boolean): void {
    document.documentElement.toggleAttribute('data-tracks', open);
    if (this.controller_) return this.controller_.setOpen(open);
    if (!open || this.loading_) return;
    this.loading_ = true;
    import('./tracks/tracks_controller')
      .then((module) => {
        this.controller_ = new module.TracksController(this.client_, this.store_, this.host_);
        this.line_.append(this.controller_.root);
        this.controller_.show(this.shown_);
        this.controller_.setOpen(this.store_.state.tracks);
      })
      .catch(() =>
        this.store_.set({ tracks: false, notice: problem('page', 'The server does not answer: try again.') }),
      )
      .finally(() => (this.loading_ = false));
  }
}
