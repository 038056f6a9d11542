// What lies at a spot of the ground, and where that is from the nearest group: for who cannot see it.

import type { SceneFacts } from '../protocol/scene';
import { hit, thingsOf, type Thing } from './place/things';
import { convexHull, distance, insidePolygon, pointsOf, type GroundPoint } from './plane';

/** A group as it stands. */
export interface StandingGroup {
  readonly name: string;
  readonly x: number;
  readonly y: number;
  readonly facing: number;
  readonly vertices: ArrayLike<number>;
}

const kAreaWords = { exit: 'Exit', source: 'Entrance', waiting: 'Waiting area' } as const;

function nameOf(one: Thing, { clips }: SceneFacts): string {
  if (one.name) return one.name;
  if (one.area) return kAreaWords[one.area.kind];
  if (one.kind === 'patch') return `Ground to ${clips[one.motion]?.name ?? 'walk'}`;
  if (one.kind === 'obstacle') return one.polygon ? 'Wall' : 'Pillar';
  return one.kind === 'item' ? 'Thing to collect' : 'Change of formation';
}

function groundWords(at: GroundPoint, scene: SceneFacts): string {
  const { min, max } = scene.box;
  if (at.x < min[0] || at.y < min[1] || at.x > max[0] || at.y > max[1]) return 'Beyond the edge';
  const found = hit(
    thingsOf(scene).filter(({ kind }) => kind !== 'group'),
    at,
    0,
  );
  return found ? nameOf(found, scene) : 'Open ground';
}

/** `3 m before North`, by the group's own front. */
function fromGroup(at: GroundPoint, { name, x, y, facing }: StandingGroup): string {
  const [dx, dy] = [at.x - x, at.y - y];
  const ahead = dx * Math.cos(facing) + dy * Math.sin(facing);
  const left = dy * Math.cos(facing) - dx * Math.sin(facing);
  const side =
    Math.abs(ahead) >= Math.abs(left) ? (ahead >= 0 ? 'before' : 'behind') : left >= 0 ? 'left of' : 'right of';
  return `${Math.round(Math.hypot(dx, dy))} m ${side} ${name}`;
}

/** `Wall, 3 m before North`. */
export function spotWords(at: GroundPoint, scene: SceneFacts, groups: readonly StandingGroup[]): string {
  const on = groups.find(({ vertices }) => insidePolygon(at, convexHull(pointsOf(vertices))));
  const ground = groundWords(at, scene);
  if (on) return ground === 'Open ground' ? `On ${on.name}` : `On ${on.name}, ${ground}`;
  const [nearest] = [...groups].sort((a, b) => distance(a, at) - distance(b, at));
  return nearest ? `${ground}, ${fromGroup(at, nearest)}` : ground;
}
