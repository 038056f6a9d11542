import { describe, expect, it } from 'vitest';
import { sceneOf } from '../../protocol/test_scene';
import { emptiedGroups, groupChoices, joinedSource, newArrivals, queued } from './areas';
import { kAdults } from './people';
import { addCommand, changeCommand, moved, removeCommand, thing, thingsOf, turned } from './things';

const box = { min: [-9, -9], max: [9, 9] } as const;
const polygon = [
  [0, 0],
  [2, 0],
  [2, 2],
  [0, 2],
] as const;
const adults = [{ name: 'Adults', speed: kAdults.speed }];
const start = { name: 'Arrivals', position: [1, 1], count: 0, people: adults } as const;
const scene = sceneOf({
  box,
  areas: [
    {
      id: 4,
      kind: 'exit',
      name: 'Door',
      polygon,
      open: false,
      rate: 1.5,
      queue: [
        [2, 1],
        [5, 1],
      ],
    },
    { id: 5, kind: 'source', polygon, open: true, rate: 2, group: 7, until: 60, timetable: [{ time: 3, count: 4 }] },
  ],
  groups: [
    { id: 7, count: 12, formation: 'square', placed: true, definition: start },
    { id: 8, accent: 1, count: 9, formation: 'square', placed: true, definition: { ...start, count: 9 } },
  ],
});
const things = thingsOf(scene);
const [exit, source] = things;

describe('areas', () => {
  it('are told to the server as they are, with the id of what is changed, and the group of a source', () => {
    expect(addCommand(exit!)).toMatchObject({
      kind: 'putThing',
      group: 0,
      area: {
        name: 'Door',
        polygon,
        kind: 'exit',
        open: false,
        rate: 1.5,
        queue: [
          [2, 1],
          [5, 1],
        ],
      },
    });
    expect(changeCommand(source!)).toMatchObject({
      kind: 'putThing',
      id: 5,
      group: 7,
      area: { kind: 'source', rate: 2, until: 60, timetable: [{ time: 3, count: 4 }] },
    });
    expect(removeCommand(exit!)).toEqual({ kind: 'removeThing', thing: 'area', id: 4 });
  });

  it('take their queues along', () => {
    expect(moved(exit!, 1, 2).area!.queue).toEqual([
      [3, 3],
      [6, 3],
    ]);
    const [, [x, y]] = turned(exit!, { x: 0, y: 0 }, Math.PI / 2).area!.queue as [unknown, [number, number]];
    expect([x, y].map((value) => Math.round(value))).toEqual([-1, 5]);
  });

  it('get a queue by a drawn line, a point a metre, and none by a press', () => {
    const line = Array.from({ length: 31 }, (_, k) => ({ x: 2 + k / 10, y: 1 }));
    expect(queued(exit!, line).area!.queue).toHaveLength(4);
    expect(queued(exit!, line.slice(0, 3)).area!.queue).toEqual([]);
  });

  it('of a source that goes take its group along, where nobody else comes to it', () => {
    const group = things.find(({ kind, id }) => kind === 'group' && id === 7)!;
    expect(emptiedGroups([source!], things)).toEqual([group]);
    expect(emptiedGroups([source!, group], things)).toEqual([]);
    expect(emptiedGroups([exit!], things)).toEqual([]);
    const other = thing('area', { id: 6, area: source!.area, group: 7 });
    expect(emptiedGroups([source!], [...things, other])).toEqual([]);
  });

  it('have groups to choose from by words that differ, and a new one for adults who leave', () => {
    expect(groupChoices(scene)).toEqual([
      { id: 7, word: 'Arrivals 7' },
      { id: 8, word: 'Arrivals 8' },
    ]);
    expect(newArrivals(source!)).toMatchObject({
      kind: 'group',
      group: { count: 0, people: [kAdults], orders: [{ kind: 'leave' }], position: [1, 1] },
    });
  });

  it('of a new source wait for their group', () => {
    const made = { ...source!, id: 0, group: 0 };
    expect(joinedSource(made, scene, things)).toBeNull();
    const before = things.filter(({ kind, id }) => kind !== 'group' || id !== 8);
    expect(joinedSource(made, scene, before)?.group).toBe(8);
  });

  it('groups begin with as many as the place says, whoever has left since', () => {
    const group = things.find(({ kind, id }) => kind === 'group' && id === 7)!;
    expect(group.count).toBe(0);
    expect(addCommand(group)).toMatchObject({ group: { count: 0, people: [kAdults] } });
  });
});
