import { describe, expect, it } from 'vitest';
import { sceneOf } from '../../protocol/test_scene';
import {
  addCommand,
  changeCommand,
  chosenAgain,
  extentOf,
  hit,
  moved,
  removeCommand,
  scaled,
  thing,
  thingsOf,
  turned,
  within,
} from './things';

const kScene = sceneOf({
  world: 3,
  box: { min: [-20, -20], max: [20, 20] },
  obstacles: [
    {
      id: 1,
      name: 'Hut',
      polygon: [
        [0, 0],
        [2, 0],
        [2, 2],
        [0, 2],
      ],
      height: 3,
      range: 1.5,
    },
    {
      id: 4,
      name: 'Car',
      centre: [5, 5],
      radius: 1,
      height: 2,
      path: {
        waypoints: [
          { time: 0, position: [0, 0] },
          { time: 2, position: [4, 0] },
        ],
        loop: true,
      },
    },
  ],
  patches: [
    {
      id: 2,
      name: 'Net',
      polygon: [
        [-4, -1],
        [-2, -1],
        [-2, 1],
        [-4, 1],
      ],
      motion: 3,
      speed: 0.3,
    },
  ],
  items: [{ id: 7, position: [1, 1], radius: 0.5 }],
  checkpoints: [
    {
      id: 1,
      position: [8, 0],
      radius: 2,
      formation: { kind: 'wedge', spacing: 1 },
      group: 1,
      once: false,
      trigger: 'mesh',
      share: 0.5,
    },
  ],
  groups: [
    {
      id: 1,
      count: 9,
      formation: 'square',
      placed: true,
      definition: { name: 'One', count: 9, position: [-8, 0], angle: 1 },
    },
    { id: 2, accent: 1, count: 4, formation: 'square', definition: { name: 'One 2' } },
  ],
});
const all = thingsOf(kScene);
const of = (kind: string, id: number) => all.find((one) => one.kind === kind && one.id === id)!;

describe('things of a place', () => {
  it('are all that can be taken hold of, but parts of groups', () => {
    expect(all.map(({ kind, id }) => `${kind} ${id}`)).toEqual([
      'patch 2',
      'obstacle 1',
      'obstacle 4',
      'checkpoint 1',
      'item 7',
      'group 1',
    ]);
  });

  it('keep what building does not change', () => {
    expect(changeCommand(moved(of('obstacle', 1), 1, 0))).toMatchObject({
      kind: 'putThing',
      id: 1,
      obstacle: {
        name: 'Hut',
        polygon: [
          [1, 0],
          [3, 0],
          [3, 2],
          [1, 2],
        ],
        height: 3,
        range: 1.5,
      },
    });
    expect(changeCommand(of('checkpoint', 1))).toMatchObject({
      kind: 'putThing',
      id: 1,
      group: 1,
      checkpoint: {
        position: [8, 0],
        radius: 2,
        formation: { kind: 'wedge', spacing: 1 },
        once: false,
        trigger: 'mesh',
        share: 0.5,
      },
    });
  });

  it('are told to the server by kind', () => {
    expect(changeCommand(of('group', 1))).toEqual({
      kind: 'pose',
      group: 1,
      position: [-8, 0],
      angle: 1,
      characters: true,
    });
    expect(removeCommand(of('group', 1))).toEqual({ kind: 'removeGroup', group: 1 });
    expect(removeCommand(of('item', 7))).toEqual({ kind: 'removeThing', thing: 'item', id: 7 });
    expect(addCommand(thing('item', { centre: [3, 4], radius: 0.5 }))).toEqual({
      kind: 'putThing',
      item: { position: [3, 4], radius: 0.5 },
    });
  });

  it('turn and grow about a point, with their ways', () => {
    const car = turned(of('obstacle', 4), { x: 5, y: 5 }, Math.PI / 2);
    expect(car.path!.waypoints[1]!.position[0]).toBeCloseTo(0, 9);
    expect(car.path!.waypoints[1]!.position[1]).toBeCloseTo(4, 9);
    const hut = scaled(of('obstacle', 1), { x: 0, y: 0 }, 2);
    expect(extentOf([hut])).toEqual({ minX: 0, minY: 0, maxX: 4, maxY: 4 });
    expect(scaled(of('item', 7), { x: 0, y: 0 }, 2).radius).toBe(1);
    const people = scaled(of('group', 1), { x: 0, y: 0 }, 2);
    expect([people.centre, people.radius]).toEqual([[-16, 0], of('group', 1).radius]);
  });

  it('are found from the top, and near their corners', () => {
    expect(hit(all, { x: 1, y: 1 }, 0.1)?.kind).toBe('item');
    expect(hit(all, { x: 1.8, y: 0.2 }, 0.1)?.id).toBe(1);
    expect(hit(all, { x: 2.2, y: 2.2 }, 0.5)?.id).toBe(1);
    expect(hit(all, { x: 2.2, y: 1 }, 0.5)?.id).toBe(1); // Beside a side, far from corners.
    expect(hit(all, { x: 15, y: 15 }, 0.5)).toBeNull();
    const loop = [
      { x: -1, y: -1 },
      { x: 6, y: -1 },
      { x: 6, y: 6 },
      { x: -1, y: 6 },
    ];
    expect(within(all, loop).map(({ kind }) => kind)).toEqual(['obstacle', 'obstacle', 'item']);
  });

  it('stay chosen: by id, or by their place in the list in a world that began again', () => {
    const chosen = [of('obstacle', 4)];
    expect(chosenAgain(chosen, all, all.slice(1), true)).toEqual(chosen);
    const renumbered = all.map((one, k) => ({ ...one, id: k + 10 }));
    expect(chosenAgain(chosen, all, renumbered, false).map(({ id }) => id)).toEqual([12]);
    expect(chosenAgain(chosen, all, renumbered.slice(1), false)).toEqual([]);
  });
});
