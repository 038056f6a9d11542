// Materials that all things of the scene share: lit bodies, and flat ground that takes shadows.

import { type Color, MeshLambertMaterial, ShaderMaterial, UniformsLib, UniformsUtils } from 'three';

/** Values every material reads; one object, so that a change reaches all. */
export interface ShadeUniforms {
  /** Part of its light that the ground keeps in shadow. */
  readonly uShadowKeeps: { value: number };
  readonly uHatch: { value: Color };
}

/** Lit by hemisphere and sun, coloured per vertex; `hatch` draws lines on what faces up above 1.5 m. */
export function bodyMaterial(shade: ShadeUniforms, hatch: boolean): MeshLambertMaterial {
  const material = new MeshLambertMaterial({ vertexColors: true });
  material.onBeforeCompile = (shader): void => {
    shader.uniforms['uHatch'] = shade.uHatch;
    shader.vertexShader = shader.vertexShader
      .replace('#include <common>', '#include <common>\nvarying vec3 vAt;\nvarying float vUp;')
      .replace('#include <begin_vertex>', '#include <begin_vertex>\nvAt = position; vUp = normal.z;');
    shader.fragmentShader = shader.fragmentShader
      .replace('#include <common>', '#include <common>\nvarying vec3 vAt;\nvarying float vUp;\nuniform vec3 uHatch;')
      .replace('#include <color_fragment>', `#include <color_fragment>\n${hatch ? kHatch : ''}`);
  };
  material.customProgramCacheKey = (): string => (hatch ? 'body-hatched' : 'body');
  return material;
}

const kHatch = `
if (vUp > 0.9 && vAt.z > 1.5) {
  float across = (vAt.x * 0.26 + vAt.y * 0.966) / 0.55;
  float wide = fwidth(across);
  float line = 1.0 - smoothstep(0.035, 0.035 + wide * 1.2, abs(fract(across) - 0.5));
  diffuseColor.rgb = mix(diffuseColor.rgb, uHatch, line * clamp(0.32 / max(wide, 0.01), 0.0, 1.0));
}`;

/** Lit, coloured per vertex, and let through what lies behind. */
export function seeThroughMaterial(opacity: number): MeshLambertMaterial {
  return new MeshLambertMaterial({ vertexColors: true, transparent: true, opacity, depthWrite: false });
}

/** Flat on the ground: shown in its own colour, dimmed where the sun does not reach. */
export function floorMaterial(shade: ShadeUniforms): ShaderMaterial {
  const material = new ShaderMaterial({
    lights: true,
    vertexColors: true,
    uniforms: UniformsUtils.merge([UniformsLib.lights, { uOpacity: { value: 1 } }]),
    vertexShader: `
#include <common>
#include <shadowmap_pars_vertex>
varying vec3 vColour;
void main() {
  vColour = color;
  vec3 objectNormal = vec3(0.0, 0.0, 1.0);
  vec3 transformedNormal = normalize(normalMatrix * objectNormal);
  vec4 worldPosition = modelMatrix * vec4(position, 1.0);
  #include <shadowmap_vertex>
  gl_Position = projectionMatrix * viewMatrix * worldPosition;
}`,
    fragmentShader: `
#include <common>
#include <packing>
#include <lights_pars_begin>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
varying vec3 vColour;
uniform float uShadowKeeps;
uniform float uOpacity;
void main() {
  float lit = mix(uShadowKeeps, 1.0, getShadowMask());
  gl_FragColor = vec4(vColour * lit, uOpacity);
  #include <colorspace_fragment>
}`,
    transparent: true,
    depthWrite: false,
    polygonOffset: true,
    polygonOffsetFactor: -1,
    polygonOffsetUnits: -2,
  });
  material.uniforms['uShadowKeeps'] = shade.uShadowKeeps;
  return material;
}
