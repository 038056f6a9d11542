// The canvas above the scene: controls, touch rings, previews, and the path of a chosen character.

import { convexHull, distance, type GroundPoint, type ScreenPoint } from '../../model/plane';
import type { DraftControl } from './draft_control';
import type { MarkState, ShownControl, TouchRing } from './mark_state';
import { pathPoints, smooth, thinned } from './control_shapes';
import type { OverlayView } from '../../model/frame_view';
import { MarkExtent, type MarkBounds } from './mark_extent';
import { MarkPainter, type MarkColours } from './mark_painter';
import { OrderMarks, type OrderScene } from './order_marks';
import { accentColour, casingOf } from '../drawing/palette';
import { drawBarred, extendByBarred } from './barred_marks';
import { drawScheme, extendByScheme } from './scheme_marks';

export interface MarkScene extends OrderScene {
  readonly paths: boolean;
  /** True where a mark on the ground would lie over a figure. */
  covered(at: GroundPoint): boolean;
  readonly now: number;
  readonly drafts: readonly DraftControl[];
  readonly overlay: OverlayView | null;
  readonly chosenGroup: number;
}

/** CSS px between two checkpoints shown. */
const kCheckpointGap = 30;
/** None is shown so near its handle [CSS px]. */
const kHandleRoom = 18;
/** A director's name stands so far below the finger, because the kind of its control is named above [CSS px]. */
const kNameBelow = 46;
/** Half of the longest name [CSS px]. */
const kNameRoom = 170;
/** Handles that the world has not answered yet are pale. */
const kDraftAlpha = 0.55;

export class MarkLayer {
  readonly canvas: HTMLCanvasElement;
  private readonly painter_: MarkPainter;
  private readonly orders_: OrderMarks;
  private width_ = 1;
  private height_ = 1;
  private ratio_ = 1;
  /** What the canvas covers now; null where it is hidden. */
  private bounds_: MarkBounds | null = null;
  /** Checkpoints shown last, by path. */
  private dots_: ReadonlyMap<string, readonly GroundPoint[]> = new Map();

  constructor(root: HTMLElement) {
    this.canvas = document.createElement('canvas');
    this.canvas.className = 'marks';
    root.append(this.canvas);
    const pen = this.canvas.getContext('2d');
    if (!pen) throw new Error('This browser draws no 2D canvas.');
    this.painter_ = new MarkPainter(pen);
    this.orders_ = new OrderMarks(this.painter_);
  }

  resize(width: number, height: number, ratio: number): void {
    this.width_ = width;
    this.height_ = height;
    this.ratio_ = ratio;
    this.bounds_ = null;
  }

  draw(marks: MarkState, scene: MarkScene): void {
    const controls = [...marks.controls];
    if (!this.cover(this.extentOf(controls, marks, scene))) return;
    this.painter_.begin(this.bounds_ as MarkBounds, this.ratio_, this.width_);
    if (scene.overlay && scene.overlay.path.length >= 4) this.drawChosenPath(scene.overlay.path, scene);
    this.orders_.draw(scene);
    drawBarred(this.painter_, scene.barred, scene);
    if (scene.scheme) drawScheme(this.painter_, scene.scheme, scene);
    for (const shown of controls) this.drawBody(shown, marks, scene);
    if (scene.paths) for (const shown of controls) this.drawPaths(shown, marks, scene);
    this.drawRings(marks, scene);
    for (const shown of controls) this.drawHandles(shown, marks, scene);
    const dots = new Map<string, readonly GroundPoint[]>();
    if (scene.paths) for (const shown of controls) this.drawEnds(shown, marks, scene, dots);
    this.dots_ = dots;
    for (const draft of scene.drafts) this.drawDraft(draft, scene);
    this.painter_.alpha = 1;
    this.drawCursor(marks, scene);
  }

  private extentOf(controls: readonly ShownControl[], marks: MarkState, scene: MarkScene): MarkExtent {
    const extent = new MarkExtent();
    const add = (x: number, y: number): void => extent.add(scene.camera.worldToScreen(x, y));
    const addAll = (pairs: ArrayLike<number>): void => {
      for (let i = 0; i + 1 < pairs.length; i += 2) add(pairs[i] ?? 0, pairs[i + 1] ?? 0);
    };
    for (const { control, handles } of controls) {
      for (const handle of handles) add(handle.x, handle.y);
      addAll(control.supplementary);
      if (scene.paths) for (const point of control.points) addAll(point.path);
    }
    for (const ring of marks.rings.values()) add(ring.at.x, ring.at.y);
    for (const ring of marks.others.values()) {
      const at = scene.camera.worldToScreen(ring.at.x, ring.at.y);
      for (const dx of [-kNameRoom, kNameRoom]) extent.add({ x: at.x + dx, y: at.y + kNameBelow });
      extent.add(at);
    }
    if (scene.cursor) add(scene.cursor.x, scene.cursor.y);
    for (const { points, handles } of scene.drafts) for (const point of [...points, ...handles]) add(point.x, point.y);
    addAll(scene.overlay?.path ?? []);
    this.orders_.extend(extent, scene);
    extendByBarred(extent, scene.barred, scene);
    if (scene.scheme) extendByScheme(extent, scene.scheme, scene);
    return extent;
  }

