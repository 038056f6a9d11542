// Paces pictures where software renders them: no picture is begun before the last one is finished, as a queue of old
// pictures only adds latency. After each picture drawing rests as long as the picture took, since the renderer shares
// its processors with the simulation. The answer to a touch does not wait for the rest.

/** What the pace needs of WebGL 2. */
export type FenceContext = Pick<
  WebGL2RenderingContext,
  'SYNC_GPU_COMMANDS_COMPLETE' | 'SYNC_STATUS' | 'SIGNALED' | 'fenceSync' | 'getSyncParameter' | 'deleteSync' | 'flush'
>;

/** Longest rest between pictures [ms]. */
const kRest = 40;
/** A fence that nobody signals is forgotten after this [ms]. */
const kPatience = 250;

export class GpuPace {
  private fence_: WebGLSync | null = null;
  private since_ = 0;
  private restUntil_ = 0;

  constructor(private readonly gl_: FenceContext) {}

  /** A picture was just handed over; `now` by performance.now() [ms]. */
  sent(now: number): void {
    if (this.fence_) this.gl_.deleteSync(this.fence_);
    this.fence_ = this.gl_.fenceSync(this.gl_.SYNC_GPU_COMMANDS_COMPLETE, 0);
    this.since_ = now;
    this.gl_.flush();
  }

  /** True while the last picture is not finished, or, where nothing is urgent, during the rest after it. */
  busy(now: number, urgent: boolean): boolean {
    if (!this.fence_) return !urgent && now < this.restUntil_;
    const done = this.gl_.getSyncParameter(this.fence_, this.gl_.SYNC_STATUS) === this.gl_.SIGNALED;
    if (!done && now - this.since_ < kPatience) return true;
    this.gl_.deleteSync(this.fence_);
    this.fence_ = null;
    this.restUntil_ = now + Math.min(kRest, now - this.since_);
    return !urgent && now < this.restUntil_;
  }
}
