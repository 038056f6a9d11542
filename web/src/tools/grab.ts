// Finds the part of a control that a contact grabs: an end, a bar, or a whole area.

import {
  convexHull,
  distance,
  distanceToSegment,
  insidePolygon,
  type GroundPoint,
  type ScreenPoint,
} from '../model/plane';
import { ControlKind, type ControlFrame } from '../protocol/messages';
import type { StudioGroup } from '../model/studio_frame';

export interface Grab {
  /** Index into the frame's groups. */
  readonly index: number;
  readonly group: number;
  readonly control: ControlFrame;
  /** Touches of the control's points that follow the contact. */
  readonly touches: readonly number[];
}

/** How much of a control may be grabbed. */
export type Grabbable = 'nothing' | 'handles' | 'whole';

export type ToScreen = (point: GroundPoint) => ScreenPoint;

/** Handles are drawn 22 px wide and grabbed within 48 px, also where perspective foreshortens the ground. */
const kHandlePx = 24;
const kBarPx = 12;

interface Candidate {
  readonly grab: Grab;
  readonly distance: number;
}

function nearestHandle(grab: Omit<Grab, 'touches'>, at: ScreenPoint, toScreen: ToScreen): Candidate | null {
  let best: Candidate | null = null;
  for (const point of grab.control.points) {
    const away = distance(toScreen(point), at);
    if (best === null || away < best.distance) best = { grab: { ...grab, touches: [point.touch] }, distance: away };
  }
  return best;
}

function holdsBody(control: ControlFrame, ground: GroundPoint, at: ScreenPoint, toScreen: ToScreen): boolean {
  const { kind, points } = control;
  if (kind === ControlKind.Area) return insidePolygon(ground, convexHull(points));
  if (kind !== ControlKind.Line) return false;
  return distanceToSegment(at, toScreen(points[0]!), toScreen(points[points.length - 1]!)) <= kBarPx;
}

/** Handles win over bars and areas; reaches are measured on the screen. */
export function grabAt(
  groups: readonly StudioGroup[],
  ground: GroundPoint,
  toScreen: ToScreen,
  grabbable: (control: ControlFrame, group: number) => Grabbable,
): Grab | null {
  const at = toScreen(ground);
  let handle: Candidate | null = null;
  let body: Grab | null = null;
  groups.forEach((group, index) => {
    for (const control of group.controls) {
      const part = grabbable(control, group.id);
      if (part === 'nothing') continue;
      const base = { index, group: group.id, control };
      const near = nearestHandle(base, at, toScreen);
      if (near && near.distance <= Math.min(kHandlePx, handle?.distance ?? kHandlePx)) handle = near;
      if (part === 'whole' && holdsBody(control, ground, at, toScreen)) {
        body = { ...base, touches: control.points.map(({ touch }) => touch) };
      }
    }
  });
  return (handle as Candidate | null)?.grab ?? body;
}
