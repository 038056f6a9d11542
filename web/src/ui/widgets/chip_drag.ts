// Drags one chip onto another, with mouse or finger.

const kStillPx = 10;
/** The dragged chip hangs below the pointer, so that the chip under it is seen [px]. */
const kLift = 22;

interface Held {
  readonly chip: HTMLElement;
  readonly id: number;
  readonly pointer: number;
  readonly x: number;
  readonly y: number;
  moved: boolean;
}

export class ChipDrag {
  private held_: Held | null = null;
  private target_: HTMLElement | null = null;
  /** A drag ends with a click, which chooses nothing. */
  private dragged_ = false;

  /** `idOf`: the id that a chip stands for. */
  constructor(
    private readonly idOf_: (chip: Element) => number | undefined,
    private readonly dropped_: (into: number, dragged: number) => void,
  ) {}

  watch(chip: HTMLElement, id: number): void {
    chip.addEventListener('pointerdown', (event) => {
      if (event.button > 0) return;
      this.dragged_ = false;
      this.held_ = { chip, id, pointer: event.pointerId, x: event.clientX, y: event.clientY, moved: false };
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
    held.chip.style.transform = `translate(${dx}px, ${dy + kLift}px)`;
    this.aimAt(this.chipUnder(event));
  }

  private chipUnder(event: PointerEvent): HTMLElement | null {
    const held = this.held_;
    const under = document.elementsFromPoint(event.clientX, event.clientY);
    const chip = under.map((one) => one.closest<HTMLElement>('.chip')).find((one) => one && one !== held?.chip);
    return chip ?? null;
  }

  private aimAt(chip: HTMLElement | null): void {
    if (chip === this.target_) return;
    this.target_?.classList.remove('drop-target');
    chip?.classList.add('drop-target');
    this.target_ = chip;
  }

  private ended(event: PointerEvent, drop: boolean): void {
    const held = this.held_;
    if (!held || held.pointer !== event.pointerId) return;
    const into = this.target_ && this.idOf_(this.target_);
    this.aimAt(null);
    this.held_ = null;
    held.chip.classList.remove('dragged');
    held.chip.style.transform = '';
    this.dragged_ = held.moved;
    if (drop && held.moved && into !== null && into !== undefined) this.dropped_(into, held.id);
  }
}
