// Everybody in the scene: one instanced draw call per body and level of detail.

import { type BufferGeometry, Group, InstancedBufferGeometry, type Material, Mesh, ShaderMaterial, Vector3 } from 'three';
import type { Body, BodyPart } from '../people/body';
import { makeTinyBody } from '../people/tiny_body';
import type { ClipBank } from '../people/clip_bank';
import type { NearPoses } from '../people/near_poses';
import { PoseTexture } from '../people/pose_texture';
import type { Rig } from '../people/rig';
import { type AllPeople, type BodyUniforms, peopleDepthMaterial, peopleMaterial } from './people_material';
import { InstanceList } from './instance_list';
import type { Quality } from './quality';
import { kJoints } from '../people/skeleton';

function instancedMesh(source: BufferGeometry, material: Material): Mesh<InstancedBufferGeometry> {
  const geometry = new InstancedBufferGeometry();
  for (const [name, attribute] of Object.entries(source.attributes)) geometry.setAttribute(name, attribute);
  geometry.setIndex(source.index);
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false;
  return mesh;
}

/** Draws nothing: for what is only to throw shadows. */
function unseenMaterial(): ShaderMaterial {
  return new ShaderMaterial({
    vertexShader: 'void main() { gl_Position = vec4(2.0, 2.0, 2.0, 1.0); }', fragmentShader: 'void main() { discard; }',
    colorWrite: false, depthWrite: false,
  });
}

/** The meshes of one level of a body. */
class Level {
  readonly meshes: Mesh<InstancedBufferGeometry>[];
  readonly list: InstanceList;

  /** `shadows`: what throws shadows in place of the parts; far fewer triangles look the same there. */
  constructor(quality: Quality, people: AllPeople, body: BodyUniforms, parts: readonly BodyPart[], shadows: readonly BodyPart[]) {
    const seen = parts.map(({ geometry, map }) => instancedMesh(geometry, peopleMaterial(quality, people, body, map)));
    const thrown = shadows.map(({ geometry }) => instancedMesh(geometry, unseenMaterial()));
    for (const mesh of thrown) {
      mesh.customDepthMaterial = peopleDepthMaterial(people, body);
      mesh.castShadow = true;
    }
    this.meshes = [...seen, ...thrown];
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

/** The poses of all bodies that have the same joints. */
export class RigPoses {
  readonly uniforms: BodyUniforms;
  private readonly baked_ = new PoseTexture(1);
  private readonly whole_ = new PoseTexture(1);

  constructor(readonly rig: Rig) {
    const bind = Array.from({ length: kJoints }, (_, j) => new Vector3().fromArray(rig.bind, 3 * j));
    this.uniforms = { uBaked: { value: this.baked_.texture }, uNear: { value: this.whole_.texture }, uBind: { value: bind } };
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

/** One body on the graphics card. */
export class DressedBody {
  readonly group = new Group();
  readonly near: Level;
  readonly far: Level;
  /** A few tubes on the same joints: for those who are small on the screen. */
  readonly tiny: Level;

  constructor(quality: Quality, people: AllPeople, poses: RigPoses, readonly body: Body) {
    this.near = new Level(quality, people, poses.uniforms, body.near, quality === 'full' ? body.far : []);
    this.far = new Level(quality, people, poses.uniforms, body.far, []);
    this.tiny = new Level(quality, people, poses.uniforms, [{ geometry: makeTinyBody(body.rig), map: null }], []);
    this.group.add(...this.near.meshes, ...this.far.meshes, ...this.tiny.meshes);
  }

  begin(most: number): void {
    this.near.list.begin(most);
    this.far.list.begin(most);
    this.tiny.list.begin(most);
  }

  end(): void {
    this.near.end();
    this.far.end();
    this.tiny.end();
  }

  dispose(): void {
    this.near.dispose();
    this.far.dispose();
    this.tiny.dispose();
  }
}
