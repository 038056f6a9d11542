// The lines of the ground, in shaders that know `uPixel`: how many pixels of the picture a CSS px has.

/** lines(): lines at multiples of a spacing, fading where they would crowd. */
export const kLinesGlsl = `
float lines(vec2 at, float spacing, float width) {
  vec2 across = at / spacing;
  vec2 wide = max(fwidth(across), vec2(1e-6));
  vec2 away = abs(fract(across - 0.5) - 0.5) / wide;
  vec2 line = 1.0 - smoothstep(width * 0.5 * uPixel - 0.5, width * 0.5 * uPixel + 0.5, away);
  line *= 1.0 - smoothstep(0.015, 0.12, wide * uPixel);
  return max(line.x, line.y);
}`;
