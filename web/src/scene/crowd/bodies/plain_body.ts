// A simple person of a few tubes on the skeleton: shown until modelled bodies have come, and where none do.

import { BufferAttribute, BufferGeometry } from 'three';
import { type Body, kRegion } from './body';
import { plainRig } from './rig';
import { jointIndex, restPositions } from '../../../model/skeleton';

export type Point = readonly [number, number, number];

export interface Tube {
  readonly joint: string;
  readonly from: Point;
  readonly to: Point;
  /** Half widths across at both ends [m]: about the vertical or the sideways axis, and about the forward one. */
  readonly wide: readonly [number, number];
  readonly deep: readonly [number, number];
  readonly region: number;
}

export type TubeMaker = (
  joint: string,
  from: Point,
  to: Point,
  wide: Tube['wide'],
  deep: Tube['deep'],
  region: number,
) => Tube;

const kRest = restPositions();

function at(joint: string, x = 0, y = 0, z = 0): Point {
  const j = 3 * jointIndex(joint);
  return [kRest[j]! + x, kRest[j + 1]! + y, kRest[j + 2]! + z];
}

function limbs(side: 'Left' | 'Right'): Tube[] {
  const { skin, shirt, trousers, shoes } = kRegion;
  const out = side === 'Left' ? 1 : -1;
  const tube = (joint: string, to: Point, wide: readonly [number, number], region: number): Tube => ({
    joint: side + joint,
    from: at(side + joint),
    to,
    wide,
    deep: wide,
    region,
  });
  return [
    tube('Arm', at(`${side}ForeArm`), [0.06, 0.047], shirt),
    tube('ForeArm', at(`${side}Hand`), [0.045, 0.032], skin),
    { ...tube('Hand', at(`${side}Hand`, 0, 0.17 * out), [0.02, 0.016], skin), deep: [0.042, 0.03] },
    tube('UpLeg', at(`${side}Leg`), [0.09, 0.062], trousers),
    tube('Leg', at(`${side}Foot`), [0.062, 0.045], trousers),
    {
      joint: `${side}Foot`,
      from: at(`${side}Foot`, -0.06, 0, -0.04),
      to: at(`${side}ToeBase`, 0.07, 0, 0.005),
      wide: [0.045, 0.04],
      deep: [0.045, 0.03],
      region: shoes,
    },
  ];
}

function tubes(): Tube[] {
  const { skin, shirt, trousers, hair } = kRegion;
  const trunk: TubeMaker = (joint, from, to, wide, deep, region) => ({ joint, from, to, wide, deep, region });
  return [
    trunk('Hips', at('Hips', 0, 0, -0.12), at('Hips', 0, 0, 0.1), [0.15, 0.145], [0.1, 0.1], trousers),
    trunk('Spine', at('Hips', 0, 0, 0.09), at('Chest'), [0.145, 0.14], [0.1, 0.1], shirt),
    trunk('Chest', at('Chest'), at('Neck', 0, 0, -0.01), [0.14, 0.17], [0.105, 0.09], shirt),
    trunk('Neck', at('Neck', 0, 0, -0.03), at('Head'), [0.052, 0.05], [0.052, 0.05], skin),
    trunk('Head', at('Head', 0.01, 0, -0.01), at('Head', 0.01, 0, 0.17), [0.075, 0.085], [0.09, 0.1], skin),
    trunk('Head', at('Head', -0.012, 0, 0.09), at('Head', -0.005, 0, 0.215), [0.088, 0.06], [0.1, 0.07], hair),
    ...limbs('Left'),
    ...limbs('Right'),
  ];
}

class TubeBuilder {
  readonly positions: number[] = [];
  readonly normals: number[] = [];
  readonly joints: number[] = [];
  readonly regions: number[] = [];
  readonly indices: number[] = [];

  add(tube: Tube, sides: number): void {
    const first = this.positions.length / 3;
    const along = [0, 1, 2].map((k) => tube.to[k]! - tube.from[k]!) as unknown as Point;
    const [across, other] = axesOf(along);
    this.ring(tube, tube.from, across, other, tube.wide[0], tube.deep[0], sides);
    this.ring(tube, tube.to, across, other, tube.wide[1], tube.deep[1], sides);
    for (let s = 0; s < sides; ++s) {
      const t = (s + 1) % sides;
      const [a, b, c, d] = [first + s, first + t, first + sides + t, first + sides + s];
      this.indices.push(a, b, c, a, c, d);
      if (s > 0 && s < sides - 1)
        this.indices.push(first, first + t, first + s, first + sides, first + sides + s, first + sides + t);
    }
  }

  private ring(
    tube: Tube,
    middle: Point,
    across: Point,
    other: Point,
    wide: number,
    deep: number,
    sides: number,
  ): void {
    for (let s = 0; s < sides; ++s) {
      const c = Math.cos((2 * Math.PI * (s + 0.5)) / sides),
        d = Math.sin((2 * Math.PI * (s + 0.5)) / sides);
      for (let k = 0; k < 3; ++k) this.positions.push(middle[k]! + across[k]! * wide * c + other[k]! * deep * d);
      for (let k = 0; k < 3; ++k) this.normals.push(across[k]! * c + other[k]! * d);
      this.joints.push(jointIndex(tube.joint), 0, 0, 0);
      this.regions.push(tube.region);
    }
  }
}

/** Two axes across a direction, the second forward where it can be; seen from its end they turn counter-clockwise. */
function axesOf([x, y, z]: Point): [Point, Point] {
  const size = Math.hypot(x, y, z);
  const [ux, uy, uz] = [x / size, y / size, z / size];
  const forward: Point = Math.abs(ux) < 0.8 ? [1, 0, 0] : [0, 0, 1];
  const dot = forward[0] * ux + forward[1] * uy + forward[2] * uz;
  const deep = [forward[0] - dot * ux, forward[1] - dot * uy, forward[2] - dot * uz] as const;
  const long = Math.hypot(...deep);
  const d: Point = [deep[0] / long, deep[1] / long, deep[2] / long];
  return [[d[1] * uz - d[2] * uy, d[2] * ux - d[0] * uz, d[0] * uy - d[1] * ux], d];
}

/** A skin of tubes with so many sides. */
export function buildTubes(list: readonly Tube[], sides: (tube: Tube) => number): BufferGeometry {
  const builder = new TubeBuilder();
  for (const tube of list) builder.add(tube, sides(tube));
  const count = builder.regions.length;
  const geometry = new BufferGeometry();
  const weights = new Float32Array(4 * count).map((_, i) => (i % 4 === 0 ? 1 : 0));
  const set = (name: string, list: readonly number[] | Float32Array, size: number): void => {
    geometry.setAttribute(name, new BufferAttribute(Float32Array.from(list), size));
  };
  set('position', builder.positions, 3);
  set('normal', builder.normals, 3);
  set('joints', builder.joints, 4);
  set('weights', weights, 4);
  set('region', builder.regions, 1);
  set('tint', new Float32Array(3 * count).fill(1), 3);
  geometry.setIndex(builder.indices);
  return geometry;
}

/** The simple person at both levels. */
export function makePlainBody(): Body {
  return {
    name: 'plain',
    rig: plainRig(),
    near: [{ geometry: buildTubes(tubes(), () => 10), map: null }],
    far: [{ geometry: buildTubes(tubes(), () => 5), map: null }],
  };
}
