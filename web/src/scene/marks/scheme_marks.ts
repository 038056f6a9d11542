// What a control scheme shows: who is selected, the box, the stroke and the goals, and in replays what is down.

import { convexHull, type GroundPoint, type ScreenPoint } from '../../model/plane';
import type { CameraController } from '../camera/camera_controller';
import { accentColour, casingOf, type Palette } from '../drawing/palette';
import type { MarkExtent } from './mark_extent';
import type { MarkPainter } from './mark_painter';

/** As the server tells it; all points on the ground. */
export interface SchemeView {
  /** Ids of characters. */
  readonly selected: ReadonlySet<number>;
  readonly rectangle: readonly GroundPoint[];
  readonly stroke: readonly GroundPoint[];
  readonly goals: readonly GroundPoint[];
  readonly pointers: readonly GroundPoint[];
}

/** The same, with the selected characters where the next picture shows them. */
export interface SchemePicture extends Omit<SchemeView, 'selected'> {
  readonly selected: readonly SelectedCharacter[];
}

export interface SelectedCharacter extends GroundPoint {
  readonly radius: number;
}

/** Where everybody is. */
export interface CrowdPlaces {
  readonly ids: ArrayLike<number>;
  /** x, y of each. */
  readonly positions: ArrayLike<number>;
  readonly radius: ArrayLike<number>;
}

interface SchemeScene {
  readonly camera: CameraController;
  readonly palette: Palette;
  readonly colours: readonly number[];
}

/** A ring stands so far outside a body [m], and is at least so large [CSS px]. */
const kRingGap = 0.12;
const kLeastRing = 5;
const kGoal = 0.45;
const kCorners = 20;

export function schemePicture(view: SchemeView, crowd: CrowdPlaces): SchemePicture {
  const selected: SelectedCharacter[] = [];
  if (view.selected.size > 0) {
    for (let i = 0; i < crowd.ids.length; ++i) {
      if (!view.selected.has(crowd.ids[i]!)) continue;
      selected.push({
        x: crowd.positions[2 * i] ?? 0,
        y: crowd.positions[2 * i + 1] ?? 0,
        radius: crowd.radius[i] ?? 0.25,
      });
    }
  }
  return { ...view, selected };
}

export function extendByScheme(extent: MarkExtent, picture: SchemePicture, { camera }: SchemeScene): void {
  const { selected, rectangle, stroke, goals, pointers } = picture;
  for (const list of [selected, rectangle, stroke, goals, pointers])
    for (const { x, y } of list) extent.add(camera.worldToScreen(x, y));
}

function ring(centre: GroundPoint, radius: number, camera: CameraController): ScreenPoint[] {
  const metres = Math.max(radius, kLeastRing / Math.max(1, camera.pixelsPerMetre()));
  return Array.from({ length: kCorners }, (_, i) => {
    const angle = (2 * Math.PI * i) / kCorners;
    return camera.worldToScreen(centre.x + metres * Math.cos(angle), centre.y + metres * Math.sin(angle));
  });
}

export function drawScheme(painter: MarkPainter, picture: SchemePicture, scene: SchemeScene): void {
  const { camera, palette } = scene;
  const accent = accentColour(palette, scene.colours[0] ?? 0);
  const colours = { accent, casing: casingOf(palette, accent) };
  const screen = (points: readonly GroundPoint[]): ScreenPoint[] =>
    points.map(({ x, y }) => camera.worldToScreen(x, y));
  painter.alpha = 1;
  for (const one of picture.selected) painter.cased(ring(one, one.radius + kRingGap, camera), colours, 1.8, 3.8, true);
  if (picture.rectangle.length > 2) {
    const corners = screen(convexHull(picture.rectangle));
    painter.veil(corners, colours.accent);
    painter.dashed(corners, colours.accent, 2.2, true);
  }
  if (picture.stroke.length > 1) painter.cased(screen(picture.stroke), colours, 2.2, 5);
  picture.goals.forEach((goal, i) => {
    if (i > 0) painter.dashed(screen([picture.goals[i - 1]!, goal]), colours.accent, 1.8, false);
    painter.cased(ring(goal, kGoal, camera), colours, 2.2, 5, true);
    painter.checkpoint(camera.worldToScreen(goal.x, goal.y), colours, true);
  });
  for (const pointer of picture.pointers) painter.ring(camera.worldToScreen(pointer.x, pointer.y), colours, 1);
}