  /** Lays the canvas over what is to be drawn; false, hiding it, where there is nothing. */
  private cover(extent: MarkExtent): boolean {
    const bounds = extent.bounds(this.width_, this.height_, this.bounds_);
    this.canvas.hidden = bounds === null;
    if (bounds !== null && bounds !== this.bounds_) {
      this.canvas.width = Math.round(bounds.width * this.ratio_);
      this.canvas.height = Math.round(bounds.height * this.ratio_);
      const { style } = this.canvas;
      [style.width, style.height] = [`${bounds.width}px`, `${bounds.height}px`];
      style.transform = `translate(${bounds.x}px, ${bounds.y}px)`;
    }
    this.bounds_ = bounds;
    return bounds !== null;
  }

  private coloursOf(group: number, scene: MarkScene): MarkColours {
    const accent = group < 0 ? scene.palette.ink2 : accentColour(scene.palette, scene.colours[group] ?? group);
    if (scene.greyed) return { accent: scene.palette.obstacleEdge, casing: scene.palette.casing };
    return { accent, casing: casingOf(scene.palette, accent) };
  }

  private screen(points: readonly GroundPoint[], scene: MarkScene): ScreenPoint[] {
    return points.map((point) => scene.camera.worldToScreen(point.x, point.y));
  }

