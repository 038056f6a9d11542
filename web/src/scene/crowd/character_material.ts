// Materials of characters: lit per pixel and casting shadows, or, for software renderers, lit per vertex.

import {
  Color,
  MeshDepthMaterial,
  MeshLambertMaterial,
  RGBADepthPacking,
  ShaderMaterial,
  type Texture,
  type Vector3,
  type WebGLProgramParametersWithUniforms,
} from 'three';
import { kClassColours } from '../../model/roles';
import { kHairs, kSkins } from './look';
import type { CrowdTextures } from './crowd_textures';
import { kCharacterColour, kCharacterPose, kCharacterShown } from './character_shader';
import type { Quality } from '../drawing/quality';
import { kEarthColour, kSkyColour, kSunColour, kToSun } from '../drawing/daylight';

/** Uniforms of all characters. */
export class CharacterUniforms {
  readonly uSkins = { value: kSkins.map((hex) => new Color(hex)) };
  readonly uHairs = { value: kHairs.map((hex) => new Color(hex)) };
  readonly uClasses = { value: kClassColours.map((hex) => new Color(hex)) };
  /** CSS px of a metre at the distance of one metre. */
  readonly uLens = { value: 1 };
  readonly uGreyed = { value: 0 };
  /** Cloth of trousers: light where the ground is dark. */
  readonly uTrousers = { value: new Color() };
  readonly uGreyTint = { value: new Color('#A9A6A2') };
  readonly uSun = { value: new Color() };
  readonly uSky = { value: new Color() };
  readonly uEarth = { value: new Color() };

  /** Strengths of sun and sky as the lights of the scene have them. */
  light(sun: number, sky: number): void {
    const set = (colour: Color, hex: string, strength: number): void => {
      // A matt surface sends back 1/pi of what falls on it.
      colour.set(hex).multiplyScalar(strength / Math.PI);
    };
    set(this.uSun.value, kSunColour, sun);
    set(this.uSky.value, kSkyColour, sky);
    set(this.uEarth.value, kEarthColour, sky);
  }
}

/** Uniforms that the shaders of all bodies share. */
export interface CrowdUniforms {
  readonly characters: CharacterUniforms;
  readonly crowd: CrowdTextures['uniforms'];
}

/** Uniforms of one body. */
export interface BodyUniforms {
  readonly uBaked: { value: Texture };
  readonly uNear: { value: Texture };
  readonly uBind: { value: Vector3[] };
}

type All = CharacterUniforms & CrowdTextures['uniforms'] & BodyUniforms & { readonly uMap: { value: Texture | null } };

const kMapAt = '#ifdef BODY_MAP\nvMapAt = uv;\n#endif\n';
const kMapVarying = '#ifdef BODY_MAP\nvarying vec2 vMapAt;\n#endif\n';

function inject(shader: WebGLProgramParametersWithUniforms, uniforms: All): void {
  Object.assign(shader.uniforms, uniforms);
  shader.vertexShader = shader.vertexShader
    .replace('#include <common>', `#include <common>\n${kCharacterPose}\n${kCharacterColour}\n${kMapVarying}`)
    .replace(
      '#include <beginnormal_vertex>',
      `Skin skin = posePerson(position, normal);\nvec3 objectNormal = skin.normal;\ncolourPerson();\n${kMapAt}`,
    )
    .replace('#include <begin_vertex>', 'vec3 transformed = skin.at;');
  shader.fragmentShader = shader.fragmentShader
    .replace('#include <common>', `#include <common>\n${kCharacterShown}`)
    .replace('#include <color_fragment>', 'diffuseColor.rgb = shownPerson();');
}

function injectDepth(shader: WebGLProgramParametersWithUniforms, uniforms: All): void {
  Object.assign(shader.uniforms, uniforms);
  shader.vertexShader = shader.vertexShader
    .replace('#include <common>', `#include <common>\n${kCharacterPose}`)
    .replace('#include <begin_vertex>', 'vec3 transformed = posePerson(position, vec3(0.0, 0.0, 1.0)).at;');
}

/** Joins the uniforms without copying them, as the crowd's textures are exchanged in them. */
function together(
  people: CharacterUniforms,
  crowd: CrowdTextures['uniforms'],
  body: BodyUniforms,
  map: Texture | null,
): All {
  return { ...people, ...crowd, ...body, uMap: { value: map } } as All;
}

/** For shadow maps. */
export function characterDepthMaterial(
  { characters: people, crowd }: CrowdUniforms,
  body: BodyUniforms,
): MeshDepthMaterial {
  const depth = new MeshDepthMaterial({ depthPacking: RGBADepthPacking });
  depth.onBeforeCompile = (shader): void => injectDepth(shader, together(people, crowd, body, null));
  depth.customProgramCacheKey = (): string => 'people-depth';
  return depth;
}

export function characterMaterial(
  quality: Quality,
  { characters: people, crowd }: CrowdUniforms,
  body: BodyUniforms,
  map: Texture | null,
): MeshLambertMaterial | ShaderMaterial {
  const uniforms = together(people, crowd, body, map);
  const defines: Record<string, string> = map ? { BODY_MAP: '' } : {};
  if (quality === 'light') return lightMaterial(uniforms, { ...defines, LIGHT: '' });
  const material = Object.assign(new MeshLambertMaterial(), { defines });
  material.onBeforeCompile = (shader): void => inject(shader, uniforms);
  material.customProgramCacheKey = (): string => `people${map ? '-map' : ''}`;
  return material;
}

function lightMaterial(uniforms: All, defines: Record<string, string>): ShaderMaterial {
  const toSun = `vec3(${kToSun.map((one) => one.toFixed(5)).join(', ')})`;
  return new ShaderMaterial({
    uniforms: uniforms as unknown as Record<string, { value: unknown }>,
    defines,
    vertexShader: `
${kCharacterPose}
${kCharacterColour}
${kMapVarying}
uniform vec3 uSun;
uniform vec3 uSky;
uniform vec3 uEarth;
varying vec3 vLight;
void main() {
  Skin skin = posePerson(position, normal);
  colourPerson();
  ${kMapAt}
  vec3 n = normalize(skin.normal);
  vLight = uSun * max(0.0, dot(n, ${toSun})) + mix(uEarth, uSky, 0.5 * n.z + 0.5);
  gl_Position = projectionMatrix * viewMatrix * vec4(skin.at, 1.0);
}`,
    fragmentShader: `
${kCharacterShown}
varying vec3 vLight;
void main() {
  gl_FragColor = vec4(shownPerson() * vLight, 1.0);
  #include <colorspace_fragment>
}`,
  });
}
