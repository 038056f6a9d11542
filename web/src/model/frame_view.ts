// What the view reads of the protocol's messages. Structural, so that decoded messages and synthetic ones both fit.

import type { QueueOrder } from './queue_order';

export type Numbers = ArrayLike<number>;

export interface ControlPointView {
  readonly touch: number;
  readonly down: boolean;
  readonly x: number;
  readonly y: number;
  /** x, y of the checkpoints ahead. */
  readonly path: Numbers;
}

export interface ControlView {
  readonly id: number;
  /** 0 point, 1 line, 2 area. */
  readonly kind: number;
  readonly client: number;
  readonly pinned: boolean;
  readonly open: boolean;
  readonly points: readonly ControlPointView[];
  /** x, y. */
  readonly supplementary: Numbers;
}

export interface GroupView {
  readonly id: number;
  readonly meshVersion: number;
  readonly lag: number;
  /** x, y of the mesh's vertices. */
  readonly vertices: Numbers;
  /** x, y. */
  readonly places: Numbers;
  /** Per place: 0 where an obstacle leaves no space for a character. */
  readonly fit: Numbers;
  readonly controls: readonly ControlView[];
  /** Centre of the formation, and its heading [rad]. */
  readonly x: number;
  readonly y: number;
  readonly facing: number;
  readonly orders: readonly QueueOrder[];
  /** x, y: the rest of the way of the first order. */
  readonly way: Numbers;
  readonly held: boolean;
  readonly patrols: boolean;
}

export interface MovingView {
  /** 0 obstacle, 1 patch. */
  readonly kind: number;
  readonly id: number;
  readonly x: number;
  readonly y: number;
  readonly angle: number;
}

/** What an area has seen. */
export interface AreaView {
  readonly id: number;
  /** Who have left by an exit, or come by a source. */
  readonly passed: number;
  /** Of a source: for whom there is no room yet. */
  readonly waiting: number;
}

export interface FrameView {
  readonly frame: number;
  readonly step: number;
  /** World time [s]. */
  readonly time: number;
  readonly playing: boolean;
  /** Newest time among our touches that the frame shows; grows with each. */
  readonly touchEcho?: number;
  /** Empty where unchanged since the last frame. */
  readonly ids: Numbers;
  /** Index into groups, per character; empty together with `ids`. */
  readonly group: Numbers;
  /** Class per character; empty where all are of none. */
  readonly unitClass: Numbers;
  /** Radius per character [cm]; empty where all have the usual one. */
  readonly radius: Numbers;
  readonly x: Numbers;
  readonly y: Numbers;
  /** Per character the clip it plays (index into the clips). */
  readonly clip: Numbers;
  /** What the graphics card reads of the characters: see StudioFrame. */
  readonly rows: Float32Array;
  /** Indices of the characters that have whole poses. */
  readonly near: Numbers;
  /** Per whole pose: hips x, y, z [m], then per joint x, y, z, w. */
  readonly nearPoses: Numbers;
  readonly groups: readonly GroupView[];
  readonly moving: readonly MovingView[];
  readonly collected: Numbers;
  readonly areas?: readonly AreaView[];
}

export interface GroupMeshView {
  readonly group: number;
  readonly version: number;
  readonly formation: string;
  readonly triangles: Numbers;
  /** Loops: length, then vertices. */
  readonly boundary: Numbers;
}

/** A mesh with its shape at rest. */
export interface ShapeMeshView extends GroupMeshView {
  readonly spacing: number;
  /** x, y of the vertices in the group's axes. */
  readonly rest: Numbers;
  readonly placeTriangles: Numbers;
  readonly placeWeights: Numbers;
}

export interface OverlayView {
  /** 0 none, 1 field, 2 cost, 3 density. */
  readonly kind: number;
  /** Id, for Cost. */
  readonly character: number;
  /** Centre of the first cell. */
  readonly x: number;
  readonly y: number;
  readonly cell: number;
  readonly width: number;
  readonly height: number;
  /** Row-major from the lower left; not finite: not reached. */
  readonly values: Numbers;
  /** x, y from the character to its place. */
  readonly path: Numbers;
}
