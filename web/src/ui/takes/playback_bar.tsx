// Playback: restart, play or pause, single step, speed, demonstration, record and takes. A replay adds the button that
// leaves it.

import type { VNode } from 'preact';
import { formatClock, formatSpeed } from '../../model/formatters';
import type { StudioActions } from '../../model/studio_actions';
import type { StudioState } from '../../model/studio_state';
import type { StudioStore } from '../../model/studio_store';
import { toolButton } from '../widgets/buttons';
import { element } from '../widgets/dom';
import { drawPanel } from '../widgets/panel';
import { ToolbarFocus } from '../widgets/toolbar_focus';
import { TakeFiles, TakeMenu } from './take_menu';

interface Props {
  readonly state: StudioState;
  readonly actions: StudioActions;
}

function TimeButtons({ state, actions }: Props): VNode {
  const speed = formatSpeed(state.speed);
  return (
    <>
      {toolButton('restart', 'Restart', () => actions.restart(), {
        iconOnly: true,
        class: 'restart',
        tip: 'Back to the start',
      })}
      {toolButton(state.playing ? 'pause' : 'play', state.playing ? 'Pause' : 'Play', () => actions.togglePlay(), {
        iconSize: 24,
        iconOnly: true,
        class: 'play solid',
        shortcut: 'Space',
      })}
      {toolButton('step', 'Single step', () => actions.singleStep(), { iconOnly: true, class: 'step', shortcut: '.' })}
      <button
        type="button"
        class="speed"
        aria-label={`Speed ${speed}`}
        data-tip="Speed"
        data-key="> <"
        onClick={({ shiftKey }) => actions.nextSpeed(shiftKey)}
      >
        {speed}
      </button>
    </>
  );
}

function RecordButton({ state, actions }: Props): VNode {
  const recording = state.recorded >= 0;
  const clock = formatClock(state.recorded);
  const kept = state.link.phase === 'lost' ? `${clock} kept` : clock;
  return (
    <button
      type="button"
      class="record"
      aria-label={recording ? 'Stop recording' : 'Record'}
      aria-pressed={recording}
      disabled={state.replaying}
      data-tip="Record a take"
      data-key="R"
      onClick={() => actions.toggleRecord()}
    >
      <svg width="12" height="12" viewBox="0 0 12 12" aria-hidden="true" fill="currentColor">
        <circle cx="6" cy="6" r="6" />
      </svg>
      <span class="record-label">{recording ? kept : 'Record'}</span>
    </button>
  );
}

function Bar({ state, actions, files }: Props & { readonly files: TakeFiles }): VNode {
  return (
    <>
      <TimeButtons state={state} actions={actions} />
      <span class="divider" />
      {toolButton('watch', 'Watch', () => actions.toggleDemonstration(), {
        class: 'watch',
        shortcut: 'W',
        hidden: !state.demonstration,
        pressed: state.demonstrating,
        tip: state.demonstrating ? 'Stop: back to the start' : 'Watch the touches that belong to this scenario',
      })}
      <RecordButton state={state} actions={actions} />
      <TakeMenu actions={actions} files={files} ownCharacter={state.ownCharacter} />
      <span class="replay" hidden={!state.replaying}>
        <strong class="replay-label">Replay</strong>
        {toolButton('leave', 'Leave', () => actions.leaveReplay(), {
          class: 'leave soft',
          tip: 'Leave the replay: load the scenario',
        })}
      </span>
    </>
  );
}

export class PlaybackBar {
  private readonly files_: TakeFiles;
  readonly root = element('div', { class: 'playback panel', role: 'toolbar', 'aria-label': 'Time and takes' });
  /** Unseen. */
  readonly inputs: readonly HTMLInputElement[];

  constructor(store: StudioStore, actions: StudioActions) {
    this.files_ = new TakeFiles(actions);
    this.inputs = this.files_.inputs;
    drawPanel(
      this.root,
      store,
      ['playing', 'speed', 'recorded', 'replaying', 'demonstration', 'demonstrating', 'link', 'ownCharacter'],
      (state) => <Bar state={state} actions={actions} files={this.files_} />,
    );
    new ToolbarFocus(this.root, store);
  }

  /** Lets the visitor choose a take to open. */
  chooseFile(): void {
    this.files_.chooseTake();
  }

  /** Lets the visitor choose the files of a character. */
  chooseCharacter(): void {
    this.files_.chooseCharacter();
  }
}
