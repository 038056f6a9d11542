// The discs of shade under everybody: one draw call.

import { BufferAttribute, DynamicDrawUsage, InstancedBufferAttribute, InstancedBufferGeometry, Mesh, ShaderMaterial } from 'three';
import { forgetInstances } from './instances';

export class ContactDiscs {
  readonly mesh: Mesh<InstancedBufferGeometry, ShaderMaterial>;
  private place_ = new Float32Array(0);
  private shape_ = new Float32Array(0);
  private count_ = 0;

  constructor() {
    this.mesh = new Mesh(makeDisc(), discMaterial());
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 2;
    this.mesh.visible = false;
  }

  set strength(alpha: number) {
    (this.mesh.material.uniforms['uAlpha'] as { value: number }).value = alpha;
  }

  begin(most: number): void {
    this.count_ = 0;
    if (4 * most <= this.place_.length) return;
    this.place_ = new Float32Array(4 * Math.ceil(1.3 * most));
    this.shape_ = new Float32Array(this.place_.length / 2);
    forgetInstances(this.mesh.geometry);
    for (const [name, array, size] of [['aPlace', this.place_, 4], ['aShape', this.shape_, 2]] as const) {
      const attribute = new InstancedBufferAttribute(array, size);
      attribute.setUsage(DynamicDrawUsage);
      this.mesh.geometry.setAttribute(name, attribute);
    }
  }

  /** `long`: over its width; `shade`: 0 none to 1. */
  add(x: number, y: number, heading: number, size: number, long: number, shade: number): void {
    const at = 4 * this.count_;
    this.place_[at] = x;
    this.place_[at + 1] = y;
    this.place_[at + 2] = heading;
    this.place_[at + 3] = size;
    this.shape_[2 * this.count_] = long;
    this.shape_[2 * this.count_ + 1] = shade;
    this.count_ += 1;
  }

  end(): void {
    const { geometry } = this.mesh;
    geometry.instanceCount = this.count_;
    this.mesh.visible = this.count_ > 0;
    for (const name of ['aPlace', 'aShape']) if (geometry.attributes[name]) geometry.attributes[name].needsUpdate = true;
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

function discMaterial(): ShaderMaterial {
  return new ShaderMaterial({
    transparent: true, depthWrite: false, polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -4,
    uniforms: { uAlpha: { value: 0.3 } },
    vertexShader: `
attribute vec4 aPlace;
attribute vec2 aShape;
varying vec2 vAt;
varying float vShade;
void main() {
  vAt = position.xy;
  vShade = aShape.y;
  vec2 p = vec2(position.x * aShape.x, position.y) * 0.34 * aPlace.w;
  float c = cos(aPlace.z);
  float s = sin(aPlace.z);
  gl_Position = projectionMatrix * viewMatrix
    * vec4(aPlace.x + c * p.x - s * p.y, aPlace.y + s * p.x + c * p.y, 0.008, 1.0);
}`,
    fragmentShader: `
varying vec2 vAt;
varying float vShade;
uniform float uAlpha;
void main() {
  float a = uAlpha * vShade * (1.0 - smoothstep(0.25, 1.0, length(vAt)));
  if (a < 0.004) discard;
  gl_FragColor = vec4(0.0, 0.0, 0.0, a);
}`,
  });
}
