// The time of a player: it runs, is sought, ends or begins again.

/** What happened, in the words of the web's media elements. */
export type PlaybackEvent = 'play' | 'pause' | 'ended' | 'timeupdate';

/** Told times are at least so far apart while it plays [s]. */
const kTellEvery = 0.2;
/** A page that was asleep goes on where it was [s]. */
const kMostStep = 0.25;

export class Playback {
  loop = false;
  /** Seconds of the file in one second. */
  speed = 1;
  private time_ = 0;
  private paused_ = true;
  private told_ = 0;

  constructor(
    readonly duration: number,
    private readonly tell_: (event: PlaybackEvent) => void,
  ) {}

  get time(): number {
    return this.time_;
  }

  get paused(): boolean {
    return this.paused_;
  }

  get ended(): boolean {
    return !this.loop && this.time_ >= this.duration;
  }

  play(): void {
    if (!this.paused_) return;
    if (this.ended) this.seek(0);
    this.paused_ = false;
    this.tell_('play');
  }

  pause(): void {
    if (this.paused_) return;
    this.paused_ = true;
    this.tell_('pause');
  }

  /** Goes to a time [s], which is clamped. */
  seek(time: number): void {
    this.time_ = Math.min(this.duration, Math.max(0, Number.isFinite(time) ? time : 0));
    this.tellTime();
  }

  /** Lets time pass [s]. */
  advance(seconds: number): void {
    if (this.paused_) return;
    const next = this.time_ + Math.min(kMostStep, Math.max(0, seconds)) * this.speed;
    if (next < this.duration) {
      this.time_ = next;
      if (Math.abs(next - this.told_) >= kTellEvery) this.tellTime();
      return;
    }
    if (this.loop && this.duration > 0) {
      this.time_ = next % this.duration;
      this.tellTime();
      return;
    }
    this.time_ = this.duration;
    this.paused_ = true;
    this.tellTime();
    this.tell_('pause');
    this.tell_('ended');
  }

  private tellTime(): void {
    this.told_ = this.time_;
    this.tell_('timeupdate');
  }
}

/** "0:07", for twenty minutes "20:00". */
export function clockText(seconds: number): string {
  const whole = Math.max(0, Math.floor(seconds + 1e-6));
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, '0')}`;
}
