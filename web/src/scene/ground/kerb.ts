// The kerb round the ground: a strip outside its edge.

import { BufferAttribute, BufferGeometry } from 'three';
import type { SceneBox } from '../../protocol/messages';

/** Width [m]. */
export const kKerb = 0.3;

/** The strip as triangles between the edge and a rectangle round it. */
export function kerbGeometry({ min, max }: SceneBox): BufferGeometry {
  const corners = (wide: number): number[][] => [
    [min[0] - wide, min[1] - wide, 0],
    [max[0] + wide, min[1] - wide, 0],
    [max[0] + wide, max[1] + wide, 0],
    [min[0] - wide, max[1] + wide, 0],
  ];
  const points = [...corners(0), ...corners(kKerb)].flat();
  const sides = [0, 1, 2, 3].flatMap((a) => {
    const b = (a + 1) % 4;
    return [a, a + 4, b + 4, a, b + 4, b];
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(Float32Array.from(points), 3));
  geometry.setIndex(sides);
  return geometry;
}
