// The track of the time line: the playhead, the ends of the part, and what happened when.

import { TakeMarkKind, type TakeMark } from '../../protocol/messages';
import type { TakeActions } from '../../model/take_actions';
import { clockAt, countMarks, shownOf, trimmed, type OpenTake, type StepRange } from '../../model/take_facts';
import { element, setAttribute } from '../widgets/dom';

/** Rows of touches, from below. */
const kRows = 4;
/** A press this near to an end of the part takes hold of it [px]. */
const kReach = 22;

/** A key frame of the camera, about its middle, so far below the upper edge [px]. */
const kDiamond: readonly (readonly [number, number])[] = [
  [0, -5],
  [5, 0],
  [0, 5],
  [-5, 0],
];
const kDiamondAt = 18;

type Hold = 'head' | 'from' | 'to';

/** The row of each touch: the lowest that is free. */
export function rowsOf(touches: readonly TakeMark[]): number[] {
  const ends = new Array<number>(kRows).fill(-1);
  return touches.map(({ step, length }) => {
    const free = ends.findIndex((end) => end < step);
    const row = free >= 0 ? free : ends.indexOf(Math.min(...ends));
    ends[row] = step + length;
    return row;
  });
}

export class TimeTrack {
  private readonly marks_ = element('canvas', { class: 'time-marks', 'aria-hidden': 'true' });
  private readonly ready_ = element('div', { class: 'time-ready' });
  private readonly before_ = element('div', { class: 'time-outside' });
  private readonly after_ = element('div', { class: 'time-outside' });
  private readonly head_ = this.slider('time-playhead', 'Moment of the take');
  private readonly from_ = this.slider('time-end time-from', 'Beginning of the part');
  private readonly to_ = this.slider('time-end time-to', 'End of the part');
  readonly root = element(
    'div',
    { class: 'time-track' },
    this.ready_,
    this.marks_,
    this.before_,
    this.after_,
    this.from_,
    this.to_,
    this.head_,
  );
  private take_: OpenTake | null = null;
  private step_ = 0;
  private hold_: Hold | null = null;
  private keys_: readonly number[] = [];
  /** The take has been read up to there. */
  private readyTo_ = 0;
  private part_: StepRange | null = null;
  /** The steps between its left and right end. */
  private shown_: StepRange = { from: 0, to: 1 };

  constructor(private readonly actions_: TakeActions) {
    this.root.addEventListener('pointerdown', (event) => this.down(event));
    this.root.addEventListener('pointermove', (event) => this.moved(event));
    for (const type of ['pointerup', 'pointercancel', 'lostpointercapture'] as const)
      this.root.addEventListener(type, () => this.up());
    this.head_.addEventListener('keydown', (event) => this.keyed(event, 'head'));
    this.from_.addEventListener('keydown', (event) => this.keyed(event, 'from'));
    this.to_.addEventListener('keydown', (event) => this.keyed(event, 'to'));
    if (typeof ResizeObserver !== 'undefined') new ResizeObserver(() => this.drawMarks()).observe(this.root);
  }

  /** The moment that is shown or wished. */
  get step(): number {
    return this.step_;
  }

  setTake(take: OpenTake): void {
    const sameMarks =
      this.take_?.marks === take.marks && this.take_.speeds === take.speeds && this.shows(shownOf(take));
    this.take_ = take;
    if (this.hold_ === null) this.shown_ = shownOf(take);
    this.place();
    setAttribute(this.head_, 'aria-description', countMarks(take.marks));
    if (!sameMarks) this.drawMarks();
  }

  private shows({ from, to }: StepRange): boolean {
    return this.shown_.from === from && this.shown_.to === to;
  }

  setStep(step: number): void {
    if (this.hold_ === 'head' || step === this.step_) return;
    this.step_ = step;
    this.place();
  }

  setReady(steps: number): void {
    this.readyTo_ = steps;
    this.place();
  }

  /** Key frames of the camera. */
  setKeys(steps: readonly number[]): void {
    this.keys_ = steps;
    this.drawMarks();
  }

  focusFrom(): void {
    this.from_.focus();
  }

  private slider(name: string, label: string): HTMLElement {
    return element('div', { class: name, role: 'slider', tabindex: 0, 'aria-label': label });
  }

  private get part(): StepRange {
    return this.part_ ?? { from: this.take_?.from ?? 0, to: this.take_?.to ?? 0 };
  }

  private place(): void {
    const take = this.take_;
    if (!take) return;
    const percent = (step: number): string => `${100 * this.shareOf(step)}%`;
    const { from, to } = this.part;
    this.before_.style.width = percent(from);
    this.after_.style.width = `${100 - 100 * this.shareOf(to)}%`;
    this.ready_.style.width = percent(this.readyTo_);
    for (const [handle, step, low, high] of [
      [this.head_, this.step_, 0, take.steps],
      [this.from_, from, 0, to],
      [this.to_, to, from, take.steps],
    ] as const) {
      handle.style.left = percent(step);
      setAttribute(handle, 'aria-valuemin', String(low));
      setAttribute(handle, 'aria-valuemax', String(high));
      setAttribute(handle, 'aria-valuenow', String(step));
      setAttribute(handle, 'aria-valuetext', clockAt(take, step));
    }
  }

  private stepAt(clientX: number): number {
    const box = this.root.getBoundingClientRect();
    const share = box.width > 0 ? (clientX - box.left) / box.width : 0;
    const { from, to } = this.shown_;
    return Math.round(from + Math.min(1, Math.max(0, share)) * (to - from));
  }

