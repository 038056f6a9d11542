// With `?stats` in the page's address: what the last second's pictures cost, and the steps of the world.

import type { StudioClient } from '../../link/studio_client';
import type { ViewStats } from '../../scene/picture_stats';
import { element, setText } from '../widgets/dom';
import { StageTable } from './stage_table';

/** Pictures that the figures are of. */
const kWindow = 60;

/** The value below which so large a share of a list lies. */
export function percentile(values: readonly number[], share: number): number {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.max(0, Math.ceil(share * sorted.length) - 1))] ?? 0;
}

export class StatsReadout {
  readonly stages = new StageTable();
  private readonly pictureLine_ = element('output', { 'aria-label': 'What a picture costs' });
  readonly root = element('div', { class: 'stats-readout' }, this.pictureLine_, this.stages.root);
  private readonly times_: number[] = [];
  private pictures_ = -1;

  /** Asks every server that greets us for the times of stages. */
  follow(client: Pick<StudioClient, 'on' | 'send'>): void {
    client.on('welcome', () => client.send({ type: 'WatchStages', on: true }));
    client.on('stageTimes', (times) => this.stages.show(times));
  }

  /** Call with every refresh of the display. */
  show(stats: Readonly<ViewStats>): void {
    if (stats.pictures === this.pictures_) return;
    this.pictures_ = stats.pictures;
    this.times_.push(stats.pictureMs);
    if (this.times_.length > kWindow) this.times_.shift();
    const [half, most] = [percentile(this.times_, 0.5), percentile(this.times_, 0.95)];
    const drawn = `${stats.drawCalls} draws · ${stats.triangles.toLocaleString('en')} triangles`;
    setText(this.pictureLine_, `${drawn} · ${half.toFixed(1)} ms, 95 % below ${most.toFixed(1)} ms`);
  }
}

/** Whether the address asks for it. */
export function wantsStats(search: string): boolean {
  return new URLSearchParams(search).has('stats');
}
