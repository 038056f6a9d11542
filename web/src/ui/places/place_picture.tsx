// A place as a small drawing, in the colours of the theme.

import type { VNode } from 'preact';
import type { PlaceDrawing } from '../../model/place_files/place_drawing';
import { accentVariable } from '../widgets/group_marks';

export interface PlacePictureProps {
  readonly drawing: PlaceDrawing;
  /** Another place behind it, faintly; its box counts then. */
  readonly present?: PlaceDrawing | null;
}

export function PlacePicture({ drawing, present = null }: PlacePictureProps): VNode {
  const [x, y, width, height] = (present ?? drawing).viewBox;
  const margin = 0.03 * Math.max(width, height);
  const box = [x - margin, y - margin, width + 2 * margin, height + 2 * margin].join(' ');
  return (
    <svg viewBox={box} class="place-drawing" aria-hidden="true">
      <rect {...{ x, y, width, height }} class="drawn-ground" />
      {present && <path d={present.patches + present.obstacles} class="drawn-present" />}
      <path d={drawing.patches} class="drawn-patches" />
      <path d={drawing.obstacles} class="drawn-obstacles" />
      {drawing.groups.map((shape, i) => (
        <path key={i} d={shape} class="drawn-group" style={{ color: accentVariable(drawing.colours[i] ?? i) }} />
      ))}
    </svg>
  );
}
