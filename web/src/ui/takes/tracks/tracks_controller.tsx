// The tracks of the open take, unfolded below its time line: what is chosen, dragged and told, and what the server makes of it.

import { render } from 'preact';
import type { StudioClient } from '../../../link/studio_client';
import { fitted, foundAgain, xOf, zoomed, type TimeWindow } from '../../../model/take_tracks';
import { shownOf, type OpenTake } from '../../../model/take_facts';
import type { StudioStore } from '../../../model/studio_store';
import { TrackEdit, type Notice, type TakeBlock, type TakeTracks } from '../../../protocol/messages';
import type { CameraKey } from '../../../scene/camera/film_camera';
import { element } from '../../widgets/dom';
import type { Chosen, TrackActions, TrackDrag, TracksState } from './track_actions';
import { TrackKeys } from './track_keys';
import { TrackPointer } from './track_pointer';
import { TrackRows } from './track_rows';
import { TrackTools } from './track_tools';
import '../../styles/tracks.css';

/** What of the time line and the film camera the tracks need. */
export interface TracksHost {
  beginScrub(): void;
  seek(step: number): void;
  endScrub(): void;
  keepView(): void;
  takeView(step: number): void;
  moveView(step: number, to: number): void;
  cutView(step: number, cut: boolean): void;
  removeView(step: number): void;
}

/** What the tracks show of the take that is open. */
export interface TracksShown {
  readonly take: OpenTake | null;
  readonly step: number;
  readonly keys: readonly CameraKey[];
  readonly films: boolean;
}

/** By what a block is found again in a changed take. */
type BlockFacts = Pick<TakeBlock, 'group' | 'label' | 'begin'>;

/** Keys that move something by little count together until none comes for so long [ms]. */
const kRests = 600;
const kReading = 'The take is being read…';
const kAgain = 'Everything is simulated again…';
const kEdits = { move: TrackEdit.Move, copy: TrackEdit.Copy, stretch: TrackEdit.Stretch } as const;

export class TracksController implements TrackActions {
  readonly root = element('section', { class: 'tracks', 'aria-label': 'Tracks', hidden: true });
  private readonly tools_ = element('div', { class: 'tracks-tools' });
  private readonly rows_ = element('div', { class: 'tracks-rows' });
  private readonly content_ = element('div', { class: 'tracks-content' });
  private readonly head_ = element('div', { class: 'tracks-head', 'aria-hidden': 'true' });
  private shown_: TracksShown = { take: null, step: 0, keys: [], films: false };
  private tracks_: TakeTracks | null = null;
  private window_: TimeWindow = { from: 0, to: 1 };
  private width_ = 0;
  private chosen_: Chosen = null;
  private drag_: TrackDrag | null = null;
  private held_: BlockFacts | null = null;
  private words_ = kReading;
  /** A change that the server makes, and the block that comes of it. */
  private waits_: BlockFacts | null | undefined;
  private rest_ = 0;
  private open_ = false;

  constructor(
    private readonly client_: StudioClient,
    private readonly store_: StudioStore,
    private readonly host_: TracksHost,
  ) {
    this.rows_.append(this.content_, this.head_);
    this.root.append(this.tools_, this.rows_);
    new TrackPointer(this, () => this.state()).listen(this.rows_);
    new TrackKeys(this, () => this.state()).listen(this.root);
    client_.on('takeTracks', (tracks) => this.came(tracks));
    client_.on('takeReady', ({ steps }) => this.readSoFar(steps));
    client_.on('notice', (notice) => this.refused(notice));
    if (typeof ResizeObserver !== 'undefined') new ResizeObserver(() => this.measure()).observe(this.rows_);
  }

  setOpen(open: boolean): void {
    if (open === this.open_) return;
    this.open_ = open;
    this.root.hidden = !open;
    this.client_.send({ type: 'WatchTracks', on: open });
    if (open) this.measure();
  }

