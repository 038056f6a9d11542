// Small frames for tests.

import type { ControlView, FrameView, GroupView } from './frame_types';

/** A frame with one character per entry of `x`. */
export function madeFrame(frame: number, x: readonly number[], more: Partial<FrameView> = {}): FrameView {
  const zeros = x.map(() => 0);
  return {
    frame, step: frame, time: frame / 60, playing: true, ids: x.map((_, i) => i + 1), group: zeros, x, y: zeros,
    heading: zeros, motion: zeros, phase: zeros, clip: zeros, clipTime: zeros, fromClip: zeros, fromTime: zeros, fade: zeros,
    near: [], nearPoses: [], groups: [], moving: [], collected: [], ...more,
  };
}

/** A control of a kind with a handle per x, y pair; touches count from 1. */
export function madeControl(id: number, kind: number, handles: readonly (readonly [number, number])[]): ControlView {
  return {
    id, kind, client: 1, pinned: false, open: false, supplementary: [],
    points: handles.map(([x, y], i) => ({ touch: i + 1, down: true, x, y, path: [] })),
  };
}

export function madeGroup(id: number, controls: readonly ControlView[], more: Partial<GroupView> = {}): GroupView {
  return { id, meshVersion: 1, lag: 0, vertices: [], places: [], fit: [], controls, ...more };
}
