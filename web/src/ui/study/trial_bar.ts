// The bar above a trial: what it is, the clock, the items, and the way out.

import type { StudyState } from '../../protocol/messages';
import { formatClock } from '../../model/formatters';
import { element, setText } from '../widgets/dom';

/** A button that ends something asks once more; it forgets that after this time [ms]. */
const kSure = 4000;

/** The clock and the items of a trial, side by side. */
export function trialFigures(clock: HTMLElement, items: HTMLElement): HTMLElement {
  const dot = element('span', { class: 'study-item-dot', 'aria-hidden': 'true' });
  return element('div', { class: 'study-figures' }, clock, dot, items);
}

export class TrialBar {
  private readonly title_ = element('strong');
  private readonly about_ = element('span', { class: 'secondary' });
  private readonly clock_ = element('strong', { class: 'study-clock', role: 'timer', 'aria-label': 'Time' });
  private readonly items_ = element('strong', { class: 'study-items' });
  private readonly end_ = element('button', { type: 'button', class: 'soft study-end' }, 'Give up');
  private readonly stop_ = element('button', { type: 'button', class: 'study-stop' }, 'Stop taking part');
  readonly root = element(
    'header',
    { class: 'study-bar panel' },
    element('div', { class: 'study-bar-words' }, this.title_, this.about_),
    trialFigures(this.clock_, this.items_),
    element('div', { class: 'study-ends' }, this.end_, this.stop_),
  );
  private sure_ = false;
  private timer_ = 0;
  private state_: StudyState | null = null;

  /** `stop`: the person wants to stop for good. */
  constructor(
    private readonly give_: () => void,
    stop: () => void,
  ) {
    this.stop_.addEventListener('click', stop);
    this.end_.addEventListener('click', () => this.pressed());
  }

  show(state: StudyState): void {
    this.state_ = state;
    setText(this.title_, state.practice ? 'Practice' : state.environment);
    setText(
      this.about_,
      state.practice ? 'Collect the golden hexagons' : `${state.schemeTitle} · ${state.trial} of ${state.trials}`,
    );
    this.calm();
    this.update(0, 0);
  }

  /** With every frame. */
  update(seconds: number, collected: number): void {
    if (!this.state_) return;
    setText(this.clock_, formatClock(seconds));
    setText(this.items_, `${collected} / ${this.state_.items}`);
    this.end_.disabled = seconds < this.state_.least;
  }

  private pressed(): void {
    // A practice may end without further questions.
    if (this.state_?.practice || this.sure_) {
      this.calm();
      return this.give_();
    }
    this.sure_ = true;
    setText(this.end_, 'Really give up?');
    this.timer_ = window.setTimeout(() => this.calm(), kSure);
  }

  private calm(): void {
    window.clearTimeout(this.timer_);
    this.sure_ = false;
    setText(this.end_, this.state_?.practice ? 'End practice' : 'Give up');
  }
}
