// People who cannot be in their places, and these places: a ring, a cross, and a line between them.

import type { GroundPoint } from '../../model/plane';
import type { CameraController } from '../camera/camera_controller';
import type { Palette } from '../drawing/palette';
import type { MarkExtent } from './mark_extent';
import type { MarkPainter } from './mark_painter';
import type { CrowdPlaces } from './scheme_marks';

/** Somebody, and where its formation wants it. */
export interface BarredPerson {
  /** Of a character. */
  readonly id: number;
  readonly place: GroundPoint;
}

/** The same, with the person where the next picture shows it. */
export interface BarredPicture {
  readonly person: GroundPoint;
  readonly place: GroundPoint;
}

interface Scene {
  readonly camera: CameraController;
  readonly palette: Palette;
}

const kCross = 5;
const kRing = 0.4;
/** Who is nearer to its place than this has no line to it [m]. */
const kNear = 0.3;

export function barredPicture(barred: readonly BarredPerson[], crowd: CrowdPlaces): BarredPicture[] {
  if (barred.length === 0) return [];
  const places = new Map(barred.map(({ id, place }) => [id, place]));
  const picture: BarredPicture[] = [];
  for (let i = 0; i < crowd.ids.length; ++i) {
    const place = places.get(crowd.ids[i]!);
    if (!place) continue;
    picture.push({ person: { x: crowd.positions[2 * i] ?? 0, y: crowd.positions[2 * i + 1] ?? 0 }, place });
  }
  return picture;
}

export function extendByBarred(extent: MarkExtent, barred: readonly BarredPicture[], { camera }: Scene): void {
  for (const { person, place } of barred)
    for (const { x, y } of [person, place]) extent.add(camera.worldToScreen(x, y));
}

export function drawBarred(painter: MarkPainter, barred: readonly BarredPicture[], { camera, palette }: Scene): void {
  const colours = { accent: palette.alarm, casing: palette.casing };
  painter.alpha = 1;
  for (const { person, place } of barred) {
    const [from, to] = [camera.worldToScreen(person.x, person.y), camera.worldToScreen(place.x, place.y)];
    painter.ring(from, colours, kRing);
    if (Math.hypot(place.x - person.x, place.y - person.y) < kNear) continue;
    painter.dashed([from, to], colours.accent, 1.2, false);
    painter.cross(to, colours, kCross);
  }
}
