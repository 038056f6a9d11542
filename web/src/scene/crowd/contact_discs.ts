// Contact discs: a soft shadow under each character, in one draw call.

import { BufferAttribute, InstancedBufferGeometry, Mesh, ShaderMaterial } from 'three';
import type { CrowdTextures } from './crowd_textures';
import { InstanceList } from '../drawing/instance_list';
import { kCharacterNow } from './character_shader';

export class ContactDiscs {
  readonly mesh: Mesh<InstancedBufferGeometry, ShaderMaterial>;
  readonly list: InstanceList;

  constructor(crowd: CrowdTextures['uniforms']) {
    this.mesh = new Mesh(makeDisc(), discMaterial(crowd));
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 2;
    this.mesh.visible = false;
    this.list = new InstanceList([this.mesh.geometry]);
  }

  set strength(alpha: number) {
    (this.mesh.material.uniforms['uStrength'] as { value: number }).value = alpha;
  }

  end(): void {
    this.list.end();
    this.mesh.visible = this.list.count > 0;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}

function makeDisc(): InstancedBufferGeometry {
  const geometry = new InstancedBufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]), 3));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  return geometry;
}

function discMaterial(crowd: CrowdTextures['uniforms']): ShaderMaterial {
  return new ShaderMaterial({
    transparent: true,
    depthWrite: false,
    polygonOffset: true,
    polygonOffsetFactor: -2,
    polygonOffsetUnits: -4,
    uniforms: { ...crowd, uStrength: { value: 0.3 } },
    vertexShader: `
${kCharacterNow}
varying vec2 vAt;
varying float vShade;
void main() {
  Person one = personShown();
  vec2 now = texelFetch(uClips, ivec2(1, one.clip), 0).xy;
  vec2 shape = mix(now, texelFetch(uClips, ivec2(1, one.before), 0).xy, one.fade);
  vAt = position.xy;
  vShade = shape.y;
  vec2 p = vec2(position.x * shape.x, position.y) * 0.34 * one.size;
  float c = cos(one.heading);
  float s = sin(one.heading);
  gl_Position = projectionMatrix * viewMatrix * vec4(one.at.x + c * p.x - s * p.y, one.at.y + s * p.x + c * p.y, 0.008, 1.0);
}`,
    fragmentShader: `
varying vec2 vAt;
varying float vShade;
uniform float uStrength;
void main() {
  float a = uStrength * vShade * (1.0 - smoothstep(0.25, 1.0, length(vAt)));
  if (a < 0.004) discard;
  gl_FragColor = vec4(0.0, 0.0, 0.0, a);
}`,
  });
}