  /** Where a step lies, from 0 at the left end to 1; what is not shown lies at an end. */
  private shareOf(step: number): number {
    const { from, to } = this.shown_;
    return Math.min(1, Math.max(0, (step - from) / Math.max(1, to - from)));
  }

  /** An end of the part where the press is at it and not nearer to the playhead. */
  private holdAt(clientX: number): Hold {
    const box = this.root.getBoundingClientRect();
    const far = (step: number): number => Math.abs(clientX - box.left - box.width * this.shareOf(step));
    const { from, to } = this.part;
    const [toFrom, toTo, toHead] = [far(from), far(to), far(this.step_)];
    // At an end the playhead lies on the handle: the press is above or below it by kind.
    if (Math.min(toFrom, toTo) > kReach || toHead + 4 < Math.min(toFrom, toTo)) return 'head';
    return toFrom < toTo ? 'from' : 'to';
  }

  private down(event: PointerEvent): void {
    if (!this.take_ || event.button > 0) return;
    event.preventDefault();
    this.root.setPointerCapture?.(event.pointerId);
    const target = event.target as Element;
    this.hold_ = target === this.from_ ? 'from' : target === this.to_ ? 'to' : this.holdAt(event.clientX);
    const handle = { head: this.head_, from: this.from_, to: this.to_ }[this.hold_];
    handle.focus({ preventScroll: true });
    this.actions_.beginScrub();
    if (this.hold_ === 'head') this.go(this.stepAt(event.clientX));
  }

  private moved(event: PointerEvent): void {
    if (this.hold_ === null || !this.take_) return;
    const step = this.stepAt(event.clientX);
    if (this.hold_ === 'head') this.go(step);
    else this.trim(this.hold_, step);
  }

  private up(): void {
    if (this.hold_ === null) return;
    this.hold_ = null;
    const part = this.part_;
    this.part_ = null;
    if (part) this.actions_.setPart(part.from, part.to);
    this.actions_.endScrub();
  }

  private go(step: number): void {
    this.step_ = step;
    this.place();
    this.actions_.seek(step);
  }

  private trim(end: 'from' | 'to', step: number): void {
    const take = this.take_;
    if (!take) return;
    this.part_ = trimmed({ ...take, ...this.part }, end, step);
    this.place();
    this.actions_.seek(this.part_[end]);
  }

  private keyed(event: KeyboardEvent, hold: Hold): void {
    const take = this.take_;
    if (!take) return;
    const second = Math.max(1, Math.round(1 / take.stepTime));
    const by = event.shiftKey ? second : Math.max(1, Math.round(second / 30));
    const moves: Partial<Record<string, number>> = {
      ArrowLeft: -by,
      ArrowDown: -by,
      ArrowRight: by,
      ArrowUp: by,
      PageDown: -5 * second,
      PageUp: 5 * second,
      Home: -take.steps,
      End: take.steps,
    };
    const move = moves[event.key];
    if (move === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    const now = hold === 'head' ? this.step_ : this.part[hold];
    const step = Math.min(take.steps, Math.max(0, now + move));
    if (hold === 'head') return this.go(step);
    const part = trimmed(take, hold, step);
    this.actions_.setPart(part.from, part.to);
    this.actions_.seek(part[hold]);
  }

  drawMarks(): void {
    const take = this.take_;
    const { clientWidth: width, clientHeight: height } = this.root;
    if (!take || width === 0) return;
    const ratio = window.devicePixelRatio || 1;
    this.marks_.width = Math.round(width * ratio);
    this.marks_.height = Math.round(height * ratio);
    const context = this.marks_.getContext('2d');
    if (!context) return;
    context.scale(ratio, ratio);
    const style = getComputedStyle(this.root);
    const colour = (name: string): string => style.getPropertyValue(name).trim();
    const { from, to } = this.shown_;
    const x = (step: number): number => (width * (step - from)) / Math.max(1, to - from);
    context.font = `550 11px ${style.fontFamily}`;
    for (const piece of take.speeds) {
      const [left, right] = [x(piece.from / take.stepTime), x(piece.to / take.stepTime)];
      context.fillStyle = colour('--pressed');
      context.fillRect(left, 0, right - left, height);
      context.fillStyle = colour('--ink-2');
      if (right - left > 22) context.fillText(`${Number(piece.speed.toFixed(2))}×`, left + 4, 11);
    }
    context.fillStyle = colour('--ink');
    for (const step of this.keys_) {
      context.beginPath();
      for (const [dx, dy] of kDiamond) context.lineTo(x(step) + dx, kDiamondAt + dy);
      context.fill();
    }
    const touches = take.marks.filter((mark) => mark.kind === TakeMarkKind.Touch);
    const rows = rowsOf(touches);
    context.fillStyle = colour('--accent');
    touches.forEach((mark, i) => {
      const left = x(mark.step);
      context.beginPath();
      context.roundRect(left, height - 8 - 6 * rows[i]!, Math.max(3, x(mark.step + mark.length) - left), 4, 2);
      context.fill();
    });
    for (const mark of take.marks) {
      if (mark.kind === TakeMarkKind.Touch) continue;
      const event = mark.kind === TakeMarkKind.Event;
      context.fillStyle = colour(event ? '--ink-2' : '--warning');
      if (event) context.fillRect(x(mark.step) - 0.5, 4, 1, 7);
      else context.fillRect(x(mark.step) - 1.5, 3, 3, 9);
    }
  }
}
