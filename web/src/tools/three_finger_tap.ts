// Three fingers that tap together, anywhere on an element. What each of them touches sees them as well.

/** A finger that moves no farther is still [px]. */
const kStill = 12;
/** From the first finger down to the last one up [ms]. */
const kTapMs = 400;

export class ThreeFingerTap {
  private readonly down_ = new Map<number, { readonly x: number; readonly y: number }>();
  private most_ = 0;
  private spoilt_ = false;
  private began_ = 0;

  constructor(
    target: HTMLElement,
    private readonly tapped_: () => void,
  ) {
    target.addEventListener('pointerdown', (event) => this.pressed(event));
    target.addEventListener('pointermove', (event) => this.moved(event));
    target.addEventListener('pointerup', (event) => this.lifted(event, false));
    target.addEventListener('pointercancel', (event) => this.lifted(event, true));
  }

  private pressed({ pointerType, pointerId, clientX, clientY, timeStamp }: PointerEvent): void {
    if (pointerType !== 'touch') return;
    if (this.down_.size === 0) [this.most_, this.spoilt_, this.began_] = [0, false, timeStamp];
    this.down_.set(pointerId, { x: clientX, y: clientY });
    this.most_ = Math.max(this.most_, this.down_.size);
  }

  private moved({ pointerId, clientX, clientY }: PointerEvent): void {
    const from = this.down_.get(pointerId);
    if (from && Math.hypot(clientX - from.x, clientY - from.y) > kStill) this.spoilt_ = true;
  }

  private lifted({ pointerId, timeStamp }: PointerEvent, cancelled: boolean): void {
    if (!this.down_.delete(pointerId)) return;
    this.spoilt_ ||= cancelled;
    if (this.down_.size > 0 || this.spoilt_ || this.most_ !== 3) return;
    if (timeStamp - this.began_ < kTapMs) this.tapped_();
  }
}
