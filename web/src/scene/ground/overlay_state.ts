// The overlay on show: its field as the ground draws it, its scale, and the numbers of its contours.

import type { FieldScale } from '../../model/field_scale';
import type { OverlayView } from '../../model/frame_view';
import { contourLabels, type ContourLabel, type FieldRaster, makeFieldRaster } from './field_raster';

/** Kind of the overlay that shows one character's cost. */
const kCost = 2;
/**
 * Contours are numbered along a ray from the place towards the upper left of the view: its angle to the camera's
 * [rad].
 */
const kLabelAngle = 2.75;

export class OverlayState {
  private overlay_: OverlayView | null = null;
  private raster_: FieldRaster | null = null;
  private contours_: readonly ContourLabel[] = [];

  /** Null where nothing is shown. */
  get overlay(): OverlayView | null {
    return this.overlay_;
  }

  get raster(): FieldRaster | null {
    return this.raster_;
  }

  get scale(): FieldScale | null {
    return this.raster_?.scale ?? null;
  }

  get contours(): readonly ContourLabel[] {
    return this.contours_;
  }

  /** Id of the character whose cost is shown; -1 for none. */
  get character(): number {
    return this.overlay_?.kind === kCost ? this.overlay_.character : -1;
  }

  /** Shows an overlay, or none; `turn` of the camera [rad]. True where other characters are greyed than before. */
  set(overlay: OverlayView | null, turn: number): boolean {
    const shown = overlay && overlay.kind !== 0 && overlay.width * overlay.height > 0 ? overlay : null;
    const changed = (shown === null) !== (this.overlay_ === null) || shown?.character !== this.overlay_?.character;
    this.overlay_ = shown;
    this.raster_ = shown ? makeFieldRaster(shown) : null;
    this.contours_ =
      shown && this.raster_ && shown.kind === kCost ? contourLabels(shown, this.raster_.scale, turn + kLabelAngle) : [];
    return changed;
  }
}
