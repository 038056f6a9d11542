// Fingers, mouse and wheel on the rows of the time line: blocks and keys are dragged, the ruler moves the playhead, empty ground
// moves and zooms the time that is shown.

import { panned, snapped, stepAt, zoomed, type TimeWindow } from '../../../model/take_tracks';
import type { TrackActions, TrackDrag, TracksState } from './track_actions';

/** A press that moves less is none [CSS px]. */
const kStill = 5;
/** So near a block snaps to the playhead and to seconds [CSS px]. */
const kSnap = 7;

/** What a press on the rows takes hold of. */
type Hold =
  | { readonly kind: 'block'; readonly id: number; readonly stretch: boolean; readonly from: number }
  | { readonly kind: 'key'; readonly id: number; readonly from: number }
  | { readonly kind: 'ruler' }
  | { readonly kind: 'ground'; readonly shown: TimeWindow };

export class TrackPointer {
  private hold_: Hold | null = null;
  private readonly down_ = new Map<number, number>();
  private began_ = 0;
  private moved_ = false;
  private alt_ = false;
  /** Distance of two fingers and the step between them, as they came down. */
  private pinch_: { readonly apart: number; readonly at: number; readonly shown: TimeWindow } | null = null;

  constructor(
    private readonly actions_: TrackActions,
    private readonly state_: () => TracksState | null,
  ) {}

  listen(root: HTMLElement): void {
    root.addEventListener('pointerdown', (event) => this.down(event));
    root.addEventListener('pointermove', (event) => this.move(event));
    root.addEventListener('pointerup', (event) => this.up(event, true));
    root.addEventListener('pointercancel', (event) => this.up(event, false));
    root.addEventListener('wheel', (event) => this.wheel(event), { passive: false });
    document.addEventListener('keydown', ({ key }) => key === 'Escape' && this.give());
  }

  private lane(event: Event): HTMLElement | null {
    return (event.target as Element).closest<HTMLElement>('.track-lane');
  }

  private left(event: Event): number {
    return this.lane(event)?.getBoundingClientRect().left ?? 0;
  }

  private down(event: PointerEvent): void {
    const state = this.state_();
    if (!state || event.button > 0 || !this.lane(event)) return;
    this.down_.set(event.pointerId, event.clientX);
    if (this.down_.size === 2) return this.beginPinch(state, this.left(event));
    if (this.down_.size > 2) return;
    const target = event.target as Element;
    const held = target.closest<HTMLElement>('[data-block], [data-key]');
    const { block, key } = held?.dataset ?? {};
    this.lane(event)!.setPointerCapture(event.pointerId);
    [this.began_, this.moved_, this.alt_] = [event.clientX, false, event.altKey];
    if (block !== undefined) {
      const id = Number(block);
      const found = state.tracks?.blocks.find((one) => one.id === id);
      const stretch = target.closest('.track-grip') !== null;
      if (found) this.hold_ = { kind: 'block', id, stretch, from: stretch ? found.end : found.begin };
    } else if (key !== undefined) this.hold_ = { kind: 'key', id: Number(key), from: Number(key) };
    else if (target.closest('.track-ruler')) {
      this.hold_ = { kind: 'ruler' };
      this.actions_.scrub(true);
      this.scrubTo(state, event);
    } else this.hold_ = { kind: 'ground', shown: state.shown };
    if (held) {
      event.preventDefault();
      held.focus({ preventScroll: true });
    }
  }

  private beginPinch(state: TracksState, left: number): void {
    this.give();
    const [a, b] = [...this.down_.values()] as [number, number];
    const at = stepAt(state.shown, state.width, (a + b) / 2 - left);
    this.pinch_ = { apart: Math.max(20, Math.abs(a - b)), at, shown: state.shown };
  }

  private scrubTo(state: TracksState, event: PointerEvent): void {
    const step = Math.round(stepAt(state.shown, state.width, event.clientX - this.left(event)));
    this.actions_.seek(Math.min(state.take.steps, Math.max(0, step)));
  }

