// A body on the graphics card: one instanced draw call per level of detail.

import type { RigPoses } from './rig_poses';
import { type BufferGeometry, Group, InstancedBufferGeometry, type Material, Mesh, ShaderMaterial } from 'three';
import type { Body, BodyPart } from './bodies/body';
import { makeSpeckBody, makeTinyBody } from './bodies/tiny_body';
import { type CrowdUniforms, type BodyUniforms, characterDepthMaterial, characterMaterial } from './character_material';
import { InstanceList } from '../drawing/instance_list';
import { kFar, kNear, kTiny } from './level_of_detail';
import type { Quality } from '../drawing/quality';

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
    vertexShader: 'void main() { gl_Position = vec4(2.0, 2.0, 2.0, 1.0); }',
    fragmentShader: 'void main() { discard; }',
    colorWrite: false,
    depthWrite: false,
  });
}

/** The meshes of one level of a body. */
class Level {
  readonly meshes: Mesh<InstancedBufferGeometry>[];
  readonly list: InstanceList;

  /** `shadows`: what throws shadows in place of the parts; far fewer triangles look the same there. */
  constructor(
    quality: Quality,
    people: CrowdUniforms,
    body: BodyUniforms,
    parts: readonly BodyPart[],
    shadows: readonly BodyPart[],
  ) {
    const seen = parts.map(({ geometry, map }) =>
      instancedMesh(geometry, characterMaterial(quality, people, body, map)),
    );
    const thrown = shadows.map(({ geometry }) => instancedMesh(geometry, unseenMaterial()));
    for (const mesh of thrown) {
      mesh.customDepthMaterial = characterDepthMaterial(people, body);
      mesh.castShadow = true;
      // In the picture itself not one of them is drawn.
      mesh.onBeforeShadow = (): void => void (mesh.geometry.instanceCount = this.list.count);
      mesh.onBeforeRender = (): void => void (mesh.geometry.instanceCount = 0);
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

/** One body on the graphics card. */
export class DressedBody {
  readonly group = new Group();
  readonly near: Level;
  readonly far: Level;
  /** A few tubes on the same joints, for characters that are small on the screen. */
  readonly tiny: Level;
  /** Fewer still, for those that are smaller. */
  readonly speck: Level;

  constructor(
    quality: Quality,
    people: CrowdUniforms,
    poses: RigPoses,
    readonly body: Body,
  ) {
    this.near = new Level(quality, people, poses.uniforms, body.near, quality === 'full' ? body.far : []);
    this.far = new Level(quality, people, poses.uniforms, body.far, []);
    this.tiny = new Level(quality, people, poses.uniforms, [{ geometry: makeTinyBody(body.rig), map: null }], []);
    this.speck = new Level(quality, people, poses.uniforms, [{ geometry: makeSpeckBody(body.rig), map: null }], []);
    for (const level of this.levels()) this.group.add(...level.meshes);
  }

  /** What draws it at that level of detail. */
  at(level: number): Level {
    if (level === kNear) return this.near;
    if (level === kFar) return this.far;
    return level === kTiny ? this.tiny : this.speck;
  }

  begin(most: number): void {
    for (const level of this.levels()) level.list.begin(most);
  }

  end(): void {
    for (const level of this.levels()) level.end();
  }

  dispose(): void {
    for (const level of this.levels()) level.dispose();
  }

  private levels(): readonly Level[] {
    return [this.near, this.far, this.tiny, this.speck];
  }
}
