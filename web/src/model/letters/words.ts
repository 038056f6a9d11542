// Words as places: letters of single lines for few people, letters of a printed font for many, as they can be read.

import type { GroundPoint } from '../plane';
import { LetterReader, type Legibility, type LetterDrawn, type LetterSeen } from './legibility';
import { kBetween, kStrokeChars, strokeLetters, type StrokeLetter } from './stroke_font';
import { leastDistance, placesAlong } from './stroke_places';

/** Words that people can stand on. */
export interface WordPlaces {
  /** About their middle, y up, in heights of a capital. */
  readonly places: readonly GroundPoint[];
  /** Between neighbours, in heights of a capital. */
  readonly gap: number;
  readonly legibility: Legibility;
}

/** Letters of a font stand apart so many times as far as people do. */
const kLetterGap = 1.7;
/** A drawn letter is sampled by so many dots. */
const kSamples = 300;
/** More people are not looked for, for a letter. */
const kMostPerLetter = 120;
/** The nearest two stand at least so near to each other, of the usual distance of neighbours. */
const kNear = 0.62;

const drawn = new Map<string, LetterDrawn>();

function drawnLetter(char: string): LetterDrawn {
  const known = drawn.get(char);
  if (known) return known;
  const { strokes } = strokeLetters(char)![0]!;
  const dots = strokes.filter(({ points }) => points.length === 1).map(({ points }) => points[0]!);
  const lines = strokes.filter(({ points }) => points.length > 1);
  const sampled = lines.length > 0 ? placesAlong(lines, kSamples) : null;
  const letter = { samples: sampled?.places ?? [], step: sampled?.gap ?? 1, dots };
  drawn.set(char, letter);
  return letter;
}

const lineReader = new LetterReader(drawnLetter, kStrokeChars);

/** Puts the middle of the box of all places at the origin. */
export function centred(places: readonly GroundPoint[]): GroundPoint[] {
  const [xs, ys] = [places.map(({ x }) => x), places.map(({ y }) => y)];
  const middle = (values: readonly number[]): number => (Math.min(...values) + Math.max(...values)) / 2;
  const [cx, cy] = [middle(xs), middle(ys)];
  return places.map(({ x, y }) => ({ x: x - cx, y: y - cy }));
}

/** The letters as they stand: who belongs to which. */
function seenLetters(letters: readonly StrokeLetter[], places: readonly GroundPoint[], between: number): LetterSeen[] {
  return letters.map(({ char, x, width }) => {
    const [left, right] = [x - between / 2, x + width + between / 2];
    return { char, places: places.filter((place) => place.x > left && place.x <= right) };
  });
}

/** Words in single lines; null where there are too few people even for the corners, or a letter has no drawing. */
export function strokeWords(words: string, count: number): WordPlaces | null {
  const tight = strokeLetters(words);
  if (!tight || tight.length === 0) return null;
  const first = placesAlong(
    tight.flatMap(({ strokes }) => strokes),
    count,
  );
  if (!first) return null;
  const between = Math.max(kBetween, kLetterGap * first.gap);
  const letters = strokeLetters(words, between)!;
  const set = placesAlong(
    letters.flatMap(({ strokes }) => strokes),
    count,
  )!;
  const legibility = lineReader.read(seenLetters(letters, set.places, between), set.gap);
  const gap = Math.min(set.gap || 1, leastDistance(set.places) / kNear);
  return { places: centred(set.places), gap, legibility };
}

/** The least number of people with which the words can be read in single lines; 0 where there is none. */
export function peopleFor(words: string): number {
  const letters = strokeLetters(words)?.length ?? 0;
  if (letters === 0) return 0;
  const reads = (count: number): boolean => strokeWords(words, count)?.legibility.reads ?? false;
  let [few, enough] = [letters, 2 * letters];
  while (enough <= kMostPerLetter * letters && !reads(enough)) [few, enough] = [enough, Math.ceil(enough * 1.25)];
  if (enough > kMostPerLetter * letters) return 0;
  while (enough - few > 1) {
    const middle = Math.floor((few + enough) / 2);
    if (reads(middle)) enough = middle;
    else few = middle;
  }
  return enough;
}
