// The scene: everything that is drawn from the world's frames, and the camera that looks at it.

import type { DirectorInfo } from '../model/directors';
import './view.css';
import type { Body } from './crowd/bodies/body';
import type { ClipPoses } from './crowd/clips/clip_bank';
import { isSameWorld, type SceneFacts } from '../protocol/scene';
import { CameraController } from './camera/camera_controller';
import { MarkState } from './marks/mark_state';
import type { CrowdLayer } from './crowd/crowd_layer';
import { CrowdState } from './crowd/crowd_state';
import { OverlayState } from './ground/overlay_state';
import { type FrameBlend, FrameTimeline } from '../model/frame_timeline';
import type { FrameView, ShapeMeshView, MovingView, OverlayView } from '../model/frame_view';
import { GroupState } from './marks/group_state';
import { MarkLayer } from './marks/mark_layer';
import { OrderPicture } from './order_picture';
import { ViewFitter } from './camera/view_fitter';
import { coversFigure } from './crowd/figure_cover';
import { accentColour, type Palette, paletteOf } from './drawing/palette';
import { pickCharacter } from './crowd/picker';
import { chooseQuality, rendererName } from './drawing/quality';
import { areasOf, chipTags, overlayTags, patchTags, type TagScene } from './marks/scene_tags';
import { Stage } from './stage';
import { PictureStats } from './picture_stats';
import type { Attention, Backdrop, StudioScene } from './studio_scene';
import { TagLayer } from './marks/tag_layer';
import type { GroundPoint, ScreenPoint } from '../model/plane';
import type { DraftControl } from './marks/draft_control';
import type { Layers, Theme } from '../model/view_settings';
import type { SceneryModel } from '../model/place_files/scenery';
import type { FieldScale } from '../model/field_scale';

/** Pictures are drawn for this long after the last change, until fades have ended [ms]. */
const kSettle = 700;
/** Longest wait for the frame that answers a finger [ms]. */
const kEchoWait = 60;
/** Interval between two checks whether the last picture is finished [ms]. */
const kRetry = 3;
/** Where a metre is smaller, nobody sees that a clip's pose is not quite the engine's [CSS px]. */
const kCloseUp = 7;
const kNothingMoves: readonly MovingView[] = [];

/** Draws the world with each refresh: controls and meshes of the newest frame, characters between the last two. */
export class StudioView implements StudioScene {
  readonly camera = new CameraController();
  readonly stats = new PictureStats();
  private readonly stage_: Stage;
  private readonly marks_ = new MarkState();
  private readonly markLayer_: MarkLayer;
  private readonly tagLayer_: TagLayer;
  private readonly timeline_ = new FrameTimeline();
  private readonly crowd_ = new CrowdState();
  readonly orders = new OrderPicture(() => this.wake(), this.crowd_);
  readonly fitter = new ViewFitter(this.camera);
  private readonly groups_ = new GroupState();
  private readonly observer_: ResizeObserver;
  private scene_: SceneFacts | null = null;
  private palette_: Palette = paletteOf('light');
  private theme_: Theme = 'light';
  private layers_: Layers = { mesh: true, places: true, paths: true };
  private readonly overlay_ = new OverlayState();
  private drafts_: readonly DraftControl[] = [];
  private preview_: readonly DraftControl[] = [];
  private moving_: readonly MovingView[] = kNothingMoves;
  private reduced_ = false;
  private closeUp_ = false;
  private activeGroup_ = -1;
  private membersStale_ = true;
  /** The next picture answers a finger. */
  private urgent_ = false;
  /** Where drawing is slow: until then only the answer to a finger may start a picture [ms]. */
  private reservedUntil_ = 0;
  private ringsStale_ = false;
  private retry_ = 0;
  private touchEcho_ = 0;
  private activeUntil_ = 0;
  private signature_ = '';
  private request_ = 0;

  constructor(
    private readonly canvas_: HTMLCanvasElement,
    private readonly overlayRoot_: HTMLElement,
  ) {
    this.stage_ = new Stage(canvas_, chooseQuality(location.search, rendererName));
    this.markLayer_ = new MarkLayer(overlayRoot_);
    this.tagLayer_ = new TagLayer(overlayRoot_);
    this.observer_ = new ResizeObserver(() => this.resize());
    this.observer_.observe(canvas_);
    this.stage_.setPalette(this.palette_);
    this.resize();
    this.request_ = requestAnimationFrame(this.tick);
  }

  /** Characters in the last picture by body, and the names of clips by index: for tests. */
  get people(): { readonly drawn: CrowdLayer['drawn']; readonly clips: readonly string[] } {
    const { drawn, bank } = this.stage_.crowd;
    return { drawn, clips: Array.from({ length: bank.clipCount }, (_, clip) => bank.name(clip)) };
  }

