// Skeleton, bodies and clips of a player's file (src/files/export/player/figures.cpp writes them).

import { DamagedFile, NumberModel, BitModel, RangeDecoder } from './range_decoder';

const kBodyUnit = 0.0005;
const kKinds = 2;
const kMostJoints = 64;
const kMostVertices = 20000;
const kMostTriangles = 40000;
const kMostPoses = 20000;
const kMostPosesTogether = 200000;
const kRotationSteps = 1023;
const kClipSecond = 256;
const kMostClipTime = kClipSecond * 3600;

export interface Skeleton {
  /** Index of each joint's parent; -1 for the first. */
  readonly parents: Int16Array;
  /** From the parent [m], three per joint. */
  readonly offsets: Float32Array;
}

/** A mesh in the rest pose. */
export interface BodyMesh {
  /** Three per vertex [m]. */
  readonly positions: Float32Array;
  /** Four per vertex: joints, and weights that sum up to 255. */
  readonly joints: Uint8Array;
  readonly weights: Uint8Array;
  /** 0 skin, 1 shirt, 2 trousers, 3 hair, 4 shoes. */
  readonly regions: Uint8Array;
  readonly indices: Uint16Array;
}

export interface Figures {
  readonly skeleton: Skeleton;
  /** Broad and narrow bodies, each a fine and a coarse mesh; null for those that nobody has. */
  readonly bodies: readonly ({ readonly fine: BodyMesh; readonly coarse: BodyMesh } | null)[];
}

/** The poses of a clip, evenly spread over its duration. */
export interface PlayedClip {
  /** In units of clip time. */
  readonly duration: number;
  readonly cyclic: boolean;
  readonly poses: number;
  /** Three per pose [m]. */
  readonly hips: Float32Array;
  /** Four per joint and pose. */
  readonly rotations: Float32Array;
}

export function readFigures(bytes: Uint8Array): Figures {
  const coder = new RangeDecoder(bytes);
  const [parent, offset, kinds] = [new NumberModel(), new NumberModel(), new NumberModel()];
  const joints = coder.count(kinds, kMostJoints, 'joints');
  if (joints === 0) throw new DamagedFile('found no joints');
  const skeleton = { parents: new Int16Array(joints), offsets: new Float32Array(3 * joints) };
  for (let j = 0; j < joints; ++j) {
    skeleton.parents[j] = coder.count(parent, j, 'parent of a joint') - 1;
    for (let k = 0; k < 3; ++k) skeleton.offsets[3 * j + k] = kBodyUnit * coder.whole(offset);
  }
  const bodies = [];
  for (let kind = 0; kind < kKinds; ++kind) {
    if (coder.count(kinds, 1, 'bodies') === 0) {
      bodies.push(null);
      continue;
    }
    const reader = new MeshReader(coder, joints);
    bodies.push({ fine: reader.mesh(), coarse: reader.mesh() });
  }
  return { skeleton, bodies };
}

class MeshReader {
  private readonly count_ = new NumberModel();
  private readonly region_ = new NumberModel();
  private readonly joints_ = new NumberModel();
  private readonly position_ = threeModels();
  private readonly joint_ = [new NumberModel(), ...threeModels()];
  private readonly weight_ = [new NumberModel(), ...threeModels()];
  private readonly index_ = threeModels();

  constructor(
    private readonly coder_: RangeDecoder,
    private readonly jointCount_: number,
  ) {}

  mesh(): BodyMesh {
    const count = this.coder_.count(this.count_, kMostVertices, 'corners of a body');
    const mesh = {
      positions: new Float32Array(3 * count),
      joints: new Uint8Array(4 * count),
      weights: new Uint8Array(4 * count),
      regions: new Uint8Array(count),
    };
    const last = { at: [0, 0, 0], region: 0, joints: [0, 0, 0, 0], weights: [0, 0, 0, 0] };
    for (let v = 0; v < count; ++v) this.vertex(mesh, v, last);
    return { ...mesh, indices: this.triangles(count) };
  }

  private vertex(
    mesh: Omit<BodyMesh, 'indices'>,
    v: number,
    last: { at: number[]; region: number; joints: number[]; weights: number[] },
  ): void {
    const coder = this.coder_;
    for (let k = 0; k < 3; ++k) {
      last.at[k]! += coder.whole(this.position_[k]!);
      mesh.positions[3 * v + k] = kBodyUnit * last.at[k]!;
    }
    last.region += coder.whole(this.region_);
    if (last.region < 0 || last.region > 4) throw new DamagedFile(`found region ${last.region}, expected 0 to 4`);
    mesh.regions[v] = last.region;
    const bearing = 1 + coder.count(this.joints_, 3, 'joints of a corner');
    let left = 255;
    for (let k = 0; k < 4; ++k) {
      if (k < bearing) last.joints[k]! += coder.whole(this.joint_[k]!);
      const joint = last.joints[k]!;
      if (k < bearing && (joint < 0 || joint >= this.jointCount_)) throw new DamagedFile(`found joint ${joint}`);
      last.weights[k] = k > 0 && k < bearing ? last.weights[k]! + coder.whole(this.weight_[k]!) : 0;
      const weight = last.weights[k]!;
      if (weight < 0 || weight > left) throw new DamagedFile(`found weight ${weight}`);
      left -= weight;
      mesh.joints[4 * v + k] = k < bearing ? joint : 0;
      mesh.weights[4 * v + k] = weight;
    }
    mesh.weights[4 * v] = left;
    last.weights[0] = left;
  }