  private move(event: PointerEvent): void {
    const state = this.state_();
    if (!state || !this.down_.has(event.pointerId)) return;
    this.down_.set(event.pointerId, event.clientX);
    if (this.pinch_ && this.down_.size >= 2) {
      const [a, b] = [...this.down_.values()] as [number, number];
      const { shown, at, apart } = this.pinch_;
      return this.actions_.showTime(zoomed(shown, state.take.steps, state.take.stepTime, Math.abs(a - b) / apart, at));
    }
    const hold = this.hold_;
    if (!hold) return;
    const by = event.clientX - this.began_;
    this.moved_ ||= Math.abs(by) > kStill;
    if (hold.kind === 'ruler') return this.scrubTo(state, event);
    if (!this.moved_) return;
    const perPixel = (state.shown.to - state.shown.from) / Math.max(1, state.width);
    if (hold.kind === 'ground') return this.actions_.showTime(panned(hold.shown, state.take.steps, -by * perPixel));
    this.alt_ = event.altKey;
    this.actions_.preview(this.dragged(state, hold, hold.from + by * perPixel));
  }

  private dragged(state: TracksState, hold: Extract<Hold, { id: number }>, wished: number): TrackDrag {
    const { take, shown, width } = state;
    const reach = stepAt(shown, width, kSnap) - stepAt(shown, width, 0);
    const step = Math.max(0, snapped(wished, state.step, take.stepTime, reach));
    if (hold.kind === 'key') return { edit: 'key', id: hold.id, step: Math.min(take.steps, step) };
    const edit = hold.stretch ? 'stretch' : this.alt_ ? 'copy' : 'move';
    return { edit, id: hold.id, step: edit === 'stretch' ? step : Math.min(take.steps - 1, step) };
  }

  private up(event: PointerEvent, done: boolean): void {
    if (!this.down_.delete(event.pointerId)) return;
    if (this.down_.size < 2) this.pinch_ = null;
    if (this.down_.size > 0) return;
    const [hold, state] = [this.hold_, this.state_()];
    this.hold_ = null;
    if (!hold || !state) return;
    if (hold.kind === 'ruler') return this.actions_.scrub(false);
    if (hold.kind === 'ground') return this.moved_ ? undefined : this.actions_.choose(null);
    this.actions_.choose(hold.kind === 'key' ? { key: hold.id } : { block: hold.id });
    const drag = state.drag;
    if (done && this.moved_ && drag) this.actions_.commit(drag);
    else this.actions_.preview(null);
  }

  /** Nothing that is held is moved. */
  private give(): void {
    if (this.hold_?.kind === 'ruler') this.actions_.scrub(false);
    else if (this.hold_) this.actions_.preview(null);
    this.hold_ = null;
  }

  private wheel(event: WheelEvent): void {
    const state = this.state_();
    if (!state) return;
    const root = event.currentTarget as HTMLElement;
    const scrolls = root.scrollHeight > root.clientHeight + 1;
    const sideways = Math.abs(event.deltaX) > Math.abs(event.deltaY);
    const ruler = (event.target as Element).closest('.track-ruler') !== null;
    const perPixel = (state.shown.to - state.shown.from) / Math.max(1, state.width);
    if (sideways || event.shiftKey) {
      event.preventDefault();
      const by = sideways ? event.deltaX : event.deltaY;
      return this.actions_.showTime(panned(state.shown, state.take.steps, by * perPixel));
    }
    if (scrolls && !ruler && !event.ctrlKey && !event.metaKey) return;
    event.preventDefault();
    const left = root.querySelector('.track-lane')!.getBoundingClientRect().left;
    this.actions_.zoom(Math.exp(-event.deltaY / 300), stepAt(state.shown, state.width, event.clientX - left));
  }
}
