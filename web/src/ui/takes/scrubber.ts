// Goes to moments of the open take as fast as pictures of them come: one request is out at a time, and only the newest wish
// is kept.

import { PlaybackAction, type ClientMessage } from '../../protocol/messages';

/** After this time without an answer the next wish is sent all the same [ms]. */
const kPatience = 400;

export class Scrubber {
  private wished_: number | null = null;
  private asked_: number | null = null;
  private askedAt_ = 0;
  private resumes_ = false;

  constructor(
    private readonly send_: (message: ClientMessage) => void,
    private readonly now_: () => number = () => performance.now(),
  ) {}

  /** The step that is wished and not yet shown; null for none. */
  get wished(): number | null {
    return this.wished_ ?? this.asked_;
  }

  /** A finger takes the playhead: playing pauses until it lets go. */
  begin(playing: boolean): void {
    this.resumes_ = playing;
    if (playing) this.send_({ type: 'Playback', action: PlaybackAction.Pause });
  }

  to(step: number): void {
    this.wished_ = Math.max(0, Math.round(step));
    this.go();
  }

  end(): void {
    if (this.resumes_) this.send_({ type: 'Playback', action: PlaybackAction.Play });
    this.resumes_ = false;
  }

  /** Call with every frame. */
  observe(step: number): void {
    if (this.asked_ !== null && (step === this.asked_ || this.now_() - this.askedAt_ > kPatience)) this.asked_ = null;
    this.go();
  }

  private go(): void {
    if (this.asked_ !== null && this.now_() - this.askedAt_ < kPatience) return;
    if (this.wished_ === null) return;
    this.send_({ type: 'Seek', step: this.wished_ });
    this.asked_ = this.wished_;
    this.askedAt_ = this.now_();
    this.wished_ = null;
  }
}
