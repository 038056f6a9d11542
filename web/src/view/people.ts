// Everybody in the scene: one instanced draw call per body and level of detail, and one for the discs of shade.

import { Color, Group, InstancedBufferGeometry, Mesh, Vector3 } from 'three';
import { type Body, type BodyPart, trianglesOf } from '../people/body';
import { type ClipBank, type Moment } from '../people/clip_bank';
import type { NearPoses } from '../people/near_poses';
import { PoseTexture } from '../people/pose_texture';
import { type BodyUniforms, peopleDepthMaterial, peopleMaterial, type PeopleUniforms } from './people_material';
import { InstanceList } from './instance_list';
import type { Quality } from './quality';
import { kJoints } from '../people/skeleton';

/** The meshes of one level of a body. */
class Level {
  readonly meshes: Mesh<InstancedBufferGeometry>[];
  readonly list: InstanceList;

  constructor(quality: Quality, people: PeopleUniforms, body: BodyUniforms, parts: readonly BodyPart[], casts: boolean) {
    this.meshes = parts.map(({ geometry: source, map }) => {
      const geometry = new InstancedBufferGeometry();
      for (const [name, attribute] of Object.entries(source.attributes)) geometry.setAttribute(name, attribute);
      geometry.setIndex(source.index);
      const mesh = new Mesh(geometry, peopleMaterial(quality, people, body, map));
      mesh.customDepthMaterial = peopleDepthMaterial(people, body);
      mesh.castShadow = casts;
      mesh.frustumCulled = false;
      return mesh;
    });
    this.list = new InstanceList(this.meshes.map((mesh) => mesh.geometry));
  }

  end(): void {
    this.list.end();
    for (const mesh of this.meshes) mesh.visible = this.list.count > 0;
  }

  dispose(): void {
    for (const mesh of this.meshes) {
      mesh.geometry.dispose();
      (mesh.material as { dispose(): void }).dispose();
      mesh.customDepthMaterial?.dispose();
    }
  }
}

/** One body with its poses on the graphics card. */
export class DressedBody {
  readonly group = new Group();
  readonly near: Level;
  readonly far: Level;
  /** Triangles of one at each level. */
  readonly triangles: readonly [number, number];
  private readonly baked_ = new PoseTexture(1);
  private readonly whole_ = new PoseTexture(1);
  private readonly uniforms_: BodyUniforms;

  constructor(quality: Quality, people: PeopleUniforms, readonly body: Body) {
    const bind = Array.from({ length: kJoints }, (_, j) => new Vector3().fromArray(body.rig.bind, 3 * j));
    this.uniforms_ = { uBaked: { value: this.baked_.texture }, uNear: { value: this.whole_.texture }, uBind: { value: bind } };
    this.near = new Level(quality, people, this.uniforms_, body.near, quality === 'full');
    this.far = new Level(quality, people, this.uniforms_, body.far, false);
    this.triangles = [trianglesOf(body.near), trianglesOf(body.far)];
    this.group.add(...this.near.meshes, ...this.far.meshes);
  }

  bake(bank: ClipBank): void {
    this.baked_.reserve(bank.poseCount);
    bank.bake(this.body.rig, this.baked_.data);
    this.baked_.send();
    this.uniforms_.uBaked.value = this.baked_.texture;
  }

  /** Puts whole poses up. */
  pose(near: NearPoses): void {
    if (near.count === 0) return;
    this.whole_.reserve(near.count);
    near.solve(this.body.rig, this.whole_.data);
    this.whole_.send();
    this.uniforms_.uNear.value = this.whole_.texture;
  }

  begin(most: number): void {
    this.near.list.begin(most);
    this.far.list.begin(most);
  }

  end(): void {
    this.near.end();
    this.far.end();
  }

  dispose(): void {
    this.near.dispose();
    this.far.dispose();
    this.baked_.dispose();
    this.whole_.dispose();
  }
}

/** Writes what a character plays. */
export class PlayWriter {
  private readonly moment_: Moment = { first: 0, second: 0, mix: 0 };

  constructor(private readonly bank_: ClipBank) {}

  /** aNow and aBefore at `at`: the clip and the one before, and the slot of a whole pose or -1. */
  write(data: Float32Array, at: number, clip: number, time: number, before: number, beforeTime: number, fade: number, slot: number): void {
    const moment = this.moment_;
    this.bank_.moment(clip, time, moment);
    data[at] = moment.first;
    data[at + 1] = moment.second;
    data[at + 2] = moment.mix;
    data[at + 3] = fade;
    if (fade > 0) this.bank_.moment(before, beforeTime, moment);
    data[at + 4] = moment.first;
    data[at + 5] = moment.second;
    data[at + 6] = moment.mix;
    data[at + 7] = slot;
  }
}

/** Accents as the shader takes them. */
export function linear(hexes: readonly string[]): Float32Array {
  const out = new Float32Array(3 * hexes.length);
  hexes.forEach((hex, i) => new Color(hex).toArray(out, 3 * i));
  return out;
}
