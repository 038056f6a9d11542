// The canvas above the scene: controls, touch rings, previews, and the way of a chosen character.

import type { CameraController } from './camera_controller';
import type { GroundPoint, ScreenPoint } from './camera_types';
import type { ControlMarks, ShownControl } from './control_marks';
import { pathPoints, roundOrder, smooth, thinned } from './control_shapes';
import type { OverlayView } from './frame_types';
import { withAlpha } from './colour';
import { MarkPainter, type MarkColours } from './mark_painter';
import { accentOf, type Palette } from './palette';

export interface DraftControl {
  readonly group: number;
  readonly points: readonly GroundPoint[];
  readonly closed: boolean;
}

export interface MarkScene {
  readonly camera: CameraController;
  readonly palette: Palette;
  /** Accent index per group. */
  readonly colours: readonly number[];
  readonly paths: boolean;
  /** Draw controls in grey. */
  readonly greyed: boolean;
  readonly now: number;
  readonly draft: DraftControl | null;
  readonly overlay: OverlayView | null;
  readonly chosenGroup: number;
}

/** CSS px between two checkpoints shown. */
const kCheckpointGap = 30;

export class MarkLayer {
  readonly canvas: HTMLCanvasElement;
  private readonly painter_: MarkPainter;
  private width_ = 1;
  private height_ = 1;
  private ratio_ = 1;
  private drawn_ = true;

  constructor(root: HTMLElement) {
    this.canvas = document.createElement('canvas');
    this.canvas.className = 'marks';
    root.append(this.canvas);
    const pen = this.canvas.getContext('2d');
    if (!pen) throw new Error('This browser draws no 2D canvas.');
    this.painter_ = new MarkPainter(pen);
  }

  resize(width: number, height: number, ratio: number): void {
    this.width_ = width;
    this.height_ = height;
    this.ratio_ = ratio;
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
  }

  draw(marks: ControlMarks, scene: MarkScene): void {
    const controls = [...marks.controls];
    const busy = controls.length > 0 || marks.rings.size > 0 || scene.draft !== null || scene.overlay !== null;
    if (!busy && !this.drawn_) return;
    this.drawn_ = busy;
    // An empty canvas over the scene would still be blended with it.
    this.canvas.hidden = !busy;
    this.painter_.begin(this.width_, this.height_, this.ratio_);
    if (scene.overlay && scene.overlay.path.length >= 4) this.drawWay(scene.overlay.path, scene);
    for (const shown of controls) this.drawBody(shown, marks, scene);
    if (scene.paths) for (const shown of controls) this.drawPaths(shown, marks, scene);
    this.drawRings(marks, scene);
    for (const shown of controls) this.drawHandles(shown, marks, scene);
    if (scene.paths) for (const shown of controls) this.drawEnds(shown, marks, scene);
    if (scene.draft) this.drawDraft(scene.draft, scene);
    this.painter_.alpha = 1;
  }

  private coloursOf(group: number, scene: MarkScene): MarkColours {
    const accent = group < 0 ? scene.palette.ink2 : accentOf(scene.palette, scene.colours[group] ?? group);
    return { accent: scene.greyed ? scene.palette.obstacleEdge : accent, casing: scene.palette.casing };
  }

  private screen(points: readonly GroundPoint[], scene: MarkScene): ScreenPoint[] {
    return points.map((point) => scene.camera.worldToScreen(point.x, point.y));
  }

  private drawBody(shown: ShownControl, marks: ControlMarks, scene: MarkScene): void {
    const colours = this.coloursOf(shown.group, scene);
    const at = this.screen(shown.handles, scene);
    const left = marks.left(shown.ended, scene.now);
    const grown = marks.grown(shown.kindSince, scene.now, 120);
    if (shown.control.kind === 1 && at.length >= 2) {
      this.painter_.alpha = left;
      const [a, b] = [at[0] as ScreenPoint, at[1] as ScreenPoint];
      const end = { x: a.x + (b.x - a.x) * grown, y: a.y + (b.y - a.y) * grown };
      this.painter_.cased([a, end], colours, 5.5, 10);
    } else if (shown.control.kind === 2) {
      this.painter_.alpha = left * grown;
      this.painter_.hull(roundOrder(shown.handles).map((i) => at[i] as ScreenPoint), colours);
    }
    if (shown.control.kind === 0) return;
    const soft = shown.control.supplementary;
    for (let i = 0; i + 1 < soft.length; i += 2) {
      this.painter_.softPoint(scene.camera.worldToScreen(soft[i] ?? 0, soft[i + 1] ?? 0), colours);
    }
  }

  /** The way of one handle, up to the finger itself while it is down. */
  private way(shown: ShownControl, index: number, marks: ControlMarks): GroundPoint[] {
    const point = shown.control.points[index];
    const from = shown.handles[index];
    if (!point || !from) return [];
    const points = pathPoints(from, point.path);
    const last = points[points.length - 1] as GroundPoint;
    const finger = point.down && points.length > 1 ? marks.fingerNear(shown.group, last) : null;
    if (finger && Math.hypot(finger.x - last.x, finger.y - last.y) > 0.02) points.push(finger);
    return points;
  }

