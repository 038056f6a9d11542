// How fast the world goes on, measured where it is shown.

/** Measured over so long [ms]. */
const kSpan = 2000;

export class PaceMeter {
  private from_: { readonly time: number; readonly now: number; readonly speed: number } | null = null;
  private pace_ = NaN;

  /** Seconds of the world per second; NaN where that is not known. `now` [ms]. */
  observe(time: number, playing: boolean, speed: number, now: number): number {
    const from = this.from_;
    if (!playing || !from || speed !== from.speed || time < from.time) {
      this.from_ = playing ? { time, now, speed } : null;
      this.pace_ = NaN;
    } else if (now - from.now >= kSpan) {
      this.pace_ = (1000 * (time - from.time)) / (now - from.now);
      this.from_ = { time, now, speed };
    }
    return this.pace_;
  }
}
