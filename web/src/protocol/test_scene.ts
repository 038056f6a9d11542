// Scenes for tests.

import { filled } from './encoding';
import type { Given, TimedPath } from './generated/commands';
import type { Scene, SceneArea, SceneObstacle, ScenePatch } from './messages';

/** A scene message with all that was left out. */
export function sceneOf(given: Given<Scene>): Scene {
  return filled<Scene>('ServerMessage', { ...given, type: 'Scene' });
}

/** An obstacle of it. */
export function obstacleOf(given: Given<SceneObstacle>): SceneObstacle {
  return filled<SceneObstacle>('SceneObstacle', given);
}

/** An area of it. */
export function areaOf(given: Given<SceneArea>): SceneArea {
  return filled<SceneArea>('SceneArea', given);
}

/** A patch of it. */
export function patchOf(given: Given<ScenePatch>): ScenePatch {
  return filled<ScenePatch>('ScenePatch', given);
}

/** The path of something that moves. */
export const kMoves: TimedPath = { waypoints: [{ time: 0, position: [0, 0], angle: 0 }], loop: false };
