// Derives the state of the panels from scene, meshes and frames.

import type { GroupMesh } from '../protocol/messages';
import type { StudioFrame } from './studio_frame';
import type { SceneFacts } from '../protocol/scene';
import { walksOf } from './objective';
import type { GroupInfo, StudioState } from './studio_state';

/** Characters per group index. */
export function countGroups(group: Uint8Array, groups: number): number[] {
  const counts = new Array<number>(groups).fill(0);
  for (const index of group) if (index < groups) counts[index]! += 1;
  return counts;
}

/** Equal for scenes that look the same: counts, formations and parameters do not matter. */
export function sceneKey(scene: SceneFacts): string {
  const { name, box, cell, obstacles, patches, clips, items, checkpoints } = scene;
  const groups = scene.groups.map((group) => [group.id, group.name, group.colour]);
  return JSON.stringify([name, box, cell, obstacles, patches, clips, items, checkpoints, groups]);
}

export class FrameReader {
  private scene_: SceneFacts | null = null;
  private readonly formations_ = new Map<number, string>();
  private counts_: number[] = [];

  setScene(scene: SceneFacts): void {
    this.scene_ = scene;
    this.formations_.clear();
    for (const group of scene.groups) this.formations_.set(group.id, group.formation);
    this.counts_ = scene.groups.map((group) => group.count);
  }

  setMesh(mesh: GroupMesh): void {
    this.formations_.set(mesh.group, mesh.formation);
  }

  /** Returns `before` itself where nothing changed, so that no watcher is called. */
  groups(frame: StudioFrame, before: readonly GroupInfo[]): readonly GroupInfo[] {
    if (frame.group.length > 0) this.counts_ = countGroups(frame.group, frame.groups.length);
    const groups = frame.groups.map(({ id }, index): GroupInfo => {
      const known = this.scene_?.groups.find((group) => group.id === id);
      return {
        id,
        name: known?.name ?? `Group ${index + 1}`,
        colour: known?.colour ?? index,
        count: this.counts_[index] ?? 0,
        formation: this.formations_.get(id) ?? '',
      };
    });
    return JSON.stringify(groups) === JSON.stringify(before) ? before : groups;
  }

  change(frame: StudioFrame, state: StudioState): Partial<StudioState> {
    const groups = this.groups(frame, state.groups);
    return {
      groups,
      active: Math.min(state.active, Math.max(0, groups.length - 1)),
      playing: frame.playing,
      replaying: frame.replaying,
      demonstrating: frame.demonstrating,
      lastSteered: frame.replaying ? state.lastSteered : state.scenario,
      speed: frame.speed,
      recorded: frame.recordedSeconds,
      characters: frame.x.length,
      stepMs: frame.stepMs,
      lag: frame.lagP95,
      swaps: frame.swapsPerSecond,
      walks: walksOf(frame),
      frames: state.frames + 1,
      loaded: true,
    };
  }
}