  /** Opacity of each building, 0 to 1: for tests. */
  get solid(): readonly number[] {
    return this.stage_.environment.solid;
  }

  /** The scale of the overlay on show, for its legend; null without one. */
  get fieldScale(): FieldScale | null {
    return this.overlay_.scale;
  }
  setScene(scene: SceneFacts, looksTheSame = false): void {
    const anew = !this.scene_ || !isSameWorld(this.scene_, scene);
    this.scene_ = scene;
    if (looksTheSame) return;
    this.membersStale_ = true;
    this.crowd_.setUsualRadius(scene.radius);
    this.orders.setGroups(scene.groups);
    this.stage_.setScene(scene, this.palette_);
    this.fitter.know(scene);
    if (anew) this.openScene(scene);
    this.wake();
  }

  private openScene(scene: SceneFacts): void {
    this.timeline_.clear();
    this.crowd_.clear();
    this.groups_.clear();
    this.orders.clear();
    this.marks_.clear();
    this.moving_ = kNothingMoves;
    this.fitter.open(scene);
    this.setOverlay(null);
  }

  setScenery(models: readonly SceneryModel[]): void {
    this.stage_.setScenery(models);
    this.wake();
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
    this.closeUp_ = this.camera.pixelsPerMetre() > (this.closeUp_ ? kCloseUp : 1.15 * kCloseUp);
    return { x: targetX, y: targetY, count: this.closeUp_ ? this.stage_.wholePoses : 0 };
  }

  setGroupMesh(mesh: ShapeMeshView): void {
    this.groups_.setMesh(mesh);
    this.orders.setMesh(mesh);
    this.wake();
  }

  pushFrame(frame: FrameView, receivedAt: number): void {
    if (this.crowd_.takeMembers(frame)) this.membersStale_ = true;
    this.timeline_.push(frame, receivedAt);
    const echo = frame.touchEcho ?? 0;
    if (this.stage_.paced && echo > this.touchEcho_) {
      this.urgent_ = true;
      this.reservedUntil_ = 0;
      this.drawSoon();
    }
    this.touchEcho_ = echo;
  }

  setOverlay(overlay: OverlayView | null): void {
    const changed = this.overlay_.set(overlay, this.camera.pose.turn);
    this.stage_.setField(this.overlay_.raster);
    this.stage_.environment.floorsVisible = this.overlay_.raster === null;
    this.membersStale_ ||= changed;
    this.wake();
  }

  setLayers(layers: Layers, backdrop: Backdrop | null = null): void {
    this.layers_ = layers;
    this.stage_.setBackdrop(backdrop);
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
    this.reduced_ = this.marks_.reducedMotion = reduced;
  }

  setLost(lost: boolean): void {
    for (const element of [this.canvas_, this.overlayRoot_]) element.classList.toggle('scene-lost', lost);
  }

  setActiveGroup(index: number): void {
    this.activeGroup_ = index;
    this.wake();
  }

  touchMark(id: number, world: GroundPoint | null, groupIndex: number): void {
    const now = performance.now();
    // A ring that only moves comes with the picture that answers the finger.
    this.ringsStale_ ||= !world || this.marks_.rings.get(id)?.lifted !== 0;
    this.marks_.touch(id, world, groupIndex, now);
    if (groupIndex >= 0 && world) this.reservedUntil_ = now + kEchoWait;
    this.wake();
  }

  showDrafts(drafts: readonly DraftControl[]): void {
    this.drafts_ = drafts;
    this.wake();
  }

  setClient(client: number): void {
    this.marks_.client = client;
  }

  setDirectors(directors: readonly DirectorInfo[]): void {
    this.marks_.directors = new Map(directors.map((one) => [one.client, one]));
  }

  previewControl(groupIndex: number, points: readonly GroundPoint[] | null, closed: boolean): void {
    this.preview_ = points ? [{ group: groupIndex, points, closed, handles: [] }] : [];
    this.wake();
  }

  pick(clientX: number, clientY: number): number {
    const bounds = this.canvas_.getBoundingClientRect();
    const index = pickCharacter({ x: clientX - bounds.left, y: clientY - bounds.top }, this.crowd_, this.camera);
    return index < 0 ? -1 : (this.crowd_.ids[index] ?? -1);
  }

  screenToWorld(at: ScreenPoint): GroundPoint | null {
    return this.camera.screenToGround(at);
  }

  worldToScreen(point: GroundPoint): ScreenPoint {
    return this.camera.worldToScreen(point.x, point.y);
  }

  fitCrowd(orPlace = false): boolean {
    return this.fitter.fit(this.crowd_.positions, this.timeline_.newest?.groups ?? [], this.reduced_, orPlace);
  }

