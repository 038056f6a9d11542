// The live figures: characters, step time, lag and swaps.

import { element, setText } from './dom';
import { formatCount, formatFigure, formatMs } from './formatters';
import { Sparkline } from './sparkline';
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

  constructor(store: StudioStore) {
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
    this.step.spark?.push(state.stepMs);
    this.lag.spark?.push(state.lag);
    this.swaps.spark?.push(state.swaps);
  }
}
