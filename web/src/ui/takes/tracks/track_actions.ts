// What the rows of the time line can ask for.

import type { BlockEdit, TimeWindow } from '../../../model/take_tracks';
import type { TakeTracks } from '../../../protocol/messages';
import type { CameraKey } from '../../../scene/camera/film_camera';
import type { OpenTake } from '../../../model/take_facts';

/** A block, or a key of the camera by its moment. */
export type Chosen = { readonly block: number } | { readonly key: number } | null;

/** What is being dragged, or waits for the next key press. */
export type TrackDrag = BlockEdit | { readonly edit: 'key'; readonly id: number; readonly step: number };

export interface TracksState {
  readonly take: OpenTake;
  /** Null until the take has been read. */
  readonly tracks: TakeTracks | null;
  /** Colours of groups, by id. */
  readonly colours: ReadonlyMap<number, number>;
  readonly keys: readonly CameraKey[];
  readonly films: boolean;
  readonly shown: TimeWindow;
  /** Of the part to the right of the names [CSS px]. */
  readonly width: number;
  readonly step: number;
  readonly chosen: Chosen;
  readonly drag: TrackDrag | null;
  /** It is simulated again. */
  readonly waits: boolean;
  readonly words: string;
}

export interface TrackActions {
  choose(chosen: Chosen): void;
  /** Shows a change that is not made yet; null for none. */
  preview(drag: TrackDrag | null): void;
  /** Makes it. */
  commit(drag: TrackDrag): void;
  /** Moves what is chosen by keys; made once no further key comes. */
  nudge(by: number): void;
  copyTo(block: number, group: number): void;
  remove(): void;
  undo(redo: boolean): void;
  /** Holds or takes the chosen block for a copy. */
  copy(): void;
  paste(): void;
  seek(step: number): void;
  scrub(down: boolean): void;
  showTime(shown: TimeWindow): void;
  zoom(factor: number, at?: number): void;
  keepView(): void;
  /** The view becomes that of the chosen key. */
  takeView(step: number): void;
  cut(step: number, cut: boolean): void;
}
