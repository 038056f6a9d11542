// Formations that a visitor has saved with a name, kept in this browser.

import type { OwnShape } from './shape_edit';

export interface SavedShape extends OwnShape {
  readonly name: string;
}

const kKey = 'muster.formations';
/** More are not kept: the oldest go. */
const kMostShapes = 40;
const kMostPlaces = 5000;
export const kMostLetters = 40;

type Kept = Pick<Storage, 'getItem' | 'setItem'>;

function isShape(value: unknown): value is { name: string; spacing: number; places: [number, number][] } {
  const { name, spacing, places } = (value ?? {}) as Record<string, unknown>;
  const number = (one: unknown): boolean => typeof one === 'number' && Number.isFinite(one) && Math.abs(one) < 1e5;
  return (
    typeof name === 'string' &&
    name.length > 0 &&
    name.length <= kMostLetters &&
    number(spacing) &&
    (spacing as number) > 0 &&
    Array.isArray(places) &&
    places.length > 0 &&
    places.length <= kMostPlaces &&
    places.every((place) => Array.isArray(place) && place.length === 2 && place.every(number))
  );
}

/** What is kept; what cannot be read is left out. Browsers may refuse to tell: then nothing is. */
export function savedShapes(storage: () => Kept): SavedShape[] {
  try {
    const kept: unknown = JSON.parse(storage().getItem(kKey) ?? '[]');
    if (!Array.isArray(kept)) return [];
    return kept
      .filter(isShape)
      .map(({ name, spacing, places }) => ({ name, spacing, places: places.map(([x, y]) => ({ x, y })) }));
  } catch {
    return [];
  }
}

/** Keeps these and nothing else. False where the browser has no room, or forbids it. */
function keep(storage: () => Kept, shapes: readonly SavedShape[]): boolean {
  const rounded = (value: number): number => Math.round(value * 1000) / 1000;
  const kept = shapes.slice(-kMostShapes).map(({ name, spacing, places }) => ({
    name,
    spacing: rounded(spacing),
    places: places.map(({ x, y }) => [rounded(x), rounded(y)]),
  }));
  try {
    storage().setItem(kKey, JSON.stringify(kept));
    return true;
  } catch {
    return false;
  }
}

/** Saves a shape; one of the same name is replaced. */
export function saveShape(storage: () => Kept, shape: SavedShape): boolean {
  return keep(storage, [...savedShapes(storage).filter(({ name }) => name !== shape.name), shape]);
}

export function removeShape(storage: () => Kept, name: string): boolean {
  return keep(
    storage,
    savedShapes(storage).filter((one) => one.name !== name),
  );
}
