import { describe, expect, it } from 'vitest';
import type { GroupMesh } from '../protocol/messages';
import type { StudioFrame } from './studio_frame';
import { sceneOf } from '../protocol/test_scene';
import { FrameReader, countGroups, sceneKey } from './frame_reader';
import { kIdle } from './test_frames';
import { kInitialState } from './studio_state';

const scene = sceneOf({
  title: 'Open',
  box: { min: [0, 0], max: [10, 10] },
  groups: [
    { id: 4, count: 2, formation: 'square', definition: { name: 'North' } },
    { id: 9, accent: 1, count: 1, formation: 'wedge', definition: { name: 'South' } },
  ],
});

function frame(group: number[], groups: number[] = [4, 9]): StudioFrame {
  const part = {
    type: 'Frame',
    group: Uint16Array.from(group),
    unitClass: Uint8Array.from(group, (_, i) => (i === 0 ? 2 : 0)),
    x: new Float32Array(3),
    groups: groups.map((id) => ({
      id,
      controls: [],
      standings: [2],
      ...kIdle,
      walkSum: 3,
      walkSquares: 5,
      walkLongest: 2,
    })),
    playing: true,
    speed: 2,
    recordedSeconds: 1.5,
    stepMs: 6,
    lagP95: 0.8,
    swapsPerSecond: 0.1,
    replaying: false,
    demonstrating: true,
    collected: Uint8Array.of(1, 0, 1),
  };
  return part as unknown as StudioFrame;
}

describe('FrameReader', () => {
  it('joins names of the scene with counts of the frame', () => {
    const reader = new FrameReader();
    reader.setScene(scene);
    const groups = reader.groups(frame([0, 0, 1]), []);
    expect(groups.map(({ name, count, formation }) => `${name} ${count} ${formation}`)).toEqual([
      'North 2 square',
      'South 1 wedge',
    ]);
  });
  it('keeps the list itself while nothing changes, also where counts are left out', () => {
    const reader = new FrameReader();
    reader.setScene(scene);
    const groups = reader.groups(frame([0, 0, 1]), []);
    expect(reader.groups(frame([]), groups)).toBe(groups);
    reader.setMesh({ group: 9, formation: 'ring' } as GroupMesh);
    expect(reader.groups(frame([]), groups)[1]!.formation).toBe('ring');
  });
  it('keeps the active group within what there is', () => {
    const reader = new FrameReader();
    reader.setScene(scene);
    const change = reader.change(frame([0, 0, 0], [4]), { ...kInitialState, active: 1 });
    expect(change.active).toBe(0);
    expect(change.recorded).toBe(1.5);
    expect(change.demonstrating).toBe(true);
  });
  it('keeps who is chosen by id when groups before it end', () => {
    const reader = new FrameReader();
    reader.setScene(scene);
    const before = reader.change(frame([0, 0, 1]), { ...kInitialState, active: 1 });
    const state = { ...kInitialState, ...before, active: 1, selected: [4, 9] };
    const after = reader.change(frame([0, 0, 0], [9]), state);
    expect([after.active, after.selected]).toEqual([0, [9]]);
    const gone = reader.change(frame([0, 0, 0], [4]), { ...state, selected: [9] });
    expect([gone.active, gone.selected]).toEqual([0, [4]]);
  });
  it('gives parts of a group its name and a number, and colours as chosen or by id', () => {
    const reader = new FrameReader();
    reader.setScene(
      sceneOf({
        box: { min: [0, 0], max: [1, 1] },
        groups: [
          { id: 4, accent: 3, definition: { name: 'North' } },
          { id: 11, accent: 4, definition: { name: 'North', colour: 0x05536d } },
        ],
      }),
    );
    const groups = reader.groups(frame([0, 1, 2], [4, 11, 14]), []);
    const chosen = 5 * 0x1000000 + 0x05536d;
    expect(groups.map(({ name, colour }) => `${name} ${colour}`)).toEqual([
      'North 3',
      `North 2 ${chosen}`,
      'Group 14 1',
    ]);
  });
  it('tells conduct and classes of each group, and the list itself while nothing changes', () => {
    const reader = new FrameReader();
    reader.groups(frame([0, 0, 1]), []);
    const told = reader.units(frame([0, 0, 1]), []);
    expect(told.map(({ id, classes }) => [id, classes])).toEqual([
      [4, [{ unitClass: 2, count: 1 }]],
      [9, []],
    ]);
    expect(told[0]!.conduct).toEqual({ stance: 'normal', cohesion: 0, squeeze: 1, avoids: false });
    expect(reader.units(frame([]), told)).toBe(told);
  });
  it('remembers the scenario that was steered through a replay', () => {
    const reader = new FrameReader();
    reader.setScene(scene);
    const live = {
      ...kInitialState,
      scenario: 'open',
      ...reader.change(frame([0, 0, 1]), { ...kInitialState, scenario: 'open' }),
    };
    expect(live.lastSteered).toBe('open');
    const take = reader.change({ ...frame([0, 0, 1]), replaying: true }, { ...live, scenario: 'Open square' });
    expect([take.replaying, take.lastSteered]).toEqual([true, 'open']);
  });
});

it('countGroups ignores indices of groups that are not there', () => {
  expect(countGroups(Uint16Array.from([0, 1, 1, 7]), 2)).toEqual([1, 2]);
});

it('sceneKey sees other ground, but no other groups, counts and formations', () => {
  const more = { ...scene, groups: scene.groups.map((group) => ({ ...group, count: 99, formation: 'ring' })) };
  expect(sceneKey(more)).toBe(sceneKey(scene));
  expect(sceneKey({ ...scene, groups: scene.groups.slice(1) })).toBe(sceneKey(scene));
  expect(sceneKey({ ...scene, cell: 1 })).not.toBe(sceneKey(scene));
});
