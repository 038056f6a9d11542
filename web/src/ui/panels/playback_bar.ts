// Playback: restart, play or pause, single step, speed, demonstration, record and takes. A replay adds the button that
// leaves it.

import { element, setAttribute, setPressed, setText } from '../widgets/dom';
import { formatClock, formatSpeed } from '../../model/formatters';
import { icon, recordDot } from '../widgets/icons';
import type { StudioActions } from '../../model/studio_actions';
import type { StudioState } from '../../model/studio_state';
import { TakeMenu } from './take_menu';
import { toolButton } from '../widgets/tool_button';
import { ToolbarFocus } from '../widgets/toolbar_focus';
import type { StudioStore } from '../../model/studio_store';

export class PlaybackBar {
  private readonly play_: HTMLButtonElement;
  private readonly speed_: HTMLButtonElement;
  private readonly recordLabel_ = element('span', { class: 'record-label' });
  private readonly record_: HTMLButtonElement;
  private readonly restart_: HTMLButtonElement;
  private readonly step_: HTMLButtonElement;
  private readonly watch_: HTMLButtonElement;
  private readonly takes_: TakeMenu;
  private readonly replay_ = element('span', { class: 'replay' });
  readonly root = element('div', { class: 'playback panel', role: 'toolbar', 'aria-label': 'Time and takes' });

  constructor(store: StudioStore, actions: StudioActions) {
    this.restart_ = toolButton({
      icon: 'restart',
      label: 'Restart',
      iconOnly: true,
      className: 'restart',
      tip: 'Back to the start',
      act: () => actions.restart(),
    });
    this.play_ = toolButton({
      icon: 'play',
      label: 'Play',
      iconOnly: true,
      key: 'Space',
      className: 'play solid',
      act: () => actions.togglePlay(),
    });
    this.step_ = toolButton({
      icon: 'step',
      label: 'Single step',
      iconOnly: true,
      key: '.',
      className: 'step',
      act: () => actions.singleStep(),
    });
    this.speed_ = element('button', { type: 'button', class: 'speed', 'data-tip': 'Speed', 'data-key': '> <' });
    this.speed_.addEventListener('click', (event) => actions.nextSpeed(event.shiftKey));
    this.watch_ = toolButton({
      icon: 'watch',
      label: 'Watch',
      key: 'W',
      className: 'watch',
      pressed: false,
      act: () => actions.toggleDemonstration(),
    });
    this.record_ = this.recordButton(actions);
    this.takes_ = new TakeMenu(store, actions);
    this.fillReplay(actions);
    this.root.append(
      this.restart_,
      this.play_,
      this.step_,
      this.speed_,
      element('span', { class: 'divider' }),
      this.watch_,
      this.record_,
      this.takes_.root,
      this.replay_,
      ...this.takes_.inputs,
    );
    store.watch(['playing', 'speed', 'recorded', 'replaying', 'demonstration', 'demonstrating', 'link'], (state) =>
      this.show(state),
    );
    new ToolbarFocus(this.root, store);
  }

  private recordButton(actions: StudioActions): HTMLButtonElement {
    const button = element(
      'button',
      { type: 'button', class: 'record', 'aria-pressed': 'false', 'data-tip': 'Record a take', 'data-key': 'R' },
      recordDot(),
      this.recordLabel_,
    );
    button.addEventListener('click', () => actions.toggleRecord());
    return button;
  }

  /** What stands there during a replay. */
  private fillReplay(actions: StudioActions): void {
    const leave = toolButton({
      icon: 'leave',
      label: 'Leave',
      className: 'leave soft',
      tip: 'Leave the replay: load the scenario',
      act: () => actions.leaveReplay(),
    });
    this.replay_.append(element('strong', { class: 'replay-label' }, 'Replay'), leave);
  }

  /** Lets the visitor choose a take to open. */
  chooseFile(): void {
    this.takes_.chooseFile();
  }

  /** Lets the visitor choose the files of a character. */
  chooseCharacter(): void {
    this.takes_.chooseCharacter();
  }

  private show(state: StudioState): void {
    const label = state.playing ? 'Pause' : 'Play';
    if (this.play_.getAttribute('data-shown') !== label) {
      this.play_.replaceChild(icon(state.playing ? 'pause' : 'play', 24), this.play_.firstElementChild!);
      for (const name of ['data-shown', 'aria-label', 'data-tip']) this.play_.setAttribute(name, label);
    }
    setText(this.speed_, formatSpeed(state.speed));
    setAttribute(this.speed_, 'aria-label', `Speed ${formatSpeed(state.speed)}`);
    const recording = state.recorded >= 0;
    const lost = state.link.phase === 'lost';
    setPressed(this.record_, recording);
    const clock = formatClock(state.recorded);
    setText(this.recordLabel_, recording ? (lost ? `${clock} kept` : clock) : 'Record');
    setAttribute(this.record_, 'aria-label', recording ? 'Stop recording' : 'Record');
    this.record_.disabled = state.replaying;
    this.replay_.hidden = !state.replaying;
    this.watch_.hidden = !state.demonstration;
    setPressed(this.watch_, state.demonstrating);
    setAttribute(
      this.watch_,
      'data-tip',
      state.demonstrating ? 'Stop: back to the start' : 'Watch the touches that belong to this scenario',
    );
  }
}
