// One low-poly person, 1.75 m, facing +x, made of tapered tubes. Each corner names the limb that carries it and the
// stuff it is made of; the shader bends limbs about fixed joints.

import { BufferAttribute, BufferGeometry } from 'three';

/** Limbs, as the shader numbers them. */
export const kLimb = { body: 0, head: 1, upperArm: 2, foreArm: 3, thigh: 4, shin: 5 } as const;
/** Stuffs, as the shader numbers them. */
export const kStuff = { shirt: 0, trousers: 1, skin: 2, hair: 3, shoe: 4 } as const;

/** Heights of the joints [m]; the shader has the same numbers. */
export const kJoints = { hip: 0.9, knee: 0.49, shoulder: 1.4, elbow: 1.12, hipSide: 0.095, shoulderSide: 0.215 } as const;

/** A ring of a tube: height, centre forward, half width forward and sideways [m]. */
type Ring = readonly [z: number, x: number, halfX: number, halfY: number];

interface Tube {
  readonly rings: readonly Ring[];
  readonly y: number;
  readonly limb: number;
  /** -1 right, 0 middle, 1 left. */
  readonly side: number;
  /** Stuff between ring i and i + 1; the last one holds on. */
  readonly stuffs: readonly number[];
  /** Ends that are not drawn to a point, where something else hides them. */
  readonly open?: 'first' | 'both';
  /** Sides, where the tube has a number of its own. */
  readonly sides?: number;
}

export interface FigureDetail {
  /** Sides of a tube. */
  readonly sides: number;
  /** Every ring, only the needed ones, or the fewest that make a person: for machines that draw without a GPU. */
  readonly shape: 'fine' | 'coarse' | 'plain';
}

const kBody: readonly Ring[] = [
  [0.84, 0, 0.02, 0.03], [0.87, 0, 0.105, 0.155], [0.98, 0, 0.11, 0.15], [1.12, 0.01, 0.105, 0.14],
  [1.28, 0.02, 0.12, 0.175], [1.39, 0.01, 0.11, 0.195], [1.45, 0, 0.075, 0.12], [1.48, 0, 0.055, 0.06],
  [1.53, 0.01, 0.052, 0.055], [1.56, 0.01, 0.02, 0.02],
];
const kHead: readonly Ring[] = [
  [1.48, 0.02, 0.02, 0.02], [1.505, 0.025, 0.065, 0.06], [1.56, 0.025, 0.095, 0.08], [1.62, 0.015, 0.105, 0.088],
  [1.68, 0.005, 0.1, 0.085], [1.73, 0, 0.07, 0.06], [1.75, 0, 0.015, 0.015],
];
const kHair: readonly Ring[] = [
  [1.535, -0.045, 0.05, 0.055], [1.58, -0.035, 0.085, 0.09], [1.64, -0.018, 0.108, 0.1], [1.69, -0.008, 0.112, 0.098],
  [1.74, -0.005, 0.08, 0.07], [1.768, -0.005, 0.015, 0.015],
];
const kUpperArm: readonly Ring[] = [
  [1.45, 0, 0.02, 0.02], [1.42, 0, 0.062, 0.06], [1.3, 0, 0.058, 0.055], [1.235, 0, 0.06, 0.056], [1.23, 0, 0.046, 0.044],
  [1.1, 0, 0.042, 0.04], [1.09, 0, 0.015, 0.015],
];
const kForeArm: readonly Ring[] = [
  [1.15, 0, 0.015, 0.015], [1.12, 0, 0.042, 0.042], [1.0, 0, 0.038, 0.036], [0.9, 0, 0.03, 0.028], [0.86, 0, 0.042, 0.026],
  [0.79, 0.005, 0.035, 0.022], [0.77, 0.005, 0.01, 0.01],
];
const kThigh: readonly Ring[] = [
  [0.96, 0, 0.03, 0.03], [0.9, 0, 0.094, 0.088], [0.72, 0, 0.084, 0.078], [0.5, 0, 0.064, 0.06], [0.47, 0, 0.03, 0.03],
];
const kShin: readonly Ring[] = [
  [0.53, 0, 0.03, 0.03], [0.49, 0, 0.062, 0.059], [0.36, -0.012, 0.064, 0.06], [0.14, 0, 0.045, 0.045],
  [0.1, 0, 0.044, 0.044], [0.075, 0.03, 0.095, 0.05], [0.03, 0.045, 0.125, 0.052], [0, 0.045, 0.12, 0.048],
];

