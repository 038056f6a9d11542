// The crowd as drawn: picks body and level for everybody, and tells the graphics card what each one plays.

import { Group } from 'three';
import { type Body, disposeBody } from '../people/body';
import { type ClipPoses, ClipBank } from '../people/clip_bank';
import { NearPoses } from '../people/near_poses';
import { makePlainBody } from '../people/plain_body';
import { type Rig, sameRig } from '../people/rig';
import type { CameraController } from './camera_controller';
import { ContactDiscs } from './contact_discs';
import type { CrowdState } from './crowd_state';
import type { FrameBlend } from './frame_timeline';
import { kHidden, kNear, LevelOfDetail } from './level_of_detail';
import { accentOf, type Palette } from './palette';
import { DressedBody, linear, PlayWriter, RigPoses } from './people';
import { PeopleUniforms } from './people_material';
import { kChosen } from './people_shader';
import type { Quality } from './quality';

/** Most whole poses that are shown at once. */
export const kNearMost = 256;

/** Long and dark is the disc of shade by what one does: standing unless listed. */
const kShades: Readonly<Record<string, readonly [long: number, shade: number]>> = {
  crawl: [2, 1], swim: [1, 0], climb: [1, 0.5], jump: [1, 0.6], duck: [1.25, 1],
};
const kStanding = [1, 1] as const;

export class CrowdLayer {
  readonly group = new Group();
  private readonly uniforms_ = new PeopleUniforms();
  private readonly discs_ = new ContactDiscs();
  private readonly near_ = new NearPoses();
  private readonly levels_ = new LevelOfDetail();
  private bank_ = new ClipBank([]);
  private writer_ = new PlayWriter(this.bank_);
  private clips_: readonly ClipPoses[] = [];
  private ours_: readonly Body[] = [makePlainBody()];
  private own_: { readonly body: Body; readonly clips: readonly ClipPoses[] } | null = null;
  private dressed_: DressedBody[] = [];
  /** One for all bodies with the same joints. */
  private poses_: RigPoses[] = [];
  private shades_: (readonly [number, number])[] = [];
  private accents_: Float32Array = new Float32Array(3);
  private groups_ = 1;
  private chosen_ = -1;

  constructor(private readonly quality_: Quality) {
    this.group.add(this.discs_.mesh);
    this.dress();
  }

  /** What plays; lengths of clips for those who mix times. */
  get bank(): ClipBank {
    return this.bank_;
  }

  /** Characters in the last picture by body: fine and far. */
  get drawn(): { readonly body: string; readonly near: number; readonly far: number }[] {
    return this.dressed_.map(({ body, near, far }) => ({ body: body.name, near: near.list.count, far: far.list.count }));
  }

  setMotions(clips: readonly ClipPoses[]): void {
    this.clips_ = clips;
    this.play();
  }

  /** Muster's own people. */
  setBodies(bodies: readonly Body[]): void {
    if (bodies.length > 0) this.ours_ = bodies;
    if (!this.own_) this.dress();
  }

  /** A visitor's body for everybody, with clips that take the place of ours; null brings our people back. */
  setOwn(body: Body | null, clips: readonly ClipPoses[] = []): void {
    const before = this.own_?.body;
    this.own_ = body ? { body, clips } : null;
    this.dress();
    if (before && before !== body) disposeBody(before);
  }

  setPalette(palette: Palette, greyed: boolean, dark: boolean): void {
    this.uniforms_.uGreyed.value = greyed ? 1 : 0;
    this.uniforms_.uGreyTint.value.set(palette.grey);
    this.uniforms_.light(palette.sun, palette.sky);
    this.uniforms_.uTrousers.value = dark ? 2.6 : 1;
    this.discs_.strength = dark ? 0.5 : 0.3;
  }

  /** `colours`: accent index per group; `chosen`: id never greyed. */
  setColours(colours: readonly number[], palette: Palette, chosen: number): void {
    const shown = colours.length > 0 ? colours : [0];
    this.accents_ = linear(shown.map((colour) => accentOf(palette, colour)));
    this.groups_ = shown.length;
    this.chosen_ = chosen;
  }

  /** Sends everybody as they are now. */
  update(state: CrowdState, blend: FrameBlend | null, camera: CameraController): void {
    const whole = this.quality_ === 'full' && blend !== null;
    if (whole) this.near_.mix(blend.from, blend.to, blend.alpha, state.count, kNearMost);
    if (whole) for (const poses of this.poses_) poses.pose(this.near_);
    for (const body of this.dressed_) body.begin(state.count);
    this.discs_.begin(state.count);
    this.levels_.begin(camera);
    for (let i = 0; i < state.count; ++i) this.add(state, i, whole);
    for (const body of this.dressed_) body.end();
    this.discs_.end();
  }

  dispose(): void {
    this.undress();
    if (this.own_) disposeBody(this.own_.body);
    this.discs_.dispose();
  }

  private add(state: CrowdState, i: number, whole: boolean): void {
    const p = state.placement;
    const x = p[4 * i]!, y = p[4 * i + 1]!, heading = p[4 * i + 2]!, size = p[4 * i + 3]!;
    const level = this.levels_.levelAt(x, y);
    if (level === kHidden) return;
    const dressed = this.dressed_[state.body(i, this.dressed_.length)]!;
    const fine = level === kNear && this.quality_ === 'full';
    const { list } = fine ? dressed.near : dressed.far;
    const at = list.next();
    const { data } = list;
    data[at] = x;
    data[at + 1] = y;
    data[at + 2] = heading;
    data[at + 3] = size;
    const clip = state.clip[i]!;
    const fade = state.fade[i]!;
    const slot = whole && !this.bank_.replaced(clip) ? this.near_.slots[i] ?? -1 : -1;
    this.writer_.write(data, at + 4, clip, state.time[i]!, state.before[i]!, state.beforeTime[i]!, fade, slot);
    const accent = 3 * Math.min(state.group[i]!, this.groups_ - 1);
    for (let k = 0; k < 3; ++k) data[at + 12 + k] = this.accents_[accent + k]!;
    data[at + 15] = state.look[i]! + (state.ids[i] === this.chosen_ ? kChosen : 0);
    const now = this.shades_[clip] ?? kStanding;
    const before = this.shades_[state.before[i]!] ?? kStanding;
    this.discs_.add(x, y, heading, size, now[0] + (before[0] - now[0]) * fade, now[1] + (before[1] - now[1]) * fade);
  }

  private undress(): void {
    for (const one of [...this.dressed_, ...this.poses_]) one.dispose();
    this.group.clear();
    this.poses_ = [];
  }

  private dress(): void {
    this.undress();
    this.group.add(this.discs_.mesh);
    const bodies = this.own_ ? [this.own_.body] : this.ours_;
    this.dressed_ = bodies.map((body) => new DressedBody(this.quality_, this.uniforms_, this.posesOf(body.rig), body));
    for (const body of this.dressed_) this.group.add(body.group);
    this.play();
  }

  private play(): void {
    this.bank_ = new ClipBank(this.clips_, this.own_?.clips ?? []);
    this.writer_ = new PlayWriter(this.bank_);
    this.shades_ = Array.from({ length: this.bank_.clipCount }, (_, clip) => kShades[this.bank_.motion(clip)] ?? kStanding);
    for (const poses of this.poses_) poses.bake(this.bank_);
  }

  private posesOf(rig: Rig): RigPoses {
    let found = this.poses_.find((one) => sameRig(one.rig, rig));
    if (!found) this.poses_.push((found = new RigPoses(rig)));
    return found;
  }
}
