// The crowd as textures: the two frames shown, the look of each character, and where the poses of each clip begin. Each
// frame is uploaded once; between frames only the share of the newer one changes.

import { Color, DataTexture, FloatType, NearestFilter, RGBAFormat } from 'three';
import { kRowFloats, kRowsAcross, rowsLength } from '../../model/studio_frame';
import type { ClipBank } from './clips/clip_bank';
import type { CrowdState } from './crowd_state';
import type { FrameBlend } from '../../model/frame_timeline';
import type { FrameView } from '../../model/frame_view';

/** Texels of a line of rows: two for each character. */
const kWidth = (kRowsAcross * kRowFloats) / 4;
/** Frame textures: the two shown and the next one. */
const kFrames = 3;
/** Added to the look of the character that keeps its colours while the others are grey. */
export const kChosen = 100;

/** Length and darkness of the contact disc by motion; as for standing where a motion is not listed. */
const kShades: Readonly<Record<string, readonly [long: number, shade: number]>> = {
  crawl: [2, 1],
  swim: [1, 0],
  climb: [1, 0.5],
  jump: [1, 0.6],
  duck: [1.25, 1],
};
const kStanding = [1, 1] as const;

function floatTexture(data: Float32Array, width: number): DataTexture {
  const texture = new DataTexture(data, width, data.length / (4 * width), RGBAFormat, FloatType);
  texture.minFilter = texture.magFilter = NearestFilter;
  texture.needsUpdate = true;
  return texture;
}

/** The rows of one frame. */
class FrameTexture {
  texture = floatTexture(new Float32Array(rowsLength(0)), kWidth);
  frame: FrameView | null = null;
  /** Number of the picture that showed it last. */
  used = 0;

  take(frame: FrameView): void {
    this.frame = frame;
    const old = this.texture.image as { data: Float32Array };
    if (old.data.length === frame.rows.length) {
      old.data = frame.rows;
      this.texture.needsUpdate = true;
      return;
    }
    this.texture.dispose();
    this.texture = floatTexture(frame.rows, kWidth);
  }
}

export class CrowdTextures {
  private readonly frames_ = Array.from({ length: kFrames }, () => new FrameTexture());
  private members_ = floatTexture(new Float32Array(rowsLength(0)), kWidth);
  private clips_ = floatTexture(new Float32Array(8), 2);
  readonly uniforms = {
    uFrom: { value: this.frames_[0]!.texture },
    uTo: { value: this.frames_[1]!.texture },
    uAlpha: { value: 0 },
    uMembers: { value: this.members_ },
    uClips: { value: this.clips_ },
  };
  private shown_ = 0;

  /** Shows this moment and uploads the frames that are new. */
  show({ from, to, alpha }: FrameBlend): void {
    this.shown_ += 1;
    const same = from.rows.length === to.rows.length && from.x.length === to.x.length;
    this.uniforms.uTo.value = this.up(to);
    this.uniforms.uFrom.value = same ? this.up(from) : this.uniforms.uTo.value;
    this.uniforms.uAlpha.value = same ? alpha : 1;
  }

  /** Shirts, skins, sizes, classes and radii; `accents` by group, three numbers each; `chosen`: id never greyed. */
  setMembers(state: CrowdState, accents: Float32Array, chosen: number): void {
    const data = new Float32Array(rowsLength(state.count));
    const groups = Math.max(1, accents.length / 3);
    for (let i = 0, at = 0; i < state.count; ++i, at += kRowFloats) {
      const accent = 3 * Math.min(state.group[i]!, groups - 1);
      for (let k = 0; k < 3; ++k) data[at + k] = accents[accent + k]!;
      data[at + 3] = state.look[i]! + (state.ids[i] === chosen ? kChosen : 0);
      data[at + 4] = state.size[i]! * state.scale[i]!;
      data[at + 5] = state.unitClass[i]!;
      data[at + 6] = state.radius[i]!;
    }
    this.members_.dispose();
    this.uniforms.uMembers.value = this.members_ = floatTexture(data, kWidth);
  }

  /** Two texels per clip: first pose, poses, 1 where cyclic; how long and dark the disc of shade is. */
  setClips(bank: ClipBank): void {
    const data = new Float32Array(8 * bank.clipCount);
    for (let clip = 0; clip < bank.clipCount; ++clip) {
      const { first, poses, cyclic } = bank.span(clip);
      const [long, shade] = kShades[bank.motion(clip)] ?? kStanding;
      data.set([first, poses, cyclic ? 1 : 0, 0, long, shade, 0, 0], 8 * clip);
    }
    this.clips_.dispose();
    this.uniforms.uClips.value = this.clips_ = floatTexture(data, 2);
  }

  dispose(): void {
    for (const texture of [this.members_, this.clips_, ...this.frames_.map((one) => one.texture)]) texture.dispose();
  }

  private up(frame: FrameView): DataTexture {
    let found = this.frames_.find((one) => one.frame === frame);
    if (!found) {
      found = this.frames_.reduce((a, b) => (b.used < a.used ? b : a));
      found.take(frame);
    }
    found.used = this.shown_;
    return found.texture;
  }
}

/** Accents as the shader takes them. */
export function linear(hexes: readonly string[]): Float32Array {
  const out = new Float32Array(3 * hexes.length);
  hexes.forEach((hex, i) => new Color(hex).toArray(out, 3 * i));
  return out;
}
