// Draws the crowd: chooses body and level of detail of each character, and uploads what the shaders need.

import { Group } from 'three';
import { type Body, disposeBody } from './bodies/body';
import { type ClipPoses, ClipBank } from './clips/clip_bank';
import { NearPoses } from './clips/near_poses';
import { makePlainBody } from './bodies/plain_body';
import { type Rig, sameRig } from './bodies/rig';
import type { CameraController } from '../camera/camera_controller';
import { ContactDiscs } from './contact_discs';
import type { CrowdState } from './crowd_state';
import type { FrameBlend } from '../../model/frame_timeline';
import type { BodyBuildWord } from '../../protocol/generated/words';
import { CrowdTextures, linear } from './crowd_textures';
import { kFar, kHidden, kNear, LevelOfDetail } from './level_of_detail';
import { accentColour, type Palette } from '../drawing/palette';
import { bodyIndex } from './look';
import { DressedBody } from './dressed_body';
import { type CrowdUniforms, CharacterUniforms } from './character_material';
import type { Quality } from '../drawing/quality';
import { RigPoses } from './rig_poses';

/** Cloth that stands out from the ground. */
const kTrousers = { light: '#1C2128', dark: '#9AA3AD' };

/** Most whole poses that are shown at once. */
export const kNearMost = 256;

export interface DrawnPeople {
  readonly body: string;
  readonly near: number;
  readonly far: number;
  readonly tiny: number;
  readonly speck: number;
}

export class CrowdLayer {
  readonly group = new Group();
  private readonly uniforms_ = new CharacterUniforms();
  private readonly textures_ = new CrowdTextures();
  private readonly shaders_: CrowdUniforms = { characters: this.uniforms_, crowd: this.textures_.uniforms };
  private readonly discs_ = new ContactDiscs(this.textures_.uniforms);
  private readonly near_ = new NearPoses();
  private readonly levels_ = new LevelOfDetail();
  private bank_ = new ClipBank([]);
  private clips_: readonly ClipPoses[] = [];
  private ours_: readonly Body[] = [makePlainBody()];
  private own_: { readonly body: Body; readonly clips: readonly ClipPoses[] } | null = null;
  private dressed_: DressedBody[] = [];
  /** One per set of joints; bodies with the same joints share it. */
  private poses_: RigPoses[] = [];
  private accents_: Float32Array = new Float32Array(3);
  private chosen_ = -1;
  private builds_: readonly (BodyBuildWord | null)[] = [];
  /** Version of the members that were uploaded; -1 where they must be uploaded again. */
  private members_ = -1;
  /** Per clip, 1 where a visitor's own is played: whole poses are not of it. */
  private replaced_ = new Uint8Array(0);

  constructor(private readonly quality_: Quality) {
    this.group.add(this.discs_.mesh);
    this.dress();
  }

  /** What plays. */
  get bank(): ClipBank {
    return this.bank_;
  }

  /** Characters in the last picture by body: fine, coarse and tiny ones, and specks. */
  get drawn(): readonly DrawnPeople[] {
    return this.dressed_.map(({ body, near, far, tiny, speck }) => ({
      body: body.name,
      near: near.list.count,
      far: far.list.count,
      tiny: tiny.list.count,
      speck: speck.list.count,
    }));
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

  /** A visitor's body for everybody, with clips that replace ours; null brings our people back. */
  setOwn(body: Body | null, clips: readonly ClipPoses[] = []): void {
    const before = this.own_?.body;
    this.own_ = body ? { body, clips } : null;
    this.dress();
    if (before && before !== body) disposeBody(before);
  }

  /** Shows the soft shadows under people, or none. */
  setShadows(shown: boolean): void {
    this.discs_.shown = shown;
  }

  setPalette(palette: Palette, greyed: boolean, dark: boolean): void {
    this.uniforms_.uGreyed.value = greyed ? 1 : 0;
    this.uniforms_.uGreyTint.value.set(palette.grey);
    this.uniforms_.light(palette.sun, palette.sky);
    this.uniforms_.uTrousers.value.set(dark ? kTrousers.dark : kTrousers.light);
    this.discs_.strength = dark ? 0.5 : 0.3;
  }

  /** `colours`: accent index per group; `chosen`: id never greyed; `builds`: per group, null for both bodies. */
  setColours(
    colours: readonly number[],
    palette: Palette,
    chosen: number,
    builds: readonly (BodyBuildWord | null)[] = [],
  ): void {
    this.builds_ = builds;
    const shown = colours.length > 0 ? colours : [0];
    this.accents_ = linear(shown.map((colour) => accentColour(palette, colour)));
    this.chosen_ = chosen;
    this.members_ = -1;
  }

  /** Uploads the crowd at this moment. */
  update(state: CrowdState, blend: FrameBlend | null, camera: CameraController): void {
    for (const body of this.dressed_) body.begin(state.count);
    this.discs_.list.begin(state.count);
    if (blend) this.take(state, blend);
    if (blend) this.choose(state, blend, camera);
    for (const body of this.dressed_) body.end();
    this.discs_.end();
  }

  dispose(): void {
    this.undress();
    if (this.own_) disposeBody(this.own_.body);
    this.discs_.dispose();
    this.textures_.dispose();
  }

  /** Uploads members, frames and whole poses. */
  private take(state: CrowdState, blend: FrameBlend): void {
    if (this.members_ !== state.version) this.textures_.setMembers(state, this.accents_, this.chosen_);
    this.members_ = state.version;
    this.textures_.show(blend);
    if (this.quality_ !== 'full') return;
    this.near_.mix(blend.from, blend.to, blend.alpha, state.count, kNearMost);
    for (const poses of this.poses_) poses.pose(this.near_);
  }

  /** Lists the characters in view at their level of detail, by the positions of the newer frame. */
  private choose(state: CrowdState, { to }: FrameBlend, camera: CameraController): void {
    const {
      dressed_: dressed,
      levels_: levels,
      discs_: discs,
      near_: { slots },
    } = this;
    const full = this.quality_ === 'full';
    const count = Math.min(state.count, to.x.length);
    levels.begin(camera, count);
    this.uniforms_.uLens.value = levels.scale;
    for (let i = 0; i < count; ++i) {
      const level = levels.levelAt(i, to.x[i]!, to.y[i]!);
      if (level === kHidden) continue;
      const body = dressed[bodyIndex(this.builds_[state.group[i]!], state.body(i, dressed.length), dressed.length)]!;
      body
        .at(level === kNear && !full ? kFar : level)
        .list.add(i, full && this.replaced_[to.clip[i]!] !== 1 ? slots[i]! : -1);
      discs.list.add(i, -1);
    }
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
    this.dressed_ = bodies.map((body) => new DressedBody(this.quality_, this.shaders_, this.posesOf(body.rig), body));
    for (const body of this.dressed_) this.group.add(body.group);
    this.play();
  }

  private play(): void {
    this.bank_ = new ClipBank(this.clips_, this.own_?.clips ?? []);
    this.textures_.setClips(this.bank_);
    this.replaced_ = Uint8Array.from({ length: this.bank_.clipCount }, (_, clip) =>
      this.bank_.replaced(clip) ? 1 : 0,
    );
    for (const poses of this.poses_) poses.bake(this.bank_);
  }

  private posesOf(rig: Rig): RigPoses {
    let found = this.poses_.find((one) => sameRig(one.rig, rig));
    if (!found) this.poses_.push((found = new RigPoses(rig)));
    return found;
  }
}
