// The scene: everything that is drawn from the world's frames, and the camera that looks at it.

import './view.css';
import type { SceneFacts } from '../protocol/scene';
import { CameraController } from './camera_controller';
import { BoundsBuilder } from './bounds_builder';
import type { CameraControls, GroundPoint, Padding, ScreenPoint } from './camera_types';
import { ControlMarks } from './control_marks';
import { CrowdState } from './crowd_state';
import { contourLabels, type ContourLabel, type FieldScale, makeFieldPicture } from './field_picture';
import { FrameTimeline } from './frame_timeline';
import type { FrameView, GroupMeshView, MovingView, Numbers, OverlayView } from './frame_types';
import { GroupPicture } from './group_picture';
import { type DraftControl, MarkLayer } from './mark_layer';
import { surroundings } from './opening';
import { accentOf, type Palette, paletteOf } from './palette';
import { pickCharacter, pickHandle, pickMesh } from './picker';
import { chooseQuality, rendererName } from './quality';
import { chipTags, overlayTags, patchTags, type TagScene } from './scene_tags';
import { Stage } from './stage';
import { TagLayer } from './tag_layer';

export type Theme = 'light' | 'dark';

export interface Layers {
  readonly mesh: boolean;
  readonly places: boolean;
  readonly paths: boolean;
}

export interface ViewStats {
  drawCalls: number;
  triangles: number;
  /** JavaScript time of the last frame [ms]. */
  frameMs: number;
  /** Frames rendered. */
  frames: number;
  /** Number of the server frame whose controls, meshes and places the last picture shows; 0 before the first.
   * Characters run about a frame behind. */
  shownFrame: number;
}

/** The contract; tools and panels hold no more than this. */
export interface StudioScene {
  readonly camera: CameraControls;
  readonly stats: ViewStats;
  /** Replaces the world; the next frame opens the view on the crowd. */
  setScene(scene: SceneFacts): void;
  setGroupMesh(mesh: GroupMeshView): void;
  /** `receivedAt` by performance.now() [ms]. */
  pushFrame(frame: FrameView, receivedAt: number): void;
  /** Shows one field over the ground and greys all else; null takes it away. */
  setOverlay(overlay: OverlayView | null): void;
  setLayers(layers: Layers): void;
  setTheme(theme: Theme): void;
  setReducedMotion(reduced: boolean): void;
  /** Greys the scene while the server is lost. */
  setLost(lost: boolean): void;
  /** The group whose panels are open (index into the scene's groups), or -1. */
  setActiveGroup(index: number): void;
  /** What panels cover; fits keep clear of it. */
  setPadding(padding: Padding): void;
  /** A ring under a finger in the very next frame; null lets it fade. A group of -1 means the camera. */
  touchMark(id: number, world: GroundPoint | null, groupIndex: number): void;
  /** Places of a formation to come (x, y pairs in the world), dashed; null takes them away. */
  previewFormation(groupIndex: number, places: ArrayLike<number> | null): void;
  /** A rubber band or lasso being drawn; null takes it away. */
  previewControl(groupIndex: number, points: readonly GroundPoint[] | null, closed: boolean): void;
  /** Client coordinates to the ground, with what stands there: nearest character within 0.6 m, group of the mesh. */
  pick(clientX: number, clientY: number): Pick | null;
  screenToWorld(at: ScreenPoint): GroundPoint | null;
  worldToScreen(point: GroundPoint): ScreenPoint;
  /** Fits crowd and paths between the panels. */
  fitCrowd(): void;
  /** CSS px that a metre on the ground takes in the middle of the view. */
  pixelsPerMetre(): number;
  dispose(): void;
}

export interface Pick {
  readonly ground: GroundPoint;
  /** Id of the nearest character, or -1. */
  readonly character: number;
  /** Index of the group whose mesh holds the point (within 48 px), or -1. */
  readonly group: number;
  /** A control whose handle catches the point (48 px), or null. */
  readonly control: { readonly group: number; readonly control: number; readonly touch: number } | null;
}

/** Rendering goes on this long after the last change, for what settles [ms]. */
const kSettle = 700;
const kNoFrame: readonly MovingView[] = [];

