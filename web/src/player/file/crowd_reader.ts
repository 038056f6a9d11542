// The frames of a crowd (src/files/export/player/crowd_track.cpp writes them): who is there, where, and which clip they play.

import type { PlayedClip } from './figures_reader';
import type { PlayerHead } from './player_file';
import { BitModel, DamagedFile, NumberModel, RangeDecoder } from './range_decoder';

const kPositionUnit = 0.005;
const kTurn = 512;
const kThingTurn = 4096;
const kFadeSteps = 15;
/** A clip before fades out within this time [s]. */
export const kFadeTime = 0.2;
/** Work between two breaths of the page [samples]. */
const kBreath = 40000;

/** A character. */
export interface Person {
  readonly id: number;
  /** 0 broad, 1 narrow. */
  readonly body: number;
  /** How much larger than others it is drawn. */
  readonly scale: number;
}

/** All frames. A sample is one character in one frame; those of frame k are first[k] to first[k + 1], by ascending id. */
export interface Crowd {
  readonly people: readonly Person[];
  readonly first: Uint32Array;
  /** Per sample: index of the character, and its sample in the frame before, or -1. */
  readonly who: Uint32Array;
  readonly before: Int32Array;
  /** [m] */
  readonly x: Float32Array;
  readonly y: Float32Array;
  /** [rad] */
  readonly yaw: Float32Array;
  readonly colour: Uint16Array;
  /** The clip, its time, and how far that went on since the frame before, in units of clip time. */
  readonly clip: Uint16Array;
  readonly time: Int32Array;
  readonly advance: Int32Array;
  /** 1 where the character has switched to another clip since the frame before; then `fade` tells when. */
  readonly switched: Uint8Array;
  readonly fade: Float32Array;
  readonly fromClip: Uint16Array;
  readonly fromTime: Float32Array;
  /** Of moving things: x, y, angle, for each thing in each frame. */
  readonly things: Float32Array;
}

interface Member {
  readonly id: number;
  readonly who: number;
  x: number;
  y: number;
  yaw: number;
  stepX: number;
  stepY: number;
  turn: number;
  clip: number;
  time: number;
  advance: number;
  colour: number;
  stir: number;
  turned: number;
  paced: number;
  switched: number;
  fade: number;
  fromClip: number;
  fromTime: number;
  /** Its latest sample, and whether it came with this frame. */
  sample: number;
  fresh: boolean;
}

/** Reads all frames; lets the page breathe meanwhile. `wait` resolves soon. */
export async function readCrowd(
  bytes: Uint8Array,
  head: PlayerHead,
  clips: readonly PlayedClip[],
  wait: () => Promise<void> = () => new Promise((done) => setTimeout(done, 0)),
): Promise<Crowd> {
  const reader = new CrowdReader(bytes, head, clips);
  let breath = kBreath;
  for (let k = 0; k < head.frames; ++k) {
    reader.frame(k);
    if (reader.samples < breath) continue;
    breath = reader.samples + kBreath;
    await wait();
  }
  return reader.finish();
}

function models(count: number): NumberModel[] {
  return Array.from({ length: count }, () => new NumberModel());
}

function wrapped(value: number, turn: number): number {
  const half = Math.floor(turn / 2);
  return value - turn * Math.floor((value + half) / turn);
}

class CrowdReader {
  samples = 0;
  private readonly coder_: RangeDecoder;
  private readonly crowd_: Crowd;
  private readonly people_: Person[] = [];
  private members_: Member[] = [];
  private readonly lastPlace_ = [0, 0];
  private readonly things_: Int32Array;
  private readonly changed_ = new BitModel();
  private readonly recoloured_ = new BitModel();
  private readonly body_ = new BitModel();
  private readonly switched_ = [new BitModel(), new BitModel()];
  private readonly gone_ = new NumberModel();
  private readonly came_ = new NumberModel();
  private readonly ids_ = new NumberModel();
  private readonly scale_ = new NumberModel();
  private readonly colour_ = new NumberModel();
  private readonly place_ = new NumberModel();
  private readonly heading_ = new NumberModel();
  private readonly clip_ = new NumberModel();
  private readonly clipTime_ = new NumberModel();
  private readonly fade_ = new NumberModel();
  private readonly phase_ = new NumberModel();
  private readonly step_ = models(3);
  private readonly turn_ = models(2);
  private readonly pace_ = models(2);
  private readonly nextClip_ = new Map<number, NumberModel>();
  private readonly thingPlace_ = new NumberModel();
  private readonly thingAngle_ = new NumberModel();
  private readonly fadePerFrame_: number;

