// The controls of a player: a button, a bar to scrub, the time, full screen.

import { clockText } from './play/playback';

export interface ControlActions {
  toggle(): void;
  /** [s] */
  seek(time: number): void;
  wholeScreen(): void;
}

const kIcons = {
  play: '<path d="M6 3.8v12.4L16.4 10Z" fill="currentColor"/>',
  pause: '<path d="M6.9 4.4v11.2 M13.1 4.4v11.2" stroke-width="3.2"/>',
  whole: '<path d="M3.4 7.4v-4h4 M12.6 3.4h4v4 M16.6 12.6v4h-4 M7.400 16.600h-4v-4"/>',
} as const;
/** Steps of the bar in a second. */
const kSteps = 50;

function made<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Readonly<Record<string, string>>,
): HTMLElementTagNameMap[K] {
  const one = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) one.setAttribute(name, value);
  return one;
}

function icon(name: keyof typeof kIcons): string {
  return `<svg viewBox="0 0 20 20" aria-hidden="true">${kIcons[name]}</svg>`;
}

export class ControlBar {
  readonly root = made('div', { class: 'bar', part: 'controls', role: 'group', 'aria-label': 'Controls' });
  /** The large button over a picture that has not played yet. */
  readonly start = made('button', { class: 'start', part: 'start-button', type: 'button', 'aria-label': 'Play' });
  private readonly toggle_ = made('button', { part: 'play-button', type: 'button' });
  private readonly scrub_ = made('input', { part: 'scrub', type: 'range', min: '0', value: '0', 'aria-label': 'Time' });
  private readonly time_ = made('span', { class: 'time', part: 'time' });
  private readonly whole_ = made('button', { part: 'full-screen-button', type: 'button' });
  private duration_ = 0;

  constructor(actions: ControlActions) {
    this.start.innerHTML = icon('play');
    this.whole_.innerHTML = icon('whole');
    this.toggle_.addEventListener('click', () => actions.toggle());
    this.start.addEventListener('click', () => {
      actions.toggle();
      // The button goes away; keys go on to those that stay.
      this.toggle_.focus({ preventScroll: true });
    });
    this.whole_.addEventListener('click', () => actions.wholeScreen());
    this.scrub_.addEventListener('input', () => actions.seek(Number(this.scrub_.value) / kSteps));
    this.root.append(this.toggle_, this.scrub_, this.time_, this.whole_);
    this.setPaused(true);
    this.setWhole(false);
    this.whole_.hidden = !document.fullscreenEnabled;
  }

  setDuration(seconds: number): void {
    this.duration_ = seconds;
    this.scrub_.max = String(Math.max(1, Math.round(seconds * kSteps)));
    this.setTime(0);
  }

  setTime(seconds: number): void {
    const step = String(Math.round(seconds * kSteps));
    if (this.scrub_.value !== step) this.scrub_.value = step;
    const share = this.duration_ > 0 ? seconds / this.duration_ : 0;
    this.scrub_.style.setProperty('--share', `${(100 * Math.min(1, share)).toFixed(2)}%`);
    const text = `${clockText(seconds)} / ${clockText(this.duration_)}`;
    if (this.time_.textContent !== text) this.time_.textContent = text;
    this.scrub_.setAttribute('aria-valuetext', `${clockText(seconds)} of ${clockText(this.duration_)}`);
  }

  setPaused(paused: boolean): void {
    this.toggle_.innerHTML = icon(paused ? 'play' : 'pause');
    this.toggle_.setAttribute('aria-label', paused ? 'Play' : 'Pause');
  }

  setWhole(whole: boolean): void {
    this.whole_.setAttribute('aria-label', whole ? 'Leave full screen' : 'Full screen');
  }
}
