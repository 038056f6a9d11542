// A body on the graphics card: one instanced draw call per level of detail.

import type { RigPoses } from './rig_poses';
import { type BufferGeometry, Group, InstancedBufferGeometry, type Material, Mesh, ShaderMaterial } from 'three';
import type { Body, BodyPart } from './bodies/body';
import { makeTinyBody } from './bodies/tiny_body';
import { type CrowdUniforms, type BodyUniforms, characterDepthMaterial, characterMaterial } from './character_material';
import { InstanceList } from '../drawing/instance_list';
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

  constructor(
    quality: Quality,
    people: CrowdUniforms,
    poses: RigPoses,
    readonly body: Body,
  ) {
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
