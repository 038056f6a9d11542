// Writes files of players for tests.

import { crc32 } from './player_file';
import { type BitModel, BitModel as Bit, NumberModel } from './range_decoder';

/** Writes what RangeDecoder reads; whole numbers without bounds stand for the coder's low end. */
export class RangeEncoder {
  private low_ = 0n;
  private shift_ = 0;
  private range_ = 0xffffffff;

  bit(model: BitModel, one: boolean): this {
    this.narrow((this.range_ >>> 15) * ((model.quick + model.slow) >> 2), one);
    if (one) {
      model.quick -= model.quick >> 4;
      model.slow -= model.slow >> 7;
    } else {
      model.quick += (0xffff - model.quick) >> 4;
      model.slow += (0xffff - model.slow) >> 7;
    }
    return this;
  }

  plain(value: number, count: number): this {
    for (let k = count - 1; k >= 0; --k) this.narrow(this.range_ >>> 1, Math.floor(value / 2 ** k) % 2 === 1);
    return this;
  }

  natural(model: NumberModel, value: number): this {
    const bits = (value + 1).toString(2);
    const length = bits.length - 1;
    for (let k = 0; k < length; ++k) this.bit(model.length[k]!, true);
    if (length < 31) this.bit(model.length[length]!, false);
    let seen = 0;
    for (let k = 0; k < length; ++k) {
      const one = bits[1 + k] === '1';
      if (k < 2) this.bit(model.leading[3 * length + seen]!, one);
      else this.plain(one ? 1 : 0, 1);
      seen = one ? 2 : 1;
    }
    return this;
  }

  whole(model: NumberModel, value: number): this {
    this.natural(model, Math.abs(value));
    if (value !== 0) this.bit(model.sign, value < 0);
    return this;
  }

  /** The bytes: a first one of 0, as the writer's, then the low end. */
  bytes(): Uint8Array {
    let rest = this.low_;
    const out: number[] = [];
    for (let k = 0; k < this.shift_ + 4; ++k, rest >>= 8n) out.unshift(Number(rest & 255n));
    return Uint8Array.from([0, ...out]);
  }

  private narrow(bound: number, one: boolean): void {
    if (one) {
      this.low_ += BigInt(bound);
      this.range_ -= bound;
    } else {
      this.range_ = bound;
    }
    while (this.range_ < 1 << 24) {
      this.range_ = (this.range_ << 8) >>> 0;
      this.low_ <<= 8n;
      ++this.shift_;
    }
  }
}

/** A character in a made frame: units of the file. */
export interface MadeSample {
  readonly id: number;
  readonly x: number;
  readonly y?: number;
  readonly yaw?: number;
  readonly clip?: number;
  readonly time?: number;
  /** Switched to its clip since the frame before; so much of the clip before is left, in fifteenths. */
  readonly fade?: number;
  readonly colour?: number;
}

/** Two clips: the first goes round in a second with four poses, the second ends after half a second. */
const kDurations = [256, 128] as const;

function body(): Uint8Array {
  const coder = new RangeEncoder();
  const [parent, offset, kinds] = [new NumberModel(), new NumberModel(), new NumberModel()];
  coder.natural(kinds, 2);
  for (const [up, z] of [
    [0, 1800],
    [1, 1000],
  ] as const)
    coder.natural(parent, up).whole(offset, 0).whole(offset, 0).whole(offset, z);
  coder.natural(kinds, 1);
  const models = Array.from({ length: 16 }, () => new NumberModel());
  const [count, region, joints, index] = [models[0]!, models[1]!, models[2]!, models.slice(3, 6)];
  const [position, joint, weight] = [models.slice(6, 9), models.slice(9, 13), new NumberModel()];
  for (let level = 0; level < 2; ++level) {
    coder.natural(count, 3);
    let last = [0, 0, 0];
    let lastWeight = 0;
    let lastRegion = 0;
    [
      { at: [0, 0, 0], weight: 0, region: 0 },
      { at: [0, 200, 0], weight: 55, region: 1 },
      { at: [0, 0, 3000], weight: 55, region: 1 },
    ].forEach((vertex, v) => {
      vertex.at.forEach((value, k) => coder.whole(position[k]!, value - last[k]!));
      last = vertex.at;
      coder.whole(region, vertex.region - lastRegion);
      lastRegion = vertex.region;
      coder.natural(joints, v === 0 ? 0 : 1).whole(joint[0]!, 0);
      if (v > 0) coder.whole(joint[1]!, v === 1 ? 1 : 0).whole(weight, vertex.weight - lastWeight);
      lastWeight = v > 0 ? vertex.weight : 0;
    });
    coder.natural(count, 1).whole(index[0]!, 0).whole(index[1]!, 1).whole(index[2]!, 1);
  }
  return coder.natural(kinds, 0).bytes();
}

