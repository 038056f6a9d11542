// Straight strokes with a width in px whatever the zoom, all of one layer in one draw.

import {
  Color,
  DynamicDrawUsage,
  GreaterDepth,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  BufferAttribute,
  LessEqualDepth,
  LinearSRGBColorSpace,
  Mesh,
  ShaderMaterial,
  Vector2,
} from 'three';
import { forgetInstances } from './instances';

const kVertex = `
attribute vec3 from;
attribute vec3 to;
attribute vec4 tint;
attribute vec2 along;
uniform vec2 uSize;
uniform float uWidth;
uniform float uLift;
varying float vAcross;
varying float vAlong;
varying vec4 vTint;
void main() {
  vec4 a = projectionMatrix * modelViewMatrix * vec4(from, 1.0);
  vec4 b = projectionMatrix * modelViewMatrix * vec4(to, 1.0);
  // What lies behind the eye is cut where the line enters the view.
  float near = 0.02;
  if (a.w < near && b.w > near) a = mix(a, b, (near - a.w) / (b.w - a.w));
  if (b.w < near && a.w > near) b = mix(b, a, (near - b.w) / (a.w - b.w));
  vec2 pa = a.xy / a.w * uSize * 0.5;
  vec2 pb = b.xy / b.w * uSize * 0.5;
  vec2 d = pb - pa;
  float l = length(d);
  d = l > 1e-4 ? d / l : vec2(1.0, 0.0);
  float reach = uWidth * 0.5 + 1.0;
  vec4 p = position.x < 0.5 ? a : b;
  vec2 offset = vec2(-d.y, d.x) * position.y * reach + d * (position.x * 2.0 - 1.0) * uWidth * 0.35;
  p.xy += offset / (uSize * 0.5) * p.w;
  p.z -= uLift * p.w;
  gl_Position = p;
  vAcross = position.y * reach;
  vAlong = mix(along.x, along.x + distance(from, to), position.x);
  vTint = tint;
}`;

const kFragment = `
uniform float uWidth;
uniform float uDash;
uniform float uFade;
varying float vAcross;
varying float vAlong;
varying vec4 vTint;
void main() {
  float cover = clamp(uWidth * 0.5 + 0.5 - abs(vAcross), 0.0, 1.0);
  if (uDash > 0.0) {
    float wide = max(fwidth(vAlong), 1e-5);
    float at = abs(fract(vAlong / uDash) - 0.5) * uDash;
    cover *= clamp((0.3 * uDash - at) / wide + 0.5, 0.0, 1.0);
  }
  if (cover * vTint.a < 0.003) discard;
  gl_FragColor = vec4(vTint.rgb, vTint.a * cover * uFade);
}`;

export interface FatLinesDef {
  /** [device px] is this times the pixel ratio. */
  readonly width: number;
  /** Dash and gap together [m]; 0 for a whole line. */
  readonly dash?: number;
  /** Draw where bodies hide the line instead. */
  readonly behind?: boolean;
  /** Has lines at the same places, in other tints; only those are set here. Reserve room in that one first. */
  readonly as?: FatLines;
  readonly renderOrder: number;
}

export class FatLines {
  readonly mesh: Mesh<InstancedBufferGeometry, ShaderMaterial>;
  private readonly width_: number;
  private readonly as_: FatLines | null;
  private capacity_ = 0;
  private count_ = 0;
  private from_ = new Float32Array(0);
  private to_ = new Float32Array(0);
  private tints_ = new Float32Array(0);
  private along_ = new Float32Array(0);
  private readonly scratch_ = new Color();

  constructor(def: FatLinesDef) {
    this.width_ = def.width;
    this.as_ = def.as ?? null;
    const material = new ShaderMaterial({
      vertexShader: kVertex,
      fragmentShader: kFragment,
      transparent: true,
      depthWrite: false,
      depthFunc: def.behind ? GreaterDepth : LessEqualDepth,
      uniforms: {
        uSize: { value: new Vector2(1, 1) },
        uWidth: { value: def.width },
        uDash: { value: def.dash ?? 0 },
        uFade: { value: 1 },
        uLift: { value: def.behind ? 0 : 8e-5 },
      },
    });
    const geometry = new InstancedBufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array([0, -1, 0, 1, -1, 0, 1, 1, 0, 0, 1, 0]), 3));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    geometry.instanceCount = 0;
    this.mesh = new Mesh(geometry, material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = def.renderOrder;
    this.mesh.visible = false;
  }

  get count(): number {
    return this.count_;
  }

  /** Canvas size in device px, and device px per CSS px. */
  setSize(width: number, height: number, ratio: number): void {
    (this.mesh.material.uniforms['uSize'] as { value: Vector2 }).value.set(width, height);
    (this.mesh.material.uniforms['uWidth'] as { value: number }).value = this.width_ * ratio;
  }

  set fade(value: number) {
    (this.mesh.material.uniforms['uFade'] as { value: number }).value = value;
  }

  /** Grows to hold `count` lines. Growing loses what was written. */
  reserve(count: number): void {
    this.count_ = count;
    this.mesh.geometry.instanceCount = count;
    this.mesh.visible = count > 0;
    if (count <= this.capacity_) return;
    this.capacity_ = Math.max(64, Math.ceil(count * 1.3));
    this.from_ = new Float32Array(3 * this.capacity_);
    this.to_ = new Float32Array(3 * this.capacity_);
    this.tints_ = new Float32Array(4 * this.capacity_);
    this.along_ = new Float32Array(2 * this.capacity_);
    const geometry = this.mesh.geometry;
    forgetInstances(geometry);
    const own = (array: Float32Array, size: number): InstancedBufferAttribute => {
      const attribute = new InstancedBufferAttribute(array, size);
      attribute.setUsage(DynamicDrawUsage);
      return attribute;
    };
    const others = this.as_?.mesh.geometry.attributes;
    geometry.setAttribute('from', others?.['from'] ?? own(this.from_, 3));
    geometry.setAttribute('to', others?.['to'] ?? own(this.to_, 3));
    geometry.setAttribute('tint', own(this.tints_, 4));
    geometry.setAttribute('along', others?.['along'] ?? own(this.along_, 2));
  }

  setLine(index: number, ax: number, ay: number, az: number, bx: number, by: number, bz: number, along = 0): void {
    const at = 3 * index;
    this.from_[at] = ax;
    this.from_[at + 1] = ay;
    this.from_[at + 2] = az;
    this.to_[at] = bx;
    this.to_[at + 1] = by;
    this.to_[at + 2] = bz;
    this.along_[2 * index] = along;
  }

  setTint(index: number, hex: string, alpha: number): void {
    // As it is shown: converting at every pixel costs software renderers more than the line.
    this.scratch_.setStyle(hex, LinearSRGBColorSpace);
    this.tints_[4 * index] = this.scratch_.r;
    this.tints_[4 * index + 1] = this.scratch_.g;
    this.tints_[4 * index + 2] = this.scratch_.b;
    this.tints_[4 * index + 3] = alpha;
  }

  /** Hands the lines to the GPU. */
  flush(tints: boolean): void {
    const attributes = this.mesh.geometry.attributes;
    if (tints && attributes['tint']) attributes['tint'].needsUpdate = true;
    if (this.as_) return;
    const dashed = (this.mesh.material.uniforms['uDash'] as { value: number }).value > 0;
    for (const name of dashed ? ['from', 'to', 'along'] : ['from', 'to']) {
      const attribute = attributes[name];
      if (attribute) attribute.needsUpdate = true;
    }
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}