  constructor(
    bytes: Uint8Array,
    private readonly head_: PlayerHead,
    private readonly clips_: readonly PlayedClip[],
  ) {
    this.coder_ = new RangeDecoder(bytes);
    this.fadePerFrame_ = 1 / (head_.fps * kFadeTime);
    this.things_ = new Int32Array(6 * head_.things);
    const count = head_.samples;
    this.crowd_ = {
      people: this.people_,
      first: new Uint32Array(head_.frames + 1),
      who: new Uint32Array(count),
      before: new Int32Array(count),
      x: new Float32Array(count),
      y: new Float32Array(count),
      yaw: new Float32Array(count),
      colour: new Uint16Array(count),
      clip: new Uint16Array(count),
      time: new Int32Array(count),
      advance: new Int32Array(count),
      switched: new Uint8Array(count),
      fade: new Float32Array(count),
      fromClip: new Uint16Array(count),
      fromTime: new Float32Array(count),
      things: new Float32Array(3 * head_.things * head_.frames),
    };
  }

  frame(k: number): void {
    for (const member of this.members_) member.fresh = false;
    if (this.coder_.bit(this.changed_)) this.changeMembers();
    for (const member of this.members_) if (!member.fresh) this.move(member);
    if (this.samples + this.members_.length > this.head_.samples)
      throw new DamagedFile('found more characters than told');
    for (const member of this.members_) this.store(member);
    this.crowd_.first[k + 1] = this.samples;
    for (let t = 0; t < this.head_.things; ++t) this.thing(k, t);
    this.coder_.check();
  }

  finish(): Crowd {
    if (this.samples !== this.head_.samples)
      throw new DamagedFile(`found ${this.samples} positions, expected ${this.head_.samples}`);
    return this.crowd_;
  }

  private changeMembers(): void {
    const coder = this.coder_;
    const gone = coder.count(this.gone_, this.members_.length, 'characters who leave');
    const leaving = new Set<number>();
    let last = 0;
    for (let k = 0; k < gone; ++k) {
      last += coder.count(this.gone_, this.members_.length - 1 - last, 'characters who leave');
      leaving.add(last);
    }
    this.members_ = this.members_.filter((_, i) => !leaving.has(i));
    const came = coder.count(this.came_, this.head_.most - this.members_.length, 'characters who come');
    let id = 0;
    for (let k = 0; k < came; ++k) {
      id += coder.natural(this.ids_);
      this.members_.push(this.come(id));
    }
    this.members_.sort((a, b) => a.id - b.id);
  }

  private come(id: number): Member {
    const coder = this.coder_;
    const body = coder.bit(this.body_) ? 1 : 0;
    const scale = 1 + coder.whole(this.scale_) / 100;
    if (!(scale >= 0.1 && scale <= 10)) throw new DamagedFile(`found size ${scale}, expected 0.1 to 10`);
    const who = this.people_.push({ id, body, scale }) - 1;
    const colour = this.readColour();
    const x = this.lastPlace_[0]! + coder.whole(this.place_);
    const y = this.lastPlace_[1]! + coder.whole(this.place_);
    this.lastPlace_.splice(0, 2, x, y);
    const yaw = coder.whole(this.heading_);
    const clip = coder.count(this.clip_, this.clips_.length - 1, 'clip');
    const time = coder.count(this.clipTime_, this.clips_[clip]!.duration, 'time of a clip');
    const still = { stepX: 0, stepY: 0, turn: 0, advance: 0, stir: 0, turned: 0, paced: 0, switched: 0, fade: 0 };
    const playing = { clip, time, fromClip: clip, fromTime: time };
    return { id, who, x, y, yaw, colour, ...still, ...playing, sample: -1, fresh: true };
  }

