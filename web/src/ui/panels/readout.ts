// How the crowd does, in plain words; on request the figures: characters, step time, lag, swaps, and what the plan's
// objective comes to.

import { element, setAttribute, setText } from '../widgets/dom';
import { formatCount, formatFigure, formatMs } from '../../model/formatters';
import { objectiveFigure, objectiveOf, objectivesFor, kObjectives, objectiveText } from '../../model/objective';
import { plainWords } from '../../model/plain_words';
import { icon } from '../widgets/icons';
import { Sparkline } from '../widgets/sparkline';
import type { StudioActions } from '../../model/studio_actions';
import type { StudioState } from '../../model/studio_state';
import type { StudioStore } from '../../model/studio_store';

interface Row {
  readonly root: HTMLElement;
  readonly value: HTMLElement;
  readonly spark: Sparkline | null;
}

/** Frames per point of a sparkline: it shows about ten seconds. */
const kEvery = 12;

export class Readout {
  private readonly rows_ = element('div', { class: 'figures' });
  readonly root = element('section', { class: 'readout panel', 'aria-label': 'How the crowd does' }, this.rows_);
  private readonly characters_ = this.row('characters', 'Characters', '', 'characters', null);
  private readonly step_ = this.row(
    'ms',
    'Step',
    '',
    'ms',
    new Sparkline(16, 1),
    'Time of a simulation step; the dashes stand at 16 ms',
  );
  private readonly lag_ = this.row(
    'lag',
    'Lag p95',
    'lag',
    'm',
    new Sparkline(0, 1),
    'Distance of characters to their places, p95',
  );
  private readonly swaps_ = this.row(
    'swaps',
    'Swaps',
    '',
    '/s',
    new Sparkline(0, 0.2),
    'Changes of place without a command, per character and second',
  );

  private readonly people_ = element('strong', { class: 'plain-people' });
  private readonly does_ = element('span', { class: 'plain-does' });
  private readonly items_ = element('span', { class: 'plain-items' });
  private readonly slow_ = element('span', { class: 'plain-slow' });
  private readonly plain_ = element(
    'button',
    { type: 'button', class: 'plain', 'aria-expanded': 'false', 'data-tip': 'Figures' },
    element('span', { class: 'plain-words' }, this.people_, this.does_, this.items_, this.slow_),
    icon('chevron'),
  );
  private readonly objective_ = element('select', { class: 'objective', 'aria-label': 'What plans make least' });
  private readonly options_ = kObjectives.map(({ label }, index) => element('option', { value: String(index) }, label));
  private readonly walks_ = element('strong', { class: 'value' });
  private readonly plan_ = element(
    'div',
    { class: 'figure figure-objective' },
    this.objective_,
    element('span', { class: 'figure-value' }, this.walks_),
  );

  constructor(store: StudioStore, actions: StudioActions) {
    this.root.prepend(this.plain_);
    this.rows_.append(this.plan_);
    this.objective_.append(...this.options_);
    this.objective_.addEventListener('change', () => actions.setObjective(Number(this.objective_.value)));
    store.watch(['parameters'], (state) => this.showObjective(state));
    store.watch(['frames'], (state) => this.show(state));
    this.plain_.addEventListener('click', () => actions.toggleFigures());
    store.watch(['figures'], ({ figures }) => {
      this.rows_.hidden = !figures;
      this.root.classList.toggle('open', figures);
      setAttribute(this.plain_, 'aria-expanded', String(figures));
    });
  }

  private row(name: string, label: string, before: string, unit: string, spark: Sparkline | null, tip?: string): Row {
    const value = element('strong', { class: 'value' });
    const row = element(
      'div',
      { class: `figure figure-${name}`, 'data-tip': tip },
      element('span', { class: 'figure-label secondary' }, label),
    );
    if (spark) row.append(spark.root);
    const short = element('span', { class: 'figure-before secondary' }, before);
    const unitText = element('span', { class: 'unit secondary' }, unit);
    row.append(element('span', { class: 'figure-value' }, short, value, unitText));
    this.rows_.append(row);
    return { root: row, value, spark };
  }

  private show(state: StudioState): void {
    const words = plainWords(state);
    setText(this.people_, words.people);
    setText(this.does_, words.does);
    setText(this.items_, words.items);
    setText(this.slow_, words.slow);
    setText(this.characters_.value, formatCount(state.characters));
    if (state.frames % kEvery !== 1) return;
    setText(this.step_.value, formatMs(state.stepMs));
    setText(this.lag_.value, formatFigure(state.lag));
    setText(this.swaps_.value, formatFigure(state.swaps));
    this.showWalks(state);
    this.step_.spark?.push(state.stepMs);
    this.lag_.spark?.push(state.lag);
    this.swaps_.spark?.push(state.swaps);
  }

  /** What the chosen objective comes to; all of them in the tip. */
  private showWalks({ walks }: StudioState): void {
    const chosen = this.objective_.selectedIndex;
    setText(this.walks_, chosen < 0 ? '' : objectiveFigure(chosen, walks));
    setAttribute(
      this.plan_,
      'data-tip',
      `What plans make least. All walks: ${kObjectives.map((_, index) => objectiveText(index, walks)).join(', ')}`,
    );
  }

  private showObjective(state: StudioState): void {
    const { parameters } = state;
    const shown = objectivesFor(parameters);
    this.options_.forEach((option, index) => {
      option.hidden = option.disabled = !shown.includes(index);
    });
    this.objective_.selectedIndex = objectiveOf(parameters);
    this.plan_.hidden = shown.length === 0;
    this.showWalks(state);
  }
}
