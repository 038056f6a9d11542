// Shaders of a player's picture. Colours are in linear light until the end.

import { kToSun } from '../../scene/drawing/daylight';
import { kLinesGlsl } from '../../scene/drawing/lines_glsl';
import { kHairs, kSkins } from '../../scene/crowd/look';

export const kFinishes = 25;

const kLight = `
const vec3 kToSun = vec3(${kToSun.map((one) => one.toFixed(6)).join(', ')});
uniform vec3 uSun;
uniform vec3 uSky;
uniform vec3 uEarth;
uniform float uShadows;
uniform mat4 uShadow;
uniform highp sampler2DShadow uDepth;

// The share of the sun that reaches a point.
float sunAt(vec3 world) {
  if (uShadows < 0.5) return 1.0;
  vec3 p = (uShadow * vec4(world, 1.0)).xyz * 0.5 + 0.5;
  if (any(lessThan(p, vec3(0.0))) || any(greaterThan(p, vec3(1.0)))) return 1.0;
  float texel = 1.0 / float(textureSize(uDepth, 0).x);
  float sum = 0.0;
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j) sum += texture(uDepth, vec3(p.xy + vec2(i, j) * texel * 1.2, p.z));
  return sum / 9.0;
}

vec3 lightOn(vec3 n, float sun) {
  return uSun * max(0.0, dot(n, kToSun)) * sun + mix(uEarth, uSky, 0.5 * n.z + 0.5);
}

vec4 shown(vec3 colour, float alpha) {
  vec3 c = clamp(colour, 0.0, 1.0);
  return vec4(mix(c * 12.92, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c)), alpha);
}
`;

export const kSceneAttributes = ['aAt', 'aNormal', 'aFinish'] as const;

export const kSceneVertex = `
in vec3 aAt;
in vec3 aNormal;
in float aFinish;
uniform mat4 uView;
uniform vec4 uPlace;
out vec3 vAt;
out vec3 vNormal;
flat out int vFinish;
vec2 turned(vec2 p) { return vec2(uPlace.z * p.x - uPlace.w * p.y, uPlace.w * p.x + uPlace.z * p.y); }
void main() {
  vAt = vec3(turned(aAt.xy) + uPlace.xy, aAt.z);
  vNormal = vec3(turned(aNormal.xy), aNormal.z);
  vFinish = int(aFinish + 0.5);
  gl_Position = uView * vec4(vAt, 1.0);
}`;

export const kSceneFragment = `${kLight}
in vec3 vAt;
in vec3 vNormal;
flat in int vFinish;
uniform vec4 uFinishes[${kFinishes}];
uniform vec4 uBox;
uniform vec3 uGround;
uniform vec3 uOutside;
uniform vec3 uFine;
uniform vec3 uCoarse;
uniform vec3 uEdge;
uniform float uKeeps;
uniform float uPixel;
out vec4 oColour;

${kLinesGlsl}

vec3 groundAt(vec2 at) {
  vec2 inside = min(at - uBox.xy, uBox.zw - at);
  float depth = min(inside.x, inside.y);
  float wide = max(fwidth(depth), 1e-5);
  vec3 colour = mix(uGround, uFine, lines(at, 1.0, 1.0));
  colour = mix(colour, uCoarse, lines(at, 5.0, 1.25));
  colour = mix(uOutside, colour, smoothstep(-wide, wide, depth));
  return mix(colour, uEdge, (1.0 - smoothstep(0.6 * uPixel, 1.6 * uPixel, abs(depth) / wide)) * 0.9);
}

void main() {
  vec3 n = normalize(vNormal);
  vec3 ground = groundAt(vAt.xy);
  float sun = sunAt(vAt + n * 0.03);
  if (vFinish == 0) {
    oColour = shown(ground * mix(uKeeps, 1.0, sun), 1.0);
    return;
  }
  vec4 finish = uFinishes[vFinish];
  oColour = shown(finish.rgb * lightOn(n, sun), finish.a);
}`;

export const kBodyAttributes = [
  'aAt',
  'aNormal',
  'aJoints',
  'aWeights',
  'aRegion',
  'iPlace',
  'iShirt',
  'iLook',
] as const;

