// What stands behind the crowd in pictures and films that are kept. Loaded with the exports.

import { Color, LinearSRGBColorSpace, Mesh, PlaneGeometry, ShaderMaterial, ShadowMaterial } from 'three';
import type { Theme } from '../model/view_settings';
import { paletteOf } from './drawing/palette';
import type { Backdrop } from './studio_scene';

/** Colours of the sky by theme: right above, and at the horizon. */
const kSky: Readonly<Record<Theme, readonly [string, string]>> = {
  light: ['#9DBAD2', '#EEF1F1'],
  dark: ['#0A0E13', '#2A323A'],
};

/** A whole plane under the crowd [m]. */
const kWide = 4000;

const kSkyVertex = `
varying vec3 vAlong;
void main() {
  vec4 along = inverse(projectionMatrix) * vec4(position.xy, 1.0, 1.0);
  vAlong = transpose(mat3(viewMatrix)) * along.xyz;
  gl_Position = vec4(position.xy, 1.0, 1.0);
}`;

/** Ground up to the horizon, in haze the farther away it is; above it the sky. */
const kSkyFragment = `
varying vec3 vAlong;
uniform vec3 uZenith;
uniform vec3 uHorizon;
uniform vec3 uGround;
void main() {
  float rise = normalize(vAlong).z;
  vec3 sky = mix(uHorizon, uZenith, smoothstep(0.0, 0.5, sqrt(max(rise, 0.0)) * 0.8));
  vec3 ground = mix(uGround, uHorizon, exp(min(rise, 0.0) * 30.0));
  gl_FragColor = vec4(rise > 0.0 ? sky : ground, 1.0);
}`;

function kept(
  object: Mesh<PlaneGeometry, ShaderMaterial | ShadowMaterial>,
  rest: Omit<Backdrop, 'objects' | 'dispose'>,
): Backdrop {
  return {
    ...rest,
    objects: [object],
    dispose: () => {
      object.geometry.dispose();
      object.material.dispose();
    },
  };
}

/** The place as it is, under a sky. */
export function skyBackdrop(theme: Theme): Backdrop {
  const plain = (hex: string): { value: Color } => ({ value: new Color().setStyle(hex, LinearSRGBColorSpace) });
  const [zenith, horizon] = kSky[theme];
  const uniforms = { uZenith: plain(zenith), uHorizon: plain(horizon), uGround: plain(paletteOf(theme).groundOutside) };
  const material = new ShaderMaterial({
    uniforms,
    vertexShader: kSkyVertex,
    fragmentShader: kSkyFragment,
    depthTest: false,
    depthWrite: false,
  });
  const sky = new Mesh(new PlaneGeometry(2, 2), material);
  sky.frustumCulled = false;
  sky.renderOrder = -100;
  return kept(sky, { colour: null, peopleOnly: false, shadows: true });
}

/** The place as it is. */
export function solidBackdrop(): Backdrop {
  return { objects: [], colour: null, peopleOnly: false, shadows: true, dispose: () => undefined };
}

/** People before one colour, with the shadows on the ground where wanted. */
export function plainBackdrop(colour: string, shadows: boolean, theme: Theme): Backdrop {
  const material = new ShadowMaterial({ opacity: 1 - paletteOf(theme).shadowKeeps, depthWrite: false });
  const floor = new Mesh(new PlaneGeometry(kWide, kWide), material);
  floor.receiveShadow = true;
  floor.visible = shadows;
  return kept(floor, { colour: new Color(colour), peopleOnly: true, shadows });
}
