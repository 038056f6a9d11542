import { beforeEach, describe, expect, it } from 'vitest';
import type { Command } from '../../protocol/generated/commands';
import { EventKind, type ClientMessage, type GroupMesh } from '../../protocol/messages';
import type { StudioFrame } from '../../model/studio_frame';
import { StudioStore } from '../../model/studio_store';
import { kIdle, madeMesh } from '../../model/test_frames';
import { OrderController } from './order_controller';
import { areaOf } from '../../protocol/test_scene';

let sent: ClientMessage[];
let said: string[];
let store: StudioStore;
let controller: OrderController;
const noKeys = { shift: false, alt: false };

/** A mesh of one triangle with three places on its corners. */
function mesh(group: number): GroupMesh {
  return madeMesh(group, {
    rest: Float32Array.of(1, 0, -1, 1, -1, -1),
    triangles: Uint32Array.of(0, 1, 2),
    boundary: Uint32Array.of(3, 0, 1, 2),
    placeTriangles: Uint32Array.of(0, 0, 0),
    placeWeights: Float32Array.of(1, 0, 0, 1, 0, 0),
  });
}

function frame(groups: readonly [id: number, x: number][], members: number[], events: unknown[] = []): StudioFrame {
  const made = groups.map(([id, x]) => {
    const corners = Float32Array.of(x + 1, 0, x - 1, 1, x - 1, -1);
    return { id, controls: [], ...kIdle, x, vertices: corners, places: corners };
  });
  const ids = Uint32Array.from(members, (_, i) => i + 1);
  const x = new Float32Array(members.length);
  return { groups: made, ids, group: Uint16Array.from(members), x, events } as unknown as StudioFrame;
}

/** All commands that were sent. */
function commands(): Command[] {
  return sent.flatMap((one) => (one.type === 'Commands' ? one.commands : []));
}

beforeEach(() => {
  sent = [];
  said = [];
  store = new StudioStore();
  const scene = {
    orders: {
      previewOrder: () => undefined,
      gaveOrder: () => undefined,
      previewCut: () => undefined,
      previewForecasts: () => undefined,
      setWays: () => undefined,
      setPicked: () => undefined,
    },
    previewControl: () => undefined,
    worldToScreen: (at: { x: number; y: number }) => at,
  };
  controller = new OrderController({ send: (one) => sent.push(one) }, store, scene, (text) => said.push(text));
  const info = (id: number, name: string) => ({ id, name, colour: 0, count: 3, formation: 'square' });
  store.set({ groups: [info(4, 'North'), info(9, 'South')] });
  controller.setMesh(mesh(4));
  controller.setMesh(mesh(9));
  controller.observe(
    frame(
      [
        [4, 0],
        [9, 20],
      ],
      [0, 0, 0, 1, 1, 1],
    ),
  );
});