function clips(): Uint8Array {
  const coder = new RangeEncoder();
  const [head, hips, other] = [new NumberModel(), new NumberModel(), new Bit()];
  const parts = Array.from({ length: 6 }, () => new NumberModel());
  kDurations.forEach((duration, c) => {
    const poses = c === 0 ? 4 : 2;
    coder
      .natural(head, duration)
      .natural(head, c === 0 ? 1 : 0)
      .natural(head, poses);
    for (let pose = 0; pose < poses; ++pose) {
      // Hips at 0.9 m, higher by 10 mm in each pose.
      for (const value of [0, 0, pose === 0 ? 1800 : pose === 1 ? 20 - 1800 : 0]) coder.whole(hips, value);
      for (let part = 0; part < 6; ++part) {
        if (part % 3 === 0) coder.bit(other, false);
        coder.whole(parts[part]!, 0);
      }
    }
  });
  return coder.bytes();
}

/** A level floor that stands, and a wall that moves. */
function land(): Uint8Array {
  const coder = new RangeEncoder();
  const [more, moves] = [new Bit(), new Bit()];
  const [kind, finish, count] = [new NumberModel(), new NumberModel(), new NumberModel()];
  const square = [
    [0, 0],
    [500, 0],
    [0, 500],
    [-500, 0],
  ] as const;
  let left = [0, 0];
  const outline = (flat: NumberModel): void => {
    coder.natural(count, 4);
    square.forEach(([x, y], k) => {
      const first = k === 0 ? left : [0, 0];
      coder.whole(flat, x - first[0]!).whole(flat, y - first[1]!);
    });
    left = [0, 500];
  };
  coder.bit(more, true).bit(moves, false).natural(kind, 1).natural(finish, 0).whole(new NumberModel(), 0);
  outline(new NumberModel());
  coder.natural(kind, 0).bit(more, true).bit(moves, true).natural(kind, 2).natural(finish, 1);
  coder.whole(new NumberModel(), 0).whole(new NumberModel(), 1000).whole(new NumberModel(), 0);
  outline(new NumberModel());
  return coder.natural(kind, 0).bit(more, false).bytes();
}

class CrowdWriter {
  readonly coder = new RangeEncoder();
  private readonly models_ = new Map<string, NumberModel>();
  private readonly bits_ = new Map<string, Bit>();
  private members_: (Required<MadeSample> & Record<string, number>)[] = [];
  private place_ = [0, 0];

  number(name: string, value: number): void {
    this.coder.whole(this.model(name), value);
  }
  natural(name: string, value: number): void {
    this.coder.natural(this.model(name), value);
  }
  bit(name: string, value: boolean): void {
    if (!this.bits_.has(name)) this.bits_.set(name, new Bit());
    this.coder.bit(this.bits_.get(name)!, value);
  }
  private model(name: string): NumberModel {
    if (!this.models_.has(name)) this.models_.set(name, new NumberModel());
    return this.models_.get(name)!;
  }

  frame(samples: readonly MadeSample[], k: number): void {
    const before = this.members_.map(({ id }) => id);
    const now = samples.map(({ id }) => id);
    this.bit('changed', before.join() !== now.join());
    if (before.join() !== now.join()) this.change(samples, before);
    for (const member of this.members_)
      if (before.includes(member.id))
        this.move(
          member,
          samples.find(({ id }) => id === member.id)!,
        );
    // A thing that goes 10 cm in each frame.
    for (const [part, by] of [
      ['thing', k === 0 ? 0 : k === 1 ? 20 : 0],
      ['thing', 0],
      ['angle', 0],
    ] as const)
      this.number(part, by);
  }

