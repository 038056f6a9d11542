// Keys on the rows of the time line.

import type { TrackActions, TracksState } from './track_actions';

/** A key moves a block by so much, with Shift by ten times as much [s]. */
const kNudge = 0.1;

export class TrackKeys {
  constructor(
    private readonly actions_: TrackActions,
    private readonly state_: () => TracksState | null,
  ) {}

  listen(root: HTMLElement): void {
    root.addEventListener('focusin', ({ target }) => this.focused(target as HTMLElement));
    root.addEventListener('keydown', (event) => {
      if (!this.pressed(root, event)) return;
      event.preventDefault();
      event.stopPropagation();
    });
    // Before the keys of the studio, whose undo is of the crowd.
    window.addEventListener('keydown', (event) => this.undoes(event), { capture: true });
  }

  private undoes(event: KeyboardEvent): void {
    const { key, ctrlKey, metaKey, shiftKey } = event;
    const redo = (shiftKey && /^z$/i.test(key)) || /^y$/i.test(key);
    if (!this.state_() || !(ctrlKey || metaKey) || !/^[zy]$/i.test(key)) return;
    if ((event.target as Element).closest?.('input, textarea, dialog')) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    this.actions_.undo(redo);
  }

  /** Who goes to a block by keys has chosen it. */
  private focused(target: HTMLElement): void {
    if (target.matches(':focus-visible')) this.chosen(target);
  }

  private chosen(target: HTMLElement): void {
    const state = this.state_();
    const { block, key } = target.dataset;
    if (!state) return;
    if (block !== undefined && !(state.chosen && 'block' in state.chosen && state.chosen.block === Number(block)))
      this.actions_.choose({ block: Number(block) });
    if (key !== undefined && !(state.chosen && 'key' in state.chosen && state.chosen.key === Number(key)))
      this.actions_.choose({ key: Number(key) });
  }

  /** True where the key means something here. */
  private pressed(root: HTMLElement, event: KeyboardEvent): boolean {
    const state = this.state_();
    const target = event.target as HTMLElement;
    if (!state) return false;
    if (event.key === 'Escape' && state.drag) return (this.actions_.preview(null), true);
    const { block, key } = target.dataset;
    if (block === undefined && key === undefined) return false;
    this.chosen(target);
    if (event.ctrlKey || event.metaKey) return this.control(event.key.toLowerCase());
    const step = (event.shiftKey ? 10 : 1) * (kNudge / state.take.stepTime);
    const does: Partial<Record<string, () => void>> = {
      ArrowLeft: () => this.actions_.nudge(-step),
      ArrowRight: () => this.actions_.nudge(step),
      ArrowUp: () => this.otherRow(root, target, false),
      ArrowDown: () => this.otherRow(root, target, true),
      Delete: () => this.actions_.remove(),
      Backspace: () => this.actions_.remove(),
      Enter: () => this.toTools(root, target),
      ' ': () => this.toTools(root, target),
    };
    does[event.key]?.();
    return event.key in does;
  }

  private toTools(root: HTMLElement, { dataset: { block, key } }: HTMLElement): void {
    this.actions_.choose(block !== undefined ? { block: Number(block) } : { key: Number(key) });
    root.querySelector<HTMLElement>('.tracks-chosen :is(input, button, select)')?.focus();
  }

  private control(key: string): boolean {
    if (key === 'c') this.actions_.copy();
    else if (key === 'v') this.actions_.paste();
    else return false;
    return true;
  }

  /** The block of the next row that is nearest in time. */
  private otherRow(root: HTMLElement, from: HTMLElement, down: boolean): void {
    const lanes = [...root.querySelectorAll('.track-lane')].filter((lane) =>
      lane.querySelector('[data-block], [data-key]'),
    );
    const lane = lanes[lanes.indexOf(from.closest('.track-lane')!) + (down ? 1 : -1)];
    const left = from.getBoundingClientRect().left;
    const away = (one: HTMLElement): number => Math.abs(one.getBoundingClientRect().left - left);
    const [nearest] = [...(lane?.querySelectorAll<HTMLElement>('[data-block], [data-key]') ?? [])].sort(
      (a, b) => away(a) - away(b),
    );
    nearest?.focus();
  }
}
