// Drags chips of a list to other places in it, with mouse or finger.

const kStillPx = 10;
/** The dragged chip hangs above the pointer, so that the chips under it are seen [px]. */
const kLift = 34;

interface Held {
  readonly chip: HTMLElement;
  readonly pointer: number;
  readonly x: number;
  readonly y: number;
  moved: boolean;
}

export class RowDrag {
  private held_: Held | null = null;
  /** Where it would be dropped: a chip, and on which side of it. */
  private aim_: { readonly chip: HTMLElement; readonly after: boolean } | null = null;
  /** A drag ends with a click, which chooses nothing. */
  private dragged_ = false;

  /** `list` holds the chips; `dropped`: from one index to another one, counted without the dragged chip. */
  constructor(
    private readonly list_: HTMLElement,
    private readonly dropped_: (from: number, to: number) => void,
  ) {}

  watch(chip: HTMLElement): void {
    chip.addEventListener('pointerdown', (event) => {
      if (event.button > 0 || this.held_) return;
      this.dragged_ = false;
      this.held_ = { chip, pointer: event.pointerId, x: event.clientX, y: event.clientY, moved: false };
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

  /** Drops the chip where it was. */
  cancel(): void {
    if (!this.held_) return;
    this.release(this.held_);
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
    held.chip.style.transform = `translate(${dx}px, ${dy - kLift}px)`;
    this.aimAt(event);
  }

  private aimAt(event: PointerEvent): void {
    const under = document.elementsFromPoint(event.clientX, event.clientY);
    const chips = [...this.list_.children];
    const chip = under
      .map((one) => chips.find((candidate) => candidate.contains(one)) as HTMLElement | undefined)
      .find((one) => one && one !== this.held_?.chip);
    if (!chip) return this.mark(null);
    const box = chip.getBoundingClientRect();
    this.mark({ chip, after: event.clientX > box.left + box.width / 2 });
  }

  private mark(aim: RowDrag['aim_']): void {
    this.aim_?.chip.classList.remove('drop-before', 'drop-after');
    this.aim_ = aim;
    aim?.chip.classList.add(aim.after ? 'drop-after' : 'drop-before');
  }

  private ended(event: PointerEvent, drop: boolean): void {
    const held = this.held_;
    if (!held || held.pointer !== event.pointerId) return;
    const chips = [...this.list_.children];
    const aim = this.aim_;
    this.dragged_ = held.moved;
    this.release(held);
    if (!drop || !held.moved || !aim) return;
    const from = chips.indexOf(held.chip);
    const before = chips.indexOf(aim.chip) + (aim.after ? 1 : 0);
    const to = before > from ? before - 1 : before;
    if (to !== from) this.dropped_(from, to);
  }

  private release(held: Held): void {
    this.mark(null);
    this.held_ = null;
    held.chip.classList.remove('dragged');
    held.chip.style.transform = '';
  }
}
