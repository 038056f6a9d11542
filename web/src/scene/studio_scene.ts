// What tools and panels know of the view.

import type { Color, Object3D } from 'three';
import type { ViewStats } from './picture_stats';
import type { Layers, Theme } from '../model/view_settings';
import type { Body } from './crowd/bodies/body';
import type { ClipPoses } from './crowd/clips/clip_bank';
import type { OrderPicture } from './order_picture';
import type { SceneFacts } from '../protocol/scene';
import type { CameraControls, GroundSight, Padding } from './camera/camera_controls';
import type { FrameView, ShapeMeshView, OverlayView } from '../model/frame_view';
import type { GroundPoint, ScreenPoint } from '../model/plane';
import type { SceneryModel } from '../model/place_files/scenery';
import type { DraftControl } from './marks/draft_control';
import type { DirectorInfo } from '../model/directors';

/** The characters whose whole poses the server shall send: those nearest to a point. */
export interface Attention {
  /** [m] */
  readonly x: number;
  readonly y: number;
  /** How many of the nearest, at most. */
  readonly count: number;
}

/** What stands behind the crowd instead of the studio's plain ground; all that is solid stays so. */
export interface Backdrop {
  readonly objects: readonly Object3D[];
  /** null: as the theme has it. */
  readonly colour: Color | null;
  /** Ground, environment and marks are left out. */
  readonly peopleOnly: boolean;
  /** People have shadows. */
  readonly shadows: boolean;
  dispose(): void;
}

/** The view as tools and panels use it. */
export interface StudioScene {
  readonly camera: CameraControls & GroundSight;
  readonly stats: ViewStats;
  /** Groups, who is chosen, and orders that are being drawn. */
  readonly orders: OrderPicture;
  /** Replaces the environment; where it is another world, the next frame fits the view to the crowd. A world may begin once more that
   * looks the same. */
  setScene(scene: SceneFacts, looksTheSame?: boolean): void;
  /** Imported models, in place of the obstacles that they came to. */
  setScenery(models: readonly SceneryModel[]): void;
  /** The clips that frames refer to by index. */
  setMotions(clips: readonly ClipPoses[]): void;
  /** Muster's own people; a simple person is drawn until they have come. */
  setBodies(bodies: readonly Body[]): void;
  /** A visitor's body for everybody, with clips that replace ours; null brings our people back. */
  setOwnBody(body: Body | null, clips?: readonly ClipPoses[]): void;
  /** Where this view looks. */
  attention(): Attention;
  setGroupMesh(mesh: ShapeMeshView): void;
  /** `receivedAt` by performance.now() [ms]. */
  pushFrame(frame: FrameView, receivedAt: number): void;
  /** Shows one field over the ground and greys all else; null takes it away. */
  setOverlay(overlay: OverlayView | null): void;
  /** Shows marks of these kinds, and puts something behind the crowd. */
  setLayers(layers: Layers, backdrop?: Backdrop | null): void;
  setTheme(theme: Theme): void;
  setReducedMotion(reduced: boolean): void;
  /** Greys the scene while the server is lost. */
  setLost(lost: boolean): void;
  /** The group whose panels are open (index into the scene's groups), or -1. */
  setActiveGroup(index: number): void;
  /** `padding`: what panels cover, and fits keep clear of. `whole`: the next world opens with all of it in view. */
  readonly fitter: { padding: Padding; whole: boolean };
  /** A ring under a finger in the very next picture; null lets it fade. A group of -1 means the camera. */
  touchMark(id: number, world: GroundPoint | null, groupIndex: number): void;
  /** What fingers have drawn and no frame shows yet. */
  showDrafts(drafts: readonly DraftControl[]): void;
  /** Our number at the server: whose fingers these are. */
  setClient(client: number): void;
  /** Whose fingers have which colour and name. */
  setDirectors(directors: readonly DirectorInfo[]): void;
  /** A rubber band or lasso being drawn; null takes it away. */
  previewControl(groupIndex: number, points: readonly GroundPoint[] | null, closed: boolean): void;
  /** Id of the character whose figure lies under client coordinates, or -1. */
  pick(clientX: number, clientY: number): number;
  screenToWorld(at: ScreenPoint): GroundPoint | null;
  worldToScreen(point: GroundPoint): ScreenPoint;
  /** Fits crowd and paths between the panels; with `orPlace` the whole place, where they are fitted already: true then. */
  fitCrowd(orPlace?: boolean): boolean;
  /** Brings a spot between the panels. */
  lookAt(point: GroundPoint): void;
  /** CSS px that a metre on the ground takes in the middle of the view. */
  pixelsPerMetre(): number;
  /** Draws again soon, even where nothing has changed. */
  wake(): void;
  dispose(): void;
}
