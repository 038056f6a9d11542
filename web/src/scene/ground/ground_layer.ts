// The ground: pale, with lines every metre and every five, a kerb round it, and at most one field painted on it.

import { kLinesGlsl } from '../drawing/lines_glsl';
import {
  Color,
  DataTexture,
  FloatType,
  LinearFilter,
  Mesh,
  NearestFilter,
  PlaneGeometry,
  RGBAFormat,
  RGFormat,
  ShaderMaterial,
  SRGBColorSpace,
  UniformsLib,
  UniformsUtils,
  Vector4,
} from 'three';
import type { SceneBox } from '../../protocol/messages';
import { rampBytes } from '../drawing/colour';
import type { FieldRaster } from './field_raster';
import { leaveOutOpenings } from '../drawing/openings';
import { kKerb } from './kerb';
import type { Palette } from '../drawing/palette';
import type { ShadeUniforms } from '../drawing/shade';

const kVertex = `
#include <common>
#include <shadowmap_pars_vertex>
varying vec2 vAt;
void main() {
  vec3 objectNormal = vec3(0.0, 0.0, 1.0);
  vec3 transformedNormal = normalize(normalMatrix * objectNormal);
  vec4 worldPosition = modelMatrix * vec4(position, 1.0);
  vAt = worldPosition.xy;
  #include <shadowmap_vertex>
  gl_Position = projectionMatrix * viewMatrix * worldPosition;
}`;

const kFragment = `
#include <common>
#include <packing>
#include <lights_pars_begin>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
const float kKerb = ${kKerb.toFixed(2)};
varying vec2 vAt;
uniform vec3 uGround;
uniform vec3 uOutside;
uniform vec3 uFine;
uniform vec3 uCoarse;
uniform vec3 uEdge;
uniform vec3 uKerb;
uniform vec3 uInk;
uniform vec4 uBox;
uniform float uShadowKeeps;
uniform float uPixel;
uniform float uFieldOn;
uniform sampler2D uField;
uniform sampler2D uRamp;
uniform vec4 uFieldBox;
uniform float uStep;

${kLinesGlsl}

void main() {
  vec2 inside = min(vAt - uBox.xy, uBox.zw - vAt);
  float depth = min(inside.x, inside.y);
  float edgeWide = max(fwidth(depth), 1e-5);
  float within = smoothstep(-edgeWide, edgeWide, depth);
  vec3 colour = mix(uGround, uFine, lines(vAt, 1.0, 1.0));
  colour = mix(colour, uCoarse, lines(vAt, 5.0, 1.25));
  float kerb = max(kKerb, 3.5 * uPixel * edgeWide);
  vec3 beyond = mix(uKerb, uOutside, 1.0 - smoothstep(-edgeWide, edgeWide, depth + kerb));
  colour = mix(beyond, colour, within);
  float keeps = uShadowKeeps;
  if (uFieldOn > 0.0) {
    vec2 uv = (vAt - uFieldBox.xy) / uFieldBox.zw;
    vec2 sampled = texture2D(uField, uv).rg;
    float reached = smoothstep(0.35, 0.65, sampled.g) * within;
    float value = sampled.r / max(sampled.g, 0.02);
    vec3 field = texture2D(uRamp, vec2(clamp(value, 0.002, 0.998), 0.5)).rgb;
    float scaled = value * uStep;
    float wide = max(fwidth(scaled), 1e-5);
    float away = abs(fract(scaled - 0.5) - 0.5) / wide;
    float major = abs(fract(scaled / 5.0 - 0.5) - 0.5) * 5.0 / wide;
    float thin = (1.0 - smoothstep(0.1, 0.9 * uPixel, away)) * 0.34 * clamp((0.4 - wide) / 0.3, 0.0, 1.0);
    float thick = (1.0 - smoothstep(0.6 * uPixel, 1.1 * uPixel, major)) * 0.8 * clamp((1.6 - wide) / 1.0, 0.0, 1.0);
    field = mix(field, uInk, value < 0.999 && scaled > 0.3 ? max(thin, thick) : 0.0);
    colour = mix(colour, field, uFieldOn * reached);
    keeps = mix(keeps, 0.72, uFieldOn * reached);
  }
  colour = mix(colour, uEdge, (1.0 - smoothstep(0.6 * uPixel, 1.6 * uPixel, abs(depth) / edgeWide)) * 0.9);
  gl_FragColor = vec4(colour * mix(keeps, 1.0, getShadowMask()), 1.0);
  #include <colorspace_fragment>
}`;

