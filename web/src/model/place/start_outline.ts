// The ground on which a group begins, in the shape of its formation.

import type { Vec2 } from '../../protocol/generated/commands';
import type { GroundPoint } from '../plane';
import { kGroupRoom } from '../place_files/group_room';
import { outlineOf, type Thing } from './things';

/** Half its extent ahead and aside is 1; who faces x stands like this. */
const kBox: readonly Vec2[] = [
  [1, 1],
  [-1, 1],
  [-1, -1],
  [1, -1],
];
const kWedge: readonly Vec2[] = [
  [1.1, 0],
  [-1, 1],
  [-1, -1],
];
const kCross: readonly Vec2[] = [0, 1, 2, 3].flatMap((k): Vec2[] => {
  const [c, s] = [Math.round(Math.cos((k * Math.PI) / 2)), Math.round(Math.sin((k * Math.PI) / 2))];
  return [
    [0.3, -0.3],
    [1, -0.3],
    [1, 0.3],
  ].map(([x, y]): Vec2 => [c * x! - s * y!, s * x! + c * y!]);
});
const kShapes: Readonly<Record<string, readonly Vec2[]>> = {
  square: kBox,
  line: kBox,
  column: kBox,
  wedge: kWedge,
  cross: kCross,
};

export function startOutline(one: Thing): GroundPoint[] {
  const { kind, spacing = 1 } = one.formation;
  const shape = kShapes[kind];
  if (!shape) return outlineOf(one);
  const [ahead, aside] = (kGroupRoom[kind] ?? kGroupRoom['circle']!)(one.count);
  const [c, s] = [Math.cos(one.angle), Math.sin(one.angle)];
  return shape.map(([a, b]) => {
    const [u, v] = [(a * ahead * spacing) / 2, (b * aside * spacing) / 2];
    return { x: one.centre[0] + c * u - s * v, y: one.centre[1] + s * u + c * v };
  });
}