describe('OrderController', () => {
  it('gives orders to the active group until others are chosen', () => {
    expect(store.state.selected).toEqual([4]);
    expect(controller.groups().map(({ id }) => id)).toEqual([4]);
    controller.choose(1, true);
    expect(controller.groups().map(({ id }) => id)).toEqual([4, 9]);
    controller.choose(1, true);
    expect(store.state.selected).toEqual([4]);
    controller.choose(0, true);
    expect(store.state.selected).toEqual([4]);
    controller.chooseWithin({ x: 15, y: -5 }, { x: 25, y: 5 });
    expect([store.state.selected, store.state.active]).toEqual([[9], 1]);
    controller.chooseAll();
    controller.stop();
    expect(commands()).toEqual([
      { kind: 'queue', group: 4, edit: 'stop', order: 0 },
      { kind: 'queue', group: 9, edit: 'stop', order: 0 },
    ]);
  });

  it('follows the group under the press, behind it, and puts the tool away', () => {
    controller.setTool('follow');
    controller.follow({ x: 0, y: 0 }, noKeys);
    expect(commands()).toEqual([]);
    expect(store.state.tool).toBe('follow');
    controller.follow({ x: 20, y: 0 }, { ...noKeys, shift: true });
    expect(commands()).toEqual([
      { kind: 'order', group: 4, mode: 'append', order: { kind: 'follow', group: 9, offset: [-4, 0] } },
    ]);
    expect(store.state.tool).toBe('steer');
  });

  it('chooses the part that a split of ours has made', () => {
    controller.split({ group: 4, index: 0, from: { x: 0, y: -3 }, to: { x: 0, y: 3 }, left: 1, right: 2 });
    const parts = [...store.state.groups, { id: 12, name: 'North 2', colour: 5, count: 1, formation: 'points' }];
    store.set({ groups: parts });
    const added = { kind: EventKind.GroupAdded, subject: 12, value: 4, x: 0, y: 0 };
    controller.observe(
      frame(
        [
          [4, 0],
          [9, 20],
          [12, 1],
        ],
        [0, 0, 2, 1, 1, 1],
        [added],
      ),
    );
    expect([store.state.active, store.state.selected]).toEqual([2, [12]]);
  });

  it('asks the server to take back, and not where there is nothing', () => {
    controller.undo();
    expect(sent).toEqual([]);
    expect(store.state.notice?.text).toBe('There is nothing to undo');
    store.set({ history: { undo: 1, undoLabel: 'Move', redo: 1, redoLabel: 'Split' } });
    controller.undo();
    controller.undo(true);
    expect(sent).toEqual([
      { type: 'UndoEdit', redo: false },
      { type: 'UndoEdit', redo: true },
    ]);
  });

  it('changes one part of the conduct and keeps the others', () => {
    const conduct = { stance: 'hold', cohesion: 0.5, squeeze: 0.25, avoids: false } as const;
    store.set({ units: [{ id: 4, orders: [], held: false, patrols: false, conduct, classes: [] }] });
    controller.setConduct({ squeeze: 1 });
    expect(commands()).toEqual([{ kind: 'changeGroup', group: 4, conduct: { ...conduct, squeeze: 1 } }]);
  });

  it('tells why a stroke did nothing', () => {
    controller.missed('The stroke leaves nobody on one side');
    expect(store.state.notice?.text).toBe('The stroke leaves nobody on one side.');
    expect(said).toHaveLength(1);
  });

  it('lets the chosen leave by the exit that is pressed, or by all, and wait in an area', () => {
    const polygon: [number, number][] = [
      [4, -1],
      [6, -1],
      [6, 1],
    ];
    const area = areaOf({ id: 3, polygon });
    controller.leave({ x: 5.5, y: -0.5 }, noKeys);
    expect(said.at(-1)).toBe('There is no exit to leave by');
    store.set({
      areas: [
        { ...area, kind: 'exit', name: 'Door' },
        { ...area, id: 4, kind: 'waiting' },
      ],
    });
    store.set({ selected: [7, 9], tool: 'leave' });
    controller.leave({ x: 5.5, y: -0.5 }, noKeys);
    expect(store.state.tool).toBe('steer');
    expect(said.at(-1)).toBe('Leaves by Door');
    controller.leave({ x: -5, y: 0 }, { shift: true, alt: false });
    controller.wait({ x: 5.5, y: -0.5 }, noKeys);
    expect(commands()).toEqual([
      { kind: 'order', group: 7, mode: 'replace', order: { kind: 'leave', exits: [3] } },
      { kind: 'order', group: 9, mode: 'replace', order: { kind: 'leave', exits: [3] } },
      { kind: 'order', group: 7, mode: 'append', order: { kind: 'leave', exits: [] } },
      { kind: 'order', group: 9, mode: 'append', order: { kind: 'leave', exits: [] } },
      { kind: 'order', group: 7, mode: 'replace', order: { kind: 'wait', area: 4 } },
      { kind: 'order', group: 9, mode: 'replace', order: { kind: 'wait', area: 4 } },
    ]);
    controller.wait({ x: -5, y: 0 }, noKeys);
    expect(said.at(-1)).toBe('Press on the area where they shall wait');
  });
});
