// Derives the state of the panels from scene, meshes and frames.

import type { GroupMesh } from '../protocol/messages';
import type { StudioFrame } from './studio_frame';
import { isSameWorld, type SceneFacts } from '../protocol/scene';
import { withChosen } from './accent';
import { walksOf } from './objective';
import { PaceMeter } from './pace_meter';
import { kStances } from './commands';
import { countClasses, type ClassCount } from './roles';
import type { GroupInfo, StudioState, UnitInfo } from './studio_state';

/** Characters per group index. */
export function countGroups(group: Uint16Array, groups: number): number[] {
  const counts = new Array<number>(groups).fill(0);
  for (const index of group) if (index < groups) counts[index]! += 1;
  return counts;
}

/** Equal for scenes that look the same: groups, counts, formations and parameters do not matter. */
export function sceneKey(scene: SceneFacts): string {
  const { name, box, cell, obstacles, patches, clips, items, checkpoints, areas } = scene;
  return JSON.stringify([name, box, cell, obstacles, patches, clips, items, checkpoints, areas]);
}

/** Colours repeat after so many groups; a group keeps its own, whichever others come and go. */
const kColours = 6;

/** The group's name; parts of a group have its name and a number. */
function nameOf(known: string | undefined, id: number, before: readonly GroupInfo[]): string {
  const name = known || `Group ${id}`;
  const taken = (one: string): boolean => before.some((group) => group.name === one);
  for (let k = 2; ; ++k) {
    const next = k === 2 && !taken(name) ? name : `${name} ${k}`;
    if (!taken(next)) return next;
  }
}

/** Of bytes that are 0 or 1. */
function sumOf(list: ArrayLike<number>): number {
  let sum = 0;
  for (let i = 0; i < list.length; ++i) sum += list[i] ?? 0;
  return sum;
}

function twoDigits(value: number): number {
  return Math.round(value * 100) / 100;
}

/** The selection by ids: groups before the active one may have ended. */
function chosenAmong(groups: readonly GroupInfo[], state: StudioState): Pick<StudioState, 'active' | 'selected'> {
  const wanted = [state.groups[state.active]?.id, ...state.selected];
  const found = wanted.map((id) => groups.findIndex((group) => group.id === id)).find((index) => index >= 0);
  const active = found ?? Math.min(state.active, Math.max(0, groups.length - 1));
  const left = state.selected.filter((id) => groups.some((group) => group.id === id));
  const id = groups[active]?.id;
  const selected = id === undefined ? [] : left.includes(id) ? left : [id];
  return { active, selected };
}

export class FrameReader {
  private scene_: SceneFacts | null = null;
  private readonly pace_ = new PaceMeter();
  private readonly formations_ = new Map<number, string>();
  private counts_: number[] = [];
  private classes_: readonly (readonly ClassCount[])[] = [];

  setScene(scene: SceneFacts): void {
    const before = this.scene_;
    this.scene_ = scene;
    for (const group of scene.groups) this.formations_.set(group.id, group.formation);
    // Frames of the same world go on with the counts that they told.
    if (before && before.world === scene.world && isSameWorld(before, scene)) return;
    this.counts_ = scene.groups.map((group) => group.count);
  }

  setMesh(mesh: GroupMesh): void {
    this.formations_.set(mesh.group, mesh.formation);
  }

  /** Returns `before` itself where nothing changed, so that no watcher is called. */
  groups(frame: StudioFrame, before: readonly GroupInfo[]): readonly GroupInfo[] {
    if (frame.group.length > 0 || frame.x.length === 0) {
      this.counts_ = countGroups(frame.group, frame.groups.length);
      this.classes_ = countClasses(frame.group, frame.unitClass, frame.groups.length);
    }
    const groups: GroupInfo[] = [];
    frame.groups.forEach(({ id }, index) => {
      const known = this.scene_?.groups.find((group) => group.id === id);
      groups.push({
        id,
        name: nameOf(known?.definition.name, id, groups),
        colour: withChosen(known?.accent ?? (id + kColours - 1) % kColours, known?.definition.colour ?? null),
        count: this.counts_[index] ?? 0,
        formation: this.formations_.get(id) ?? '',
      });
    });
    return JSON.stringify(groups) === JSON.stringify(before) ? before : groups;
  }

  /** Returns `before` itself where nothing changed. */
  units(frame: StudioFrame, before: readonly UnitInfo[]): readonly UnitInfo[] {
    const units = frame.groups.map(
      ({ id, orders, held, patrols, stance, cohesion, squeeze, avoids }, index): UnitInfo => ({
        id,
        orders: orders.map((order) => ({ id: order.id, kind: order.kind })),
        held,
        patrols,
        conduct: {
          stance: kStances[stance],
          cohesion: twoDigits(cohesion),
          squeeze: twoDigits(squeeze),
          avoids,
        },
        classes: this.classes_[index] ?? [],
      }),
    );
    return JSON.stringify(units) === JSON.stringify(before) ? before : units;
  }

  /** Returns `before` itself where nothing changed. */
  private standings(frame: StudioFrame, before: StudioState['standings']): StudioState['standings'] {
    const standings = frame.groups.map((group) => [...group.standings]);
    return JSON.stringify(standings) === JSON.stringify(before) ? before : standings;
  }

  /** `now` [ms]. */
  change(frame: StudioFrame, state: StudioState, now = performance.now()): Partial<StudioState> {
    const groups = this.groups(frame, state.groups);
    return {
      groups,
      ...(groups === state.groups ? {} : chosenAmong(groups, state)),
      units: this.units(frame, state.units),
      playing: frame.playing,
      replaying: frame.replaying,
      demonstrating: frame.demonstrating,
      lastSteered: frame.replaying ? state.lastSteered : state.scenario,
      speed: frame.speed,
      recorded: frame.recordedSeconds,
      characters: frame.x.length,
      items: this.scene_?.items.length ?? 0,
      collected: sumOf(frame.collected),
      standings: this.standings(frame, state.standings),
      stepMs: frame.stepMs,
      pace: this.pace_.observe(frame.time, frame.playing && !frame.replaying, frame.speed, now),
      lag: frame.lagP95,
      swaps: frame.swapsPerSecond,
      walks: walksOf(frame),
      frames: state.frames + 1,
      loaded: true,
    };
  }
}
