// What lies under a pointer: a handle, a character, a mesh.

import type { CameraController } from './camera_controller';
import type { ScreenPoint } from './camera_types';
import type { ShownControl } from './control_marks';
import type { CrowdState } from './crowd_state';
import type { Numbers } from './frame_types';
import { insideMesh, type MeshTopology } from './mesh_topology';

/** Handles draw at 22 px but catch within this [CSS px]. */
const kCatch = 24;
/** Height of a figure's head [m]. */
const kHead = 1.7;

export interface MeshTarget {
  readonly topology: MeshTopology;
  readonly vertices: Numbers;
}

/** Distance of a point from a segment [px]. */
export function segmentDistance(p: ScreenPoint, a: ScreenPoint, b: ScreenPoint): number {
  const dx = b.x - a.x;
  const dy = b.y - a.y;
  const length = dx * dx + dy * dy;
  const t = length > 0 ? Math.min(1, Math.max(0, ((p.x - a.x) * dx + (p.y - a.y) * dy) / length)) : 0;
  return Math.hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

/** Index of the character whose figure is nearest on the screen, or -1. */
export function pickCharacter(at: ScreenPoint, state: CrowdState, camera: CameraController): number {
  let best = -1;
  let least = Math.max(10, 0.4 * camera.pixelsPerMetre());
  for (let i = 0; i < state.count; ++i) {
    const x = state.placement[4 * i] ?? 0;
    const y = state.placement[4 * i + 1] ?? 0;
    const away = segmentDistance(at, camera.worldToScreen(x, y), camera.worldToScreen(x, y, kHead));
    if (away >= least) continue;
    least = away;
    best = i;
  }
  return best;
}

/** The living control whose handle catches the point, or null. */
export function pickHandle(at: ScreenPoint, controls: Iterable<ShownControl>, camera: CameraController):
    { readonly group: number; readonly control: number; readonly touch: number } | null {
  let found = null;
  let least = kCatch;
  for (const shown of controls) {
    if (shown.ended > 0) continue;
    shown.handles.forEach((handle, i) => {
      const screen = camera.worldToScreen(handle.x, handle.y);
      const away = Math.hypot(screen.x - at.x, screen.y - at.y);
      const touch = shown.control.points[i]?.touch;
      if (away > least || touch === undefined) return;
      least = away;
      found = { group: shown.group, control: shown.control.id, touch };
    });
  }
  return found;
}

/** Index of the mesh that holds the point, or whose rim is nearest within reach; -1 for none. */
export function pickMesh(at: ScreenPoint, targets: readonly (MeshTarget | null)[], camera: CameraController): number {
  const ground = camera.screenToGround(at);
  if (!ground) return -1;
  let best = -1;
  let least = kCatch;
  for (let g = 0; g < targets.length; ++g) {
    const target = targets[g];
    if (!target) continue;
    const { topology, vertices } = target;
    if (insideMesh(topology, vertices, ground.x, ground.y)) return g;
    for (let i = 0; i + 1 < topology.rim.length; i += 2) {
      const [a, b] = [topology.rim[i] ?? 0, topology.rim[i + 1] ?? 0];
      const away = segmentDistance(at, camera.worldToScreen(vertices[2 * a] ?? 0, vertices[2 * a + 1] ?? 0),
        camera.worldToScreen(vertices[2 * b] ?? 0, vertices[2 * b + 1] ?? 0));
      if (away >= least) continue;
      least = away;
      best = g;
    }
  }
  return best;
}
