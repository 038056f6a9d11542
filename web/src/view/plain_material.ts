// What software renderers draw figures with: lit per corner instead of per pixel, and no shadows.

import { Color, ShaderMaterial } from 'three';
import { kFigureColour, kFigurePose } from './figure_shader';
import { kEarthColour, kSkyColour, kSunColour, kToSun } from './sun';

type Uniforms = Record<string, { value: unknown }>;

/** `uniforms`: what the shader of figures reads. */
export function plainFigureMaterial(uniforms: Uniforms): ShaderMaterial {
  const toSun = `vec3(${kToSun.map((one) => one.toFixed(5)).join(', ')})`;
  return new ShaderMaterial({
    uniforms: { ...uniforms, uSun: { value: new Color() }, uSky: { value: new Color() }, uEarth: { value: new Color() } },
    vertexShader: `
${kFigurePose}
${kFigureColour}
uniform vec3 uSun;
uniform vec3 uSky;
uniform vec3 uEarth;
// From light to what a screen takes, per corner: nearly the same as per pixel, and much cheaper.
vec3 shown(vec3 c) { return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c)); }
void main() {
  Figure posed = poseFigure(position, normal);
  colourFigure();
  vec3 n = normalize(posed.normal);
  vFigure *= uSun * max(0.0, dot(n, ${toSun})) + mix(uEarth, uSky, 0.5 * n.z + 0.5);
  vFigure = shown(vFigure);
  gl_Position = projectionMatrix * viewMatrix * vec4(posed.at, 1.0);
}`,
    fragmentShader: `
varying vec3 vFigure;
void main() { gl_FragColor = vec4(vFigure, 1.0); }`,
  });
}

/** Sets the light: strengths of sun and sky as the lights of the scene have them. */
export function lightPlainFigures(material: ShaderMaterial, sun: number, sky: number): void {
  const set = (name: string, hex: string, strength: number): void => {
    // A matt surface sends back 1/pi of what falls on it.
    (material.uniforms[name]?.value as Color).set(hex).multiplyScalar(strength / Math.PI);
  };
  set('uSun', kSunColour, sun);
  set('uSky', kSkyColour, sky);
  set('uEarth', kEarthColour, sky);
}
