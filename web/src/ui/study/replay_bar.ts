// The bar above a replayed trial: what it is, clock and items, play and pause, speed.

import { PlaybackAction, type StudyState } from '../../protocol/messages';
import type { MessageSender } from '../../link/studio_client';
import { formatClock } from '../../model/formatters';
import { element, setAttribute, setPressed, setText } from '../widgets/dom';
import { icon } from '../widgets/icons';
import { endText } from './stage_pages';
import { trialFigures } from './trial_bar';

const kSpeeds = [1, 2, 4, 8] as const;

export class ReplayBar {
  private readonly title_ = element('strong');
  private readonly about_ = element('span', { class: 'secondary' });
  private readonly clock_ = element('strong', { class: 'study-clock', role: 'timer', 'aria-label': 'Time' });
  private readonly items_ = element('strong', { class: 'study-items' });
  private readonly play_ = element('button', { type: 'button', class: 'solid', 'aria-label': 'Pause' }, icon('pause'));
  private readonly speeds_ = kSpeeds.map((speed) => {
    const button = element('button', { type: 'button', 'aria-pressed': 'false' }, `${speed}×`);
    button.addEventListener('click', () => this.client_.send({ type: 'SetSpeed', factor: speed }));
    return button;
  });
  readonly root: HTMLElement;
  private playing_ = true;
  private state_: StudyState | null = null;

  constructor(private readonly client_: MessageSender) {
    const again = element('button', { type: 'button', 'aria-label': 'From the start' }, icon('restart'));
    again.addEventListener('click', () => client_.send({ type: 'Playback', action: PlaybackAction.Restart }));
    this.play_.addEventListener('click', () =>
      client_.send({ type: 'Playback', action: this.playing_ ? PlaybackAction.Pause : PlaybackAction.Play }),
    );
    this.root = element(
      'header',
      { class: 'study-bar panel' },
      element('div', { class: 'study-bar-words' }, this.title_, this.about_),
      trialFigures(this.clock_, this.items_),
      element(
        'div',
        { class: 'study-transport' },
        again,
        this.play_,
        element('div', { class: 'segments', role: 'group', 'aria-label': 'Speed' }, ...this.speeds_),
      ),
    );
  }

  show(state: StudyState): void {
    this.state_ = state;
    setText(this.title_, `${state.environment} · ${state.schemeTitle}`);
    const kind = state.test ? ' · test' : state.practice ? ' · practice' : '';
    setText(this.about_, `Trial ${state.trial} of run ${state.run}${kind}. ${endText(state)}`);
  }

  /** With every frame. */
  update(frame: { time: number; playing: boolean; speed: number }, collected: number): void {
    setText(this.clock_, formatClock(frame.time));
    setText(this.items_, `${collected} / ${this.state_?.items ?? 0}`);
    this.speeds_.forEach((button, i) => setPressed(button, kSpeeds[i] === frame.speed));
    if (frame.playing === this.playing_) return;
    this.playing_ = frame.playing;
    this.play_.replaceChildren(icon(frame.playing ? 'pause' : 'play'));
    setAttribute(this.play_, 'aria-label', frame.playing ? 'Pause' : 'Play');
  }
}
