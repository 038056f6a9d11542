// Sorts of persons of a group, as somebody edits them.

import type { Distribution, PeopleDef } from '../../protocol/generated/commands';
import type { SpreadWord } from '../../protocol/generated/words';

export type Spread = SpreadWord;
export type Spreading = Distribution;

/** Numbers that differ from person to person. */
export type DrawnNumber = 'speed' | 'radius' | 'headway' | 'premovement' | 'age';

export const kDrawnNumbers: readonly DrawnNumber[] = ['speed', 'radius', 'headway', 'premovement', 'age'];

/** A sort; a number that it leaves is that of the group's bodies. */
export interface PersonSort extends Readonly<Partial<Record<DrawnNumber, Spreading>>> {
  readonly name: string;
  readonly share: number;
  readonly unitClass: number;
  /** Shares of the speed in the open; 0 for that of the stairs. */
  readonly upstairs: number;
  readonly downstairs: number;
}

const kMost = 1e9;
const kBlank: PersonSort = { name: '', share: 1, unitClass: 0, upstairs: 0, downstairs: 0 };

/** Free speeds of Weidmann 1993. */
export const kAdults: PersonSort = {
  ...kBlank,
  name: 'Adults',
  speed: { spread: 'normal', a: 1.34, b: 0.26, least: 0.5, most: 2.2 },
};

/** What a number may be, and how it is spread where somebody begins with it. */
export interface NumberFacts {
  readonly label: string;
  readonly unit: string;
  readonly min: number;
  readonly max: number;
  readonly mean: number;
  readonly deviation: number;
}

export const kNumbers: Readonly<Record<DrawnNumber, NumberFacts>> = {
  speed: { label: 'Speed', unit: 'm/s', min: 0.01, max: 50, mean: 1.34, deviation: 0.26 },
  radius: { label: 'Radius', unit: 'm', min: 0.05, max: 1.5, mean: 0.22, deviation: 0.02 },
  headway: { label: 'Headway', unit: 's', min: 0.02, max: 5, mean: 0.6, deviation: 0.1 },
  premovement: { label: 'Premovement', unit: 's', min: 0, max: 1e7, mean: 60, deviation: 20 },
  age: { label: 'Age', unit: 'years', min: 5, max: 90, mean: 45, deviation: 15 },
};

/** The parameters of a spread that people type: their field, and what they are called. */
export const kSpreads: Readonly<
  Record<Spread, { readonly word: string; readonly fields: readonly (readonly [keyof Spreading, string])[] }>
> = {
  constant: { word: 'The same for all', fields: [['a', 'Value']] },
  uniform: {
    word: 'Uniform',
    fields: [
      ['a', 'From'],
      ['b', 'To'],
    ],
  },
  normal: {
    word: 'Normal',
    fields: [
      ['a', 'Mean'],
      ['b', 'Deviation'],
      ['least', 'Least'],
      ['most', 'Most'],
    ],
  },
  logNormal: {
    word: 'Log-normal',
    fields: [
      ['a', 'Log mean'],
      ['b', 'Log dev.'],
      ['least', 'Least'],
      ['most', 'Most'],
    ],
  },
  gamma: {
    word: 'Gamma',
    fields: [
      ['a', 'Shape'],
      ['b', 'Scale'],
      ['least', 'Least'],
      ['most', 'Most'],
    ],
  },
  weibull: {
    word: 'Weibull',
    fields: [
      ['a', 'Scale'],
      ['b', 'Shape'],
      ['least', 'Least'],
      ['most', 'Most'],
    ],
  },
};

/** A sort as definitions have it: a number that is constantly 0 is not drawn. */
export function sortOf({ name, share, unitClass, upstairs, downstairs, ...numbers }: PeopleDef): PersonSort {
  const drawn = kDrawnNumbers.filter((key) => numbers[key].spread !== 'constant' || numbers[key].a !== 0);
  return {
    name,
    share,
    unitClass,
    upstairs,
    downstairs,
    ...Object.fromEntries(drawn.map((key) => [key, numbers[key]])),
  };
}

/** The number with another kind of spread, about as it was; undefined for none. */
export function respread(
  key: DrawnNumber,
  before: Spreading | undefined,
  spread: Spread | undefined,
): Spreading | undefined {
  const { mean, deviation, min, max } = kNumbers[key];
  if (!spread) return undefined;
  const middle = before ? meanOf(before) : mean;
  const width = Math.max(0.01 * middle, Math.min(deviation, middle / 3));
  const bounds = { least: Math.max(min, middle - 3 * width), most: Math.min(max, middle + 3 * width) };
  const round = (value: number): number => Math.round(1000 * value) / 1000;
  const made: Record<Spread, readonly [number, number]> = {
    constant: [middle, 0],
    uniform: [Math.max(min, middle - 1.5 * width), Math.min(max, middle + 1.5 * width)],
    normal: [middle, width],
    logNormal: [Math.log(Math.max(min, middle, 1e-3)), width / Math.max(middle, 1e-3)],
    gamma: [(middle / width) ** 2, width ** 2 / middle],
    weibull: [1.1 * middle, 2],
  };
  const [a, b] = made[spread].map(round) as [number, number];
  const bounded = spread !== 'constant' && spread !== 'uniform';
  return { spread, a, b, least: bounded ? round(bounds.least) : 0, most: bounded ? round(bounds.most) : kMost };
}

/** The mean, but for what is cut off. */
export function meanOf({ spread, a, b }: Spreading): number {
  switch (spread) {
    case 'uniform':
      return (a + b) / 2;
    case 'logNormal':
      return Math.exp(a + (b * b) / 2);
    case 'gamma':
      return a * b;
    case 'weibull':
      return 0.9 * a;
    case 'constant':
    case 'normal':
      return a;
  }
}

function short(value: number): string {
  return String(Math.round(100 * value) / 100);
}

/** In a few words: "1.34 ± 0.26 m/s". */
export function spreadWords(key: DrawnNumber, one: Spreading): string {
  const { unit } = kNumbers[key];
  if (one.spread === 'uniform') return `${short(one.a)} to ${short(one.b)} ${unit}`;
  if (one.spread === 'normal') return `${short(one.a)} ± ${short(one.b)} ${unit}`;
  return `${one.spread === 'constant' ? '' : 'about '}${short(meanOf(one))} ${unit}`;
}

/** From where to where a spread reaches, as far as its numbers say so. */
function reachOf({ spread, a, b, least, most }: Spreading, { min, max }: NumberFacts): readonly [number, number] {
  if (spread === 'constant') return [a, a];
  if (spread === 'uniform') return [a, b];
  return [least > 0 ? least : min, most < kMost ? most : max];
}

/** What is wrong with a spread, for people; empty where it is good. The engine refuses the rest. */
export function spreadTrouble(key: DrawnNumber, one: Spreading): string {
  const { spread, a, b, least, most } = one;
  const { label, min, max, unit } = kNumbers[key];
  const name = label.toLowerCase();
  const cut = spread !== 'constant' && spread !== 'uniform';
  if (cut && b <= 0) return `The ${name} needs a second number above 0.`;
  if (cut && least >= most) return `The least ${name} is not below the largest one.`;
  if (spread === 'uniform' && b < a) return `The ${name} ends below where it begins.`;
  const [lowest, highest] = reachOf(one, kNumbers[key]);
  return lowest < min || highest > max ? `The ${name} is to lie within ${min} and ${max} ${unit}.` : '';
}
