// Paths of chosen people over the scene: as recorded, as shown, with pins to take hold of and marks where something is wrong.

import type { GroundPoint, ScreenPoint } from '../../../model/plane';
import { line, shape } from './path_layer';

interface PersonPath {
  /** Null where it is shown as it was recorded. */
  readonly recorded: readonly GroundPoint[] | null;
  readonly shown: readonly GroundPoint[];
  /** Where the person stands in the shown moment. */
  readonly now: GroundPoint | null;
  readonly times: readonly { readonly at: GroundPoint; readonly text: string }[];
  /** A pin each. */
  readonly handles: readonly GroundPoint[];
}

export interface PeoplePicture {
  readonly paths: readonly PersonPath[];
  /** The chosen pin; -1 for none. */
  readonly pin: number;
  /** Where something is wrong. */
  readonly troubles: readonly GroundPoint[];
  readonly lasso: readonly GroundPoint[] | null;
}

const kHandle = 11;

function circle({ x, y }: ScreenPoint, r: number, name: string): SVGElement {
  return shape('circle', { cx: x.toFixed(1), cy: y.toFixed(1), r, class: name });
}

function words({ x, y }: ScreenPoint, text: string): SVGElement {
  const made = shape('text', { x: (x + 9).toFixed(1), y: (y - 9).toFixed(1), class: 'path-time' });
  made.textContent = text;
  return made;
}

export function peopleShapes(picture: PeoplePicture, toScreen: (point: GroundPoint) => ScreenPoint): SVGElement[] {
  const { paths, pin, troubles, lasso } = picture;
  const on = (points: readonly GroundPoint[]): ScreenPoint[] => points.map(toScreen);
  const alone = paths.length === 1;
  return [
    ...paths.flatMap(({ recorded }) => (recorded ? [line(on(recorded), 'path-before')] : [])),
    ...paths.flatMap(({ shown }) => [line(on(shown), 'path-casing'), line(on(shown), 'path-line')]),
    ...paths.flatMap(({ now }) => (now ? [circle(toScreen(now), 7, 'path-now')] : [])),
    ...troubles.map((trouble) => {
      const { x, y } = toScreen(trouble);
      return shape('path', { d: `M${x - 7} ${y - 7}l14 14m0 -14l-14 14`, class: 'path-trouble' });
    }),
    ...paths.flatMap(({ handles }) =>
      handles.map((handle, k) => circle(toScreen(handle), kHandle, k === pin ? 'path-pin chosen' : 'path-pin')),
    ),
    ...(alone ? paths[0]!.times.map(({ at, text }) => words(toScreen(at), text)) : []),
    ...(lasso
      ? [
          shape('polygon', {
            points: on(lasso)
              .map(({ x, y }) => `${x},${y}`)
              .join(' '),
            class: 'path-lasso',
          }),
        ]
      : []),
  ];
}
