// Colours: hex to components, OKLab, and ramps that are even in lightness.

/** Components 0 to 1, sRGB encoded. */
export type Rgb = readonly [number, number, number];
/** Lightness, a, b. */
export type Oklab = readonly [number, number, number];

/** `#RRGGBB` to components. */
export function hexToRgb(hex: string): Rgb {
  const value = Number.parseInt(hex.slice(1), 16);
  return [((value >> 16) & 255) / 255, ((value >> 8) & 255) / 255, (value & 255) / 255];
}

export function rgbToHex(rgb: Rgb): string {
  const byte = (v: number): string =>
    Math.round(Math.min(1, Math.max(0, v)) * 255)
      .toString(16)
      .padStart(2, '0')
      .toUpperCase();
  return `#${byte(rgb[0])}${byte(rgb[1])}${byte(rgb[2])}`;
}

/** CSS colour with an alpha. */
export function withAlpha(hex: string, alpha: number): string {
  const [r, g, b] = hexToRgb(hex);
  return `rgba(${Math.round(r * 255)},${Math.round(g * 255)},${Math.round(b * 255)},${alpha})`;
}

export function srgbToLinear(v: number): number {
  return v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4;
}

/** Relative luminance (WCAG 2). */
export function luminance(hex: string): number {
  const [r, g, b] = hexToRgb(hex);
  return 0.2126 * srgbToLinear(r) + 0.7152 * srgbToLinear(g) + 0.0722 * srgbToLinear(b);
}

/** Contrast of two colours (WCAG 2), 1 to 21. */
export function contrast(a: string, b: string): number {
  const [one, other] = [luminance(a), luminance(b)];
  return (Math.max(one, other) + 0.05) / (Math.min(one, other) + 0.05);
}

export function linearToSrgb(v: number): number {
  return v <= 0.0031308 ? v * 12.92 : 1.055 * v ** (1 / 2.4) - 0.055;
}

/** B. Ottosson's OKLab (2020). */
export function rgbToOklab(rgb: Rgb): Oklab {
  const r = srgbToLinear(rgb[0]);
  const g = srgbToLinear(rgb[1]);
  const b = srgbToLinear(rgb[2]);
  const l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return [
    0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s,
    1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s,
    0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s,
  ];
}

export function oklabToRgb(lab: Oklab): Rgb {
  const l = (lab[0] + 0.3963377774 * lab[1] + 0.2158037573 * lab[2]) ** 3;
  const m = (lab[0] - 0.1055613458 * lab[1] - 0.0638541728 * lab[2]) ** 3;
  const s = (lab[0] - 0.0894841775 * lab[1] - 1.291485548 * lab[2]) ** 3;
  const clip = (v: number): number => Math.min(1, Math.max(0, linearToSrgb(v)));
  return [
    clip(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
    clip(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
    clip(-0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s),
  ];
}

/** The colour made darker or lighter in OKLab, until its luminance lies between the two. */
export function betweenLuminances(hex: string, least: number, most: number): string {
  const [lightness, a, b] = rgbToOklab(hexToRgb(hex));
  const now = luminance(hex);
  if (now >= least && now <= most) return hex;
  const step = now > most ? -0.01 : 0.01;
  for (let k = 1; k <= 100; ++k) {
    const made = rgbToHex(oklabToRgb([lightness + step * k, a, b]));
    if (now > most ? luminance(made) <= most : luminance(made) >= least) return made;
  }
  return hex;
}

/** The colour at `t` (0 to 1, clamped) along evenly spaced stops, mixed in OKLab. */
export function rampColour(stops: readonly string[], t: number): Rgb {
  const place = Math.min(1, Math.max(0, t)) * (stops.length - 1);
  const index = Math.min(stops.length - 2, Math.floor(place));
  const fraction = place - index;
  const from = rgbToOklab(hexToRgb(stops[index] ?? '#000000'));
  const to = rgbToOklab(hexToRgb(stops[index + 1] ?? '#000000'));
  const mix = (i: 0 | 1 | 2): number => from[i] + (to[i] - from[i]) * fraction;
  return oklabToRgb([mix(0), mix(1), mix(2)]);
}

/** RGBA bytes of a ramp, for a lookup texture. */
export function rampBytes(stops: readonly string[], size: number): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(size * 4);
  for (let i = 0; i < size; ++i) {
    const rgb = rampColour(stops, i / (size - 1));
    for (let c = 0; c < 3; ++c) bytes[i * 4 + c] = Math.round((rgb[c] ?? 0) * 255);
    bytes[i * 4 + 3] = 255;
  }
  return bytes;
}
