// Heights as maps write them: numbers, "12 m", "40'", storeys.

/** Of a storey, and of what says nothing of its height [m]. */
export const kStorey = 3;
const kFoot = 0.3048;
const kInch = 0.0254;
const kCentimetre = 0.01;

const kHeightKeys = ['height', 'building:height', 'render_height', 'est_height', 'measuredHeight', 'Height', 'HEIGHT'];
const kStoreyKeys = ['building:levels', 'levels', 'building_levels', 'num_floors', 'floors', 'storeys'];
const kFootKeys = ['min_height', 'render_min_height', 'building:min_height'];
const kFootStoreyKeys = ['building:min_level', 'min_level'];

export type Properties = Readonly<Record<string, unknown>>;

const numberOf = (text: string): number => Number(text.replace(',', '.'));

/** "12", "12,5 m", "40'", `12'6"`, "40 ft", 12 as metres; null where it is none. */
export function lengthOf(value: unknown): number | null {
  if (typeof value === 'number') return Number.isFinite(value) ? value : null;
  if (typeof value !== 'string') return null;
  const text = value.trim().toLowerCase();
  const feet = /^~?(\d+(?:[.,]\d+)?)\s*(?:'|′|’|ft|feet|foot)\s*(?:(\d+(?:[.,]\d+)?)\s*(?:"|″|”|''|in)?)?$/.exec(text);
  if (feet) return numberOf(feet[1]!) * kFoot + (feet[2] ? numberOf(feet[2]) * kInch : 0);
  const metres = /^~?(-?\d+(?:[.,]\d+)?)\s*(cm|m|metres?|meters?)?$/.exec(text);
  if (!metres) return null;
  return numberOf(metres[1]!) * (metres[2] === 'cm' ? kCentimetre : 1);
}

function first(properties: Properties, keys: readonly string[]): number | null {
  for (const key of keys) {
    const found = lengthOf(properties[key]);
    if (found !== null) return found;
  }
  return null;
}

/** Of a building's top [m]; null where nothing is said. */
export function heightOf(properties: Properties): number | null {
  const height = first(properties, kHeightKeys);
  if (height !== null && height > 0) return height;
  const storeys = first(properties, kStoreyKeys);
  return storeys !== null && storeys > 0 ? storeys * kStorey : null;
}

/** Where it begins above the ground [m]. */
export function footOf(properties: Properties): number {
  return first(properties, kFootKeys) ?? (first(properties, kFootStoreyKeys) ?? 0) * kStorey;
}
