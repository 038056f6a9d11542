// The sun and the sky: where the light comes from, and its colours.

const kElevation = (52 * Math.PI) / 180;
/** Where the sun stands, from +x counter-clockwise [rad]: left of the view as it opens, so that shadows fall right. */
const kAzimuth = 3.4;
export const kSunColour = '#FFF9EE';
export const kSkyColour = '#FFFFFF';
export const kEarthColour = '#D2CABF';
/** Unit vector to the sun. */
export const kToSun = [
  Math.cos(kElevation) * Math.cos(kAzimuth),
  Math.cos(kElevation) * Math.sin(kAzimuth),
  Math.sin(kElevation),
] as const;
