// What of the controls on the meshes a contact takes hold of: an end, a bar, or a whole area.

import { ControlKind, type ControlFrame, type GroupFrame } from '../protocol/messages';
import type { GroundPoint } from '../view/camera_types';
import { convexHull, distance, distanceToSegment, insidePolygon } from './ground_geometry';

export interface Grab {
  /** Index into the frame's groups. */
  readonly index: number;
  readonly group: number;
  readonly control: ControlFrame;
  /** Indices of the control's points that follow the contact. */
  readonly points: readonly number[];
}

/** How much of a control may be grabbed. */
export type Grabbable = 'nothing' | 'handles' | 'whole';

interface Candidate {
  readonly grab: Grab;
  readonly distance: number;
}

function nearestHandle(grab: Omit<Grab, 'points'>, at: GroundPoint): Candidate | null {
  let best: Candidate | null = null;
  grab.control.points.forEach((point, i) => {
    const away = distance(point, at);
    if (best === null || away < best.distance) best = { grab: { ...grab, points: [i] }, distance: away };
  });
  return best;
}

function holdsBody(control: ControlFrame, at: GroundPoint, reach: number): boolean {
  const points = control.points;
  if (control.kind === ControlKind.Line) return distanceToSegment(at, points[0]!, points[points.length - 1]!) <= reach / 2;
  return control.kind === ControlKind.Area && insidePolygon(at, convexHull(points));
}

/** Handles win over bars and areas; `reach` [m] is that of a handle. */
export function grabAt(
  groups: readonly GroupFrame[],
  at: GroundPoint,
  reach: number,
  grabbable: (control: ControlFrame) => Grabbable,
): Grab | null {
  let handle: Candidate | null = null;
  let body: Grab | null = null;
  groups.forEach((group, index) => {
    for (const control of group.controls) {
      const part = grabbable(control);
      if (part === 'nothing') continue;
      const base = { index, group: group.id, control };
      const near = nearestHandle(base, at);
      if (near && near.distance <= Math.min(reach, handle?.distance ?? reach)) handle = near;
      if (part === 'whole' && holdsBody(control, at, reach)) body = { ...base, points: control.points.map((_, i) => i) };
    }
  });
  return (handle as Candidate | null)?.grab ?? body;
}
