// Drags one chip onto another, with mouse or finger.

import { HeldChip } from './held_chip';

/** The dragged chip hangs below the pointer. */
const kLift = -22;

export class ChipDrag {
  private readonly held_ = new HeldChip<number>(kLift, {
    aim: (event, chip) => this.aimAt(chipUnder(event, chip)),
    end: (_, id, dropped) => this.ended(id, dropped),
  });
  private target_: HTMLElement | null = null;

  /** `idOf`: the id that a chip stands for. */
  constructor(
    private readonly idOf_: (chip: Element) => number | undefined,
    private readonly dropped_: (into: number, dragged: number) => void,
  ) {}

  watch(chip: HTMLElement, id: number): void {
    this.held_.watch(chip, id);
  }

  /** True once after a drag: its click shall do nothing. */
  consumeClick(): boolean {
    return this.held_.consumeClick();
  }

  private aimAt(chip: HTMLElement | null): void {
    if (chip === this.target_) return;
    this.target_?.classList.remove('drop-target');
    chip?.classList.add('drop-target');
    this.target_ = chip;
  }

  private ended(id: number, dropped: boolean): void {
    const into = this.target_ && this.idOf_(this.target_);
    this.aimAt(null);
    if (dropped && into !== null && into !== undefined) this.dropped_(into, id);
  }
}

function chipUnder(event: PointerEvent, dragged: HTMLElement): HTMLElement | null {
  const under = document.elementsFromPoint(event.clientX, event.clientY);
  const chip = under.map((one) => one.closest<HTMLElement>('.chip')).find((one) => one && one !== dragged);
  return chip ?? null;
}
