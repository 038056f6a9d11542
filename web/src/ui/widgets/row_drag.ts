// Drags chips of a list to other places in it, with mouse or finger.

import { HeldChip } from './held_chip';

const kLift = 34;

export class RowDrag {
  private readonly held_ = new HeldChip(kLift, {
    aim: (event, chip) => this.aimAt(event, chip),
    end: (chip, _, dropped) => this.ended(chip, dropped),
  });
  /** Where it would be dropped: a chip, and on which side of it. */
  private aim_: { readonly chip: HTMLElement; readonly after: boolean } | null = null;

  /** `list` holds the chips; `dropped`: from one index to another one, counted without the dragged chip. */
  constructor(
    private readonly list_: HTMLElement,
    private readonly dropped_: (from: number, to: number) => void,
  ) {}

  watch(chip: HTMLElement): void {
    this.held_.watch(chip, undefined);
  }

  /** True once after a drag: its click shall do nothing. */
  consumeClick(): boolean {
    return this.held_.consumeClick();
  }

  /** Drops the chip where it was. */
  cancel(): void {
    this.held_.cancel();
  }

  private aimAt(event: PointerEvent, dragged: HTMLElement): void {
    const under = document.elementsFromPoint(event.clientX, event.clientY);
    const chips = [...this.list_.children];
    const chip = under
      .map((one) => chips.find((candidate) => candidate.contains(one)) as HTMLElement | undefined)
      .find((one) => one && one !== dragged);
    if (!chip) return this.mark(null);
    const box = chip.getBoundingClientRect();
    this.mark({ chip, after: event.clientX > box.left + box.width / 2 });
  }

  private mark(aim: RowDrag['aim_']): void {
    this.aim_?.chip.classList.remove('drop-before', 'drop-after');
    this.aim_ = aim;
    aim?.chip.classList.add(aim.after ? 'drop-after' : 'drop-before');
  }

  private ended(dragged: HTMLElement, dropped: boolean): void {
    const chips = [...this.list_.children];
    const aim = this.aim_;
    this.mark(null);
    if (!dropped || !aim) return;
    const from = chips.indexOf(dragged);
    const before = chips.indexOf(aim.chip) + (aim.after ? 1 : 0);
    const to = before > from ? before - 1 : before;
    if (to !== from) this.dropped_(from, to);
  }
}
