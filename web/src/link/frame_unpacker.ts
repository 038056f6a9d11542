// Unpacks the server's frames, which hold changes only, to whole ones. This runs in the worker, so that the page's
// thread only hands them on.

import type { Frame, GroupFrame, GroupMesh, Motions } from '../protocol/messages';
import { clipDuration } from '../model/clip_duration';
import { kJoints } from '../model/skeleton';
import { CrowdUnpacker } from './crowd_unpacker';
import { queueOrder, type QueueOrder } from '../model/queue_order';
import type { StudioFrame, StudioGroup } from '../model/studio_frame';

/** Numbers of a whole pose on the wire, and unpacked. */
const kPacked = 3 + 3 * kJoints;
const kUnpacked = 3 + 4 * kJoints;
/** Value of the largest packed component: the three smaller components of a unit quaternion are at most sqrt(1/2). */
const kLargest = Math.SQRT1_2;
const kUnits = 16383;

/**
 * Unpacks whole poses, three numbers per joint. The largest component of a unit quaternion follows from the other
 * three; the lowest bits of the first two numbers give its index.
 */
export function unpackPoses(packed: Int16Array): Float32Array {
  const count = Math.floor(packed.length / kPacked);
  const poses = new Float32Array(kUnpacked * count);
  for (let k = 0; k < count; ++k) {
    for (let n = 0; n < 3; ++n) poses[kUnpacked * k + n] = packed[kPacked * k + n]! / 1000;
    for (let j = 0; j < kJoints; ++j) unpackTurn(packed, kPacked * k + 3 + 3 * j, poses, kUnpacked * k + 3 + 4 * j);
  }
  return poses;
}

function unpackTurn(packed: Int16Array, from: number, out: Float32Array, to: number): void {
  const largest = (packed[from]! & 1) | ((packed[from + 1]! & 1) << 1);
  let rest = 1;
  let next = from;
  for (let k = 0; k < 4; ++k) {
    if (k === largest) continue;
    const part = ((packed[next++]! >> 1) / kUnits) * kLargest;
    out[to + k] = part;
    rest -= part * part;
  }
  out[to + largest] = Math.sqrt(Math.max(0, rest));
}

/** What frames have said of a group: its queue, and its places, each a point of the mesh and an offset from it. */
class GroupUnpacker {
  private readonly offsets_: Float32Array;
  private unfit_: Uint8Array = new Uint8Array(0);
  private standings_: Uint32Array = new Uint32Array(0);
  private orders_: readonly QueueOrder[] = [];

  constructor(private readonly mesh_: GroupMesh) {
    this.offsets_ = new Float32Array(2 * mesh_.placeTriangles.length);
  }

  unpack({ moved, offsets, unfit, standings, queued, orders, ...group }: GroupFrame): StudioGroup {
    for (let k = 0; k < moved.length; ++k) {
      const at = 2 * moved[k]!;
      this.offsets_[at] = offsets[2 * k]! / 100;
      this.offsets_[at + 1] = offsets[2 * k + 1]! / 100;
    }
    if (unfit.length > 0) this.unfit_ = unfit;
    if (standings.length > 0) this.standings_ = standings;
    if (queued) this.orders_ = orders.map(queueOrder);
    const count = this.mesh_.placeTriangles.length;
    const fit = new Uint8Array(count);
    for (let k = 0; k < count; ++k) fit[k] = ((this.unfit_[k >> 3] ?? 0) >> (k & 7)) & 1 ? 0 : 1;
    return { ...group, standings: this.standings_, orders: this.orders_, places: this.places(group.vertices), fit };
  }

  private places(vertices: Float32Array): Float32Array {
    const { triangles, placeTriangles, placeWeights } = this.mesh_;
    const places = new Float32Array(this.offsets_.length);
    for (let k = 0; k < placeTriangles.length; ++k) {
      const corner = 3 * placeTriangles[k]!;
      const a = 2 * triangles[corner]!,
        b = 2 * triangles[corner + 1]!,
        c = 2 * triangles[corner + 2]!;
      const u = placeWeights[2 * k]!,
        v = placeWeights[2 * k + 1]!,
        w = 1 - u - v;
      places[2 * k] = this.offsets_[2 * k]! + u * vertices[a]! + v * vertices[b]! + w * vertices[c]!;
      places[2 * k + 1] =
        this.offsets_[2 * k + 1]! + u * vertices[a + 1]! + v * vertices[b + 1]! + w * vertices[c + 1]!;
    }
    return places;
  }
}

const kNoMesh: GroupMesh = {
  type: 'GroupMesh',
  group: 0,
  version: 0,
  formation: '',
  spacing: 1,
  rest: new Float32Array(0),
  triangles: new Uint32Array(0),
  boundary: new Uint32Array(0),
  placeTriangles: new Uint32Array(0),
  placeWeights: new Float32Array(0),
};

export class FrameUnpacker {
  private readonly crowd_ = new CrowdUnpacker();
  private readonly groups_ = new Map<number, GroupUnpacker>();

  setMotions({ clips }: Motions): void {
    this.crowd_.setClips(clips.map((clip) => ({ seconds: clipDuration(clip), cyclic: clip.cyclic })));
  }

  setMesh(mesh: GroupMesh): void {
    this.groups_.set(mesh.group, new GroupUnpacker(mesh));
  }

  unpack({ crowd, groups, ...frame }: Frame): StudioFrame {
    const people = this.crowd_.unpack(crowd, frame.time);
    const { near, nearPlaces } = crowd;
    // Characters near the view come with exact positions.
    for (let k = 0; k < near.length; ++k) {
      const who = near[k]!;
      if (who >= crowd.count) continue;
      people.x[who] = people.rows[8 * who] = nearPlaces[3 * k]!;
      people.y[who] = people.rows[8 * who + 1] = nearPlaces[3 * k + 1]!;
      people.rows[8 * who + 2] = nearPlaces[3 * k + 2]!;
    }
    return {
      ...frame,
      ...people,
      near,
      nearPoses: unpackPoses(crowd.nearPoses),
      groups: groups.map((group) => (this.groups_.get(group.id) ?? new GroupUnpacker(kNoMesh)).unpack(group)),
    };
  }
}
