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

/** Words about what is drawn. */
export interface Words {
  readonly text: string;
  readonly ink: string;
  /** Half of their plate [CSS px]. */
  readonly half: number;
}

/** What words are made of. */
interface Said {
  readonly palette: Palette;
  readonly forecasts: readonly { readonly text: string; readonly arrives: boolean }[];
  readonly drawn: { readonly note?: { readonly text: string; readonly warns: boolean } } | null;
}

/** When groups arrive, and what is said of their places; empty where nothing is known. */
export function saidOf(forecasts: Said['forecasts'], note = ''): string {
  return [forecasts.find(({ text }) => text !== '')?.text ?? '', note].filter((one) => one !== '').join(' \u00b7 ');
}

/** What would come of an order, and what is said of its places; null where there is nothing to say. */
export function wordsOf({ palette, forecasts, drawn }: Said): Words | null {
  const note = drawn?.note;
  const text = saidOf(forecasts, note?.text);
  if (text === '') return null;
  const alarms = note?.warns === true || forecasts.some(({ arrives }) => !arrives);
  return { text, ink: alarms ? palette.alarm : palette.ink, half: kLetter * text.length + 12 };
}

/** What panels take of the edges, in wide windows and in narrow ones [CSS px]. */
const kPanels = { wide: { left: 184, right: 164, top: 88 }, narrow: { left: 8, right: 8, top: 146 } };
const kWide = 1000;
/** Half the mean width of a letter of a label [CSS px]. */
const kLetter = 3.9;

/** The spot nearest to one above what is drawn where the words lie clear of the panels. */
export function roomFor(
  { x, y }: ScreenPoint,
  { half }: Words,
  { width, height }: { readonly width: number; readonly height: number },
): ScreenPoint {
  const edge = width >= kWide ? kPanels.wide : kPanels.narrow;
  const [from, to] = [edge.left + half, width - edge.right - half];
  return {
    x: from > to ? (from + to) / 2 : Math.min(to, Math.max(from, x)),
    y: Math.min(Math.max(y, edge.top), Math.max(edge.top, height / 2)),
  };
}
