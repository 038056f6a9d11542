// Time: restart, play or pause, single step, speed, what there is to watch, record and takes; during a replay the way
// out of it.

import { element, setAttribute, setPressed, setText } from './dom';
import { formatClock, formatSpeed } from './formatters';
import { icon, recordDot, type IconName } from './icons';
import { kCharacterFiles } from './own_people';
import { Popup } from './popup';
import type { StudioActions } from './studio_actions';
import type { StudioState, StudioStore } from './studio_state';
import { toolButton } from './tool_button';
import { ToolbarFocus } from './toolbar_focus';

export class TransportBar {
  private readonly play: HTMLButtonElement;
  private readonly speed: HTMLButtonElement;
  private readonly recordLabel = element('span', { class: 'record-label' });
  private readonly record: HTMLButtonElement;
  private readonly restart: HTMLButtonElement;
  private readonly step: HTMLButtonElement;
  private readonly watch: HTMLButtonElement;
  private readonly takes: HTMLButtonElement;
  private readonly replay = element('span', { class: 'replay' });
  private readonly takeList = element('div', { class: 'take-list panel', role: 'group', 'aria-label': 'Takes' });
  private readonly characters = element('input', { type: 'file', accept: kCharacterFiles, multiple: true, hidden: true, 'aria-label': 'Open a character', tabindex: -1 });
  private readonly file = element('input', { type: 'file', accept: '.take', hidden: true, 'aria-label': 'Open a take', tabindex: -1 });
  readonly root = element('div', { class: 'transport panel', role: 'toolbar', 'aria-label': 'Time and takes' });

  constructor(store: StudioStore, private readonly actions: StudioActions) {
    this.restart = toolButton({ icon: 'restart', label: 'Restart', iconOnly: true, className: 'restart', tip: 'Back to the start', act: () => actions.restart() });
    this.play = toolButton({ icon: 'play', label: 'Play', iconOnly: true, key: 'Space', className: 'play solid', act: () => actions.togglePlay() });
    this.step = toolButton({ icon: 'step', label: 'Single step', iconOnly: true, key: '.', className: 'step', act: () => actions.singleStep() });
    this.speed = element('button', { type: 'button', class: 'speed', 'data-tip': 'Speed', 'data-key': '> <' });
    this.speed.addEventListener('click', (event) => actions.nextSpeed(event.shiftKey));
    this.watch = toolButton({ icon: 'watch', label: 'Watch', key: 'W', className: 'watch', pressed: false, act: () => actions.toggleDemonstration() });
    this.record = element('button', { type: 'button', class: 'record', 'aria-pressed': 'false', 'data-tip': 'Record a take', 'data-key': 'R' }, recordDot(), this.recordLabel);
    this.record.addEventListener('click', () => actions.toggleRecord());
    this.takes = toolButton({ icon: 'takes', label: 'Takes', iconOnly: true, className: 'takes', tip: 'Takes, and whom the crowd looks like' });
    this.fillTakes(store);
    const leave = toolButton({ icon: 'leave', label: 'Leave', className: 'leave soft', tip: 'Leave the replay: load the scenario', act: () => actions.leaveReplay() });
    this.replay.append(element('strong', { class: 'replay-label' }, 'Replay'), leave);
    const divider = element('span', { class: 'divider' });
    const takes = element('span', { class: 'takes-holder' }, this.takes, this.takeList);
    this.root.append(this.restart, this.play, this.step, this.speed, divider, this.watch, this.record, takes, this.replay, this.file, this.characters);
    store.watch(['playing', 'speed', 'recorded', 'replaying', 'demonstration', 'demonstrating', 'link'], (state) => this.show(state));
    new ToolbarFocus(this.root, store);
  }

  private fillTakes(store: StudioStore): void {
    const popup = new Popup(this.takes, this.takeList);
    const item = (name: IconName, label: string, act: () => void): HTMLButtonElement => {
      const button = element('button', { type: 'button', class: 'menu-item' }, icon(name), label);
      button.addEventListener('click', () => {
        popup.close(true);
        act();
      });
      return button;
    };
    const ours = item('places', 'Our people', () => this.actions.ourPeople());
    this.takeList.append(
      item('download', 'Download take', () => this.actions.downloadTake()),
      item('open', 'Open take…', () => this.chooseFile()),
      item('character', 'Own character…', () => this.chooseCharacter()),
      ours,
    );
    store.watch(['ownCharacter'], ({ ownCharacter }) => (ours.hidden = ownCharacter === ''));
    this.file.addEventListener('change', () => {
      const chosen = this.file.files?.[0];
      if (chosen) this.actions.openTake(chosen);
      this.file.value = '';
    });
    this.characters.addEventListener('change', () => {
      this.actions.openCharacter([...(this.characters.files ?? [])]);
      this.characters.value = '';
    });
  }

  /** Lets the visitor choose a take to open. */
  chooseFile(): void {
    this.file.click();
  }

  /** Lets the visitor choose the files of a character. */
  chooseCharacter(): void {
    this.characters.click();
  }

  private show(state: StudioState): void {
    const label = state.playing ? 'Pause' : 'Play';
    if (this.play.getAttribute('data-shown') !== label) {
      this.play.replaceChild(icon(state.playing ? 'pause' : 'play', 24), this.play.firstElementChild!);
      for (const name of ['data-shown', 'aria-label', 'data-tip']) this.play.setAttribute(name, label);
    }
    setText(this.speed, formatSpeed(state.speed));
    setAttribute(this.speed, 'aria-label', `Speed ${formatSpeed(state.speed)}`);
    const recording = state.recorded >= 0;
    const lost = state.link.phase === 'lost';
    setPressed(this.record, recording);
    const clock = formatClock(state.recorded);
    setText(this.recordLabel, recording ? (lost ? `${clock} kept` : clock) : 'Record');
    setAttribute(this.record, 'aria-label', recording ? 'Stop recording' : 'Record');
    this.record.disabled = state.replaying;
    this.replay.hidden = !state.replaying;
    this.watch.hidden = !state.demonstration;
    setPressed(this.watch, state.demonstrating);
    setAttribute(this.watch, 'data-tip', state.demonstrating ? 'Stop: back to the start' : 'Watch the touches that belong to this scenario');
  }
}