  show(shown: TracksShown): void {
    const before = this.shown_;
    this.shown_ = shown;
    const { take } = shown;
    if (!take) return this.forget();
    if (before.take && before.take.name !== take.name && this.waits_ === undefined) this.anotherTake();
    if (!before.take || before.take.steps !== take.steps)
      this.window_ = before.take ? fitted(this.window_, before.take.steps, take.steps) : shownOf(take);
    if (before.take !== take || before.keys !== shown.keys || before.films !== shown.films) this.draw();
    else if (before.step !== shown.step) this.placeHead();
  }

  private anotherTake(): void {
    this.tracks_ = null;
    this.chosen_ = this.drag_ = null;
    this.held_ = null;
    this.words_ = kReading;
  }

  private forget(): void {
    this.anotherTake();
    this.waits_ = undefined;
    if (this.store_.state.tracks) this.store_.set({ tracks: false });
  }

  private came(tracks: TakeTracks): void {
    const meant = this.waits_;
    this.waits_ = undefined;
    this.tracks_ = tracks;
    this.words_ = '';
    this.drag_ = null;
    const found = meant ? foundAgain(tracks.blocks, meant) : null;
    if (meant !== undefined || this.chosen_ === null || 'block' in this.chosen_)
      this.chosen_ = found ? { block: found.id } : null;
    const focused = this.root.contains(document.activeElement);
    this.draw();
    if (found && focused) this.rows_.querySelector<HTMLElement>(`[data-block="${found.id}"]`)?.focus();
  }

  private readSoFar(steps: number): void {
    const { take } = this.shown_;
    if (!take || (this.waits_ === undefined && this.tracks_)) return;
    const share = Math.round((100 * steps) / Math.max(1, take.steps));
    const words = this.waits_ === undefined ? kReading : kAgain;
    this.words_ = share < 100 ? `${words} ${share} %` : words;
    this.draw();
  }

  private refused({ code }: Notice): void {
    if (code !== 'EditTrack' || this.waits_ === undefined) return;
    this.waits_ = undefined;
    this.drag_ = null;
    this.words_ = '';
    this.draw();
  }

  // Drawing.

  private state(): TracksState | null {
    const { take, step, keys, films } = this.shown_;
    if (!take || !this.open_) return null;
    return {
      take,
      step,
      keys,
      films,
      tracks: this.tracks_,
      colours: new Map(this.store_.state.groups.map(({ id, colour }) => [id, colour])),
      shown: this.window_,
      width: this.width_,
      chosen: this.chosen_,
      drag: this.drag_,
      waits: this.waits_ !== undefined,
      words: this.words_,
    };
  }

  private measure(): void {
    const lane = this.rows_.querySelector('.track-lane');
    this.width_ = lane?.clientWidth ?? 0;
    this.draw();
    // The first drawing made the rows.
    if (!lane) this.width_ = this.rows_.querySelector('.track-lane')?.clientWidth ?? 0;
    if (!lane) this.draw();
  }

  private draw(): void {
    const state = this.state();
    if (!state) return;
    render(<TrackTools state={state} actions={this} />, this.tools_);
    render(<TrackRows state={state} actions={this} />, this.content_);
    this.rows_.toggleAttribute('data-waits', state.waits);
    this.placeHead();
  }

  private placeHead(): void {
    const x = xOf(this.window_, this.width_, this.shown_.step);
    this.head_.hidden = x < 0 || x > this.width_;
    this.head_.style.transform = `translateX(${x}px)`;
  }

  // Actions.

  choose(chosen: Chosen): void {
    this.settle();
    this.chosen_ = chosen;
    this.draw();
  }

  preview(drag: TrackDrag | null): void {
    if (this.waits_ !== undefined) return;
    this.drag_ = drag;
    this.draw();
  }

