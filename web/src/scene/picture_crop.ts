// Which part of the scene a small picture shows: the crowd, with what stands about it.

import type { ScreenPoint } from '../model/plane';

/** x, y, width and height [px]. */
export interface Crop {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** The crowd takes at most this share of the picture's width or height. */
const kShare = 0.6;
/** A picture shows at least this share of the scene's, or single people would fill it. */
const kLeast = 0.4;

/** The part of that aspect that shows the spots; the middle where there are none on the scene. */
export function cropAround(spots: readonly ScreenPoint[], width: number, height: number, aspect: number): Crop {
  const most = Math.min(width, height * aspect);
  const seen = spots.filter(({ x, y }) => x >= 0 && y >= 0 && x <= width && y <= height);
  const span = (values: readonly number[]): [number, number] => [Math.min(...values), Math.max(...values)];
  const [x0, x1] = seen.length > 0 ? span(seen.map(({ x }) => x)) : [0, width];
  const [y0, y1] = seen.length > 0 ? span(seen.map(({ y }) => y)) : [0, height];
  const wanted = Math.max((x1 - x0) / kShare, ((y1 - y0) * aspect) / kShare, kLeast * most);
  const wide = Math.min(most, wanted);
  const high = wide / aspect;
  const within = (middle: number, size: number, whole: number): number =>
    Math.min(whole - size, Math.max(0, middle - size / 2));
  return { x: within((x0 + x1) / 2, wide, width), y: within((y0 + y1) / 2, high, height), width: wide, height: high };
}
