// The scene: everything that is drawn from the world's frames, and the camera that looks at it.

import './view.css';
import type { Body } from '../people/body';
import type { ClipPoses } from '../people/clip_bank';
import { isSameWorld, type SceneFacts } from '../protocol/scene';
import { CameraController } from './camera_controller';
import { BoundsBuilder } from './bounds_builder';
import type { GroundPoint, Padding, ScreenPoint } from './camera_types';
import { ControlMarks } from './control_marks';
import type { CrowdLayer } from './crowd_layer';
import { CrowdState } from './crowd_state';
import { contourLabels, type ContourLabel, type FieldScale, makeFieldPicture } from './field_picture';
import { type FrameBlend, FrameTimeline } from './frame_timeline';
import type { FrameView, GroupMeshView, MovingView, Numbers, OverlayView } from './frame_types';
import { GroupPicture } from './group_picture';
import { type DraftControl, MarkLayer } from './mark_layer';
import { surroundings } from './opening';
import { accentOf, type Palette, paletteOf } from './palette';
import { pickCharacter } from './picker';
import { chooseQuality, rendererName } from './quality';
import { chipTags, overlayTags, patchTags, type TagScene } from './scene_tags';
import { Stage } from './stage';
import type { Attention, Layers, StudioScene, Theme, ViewStats } from './studio_scene';
import { TagLayer } from './tag_layer';

/** Rendering goes on this long after the last change, for what settles [ms]. */
const kSettle = 700;
/** The answer to a finger comes within this time, or does not come [ms]. */
const kEchoWait = 60;
/** Between two looks whether the last picture is finished [ms]. */
const kRetry = 3;
/** The camera's way to another view takes so long [ms]. */
const kGlide = 260;
const kNoFrame: readonly MovingView[] = [];

/** Draws the world once per display frame: controls and meshes of the newest frame, characters between the last two. */
export class StudioView implements StudioScene {
  readonly camera = new CameraController();
  readonly stats: ViewStats = { drawCalls: 0, triangles: 0, frameMs: 0, takenMs: 0, taken: 0, frames: 0, shownFrame: 0 };
  private readonly stage_: Stage;
  private readonly marks_ = new ControlMarks();
  private readonly markLayer_: MarkLayer;
  private readonly tagLayer_: TagLayer;
  private readonly timeline_ = new FrameTimeline();
  private readonly crowd_ = new CrowdState();
  private readonly groups_ = new GroupPicture();
  private readonly observer_: ResizeObserver;
  private scene_: SceneFacts | null = null;
  private palette_: Palette = paletteOf('light');
  private theme_: Theme = 'light';
  private layers_: Layers = { mesh: true, places: true, paths: true };
  private overlay_: OverlayView | null = null;
  private contours_: readonly ContourLabel[] = [];
  private fieldScale_: FieldScale | null = null;
  private drafts_: readonly DraftControl[] = [];
  /** A rubber band or lasso. */
  private preview_: readonly DraftControl[] = [];
  private padding_: Padding = { top: 84, right: 24, bottom: 120, left: 24 };
  private moving_: readonly MovingView[] = kNoFrame;
  private reduced_ = false;
  private activeGroup_ = -1;
  private opened_ = false;
  private membersStale_ = true;
  /** The next picture answers a finger. */
  private urgent_ = false;
  /** Where drawing is slow: until then only the answer to a finger may start a picture [ms]. */
  private keptFreeUntil_ = 0;
  private ringsStale_ = false;
  private retry_ = 0;
  private touchEcho_ = 0;
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

  /** Characters in the last picture by body, and the names of clips by index: for tests and the curious. */
  get people(): { readonly drawn: CrowdLayer['drawn']; readonly clips: readonly string[] } {
    const { drawn, bank } = this.stage_.crowd;
    return { drawn, clips: Array.from({ length: bank.clipCount }, (_, clip) => bank.name(clip)) };
  }

  /** The scale of the overlay on show, for its legend; null without one. */
  get fieldScale(): FieldScale | null {
    return this.fieldScale_;
  }

  setScene(scene: SceneFacts): void {
    const anew = !this.scene_ || !isSameWorld(this.scene_, scene);
    this.scene_ = scene;
    this.membersStale_ = true;
    this.stage_.setScene(scene, this.palette_);
    if (anew) this.openScene(scene);
    this.wake();
  }

  private openScene(scene: SceneFacts): void {
    this.timeline_.clear();
    this.crowd_.clear();
    this.groups_.clear();
    this.marks_.clear();
    this.moving_ = kNoFrame;
    this.opened_ = false;
    this.camera.setWorld(scene.box.min[0], scene.box.min[1], scene.box.max[0], scene.box.max[1]);
    this.camera.open();
    this.setOverlay(null);
  }

  setMotions(clips: readonly ClipPoses[]): void {
    this.stage_.crowd.setMotions(clips);
    this.wake();
  }

  setBodies(bodies: readonly Body[]): void {
    this.stage_.crowd.setBodies(bodies);
    this.wake();
  }

  setOwnBody(body: Body | null, clips: readonly ClipPoses[] = []): void {
    this.stage_.crowd.setOwn(body, clips);
    this.wake();
  }

  attention(): Attention {
    const { targetX, targetY } = this.camera.pose;
    return { x: targetX, y: targetY, count: this.stage_.wholePoses };
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
    const echo = frame.touchEcho ?? 0;
    if (this.stage_.paced && echo > this.touchEcho_) {
      this.urgent_ = true;
      this.keptFreeUntil_ = 0;
      this.drawSoon();
    }
    this.touchEcho_ = echo;
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
    const now = performance.now();
    // A ring that only moves comes with the picture that answers the finger.
    this.ringsStale_ ||= !world || this.marks_.rings.get(id)?.lifted !== 0;
    this.marks_.touch(id, world, groupIndex, now);
    if (groupIndex >= 0 && world) this.keptFreeUntil_ = now + kEchoWait;
    this.wake();
  }

