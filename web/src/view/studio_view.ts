// The scene: everything that is drawn from the world's frames, and the camera that looks at it.

import type { SceneFacts } from '../protocol/scene';
import type { CameraControls, GroundPoint, Padding, ScreenPoint } from './camera_types';
import type { FrameView, GroupMeshView, OverlayView } from './frame_types';

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
