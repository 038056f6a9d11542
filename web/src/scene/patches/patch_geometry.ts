// Shapes of patches by motion, so that the ground explains how the characters move.

import type { Vec2 } from '../../protocol/generated/commands';
import type { ScenePatch } from '../../protocol/messages';
import { isMoving } from '../../protocol/scene';
import { counterClockwise } from '../drawing/geometry_builder';
import type { Palette } from '../drawing/palette';
import { addBranches, kLeavesFrom } from './branches';
import { addJump, kHurdleHeight } from './hurdle';
import { addNet, kNetHeight } from './net';
import { addPlain, type PatchParts } from './patch_parts';
import { addPool } from './pool';
import { addStairs } from './stairs';
import { addWall, kWallHeight } from './wall';

export type PatchLook = 'net' | 'pool' | 'wall' | 'jump' | 'branches' | 'plain';

/** The look that goes with a clip's name. */
export function lookOfMotion(clip: string): PatchLook {
  const looks: Readonly<Record<string, PatchLook>> = {
    crawl: 'net',
    swim: 'pool',
    climb: 'wall',
    jump: 'jump',
    duck: 'branches',
  };
  return looks[clip] ?? 'plain';
}

/** Height of the object above a patch [m], for its tag. */
export function heightOfLook(look: PatchLook): number {
  return {
    net: kNetHeight,
    pool: 0.1,
    wall: kWallHeight + 0.1,
    jump: kHurdleHeight + 0.1,
    branches: kLeavesFrom + 0.5,
    plain: 0,
  }[look];
}

/** Adds a patch, lying where its polygon says. */
export function addPatch(parts: PatchParts, patch: ScenePatch, clip: string, palette: Palette): void {
  const outline = counterClockwise(patch.polygon);
  if (outline.length < 3) return;
  if (patch.ascent !== null) return addStairs(parts, outline, patch.ascent, palette);
  addLook(lookOfMotion(clip), parts, outline, isMoving(patch), palette);
}

function addLook(look: PatchLook, parts: PatchParts, outline: readonly Vec2[], moves: boolean, palette: Palette): void {
  switch (look) {
    case 'net':
      return addNet(parts, outline, palette);
    case 'pool':
      return addPool(parts, outline, palette);
    case 'wall':
      return addWall(parts, outline, palette);
    case 'jump':
      return addJump(parts, outline, moves, palette);
    case 'branches':
      return addBranches(parts, outline, palette);
    case 'plain':
      return addPlain(parts, outline, palette.plainFloor, palette.obstacleEdge);
  }
}