  private drawBody(shown: ShownControl, marks: MarkState, scene: MarkScene): void {
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
      this.painter_.hull(this.screen(convexHull(shown.handles), scene), colours);
    }
    if (shown.control.kind === 0) return;
    const soft = shown.control.supplementary;
    for (let i = 0; i + 1 < soft.length; i += 2) {
      const at = { x: soft[i] ?? 0, y: soft[i + 1] ?? 0 };
      if (!scene.covered(at)) this.painter_.softPoint(scene.camera.worldToScreen(at.x, at.y), colours);
    }
  }

  /** The path of one handle, up to the finger itself while it is down. */
  private pathOf(shown: ShownControl, index: number, marks: MarkState): GroundPoint[] {
    const point = shown.control.points[index];
    const from = shown.handles[index];
    if (!point || !from) return [];
    const points = pathPoints(from, point.path);
    const finger = point.down && points.length > 1 ? marks.fingerOf(shown.control.client, point.touch) : null;
    // The last point is where the finger was when the server heard of it.
    if (finger) points[points.length - 1] = finger;
    return points;
  }

  private drawPaths(shown: ShownControl, marks: MarkState, scene: MarkScene): void {
    const colours = this.coloursOf(shown.group, scene);
    this.painter_.alpha = marks.left(shown.ended, scene.now);
    const ends: GroundPoint[] = [];
    shown.control.points.forEach((_, index) => {
      const points = this.pathOf(shown, index, marks);
      if (points.length > 1) this.painter_.cased(this.screen(smooth(points, 5), scene), colours, 2.2, 5);
      const last = points[points.length - 1];
      if (last) ends.push(last);
    });
    const away = ends.some((end, i) => {
      const handle = shown.handles[i];
      return handle !== undefined && Math.hypot(end.x - handle.x, end.y - handle.y) > 0.4;
    });
    if (!away || shown.control.kind === 0 || ends.length < 2) return;
    const ghost = this.screen(shown.control.kind === 2 ? convexHull(ends) : ends, scene);
    this.painter_.dashed(ghost, colours.accent, 2.2, shown.control.kind === 2, colours.casing);
  }

  private drawEnds(
    shown: ShownControl,
    marks: MarkState,
    scene: MarkScene,
    dots: Map<string, readonly GroundPoint[]>,
  ): void {
    const colours = this.coloursOf(shown.group, scene);
    this.painter_.alpha = marks.left(shown.ended, scene.now);
    const gap = kCheckpointGap / Math.max(1, scene.camera.pixelsPerMetre());
    shown.control.points.forEach((point, index) => {
      const points = this.pathOf(shown, index, marks);
      if (points.length < 2) return;
      const at = this.screen(points, scene);
      const key = `${shown.group}:${shown.control.id}:${point.touch}`;
      const shownPoints = thinned(points, gap, this.dots_.get(key));
      dots.set(
        key,
        shownPoints.map((i) => points[i] as GroundPoint),
      );
      const clear = shownPoints.filter(
        (i) => distance(at[i] as ScreenPoint, at[0] as ScreenPoint) > kHandleRoom && !scene.covered(points[i]!),
      );
      clear.forEach((i, order) => this.painter_.checkpoint(at[i] as ScreenPoint, colours, order === 0));
      const last = at[at.length - 1] as ScreenPoint;
      const before = at[at.length - 2] as ScreenPoint;
      if (point.down) this.painter_.checkpoint(last, colours, true);
      else this.painter_.chevron(last, Math.atan2(last.y - before.y, last.x - before.x), colours);
    });
  }

  private drawHandles(shown: ShownControl, marks: MarkState, scene: MarkScene): void {
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
      if (shown.control.pinned) this.painter_.pin(point, colours, scene.palette.ink);
    }
  }

  private drawRings(marks: MarkState, scene: MarkScene): void {
    for (const ring of marks.rings.values()) this.drawRing(ring, this.coloursOf(ring.group, scene), marks, scene);
    const named = new Set<number>();
    for (const [key, ring] of marks.others) {
      const client = Number.parseInt(key, 10);
      const director = marks.directors.get(client);
      const colours = this.coloursOf(ring.group, scene);
      const at = this.drawRing(ring, director ? { ...colours, accent: director.colour } : colours, marks, scene);
      if (!director || named.has(client)) continue;
      named.add(client);
      this.painter_.label({ x: at.x, y: at.y + kNameBelow }, director.name, director.colour, '#ffffff');
    }
  }

  private drawRing(ring: TouchRing, colours: MarkColours, marks: MarkState, scene: MarkScene): ScreenPoint {
    this.painter_.alpha = marks.left(ring.lifted, scene.now) * (ring.group < 0 ? 0.6 : 1);
    const at = scene.camera.worldToScreen(ring.at.x, ring.at.y);
    this.painter_.ring(at, colours, 0.55 + 0.45 * marks.grown(ring.since, scene.now, 90));
    return at;
  }

  /** In its director's colour. */
  private drawCursor({ directors, client }: MarkState, { cursor, camera, palette }: MarkScene): void {
    const accent = directors.get(client)?.colour ?? palette.ink;
    if (cursor) this.painter_.cursor(camera.worldToScreen(cursor.x, cursor.y), { accent, casing: '#ffffff' });
  }

  private drawDraft(draft: DraftControl, scene: MarkScene): void {
    const colours = this.coloursOf(draft.group, scene);
    const at = this.screen(draft.points, scene);
    this.painter_.alpha = 1;
    if (draft.closed) this.painter_.veil(at, colours.accent);
    this.painter_.dashed(at, colours.accent, 2.2, draft.closed, colours.casing);
    this.painter_.alpha = kDraftAlpha;
    for (const handle of this.screen(draft.handles, scene)) this.painter_.pointHandle(handle, colours, 1);
  }

  private drawChosenPath(path: ArrayLike<number>, scene: MarkScene): void {
    const accent = accentColour(scene.palette, scene.colours[scene.chosenGroup] ?? 0);
    const colours = { accent, casing: casingOf(scene.palette, accent) };
    const points: GroundPoint[] = [];
    for (let i = 0; i + 1 < path.length; i += 2) points.push({ x: path[i] ?? 0, y: path[i + 1] ?? 0 });
    this.painter_.alpha = 1;
    this.painter_.cased(this.screen(points, scene), colours, 3.4, 7.5);
    const ring = (centre: GroundPoint, radius: number): ScreenPoint[] =>
      Array.from({ length: 40 }, (_, i) =>
        scene.camera.worldToScreen(
          centre.x + radius * Math.cos(i * 0.15708),
          centre.y + radius * Math.sin(i * 0.15708),
        ),
      );
    this.painter_.cased(ring(points[0] as GroundPoint, 0.55), colours, 3.4, 7.5, true);
    const last = points[points.length - 1] as GroundPoint;
    const place = ring(last, 0.5);
    this.painter_.cased(place, colours, 3.4, 7.5, true);
    this.painter_.checkpoint(scene.camera.worldToScreen(last.x, last.y), colours, true);
  }
}