/** Draws the world once per display frame: controls and meshes of the newest frame, characters between the last two. */
export class StudioView implements StudioScene {
  readonly camera = new CameraController();
  readonly stats: ViewStats = { drawCalls: 0, triangles: 0, frameMs: 0, frames: 0, shownFrame: 0 };
  private readonly stage_: Stage;
  private readonly marks_ = new ControlMarks();
  private readonly markLayer_: MarkLayer;
  private readonly tagLayer_: TagLayer;
  private readonly timeline_ = new FrameTimeline();
  private readonly crowd_ = new CrowdState();
  private readonly groups_ = new GroupPicture();
  private readonly previews_ = new Map<number, ArrayLike<number>>();
  private readonly observer_: ResizeObserver;
  private scene_: SceneFacts | null = null;
  private palette_: Palette = paletteOf('light');
  private theme_: Theme = 'light';
  private layers_: Layers = { mesh: true, places: true, paths: true };
  private overlay_: OverlayView | null = null;
  private contours_: readonly ContourLabel[] = [];
  private fieldScale_: FieldScale | null = null;
  private draft_: DraftControl | null = null;
  private padding_: Padding = { top: 84, right: 24, bottom: 120, left: 24 };
  private moving_: readonly MovingView[] = kNoFrame;
  private reduced_ = false;
  private activeGroup_ = -1;
  private opened_ = false;
  private membersStale_ = true;
  /** The next picture answers a finger. */
  private urgent_ = false;
  private touchEcho_ = 0;
  private last_ = 0;
  private activeUntil_ = 0;
  private signature_ = '';
  private request_ = 0;

  constructor(private readonly canvas_: HTMLCanvasElement, private readonly overlayRoot_: HTMLElement) {
    this.stage_ = new Stage(canvas_, chooseQuality(location.search, rendererName));
    this.markLayer_ = new MarkLayer(overlayRoot_);
    this.tagLayer_ = new TagLayer(overlayRoot_);
    this.observer_ = new ResizeObserver(() => this.resize());
    this.observer_.observe(canvas_);
    this.stage_.setPalette(this.palette_);
    this.resize();
    this.request_ = requestAnimationFrame((now) => this.frame(now));
  }

  /** The scale of the overlay on show, for its legend; null without one. */
  get fieldScale(): FieldScale | null {
    return this.fieldScale_;
  }

  setScene(scene: SceneFacts): void {
    this.scene_ = scene;
    this.timeline_.clear();
    this.crowd_.clear();
    this.crowd_.setClips(scene.clips.map((clip) => clip.name));
    this.groups_.clear();
    this.previews_.clear();
    this.marks_.clear();
    this.moving_ = kNoFrame;
    this.membersStale_ = true;
    this.opened_ = false;
    this.stage_.setScene(scene, this.palette_);
    this.camera.setWorld(scene.box.min[0], scene.box.min[1], scene.box.max[0], scene.box.max[1]);
    this.camera.open();
    this.setOverlay(null);
  }

  setGroupMesh(mesh: GroupMeshView): void {
    this.groups_.setMesh(mesh);
    this.wake();
  }

  pushFrame(frame: FrameView, receivedAt: number): void {
    if (frame.ids.length > 0 && !sameNumbers(frame.ids, this.crowd_.ids, frame.group, this.crowd_.group)) {
      this.crowd_.setMembers(frame.ids, frame.group);
      this.membersStale_ = true;
    } else if (frame.x.length === 0 && this.crowd_.count > 0) {
      this.crowd_.setMembers([], []);
      this.membersStale_ = true;
    }
    this.timeline_.push(frame, receivedAt);
    this.urgent_ ||= (frame.touchEcho ?? 0) > this.touchEcho_;
    this.touchEcho_ = frame.touchEcho ?? 0;
    // Where drawing is slow the answer to a finger does not wait for the display's next beat as well.
    if (this.urgent_ && this.stage_.paced) this.draw(performance.now());
  }

