// Bodies of a few tubes on the joints of any rig, for characters that are a few px tall: nearly all of them has the
// group's colour, or a large crowd would look like noise. Heads and shoulders are larger than life, as in miniatures:
// by them one person is told from the next.

import type { BufferGeometry } from 'three';
import { kRegion } from './body';
import { buildTubes, type Point, type Tube, type TubeMaker } from './plain_body';
import type { Rig } from './rig';
import { jointIndex } from '../../../model/skeleton';

interface Joints {
  readonly at: (joint: string, up?: number) => Point;
  readonly tube: TubeMaker;
}

function jointsOf({ bind, scale }: Rig): Joints {
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
  return { at, tube };
}

function tinyTubes({ at, tube }: Joints): Tube[] {
  const sides = (['Left', 'Right'] as const).flatMap((side) => [
    tube(
      `${side}UpLeg`,
      at(`${side}UpLeg`, 0.08),
      at(`${side}Foot`, -0.08),
      [0.11, 0.075],
      [0.11, 0.08],
      kRegion.farLegs,
    ),
    tube(`${side}Arm`, at(`${side}Arm`), at(`${side}Hand`), [0.08, 0.065], [0.07, 0.06], kRegion.farShirt),
  ]);
  return [
    tube('Spine', at('Hips', -0.02), at('Neck'), [0.15, 0.22], [0.11, 0.13], kRegion.farShirt),
    tube('Head', at('Head', -0.06), at('Head', 0.11), [0.09, 0.15], [0.1, 0.15], kRegion.farHead),
    tube('Head', at('Head', 0.09), at('Head', 0.24), [0.15, 0.1], [0.15, 0.1], kRegion.farHead),
    ...sides,
  ];
}

/** Arms are too thin to be seen: the trunk is as wide as with them. */
function speckTubes({ at, tube }: Joints): Tube[] {
  return [
    tube('Spine', at('Hips', -0.04), at('Neck', 0.02), [0.17, 0.27], [0.13, 0.17], kRegion.farShirt),
    tube('Head', at('Head', -0.06), at('Head', 0.24), [0.17, 0.15], [0.17, 0.15], kRegion.farHead),
    ...(['Left', 'Right'] as const).map((side) =>
      tube(
        `${side}UpLeg`,
        at(`${side}UpLeg`, 0.08),
        at(`${side}Foot`, -0.08),
        [0.12, 0.09],
        [0.12, 0.09],
        kRegion.farLegs,
      ),
    ),
  ];
}

/** Its skin, to be drawn with the poses of that rig. */
export function makeTinyBody(rig: Rig): BufferGeometry {
  return buildTubes(tinyTubes(jointsOf(rig)), ({ joint }) => (joint === 'Spine' || joint === 'Head' ? 4 : 3));
}

/** The same in half as many triangles. */
export function makeSpeckBody(rig: Rig): BufferGeometry {
  return buildTubes(speckTubes(jointsOf(rig)), ({ joint }) => (joint === 'Spine' ? 4 : 3));
}
