// A body of a few tubes on the joints of any rig, for characters that are a few px tall: nearly all of it has the
// group's colour, or a large crowd would look like noise.

import type { BufferGeometry } from 'three';
import { kRegion } from './body';
import { buildTubes, type Point, type Tube, type TubeMaker } from './plain_body';
import type { Rig } from './rig';
import { jointIndex } from '../../../model/skeleton';

function tubes({ bind, scale }: Rig): Tube[] {
  const at = (joint: string, up = 0): Point => {
    const j = 3 * jointIndex(joint);
    return [bind[j]!, bind[j + 1]!, bind[j + 2]! + up * scale];
  };
  const tube: TubeMaker = (joint, from, to, wide, deep, region) => ({
    joint,
    from,
    to,
    wide: [wide[0] * scale, wide[1] * scale],
    deep: [deep[0] * scale, deep[1] * scale],
    region,
  });
  const { skin, farShirt, farLegs } = kRegion;
  const sides = (['Left', 'Right'] as const).flatMap((side) => [
    tube(`${side}UpLeg`, at(`${side}UpLeg`, 0.08), at(`${side}Foot`, -0.08), [0.1, 0.06], [0.1, 0.07], farLegs),
    tube(`${side}Arm`, at(`${side}Arm`), at(`${side}Hand`), [0.07, 0.05], [0.06, 0.05], farShirt),
  ]);
  return [
    tube('Spine', at('Hips', -0.02), at('Neck'), [0.16, 0.18], [0.11, 0.1], farShirt),
    tube('Head', at('Head', -0.06), at('Head', 0.12), [0.08, 0.1], [0.1, 0.11], skin),
    tube('Head', at('Head', 0.1), at('Head', 0.23), [0.1, 0.07], [0.11, 0.08], farShirt),
    ...sides,
  ];
}

/** Its skin, to be drawn with the poses of that rig. */
export function makeTinyBody(rig: Rig): BufferGeometry {
  return buildTubes(tubes(rig), ({ joint }) => (joint === 'Spine' || joint === 'Head' ? 4 : 3));
}
