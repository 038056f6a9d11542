// Places as rings on the ground, in one draw call: whole, dashed while a formation is new, crossed where a character
// does not fit.

import {
  BufferAttribute,
  Color,
  DynamicDrawUsage,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  LinearSRGBColorSpace,
  Mesh,
  ShaderMaterial,
} from 'three';
import { forgetInstances } from '../drawing/instances';

/** Radius of a ring [m]. */
const kRadius = 0.24;
/** How a ring is drawn. */
export const kRing = { whole: 0, dashed: 1, crossed: 2 } as const;

/** Half the quad beyond the ring's radius [m]. */
const kMargin = 0.06;
/** Where a metre is this small, rings are not seen; where it is twice as large, fully [CSS px]. */
const kDense = 7;

const kVertex = `
attribute vec2 ring;
attribute vec4 tint;
varying vec2 vAt;
varying vec4 vTint;
varying float vStyle;
void main() {
  vAt = position.xy * ${(kRadius + kMargin).toFixed(2)};
  // The style, and what is left of it the opacity.
  vStyle = floor(tint.a);
  vTint = vec4(tint.rgb, tint.a - vStyle);
  gl_Position = projectionMatrix * viewMatrix * vec4(ring + vAt, 0.012, 1.0);
}`;

const kFragment = `
varying vec2 vAt;
varying vec4 vTint;
varying float vStyle;
uniform float uPixel;
uniform float uFade;
void main() {
  float r = length(vAt);
  float wide = max(fwidth(r), 1e-5);
  float cover = clamp(0.65 * uPixel + 0.5 - abs(r - ${kRadius.toFixed(2)} + 0.5 * wide) / wide, 0.0, 1.0);
  if (vStyle > 0.5 && vStyle < 1.5) {
    float turn = fract(atan(vAt.y, vAt.x) / 6.2831853 * 7.0);
    cover *= smoothstep(0.0, 0.12, turn) * (1.0 - smoothstep(0.5, 0.62, turn));
  }
  if (vStyle > 1.5 && r < ${kRadius.toFixed(2)}) {
    vec2 cross = vec2(vAt.x + vAt.y, vAt.x - vAt.y) * 0.7071;
    float away = min(abs(cross.x), abs(cross.y)) / wide;
    cover = max(cover, clamp(0.65 * uPixel + 0.5 - away, 0.0, 1.0));
  }
  if (cover < 0.01) discard;
  gl_FragColor = vec4(vTint.rgb, vTint.a * cover * uFade);
}`;

export class PlaceLayer {
  readonly mesh: Mesh<InstancedBufferGeometry, ShaderMaterial>;
  private rings_ = new Float32Array(0);
  private tints_ = new Float32Array(0);
  private capacity_ = 0;
  private count_ = 0;
  private tinted_ = false;
  private readonly scratch_ = new Color();

  constructor() {
    const geometry = new InstancedBufferGeometry();
    geometry.setAttribute(
      'position',
      new BufferAttribute(new Float32Array([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]), 3),
    );
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    geometry.instanceCount = 0;
    const material = new ShaderMaterial({
      vertexShader: kVertex,
      fragmentShader: kFragment,
      transparent: true,
      depthWrite: false,
      polygonOffset: true,
      polygonOffsetFactor: -3,
      polygonOffsetUnits: -6,
      uniforms: { uPixel: { value: 1 }, uFade: { value: 1 } },
    });
    this.mesh = new Mesh(geometry, material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 5;
  }

  /** False where rings would be dots. */
  get seen(): boolean {
    return (this.mesh.material.uniforms['uFade'] as { value: number }).value > 0;
  }

  /** Rings fade away where they would be dots; by the size of a metre [CSS px]. */
  setScale(pixelsPerMetre: number): void {
    const fade = Math.min(1, Math.max(0, (pixelsPerMetre - kDense) / kDense));
    (this.mesh.material.uniforms['uFade'] as { value: number }).value = fade;
    this.mesh.visible = fade > 0 && this.count_ > 0;
  }

  setPixelRatio(ratio: number): void {
    (this.mesh.material.uniforms['uPixel'] as { value: number }).value = ratio;
  }

  /** Removes all rings and grows to hold `count`. */
  begin(count: number): void {
    this.count_ = 0;
    this.tinted_ = false;
    if (count <= this.capacity_) return;
    this.capacity_ = Math.ceil(count * 1.3) + 16;
    this.rings_ = new Float32Array(2 * this.capacity_);
    this.tints_ = new Float32Array(4 * this.capacity_);
    forgetInstances(this.mesh.geometry);
    for (const [name, array, size] of [
      ['ring', this.rings_, 2],
      ['tint', this.tints_, 4],
    ] as const) {
      const attribute = new InstancedBufferAttribute(array, size);
      attribute.setUsage(DynamicDrawUsage);
      this.mesh.geometry.setAttribute(name, attribute);
    }
  }

  /** All rings that follow have this colour. */
  setTint(hex: string): void {
    // As it is shown: the shader converts nothing.
    this.scratch_.setStyle(hex, LinearSRGBColorSpace);
  }

  /** `alpha`: below 1. */
  add(x: number, y: number, style: number, alpha: number): void {
    if (this.count_ >= this.capacity_) return;
    this.rings_[2 * this.count_] = x;
    this.rings_[2 * this.count_ + 1] = y;
    const at = 4 * this.count_;
    this.tint(at, this.scratch_.r);
    this.tint(at + 1, this.scratch_.g);
    this.tint(at + 2, this.scratch_.b);
    this.tint(at + 3, style + alpha);
    ++this.count_;
  }

  private tint(at: number, value: number): void {
    const was = this.tints_[at];
    this.tints_[at] = value;
    this.tinted_ ||= this.tints_[at] !== was;
  }

  end(): void {
    this.mesh.geometry.instanceCount = this.count_;
    this.mesh.visible = this.count_ > 0;
    const { ring, tint } = this.mesh.geometry.attributes as Record<string, InstancedBufferAttribute | undefined>;
    if (this.tinted_ && tint) tint.needsUpdate = true;
    if (!ring || this.count_ === 0) return;
    ring.clearUpdateRanges();
    ring.addUpdateRange(0, 2 * this.count_);
    ring.needsUpdate = true;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}