  setOverlay(overlay: OverlayView | null): void {
    const shown = overlay && overlay.kind !== 0 && overlay.width * overlay.height > 0 ? overlay : null;
    const changed = (shown === null) !== (this.overlay_ === null) || shown?.character !== this.overlay_?.character;
    this.overlay_ = shown;
    const picture = shown ? makeFieldPicture(shown) : null;
    this.fieldScale_ = picture?.scale ?? null;
    // Numbers run from the place towards the upper left of the view.
    this.contours_ = shown && picture && shown.kind === 2
      ? contourLabels(shown, picture.scale, this.camera.pose.turn + 2.75) : [];
    this.stage_.setField(picture);
    this.stage_.world.floorsVisible = picture === null;
    this.membersStale_ ||= changed;
    this.wake();
  }

  setLayers(layers: Layers): void {
    this.layers_ = layers;
    this.wake();
  }

  setTheme(theme: Theme): void {
    this.theme_ = theme;
    this.palette_ = paletteOf(theme);
    this.overlayRoot_.dataset['theme'] = theme;
    this.stage_.setPalette(this.palette_);
    if (this.scene_) this.stage_.setScene(this.scene_, this.palette_);
    this.membersStale_ = true;
    this.wake();
  }

  setReducedMotion(reduced: boolean): void {
    this.reduced_ = reduced;
    this.marks_.reducedMotion = reduced;
  }

  setLost(lost: boolean): void {
    for (const element of [this.canvas_, this.overlayRoot_]) element.classList.toggle('scene-lost', lost);
  }

  setActiveGroup(index: number): void {
    this.activeGroup_ = index;
    this.wake();
  }

  setPadding(padding: Padding): void {
    this.padding_ = padding;
  }

  touchMark(id: number, world: GroundPoint | null, groupIndex: number): void {
    this.marks_.touch(id, world, groupIndex, performance.now());
    this.urgent_ = true;
    this.wake();
  }

  previewFormation(groupIndex: number, places: ArrayLike<number> | null): void {
    if (places) this.previews_.set(groupIndex, places);
    else this.previews_.delete(groupIndex);
    this.wake();
  }

  previewControl(groupIndex: number, points: readonly GroundPoint[] | null, closed: boolean): void {
    this.draft_ = points ? { group: groupIndex, points, closed } : null;
    this.wake();
  }

  pick(clientX: number, clientY: number): Pick | null {
    const bounds = this.canvas_.getBoundingClientRect();
    const at = { x: clientX - bounds.left, y: clientY - bounds.top };
    const ground = this.camera.screenToGround(at);
    if (!ground) return null;
    const index = pickCharacter(at, this.crowd_, this.camera);
    return {
      ground,
      character: index < 0 ? -1 : this.crowd_.ids[index] ?? -1,
      group: pickMesh(at, this.groups_.targets(), this.camera),
      control: pickHandle(at, this.marks_.controls, this.camera),
    };
  }

  screenToWorld(at: ScreenPoint): GroundPoint | null {
    return this.camera.screenToGround(at);
  }

  worldToScreen(point: GroundPoint): ScreenPoint {
    return this.camera.worldToScreen(point.x, point.y);
  }

  fitCrowd(): void {
    this.camera.glideFit(this.crowdPoints(), this.padding_, performance.now(), this.reduced_ ? 0 : 260);
  }

  pixelsPerMetre(): number {
    return this.camera.pixelsPerMetre();
  }

  dispose(): void {
    cancelAnimationFrame(this.request_);
    this.observer_.disconnect();
    this.stage_.dispose();
    this.overlayRoot_.replaceChildren();
  }

  private wake(): void {
    this.activeUntil_ = performance.now() + kSettle;
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.canvas_;
    this.camera.resize(clientWidth, clientHeight);
    this.stage_.resize(clientWidth, clientHeight);
    this.markLayer_.resize(clientWidth, clientHeight, this.stage_.pixelRatio);
    this.wake();
  }

  private frame(now: number): void {
    this.request_ = requestAnimationFrame((next) => this.frame(next));
    this.draw(now);
  }

