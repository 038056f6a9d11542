// Times of a step: a line with the whole, which opens a table of the step's stages.

import type { StageTimes } from '../../protocol/messages';
import { element, setText } from '../widgets/dom';

interface Row {
  readonly time: HTMLElement;
  readonly bar: HTMLElement;
}

function inMs(milliseconds: number, digits: number): string {
  return `${milliseconds.toFixed(digits)} ms`;
}

export class StageTable {
  private readonly summary_ = element('summary', {}, 'Times of a step');
  private readonly rows_ = element('tbody');
  private readonly total_ = element('td');
  private readonly shown_: Row[] = [];
  /** The names of the stages that have rows. */
  private names_ = '';
  readonly root = element('details', { class: 'stage-times', hidden: true }, this.summary_, this.table());

  /** The times of the newest steps. */
  show({ total, stages }: StageTimes): void {
    const names = stages.map(({ name }) => name).join('\n');
    if (names !== this.names_) this.list(stages);
    this.names_ = names;
    this.root.hidden = false;
    setText(this.summary_, `Times of a step: ${inMs(total, 2)}`);
    setText(this.total_, inMs(total, 3));
    const largest = Math.max(...stages.map(({ milliseconds }) => milliseconds));
    stages.forEach(({ milliseconds }, i) => {
      const { time, bar } = this.shown_[i]!;
      setText(time, inMs(milliseconds, 3));
      bar.style.setProperty('--share', largest > 0 ? (milliseconds / largest).toFixed(3) : '0');
    });
  }

  private table(): HTMLElement {
    const head = element(
      'tr',
      {},
      element('th', { scope: 'col' }, 'Stage'),
      element('th', { scope: 'col' }, 'Mean of 60 steps'),
    );
    const whole = element('tr', {}, element('th', { scope: 'row' }, 'Whole step'), this.total_);
    const table = element(
      'table',
      { 'aria-label': 'Times of the stages of a step' },
      element('thead', {}, head),
      this.rows_,
      element('tfoot', {}, whole),
    );
    // Keys scroll what has the focus.
    return element('div', { class: 'stage-scroll', role: 'group', 'aria-label': 'Stages', tabindex: 0 }, table);
  }

  /** Makes a row for each stage, in the order of the step. */
  private list(stages: StageTimes['stages']): void {
    this.shown_.length = 0;
    this.rows_.replaceChildren(
      ...stages.map(({ name, about }) => {
        const time = element('td');
        const bar = element('tr', { title: about }, element('th', { scope: 'row' }, name), time);
        this.shown_.push({ time, bar });
        return bar;
      }),
    );
  }
}
