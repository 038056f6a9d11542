// Space plays or pauses when it is tapped, and pans while it is held with the mouse.

export class SpaceKey {
  private held = false;
  private used = false;

  constructor(
    target: EventTarget,
    private readonly panning: (held: boolean) => void,
    private readonly tapped: () => void,
  ) {
    target.addEventListener('keydown', (event) => this.down(event as KeyboardEvent));
    target.addEventListener('keyup', (event) => this.up(event as KeyboardEvent));
    target.addEventListener('pointerdown', () => {
      this.used ||= this.held;
    });
    target.addEventListener('blur', () => this.release());
  }

  private down(event: KeyboardEvent): void {
    if (event.key !== ' ' || event.defaultPrevented) return;
    const { target } = event;
    if (target instanceof HTMLElement && target.closest('button, input, dialog, a') !== null) return;
    event.preventDefault();
    if (this.held) return;
    this.held = true;
    this.used = false;
    this.panning(true);
  }

  private up(event: KeyboardEvent): void {
    if (event.key !== ' ' || !this.held) return;
    const tap = !this.used;
    this.release();
    if (tap) this.tapped();
  }

  private release(): void {
    this.held = false;
    this.panning(false);
  }
}
