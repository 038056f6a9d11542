// Samples over time. A long series keeps every other sample and goes on half as often.

export interface Sample {
  readonly time: number;
}

/** The time between samples at first [s], and the most that are kept. */
const kApart = 0.2;
const kMost = 6000;
/** Frames lie on times that are rounded. */
const kSlack = 1e-6;

export class Series<What extends Sample> {
  samples: What[] = [];
  private apart_ = kApart;

  constructor(private readonly most_ = kMost) {}

  /** Time from one sample to the next [s]. */
  get apart(): number {
    return this.apart_;
  }

  get last(): What | undefined {
    return this.samples[this.samples.length - 1];
  }

  isDue(time: number): boolean {
    const { last } = this;
    return last === undefined || time - last.time >= this.apart_ - kSlack;
  }

  add(sample: What): void {
    this.samples.push(sample);
    if (this.samples.length <= this.most_) return;
    this.samples = this.samples.filter((_, k) => k % 2 === 0);
    this.apart_ *= 2;
  }

  cut(time: number): void {
    this.samples = this.samples.filter((one) => one.time <= time);
  }

  clear(): void {
    this.samples = [];
    this.apart_ = kApart;
  }
}