  commit(drag: TrackDrag): void {
    window.clearTimeout(this.rest_);
    this.rest_ = 0;
    if (this.waits_ !== undefined) return;
    if (drag.edit === 'key') {
      this.drag_ = null;
      this.chosen_ = { key: drag.step };
      return this.host_.moveView(drag.id, drag.step);
    }
    const block = this.tracks_?.blocks.find(({ id }) => id === drag.id);
    const same = drag.step === (drag.edit === 'stretch' ? block?.end : block?.begin);
    if (!block || (same && drag.edit !== 'copy')) return this.preview(null);
    const begin = drag.edit === 'stretch' ? block.begin : drag.step;
    this.send(kEdits[drag.edit], block, drag.step, 0, { ...block, begin });
    this.drag_ = drag;
    this.draw();
  }

  private send(edit: TrackEdit, block: TakeBlock | null, step: number, group: number, meant: TakeBlock | null): void {
    if (this.waits_ !== undefined || !this.tracks_) return;
    this.waits_ = meant;
    this.words_ = kAgain;
    const { revision } = this.tracks_;
    this.client_.send({ type: 'EditTrack', revision, edit, block: block?.id ?? 0, step, group });
    this.draw();
  }

  nudge(by: number): void {
    const { chosen_: chosen, drag_: drag } = this;
    const { take } = this.shown_;
    if (!take || !chosen || this.waits_ !== undefined) return;
    const within = (step: number): number => Math.min(take.steps - 1, Math.max(0, Math.round(step)));
    if ('key' in chosen) {
      const from = drag?.edit === 'key' ? drag.step : chosen.key;
      this.preview({ edit: 'key', id: chosen.key, step: within(from + by) });
    } else {
      const block = this.tracks_?.blocks.find(({ id }) => id === chosen.block);
      if (!block?.moves) return;
      const from = drag?.edit === 'move' ? drag.step : block.begin;
      this.preview({ edit: 'move', id: block.id, step: within(from + by) });
    }
    window.clearTimeout(this.rest_);
    this.rest_ = window.setTimeout(() => this.settle(), kRests);
  }

  /** What keys have moved is made. */
  private settle(): void {
    if (this.rest_ !== 0 && this.drag_) this.commit(this.drag_);
  }

  copyTo(id: number, group: number): void {
    const block = this.tracks_?.blocks.find((one) => one.id === id);
    const { step, take } = this.shown_;
    if (!block || !take) return;
    const begin = Math.min(take.steps - 1, step);
    this.send(TrackEdit.Copy, block, begin, group, { ...block, begin, group: group || block.group });
  }

  copy(): void {
    const { chosen_: chosen } = this;
    if (chosen && 'block' in chosen) this.held_ = this.tracks_?.blocks.find(({ id }) => id === chosen.block) ?? null;
  }

  paste(): void {
    const held = this.held_ && foundAgain(this.tracks_?.blocks ?? [], this.held_);
    if (held) this.copyTo(held.id, 0);
  }

  remove(): void {
    const { chosen_: chosen } = this;
    if (!chosen) return;
    this.chosen_ = null;
    if ('key' in chosen) return this.host_.removeView(chosen.key);
    const block = this.tracks_?.blocks.find(({ id }) => id === chosen.block);
    if (block) this.send(TrackEdit.Remove, block, 0, 0, null);
  }

  undo(redo: boolean): void {
    if (redo ? this.tracks_?.redo : this.tracks_?.undo)
      this.send(redo ? TrackEdit.Redo : TrackEdit.Undo, null, 0, 0, null);
  }

  seek(step: number): void {
    this.host_.seek(step);
    this.shown_ = { ...this.shown_, step };
    this.placeHead();
  }

  scrub(down: boolean): void {
    if (down) this.host_.beginScrub();
    else this.host_.endScrub();
  }

  showTime(shown: TimeWindow): void {
    this.window_ = shown;
    this.draw();
  }

  zoom(factor: number, at = this.shown_.step): void {
    const { take } = this.shown_;
    if (take) this.showTime(zoomed(this.window_, take.steps, take.stepTime, factor, at));
  }

  keepView(): void {
    this.host_.keepView();
  }

  takeView(step: number): void {
    this.host_.takeView(step);
  }

  cut(step: number, cut: boolean): void {
    this.host_.cutView(step, cut);
  }
}