  private readColour(): number {
    return this.coder_.count(this.colour_, this.head_.colours.length - 1, 'colour');
  }

  private move(member: Member): void {
    const coder = this.coder_;
    const byX = coder.whole(this.step_[member.stir]!);
    const byY = coder.whole(this.step_[member.stir]!);
    const stir = Math.abs(byX) + Math.abs(byY);
    member.stir = stir === 0 ? 0 : stir < 3 ? 1 : 2;
    member.stepX += byX;
    member.stepY += byY;
    member.x += member.stepX;
    member.y += member.stepY;
    const by = coder.whole(this.turn_[member.turned]!);
    member.turned = by === 0 ? 0 : 1;
    member.turn += by;
    member.yaw += member.turn;
    if (!(Math.abs(member.x) + Math.abs(member.y) + Math.abs(member.yaw) < 1e9))
      throw new DamagedFile('found no place');
    if (coder.bit(this.recoloured_)) member.colour = this.readColour();
    this.play(member);
  }

  private play(member: Member): void {
    const coder = this.coder_;
    const switched = coder.bit(this.switched_[member.switched]!);
    member.switched = switched ? 1 : 0;
    const before = this.clips_[member.clip]!;
    if (switched) {
      this.change(member, before);
    } else {
      const by = coder.whole(this.pace_[member.paced]!);
      member.paced = by === 0 ? 0 : 1;
      member.advance += by;
      member.time = timeIn(before, member.time + member.advance);
      member.fade = Math.max(0, member.fade - this.fadePerFrame_);
      member.fromTime = timeIn(this.clips_[member.fromClip]!, member.fromTime + member.advance);
    }
  }

  private change(member: Member, before: PlayedClip): void {
    const coder = this.coder_;
    let next = this.nextClip_.get(member.clip);
    if (!next) this.nextClip_.set(member.clip, (next = new NumberModel()));
    const clip = coder.count(next, this.clips_.length - 1, 'clip');
    const now = this.clips_[clip]!;
    const fade = coder.count(this.fade_, kFadeSteps, 'fade') / kFadeSteps;
    const same = Math.floor((member.time * now.duration) / before.duration);
    const turn = now.duration + 1;
    const time = same + coder.whole(this.phase_);
    member.fromClip = member.clip;
    member.fromTime = timeIn(before, member.time + member.advance);
    member.clip = clip;
    member.time = ((time % turn) + turn) % turn;
    member.fade = fade;
  }

  private store(member: Member): void {
    const crowd = this.crowd_;
    const at = this.samples++;
    crowd.who[at] = member.who;
    crowd.before[at] = member.sample;
    member.sample = at;
    crowd.x[at] = kPositionUnit * member.x;
    crowd.y[at] = kPositionUnit * member.y;
    crowd.yaw[at] = (2 * Math.PI * wrapped(member.yaw, kTurn)) / kTurn;
    crowd.colour[at] = member.colour;
    crowd.clip[at] = member.clip;
    crowd.time[at] = member.time;
    crowd.advance[at] = member.advance;
    crowd.switched[at] = member.fresh ? 0 : member.switched;
    crowd.fade[at] = member.fade;
    crowd.fromClip[at] = member.fromClip;
    crowd.fromTime[at] = member.fromTime;
  }

  private thing(k: number, t: number): void {
    for (let part = 0; part < 3; ++part) {
      const at = 6 * t + 2 * part;
      const by = this.coder_.whole(part < 2 ? this.thingPlace_ : this.thingAngle_);
      const now = this.things_[at]! + (k === 0 ? 0 : this.things_[at + 1]!) + by;
      this.things_[at + 1] = k === 0 ? 0 : now - this.things_[at]!;
      this.things_[at] = now;
      const unit = part < 2 ? kPositionUnit : (2 * Math.PI) / kThingTurn;
      this.crowd_.things[3 * (this.head_.things * k + t) + part] = unit * now;
    }
  }
}

/** A time within a clip. */
export function timeIn(clip: PlayedClip, time: number): number {
  if (!clip.cyclic) return Math.min(clip.duration, Math.max(0, time));
  return time - clip.duration * Math.floor(time / clip.duration);
}
