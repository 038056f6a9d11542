// Some people of the open take whose path, time, clips and looks are changed: who is chosen, the pins under the hand, and
// what the server is told. Everybody else keeps everything.

import { insidePolygon, type GroundPoint, type ScreenPoint } from '../../../model/plane';
import {
  editedPoints,
  editOf,
  movedPin,
  ownTime,
  placeAt,
  runs,
  takeTime,
  withPart,
  withPin,
} from '../../../model/people_edit';
import type { StudioFrame } from '../../../model/studio_frame';
import { grabbed, timesBeside, wayOf, type TakeWay } from '../../../model/take_path';
import type { EditFinding, PeopleEdit, TakeEdits, TakePath } from '../../../protocol/messages';
import type { BuildStroke, BuildStrokes } from '../../../tools/build_pointer';
import { formatClock } from '../../../model/formatters';
import type { Members, PathParts } from './path_controller';
import type { PeoplePicture } from './people_layer';
import type { PeopleState } from './people_panel';

const kFinger = 26;
const kMouse = 14;
/** A tap chooses the nearest person within this [m]. */
const kTap = 1.2;
/** Between two messages while a pin is dragged [ms]. */
const kBetween = 200;
/** More people are not changed at once. */
const kMostChosen = 100;
/** The highest camera that somebody can look at [m]. */
const kHighest = 100;

type Held = { readonly pin: number; readonly from: GroundPoint; readonly offset: GroundPoint };

export class PeopleEditor implements BuildStrokes {
  private chosen_: readonly number[] = [];
  private readonly ways_ = new Map<number, TakeWay>();
  private known_: Omit<TakeEdits, 'type'> = { edits: [], findings: [], checked: false, clips: [] };
  private edit_: PeopleEdit = editOf([], []);
  private pin_ = -1;
  private held_: Held | null = null;
  /** Before the hand took hold of a pin. */
  private before_ = this.edit_;
  private wasChosen_ = false;
  private pans_: ScreenPoint | null = null;
  private lasso_: GroundPoint[] | null = null;
  private gesture_ = 0;
  private sentAt_ = 0;
  private several_ = false;
  private aims_: 'point' | 'person' | null = null;
  private stepTime_ = 1 / 60;
  private frame_: StudioFrame | null = null;

  constructor(
    private readonly parts_: PathParts,
    private readonly members_: Members,
    private readonly changed_: (state: PeopleState) => void,
  ) {
    parts_.client.on('takePath', (path) => this.came(path));
    parts_.client.on('notice', ({ code }) => code === 'EditPeople' && this.take());
    parts_.store.watch(['history'], () => this.say());
  }

  /** Another take is open, or none. */
  restart(stepTime: number): void {
    this.stepTime_ = stepTime;
    this.ways_.clear();
    this.choose([]);
  }

  setFrame(frame: StudioFrame): void {
    const moved = frame.step !== this.frame_?.step;
    this.frame_ = frame;
    if (moved) this.say();
  }

  /** The shown moment [s of the take]. */
  private get now(): number {
    return (this.frame_?.step ?? 0) * this.stepTime_;
  }

  // Who is chosen.

  choose(people: readonly number[]): void {
    this.chosen_ = [...people].sort((a, b) => a - b).slice(0, kMostChosen);
    this.pin_ = -1;
    this.held_ = null;
    this.aims_ = null;
    this.take();
    this.askNext();
  }

  setSeveral(several: boolean): void {
    this.several_ = several;
    this.say();
  }

  /** One path after the other: the server answers the last question only. */
  private askNext(): void {
    const next = this.chosen_.find((id) => !this.ways_.has(id));
    if (next !== undefined) this.parts_.client.send({ type: 'AskPath', group: 0, character: next });
  }

  private came({ character, spacing, points }: TakePath): void {
    if (!this.chosen_.includes(character)) return;
    this.ways_.set(character, wayOf(points, spacing, this.stepTime_));
    this.askNext();
    this.say();
  }

  // The edit.

  told(edits: TakeEdits): void {
    this.known_ = edits;
    if (this.held_) return this.say();
    this.take();
  }

  /** As the server has it. */
  private take(): void {
    this.edit_ = editOf(this.known_.edits, this.chosen_);
    if (this.pin_ >= this.edit_.pins.length) this.pin_ = -1;
    this.say();
  }

