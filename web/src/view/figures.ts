// All characters: one instanced draw for bodies, one for the discs of shade under their feet.

import {
  BufferAttribute, Color, DynamicDrawUsage, InstancedBufferAttribute, InstancedBufferGeometry, Mesh, MeshDepthMaterial,
  MeshLambertMaterial, RGBADepthPacking, ShaderMaterial, type BufferGeometry, type WebGLProgramParametersWithUniforms,
} from 'three';
import type { CrowdState } from './crowd_state';
import { makeFigureGeometry } from './figure_geometry';
import { kFigureColour, kFigurePose } from './figure_shader';
import { forgetInstances } from './instances';
import { accentOf, type Palette } from './palette';
import { lightPlainFigures, plainFigureMaterial } from './plain_material';
import type { Quality } from './quality';

const kSkins = ['#F1C9A5', '#E0A97F', '#B97A50', '#8A5636', '#5B3A28'];
const kHairs = ['#15120F', '#3A2618', '#6B4A2B', '#8F867C', '#241A16'];

/** Added to the look of the one who keeps colours while the rest is grey. */
const kChosen = 100;

/** Beyond this many, or smaller than this [px/m], bodies are the coarse ones and only discs are their shadows. */
const kFineCount = 1500;
const kFinePixels = 11;