  private change(samples: readonly MadeSample[], before: readonly number[]): void {
    const gone = before.flatMap((id, i) => (samples.some((one) => one.id === id) ? [] : [i]));
    this.natural('gone', gone.length);
    gone.forEach((i, k) => this.natural('gone', i - (gone[k - 1] ?? 0)));
    this.members_ = this.members_.filter((_, i) => !gone.includes(i));
    const came = samples.filter(({ id }) => !before.includes(id));
    this.natural('came', came.length);
    let last = 0;
    for (const { id, x, y = 0, yaw = 0, clip = 0, time = 0, colour = 0 } of came) {
      this.natural('ids', id - last);
      last = id;
      this.bit('body', false);
      this.number('scale', 0);
      this.natural('colour', colour);
      this.number('place', x - this.place_[0]!);
      this.number('place', y - this.place_[1]!);
      this.place_ = [x, y];
      this.number('heading', yaw);
      this.natural('clip', clip);
      this.natural('time', time);
      const still = { stepX: 0, stepY: 0, turn: 0, advance: 0, stir: 0, turned: 0, paced: 0, switched: 0 };
      this.members_.push({ id, x, y, yaw, clip, time, colour, fade: 0, ...still });
    }
    this.members_.sort((a, b) => a.id - b.id);
  }

  private move(member: Record<string, number>, sample: MadeSample): void {
    const { x, y = 0, yaw = 0, clip = 0, time = 0, colour = 0, fade } = sample;
    const [byX, byY] = [x - member['x']! - member['stepX']!, y - member['y']! - member['stepY']!];
    this.number(`step${member['stir']}`, byX);
    this.number(`step${member['stir']}`, byY);
    const stir = Math.abs(byX) + Math.abs(byY);
    const turn = yaw - member['yaw']! - member['turn']!;
    this.number(`turn${member['turned']}`, turn);
    this.bit('recoloured', colour !== member['colour']);
    if (colour !== member['colour']) this.natural('colour', colour);
    const switched = fade !== undefined;
    this.bit(`switched${member['switched']}`, switched);
    const duration = kDurations[clip]!;
    let advance = member['advance']!;
    let paced = member['paced']!;
    if (switched) {
      this.natural(`next${member['clip']}`, clip);
      this.natural('fade', fade);
      this.number('phase', time - Math.floor((member['time']! * duration) / kDurations[member['clip']!]!));
    } else {
      const by = time - member['time']! - advance;
      const round = clip === 0 ? by - duration * Math.round(by / duration) : by;
      this.number(`pace${paced}`, round);
      paced = round === 0 ? 0 : 1;
      advance += round;
    }
    const steps = { stepX: x - member['x']!, stepY: y - member['y']!, turn: yaw - member['yaw']!, advance };
    const stirs = {
      stir: stir === 0 ? 0 : stir < 3 ? 1 : 2,
      turned: turn === 0 ? 0 : 1,
      paced,
      switched: switched ? 1 : 0,
    };
    Object.assign(member, { x, y, yaw, clip, time, colour, ...steps, ...stirs });
  }
}

/** The file of parts, with or without a fitting checksum. */
export function joined(parts: Readonly<Record<string, Uint8Array>>, version = 1): Uint8Array {
  const size = Object.values(parts).reduce((sum, part) => sum + 8 + part.length, 20);
  const out = new Uint8Array(size);
  const view = new DataView(out.buffer);
  out.set(new TextEncoder().encode('MUSTERPL'));
  view.setUint32(8, version, true);
  view.setUint32(12, size, true);
  let at = 20;
  for (const [tag, part] of Object.entries(parts)) {
    out.set(new TextEncoder().encode(tag), at);
    view.setUint32(at + 4, part.length, true);
    out.set(part, at + 8);
    at += 8 + part.length;
  }
  view.setUint32(16, crc32(out.subarray(20)), true);
  return out;
}

/** The parts of a file with these frames, ten per second. */
export function madeParts(
  frames: readonly (readonly MadeSample[])[],
  head: Readonly<Record<string, unknown>> = {},
): Record<string, Uint8Array> {
  const writer = new CrowdWriter();
  frames.forEach((frame, k) => writer.frame(frame, k));
  const text = JSON.stringify({
    title: 'Made',
    fps: 10,
    frames: frames.length,
    most: Math.max(...frames.map((frame) => frame.length)),
    samples: frames.reduce((sum, frame) => sum + frame.length, 0),
    clips: 2,
    things: 1,
    colours: [0, '#aa5500'],
    box: [-10, -5, 10, 5],
    camera: { turn: 0.33, pitch: 0.8, angle: 0.42 },
    ...head,
  });
  return {
    head: new TextEncoder().encode(text),
    body: body(),
    clip: clips(),
    land: land(),
    crwd: writer.coder.bytes(),
  };
}

export function madeFile(frames: readonly (readonly MadeSample[])[]): Uint8Array {
  return joined(madeParts(frames));
}
