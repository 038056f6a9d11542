// The time line of the open take: where it stands, which part of it plays, and what can be done with it.

import { render, type VNode } from 'preact';
import type { StudioStore } from '../../model/studio_store';
import type { TakeActions } from '../../model/take_actions';
import { clockAt, type OpenTake } from '../../model/take_facts';
import type { CameraKey } from '../../scene/camera/film_camera';
import { ToolButton } from '../widgets/buttons';
import { element } from '../widgets/dom';
import { Held } from '../widgets/held';
import { FilmCameraMenu, type FilmCameraActions } from './film_camera_menu';
import { SpeedMenu } from './speed_menu';
import { TimeTrack } from './time_track';

const kStored = 'Recorded by another version of Muster: it plays from its stored frames and cannot be changed.';

function clockOf(take: OpenTake, step: number): string {
  return `${clockAt(take, step)} of ${clockAt(take, take.to)}`;
}

export class TimeLine {
  readonly track: TimeTrack;
  /** Below the track, where the tracks unfold. */
  readonly tracks = element('div', { class: 'tracks-holder' });
  readonly root = element('section', { class: 'time-line panel', 'aria-label': 'Time line', hidden: true });
  private take_: OpenTake | null = null;
  private title_ = '';
  private keys_: readonly CameraKey[] = [];
  private films_ = false;

  /** `store` tells whether paths are being changed. */
  constructor(
    private readonly actions_: TakeActions,
    private readonly film_: FilmCameraActions | null = null,
    private readonly store_: StudioStore | null = null,
  ) {
    this.track = new TimeTrack(actions_);
    this.draw();
    store_?.watch(['paths', 'tracks'], () => this.draw());
  }

  /** Null: no take is open. */
  setTake(take: OpenTake | null, title: string): void {
    this.take_ = take;
    this.root.hidden = take === null;
    if (!take) return;
    this.title_ = title;
    this.root.toggleAttribute('data-stored', take.stored);
    this.track.setTake(take);
    this.draw();
  }

  setStep(step: number): void {
    this.track.setStep(step);
    if (this.take_) this.draw();
  }

  /** The key frames of the film camera, and whether it leads. */
  setFilm(keys: readonly CameraKey[], on: boolean): void {
    [this.keys_, this.films_] = [keys, on];
    this.draw();
  }

  private draw(): void {
    const { take_: take } = this;
    render(
      <>
        <div class="time-head">
          <div class="time-words">
            <strong class="time-title">{this.title_}</strong>
            <span class="time-clock">{take && clockOf(take, this.track.step)}</span>
          </div>
          {this.tools()}
          <ToolButton
            icon="close"
            label="Leave the take"
            iconOnly
            class="time-close"
            act={() => this.actions_.leaveTake()}
          />
        </div>
        <div class="time-track-holder">
          <Held make={() => this.track.root} />
        </div>
        <Held make={() => this.tracks} />
        <p class="time-stored" role="note" hidden={!take?.stored}>
          {kStored}
        </p>
      </>,
      this.root,
    );
  }

  private tools(): VNode {
    const { actions_: actions, take_: take } = this;
    return (
      <div class="time-tools">
        <ToolButton
          icon="steer"
          label="Retake"
          class="time-again"
          tip="Direct from this moment on: a new take with this beginning"
          act={() => actions.takeAgain(false)}
        />
        <ToolButton
          icon="layers"
          label="Add to it"
          class="time-layer"
          tip="Direct on top of what was recorded, from this moment on"
          act={() => actions.takeAgain(true)}
        />
        {this.store_ && this.paths(this.store_)}
        {this.store_ && this.unfolds(this.store_)}
        <ToolButton
          icon="patrol"
          label="Loop"
          class="time-loop"
          pressed={take?.loop ?? false}
          tip="Play the part over and over"
          act={() => actions.setLoop(!take?.loop)}
        />
        {take && <SpeedMenu take={take} step={this.track.step} setSpeeds={(speeds) => actions.setSpeeds(speeds)} />}
        {this.film_ && take && <FilmCameraMenu keys={this.keys_} on={this.films_} take={take} actions={this.film_} />}
        <ToolButton
          icon="download"
          label="Export"
          class="time-export"
          tip="Files for other programs, pictures and films"
          act={() => actions.exportTake()}
        />
      </div>
    );
  }

  private unfolds(store: StudioStore): VNode {
    const { tracks } = store.state;
    return (
      <ToolButton
        icon="tracks"
        label="Tracks"
        class="time-tracks"
        pressed={tracks}
        tip="What each group is told, as blocks to move, copy and retime; views and cuts of the camera"
        act={() => store.set({ tracks: !tracks })}
      />
    );
  }

  private paths(store: StudioStore): VNode {
    const { paths } = store.state;
    return (
      <ToolButton
        icon="arrow"
        label="Edit paths"
        class="time-path"
        shortcut="Shift+P"
        pressed={paths}
        tip="Moves the path of a group or a person in this take, which is computed anew"
        act={() => store.set({ paths: !paths })}
      />
    );
  }
}
