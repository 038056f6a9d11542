import { expect, it } from 'vitest';
import { plainRig } from './rig';
import { restPositions } from '../../../model/skeleton';
import { makeTinyBody } from './tiny_body';

it('is as tall as a person, on the floor, in few triangles, and grows with the rig', () => {
  for (const scale of [1, 0.5]) {
    const geometry = makeTinyBody(plainRig(restPositions().map((one) => one * scale)));
    expect(geometry.index!.count / 3).toBeLessThan(90);
    geometry.computeBoundingBox();
    const { min, max } = geometry.boundingBox!;
    expect(min.z / scale).toBeGreaterThan(-0.05);
    expect(min.z / scale).toBeLessThan(0.1);
    expect(max.z / scale).toBeGreaterThan(1.6);
    expect(max.z / scale).toBeLessThan(1.95);
    expect((max.x - min.x) / scale).toBeLessThan(0.5);
  }
});
