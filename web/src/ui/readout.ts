// The live figures: characters, step time, lag, swaps, and what the plan's objective comes to.

import { element, setAttribute, setText } from './dom';
import { formatCount, formatFigure, formatMs } from './formatters';
import { objectiveFigure, objectiveOf, objectivesFor, OBJECTIVES, objectiveText } from './objective';
import { Sparkline } from './sparkline';
import type { StudioActions } from './studio_actions';
import type { StudioState, StudioStore } from './studio_state';

interface Row {
  readonly root: HTMLElement;
  readonly value: HTMLElement;
  readonly spark: Sparkline | null;
}

/** Frames per point of a sparkline: it shows about ten seconds. */
const EVERY = 12;

export class Readout {
  readonly root = element('section', { class: 'readout panel', 'aria-label': 'Figures' });
  private readonly characters = this.row('characters', 'Characters', '', 'characters', null);
  private readonly step = this.row('ms', 'Step', '', 'ms', new Sparkline(16, 1), 'Time of a simulation step; the dashes stand at 16 ms');
  private readonly lag = this.row('lag', 'Lag p95', 'lag', 'm', new Sparkline(0, 1), 'Distance of characters to their places, p95');
  private readonly swaps = this.row('swaps', 'Swaps', '', '/s', new Sparkline(0, 0.2), 'Changes of place without a command, per character and second');

  private readonly objective = element('select', { class: 'objective', 'aria-label': 'What plans make least' });
  private readonly options = OBJECTIVES.map(({ label }, index) => element('option', { value: String(index) }, label));
  private readonly walks = element('strong', { class: 'value' });
  private readonly plan = element('div', { class: 'figure figure-objective' }, this.objective,
    element('span', { class: 'figure-value' }, this.walks));

  constructor(store: StudioStore, actions: StudioActions) {
    this.root.append(this.plan);
    this.objective.append(...this.options);
    this.objective.addEventListener('change', () => actions.setObjective(Number(this.objective.value)));
    store.watch(['parameters'], (state) => this.showObjective(state));
    store.watch(['frames'], (state) => this.show(state));
  }

  private row(name: string, label: string, before: string, unit: string, spark: Sparkline | null, tip?: string): Row {
    const value = element('strong', { class: 'value' });
    const row = element('div', { class: `figure figure-${name}`, 'data-tip': tip },
      element('span', { class: 'figure-label secondary' }, label));
    if (spark) row.append(spark.root);
    const short = element('span', { class: 'figure-before secondary' }, before);
    const unitText = element('span', { class: 'unit secondary' }, unit);
    row.append(element('span', { class: 'figure-value' }, short, value, unitText));
    this.root.append(row);
    return { root: row, value, spark };
  }

  private show(state: StudioState): void {
    setText(this.characters.value, formatCount(state.characters));
    if (state.frames % EVERY !== 1) return;
    setText(this.step.value, formatMs(state.stepMs));
    setText(this.lag.value, formatFigure(state.lag));
    setText(this.swaps.value, formatFigure(state.swaps));
    this.showWalks(state);
    this.step.spark?.push(state.stepMs);
    this.lag.spark?.push(state.lag);
    this.swaps.spark?.push(state.swaps);
  }

  /** What the chosen objective comes to; all of them in the tip. */
  private showWalks({ walks }: StudioState): void {
    const chosen = this.objective.selectedIndex;
    setText(this.walks, chosen < 0 ? '' : objectiveFigure(chosen, walks));
    setAttribute(this.plan, 'data-tip', `What plans make least. All walks: ${OBJECTIVES.map((_, index) => objectiveText(index, walks)).join(', ')}`);
  }

  private showObjective(state: StudioState): void {
    const { parameters } = state;
    const shown = objectivesFor(parameters);
    this.options.forEach((option, index) => {
      option.hidden = option.disabled = !shown.includes(index);
    });
    this.objective.selectedIndex = objectiveOf(parameters);
    this.plan.hidden = shown.length === 0;
    this.showWalks(state);
  }
}
