// Space plays or pauses when it is tapped, and pans while it is held with the mouse.

export class SpaceKey {
  private held_ = false;
  private used_ = false;

  constructor(
    target: EventTarget,
    private readonly panning_: (held: boolean) => void,
    private readonly tapped_: () => void,
  ) {
    target.addEventListener('keydown', (event) => this.down(event as KeyboardEvent));
    target.addEventListener('keyup', (event) => this.up(event as KeyboardEvent));
    target.addEventListener('pointerdown', () => {
      this.used_ ||= this.held_;
    });
    target.addEventListener('blur', () => this.release());
  }

  private down(event: KeyboardEvent): void {
    if (event.key !== ' ' || event.defaultPrevented) return;
    const { target } = event;
    if (target instanceof HTMLElement && target.closest('button, input, dialog, a') !== null) return;
    event.preventDefault();
    if (this.held_) return;
    this.held_ = true;
    this.used_ = false;
    this.panning_(true);
  }

  private up(event: KeyboardEvent): void {
    if (event.key !== ' ' || !this.held_) return;
    const tap = !this.used_;
    this.release();
    if (tap) this.tapped_();
  }

  private release(): void {
    this.held_ = false;
    this.panning_(false);
  }
}