function tubes(): Tube[] {
  const { shirt, trousers, skin, hair, shoe } = kStuff;
  const list: Tube[] = [
    { rings: kBody, y: 0, limb: kLimb.body, side: 0, stuffs: [trousers, trousers, shirt, shirt, shirt, shirt, shirt, skin] },
    { rings: kHead, y: 0, limb: kLimb.head, side: 0, stuffs: [skin] },
    { rings: kHair, y: 0, limb: kLimb.head, side: 0, stuffs: [hair] },
  ];
  for (const side of [-1, 1]) {
    const arm = side * kJoints.shoulderSide;
    const leg = side * kJoints.hipSide;
    list.push(
      { rings: kUpperArm, y: arm, limb: kLimb.upperArm, side, stuffs: [shirt, shirt, shirt, shirt, skin] },
      { rings: kForeArm, y: arm, limb: kLimb.foreArm, side, stuffs: [skin] },
      { rings: kThigh, y: leg, limb: kLimb.thigh, side, stuffs: [trousers] },
      { rings: kShin, y: leg, limb: kLimb.shin, side, stuffs: [trousers, trousers, trousers, trousers, shoe] },
    );
  }
  return list;
}

const kPlainBody: readonly Ring[] = [
  [0.84, 0, 0.12, 0.17], [1.0, 0, 0.125, 0.17], [1.4, 0.01, 0.13, 0.235], [1.53, 0, 0, 0],
];
const kPlainHead: readonly Ring[] = [
  [1.47, 0.02, 0.06, 0.06], [1.6, 0.02, 0.12, 0.105], [1.7, 0, 0.125, 0.115], [1.76, 0, 0, 0],
];
const kPlainArm: readonly Ring[] = [[1.43, 0, 0.075, 0.07], [1.14, 0, 0.055, 0.055]];
const kPlainHand: readonly Ring[] = [[1.15, 0, 0.06, 0.055], [0.76, 0, 0, 0]];
const kPlainThigh: readonly Ring[] = [[0.9, 0, 0.115, 0.105], [0.47, 0, 0.075, 0.07]];
const kPlainShin: readonly Ring[] = [[0.5, 0, 0.075, 0.07], [0.09, 0, 0.052, 0.052], [0, 0.045, 0.14, 0.06]];

/** Fewer than a hundred triangles. */
function plainTubes(): Tube[] {
  const { shirt, trousers, skin, hair, shoe } = kStuff;
  const list: Tube[] = [
    { rings: kPlainBody, y: 0, limb: kLimb.body, side: 0, stuffs: [trousers, shirt, shirt], open: 'first' },
    { rings: kPlainHead, y: 0, limb: kLimb.head, side: 0, stuffs: [skin, hair, hair], open: 'first' },
  ];
  for (const side of [-1, 1]) {
    const arm = side * kJoints.shoulderSide;
    const leg = side * kJoints.hipSide;
    list.push(
      { rings: kPlainArm, y: arm, limb: kLimb.upperArm, side, stuffs: [shirt], open: 'both', sides: 3 },
      { rings: kPlainHand, y: arm, limb: kLimb.foreArm, side, stuffs: [skin], open: 'first', sides: 3 },
      { rings: kPlainThigh, y: leg, limb: kLimb.thigh, side, stuffs: [trousers], open: 'both' },
      { rings: kPlainShin, y: leg, limb: kLimb.shin, side, stuffs: [trousers, shoe], open: 'both', sides: 3 },
    );
  }
  return list;
}

