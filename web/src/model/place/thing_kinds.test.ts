import { expect, it } from 'vitest';
import { isGatePath, type SceneFacts } from '../../protocol/scene';
import { withDoor } from './doors';
import { polygonThing } from './drawing';
import { frameOf, resized } from './frame';
import { gated, gateOf, isOpenAt, kNever, pressedAt } from './gates';
import { kindName, mistakeOf, mistakesOf, outsideOf, withMotion } from './motions';
import { carAlong, changedAt, defined, placeOn, routed, standing } from './routes';
import { moved, thing, turned, type Thing } from './things';

const kClips = [
  { name: 'run', length: 0 },
  { name: 'swim', length: 0 },
  { name: 'jump', length: 2.1 },
];
const wall = {
  ...polygonThing(
    [
      [0, 0],
      [6, 0],
      [6, 0.3],
      [0, 0.3],
    ],
    3,
  )!,
  id: 7,
};

it('a door splits a wall, and says why where it cannot', () => {
  const pieces = withDoor(wall, { x: 2, y: 0.1 }, 1.2) as readonly Thing[];
  expect(pieces.map(({ id }) => id)).toEqual([7, 0]);
  expect(pieces.map(({ polygon }) => polygon!.map(([x]) => +x.toFixed(6)).sort((a, b) => a - b))).toEqual([
    [0, 0, 1.4, 1.4],
    [2.6, 2.6, 6, 6],
  ]);
  expect(withDoor(wall, { x: 0, y: 0 }, 1.2)).toHaveLength(1);
  expect(withDoor(wall, { x: 2, y: 0 }, 7)).toBe('The wall is 6.0 m long: too short for this door.');
  expect(
    withDoor(
      routed(
        wall,
        [
          { x: 0, y: 0 },
          { x: 4, y: 0 },
        ],
        1,
      ),
      { x: 2, y: 0 },
      1,
    ),
  ).toMatch(/stands still/);
});

it('a gate keeps its times, opens and shuts where it is pressed, and is known by its path', () => {
  const never = gated(wall, { opens: kNever, shuts: kNever });
  expect(gateOf(never)).toEqual({ opens: kNever, shuts: kNever });
  expect(kindName({ ...never, name: 'Mouse' }, kClips)).toBe('Gate');
  const gate = gated(wall, { opens: 10, shuts: 30 });
  expect(gateOf(turned(gate, { x: 1, y: 2 }, 0.7))).toEqual({ opens: 10, shuts: 30 });
  expect([9, 14.1, 29, 40].map((time) => Math.round(placeOn(gate.path!, time).position[0]))).toEqual([0, 6, 6, 0]);
  expect(pressedAt({ opens: 10, shuts: kNever }, 12)).toEqual({ opens: 10, shuts: 12 });
  expect(pressedAt({ opens: 10, shuts: 12 }, 20)).toEqual({ opens: 20, shuts: kNever });
  expect(isOpenAt({ opens: 10, shuts: 30 }, 30)).toBe(false);
  // Resized while it is open it shuts where it did.
  const open = standing(gate, 20);
  const wider = changedAt(open, 20, (one) => gated(resized(one, 'length', 4), { opens: 10, shuts: 30 }));
  expect(frameOf(defined(wider, 20).polygon!).middle.x).toBeCloseTo(3);
  expect(frameOf(wider.polygon!).middle.x).toBeCloseTo(7);
  expect([isGatePath(gate.path), isGatePath(null)]).toEqual([true, false]);
});

it('what moves is where it stands, whatever the time of the world is', () => {
  const line = Array.from({ length: 9 }, (_, k) => ({ x: k, y: 2 }));
  for (const now of [0, 3.3, 7.9, 1234.5]) {
    const { path } = routed(wall, line, 1, now);
    const { position } = placeOn(path!, now);
    expect(Math.hypot(...position)).toBeLessThan(1e-9);
    const times = path!.waypoints.map(({ time }) => time);
    expect(times.every((time, k) => k === 0 || time > times[k - 1]!)).toBe(true);
    expect(placeOn(path!, now + 8).position[0]).toBeCloseTo(8);
    const one = routed(wall, line, 1, now);
    expect(defined(standing(one, now + 5), now + 5).polygon![1]![0]).toBeCloseTo(6);
  }
});

it('a car heads along its way and round', () => {
  const round = Array.from({ length: 41 }, (_, k) => {
    const angle = (2 * Math.PI * k) / 40;
    return { x: 8 * Math.cos(angle), y: 8 * Math.sin(angle) };
  });
  const car = carAlong(round, 2, 7)!;
  const { waypoints } = car.path!;
  expect(waypoints.at(-1)!.angle - waypoints[0]!.angle).toBeCloseTo(2 * Math.PI);
  expect(Math.max(...waypoints.slice(1).map(({ angle }, k) => Math.abs(angle - waypoints[k]!.angle)))).toBeLessThan(
    0.5,
  );
  expect(frameOf(car.polygon!).length).toBeCloseTo(4.2);
  expect(carAlong([{ x: 0, y: 0 }], 2, 0)).toBeNull();
});

it('says by name what people cannot jump, and makes it fit', () => {
  const hedge = thing('patch', { name: 'Box tree', polygon: resized(wall, 'width', 1).polygon, motion: 2 });
  const mistake = mistakeOf(turned(hedge, { x: 0, y: 0 }, 0.4), kClips)!;
  expect(mistake.text).toBe('Box tree is 1.0 m deep; people can jump over 1.8 to 2.4 m.');
  const { length, width } = frameOf(mistake.fits.polygon!);
  expect([length.toFixed(6), width.toFixed(6)]).toEqual(['6.000000', '2.100000']);
  expect(mistakeOf(mistake.fits, kClips)).toBeNull();
  expect(mistakeOf({ ...hedge, motion: 1 }, kClips)).toBeNull();
  const small = { ...hedge, polygon: resized(resized(hedge, 'length', 1.2), 'width', 0.4).polygon };
  expect(mistakeOf(mistakeOf(small, kClips)!.fits, kClips)).toBeNull();
});

it('another motion makes another thing: ground, or what is in the way', () => {
  const hedge = withMotion(wall, 2, kClips);
  expect([hedge.kind, kindName(hedge, kClips), frameOf(hedge.polygon!).width.toFixed(2)]).toEqual([
    'patch',
    'Hedge',
    '2.10',
  ]);
  const round = withMotion(hedge, -1, kClips);
  expect([round.kind, round.name, frameOf(round.polygon!).width.toFixed(2)]).toEqual(['obstacle', 'Hedge', '0.30']);
  expect(kindName(withMotion(wall, 1, kClips), kClips)).toBe('Water');
});

it('says what lies beyond the ground, and moves it inside', () => {
  const box = { min: [-10, -10], max: [10, 10] } as const;
  expect(outsideOf(wall, box, kClips)).toBeNull();
  const away = { ...moved(wall, 20, -14), name: 'Yard' };
  const mistake = outsideOf(away, box, kClips)!;
  expect(mistake.text).toBe('Yard lies beyond the ground, where nobody can go.');
  expect(mistake.fits.polygon).toEqual(moved(wall, 4, -10).polygon);
  expect(mistakesOf([wall, away], { box } as unknown as SceneFacts, kClips)).toHaveLength(1);
});
