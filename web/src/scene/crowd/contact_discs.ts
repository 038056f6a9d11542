// Contact discs: a soft shadow under each character, and round those of a class a ring in its colour, as large as the
// body; all in one draw call.

import { BufferAttribute, Color, InstancedBufferGeometry, Mesh, ShaderMaterial } from 'three';
import type { CrowdTextures } from './crowd_textures';
import { kClassColours } from '../../model/roles';
import { InstanceList } from '../drawing/instance_list';
import { kCharacterNow } from './character_shader';

export class ContactDiscs {
  readonly mesh: Mesh<InstancedBufferGeometry, ShaderMaterial>;
  readonly list: InstanceList;
  shown = true;

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
    this.mesh.visible = this.shown && this.list.count > 0;
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
    uniforms: { ...crowd, uStrength: { value: 0.3 }, uClasses: { value: kClassColours.map((hex) => new Color(hex)) } },
    vertexShader: `
${kCharacterNow}
varying vec2 vAt;
varying float vShade;
varying vec2 vRing;
flat varying int vClass;
void main() {
  Person one = personShown();
  vec2 now = texelFetch(uClips, ivec2(1, one.clip), 0).xy;
  vec2 shape = mix(now, texelFetch(uClips, ivec2(1, one.before), 0).xy, one.fade);
  vShade = shape.y;
  vec4 body = texelFetch(uMembers, rowOf(who()) + ivec2(1, 0), 0);
  vClass = int(body.y + 0.5);
  vec2 shade = vec2(shape.x, 1.0) * 0.34 * one.size;
  float ring = vClass > 0 ? 1.25 * max(body.z, 0.2) : 0.0;
  vec2 p = position.xy * max(shade, vec2(ring));
  vAt = p / shade;
  vRing = p / max(body.z, 0.2);
  float c = cos(one.heading);
  float s = sin(one.heading);
  gl_Position = projectionMatrix * viewMatrix * vec4(one.at.x + c * p.x - s * p.y, one.at.y + s * p.x + c * p.y, 0.008, 1.0);
}`,
    fragmentShader: `
varying vec2 vAt;
varying float vShade;
varying vec2 vRing;
flat varying int vClass;
uniform float uStrength;
uniform vec3 uClasses[${kClassColours.length}];
void main() {
  float a = uStrength * vShade * (1.0 - smoothstep(0.25, 1.0, length(vAt)));
  vec3 colour = vec3(0.0);
  if (vClass > 0) {
    float r = length(vRing);
    float edge = fwidth(r);
    float ring = smoothstep(0.86 - edge, 0.86, r) - smoothstep(1.1, 1.1 + edge, r);
    colour = uClasses[(vClass - 1) % ${kClassColours.length}];
    // Premultiplied over the shade: the ring covers it.
    float over = 0.9 * ring;
    colour = mix(vec3(0.0), colour, over / max(over + a * (1.0 - over), 0.001));
    a = over + a * (1.0 - over);
  }
  if (a < 0.004) discard;
  gl_FragColor = vec4(colour, a);
  #include <colorspace_fragment>
}`,
  });
}