/** Keeps the ends and the rings where the stuff changes. */
function coarse(tube: Tube): Tube {
  const keep: number[] = [];
  const stuffAt = (i: number): number => tube.stuffs[Math.min(i, tube.stuffs.length - 1)] ?? 0;
  const last = tube.rings.length - 1;
  for (let i = 0; i <= last; ++i) {
    const change = i > 0 && i < last && stuffAt(i) !== stuffAt(i - 1);
    if (i === 0 || i >= last - 1 || change || (i === 2 && last < 7) || (i === 3 && last > 7)) keep.push(i);
  }
  return { ...tube, rings: keep.map((i) => tube.rings[i] as Ring), stuffs: keep.map(stuffAt) };
}

/** Ends are drawn to a point, so that no tube stands open where it can be seen. */
function pointed(tube: Tube, index: number): boolean {
  if (index === 0) return tube.open === undefined;
  return index === tube.rings.length - 1 && tube.open !== 'both';
}

class FigureBuilder {
  readonly positions: number[] = [];
  readonly normals: number[] = [];
  /** Limb, side, stuff. */
  readonly limbs: number[] = [];
  readonly indices: number[] = [];

  add(tube: Tube, sides: number): void {
    const last = tube.rings.length - 1;
    for (let i = 0; i < last; ++i) {
      const stuff = tube.stuffs[Math.min(i, tube.stuffs.length - 1)] ?? 0;
      const low = this.ring(tube, i, sides, stuff);
      const high = this.ring(tube, i + 1, sides, stuff);
      const rising = (tube.rings[i + 1]?.[0] ?? 0) > (tube.rings[i]?.[0] ?? 0);
      for (let s = 0; s < sides; ++s) {
        const t = (s + 1) % sides;
        // At a pointed end one of the two triangles has no area.
        if (!pointed(tube, i + 1)) this.triangle(low + s, high + t, high + s, rising);
        if (!pointed(tube, i)) this.triangle(low + s, low + t, high + t, rising);
      }
    }
  }

  private triangle(a: number, b: number, c: number, rising: boolean): void {
    if (rising) this.indices.push(a, b, c);
    else this.indices.push(a, c, b);
  }

  private ring(tube: Tube, index: number, sides: number, stuff: number): number {
    const first = this.positions.length / 3;
    const [z, x, wideX, wideY] = tube.rings[index] as Ring;
    const end = pointed(tube, index) ? 0.001 : 1;
    const [halfX, halfY] = [wideX * end, wideY * end];
    const before = tube.rings[Math.max(0, index - 1)] as Ring;
    const after = tube.rings[Math.min(tube.rings.length - 1, index + 1)] as Ring;
    const rise = after[0] - before[0];
    const widen = (after[2] + after[3] - before[2] - before[3]) / 2;
    const slope = Math.abs(rise) > 1e-6 ? -widen / Math.abs(rise) : 0;
    const sign = rise >= 0 ? 1 : -1;
    for (let s = 0; s < sides; ++s) {
      const angle = (2 * Math.PI * (s + 0.5)) / sides;
      const c = Math.cos(angle);
      const d = Math.sin(angle);
      this.positions.push(x + halfX * c, tube.y + halfY * d, z);
      const nz = Math.max(-3, Math.min(3, slope * sign));
      const length = Math.hypot(1, nz);
      this.normals.push(c / length, d / length, nz / length);
      this.limbs.push(tube.limb, tube.side, stuff);
    }
    return first;
  }
}

/** The person at a level of detail. Attributes: position, normal, limb (limb, side, stuff). */
export function makeFigureGeometry(detail: FigureDetail): BufferGeometry {
  const builder = new FigureBuilder();
  const list = detail.shape === 'plain' ? plainTubes() : tubes();
  for (const tube of list) builder.add(detail.shape === 'coarse' ? coarse(tube) : tube, tube.sides ?? detail.sides);
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(Float32Array.from(builder.positions), 3));
  geometry.setAttribute('normal', new BufferAttribute(Float32Array.from(builder.normals), 3));
  geometry.setAttribute('limb', new BufferAttribute(Float32Array.from(builder.limbs), 3));
  geometry.setIndex(builder.indices);
  return geometry;
}