  showDrafts(drafts: readonly DraftControl[]): void {
    this.drafts_ = drafts;
    this.wake();
  }

  setClient(client: number): void {
    this.marks_.client = client;
  }

  previewControl(groupIndex: number, points: readonly GroundPoint[] | null, closed: boolean): void {
    this.preview_ = points ? [{ group: groupIndex, points, closed, handles: [] }] : [];
    this.wake();
  }

  pick(clientX: number, clientY: number): number {
    const bounds = this.canvas_.getBoundingClientRect();
    const index = pickCharacter({ x: clientX - bounds.left, y: clientY - bounds.top }, this.crowd_, this.camera);
    return index < 0 ? -1 : this.crowd_.ids[index] ?? -1;
  }

  screenToWorld(at: ScreenPoint): GroundPoint | null {
    return this.camera.screenToGround(at);
  }

  worldToScreen(point: GroundPoint): ScreenPoint {
    return this.camera.worldToScreen(point.x, point.y);
  }

  fitCrowd(): void {
    this.camera.glideFit(this.crowdPoints(), this.padding_, performance.now(), this.reduced_ ? 0 : kGlide);
  }

  lookAt(point: GroundPoint): void {
    this.camera.glideTo(point, this.padding_, performance.now(), this.reduced_ ? 0 : kGlide);
    this.wake();
  }

  pixelsPerMetre(): number {
    return this.camera.pixelsPerMetre();
  }

  dispose(): void {
    cancelAnimationFrame(this.request_);
    clearTimeout(this.retry_);
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

  /** Where drawing is slow the answer to a finger waits for the last picture only, not for the display's beat. */
  private drawSoon(): void {
    clearTimeout(this.retry_);
    this.draw(performance.now());
    if (this.urgent_) this.retry_ = window.setTimeout(() => this.drawSoon(), kRetry);
  }

  /** True where this picture would stand in the way of another; see GpuPace. */
  private mustWait(now: number): boolean {
    if (!this.stage_.paced) return false;
    return this.stage_.busy(this.urgent_) || (!this.urgent_ && now < this.keptFreeUntil_);
  }

  private draw(now: number): void {
    const start = performance.now();
    if (!this.changed(now)) return;
    if (this.mustWait(now)) {
      // The ring under a finger comes with the next beat all the same.
      if (this.ringsStale_) this.showMarks(this.tagScene(now));
      return;
    }
    this.urgent_ = false;
    const blend = this.timeline_.sample(now);
    if (blend) {
      this.crowd_.update(blend);
      this.moving_ = blend.to.moving;
      this.stage_.world.move(blend.from.moving, blend.to.moving, blend.alpha);
      this.stage_.world.setCollected(blend.to.collected);
      this.openView();
    }
    const newest = this.timeline_.newest;
    this.groups_.update(newest?.groups ?? []);
    this.marks_.update(newest?.groups ?? [], now);
    this.show(now, blend);
    this.stats.frameMs = performance.now() - start + this.stats.takenMs / Math.max(1, this.stats.taken);
    this.stats.takenMs = 0;
    this.stats.taken = 0;
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

  private show(now: number, blend: FrameBlend | null): void {
    const scene = this.scene_;
    const greyed = this.overlay_ !== null;
    const colours = this.colours();
    const accents = colours.map((colour) => (greyed ? this.palette_.grey : accentOf(this.palette_, colour)));
    if (this.membersStale_) this.dress(colours, greyed);
    this.groups_.showMeshes(this.stage_.meshes, this.layers_.mesh, accents);
    this.groups_.showPlaces(this.stage_.rings, this.layers_.places, accents, now);
    if (this.stage_.world.reveal(this.crowd_, this.camera)) this.wake();
    this.stage_.crowd.update(this.crowd_, blend, this.camera);
    this.stage_.render(this.camera, this.stats);
    const view = this.tagScene(now);
    this.showMarks(view);
    const tags = scene ? patchTags(scene, view) : [];
    const chips = chipTags(this.marks_, view);
    // Also where no frame comes, as in a pause, they must go again.
    if (chips.length > 0) this.wake();
    this.tagLayer_.show([...tags, ...chips, ...overlayTags(view)]);
  }

  private showMarks(view: TagScene): void {
    this.ringsStale_ = false;
    const greyed = this.overlay_ !== null;
    this.markLayer_.draw(this.marks_, { ...view, paths: this.layers_.paths, greyed, drafts: [...this.drafts_, ...this.preview_] });
  }

  private tagScene(now: number): TagScene {
    return {
      camera: this.camera, palette: this.palette_, colours: this.colours(), now, moving: this.moving_,
      overlay: this.overlay_, contours: this.contours_, chosenGroup: this.chosenGroup(),
    };
  }

  private colours(): readonly number[] {
    return this.scene_?.groups.map((group) => group.colour) ?? [];
  }

  /** Gives people their colours. */
  private dress(colours: readonly number[], greyed: boolean): void {
    this.membersStale_ = false;
    const chosen = greyed && this.overlay_?.kind === 2 ? this.overlay_.character : -1;
    this.stage_.crowd.setPalette(this.palette_, greyed, this.theme_ === 'dark');
    this.stage_.crowd.setColours(colours, this.palette_, chosen);
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
    box.addAll(this.crowd_.places);
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
