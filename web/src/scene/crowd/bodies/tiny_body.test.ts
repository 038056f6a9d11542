import { expect, it } from 'vitest';
import { plainRig } from './rig';
import { jointIndex, restPositions } from '../../../model/skeleton';
import { makeSpeckBody, makeTinyBody } from './tiny_body';

it('is as tall as a person, on the floor, in few triangles, and grows with the rig', () => {
  const made = [
    [makeTinyBody, 68],
    [makeSpeckBody, 36],
  ] as const;
  for (const [scale, [make, triangles]] of [1, 0.5].flatMap((one) => made.map((each) => [one, each] as const))) {
    const geometry = make(plainRig(restPositions().map((one) => one * scale)));
    expect(geometry.index!.count / 3).toBe(triangles);
    // It walks: its legs go with their joints.
    const joints = geometry.attributes['joints']!;
    const moved = new Set(Array.from({ length: joints.count }, (_, i) => joints.getX(i)));
    for (const leg of ['LeftUpLeg', 'RightUpLeg']) expect(moved.has(jointIndex(leg))).toBe(true);
    geometry.computeBoundingBox();
    const { min, max } = geometry.boundingBox!;
    expect(min.z / scale).toBeGreaterThan(-0.05);
    expect(min.z / scale).toBeLessThan(0.1);
    expect(max.z / scale).toBeGreaterThan(1.6);
    expect(max.z / scale).toBeLessThan(1.95);
    expect((max.x - min.x) / scale).toBeLessThan(0.5);
  }
});