  /** Another edit of the chosen; `lasting` once the hand has lifted. */
  change(part: Partial<PeopleEdit>, lasting = true, clear = false): void {
    const edit = { ...this.edit_, ...part };
    if (!runs(edit.clock)) return this.say();
    this.edit_ = edit;
    this.say();
    const at = performance.now();
    if (this.chosen_.length === 0 || (!lasting && at - this.sentAt_ < kBetween)) return;
    this.sentAt_ = at;
    const gesture = this.held_ ? this.gesture_ : 0;
    this.parts_.client.send({ type: 'EditPeople', edit, gesture, kept: lasting, clear });
  }

  choosePin(pin: number): void {
    this.pin_ = pin;
    this.say();
  }

  /** A pin of the shown moment. */
  addPin(): void {
    const { pins, at } = withPin(this.edit_.pins, ownTime(this.edit_.clock, this.now), 2);
    this.pin_ = at;
    this.change({ pins });
  }

  removePin(): void {
    const pins = this.edit_.pins.filter((_, k) => k !== this.pin_);
    this.pin_ = -1;
    this.change({ pins });
  }

  playClip(name: string): void {
    const clips = withPart(this.edit_.clips, { name, from: 0, to: 0 }, this.now);
    if (clips) this.change({ clips });
  }

  /** The next tap tells at what they look. */
  aim(at: 'point' | 'person' | null): void {
    this.aims_ = at;
    this.say();
  }

  lookAtCamera(): void {
    const { targetX, targetY, distance, turn, pitch } = this.parts_.view.camera.pose;
    const away = distance * Math.cos(pitch);
    const height = Math.min(kHighest, distance * Math.sin(pitch));
    this.look({ person: 0, x: targetX + Math.sin(turn) * away, y: targetY - Math.cos(turn) * away, height });
  }

  private look(at: { person: number; x: number; y: number; height: number }): void {
    const looks = withPart(this.edit_.looks, { ...at, from: 0, to: 0 }, this.now);
    this.aims_ = null;
    if (looks) this.change({ looks });
    else this.say();
  }

  show({ from, x, y }: EditFinding): void {
    this.parts_.client.send({ type: 'Seek', step: Math.round(from / this.stepTime_) });
    const { camera } = this.parts_.view;
    camera.glideToPose({ ...camera.pose, targetX: x, targetY: y }, performance.now(), 400);
    this.parts_.view.wake();
  }

  undo(redo: boolean): void {
    this.parts_.client.send({ type: 'UndoEdit', redo });
  }

  private get findings(): EditFinding[] {
    return this.known_.findings.filter(({ person }) => this.chosen_.includes(person));
  }

  private say(): void {
    const { history } = this.parts_.store.state;
    this.changed_({
      chosen: this.chosen_,
      edit: this.edit_,
      pin: this.pin_,
      several: this.several_,
      aims: this.aims_,
      now: this.now,
      findings: this.findings,
      clips: this.known_.clips,
      others: this.known_.edits.flatMap(({ people }) => [...people]).filter((id) => !this.chosen_.includes(id)),
      read: this.chosen_.every((id) => this.ways_.has(id)),
      undo: history.undo > 0 ? history.undoLabel : '',
      redo: history.redo > 0 ? history.redoLabel : '',
    });
  }

  // What is drawn.

  picture(): PeoplePicture {
    const { pins, clock } = this.edit_;
    const frame = this.frame_;
    const paths = this.chosen_.flatMap((id) => {
      const way = this.ways_.get(id);
      if (!way) return [];
      const at = this.members_.ids.indexOf(id);
      const now = frame && at >= 0 && at < frame.x.length ? { x: frame.x[at]!, y: frame.y[at]! } : null;
      const shown = editedPoints(way, pins);
      const screen = shown.map((point) => this.parts_.view.worldToScreen(point));
      const times = timesBeside(way, screen, 64).map((k) => ({
        at: shown[k]!,
        text: formatClock(takeTime(clock, k * way.spacing * way.stepTime)),
      }));
      const handles = pins.flatMap(({ time }) => placeAt(way, pins, time) ?? []);
      return [{ recorded: pins.length > 0 ? way.points : null, shown, now, times, handles }];
    });
    return { paths, pin: this.pin_, troubles: this.findings, lasso: this.lasso_ };
  }

  // Strokes.

  private pinAt(at: ScreenPoint, px: number): number {
    let best = -1;
    let least = px;
    for (const id of this.chosen_) {
      const way = this.ways_.get(id);
      if (!way) continue;
      this.edit_.pins.forEach(({ time }, k) => {
        const place = placeAt(way, this.edit_.pins, time);
        if (!place) return;
        const { x, y } = this.parts_.view.worldToScreen(place);
        const away = Math.hypot(x - at.x, y - at.y) - (k === this.pin_ ? 4 : 0);
        if (away < least) [best, least] = [k, away];
      });
    }
    return best;
  }