  private drawPaths(shown: ShownControl, marks: ControlMarks, scene: MarkScene): void {
    const colours = this.coloursOf(shown.group, scene);
    this.painter_.alpha = marks.left(shown.ended, scene.now);
    const ends: GroundPoint[] = [];
    shown.control.points.forEach((_, index) => {
      const points = this.way(shown, index, marks);
      if (points.length > 1) this.painter_.cased(this.screen(smooth(points, 5), scene), colours, 2.2, 5);
      const last = points[points.length - 1];
      if (last) ends.push(last);
    });
    const away = ends.some((end, i) => {
      const handle = shown.handles[i];
      return handle !== undefined && Math.hypot(end.x - handle.x, end.y - handle.y) > 0.4;
    });
    if (!away || shown.control.kind === 0 || ends.length < 2) return;
    const order = shown.control.kind === 2 ? roundOrder(shown.handles) : ends.map((_, i) => i);
    const ghost = this.screen(order.map((i) => ends[i] as GroundPoint), scene);
    this.painter_.dashed(ghost, withAlpha(colours.accent, 0.8), 2.2, shown.control.kind === 2);
  }

  private drawEnds(shown: ShownControl, marks: ControlMarks, scene: MarkScene): void {
    const colours = this.coloursOf(shown.group, scene);
    this.painter_.alpha = marks.left(shown.ended, scene.now);
    const gap = kCheckpointGap / Math.max(1, scene.camera.pixelsPerMetre());
    shown.control.points.forEach((point, index) => {
      const points = this.way(shown, index, marks);
      if (points.length < 2) return;
      const at = this.screen(points, scene);
      const kept = thinned(points, gap);
      kept.forEach((i, order) => this.painter_.checkpoint(at[i] as ScreenPoint, colours, order === 0));
      const last = at[at.length - 1] as ScreenPoint;
      const before = at[at.length - 2] as ScreenPoint;
      if (point.down) this.painter_.checkpoint(last, colours, true);
      else this.painter_.chevron(last, Math.atan2(last.y - before.y, last.x - before.x), colours);
    });
  }

  private drawHandles(shown: ShownControl, marks: ControlMarks, scene: MarkScene): void {
    const colours = this.coloursOf(shown.group, scene);
    const at = this.screen(shown.handles, scene);
    this.painter_.alpha = marks.left(shown.ended, scene.now);
    const size = 0.4 + 0.6 * marks.grown(shown.born, scene.now, 90);
    const [a, b] = [at[0], at[1]];
    const angle = a && b ? Math.atan2(b.y - a.y, b.x - a.x) : 0;
    for (const point of at) {
      if (shown.control.kind === 0) this.painter_.pointHandle(point, colours, size);
      else if (shown.control.kind === 1) this.painter_.lineHandle(point, angle, colours, size);
      else this.painter_.areaHandle(point, colours, size);
    }
  }

  private drawRings(marks: ControlMarks, scene: MarkScene): void {
    for (const ring of marks.rings.values()) {
      this.painter_.alpha = marks.left(ring.lifted, scene.now) * (ring.group < 0 ? 0.6 : 1);
      const size = 0.55 + 0.45 * marks.grown(ring.since, scene.now, 90);
      this.painter_.ring(scene.camera.worldToScreen(ring.at.x, ring.at.y), this.coloursOf(ring.group, scene), size);
    }
  }

  private drawDraft(draft: DraftControl, scene: MarkScene): void {
    const colours = this.coloursOf(draft.group, scene);
    const at = this.screen(draft.points, scene);
    this.painter_.alpha = 1;
    if (draft.closed) this.painter_.veil(at, colours.accent);
    this.painter_.dashed(at, colours.accent, 2.2, draft.closed);
  }

  private drawWay(path: ArrayLike<number>, scene: MarkScene): void {
    const accent = accentOf(scene.palette, scene.colours[scene.chosenGroup] ?? 0);
    const colours = { accent, casing: scene.palette.casing };
    const points: GroundPoint[] = [];
    for (let i = 0; i + 1 < path.length; i += 2) points.push({ x: path[i] ?? 0, y: path[i + 1] ?? 0 });
    this.painter_.alpha = 1;
    this.painter_.cased(this.screen(points, scene), colours, 3.4, 7.5);
    const ring = (centre: GroundPoint, radius: number): ScreenPoint[] => Array.from({ length: 40 }, (_, i) =>
      scene.camera.worldToScreen(centre.x + radius * Math.cos(i * 0.15708), centre.y + radius * Math.sin(i * 0.15708)));
    this.painter_.cased(ring(points[0] as GroundPoint, 0.55), colours, 3.4, 7.5, true);
    const last = points[points.length - 1] as GroundPoint;
    const place = ring(last, 0.5);
    this.painter_.cased(place, colours, 3.4, 7.5, true);
    this.painter_.checkpoint(scene.camera.worldToScreen(last.x, last.y), colours, true);
  }
}