  lookAt(point: GroundPoint): void {
    this.fitter.lookAt(point, this.reduced_);
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

  readonly wake = (): void => void (this.activeUntil_ = performance.now() + kSettle);

  private resize(): void {
    const { clientWidth, clientHeight } = this.canvas_;
    this.camera.resize(clientWidth, clientHeight);
    this.stage_.resize(clientWidth, clientHeight);
    this.markLayer_.resize(clientWidth, clientHeight, this.stage_.pixelRatio);
    this.wake();
  }

  private readonly tick = (now: number): void => {
    this.request_ = requestAnimationFrame(this.tick);
    this.draw(now);
  };

  /** Where drawing is slow, the answer to a finger follows the last picture without waiting for a refresh. */
  private drawSoon(): void {
    clearTimeout(this.retry_);
    this.draw(performance.now());
    if (this.urgent_) this.retry_ = window.setTimeout(() => this.drawSoon(), kRetry);
  }

  /** True where this picture would delay a more urgent one; see GpuPace. */
  private mustWait(now: number): boolean {
    if (!this.stage_.paced) return false;
    return this.stage_.busy(this.urgent_) || (!this.urgent_ && now < this.reservedUntil_);
  }

  private draw(now: number): void {
    const start = performance.now();
    if (!this.changed(now)) return;
    if (this.mustWait(now)) {
      // The ring under a finger is drawn with the next refresh all the same.
      if (this.ringsStale_) this.showMarks(this.tagScene(now));
      return;
    }
    this.urgent_ = false;
    const blend = this.timeline_.sample(now);
    if (blend) {
      this.crowd_.update(blend);
      this.moving_ = blend.to.moving;
      this.stage_.environment.move(blend.from.moving, blend.to.moving, blend.alpha);
      this.stage_.environment.setCollected(blend.to.collected);
      this.fitter.show(() => this.crowd_.positions, this.timeline_.newest?.groups ?? []);
    }
    const newest = this.timeline_.newest;
    if (this.orders.update(newest?.groups ?? [])) this.membersStale_ = true;
    this.groups_.update(newest?.groups ?? []);
    this.marks_.update(newest?.groups ?? [], now);
    this.show(now, blend);
    this.stats.finish(start, newest?.frame);
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
    const greyed = this.overlay_.overlay !== null;
    const colours = this.orders.colours;
    const accents = colours.map((colour) => (greyed ? this.palette_.grey : accentColour(this.palette_, colour)));
    if (this.membersStale_) this.dress(colours, greyed);
    const { meshes, places } = this.stage_;
    for (const layer of [meshes, places]) layer.setScale(this.camera.pixelsPerMetre());
    this.groups_.showMeshes(meshes, this.layers_.mesh, accents);
    this.groups_.showPlaces(places, this.layers_.places && places.seen, accents, now);
    if (this.stage_.environment.reveal(this.crowd_, this.camera)) this.wake();
    this.stage_.crowd.update(this.crowd_, blend, this.camera);
    this.stage_.render(this.camera, this.stats);
    const view = this.tagScene(now);
    this.showMarks(view);
    const tags = this.scene_ ? patchTags(this.scene_, view) : [];
    const chips = chipTags(this.marks_, view);
    // Chips must fade in a pause as well, when no frame comes.
    if (chips.length > 0) this.wake();
    this.tagLayer_.show([...tags, ...chips, ...overlayTags(view)], this.fitter.room);
  }

  private showMarks(view: TagScene): void {
    this.ringsStale_ = false;
    const greyed = this.overlay_.overlay !== null;
    this.markLayer_.draw(this.marks_, {
      ...view,
      paths: this.layers_.paths,
      covered: (at) => coversFigure(this.crowd_, this.camera, at),
      greyed,
      drafts: [...this.drafts_, ...this.preview_],
      ...this.orders.scene(this.layers_.paths && !greyed),
    });
  }

  private tagScene(now: number): TagScene {
    return {
      camera: this.camera,
      palette: this.palette_,
      colours: this.orders.colours,
      now,
      moving: this.moving_,
      ...areasOf(this.timeline_.newest),
      overlay: this.overlay_.overlay,
      contours: this.overlay_.contours,
      chosenGroup: this.chosenGroup(),
    };
  }

  /** Gives people their colours and bodies. */
  private dress(colours: readonly number[], greyed: boolean): void {
    this.membersStale_ = false;
    const chosen = greyed ? this.overlay_.character : -1;
    this.stage_.crowd.setPalette(this.palette_, greyed, this.theme_ === 'dark');
    this.stage_.crowd.setColours(colours, this.palette_, chosen, this.orders.builds);
  }

  private chosenGroup(): number {
    const { overlay } = this.overlay_;
    return overlay ? (this.crowd_.groupOf(overlay.character) ?? this.activeGroup_) : -1;
  }
}