  private draw(now: number): void {
    const start = performance.now();
    if (!this.changed(now) || this.stage_.busy(this.urgent_)) return;
    this.urgent_ = false;
    const dt = Math.min(0.1, Math.max(0, (now - this.last_) / 1000));
    this.last_ = now;
    const blend = this.timeline_.sample(now);
    if (blend) {
      this.crowd_.update(blend, dt);
      this.moving_ = blend.to.moving;
      this.stage_.world.move(blend.from.moving, blend.to.moving, blend.alpha);
      this.stage_.world.setCollected(blend.to.collected);
      this.openView();
    }
    const newest = this.timeline_.newest;
    this.groups_.update(newest?.groups ?? []);
    this.marks_.update(newest?.groups ?? [], now);
    this.show(now);
    this.stats.frameMs = performance.now() - start;
    this.stats.frames += 1;
    if (newest) this.stats.shownFrame = newest.frame;
  }

  /** False where the next picture would be the last one again. */
  private changed(now: number): boolean {
    const moved = this.camera.update(now);
    const newest = this.timeline_.newest;
    const { targetX, targetY, distance, turn, pitch } = this.camera.pose;
    const signature = `${newest?.frame}:${targetX}:${targetY}:${distance}:${turn}:${pitch}`;
    if (moved || signature !== this.signature_ || this.marks_.rings.size > 0) this.activeUntil_ = now + kSettle;
    this.signature_ = signature;
    return now < this.activeUntil_;
  }

  private show(now: number): void {
    const scene = this.scene_;
    const greyed = this.overlay_ !== null;
    const colours = scene?.groups.map((group) => group.colour) ?? [];
    const accents = colours.map((colour) => (greyed ? this.palette_.grey : accentOf(this.palette_, colour)));
    if (this.membersStale_) this.dress(colours, greyed);
    this.groups_.showMeshes(this.stage_.meshes, this.layers_.mesh, accents);
    this.groups_.showPlaces(this.stage_.rings, this.layers_.places, accents, this.previews_);
    this.stage_.figures.update(this.camera.pixelsPerMetre());
    this.stage_.render(this.camera, this.stats);
    const chosenGroup = this.chosenGroup();
    const view: TagScene = {
      camera: this.camera, palette: this.palette_, colours, now, moving: this.moving_, overlay: this.overlay_,
      contours: this.contours_, chosenGroup,
    };
    this.markLayer_.draw(this.marks_, { ...view, paths: this.layers_.paths, greyed, draft: this.draft_ });
    const tags = scene ? patchTags(scene, view) : [];
    this.tagLayer_.show([...tags, ...chipTags(this.marks_, view), ...overlayTags(view)]);
  }

  /** Gives figures their colours. */
  private dress(colours: readonly number[], greyed: boolean): void {
    this.membersStale_ = false;
    const chosen = greyed && this.overlay_?.kind === 2 ? this.overlay_.character : -1;
    this.stage_.figures.setPalette(this.palette_, greyed, this.theme_ === 'dark');
    this.stage_.figures.setMembers(this.crowd_, colours, this.palette_, chosen);
  }

  private chosenGroup(): number {
    const overlay = this.overlay_;
    if (!overlay) return -1;
    const index = this.crowd_.ids.indexOf(overlay.character);
    return index < 0 ? this.activeGroup_ : this.crowd_.group[index] ?? -1;
  }

  /** Opens the view on the crowd, and what awaits it, with the first frame that has one. */
  private openView(): void {
    if (this.opened_ || this.camera.width < 2) return;
    const points = this.crowdPoints();
    if (points.length === 0) return;
    this.opened_ = true;
    const around = this.scene_ ? surroundings(this.scene_, points) : [];
    this.camera.fit([...points, ...around], this.padding_);
  }

  /** Points round crowd, places and paths. */
  private crowdPoints(): GroundPoint[] {
    const box = new BoundsBuilder();
    for (let i = 0; i < this.crowd_.count; ++i) {
      box.add(this.crowd_.placement[4 * i] ?? 0, this.crowd_.placement[4 * i + 1] ?? 0);
    }
    for (const group of this.timeline_.newest?.groups ?? []) {
      box.addAll(group.places);
      for (const control of group.controls) for (const point of control.points) box.addAll(point.path);
    }
    return box.outline();
  }
}

function sameNumbers(a: Numbers, b: Numbers, c: Numbers, d: Numbers): boolean {
  if (a.length !== b.length || c.length !== d.length) return false;
  for (let i = 0; i < a.length; ++i) if (a[i] !== b[i] || c[i] !== d[i]) return false;
  return true;
}
