// Lines and areas that somebody has drawn to measure the crowd, and what they have measured while it walks.

import { EventKind, type EventFrame } from '../../protocol/messages';
import { isSameWorld, type SceneFacts } from '../../protocol/scene';
import type { GroundPoint } from '../plane';
import { AreaRecord } from './area_record';
import { LineRecord, crossingOf, type Crossing, type MeasureLine } from './crossing';
import { movesBetween, SpeedMemory, type CrowdMoment, type Leaver, type Move } from './crowd_steps';
import { EvacuationRecord, type PassedArea } from './evacuation_record';

/** Recent flows are those of so many seconds. */
export const kWindow = 10;
/** A replay that goes on by more has leapt [s]. */
const kLeap = 2;

interface Named {
  readonly id: number;
  readonly name: string;
  readonly hidden: boolean;
  /** World time from which it measures [s]. */
  readonly since: number;
}

export interface LineMeasure extends Named, MeasureLine {
  readonly kind: 'line';
  readonly record: LineRecord;
}

export interface AreaMeasure extends Named {
  readonly kind: 'area';
  readonly record: AreaRecord;
}

export type Measure = LineMeasure | AreaMeasure;

/** What measuring needs of a frame. `ids` are those of everybody, also where the frame does not repeat them. */
export interface MeasuredFrame extends CrowdMoment {
  readonly replaying: boolean;
  readonly events: readonly EventFrame[];
  readonly areas: readonly PassedArea[];
}

function leaversOf(events: readonly EventFrame[]): Leaver[] {
  return events
    .filter(({ kind }) => kind === EventKind.Exited)
    .map(({ subject, x, y }) => ({ id: subject, at: { x, y } }));
}

export class Measures {
  list: readonly Measure[] = [];
  readonly evacuation = new EvacuationRecord();
  /** The longest time between two frames that were measured [s]. */
  longestGap = 0;
  private readonly memory_ = new SpeedMemory();
  private last_: CrowdMoment | null = null;
  private scene_: SceneFacts | null = null;
  private began_ = 0;
  private made_ = { line: 0, area: 0 };
  private ids_ = 0;

  /** Time of the newest frame; 0 before the first [s]. */
  get time(): number {
    return this.last_?.time ?? 0;
  }

  /** From when on people are followed [s]. */
  get since(): number {
    return this.began_;
  }

  get scene(): SceneFacts | null {
    return this.scene_;
  }

  /** What was measured goes where another world begins, lines and areas where it is another place. */
  setScene(scene: SceneFacts): void {
    const before = this.scene_;
    this.scene_ = scene;
    if (before?.world === scene.world && before.name === scene.name) return;
    if (before && !isSameWorld(before, scene)) this.list = [];
    this.clear();
  }

  addLine(a: GroundPoint, b: GroundPoint): LineMeasure {
    this.made_.line += 1;
    const name = `Line ${this.made_.line}`;
    const made: LineMeasure = { kind: 'line', id: ++this.ids_, name, hidden: false, ...this.fresh(), a, b };
    this.list = [...this.list, made];
    return made;
  }

  addArea(polygon: readonly GroundPoint[]): AreaMeasure {
    this.made_.area += 1;
    const name = `Area ${this.made_.area}`;
    const record = new AreaRecord(polygon);
    const made: AreaMeasure = { kind: 'area', id: ++this.ids_, name, hidden: false, since: this.time, record };
    this.list = [...this.list, made];
    return made;
  }

  private fresh(): { readonly since: number; readonly record: LineRecord } {
    return { since: this.time, record: new LineRecord() };
  }

  remove(id: number): void {
    this.list = this.list.filter((one) => one.id !== id);
  }

  change(id: number, fields: Partial<Pick<Named, 'name' | 'hidden'>>): void {
    this.list = this.list.map((one) => (one.id === id ? { ...one, ...fields } : one));
  }

  /** Elsewhere it begins to measure anew. */
  moveLine(id: number, ends: MeasureLine): void {
    this.list = this.list.map((one) =>
      one.id === id && one.kind === 'line' ? { ...one, ...ends, ...this.fresh() } : one,
    );
  }

  moveArea(id: number, polygon: readonly GroundPoint[]): void {
    this.list = this.list.map((one) =>
      one.id === id && one.kind === 'area' ? { ...one, since: this.time, record: new AreaRecord(polygon) } : one,
    );
  }

  /** Forgets all that was measured. */
  clear(): void {
    this.last_ = null;
    this.began_ = 0;
    this.longestGap = 0;
    this.memory_.clear();
    this.evacuation.clear();
    this.list = this.list.map((one) =>
      one.kind === 'line'
        ? { ...one, since: 0, record: new LineRecord() }
        : { ...one, since: 0, record: new AreaRecord(one.record.polygon) },
    );
  }

  observe(frame: MeasuredFrame): void {
    const before = this.last_;
    const passed = before ? frame.time - before.time : 0;
    if (before && passed === 0) return;
    if (before && passed < 0) this.goBack(frame.time);
    else if (before && frame.replaying && passed > kLeap) this.clear();
    else if (before) this.follow(before, frame);
    if (!this.last_) this.begin(frame.time);
    const { time, ids, x, y } = frame;
    this.last_ = { time, ids, x, y };
    const isExit = (id: number): boolean =>
      this.scene_?.areas.some((area) => area.id === id && area.kind === 'exit') ?? false;
    this.evacuation.observe(time, x.length, frame.areas, isExit);
    if (!this.list.some(({ kind }) => kind === 'area')) return this.memory_.clear();
    this.memory_.add(this.last_);
    for (const one of this.list) if (one.kind === 'area') one.record.observe(this.memory_, this.ring);
  }

  private get ring(): number {
    return this.scene_?.ring ? this.scene_.box.max[0] - this.scene_.box.min[0] : 0;
  }

  private begin(time: number): void {
    this.began_ = time;
    this.list = this.list.map((one) => ({ ...one, since: time }));
  }

  /** Time was wound back: what came later has not happened. */
  private goBack(time: number): void {
    this.memory_.clear();
    this.evacuation.cut(time);
    for (const one of this.list) {
      if (one.kind === 'line') one.record.cut(time);
      else one.record.series.cut(time);
    }
    this.began_ = Math.min(this.began_, time);
    this.list = this.list.map((one) => ({ ...one, since: Math.min(one.since, time) }));
  }

  private follow(before: CrowdMoment, frame: MeasuredFrame): void {
    const seconds = frame.time - before.time;
    this.longestGap = Math.max(this.longestGap, seconds);
    const lines = this.list.filter((one) => one.kind === 'line');
    if (lines.length === 0) return;
    const moves = movesBetween(before, frame, leaversOf(frame.events), this.ring);
    for (const line of lines) line.record.add(crossingsBy(moves, line, before.time, seconds));
  }
}

function crossingsBy(moves: readonly Move[], line: MeasureLine, time: number, seconds: number): Crossing[] {
  const found: Crossing[] = [];
  for (const { id, from, to } of moves) {
    const crossing = crossingOf(line, from, to);
    if (!crossing) continue;
    found.push({ time: time + crossing.share * seconds, person: id, direction: crossing.direction });
  }
  return found;
}
