// Vertex code that poses a figure: it bends limbs about fixed joints by gait phase and pose, then sets it in the world.

/** Attributes per figure: aPlace (x, y, heading, phase), aPose (gait, prone, crouch, lift), aReach, aShirt, aLook. */
export const kFigurePose = `
attribute vec3 limb;
attribute vec4 aPlace;
attribute vec4 aPose;
attribute float aReach;
attribute vec3 aShirt;
attribute vec2 aLook;

// Turns about the y axis through a joint: positive swings what hangs down forward.
vec3 bend(vec3 p, float x, float z, float angle) {
  float c = cos(angle);
  float s = sin(angle);
  vec2 d = vec2(p.x - x, p.z - z);
  return vec3(x + c * d.x - s * d.y, p.y, z + s * d.x + c * d.y);
}

struct Figure { vec3 at; vec3 normal; };

Figure poseFigure(vec3 p, vec3 n) {
  float gait = aPose.x;
  float prone = aPose.y;
  float crouch = aPose.z;
  float lying = prone * (1.0 - crouch);
  float cycle = aPlace.w + (limb.y > 0.0 ? 3.14159265 : 0.0);
  float swing = sin(cycle);
  float kind = limb.x;
  vec3 tip = n + p;
  if (kind > 3.5) {
    float thigh = gait * (0.72 * swing + 0.16) * (1.0 - 0.6 * lying) + crouch * 1.15 * (1.0 - prone);
    float knee = gait * (0.3 + 1.05 * max(0.0, cos(cycle + 0.35))) * (1.0 - 0.7 * prone) + crouch * (1.75 - 0.3 * prone);
    if (kind > 4.5) {
      p = bend(p, 0.0, 0.49, -knee);
      tip = bend(tip, 0.0, 0.49, -knee);
    }
    p = bend(p, 0.0, 0.9, thigh);
    tip = bend(tip, 0.0, 0.9, thigh);
  } else if (kind > 1.5) {
    float arm = -gait * 0.85 * swing * (1.0 - lying) * (1.0 - 0.5 * prone) + aReach * 1.5 * (1.0 - crouch * prone) + prone * crouch * 1.35;
    arm += lying * (0.9 + 1.1 * sin(cycle));
    float elbow = gait * 1.25 * (1.0 - prone) + 0.12 + prone * crouch * 0.2;
    if (kind > 2.5) {
      p = bend(p, 0.0, 1.12, elbow);
      tip = bend(tip, 0.0, 1.12, elbow);
    }
    p = bend(p, 0.0, 1.4, arm);
    tip = bend(tip, 0.0, 1.4, arm);
  } else if (kind > 0.5) {
    p = bend(p, 0.0, 1.5, prone * 0.75);
    tip = bend(tip, 0.0, 1.5, prone * 0.75);
  }
  // The trunk leans as one; when crouching the legs stay under it.
  float lean = -(0.13 * gait * (1.0 - prone) + (1.45 - 0.2 * crouch) * prone);
  float part = kind > 3.5 ? 1.0 - crouch * 0.85 : 1.0;
  p = bend(p, 0.0, 0.9, lean * part);
  tip = bend(tip, 0.0, 0.9, lean * part);
  n = tip - p;
  p.z += aPose.w - crouch * (0.36 + 0.08 * prone) + gait * (1.0 - prone) * 0.035 * cos(2.0 * aPlace.w);
  p *= 0.96 + 0.08 * aLook.y;
  float c = cos(aPlace.z);
  float s = sin(aPlace.z);
  Figure figure;
  figure.at = vec3(aPlace.x + c * p.x - s * p.y, aPlace.y + s * p.x + c * p.y, p.z);
  figure.normal = vec3(c * n.x - s * n.y, s * n.x + c * n.y, n.z);
  return figure;
}
`;

/** Colours by stuff; skins and hairs by the figure's look. */
export const kFigureColour = `
uniform vec3 uSkins[5];
uniform vec3 uHairs[5];
uniform float uGreyed;
uniform vec3 uGreyTint;
varying vec3 vFigure;

void colourFigure() {
  float stuff = limb.z;
  float chosen = step(99.5, aLook.x);
  int look = int(aLook.x + 0.5 - chosen * 100.0);
  int skin = look / 5;
  int hair = look - skin * 5;
  vec3 colour = aShirt * (0.9 + 0.2 * fract(aLook.y * 7.31));
  if (stuff > 3.5) colour = vec3(0.8);
  else if (stuff > 2.5) colour = uHairs[hair];
  else if (stuff > 1.5) colour = uSkins[skin];
  else if (stuff > 0.5) colour = mix(aShirt * 0.16, vec3(0.012, 0.016, 0.026), 0.55);
  vFigure = mix(colour, mix(uGreyTint * 1.35, vec3(dot(colour, vec3(0.3, 0.6, 0.1))), 0.12), uGreyed * (1.0 - chosen));
}
`;
