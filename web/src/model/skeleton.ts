// The characters' skeleton: 21 joints, in rest a T-pose facing +x (y to the left, z up), all joint axes parallel to the
// body axes. The server has the same skeleton.

export interface Joint {
  readonly name: string;
  /** Index; -1 for the hips. */
  readonly parent: number;
  /** From the parent [m]; of the hips from the ground below. */
  readonly offset: readonly [number, number, number];
}

const joint = (name: string, parent: number, x: number, y: number, z: number): Joint => ({
  name,
  parent,
  offset: [x, y, z],
});

function arm(side: 'Left' | 'Right', first: number): Joint[] {
  const s = side === 'Left' ? 1 : -1;
  return [
    joint(`${side}Shoulder`, 2, 0, 0.03 * s, 0.19),
    joint(`${side}Arm`, first, 0, 0.15 * s, 0),
    joint(`${side}ForeArm`, first + 1, 0, 0.28 * s, 0),
    joint(`${side}Hand`, first + 2, 0, 0.25 * s, 0),
  ];
}

function leg(side: 'Left' | 'Right', first: number): Joint[] {
  const s = side === 'Left' ? 1 : -1;
  return [
    joint(`${side}UpLeg`, 0, 0, 0.09 * s, -0.04),
    joint(`${side}Leg`, first, 0, 0, -0.42),
    joint(`${side}Foot`, first + 1, 0, 0, -0.41),
    joint(`${side}ToeBase`, first + 2, 0.13, 0, -0.05),
  ];
}

/** Parents before children. */
export const kSkeleton: readonly Joint[] = [
  joint('Hips', -1, 0, 0, 0.95),
  joint('Spine', 0, 0, 0, 0.1),
  joint('Chest', 1, 0, 0, 0.17),
  joint('Neck', 2, 0, 0, 0.25),
  joint('Head', 3, 0.015, 0, 0.09),
  ...arm('Left', 5),
  ...arm('Right', 9),
  ...leg('Left', 13),
  ...leg('Right', 17),
];

export const kJoints = 21;

/** Index of a joint by its name; -1 where there is none. */
export function jointIndex(name: string): number {
  return kSkeleton.findIndex((one) => one.name === name);
}

/** Where the joints are in rest, x, y, z each, the character standing at the origin [m]. */
export function restPositions(skeleton: readonly Joint[] = kSkeleton): Float32Array {
  const at = new Float32Array(3 * skeleton.length);
  skeleton.forEach(({ parent, offset }, j) => {
    for (let k = 0; k < 3; ++k) at[3 * j + k] = (parent < 0 ? 0 : at[3 * parent + k]!) + offset[k as 0 | 1 | 2];
  });
  return at;
}
