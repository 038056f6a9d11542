// Shader code that poses a body by linear blending of its joints and places it in the world.
//
// Per character: aWho (its number in the crowd; above it the row of a whole pose of its own, from 1 on). All else lies in
// textures: uFrom and uTo, two frames as StudioFrame.rows has them; uMembers (shirt, and skin, hair and whether it is
// never greyed as one number; size, class, radius); uClips (first pose, poses, whether cyclic; disc of shade).

import { kRowsAcross } from '../../model/studio_frame';
import { kClassColours } from '../../model/roles';
import { kWhoBits } from '../drawing/instance_list';
import { kPosesAcross } from './clips/pose_texture';
import { kChosen } from './crowd_textures';
import { kJump } from './crowd_state';

/** Where a character is in this moment, and what it plays. */
export const kCharacterNow = `
attribute uint aWho;
uniform highp sampler2D uFrom;
uniform highp sampler2D uTo;
uniform highp sampler2D uMembers;
uniform highp sampler2D uClips;
uniform float uAlpha;

struct Person { vec2 at; float heading; float size; float fade; int clip; float phase; int before; float beforePhase; };

int who() {
  return int(aWho & ${2 ** kWhoBits - 1}u);
}

ivec2 rowOf(int i) {
  return ivec2(2 * (i % ${kRowsAcross}), i / ${kRowsAcross});
}

float phaseBetween(float clip, float from, float to, float t) {
  float gone = to - from;
  bool cyclic = texelFetch(uClips, ivec2(0, int(clip + 0.5)), 0).z > 0.5;
  // One that begins anew does not run backwards.
  gone = cyclic ? gone - floor(gone + 0.5) : max(gone, 0.0);
  return to - gone * (1.0 - t);
}

Person personShown() {
  ivec2 row = rowOf(who());
  vec4 a = texelFetch(uFrom, row, 0);
  vec4 b = texelFetch(uTo, row, 0);
  vec4 playedA = texelFetch(uFrom, row + ivec2(1, 0), 0);
  vec4 playedB = texelFetch(uTo, row + ivec2(1, 0), 0);
  // A character that was put elsewhere is not interpolated.
  float t = distance(a.xy, b.xy) > ${kJump.toFixed(1)} ? 1.0 : uAlpha;
  float turn = b.z - a.z;
  turn -= 6.2831853 * floor(turn / 6.2831853 + 0.5);
  bool same = t < 1.0 && playedA.x == playedB.x;
  bool sameBefore = t < 1.0 && playedA.z == playedB.z;
  Person one;
  one.at = mix(a.xy, b.xy, t);
  one.heading = a.z + turn * t;
  one.size = texelFetch(uMembers, row + ivec2(1, 0), 0).x;
  one.fade = same && sameBefore ? mix(a.w, b.w, t) : b.w;
  one.clip = int(playedB.x + 0.5);
  one.phase = same ? phaseBetween(playedB.x, playedA.y, playedB.y, t) : playedB.y;
  one.before = int(playedB.z + 0.5);
  one.beforePhase = sameBefore ? phaseBetween(playedB.z, playedA.w, playedB.w, t) : playedB.w;
  return one;
}
`;

