// Places where a group would stand, and the words about them.

import type { ScreenPoint } from '../../model/plane';
import type { Palette } from '../drawing/palette';
import type { MarkColours, MarkPainter } from './mark_painter';

/** Half of a cross on a place that nobody can get to [CSS px]. */
const kCross = 4.5;

/** Dots; crosses where `unfit` is not 0. */
export function drawPlaces(
  painter: MarkPainter,
  places: readonly ScreenPoint[],
  unfit: ArrayLike<number> | undefined,
  colours: MarkColours,
  alarm: string,
): void {
  places.forEach((place, k) => {
    if (unfit?.[k]) return;
    painter.dot(place, 3.6, colours.casing);
    painter.dot(place, 2.5, colours.accent);
  });
  // Above the dots of their neighbours.
  places.forEach((place, k) => {
    if (unfit?.[k]) painter.cross(place, { accent: alarm, casing: colours.casing }, kCross);
  });
}

/** What would come of an order, and what is said of its places, on one plate. */
export function drawWords(
  painter: MarkPainter,
  at: ScreenPoint,
  said: {
    readonly palette: Palette;
    readonly forecasts: readonly { readonly text: string; readonly arrives: boolean }[];
    readonly note?: { readonly text: string; readonly warns: boolean } | undefined;
  },
): void {
  const { palette, forecasts, note } = said;
  const words = [forecasts.find(({ text }) => text !== '')?.text ?? '', note?.text ?? ''].filter((one) => one !== '');
  if (words.length === 0) return;
  const alarms = note?.warns === true || forecasts.some(({ arrives }) => !arrives);
  painter.label(at, words.join(' \u00b7 '), palette.panel, alarms ? palette.alarm : palette.ink);
}
