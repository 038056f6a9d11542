// Vertex code that bends a body to its pose and sets it in the world.
//
// Per character: aPlace (x, y, heading, size), aNow (two poses of the clip it plays, how far from one to the other, share
// of the clip before), aBefore (the same of the clip before; its fourth: row of a whole pose of its own, or -1), aLook
// (shirt, and skin, hair and whether it is never greyed as one number).

import { kPosesAcross } from '../people/pose_texture';

/** Added to the look of the one who keeps colours while the rest is grey. */
export const kChosen = 100;

/** `LIGHT`: the nearest pose alone, and the two joints that matter most. */
export const kPeoplePose = `
attribute vec4 joints;
attribute vec4 weights;
attribute float region;
attribute vec3 tint;
attribute vec4 aPlace;
attribute vec4 aNow;
attribute vec4 aBefore;
attribute vec4 aLook;
uniform highp sampler2D uBaked;
uniform highp sampler2D uNear;
uniform vec3 uBind[21];

struct Bone { vec4 turn; vec3 at; };
struct Skin { vec3 at; vec3 normal; };

Bone boneOf(highp sampler2D poses, float row, int joint) {
  int r = int(row + 0.5);
  ivec2 texel = ivec2((r % ${kPosesAcross}) * 42 + 2 * joint, r / ${kPosesAcross});
  return Bone(texelFetch(poses, texel, 0), texelFetch(poses, texel + ivec2(1, 0), 0).xyz);
}

Bone between(Bone a, Bone b, float t) {
  vec4 other = dot(a.turn, b.turn) < 0.0 ? -b.turn : b.turn;
  return Bone(normalize(mix(a.turn, other, t)), mix(a.at, b.at, t));
}

Bone posedBone(int joint) {
#ifdef LIGHT
  return boneOf(uBaked, aNow.z < 0.5 ? aNow.x : aNow.y, joint);
#else
  if (aBefore.w >= 0.0) return boneOf(uNear, aBefore.w, joint);
  Bone now = between(boneOf(uBaked, aNow.x, joint), boneOf(uBaked, aNow.y, joint), aNow.z);
  if (aNow.w < 0.004) return now;
  return between(now, between(boneOf(uBaked, aBefore.x, joint), boneOf(uBaked, aBefore.y, joint), aBefore.z), aNow.w);
#endif
}

vec3 turned(vec4 q, vec3 v) {
  vec3 t = 2.0 * cross(q.xyz, v);
  return v + q.w * t + cross(q.xyz, t);
}

void addBone(inout Skin skin, vec3 p, vec3 n, float joint, float weight) {
  if (weight <= 0.0) return;
  int j = int(joint + 0.5);
  Bone bone = posedBone(j);
  skin.at += weight * (turned(bone.turn, p - uBind[j]) + bone.at);
  skin.normal += weight * turned(bone.turn, n);
}

Skin posePerson(vec3 p, vec3 n) {
  Skin skin = Skin(vec3(0.0), vec3(0.0));
#ifdef LIGHT
  float both = max(weights.x + weights.y, 1e-4);
  addBone(skin, p, n, joints.x, weights.x / both);
  addBone(skin, p, n, joints.y, weights.y / both);
#else
  addBone(skin, p, n, joints.x, weights.x);
  addBone(skin, p, n, joints.y, weights.y);
  addBone(skin, p, n, joints.z, weights.z);
  addBone(skin, p, n, joints.w, weights.w);
#endif
  skin.at *= aPlace.w;
  float c = cos(aPlace.z);
  float s = sin(aPlace.z);
  skin.at = vec3(aPlace.x + c * skin.at.x - s * skin.at.y, aPlace.y + s * skin.at.x + c * skin.at.y, skin.at.z);
  skin.normal = vec3(c * skin.normal.x - s * skin.normal.y, s * skin.normal.x + c * skin.normal.y, skin.normal.z);
  return skin;
}
`;

/** Colours by what the skin is made of (see kRegion); skins and hairs by the look. */
export const kPeopleColour = `
uniform vec3 uSkins[5];
uniform vec3 uHairs[5];
uniform float uGreyed;
uniform float uTrousers;
varying vec3 vPerson;
varying float vGrey;

void colourPerson() {
  float chosen = step(${kChosen - 0.5}, aLook.w);
  int look = int(aLook.w + 0.5 - chosen * ${kChosen}.0);
  int skin = look / 5;
  int hair = look - skin * 5;
  vec3 colour = aLook.rgb * (0.86 + 0.28 * fract(aPlace.w * 97.31));
  if (region > 4.5) colour = mix(tint, aLook.rgb, 0.3);
  else if (region > 3.5) colour = vec3(0.8);
  else if (region > 2.5) colour = uHairs[hair];
  else if (region > 1.5) colour = uTrousers * mix(aLook.rgb * 0.16, vec3(0.012, 0.016, 0.026), 0.55);
  else if (region < 0.5) colour = uSkins[skin];
  vPerson = colour;
  vGrey = uGreyed * (1.0 - chosen);
}
`;

/** In the fragment: the colour as seen, with a body's own picture where it has one. */
export const kPeopleShown = `
varying vec3 vPerson;
varying float vGrey;
uniform vec3 uGreyTint;
#ifdef BODY_MAP
uniform sampler2D uMap;
varying vec2 vMapAt;
#endif
vec3 shownPerson() {
  vec3 colour = vPerson;
#ifdef BODY_MAP
  vec4 seen = texture2D(uMap, vMapAt);
  if (seen.a < 0.5) discard;
  colour *= seen.rgb;
#endif
  return mix(colour, mix(uGreyTint * 1.35, vec3(dot(colour, vec3(0.3, 0.6, 0.1))), 0.12), vGrey);
}
`;