/** `LIGHT`: the nearest pose alone, and the two joints that matter most. */
export const kCharacterPose = `
attribute vec4 joints;
attribute vec4 weights;
attribute float region;
attribute vec3 tint;
uniform highp sampler2D uBaked;
uniform highp sampler2D uNear;
uniform vec3 uBind[21];
${kCharacterNow}
// Two poses, and how far from one to the other: of the clip, of the clip before, and the share of that.
vec3 gNow;
vec3 gBefore;
float gFade;
float gSize;
// 1 where a character is so small that only the group's colour is told; nearer ones come to that by and by.
float gAfar;
uniform float uLens;

vec3 momentOf(int clip, float phase) {
  vec4 span = texelFetch(uClips, ivec2(0, clip), 0);
  bool cyclic = span.z > 0.5;
  float at = phase * (cyclic ? span.y : max(1.0, span.y - 1.0));
  at = cyclic ? at - span.y * floor(at / span.y) : clamp(at, 0.0, span.y - 1.0);
  float whole = min(floor(at), span.y - 1.0);
  float next = cyclic ? (whole + 1.5 > span.y ? 0.0 : whole + 1.0) : min(whole + 1.0, span.y - 1.0);
  return vec3(span.x + whole, span.x + next, at - whole);
}

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
  return boneOf(uBaked, gNow.z < 0.5 ? gNow.x : gNow.y, joint);
#else
  uint whole = aWho >> ${kWhoBits}u;
  if (whole > 0u) return boneOf(uNear, float(whole) - 1.0, joint);
  Bone now = between(boneOf(uBaked, gNow.x, joint), boneOf(uBaked, gNow.y, joint), gNow.z);
  if (gFade < 0.004) return now;
  return between(now, between(boneOf(uBaked, gBefore.x, joint), boneOf(uBaked, gBefore.y, joint), gBefore.z), gFade);
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
  Person one = personShown();
  gNow = momentOf(one.clip, one.phase);
  gBefore = momentOf(one.before, one.beforePhase);
  gFade = one.fade;
  gSize = one.size;
  float pixels = uLens / max(0.1, -(viewMatrix * vec4(one.at, 0.9, 1.0)).z);
  gAfar = region > 1.1 && region < 1.5 ? 1.0 : smoothstep(10.0, 5.0, pixels);
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
  skin.at *= one.size;
  float c = cos(one.heading);
  float s = sin(one.heading);
  skin.at = vec3(one.at.x + c * skin.at.x - s * skin.at.y, one.at.y + s * skin.at.x + c * skin.at.y, skin.at.z);
  skin.normal = vec3(c * skin.normal.x - s * skin.normal.y, s * skin.normal.x + c * skin.normal.y, skin.normal.z);
  // Light from above, or the sides that are in shade would make small figures dark.
  skin.normal += vec3(0.0, 0.0, 1.4 * gAfar);
  return skin;
}
`;

/** Colours by what the skin is made of (see kRegion); skins and hairs by the look. */
export const kCharacterColour = `
uniform vec3 uSkins[5];
uniform vec3 uHairs[5];
uniform vec3 uClasses[${kClassColours.length}];
uniform float uGreyed;
uniform vec3 uTrousers;
varying vec3 vPerson;
varying float vGrey;

void colourPerson() {
  vec4 worn = texelFetch(uMembers, rowOf(who()), 0);
  float chosen = step(${kChosen - 0.5}, worn.w);
  int look = int(worn.w + 0.5 - chosen * ${kChosen}.0);
  int skin = look / 5;
  int hair = look - skin * 5;
  // Who is of a class wears a helmet.
  int unitClass = int(texelFetch(uMembers, rowOf(who()) + ivec2(1, 0), 0).y + 0.5);
  vec3 crown = unitClass > 0 ? uClasses[(unitClass - 1) % ${kClassColours.length}] : uHairs[hair];
  vec3 colour = worn.rgb * mix(0.86 + 0.28 * fract(gSize * 97.31), 1.0, gAfar);
  // Heads stand out from shirts, which are dark on light ground and light on dark ground.
  float bright = smoothstep(0.2, 0.35, dot(worn.rgb, vec3(0.3, 0.6, 0.1)));
  vec3 bare = mix(mix(uSkins[skin], vec3(0.9, 0.82, 0.74), 0.55), mix(uSkins[skin], crown, 0.7), bright);
  vec3 farHead = unitClass > 0 ? crown : bare;
  vec3 farLegs = worn.rgb * 0.55;
  if (region > 4.5) colour = mix(tint, worn.rgb, 0.3);
  else if (region > 3.5) colour = mix(vec3(0.8), farLegs, gAfar);
  else if (region > 2.5) colour = mix(crown, farHead, gAfar);
  else if (region > 1.5) colour = mix(mix(worn.rgb * 0.16, uTrousers, 0.55), farLegs, gAfar);
  else if (region > 1.35) colour = farLegs;
  else if (region > 1.25) colour = farHead;
  else if (region < 0.5) colour = mix(uSkins[skin], farHead, gAfar);
  vPerson = colour;
  vGrey = uGreyed * (1.0 - chosen);
}
`;

/** In the fragment: the colour as seen, with a body's own picture where it has one. */
export const kCharacterShown = `
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