  private triangles(vertices: number): Uint16Array {
    const count = this.coder_.count(this.count_, kMostTriangles, 'triangles of a body');
    const indices = new Uint16Array(3 * count);
    let [a, b, c] = [0, 0, 0];
    for (let t = 0; t < count; ++t) {
      const first = a + this.coder_.whole(this.index_[0]!);
      const second = first + (b - a) + this.coder_.whole(this.index_[1]!);
      const third = second + (c - b) + this.coder_.whole(this.index_[2]!);
      [a, b, c] = [first, second, third];
      for (const corner of [a, b, c])
        if (corner < 0 || corner >= vertices) throw new DamagedFile(`found corner ${corner} of ${vertices}`);
      indices.set([a, b, c], 3 * t);
    }
    this.coder_.check();
    return indices;
  }
}

function threeModels(): NumberModel[] {
  return [new NumberModel(), new NumberModel(), new NumberModel()];
}

/** The clips of a file, for a skeleton of so many joints. */
export function readClips(bytes: Uint8Array, count: number, joints: number): PlayedClip[] {
  const coder = new RangeDecoder(bytes);
  const reader = new ClipReader(coder, joints);
  const clips: PlayedClip[] = [];
  let poses = 0;
  for (let c = 0; c < count; ++c) {
    const clip = reader.clip();
    poses += clip.poses;
    if (poses > kMostPosesTogether)
      throw new DamagedFile(`found ${poses} poses, expected at most ${kMostPosesTogether}`);
    clips.push(clip);
  }
  return clips;
}

class ClipReader {
  private readonly head_ = new NumberModel();
  private readonly hips_ = new NumberModel();
  private readonly other_ = new BitModel();
  private readonly part_: readonly NumberModel[];

  constructor(
    private readonly coder_: RangeDecoder,
    private readonly joints_: number,
  ) {
    this.part_ = Array.from({ length: 3 * joints_ }, () => new NumberModel());
  }

  clip(): PlayedClip {
    const coder = this.coder_;
    const duration = coder.count(this.head_, kMostClipTime, 'duration of a clip');
    const cyclic = coder.count(this.head_, 1, 'kind of a clip') === 1;
    const poses = coder.count(this.head_, kMostPoses, 'poses of a clip');
    if (duration === 0 || poses === 0) throw new DamagedFile('found an empty clip');
    const clip = {
      duration,
      cyclic,
      poses,
      hips: new Float32Array(3 * poses),
      rotations: new Float32Array(4 * this.joints_ * poses),
    };
    const hips = [0, 0, 0, 0, 0, 0];
    const largest = new Uint8Array(this.joints_).fill(3);
    const others = new Int32Array(3 * this.joints_);
    const steps = new Int32Array(3 * this.joints_);
    for (let pose = 0; pose < poses; ++pose) {
      for (let k = 0; k < 3; ++k) {
        hips[3 + k]! += coder.whole(this.hips_);
        hips[k]! += hips[3 + k]!;
        clip.hips[3 * pose + k] = kBodyUnit * hips[k]!;
      }
      for (let j = 0; j < this.joints_; ++j) {
        this.joint(j, largest, others, steps);
        whole(largest[j]!, others, 3 * j, clip.rotations, 4 * (this.joints_ * pose + j));
      }
      coder.check();
    }
    return clip;
  }

  private joint(j: number, largest: Uint8Array, others: Int32Array, steps: Int32Array): void {
    const other = this.coder_.bit(this.other_);
    if (other) largest[j] = this.coder_.plain(2);
    for (let k = 3 * j; k < 3 * j + 3; ++k) {
      const before = others[k]!;
      others[k] = (other ? 0 : before + steps[k]!) + this.coder_.whole(this.part_[k]!);
      steps[k] = other ? 0 : others[k]! - before;
    }
  }
}

/** Writes a rotation of which the largest part is left out. */
function whole(largest: number, others: Int32Array, at: number, out: Float32Array, to: number): void {
  let sum = 0;
  let from = at;
  for (let k = 0; k < 4; ++k) {
    if (k === largest) continue;
    const part = (others[from++]! / kRotationSteps) * Math.SQRT1_2;
    out[to + k] = part;
    sum += part * part;
  }
  if (!(sum <= 1.01)) throw new DamagedFile('found no rotation');
  out[to + largest] = Math.sqrt(Math.max(0, 1 - sum));
}
