import { describe, expect, it } from 'vitest';
import { drawn, kDrawingOptions, polygonThing, wallOf, type DrawingOptions } from './drawing';
import { routed } from './routes';
import { rightAngled, snapped } from './snap';
import { thing } from './things';

const kOptions: DrawingOptions = {
  ...kDrawingOptions,
  clips: ['run', 'walk', 'duck', 'crawl', 'swim', 'jump', 'climb'].map((name) => ({
    name,
    length: { jump: 2.1, climb: 1.8 }[name] ?? 0,
  })),
  height: 2,
  width: 0.5,
  speed: 2,
  formation: 'wedge',
  count: 12,
  spacing: 0.8,
  sourceRate: 1.5,
};

describe('drawing', () => {
  it('makes boxes from corner to corner, however they are drawn, and from a press', () => {
    const box = drawn('box', { x: 3, y: 4 }, { x: 1, y: 1 }, kOptions)!;
    expect(box.polygon).toEqual([
      [1, 1],
      [3, 1],
      [3, 4],
      [1, 4],
    ]);
    expect([box.kind, box.height]).toEqual(['obstacle', 2]);
    expect(drawn('box', { x: 0, y: 0 }, { x: 0, y: 0 }, kOptions)!.polygon).toHaveLength(4);
  });

  it('makes walls as wide as wished, along their line', () => {
    const wall = wallOf({ x: 0, y: 0 }, { x: 3, y: 4 }, 0.5)!;
    const side = Math.hypot(wall[0]![0] - wall[3]![0], wall[0]![1] - wall[3]![1]);
    expect(side).toBeCloseTo(0.5, 9);
    expect(Math.hypot(wall[1]![0] - wall[0]![0], wall[1]![1] - wall[0]![1])).toBeCloseTo(5, 9);
    expect(wallOf({ x: 0, y: 0 }, { x: 0.1, y: 0 }, 0.5)).toBeNull();
  });

  it('makes people who face where the stroke leads', () => {
    const people = drawn('people', { x: 0, y: 0 }, { x: 0, y: -3 }, kOptions)!;
    expect(people.angle).toBeCloseTo(-Math.PI / 2, 9);
    expect([people.count, people.formation]).toEqual([12, { kind: 'wedge', spacing: 0.8 }]);
  });

  it('makes discs, items and checkpoints', () => {
    expect(drawn('disc', { x: 1, y: 1 }, { x: 1, y: 3 }, kOptions)!.radius).toBe(2);
    expect(drawn('item', { x: 1, y: 1 }, { x: 1, y: 1 }, kOptions)!.centre).toEqual([1, 1]);
    expect(drawn('checkpoint', { x: 1, y: 1 }, { x: 1, y: 1 }, kOptions)!.formation.kind).toBe('wedge');
    expect(
      polygonThing(
        [
          [0, 0],
          [1, 0],
        ],
        2,
      ),
    ).toBeNull();
  });

  it('leads a thing there and back at its speed, or round', () => {
    const car = thing('obstacle', { centre: [0, 0], radius: 1 });
    const line = Array.from({ length: 11 }, (_, k) => ({ x: k, y: 0 }));
    const back = routed(car, line, 2).path!;
    expect(back.loop).toBe(true);
    expect(back.waypoints.at(-1)).toEqual({ time: 10, position: [0, 0], angle: 0 });
    expect(Math.max(...back.waypoints.map(({ position: [x] }) => x))).toBe(10);
    for (let k = 1; k < back.waypoints.length; ++k)
      expect(back.waypoints[k]!.time).toBeGreaterThan(back.waypoints[k - 1]!.time);
    const round = Array.from({ length: 41 }, (_, k) => {
      const angle = (2 * Math.PI * k) / 40;
      return { x: 5 * Math.cos(angle), y: 5 * Math.sin(angle) };
    });
    const way = routed(car, round, 1).path!;
    expect(way.waypoints.at(-1)!.time).toBeCloseTo(2 * Math.PI * 5, 0);
    expect(routed(car, [{ x: 0, y: 0 }], 1).path).toBeNull();
  });
});

describe('snapping', () => {
  const hut = thing('obstacle', {
    polygon: [
      [0.1, 0.1],
      [2, 0],
      [2, 2],
    ],
  });

  it('goes to a corner nearby, else to the grid', () => {
    expect(snapped({ x: 0.2, y: 0.2 }, [hut], 0.3)).toEqual({ x: 0.1, y: 0.1 });
    expect(snapped({ x: 5.3, y: 4.8 }, [hut], 0.3)).toEqual({ x: 5.5, y: 5 });
  });

  it('goes to right and half right angles', () => {
    const p = rightAngled({ x: 1, y: 1 }, { x: 5, y: 1.4 });
    expect(p.y).toBeCloseTo(1, 9);
    expect(p.x).toBeCloseTo(1 + Math.hypot(4, 0.4), 9);
  });

  it('makes stairs from the foot to the top, with their speeds', () => {
    const stairs = drawn('stairs', { x: 0, y: 0 }, { x: 0, y: 4 }, kOptions)!;
    expect(stairs).toMatchObject({ kind: 'patch', motion: 1, rest: { speed: 0.5, speedDown: 0.7 } });
    expect(stairs.ascent).toBeCloseTo(Math.PI / 2);
    expect(stairs.polygon!.map(([x]) => Math.abs(x))).toEqual([1, 1, 1, 1]);
    expect(drawn('stairs', { x: 0, y: 0 }, { x: 0, y: 0.1 }, kOptions)).toBeNull();
  });

  it('makes exits, sources and waiting areas from corner to corner', () => {
    const [a, b] = [
      { x: 0, y: 0 },
      { x: 3, y: 2 },
    ];
    expect(drawn('exit', a, b, kOptions)).toMatchObject({ kind: 'area', area: { kind: 'exit', open: true, rate: 0 } });
    expect(drawn('source', a, b, { ...kOptions, sourceGroup: 4 })).toMatchObject({
      area: { kind: 'source', rate: 1.5 },
      group: 4,
    });
    expect(drawn('waiting', a, b, kOptions)).toMatchObject({ name: 'Waiting area', centre: [1.5, 1] });
  });
});
