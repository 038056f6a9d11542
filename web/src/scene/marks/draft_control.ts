// What fingers have drawn and no frame shows yet.

import type { GroundPoint } from '../../model/plane';

/** A dashed line or outline, with handles. */
export interface DraftControl {
  /** Index into the frame's groups. */
  readonly group: number;
  readonly points: readonly GroundPoint[];
  readonly closed: boolean;
  readonly handles: readonly GroundPoint[];
}
