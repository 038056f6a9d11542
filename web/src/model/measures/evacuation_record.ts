// How many people are in the world, and how many have left it by its exits.

import { Series, type Sample } from './series';

/** What exits and sources have seen; see AreaFrame. */
export interface PassedArea {
  readonly id: number;
  readonly passed: number;
}

export interface EvacuationSample extends Sample {
  readonly inside: number;
  /** By all exits since the world began. */
  readonly out: number;
  /** By each exit, as `exits` of the record lists them. */
  readonly byExit: readonly number[];
}

export class EvacuationRecord {
  readonly series = new Series<EvacuationSample>();
  /** Ids of exits, in the order in which they were seen first. */
  readonly exits: number[] = [];
  private passed_ = new Map<number, number>();
  private now_: EvacuationSample | null = null;
  /** When the last one left; NaN before anybody has [s]. */
  lastOut = NaN;

  /** How it is at the newest frame. */
  get now(): EvacuationSample | null {
    return this.now_;
  }

  /** `isExit` knows the areas of the world. An exit that is taken away has let through whom it has. */
  observe(time: number, inside: number, areas: readonly PassedArea[], isExit: (id: number) => boolean): void {
    for (const { id, passed } of areas) {
      if (!isExit(id)) continue;
      if (!this.passed_.has(id)) this.exits.push(id);
      this.passed_.set(id, passed);
    }
    const byExit = this.exits.map((id) => this.passed_.get(id) ?? 0);
    const out = byExit.reduce((sum, one) => sum + one, 0);
    if (this.now_ ? out > this.now_.out : out > 0) this.lastOut = time;
    this.now_ = { time, inside, out, byExit };
    if (this.series.isDue(time)) this.series.add(this.now_);
  }

  cut(time: number): void {
    this.series.cut(time);
    this.now_ = this.series.last ?? null;
    this.passed_ = new Map(this.exits.map((id, k) => [id, this.now_?.byExit[k] ?? 0]));
    this.lastOut = this.lastRise();
  }

  private lastRise(): number {
    const { samples } = this.series;
    for (let k = samples.length - 1; k >= 0; --k)
      if (samples[k]!.out > (samples[k - 1]?.out ?? 0)) return samples[k]!.time;
    return NaN;
  }

  clear(): void {
    this.series.clear();
    this.exits.length = 0;
    this.passed_.clear();
    this.now_ = null;
    this.lastOut = NaN;
  }
}
