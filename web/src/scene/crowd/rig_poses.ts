// The poses of all bodies that have the same joints, on the graphics card.

import { Vector3 } from 'three';
import { kJoints } from '../../model/skeleton';
import type { Rig } from './bodies/rig';
import type { BodyUniforms } from './character_material';
import type { ClipBank } from './clips/clip_bank';
import type { NearPoses } from './clips/near_poses';
import { PoseTexture } from './clips/pose_texture';

export class RigPoses {
  readonly uniforms: BodyUniforms;
  private readonly baked_ = new PoseTexture(1);
  private readonly whole_ = new PoseTexture(1);

  constructor(readonly rig: Rig) {
    const bind = Array.from({ length: kJoints }, (_, j) => new Vector3().fromArray(rig.bind, 3 * j));
    this.uniforms = {
      uBaked: { value: this.baked_.texture },
      uNear: { value: this.whole_.texture },
      uBind: { value: bind },
    };
  }

  bake(bank: ClipBank): void {
    this.baked_.reserve(bank.poseCount);
    bank.bake(this.rig, this.baked_.data);
    this.baked_.send();
    this.uniforms.uBaked.value = this.baked_.texture;
  }

  /** Puts whole poses up. */
  pose(near: NearPoses): void {
    if (near.count === 0) return;
    this.whole_.reserve(near.count);
    near.solve(this.rig, this.whole_.data);
    this.whole_.send();
    this.uniforms.uNear.value = this.whole_.texture;
  }

  dispose(): void {
    this.baked_.dispose();
    this.whole_.dispose();
  }
}