/** Skin, hair and size of a character by its id: a scrambled number (the finaliser of murmur3). */
export function lookOf(id: number): { readonly skin: number; readonly hair: number; readonly size: number } {
  let h = id | 0;
  h = Math.imul(h ^ (h >>> 16), 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
  h = (h ^ (h >>> 16)) >>> 0;
  return { skin: h % 5, hair: (h >>> 8) % 5, size: ((h >>> 16) & 255) / 255 };
}

function inject(shader: WebGLProgramParametersWithUniforms, colours: boolean): void {
  const lines = `${kFigurePose}\n${colours ? kFigureColour : ''}`;
  shader.vertexShader = shader.vertexShader.replace('#include <common>', `#include <common>\n${lines}`);
  if (colours) {
    shader.vertexShader = shader.vertexShader
      .replace('#include <beginnormal_vertex>',
        'Figure posed = poseFigure(position, normal);\nvec3 objectNormal = posed.normal;\ncolourFigure();')
      .replace('#include <begin_vertex>', 'vec3 transformed = posed.at;');
    shader.fragmentShader = shader.fragmentShader
      .replace('#include <common>', '#include <common>\nvarying vec3 vFigure;')
      .replace('#include <color_fragment>', 'diffuseColor.rgb = vFigure;');
  } else {
    shader.vertexShader = shader.vertexShader
      .replace('#include <begin_vertex>', 'vec3 transformed = poseFigure(position, vec3(0.0, 0.0, 1.0)).at;');
  }
}

type FigureUniforms = {
  readonly uSkins: { value: Color[] };
  readonly uHairs: { value: Color[] };
  readonly uGreyed: { value: number };
  readonly uGreyTint: { value: Color };
};

export class Figures {
  readonly bodies: Mesh<InstancedBufferGeometry, MeshLambertMaterial | ShaderMaterial>;
  readonly discs: Mesh<InstancedBufferGeometry, ShaderMaterial>;
  /** Near, and far. */
  private readonly shapes_: readonly [BufferGeometry, BufferGeometry];
  private readonly uniforms_: FigureUniforms = {
    uSkins: { value: kSkins.map((hex) => new Color(hex)) },
    uHairs: { value: kHairs.map((hex) => new Color(hex)) },
    uGreyed: { value: 0 },
    uGreyTint: { value: new Color('#A9A6A2') },
  };
  private shape_: BufferGeometry | null = null;
  private shirts_ = new Float32Array(0);

  /** In full quality near figures throw shadows, in light quality all are plain and have only discs. */
  constructor(private readonly quality_: Quality) {
    const plain = quality_ === 'light' ? makeFigureGeometry({ sides: 4, shape: 'plain' }) : null;
    this.shapes_ = plain ? [plain, plain]
      : [makeFigureGeometry({ sides: 8, shape: 'fine' }), makeFigureGeometry({ sides: 4, shape: 'coarse' })];
    const material = plain ? plainFigureMaterial(this.uniforms_) : this.litMaterial();
    const depth = new MeshDepthMaterial({ depthPacking: RGBADepthPacking });
    depth.onBeforeCompile = (shader): void => inject(shader, false);
    this.bodies = new Mesh(new InstancedBufferGeometry(), material);
    this.bodies.customDepthMaterial = depth;
    this.bodies.receiveShadow = false;
    this.bodies.frustumCulled = false;
    this.discs = new Mesh(makeDisc(), discMaterial());
    this.discs.frustumCulled = false;
    this.discs.renderOrder = 2;
    this.useDetail(true);
    this.setCount(0);
  }

  get count(): number {
    return this.bodies.geometry.instanceCount;
  }

  setPalette(palette: Palette, greyed: boolean, dark: boolean): void {
    this.uniforms_.uGreyed.value = greyed ? 1 : 0;
    this.uniforms_.uGreyTint.value.set(palette.grey);
    const { material } = this.bodies;
    if (material instanceof ShaderMaterial) lightPlainFigures(material, palette.sun, palette.sky);
    (this.discs.material.uniforms['uAlpha'] as { value: number }).value = dark ? 0.5 : 0.3;
  }

  /** After the list of characters or the theme changed. `colours`: accent index per group; `chosen`: id never greyed. */
  setMembers(state: CrowdState, colours: readonly number[], palette: Palette, chosen: number): void {
    const count = state.count;
    this.shirts_ = new Float32Array(3 * count);
    const looks = new Float32Array(2 * count);
    const accents = colours.map((colour) => new Color(accentOf(palette, colour)));
    const fallback = new Color(accentOf(palette, 0));
    for (let i = 0; i < count; ++i) {
      const accent = accents[state.group[i] ?? 0] ?? fallback;
      this.shirts_.set([accent.r, accent.g, accent.b], 3 * i);
      const look = lookOf(state.ids[i] ?? 0);
      looks.set([look.skin * 5 + look.hair + (state.ids[i] === chosen ? kChosen : 0), look.size], 2 * i);
    }
    const place = instanced(state.placement, 4, true);
    for (const geometry of [this.bodies.geometry, this.discs.geometry]) {
      forgetInstances(geometry);
      geometry.setAttribute('aPlace', place);
    }
    const pose = instanced(state.pose, 4, true);
    this.bodies.geometry.setAttribute('aPose', pose);
    this.discs.geometry.setAttribute('aPose', pose);
    this.bodies.geometry.setAttribute('aReach', instanced(state.reach, 1, true));
    this.bodies.geometry.setAttribute('aShirt', instanced(this.shirts_, 3, false));
    this.bodies.geometry.setAttribute('aLook', instanced(looks, 2, false));
    this.setCount(count);
  }

  /** Sends the moved figures and picks their detail. */
  update(pixelsPerMetre: number): void {
    this.useDetail(this.count <= kFineCount && pixelsPerMetre > kFinePixels);
    for (const name of ['aPlace', 'aPose', 'aReach']) {
      const attribute = this.bodies.geometry.attributes[name];
      if (attribute) attribute.needsUpdate = true;
    }
  }

  dispose(): void {
    this.bodies.geometry.dispose();
    this.bodies.material.dispose();
    this.discs.geometry.dispose();
    this.discs.material.dispose();
  }

  private setCount(count: number): void {
    this.bodies.geometry.instanceCount = count;
    this.discs.geometry.instanceCount = count;
    this.bodies.visible = count > 0;
    this.discs.visible = count > 0;
  }

  private litMaterial(): MeshLambertMaterial {
    const material = new MeshLambertMaterial();
    material.onBeforeCompile = (shader): void => {
      Object.assign(shader.uniforms, this.uniforms_);
      inject(shader, true);
    };
    return material;
  }

  private useDetail(fine: boolean): void {
    const source = this.shapes_[fine ? 0 : 1];
    if (source === this.shape_) return;
    this.shape_ = source;
    this.bodies.castShadow = fine && this.quality_ === 'full';
    for (const name of ['position', 'normal', 'limb']) {
      this.bodies.geometry.setAttribute(name, source.attributes[name] as BufferAttribute);
    }
    this.bodies.geometry.setIndex(source.index);
  }
}

function instanced(array: Float32Array, size: number, moves: boolean): InstancedBufferAttribute {
  const attribute = new InstancedBufferAttribute(array, size);
  if (moves) attribute.setUsage(DynamicDrawUsage);
  return attribute;
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
attribute vec4 aPose;
varying vec2 vAt;
varying float vDim;
void main() {
  vAt = position.xy;
  vDim = aPose.w < -0.2 ? 0.0 : 1.0 - 0.5 * clamp(aPose.w, 0.0, 1.0);
  float longer = 1.0 + 1.3 * aPose.y;
  vec2 p = vec2(position.x * longer, position.y) * 0.34;
  float c = cos(aPlace.z);
  float s = sin(aPlace.z);
  gl_Position = projectionMatrix * viewMatrix
    * vec4(aPlace.x + c * p.x - s * p.y, aPlace.y + s * p.x + c * p.y, 0.008, 1.0);
}`,
    fragmentShader: `
varying vec2 vAt;
varying float vDim;
uniform float uAlpha;
void main() {
  float r = length(vAt);
  float a = uAlpha * vDim * (1.0 - smoothstep(0.25, 1.0, r));
  if (a < 0.004) discard;
  gl_FragColor = vec4(0.0, 0.0, 0.0, a);
}`,
  });
}