const kPose = `
in vec3 aAt;
in vec3 aNormal;
in uvec4 aJoints;
in vec4 aWeights;
in vec4 iPlace;
in vec4 iShirt;
uniform mat4 uView;
uniform highp sampler2D uBones;
uniform int uAcross;
uniform int uTexels;
vec3 gAt;
vec3 gNormal;

vec3 turnedBy(vec4 q, vec3 v) {
  vec3 t = 2.0 * cross(q.xyz, v);
  return v + q.w * t + cross(q.xyz, t);
}

void addJoint(int slot, uint joint, float weight) {
  if (weight <= 0.0) return;
  ivec2 texel = ivec2((slot % uAcross) * uTexels + 2 * int(joint), slot / uAcross);
  vec4 q = texelFetch(uBones, texel, 0);
  gAt += weight * (turnedBy(q, aAt) + texelFetch(uBones, texel + ivec2(1, 0), 0).xyz);
  gNormal += weight * turnedBy(q, aNormal);
}

void pose() {
  int slot = int(iShirt.w + 0.5);
  gAt = vec3(0.0);
  gNormal = vec3(0.0);
  addJoint(slot, aJoints.x, aWeights.x);
  addJoint(slot, aJoints.y, aWeights.y);
  addJoint(slot, aJoints.z, aWeights.z);
  addJoint(slot, aJoints.w, aWeights.w);
  float c = cos(iPlace.z);
  float s = sin(iPlace.z);
  gAt *= iPlace.w;
  gAt = vec3(iPlace.x + c * gAt.x - s * gAt.y, iPlace.y + s * gAt.x + c * gAt.y, gAt.z);
  gNormal = vec3(c * gNormal.x - s * gNormal.y, s * gNormal.x + c * gNormal.y, gNormal.z);
}
`;

const colours = (hexes: readonly string[]): string =>
  hexes
    .map((hex) => {
      const value = Number.parseInt(hex.slice(1), 16);
      const part = (shift: number): string => (((value >> shift) & 255) / 255).toFixed(4);
      return `vec3(${part(16)}, ${part(8)}, ${part(0)})`;
    })
    .join(', ');

export const kBodyVertex = `${kPose}
in float aRegion;
in vec2 iLook;
uniform vec3 uTrousers;
out vec3 vAt;
out vec3 vNormal;
out vec3 vColour;
const vec3 kSkins[5] = vec3[5](${colours(kSkins)});
const vec3 kHairs[5] = vec3[5](${colours(kHairs)});
vec3 linearOf(vec3 c) { return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c)); }
void main() {
  pose();
  vAt = gAt;
  vNormal = gNormal;
  int region = int(aRegion + 0.5);
  // Shirts of one group differ a little.
  vec3 colour = iShirt.rgb * (0.86 + 0.28 * fract(iPlace.w * 97.31));
  if (region == 0) colour = linearOf(kSkins[int(iLook.x + 0.5)]);
  else if (region == 2) colour = mix(iShirt.rgb * 0.16, uTrousers, 0.55);
  else if (region == 3) colour = linearOf(kHairs[int(iLook.y + 0.5)]);
  else if (region == 4) colour = vec3(0.8);
  vColour = colour;
  gl_Position = uView * vec4(gAt, 1.0);
}`;

export const kBodyFragment = `${kLight}
in vec3 vAt;
in vec3 vNormal;
in vec3 vColour;
out vec4 oColour;
void main() {
  vec3 n = normalize(vNormal);
  oColour = shown(vColour * lightOn(n, sunAt(vAt + n * 0.04)), 1.0);
}`;

export const kBodyDepthVertex = `${kPose}
void main() {
  pose();
  gl_Position = uView * vec4(gAt, 1.0);
}`;

export const kSceneDepthVertex = `
in vec3 aAt;
uniform mat4 uView;
uniform vec4 uPlace;
void main() {
  vec2 p = vec2(uPlace.z * aAt.x - uPlace.w * aAt.y, uPlace.w * aAt.x + uPlace.z * aAt.y) + uPlace.xy;
  gl_Position = uView * vec4(p, aAt.z, 1.0);
}`;

export const kDepthFragment = 'void main() {}';

/** A soft shade under each character. */
export const kDiscVertex = `
in vec2 aAt;
in vec4 iPlace;
uniform mat4 uView;
out vec2 vAt;
void main() {
  vAt = aAt;
  gl_Position = uView * vec4(iPlace.xy + 0.34 * iPlace.w * aAt, 0.02, 1.0);
}`;

export const kDiscFragment = `
in vec2 vAt;
uniform float uStrength;
out vec4 oColour;
void main() {
  oColour = vec4(0.0, 0.0, 0.0, uStrength * (1.0 - smoothstep(0.25, 1.0, length(vAt))));
}`;