  /** The own time of the point of a chosen path under the hand; -1 for none. */
  private timeAt(at: ScreenPoint, px: number): number {
    const toScreen = (point: GroundPoint): ScreenPoint => this.parts_.view.worldToScreen(point);
    for (const id of this.chosen_) {
      const way = this.ways_.get(id);
      if (!way) continue;
      const step = ownTime(this.edit_.clock, this.now) / way.stepTime;
      const k = grabbed({ ...way, points: editedPoints(way, this.edit_.pins) }, at, toScreen, px, step);
      if (k >= 0) return k * way.spacing * way.stepTime;
    }
    return -1;
  }

  begin({ screen, ground, touch, shift }: BuildStroke): void {
    this.pans_ = this.lasso_ = null;
    const px = touch ? kFinger : kMouse;
    const pin = this.aims_ ? -1 : this.pinAt(screen, px);
    const time = this.aims_ || pin >= 0 ? -1 : this.timeAt(screen, px);
    if (pin < 0 && time < 0) {
      if (shift || this.several_) this.lasso_ = [ground];
      else this.pans_ = screen;
      return;
    }
    ++this.gesture_;
    const made = pin >= 0 ? { pins: this.edit_.pins, at: pin } : withPin(this.edit_.pins, time, 2);
    const { x, y } = made.pins[made.at]!;
    this.held_ = { pin: made.at, from: ground, offset: { x, y } };
    this.before_ = this.edit_;
    this.edit_ = { ...this.edit_, pins: made.pins };
    this.wasChosen_ = pin >= 0 && pin === this.pin_;
    this.pin_ = made.at;
    this.say();
  }
  move({ screen, ground }: BuildStroke, still: boolean): void {
    const { held_: held } = this;
    if (held && !still) {
      const to = { x: held.offset.x + ground.x - held.from.x, y: held.offset.y + ground.y - held.from.y };
      return this.change({ pins: movedPin(this.edit_.pins, held.pin, to) }, false);
    }
    if (this.lasso_) this.lasso_ = [...this.lasso_, ground];
    else if (this.pans_) {
      this.parts_.view.camera.pan(this.pans_, screen);
      this.pans_ = screen;
      this.parts_.view.wake();
    }
  }

  end({ ground, shift }: BuildStroke, still: boolean): void {
    const { held_: held, lasso_: lasso } = this;
    this.pans_ = this.lasso_ = null;
    if (held) {
      if (still && this.wasChosen_) this.pin_ = -1;
      // A tap on a pin changes nothing.
      if (!still || this.edit_.pins.length !== this.before_.pins.length) this.change({});
      this.held_ = null;
      return this.say();
    }
    if (still) return this.tapped(ground, shift || this.several_);
    if (lasso) this.enclose(lasso);
  }

  cancel(): void {
    if (this.held_) this.edit_ = this.before_;
    if (this.held_ && this.edit_.pins.length > 0) this.change({});
    this.held_ = null;
    this.pans_ = this.lasso_ = null;
    this.take();
  }

  doubleTap(): void {
    // Means no more than a tap.
  }

  threeFingers(): void {
    this.undo(false);
  }

  private nearest(at: GroundPoint): number {
    const frame = this.frame_;
    let best = 0;
    let least = kTap;
    if (!frame) return best;
    for (let i = 0; i < frame.x.length; ++i) {
      const away = Math.hypot(frame.x[i]! - at.x, frame.y[i]! - at.y);
      if (away < least) [best, least] = [this.members_.ids[i] ?? 0, away];
    }
    return best;
  }

  private tapped(at: GroundPoint, adds: boolean): void {
    if (this.aims_ === 'point') return this.look({ person: 0, ...at, height: 1.6 });
    const id = this.nearest(at);
    if (this.aims_ === 'person') return id > 0 ? this.look({ person: id, x: 0, y: 0, height: 1.6 }) : undefined;
    if (id === 0) return;
    if (!adds) return this.choose([id]);
    const others = this.chosen_.filter((one) => one !== id);
    this.choose(others.length < this.chosen_.length ? others : [...this.chosen_, id]);
  }

  private enclose(lasso: readonly GroundPoint[]): void {
    const frame = this.frame_;
    if (!frame || lasso.length < 3) return;
    const inside = [...this.members_.ids].filter((_, i) =>
      insidePolygon({ x: frame.x[i] ?? Infinity, y: frame.y[i] ?? Infinity }, lasso),
    );
    if (inside.length > 0) this.choose([...new Set([...this.chosen_, ...inside])]);
  }
}
