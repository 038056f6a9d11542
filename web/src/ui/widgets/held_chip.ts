// A chip that mouse or finger drags; what it is dropped on is its owner's matter.

const kStillPx = 10;

interface Held<Value> {
  readonly chip: HTMLElement;
  readonly value: Value;
  readonly pointer: number;
  readonly x: number;
  readonly y: number;
  moved: boolean;
}

/** What the owner of dragged chips does. */
export interface ChipDragOwner<Value> {
  /** The pointer has moved with a chip. */
  aim(event: PointerEvent, chip: HTMLElement): void;
  /** The drag has ended: dropped, or given up. The chip is where it was. */
  end(chip: HTMLElement, value: Value, dropped: boolean): void;
}

export class HeldChip<Value = undefined> {
  private held_: Held<Value> | null = null;
  /** A drag ends with a click, which chooses nothing. */
  private dragged_ = false;

  /** `lift`: how far above the pointer a dragged chip hangs, so that the chips under it are seen [px]. */
  constructor(
    private readonly lift_: number,
    private readonly owner_: ChipDragOwner<Value>,
  ) {}

  watch(chip: HTMLElement, value: Value): void {
    chip.addEventListener('pointerdown', (event) => {
      // A press that ended outside the chip, or whose chip is gone, was never told to end.
      const busy = this.held_?.moved && this.held_.chip.isConnected;
      if (event.button > 0 || busy) return;
      this.dragged_ = false;
      this.held_ = { chip, value, pointer: event.pointerId, x: event.clientX, y: event.clientY, moved: false };
    });
    chip.addEventListener('pointermove', (event) => this.moved(event));
    chip.addEventListener('pointerup', (event) => this.ended(event, true));
    chip.addEventListener('pointercancel', (event) => this.ended(event, false));
  }

  /** True once after a drag: its click shall do nothing. */
  consumeClick(): boolean {
    const dragged = this.dragged_;
    this.dragged_ = false;
    return dragged;
  }

  /** Puts the chip back where it was. */
  cancel(): void {
    if (this.held_) this.release(this.held_, false);
  }

  private moved(event: PointerEvent): void {
    const held = this.held_;
    if (!held || held.pointer !== event.pointerId) return;
    const [dx, dy] = [event.clientX - held.x, event.clientY - held.y];
    if (!held.moved) {
      if (Math.hypot(dx, dy) < kStillPx) return;
      held.moved = true;
      held.chip.setPointerCapture(event.pointerId);
      held.chip.classList.add('dragged');
    }
    held.chip.style.transform = `translate(${dx}px, ${dy - this.lift_}px)`;
    this.owner_.aim(event, held.chip);
  }

  private ended(event: PointerEvent, drop: boolean): void {
    const held = this.held_;
    if (!held || held.pointer !== event.pointerId) return;
    this.dragged_ = held.moved;
    this.release(held, drop && held.moved);
  }

  private release({ chip, value }: Held<Value>, dropped: boolean): void {
    this.held_ = null;
    chip.classList.remove('dragged');
    chip.style.transform = '';
    this.owner_.end(chip, value, dropped);
  }
}