/** Steps of the ramp's lookup table. */
const kRampSize = 256;

export class GroundLayer {
  readonly mesh: Mesh<PlaneGeometry, ShaderMaterial>;
  private ramp_: DataTexture | null = null;
  private field_: DataTexture | null = null;
  private rampKey_ = '';

  constructor(shade: ShadeUniforms) {
    const material = new ShaderMaterial({
      lights: true,
      vertexShader: kVertex,
      fragmentShader: kFragment,
      uniforms: UniformsUtils.merge([
        UniformsLib.lights,
        {
          uGround: { value: new Color() },
          uOutside: { value: new Color() },
          uFine: { value: new Color() },
          uCoarse: { value: new Color() },
          uEdge: { value: new Color() },
          uKerb: { value: new Color() },
          uInk: { value: new Color() },
          uBox: { value: new Vector4(-1, -1, 1, 1) },
          uPixel: { value: 1 },
          uFieldOn: { value: 0 },
          uField: { value: null },
          uRamp: { value: null },
          uFieldBox: { value: new Vector4(0, 0, 1, 1) },
          uStep: { value: 1 },
        },
      ]),
    });
    material.uniforms['uShadowKeeps'] = shade.uShadowKeeps;
    this.mesh = new Mesh(new PlaneGeometry(1, 1), leaveOutOpenings(material));
    this.mesh.receiveShadow = true;
    this.mesh.frustumCulled = false;
  }

  setBox(box: SceneBox): void {
    const width = box.max[0] - box.min[0];
    const height = box.max[1] - box.min[1];
    const reach = 6 * Math.max(width, height) + 200;
    this.mesh.position.set((box.min[0] + box.max[0]) / 2, (box.min[1] + box.max[1]) / 2, 0);
    this.mesh.scale.set(reach, reach, 1);
    (this.uniform('uBox').value as Vector4).set(box.min[0], box.min[1], box.max[0], box.max[1]);
  }

  setPalette(palette: Palette): void {
    const pairs = [
      ['uGround', palette.ground],
      ['uOutside', palette.groundOutside],
      ['uFine', palette.lineFine],
      ['uCoarse', palette.lineCoarse],
      ['uEdge', palette.edge],
      ['uKerb', palette.kerb],
    ] as const;
    for (const [name, hex] of pairs) (this.uniform(name).value as Color).set(hex);
    (this.uniform('uInk').value as Color).set('#11181C');
    const key = palette.ramp.join();
    if (key === this.rampKey_) return;
    this.rampKey_ = key;
    this.ramp_?.dispose();
    this.ramp_ = new DataTexture(rampBytes(palette.ramp, kRampSize), kRampSize, 1, RGBAFormat);
    this.ramp_.colorSpace = SRGBColorSpace;
    this.ramp_.minFilter = LinearFilter;
    this.ramp_.magFilter = LinearFilter;
    this.ramp_.needsUpdate = true;
    this.uniform('uRamp').value = this.ramp_;
  }

  /** Device px per CSS px: lines keep their width. */
  setPixelRatio(ratio: number): void {
    this.uniform('uPixel').value = ratio;
  }

  /** Paints a field, or none. `floatLinear`: the GPU can mix float texels. */
  setField(picture: FieldRaster | null, floatLinear: boolean): void {
    this.uniform('uFieldOn').value = picture ? 1 : 0;
    if (!picture) return;
    const old = this.field_;
    if (!old || old.image.width !== picture.width || old.image.height !== picture.height) {
      old?.dispose();
      this.field_ = new DataTexture(picture.texels, picture.width, picture.height, RGFormat, FloatType);
      const filter = floatLinear ? LinearFilter : NearestFilter;
      this.field_.minFilter = filter;
      this.field_.magFilter = filter;
    } else {
      old.image.data = picture.texels;
    }
    if (this.field_) this.field_.needsUpdate = true;
    this.uniform('uField').value = this.field_;
    (this.uniform('uFieldBox').value as Vector4).set(picture.x, picture.y, picture.spanX, picture.spanY);
    this.uniform('uStep').value = picture.scale.max / picture.scale.step;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
    this.ramp_?.dispose();
    this.field_?.dispose();
  }

  private uniform(name: string): { value: unknown } {
    return this.mesh.material.uniforms[name] as { value: unknown };
  }
}
